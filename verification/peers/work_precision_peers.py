#!/usr/bin/env python3
"""Error against time of the peers on problems that this program solves as well: stored runs for the report of `viscotack verify`.

    FOLDER/bin/python verification/peers/work_precision_peers.py [HARNESS]     writes verification/peers/work_precision_peers.csv

HARNESS is the folder of the built harness (target/harness): with it, this program is measured in the same run, beside the peers.

Problems
    sliding_without_adhesion    a wave on one term (ninefold, relaxation time 0.1) at a speed of 0.6 under the mean pressure of the stored reference (adhesiveless, one,
                                half-width 0.8): larger error of penetration and friction stress, over max(|value|, 1), against that reference (eleven digits)
    elastic_wave                an elastic wave under a mean pressure of 0.5: larger error of penetration and work of the interface, against Westergaard
    adhesive_elastic_wave       an elastic adhesive wave (reduced work 0.01) at the penetration of a half-width of 0.4 half periods: error of the mean pressure, over
                                max(|value|, 1), against Johnson; the peers have a finite range and mesh, this program a process zone

seconds: the median of processor times of one thread in which the answer is made; nothing of the interpreter's start, of imports, of the truth.
"""

import csv
import datetime
import io
import logging
import os
import platform
import statistics
import sys
import time

import numpy as np

import adhesive_wave
import elastic_wave
from maxwell import slid
from shared import HERE, extrapolated, version
import common

TERMS, SPEED = [(9.0, 0.1)], 0.6
WORK, PART = 0.01, 0.4


def references():
    own = [row for row in common.read("sliding_wave.csv") if row["asked"] == "adhesiveless" and row["case"] == "one"]
    return {row["quantity"]: float(row["value"]) for row in own}


def timed(solve):
    """(answer, median of processor times): again and again for half a second, at most nine times."""
    times, answer = [], None
    while len(times) < 9 and (len(times) < 1 or sum(times) < 0.5):
        start = time.process_time()
        answer = solve()
        times.append(time.process_time() - start)
    return answer, statistics.median(times)


def worst(found, truth):
    return max(abs(one - right) / max(abs(right), 1.0) for one, right in zip(found, truth))


def sliding(harness):
    stored = references()
    load = stored["mean_pressure"]
    truth = [stored["penetration"], stored["friction_stress"]]

    def peer(points, parts):
        friction, depth, _ = slid(TERMS, SPEED, load, points, parts, settled=12.0)
        return depth, friction

    for points in (32, 64, 128, 256, 512):
        found, seconds = timed(lambda: peer(points, 1))
        yield "sliding_without_adhesion", "Tamaas, stepped", f"N = {points}", worst(found, truth), seconds
    for points in (32, 64, 128):
        def richer():
            runs = [peer(points, parts) for parts in (1, 2, 4)]
            return [extrapolated([run[index] for run in runs], 2, [1, 2])[0] for index in range(2)]
        found, seconds = timed(richer)
        yield "sliding_without_adhesion", "Tamaas, extrapolated", f"N = {points}, steps of 1, 1/2, 1/4 mesh", worst(found, truth), seconds
    if harness:
        solid = harness.Material.from_relaxation(1.0, [9.0], [0.1])
        for accuracy in (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12):
            found, seconds = timed(lambda: harness.sliding_steady(solid, SPEED, "mean_pressure", load, accuracy=accuracy))
            values = [found["penetration"][0], found["friction_stress"][0]]
            yield "sliding_without_adhesion", "this program", f"{accuracy:.0e}", worst(values, truth), seconds


def elastic(harness):
    load = 0.5
    square = load
    truth = [square * (1.0 - np.log(square)), 0.5 * np.pi * (square ** 2 - 2.0 * square ** 2 * np.log(square))]
    for name, solve in (("Tamaas", elastic_wave.by_tamaas), ("ContactMechanics", elastic_wave.by_contact_mechanics)):
        solve(16, load)     # imports
        for points in (32, 64, 128, 256, 512, 1024, 2048):
            (pressure, displacement), seconds = timed(lambda: solve(points, load))
            pressure = abs(pressure)
            numbers = {quantity: value for quantity, position, value in elastic_wave.quantities(points, pressure, displacement, load) if not position}
            yield "elastic_wave", name, f"N = {points}", worst([numbers["penetration"], numbers["interface_work"]], truth), seconds
    if harness:
        solid = harness.Material.from_creep(1.0, [], [])
        for accuracy in (1e-4, 1e-8, 1e-12):
            found, seconds = timed(lambda: harness.sliding_steady(solid, 1.0, "mean_pressure", load, accuracy=accuracy))
            yield "elastic_wave", "this program, sliding solver", f"{accuracy:.0e}", worst([found["penetration"][0], found["interface_work"][0]], truth), seconds


def adhesive(harness):
    depth = float(adhesive_wave.penetration_of(WORK, PART))
    sine = np.sin(0.5 * np.pi * PART)
    truth = [sine ** 2 - 2.0 * np.sqrt(WORK * np.tan(0.5 * np.pi * PART))]
    ladder = [(0.2, 256), (0.1, 1024), (0.05, 2048), (0.025, 4096)]
    for name, solve, steps in (("Tamaas", adhesive_wave.by_tamaas, ladder), ("Adhesion", adhesive_wave.by_adhesion, ladder[:3])):
        solve(64, WORK, 0.3, depth, None)   # imports
        for reach, points in steps:
            (pressure, _, _), seconds = timed(lambda: solve(points, WORK, reach, depth, None))
            yield "adhesive_elastic_wave", name, f"range {reach:g}, N = {points}", worst([abs(pressure.mean())], truth), seconds
    if harness:
        solid = harness.Material.from_creep(1.0, [], [])
        for zone in (1e-2, 1e-4, 1e-6, 1e-8):
            found, seconds = timed(lambda: harness.sliding_steady(solid, 1.0, "penetration", depth, edges=[WORK, WORK, zone, zone], accuracy=1e-10))
            yield "adhesive_elastic_wave", "this program, sliding solver", f"zone {zone:.0e}", worst([found["mean_pressure"][0]], truth), seconds


def machine():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    return f"{names[0] if names else platform.machine()}, {os.cpu_count()} cores, one used"


def main():
    logging.disable(logging.WARNING)
    harness = None
    if len(sys.argv) > 1:
        sys.path.insert(0, sys.argv[1])
        import viscotack_harness as harness
    stamps = {"Tamaas": version("tamaas"), "ContactMechanics": version("ContactMechanics"), "Adhesion": version("Adhesion"), "this program": "viscotack 0.1.0"}
    text = io.StringIO()
    text.write("# about: error against time of peers on problems that this program solves as well; seconds are processor time of one thread\n")
    text.write("# command: FOLDER/bin/python verification/peers/work_precision_peers.py target/harness\n")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["problem", "method", "setting", "error", "seconds", "machine", "version", "date"])
    for runs in (sliding(harness), elastic(harness), adhesive(harness)):
        for problem, method, setting, error, seconds in runs:
            print(problem, method, setting, f"{error:.2e}", f"{seconds:.3g} s", flush=True)
            writer.writerow([problem, method, setting, f"{error:.3e}", f"{seconds:.3e}", machine(), stamps[method.split(",")[0]], datetime.date.today().isoformat()])
    with open(os.path.join(HERE, "work_precision_peers.csv"), "w", encoding="utf-8", newline="") as file:
        file.write(text.getvalue())


if __name__ == "__main__":
    main()
