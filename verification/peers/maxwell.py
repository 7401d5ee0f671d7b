#!/usr/bin/env python3
"""Tamaas's generalised Maxwell solver, stepped in time: relaxation of a full contact, creep of a partial one, friction of a sliding one; without adhesion.

    FOLDER/bin/python verification/peers/maxwell.py        writes reference_data/peers_maxwell.csv

FOLDER is made by verification/peers/setup.sh. The solver steps by backward Euler, so its error falls with the first power of the step: steps are halved and
extrapolated in whole powers. The wave slides over the grid by a part of a mesh each step; friction is a mean over the last whole mesh.
Its long-time shear modulus is 1 here, the only one that it is right for (maxwell_limits.py), so E0* = 2 and pressures are reduced ones.

Quantities
    amplitude        of the pressure of a full contact (mean pressure 1.5 times the largest that partial contact bears when fresh), a time after it was put on: R(t)/E0
    penetration      of a contact under a constant load, that grows: that of an elastic contact under the load E0 J(t) p
    friction_stress, penetration, interface_work     of a contact that has slid at a speed, under a load, until it is steady
"""

import sys

import numpy as np
import tamaas

from shared import PERIOD, SAFETY, digits, extrapolated, row, wave_position, write

# Modulus of a relaxation term over the relaxed one, and its relaxation time.
SOLIDS = {"one": [(9.0, 0.1)], "two": [(3.0, 0.5), (6.0, 0.04)], "stiff": [(99.0, 0.02)]}
TIMES = [0.05, 0.2, 0.8]
STEPS = [40, 80, 160, 320]
# Solid, speed in 1/k per unit time, mean pressure.
SLIDING = [("one", 0.2, 0.1), ("one", 0.6, 0.3), ("one", 3.0, 0.6), ("two", 0.5, 0.2), ("two", 2.0, 0.4), ("stiff", 0.3, 0.3)]
MESH, PARTS = 256, [1, 2, 4, 8]
SETTLED = 14.0
COLUMNS = ["asked", "solid", "terms", "speed", "mean_pressure", "time", "quantity", "value", "error", "scale"]


def solver(points, terms, step, long_time_shear=1.0):
    """(model, surface, solver); E0* = 2 long_time_shear, Poisson's ratio 0."""
    tamaas.set_log_level(tamaas.LogLevel.error)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_1d, [PERIOD], [points])
    model.E, model.nu = 2.0 * long_time_shear, 0.0
    surface = np.ascontiguousarray(np.cos(wave_position(points)))
    stepped = tamaas.MaxwellViscoelastic(model, surface, 1e-12, step, [ratio * long_time_shear for ratio, _ in terms], [time for _, time in terms])
    stepped.max_iter = 20000
    return model, surface, stepped


def depth(surface, pressure, displacement):
    """Penetration: what the contact lies above the mean of the displacement."""
    touching = pressure > 1e-9 * pressure.max()
    return 1.0 + (displacement - surface)[touching].mean() - displacement.mean()


def after_a_step(terms, mean_pressure, time, steps, points):
    model, surface, stepped = solver(points, terms, time / steps)
    for _ in range(steps):
        stepped.solve(mean_pressure)
    return surface, model.traction.ravel().copy(), model.displacement.ravel().copy()


def slid(terms, speed, mean_pressure, points, parts, settled=SETTLED, long_time_shear=1.0, every=None):
    """(friction stress, penetration, interface work) over the last mesh; the wave moves to +x."""
    length = PERIOD / points / parts
    model, surface, stepped = solver(points, terms, length / speed, long_time_shear)
    longest = retardation_time(terms)
    count = max(int(np.ceil(settled * longest * speed / length)), int(np.ceil(PERIOD / length)))
    x = wave_position(points)
    sums, kept = np.zeros(3), []
    for index in range(1, count + 1):
        surface[...] = np.cos(x - index * length)
        stepped.solve(mean_pressure * long_time_shear)
        last = index > count - parts
        if last or every:
            pressure, displacement = model.traction.ravel() / long_time_shear, model.displacement.ravel()
            friction = np.mean(pressure * np.sin(x - index * length))
            if every:
                kept.append(friction)
            if last:
                work = 0.5 * np.mean(pressure * (displacement - displacement.mean())) * PERIOD
                sums += np.array([friction, depth(surface, pressure, displacement), work]) / parts
    return np.array(kept) if every else sums


def retardation_time(terms):
    """The longest one: the smallest zero of the compliance's denominator, by bisection."""
    slowest = max(time for _, time in terms)
    rates = [(ratio, 1.0 / time) for ratio, time in terms]
    low, high = 0.0, 1.0 / slowest
    for _ in range(200):
        middle = 0.5 * (low + high)
        # E0 - sum E_i l/(r_i - l) falls from E0 to minus infinity.
        if 1.0 - sum(ratio * middle / (rate - middle) for ratio, rate in rates) > 0.0:
            low = middle
        else:
            high = middle
    return 1.0 / low


def with_the_mesh(one, beside, here):
    """Adds what the mesh leaves open, by the same step on half of it and on twice as many points: edges fall between points, so its order is no more
    than one, and what remains twice the change."""
    coarser, finer = (abs(other - here) for other in beside)
    # Such edges disturb the extrapolation in the steps as well: its error is doubled once more.
    one["error"] = f"{SAFETY * (float(one['error']) + 2.0 * max(0.5 * coarser, finer)):.2e}"
    print("   with the mesh", one["error"], flush=True)
    return one


def rows():
    def told(sequence, orders, **columns):
        value, error = extrapolated(sequence, 2, orders)
        print(*columns.values(), f"{value:.9f} +- {error:.1e}   changes", " ".join(f"{b - a:.1e}" for a, b in zip(sequence, sequence[1:])), flush=True)
        return row(error, **columns, value=digits(value))

    for name, terms in SOLIDS.items():
        text = " ".join(f"{ratio!r}:{time!r}" for ratio, time in terms)
        glassy = 1.0 + sum(ratio for ratio, _ in terms)
        for time in TIMES:
            load = 1.5 * glassy
            runs = [after_a_step(terms, load, time, steps, 64) for steps in STEPS]
            yield told([2.0 * np.mean(pressure * np.cos(wave_position(64))) for _, pressure, _ in runs], [1, 2, 3], asked="relaxation", solid=name, terms=text, speed="",
                       mean_pressure=repr(load), time=repr(time), quantity="amplitude")
        for time in TIMES:
            runs = [depth(*after_a_step(terms, 0.15, time, steps, 1024)) for steps in STEPS]
            one = told(runs, [1, 2, 3], asked="creep", solid=name, terms=text, speed="", mean_pressure="0.15", time=repr(time), quantity="penetration")
            yield with_the_mesh(one, [depth(*after_a_step(terms, 0.15, time, STEPS[-1], points)) for points in (512, 2048)], runs[-1])
    for name, speed, load in SLIDING:
        terms = SOLIDS[name]
        text = " ".join(f"{ratio!r}:{time!r}" for ratio, time in terms)
        runs = [slid(terms, speed, load, MESH, parts) for parts in PARTS]
        beside = [slid(terms, speed, load, MESH // 2, 2 * PARTS[-1]), slid(terms, speed, load, 2 * MESH, PARTS[-1] // 2)]
        for index, quantity in enumerate(["friction_stress", "penetration", "interface_work"]):
            one = told([run[index] for run in runs], [1, 2, 3], asked="sliding", solid=name, terms=text, speed=repr(speed), mean_pressure=repr(load), time="", quantity=quantity)
            yield with_the_mesh(one, [run[index] for run in beside], runs[-1][index])


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    write("peers_maxwell.csv", "a wave on a generalised Maxwell solid without adhesion, by another program in time steps; terms are modulus over the relaxed one : relaxation time", COLUMNS,
          list(rows()), "backward Euler, steps halved three times and extrapolated; `error` is twice the last change of the extrapolated value, and where edges move four times the change by the mesh, whose order is one", ["tamaas"],
          "maxwell.py")
