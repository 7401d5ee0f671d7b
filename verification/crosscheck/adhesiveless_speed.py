#!/usr/bin/env python3
"""How many times faster one program solves indentation without adhesion than another one: both in one run, one after the other, again and again.

    verification/crosscheck/adhesiveless_speed.py --old BINARY --new BINARY [--accuracy 1e-6] [--repeats 15] [--only WORDS] [--energies] [--instants 4] [--processor] [--instructions]

`whole`: wall-clock time of `viscotack run`, the least of all repeats. `solver`: the same without that of `viscotack --version` of the same binary.
`floor`: `solver` of a scene that the new program reads, plans and prints but hardly solves: one ramp of a sphere with one instant. Where the old program
takes less than 20 floors, no solver is 20 times faster; of the other scenes the last lines say how many are.
On a machine with other work, `--processor` takes the processor time of all threads instead, and `--instructions` counts theirs under `valgrind`; the new
program, which has two threads, then counts both.
Both programs must give the same values, within the error bounds of both; a scene that one of them does not solve has no ratio.
"""

import argparse
import json
import math
import os
import re
import subprocess
import tempfile
import time

SHAPES = {
    "sphere": "sphere = {}",
    "cone": "cone = { slope = 0.1 }",
    "power": "power_law = { exponent = 4.0 }",
    "table": 'profile = "shape.csv"',
}
CONTROLS = {
    # Approach, hold, partial retraction, approach again.
    "penetration": ("penetration", [(0.01, 1.0), (None, 3.0), (0.005, 0.5), (0.012, 2.0)]),
    # Approach and partial retraction alone.
    "approach": ("penetration", [(0.01, 1.0), (0.006, 0.5)]),
    "force": ("force", [(1.0, 1.0), (None, 10.0), (0.3, 2.0), (1.2, 3.0)]),
    "frame": ("frame", [(0.02, 1.0), (None, 10.0), (0.008, 2.0), (0.025, 3.0)]),
}
# A force that presses each shape as deep as the other controls do.
FORCES = {"sphere": 1e-3, "cone": 1e-3, "power": 3e-3, "table": 1e-3}


def material(terms):
    """Terms a decade apart that stiffen tenfold together."""
    series = ", ".join(f"{{ fraction = {1.0 / terms!r}, relaxation_time = {10.0 ** (k - terms // 2)!r} }}" for k in range(terms))
    return f"[material]\npoisson_ratio = 0.5\nglassy_modulus = 10.0\nrelaxation = [{series}]\n"


def scene(shape, terms, control, accuracy, energies=False, instants=4):
    quantity, legs = CONTROLS[control]
    lines = ['units = "reduced"', f"accuracy = {accuracy!r}", material(terms), "[indentation]", SHAPES[shape], f"instants = {instants}"]
    if control == "frame":
        lines.append("frame_stiffness = 0.1")
    if energies:
        lines.append("energies = {}")
    scale = FORCES[shape] if control == "force" else 1.0
    for end, duration in legs:
        lines += ["[[history]]", f"hold = {duration!r}" if end is None else f"{quantity} = {end * scale!r}\nduration = {duration!r}"]
    return "\n".join(lines) + "\n"


def table():
    """A paraboloid with a blunt tip, to a radius of 0.5."""
    rows = [f"{r!r},{0.5 * r * r / (1.0 + (0.01 / max(r, 1e-6)) ** 2)!r}" for r in (0.5 * k / 100 for k in range(101))]
    return "r, z\n" + "\n".join(rows) + "\n"


def floor_scene(accuracy):
    return "\n".join(['units = "reduced"', f"accuracy = {accuracy!r}", material(1), "[indentation]", SHAPES["sphere"], "instants = 1", "[[history]]",
                      "penetration = 0.01", "duration = 1.0"]) + "\n"


def timed(command, folder):
    """Milliseconds, and the process that is over."""
    start = time.perf_counter()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return (time.perf_counter() - start) * 1e3, done


def processor(command, folder):
    """Milliseconds of the processor, and the process that is over."""
    with open(os.devnull, "w", encoding="utf-8") as nothing:
        done = subprocess.Popen(command, cwd=folder, stdout=nothing, stderr=nothing)
        _, status, usage = os.wait4(done.pid, 0)
        done.returncode = os.waitstatus_to_exitcode(status)
    return (usage.ru_utime + usage.ru_stime) * 1e3, done


def counted(command, folder):
    """Millions of instructions, and the process that is over."""
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *command], cwd=folder, capture_output=True, text=True,
                          check=False)
    return int(re.search(r"Collected : (\d+)", done.stderr)[1]) / 1e6, done


def values(done):
    """Rows at instants, or none where the program has not solved the scene."""
    try:
        rows = json.loads(done.stdout)["results"]
    except ValueError:
        return None
    if done.returncode != 0:
        return None
    return [row["values"] for row in rows if row["row"] == "instant"]


def difference(old, new):
    """The largest difference of both programs over the bounds of both, and over the largest value."""
    if len(old) != len(new):
        return math.inf, math.inf
    most, over_scale = 0.0, 0.0
    for name in ("penetration", "force", "contact_radius"):
        scale = max(abs(row[name]["value"]) for row in new)
        for one, other in zip(old, new):
            one, other = one[name], other[name]
            difference = abs(one["value"] - other["value"])
            most = max(most, difference / (one["error"] + other["error"] + 1e-12 * scale))
            over_scale = max(over_scale, difference / scale)
    return most, over_scale


def compared(binaries, name, text, floor, measured, repeats, least):
    """The ratios of both programs, and what the old one's solver takes. `least`: of the starts and of the floor so far, which no scene changes."""
    with tempfile.TemporaryDirectory() as folder:
        for file_name, content in (("shape.csv", table()), ("scene.toml", text), ("floor.toml", floor)):
            with open(os.path.join(folder, file_name), "w", encoding="utf-8") as file:
                file.write(content)
        found = {}
        for key, binary in binaries.items():
            found[key] = values(timed([binary, "run", "scene.toml", "--json"], folder)[1])
        if any(rows is None for rows in found.values()):
            print(f"{name:28} not solved by: {', '.join(key for key, rows in found.items() if rows is None)}")
            return None
        bounds, scale = difference(found["old"], found["new"])
        if bounds > 1.0:
            print(f"{name:28} they differ by {scale:.1e} of the largest value, {bounds:.2g} of both bounds: no ratio")
            return None
        commands = {(key, *arguments): [binary, *arguments] for key, binary in binaries.items() for arguments in (("run", "scene.toml"), ("--version",))}
        commands["floor"] = [binaries["new"], "run", "floor.toml"]
        for key in binaries:
            least[key, "run", "scene.toml"] = math.inf
        for _ in range(repeats):
            for key, command in commands.items():
                least[key] = min(least.get(key, math.inf), measured(command, folder)[0])
    old_start, start = least["old", "--version"], least["new", "--version"]
    old, new, floor = least["old", "run", "scene.toml"], least["new", "run", "scene.toml"], least["floor"]
    # What is below a tenth of a millisecond, or of a million instructions, is scatter of the start.
    solver = (old - old_start) / max(new - start, 0.1)
    print(f"{name:28} old {old:9.2f}  new {new:7.2f} (start {start:.2f}, floor {floor - start:.2f})  whole {old / new:7.1f}  solver {solver:7.1f}"
          f"  apart {scale:.1e} ({bounds:.2g} of both bounds)", flush=True)
    return old / new, solver, old - old_start


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--old", required=True)
    parser.add_argument("--new", required=True)
    parser.add_argument("--accuracy", type=float, default=1e-6)
    parser.add_argument("--repeats", type=int, default=15)
    parser.add_argument("--only", nargs="*", default=[], help="words that the name of a scene must hold")
    parser.add_argument("--energies", action="store_true", help="with the work done and the energies stored and lost")
    parser.add_argument("--instants", type=int, default=4, help="instants of each segment")
    parser.add_argument("--processor", action="store_true", help="milliseconds of the processor, of all threads")
    parser.add_argument("--instructions", action="store_true", help="millions of instructions, by valgrind, instead of milliseconds")
    options = parser.parse_args()
    binaries = {"old": os.path.abspath(options.old), "new": os.path.abspath(options.new)}
    measured, repeats, unit = timed, options.repeats, "milliseconds"
    if options.processor:
        measured, unit = processor, "milliseconds of the processor"
    if options.instructions:
        measured, repeats, unit = counted, 1, "millions of instructions"
    print(unit)
    floor, least = floor_scene(options.accuracy), {}
    ratios = []
    for control in CONTROLS:
        for shape in SHAPES:
            for terms in (1, 4, 12):
                name = f"{control} {shape} {terms}"
                if all(word in name.split() for word in options.only):
                    text = scene(shape, terms, control, options.accuracy, options.energies, options.instants)
                    ratios.append((name, compared(binaries, name, text, floor, measured, repeats, least)))
    for index, word in enumerate(("whole", "solver")):
        known = sorted((ratio[index], name) for name, ratio in ratios if ratio)
        if known:
            print(f"{word}: least {known[0][0]:.1f} ({known[0][1]}), median {known[len(known) // 2][0]:.1f}, "
                  f"{sum(ratio >= 20.0 for ratio, _ in known)} of {len(known)} at least 20")
    solved = [(name, *ratio) for name, ratio in ratios if ratio]
    if not solved:
        return
    floor = least["floor"] - least["new", "--version"]
    allowed = [(name, solver) for name, _, solver, old in solved if old >= 20.0 * floor]
    short = [f"{name} {solver:.1f}" for name, solver in allowed if solver < 20.0]
    print(f"floor: {floor:.2f}; the old program takes 20 of them in {len(allowed)} of {len(solved)}, of which {len(allowed) - len(short)} at least 20"
          + (f", not: {', '.join(short)}" if short else ""))


if __name__ == "__main__":
    main()
