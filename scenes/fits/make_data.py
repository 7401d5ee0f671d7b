"""Makes the data of the scenes in this folder: the curve of a known truth, sampled evenly in time, with normal noise from a seed.

    python3 scenes/fits/make_data.py target/release/viscotack

Truth of pull_off.csv: work of adhesion 55 mJ/m², frame stiffness 180 N/m; of twelve_terms.csv: 80 mJ/m² and 250 N/m. Each has 500 rows and noise of 1 % of the
largest tension; the loss of contact lies between two rows.
"""

import bisect
import csv
import pathlib
import random
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
SEED = 43


def way(program, scene, sets):
    """Times and forces of the kept instants of a scene without its [fit], at a tight accuracy, and the times of events."""
    with tempfile.TemporaryDirectory() as folder:
        plain = pathlib.Path(folder) / "scene.toml"
        plain.write_text(scene.read_text().split("[fit]")[0])
        arguments = [argument for one in sets for argument in ("--set", one)]
        subprocess.run([program, "run", plain, "--no-plots", "--out", folder + "/out", *arguments], check=True, stdout=subprocess.DEVNULL)
        with open(folder + "/out/path.csv") as file:
            rows = list(csv.DictReader(file))
    events = {row["event"]: float(row["time [s]"]) for row in rows if row["row"] == "event"}
    kept = [(float(row["time [s]"]), float(row["force [N]"])) for row in rows if row["row"] == "instant"]
    return kept, events


def between(points, place):
    """The cubic through the four points around a place."""
    middle = min(max(bisect.bisect([point[0] for point in points], place), 2), len(points) - 2)
    four = points[middle - 2 : middle + 2]
    value = 0.0
    for x, y in four:
        for other, _ in four:
            if other != x:
                y *= (place - other) / (x - other)
        value += y
    return value


def pull_off(program, name, work, stiffness, end, accuracy):
    truth = [f"adhesion.work_of_adhesion='{work}'", f"indentation.frame_stiffness='{stiffness}'", "indentation.instants=5000", f"accuracy={accuracy}"]
    points, events = way(program, HERE / f"{name}.toml", truth)
    lost = events["detachment"]
    held = [point for point in points if point[0] < lost]
    times = [end * row / 499 for row in range(500)]
    clean = [between(held, time) if time < lost else 0.0 for time in times]
    draw = random.Random(SEED)
    noise = 0.01 * -min(clean)
    with open(HERE / f"{name}.csv", "w") as file:
        file.write("time (s), force (µN)\n")
        for time, value in zip(times, clean):
            file.write(f"{time:.5f}, {1e6 * (value + draw.gauss(0, noise)):.3f}\n")


pull_off(sys.argv[1], "pull_off", "55 mJ/m²", "180 N/m", 6, 1e-6)
pull_off(sys.argv[1], "twelve_terms", "80 mJ/m²", "250 N/m", 7.5, 1e-5)
