#!/usr/bin/env python3
"""Where Tamaas's Maxwell solver may be used, measured: its long-time shear modulus, adhesion, and how long a sliding contact takes to settle.

    FOLDER/bin/python verification/peers/maxwell_limits.py        writes verification/peers/maxwell_limits.csv

Every number is reduced, so that a change of all moduli together (with the load) must change nothing. The case: one term of nine times the relaxed modulus, relaxation
time 0.1, a wave under a mean pressure of 0.3 that slides at 0.6 wave numbers per unit time; 128 points, one step a mesh.
"""

import contextlib
import io
import os
import tempfile

import numpy as np
import tamaas

from maxwell import SOLIDS, retardation_time, slid, solver
from shared import HERE, PERIOD, version, wave_position

TERMS, SPEED, LOAD, POINTS = SOLIDS["one"], 0.6, 0.3, 128


@contextlib.contextmanager
def all_that_is_said(said):
    """Whatever the process writes to its standard streams, also from compiled code."""
    with tempfile.TemporaryFile() as file:
        kept = [os.dup(1), os.dup(2)]
        os.dup2(file.fileno(), 1)
        os.dup2(file.fileno(), 2)
        try:
            yield
        finally:
            for stream, own in enumerate(kept, 1):
                os.dup2(own, stream)
            file.seek(0)
            said.append(file.read().decode())


def relaxation(modulus):
    """R/E0 of a full contact 0.05 after it was put on, in 40 steps."""
    model, surface, stepped = solver(64, TERMS, 0.05 / 40, modulus)
    for _ in range(40):
        stepped.solve(15.0 * modulus)
    return 2.0 * np.mean(model.traction.ravel() * np.cos(wave_position(64))) / modulus


def adhesive(kind, with_functional):
    """(largest tension, penetration-like mean of the displacement) of a solver with or without an adhesion functional."""
    tamaas.set_log_level(tamaas.LogLevel.info)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_1d, [PERIOD], [POINTS])
    model.E, model.nu = 2.0, 0.0
    surface = np.ascontiguousarray(np.cos(wave_position(POINTS)))
    if kind == "viscoelastic":
        found = tamaas.MaxwellViscoelastic(model, surface, 1e-10, 0.01, [9.0], [0.1])
    else:
        found = tamaas.PolonskyKeerRey(model, surface, 1e-10, tamaas.PolonskyKeerRey.gap, tamaas.PolonskyKeerRey.gap)
    if with_functional:
        functional = tamaas.ExponentialAdhesionFunctional(surface)
        functional.parameters = {"rho": 0.1, "surface_energy": 0.1}
        found.addFunctionalTerm(functional)
    for _ in range(100 if kind == "viscoelastic" else 1):
        found.solve(0.3)
    return -float(model.traction.min())


def rows():
    exact = slid(TERMS, SPEED, LOAD, POINTS, 1)[0]
    for modulus in (0.1, 0.5, 1.0, 2.0, 10.0, 1e6):
        yield "friction_stress", f"long-time shear modulus {modulus:g}", slid(TERMS, SPEED, LOAD, POINTS, 1, long_time_shear=modulus)[0], exact
    exact = relaxation(1.0)
    for modulus in (0.1, 0.5, 1.0, 2.0, 10.0, 1e6):
        yield "relaxation", f"long-time shear modulus {modulus:g}", relaxation(modulus), exact
    said = []
    for kind in ("elastic", "viscoelastic"):
        for functional in (False, True):
            with all_that_is_said(said):
                tension = adhesive(kind, functional)
            # What an adhesion functional should give the elastic contact is what the gap-based solver gives it.
            yield "largest_tension", f"{kind}, {'with' if functional else 'without'} an adhesion functional", tension, float("nan")
    words = [line for line in said[-1].splitlines() if "adhes" in line.lower() or "functional" in line.lower() or "warn" in line.lower()]
    yield "lines_about_adhesion", "viscoelastic, with an adhesion functional", len(words), float("nan")
    course = slid(TERMS, SPEED, LOAD, POINTS, 1, settled=24.0, every=True)
    step = PERIOD / POINTS / SPEED / retardation_time(TERMS)
    for times in (1, 2, 4, 6, 8, 10, 12, 16):
        yield "friction_stress", f"slid for {times} retardation times", course[round(times / step) - 1], course[-1]


def main():
    text = io.StringIO()
    text.write("# about: where Tamaas's Maxwell solver may be used, measured; `right` is its own value where it is right, deviation relative to that\n")
    text.write(f"# command: FOLDER/bin/python verification/peers/maxwell_limits.py\n# tool: {version('tamaas', 'numpy')}\n")
    text.write("quantity,case,value,right,deviation\n")
    for quantity, case, value, right in rows():
        deviation = "" if right != right else f"{value / right - 1.0:.2e}"
        text.write(f'{quantity},"{case}",{value:.8g},{"" if right != right else f"{right:.8g}"},{deviation}\n')
    with open(os.path.join(HERE, "maxwell_limits.csv"), "w", encoding="utf-8", newline="") as file:
        file.write(text.getvalue())
    print(text.getvalue())


if __name__ == "__main__":
    main()
