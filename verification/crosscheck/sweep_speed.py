#!/usr/bin/env python3
"""How long sweeps of sliding contacts take beside another program: both in one run, one after the other, again and again.

    verification/crosscheck/sweep_speed.py --old BINARY --new BINARY [--repeats 3]

Processor time of one thread. `command`: `viscotack run SCENE --out DIR`, with its tables and pictures, as a sweep is made. `solved`: without `--out`.
"""

import argparse
import os
import resource
import subprocess
import tempfile

SPEEDS = ("sliding.speed", '"1 µm/s"', '"1 m/s"', 400, "")
LOADS = ("sliding.mean_pressure", '"-2 kPa"', '"10 kPa"', 400, '\nspacing = "linear"')
ONE = '[{ fraction = 1, retardation_time = "10 ms" }]'
# Twelve over seven decades; the last share makes their sum one.
TWELVE = "[" + ", ".join(f'{{ fraction = {1 / 12 if k else 1 - 11 * (1 / 12)!r}, retardation_time = "{10.0 ** (0.6 * k - 3):g} ms" }}' for k in range(12)) + "]"
SCENES = {
    "400 speeds, one term, 6 kPa": (ONE, "adhesive", 'mean_pressure = "6 kPa"', SPEEDS),
    "400 speeds, one term, -5 kPa": (ONE, "adhesive", 'mean_pressure = "-5 kPa"', SPEEDS),
    "400 speeds, one term, without adhesion": (ONE, "adhesiveless", 'mean_pressure = "6 kPa"', SPEEDS),
    "100 speeds, twelve terms, 6 kPa": (TWELVE, "adhesive", 'mean_pressure = "6 kPa"', (*SPEEDS[:3], 100, "")),
    "400 loads, one term": (ONE, "adhesive", 'mean_pressure = "6 kPa"', LOADS),
}


def scene(creep, contact, held, sweep):
    key, start, end, points, spacing = sweep
    return f"""accuracy = 1e-6
[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "10 MPa"
poisson_ratio = 0.49
creep = {creep}
[adhesion]
work_of_adhesion = "20 mJ/m²"
process_zone = {{ length = "0.16 µm" }}
[sliding]
contacts = ["{contact}"]
speed = "1 mm/s"
{held}
[sliding.wave]
wavelength = "100 µm"
amplitude = "3 µm"
[sweep]
key = "{key}"
from = {start}
to = {end}
points = {points}{spacing}
"""


def processor_time(command, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, cwd=folder, capture_output=True, check=True, env={**os.environ, "RAYON_NUM_THREADS": "1"})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--old", required=True)
    parser.add_argument("--new", required=True)
    parser.add_argument("--repeats", type=int, default=3)
    options = parser.parse_args()
    binaries = [os.path.abspath(options.old), os.path.abspath(options.new)]
    for name, parts in SCENES.items():
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "scene.toml"), "w", encoding="utf-8") as file:
                file.write(scene(*parts))
            ways = {"command": ["--out", "out", "--force"], "solved": []}
            least = {(way, binary): float("inf") for way in ways for binary in binaries}
            for _ in range(options.repeats):
                for way, binary in least:
                    least[way, binary] = min(least[way, binary], processor_time([binary, "run", "scene.toml", *ways[way]], folder))
        told = (f"{way} {least[way, binaries[0]]:.2f} s, {least[way, binaries[1]]:.2f} s: {least[way, binaries[1]] / least[way, binaries[0]]:.2f} times" for way in ways)
        print(f"{name:40}", ";  ".join(told), flush=True)


if __name__ == "__main__":
    main()
