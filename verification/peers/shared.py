"""What the scripts of the peers share: reduced units, extrapolation, files.

Units       wave Lambda cos(kx): lengths in 1/k, displacements in Lambda, pressures in E0* k Lambda/2, energies per width in E0* Lambda^2/2, speeds in 1/k per
            reference time. The peers are run with k = Lambda = 1 and E0* = 2 or so: pressures are then divided by E0*/2.
Signs       pressure > 0 presses; the displacement w goes into the body and has no mean; in contact w = cos x - 1 + penetration.
Accuracy    a peer knows its solution on a grid, in steps, with a range of adhesion: the value is extrapolated in what is finest, and `error` is
            SAFETY times the change by the last refinement of the extrapolated value (or its whole difference from the finest one, if that is less).
"""

import importlib.metadata
import os
import sys

import numpy as np

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(HERE), "references"))
import common

PERIOD = 2.0 * np.pi
SAFETY = 2.0


def version(*names):
    return ", ".join(f"{name} {importlib.metadata.version(name)}" for name in names)


def extrapolated(values, ratio, orders):
    """(value, error) of a sequence whose discretisation gets finer by `ratio` each time; its error falls with these powers of it."""
    table = [np.asarray(values, dtype=float)]
    for order in orders[:len(values) - 1]:
        last, factor = table[-1], float(ratio) ** order
        table.append((factor * last[1:] - last[:-1]) / (factor - 1.0))
    best = table[-1]
    before = best[-2] if len(best) > 1 else table[-2][-1]
    return float(best[-1]), SAFETY * abs(float(best[-1] - before)) + 4e-16 * abs(float(best[-1]))


def digits(value):
    return f"{value:.12e}"


def row(error, scale=1.0, **columns):
    return {**columns, "error": f"{error:.2e}", "scale": common.double(scale)}


def write(name, about, columns, rows, precision, packages, script):
    common.write(name, f"FOLDER/bin/python verification/peers/{script}", about, columns, rows, precision=precision, tool=f"{version(*packages)}, {version('numpy', 'scipy')}")


def wave_position(points):
    return np.arange(points) * PERIOD / points
