#!/usr/bin/python3
"""Error against time of the finite elements; writes verification/peers/work_precision_fenicsx.csv.

    verification/harness/build.sh && /usr/bin/python3 verification/fenicsx/work_precision.py

Errors of the force against the solver (whose own error is below 1e-10 here), over the largest force of the history. Seconds: processor time of one process,
forms compiled before; a mesh, its factor and all steps are in it. `extrapolated`: two or three meshes, times added.
"""

import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(os.path.dirname(HERE), "references"), os.path.join(os.path.dirname(HERE), "crosscheck")]
os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"

import csv
import datetime
import hashlib
import io
import platform
import time

import dolfinx

import cases
import elements
import integration
import run
import tools
from common import read

COLUMNS = ["problem", "method", "setting", "error", "seconds", "machine", "version", "date"]
PROBLEM = {"sphere": "sphere, retraction along a prescribed edge, one relaxation time", "punch": "flat punch pressed at once and held, elastic bulk, viscoelastic shear"}


def timed(work):
    """(result, processor seconds)."""
    begun = time.process_time()
    result = work()
    return result, time.process_time() - begun


def machine():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        model = next((line.split(":")[1].strip() for line in file if line.startswith("model name")), platform.machine())
    return f"{model}, one core"


def rows(harness):
    stored = {(row["case"], row["instant"], row["quantity"]): row for row in read(run.FILE)}
    case = next(case for case in cases.histories() if case.name == "retraction")
    last = stored[case.name, "2", "force"]
    found, _ = elements.followed(harness, last, [last])
    exact, scale = float(found["force"][1]), float(last["scale"])
    integration.history(case, 1)          # forms compiled
    raw, spent = [], []
    for refinement in run.REFINEMENTS:
        result, seconds = timed(lambda refinement=refinement: integration.history(case, refinement))
        raw.append(result[2, "force", ""])
        spent.append(seconds)
        yield "sphere", f"P{integration.DEGREE}, {3 * refinement} elements a zone", abs(raw[-1] - exact) / scale, seconds
    yield "sphere", "extrapolated, two meshes", abs(2.0 * raw[1] - raw[0] - exact) / scale, sum(spent[:2])
    yield "sphere", "extrapolated, three meshes", abs(run.in_space(raw)[0] - exact) / scale, sum(spent)
    last = stored["punch, elastic bulk", "2", "force"]
    found, _ = elements.followed(harness, last, [last])
    exact, scale = float(found["force"][2]), float(last["scale"])
    for smallest, ratio, degree, steps in ((1e-3, 2.0, 2, 4), (1e-4, 2.0, 3, 8), (*integration.PUNCH, 16)):
        def solved():
            body, candidates = integration.graded_body(cases.ELASTIC_BULK, cases.PUNCH_RADIUS, smallest, ratio, degree)
            return integration.punch(cases.ELASTIC_BULK, body, candidates, steps)[2, "force", ""]

        value, seconds = timed(solved)
        yield "punch", f"P{degree}, {steps} steps an octave", abs(value - exact) / scale, seconds


def main():
    harness = tools.harness()
    stamp = {"machine": machine(), "version": f"dolfinx {dolfinx.__version__}", "date": datetime.date.today().isoformat()}
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    for problem, setting, error, seconds in rows(harness):
        writer.writerow({"problem": PROBLEM[problem], "method": "FEniCSx, axisymmetric elements", "setting": setting, "error": f"{error:.2e}", "seconds": f"{seconds:.3g}", **stamp})
    body = text.getvalue()
    header = {"about": "error of the force against processor time, finite elements of the body", "command": "/usr/bin/python3 verification/fenicsx/work_precision.py",
              "tool": stamp["version"], "sha256": hashlib.sha256(body.encode()).hexdigest()}
    path = os.path.join(os.path.dirname(HERE), "peers", "work_precision_fenicsx.csv")
    with open(path, "w", encoding="utf-8", newline="") as file:
        file.write("".join(f"# {key}: {value}\n" for key, value in header.items()) + body)
    print(body)


if __name__ == "__main__":
    main()
