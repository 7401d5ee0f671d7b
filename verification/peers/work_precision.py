#!/usr/bin/env python3
"""Error against time of the references in numpy, on problems of `viscotack verify`; writes verification/peers/work_precision.csv.

    FOLDER/bin/python verification/peers/work_precision.py        one thread, some ten minutes

FOLDER needs numpy, scipy and mpmath (verification/peers/setup.sh makes one). Tamaas, ContactMechanics and Adhesion: work_precision_peers.py. Seconds: median processor time of several solutions in one process, imports not counted. The same problems, truths and measures as
in verification/src/studies/precision:

delayed_fracture    verification/references/delayed_fracture.py, the thesis's stepping in numpy: largest |place - closed form|/zone at 2 to 6 delays
sphere_retraction   verification/references/sphere_annuli.py, dense annuli with exact memories: force at t = 10, 14 and 18 over the largest, against the extrapolated values
                    of reference_data/sphere_annuli.csv (of the same program on finer meshes: an estimate of its error, sure to 3e-7)
sphere_prescribed_edge   the same along a prescribed edge, against the extrapolated force (sure to 2e-9)
"""

import os

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"

import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(os.path.dirname(HERE), "references")]

import csv
import datetime
import importlib.metadata
import math
import platform
import statistics
import time

import mpmath
import numpy as np

import delayed_fracture
import sphere_annuli
from common import read

COLUMNS = ["problem", "method", "setting", "error", "seconds", "machine", "version", "date"]


def version(*names):
    return " ".join(f"{name} {importlib.metadata.version(name)}" for name in names)


def machine():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            model = next(line.split(":")[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        model = platform.machine()
    return f"{model} one core"


def timed(work, most=5, patience=2.0):
    """(result, median seconds): of at most five runs, of one if that takes longer than the patience."""
    seconds = []
    while len(seconds) < most and sum(seconds) < patience:
        begun = time.process_time()
        result = work()
        seconds.append(time.process_time() - begun)
    return result, statistics.median(seconds)


# ---------------------------------------------------------------- growth of a crack

def growth():
    """The case of verification/src/studies/convergence/crack.rs."""
    relaxed, beta, tau, work, zone, ratio, last = 1.1e6, 10.0, 0.37, 0.31, 2.3e-6, 3.0, 6
    c = (1.0 - 1.0 / ratio) / (1.0 - 1.0 / beta)
    delay = -tau * math.log(c)
    load = math.sqrt(2.0 * work * ratio * relaxed)
    # Polynomials of w = e^(t/tau), zone by zone.
    polynomials = [np.array([1.0 / c - 1.0])]
    for _ in range(7):
        before = polynomials[-1]
        start = math.exp(1.0 / c) * before.sum()
        polynomials.append(np.concatenate([[start], -before / (c * np.arange(1, len(before) + 1))]))

    def reached(q):
        number = int(q)
        s = q - number
        return tau * math.log1p(math.exp(s / c) * float(np.polyval(polynomials[number][::-1], s)))

    def place(t):
        low, high = 0.0, len(polynomials) - 1e-12
        for _ in range(80):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if reached(middle) < t else (low, middle)
        return low

    class Solid:
        strengths, times = [(1.0 - 1.0 / beta) / relaxed], [tau]

        @staticmethod
        def instant_compliance():
            return 1.0 / (beta * relaxed)

    for steps in (4, 8, 16, 32, 64):
        points = 12 * steps
        places, seconds = timed(lambda: delayed_fracture.raw_run(Solid, work, lambda t: zone, lambda t: load, last * delay, last * steps, points))
        error = max(abs(float(places[delays * steps]) / zone - place(delays * delay)) for delays in range(2, last + 1))
        yield "delayed_fracture", "thesis's stepping, numpy", f"{steps} steps a delay", error, seconds, version("numpy")


# ---------------------------------------------------------------- sphere

def sphere():
    stored = [row for row in read("sphere_annuli.csv")]
    forces = {float(row["time"]): (float(row["value"]), float(row["scale"])) for row in stored
              if row["case"] == "closed, retraction" and row["quantity"] == "force"}
    case = next(case for case in sphere_annuli.closed_cases() if case[0] == "closed, retraction")
    for refinement in (1, 2, 4, 8):
        (_, _, table), seconds = timed(lambda: sphere_annuli.closed(case, refinement))
        error = max(abs(sphere_annuli.interpolated(table, t, 0, len(table) - 1)[1] - value) / scale for t, (value, scale) in forces.items())
        yield "sphere_retraction", "dense annuli, exact memory, numpy", f"{sphere_annuli.COARSEST_CLOSED * refinement} annuli a zone", error, seconds, version("numpy", "scipy")
    row = next(row for row in stored if row["case"] == "retraction" and row["quantity"] == "force" and row["instant"] == "1")
    case = next(case for case in sphere_annuli.prescribed_cases() if case[0] == "retraction")
    for refinement in (1, 2, 4):
        values, seconds = timed(lambda: sphere_annuli.prescribed(case, refinement))
        error = abs(values[1, "force", ""] - float(row["value"])) / float(row["scale"])
        yield "sphere_prescribed_edge", "dense annuli, numpy", f"{sphere_annuli.COARSEST * refinement} annuli a zone", error, seconds, version("numpy", "scipy")


def main():
    stamp = {"machine": machine(), "date": datetime.date.today().isoformat()}
    path = os.path.join(HERE, "work_precision.csv")
    rows = []
    for part in (growth, sphere):
        for problem, method, setting, error, seconds, packages in part():
            print(f"{problem:24} {method:40} {setting:20} error {error:.2e}  {seconds:.3g} s", flush=True)
            rows.append({"problem": problem, "method": method, "setting": setting, "error": f"{error:.2e}", "seconds": f"{seconds:.3g}", "version": packages, **stamp})
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
