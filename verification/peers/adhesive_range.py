#!/usr/bin/env python3
"""Elastic lines and surfaces under an exponential attraction of finite range beyond a hard wall, by Tamaas: load, contact and energy at a mean gap.

    FOLDER/bin/python verification/peers/adhesive_range.py       writes reference_data/peers_adhesive_range.csv

FOLDER is made by verification/peers/setup.sh. Heights are sums of the waves of the column `waves` (number along x, along y, amplitude, phase), largest where they
press. Units: k = Lambda = 1, E0* = 2, so that pressures are in E0* k Lambda/2. Tamaas holds the mean gap by its gap-based solver with an adhesion functional.
Per state the mesh is refined; `value` is that of the finest, `error` twice the largest of the last two changes, and what its solver leaves.
"""

import sys
import time

import numpy as np

from shared import PERIOD, SAFETY, digits, row, write

RESIDUAL = 1e-9
COLUMNS = ["case", "waves", "work", "range", "mean_gap", "quantity", "value", "error", "scale", "points"]
WAVE = [(1, 0, 1.0, 0.0)]
FIVE = [(1, 0, 1.0, 0.0), (2, 0, 0.35, 2.1), (3, 0, 0.3, 0.5), (4, 0, 0.15, -1.2), (5, 0, 0.2, 1.7)]
EGGS = [(1, 0, 0.5, 0.0), (0, 1, 0.5, 0.0)]
ROUGH = [(1, 0, 0.5, 0.3), (0, 1, 0.4, 1.1), (1, 1, 0.3, -0.4), (1, -1, 0.25, 2.0), (2, 0, 0.2, 0.9), (2, 1, 0.15, -2.2), (1, -2, 0.18, 0.1), (3, 1, 0.1, 1.4), (3, -2, 0.08, 2.7)]
CASES = [("wave", WAVE, 0.006, 0.1, 0.6), ("wave, wide", WAVE, 0.004, 0.08, 0.3), ("wave, little", WAVE, 0.008, 0.15, 0.85), ("five waves", FIVE, 0.005, 0.1, 0.7),
         ("five waves, more", FIVE, 0.005, 0.1, 0.35), ("eggs", EGGS, 0.006, 0.12, 0.45), ("eggs, little", EGGS, 0.006, 0.12, 0.8), ("rough", ROUGH, 0.006, 0.15, 0.5),
         ("rough, little", ROUGH, 0.006, 0.15, 0.8)]


def heights(waves, points, dimensions):
    x = np.arange(points) * PERIOD / points
    if dimensions == 1:
        return sum(a * np.cos(m * x + p) for m, _, a, p in waves)
    return sum(a * np.cos(m * x[:, None] + n * x[None, :] + p) for m, n, a, p in waves)


def by_tamaas(points, waves, work, reach, gap):
    import tamaas
    tamaas.set_log_level(tamaas.LogLevel.error)
    dimensions = 2 if any(n for _, n, _, _ in waves) else 1
    kind = tamaas.model_type.basic_1d if dimensions == 1 else tamaas.model_type.basic_2d
    model = tamaas.ModelFactory.createModel(kind, [PERIOD] * dimensions, [points] * dimensions)
    model.E, model.nu = 2.0, 0.0
    surface = np.ascontiguousarray(heights(waves, points, dimensions))
    by_gap = tamaas.PolonskyKeerRey.gap
    solver = tamaas.PolonskyKeerRey(model, surface, RESIDUAL, by_gap, by_gap)
    functional = tamaas.ExponentialAdhesionFunctional(surface)
    functional.parameters = {"rho": reach, "surface_energy": work}
    solver.addFunctionalTerm(functional)
    solver.max_iter = 50000
    residual = solver.solve(gap)
    assert residual <= RESIDUAL, residual
    pressure = model.traction.reshape(surface.shape)
    displacement = model.displacement.reshape(surface.shape)
    # Gap from the displacement: zero where they touch.
    distance = displacement - surface
    distance = distance - distance.mean() + gap
    touching = distance < 1e-9
    return {"mean_pressure": pressure.mean(), "contact_fraction": touching.mean(), "interface_energy": -(work * np.exp(-distance / reach)).mean()}, distance.min()


def rows():
    for case, waves, gamma, reach, gap in CASES:
        work = PERIOD * gamma
        surface = any(n for _, n, _, _ in waves)
        runs = []
        for points in [64, 128, 256, 512] if surface else [1024, 2048, 4096, 8192]:
            start = time.time()
            found, least = by_tamaas(points, waves, work, reach, gap)
            runs.append(found)
            print(f"{case:18} {points:5}", found, f"least gap {least:.1e}", f"{time.time() - start:.1f} s", flush=True)
        for quantity in runs[-1]:
            sequence = [run[quantity] for run in runs]
            error = SAFETY * max(abs(b - a) for a, b in zip(sequence[-3:-1], sequence[-2:])) + 10 * RESIDUAL
            if quantity == "contact_fraction":
                # An edge lies anywhere between two points.
                error += 2 / points
            text = "; ".join(f"{m} {n} {a!r} {p!r}" for m, n, a, p in waves)
            yield row(error, case=case, waves=text, work=repr(work), range=repr(reach), mean_gap=repr(gap), quantity=quantity, value=digits(sequence[-1]), points=points)


if __name__ == "__main__":
    found = list(rows())
    if len(sys.argv) == 1:
        write("peers_adhesive_range.csv", "elastic lines and surfaces under an exponential attraction of finite range, by another program", COLUMNS, found,
              "four meshes, each twice as fine; the finest, `error` from the last two changes", ["tamaas"], "adhesive_range.py")
