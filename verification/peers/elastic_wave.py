#!/usr/bin/env python3
"""An elastic wave without adhesion by ContactMechanics and by Tamaas: penetration, work of the interface, pressures and gaps under a given mean pressure.

    FOLDER/bin/python verification/peers/elastic_wave.py        writes reference_data/peers_elastic_wave.csv

FOLDER is made by verification/peers/setup.sh. Both solve the pressed wave on a grid with the harmonic kernel (by conjugate gradients, with a contact set).
Loads are such that edges lie on grid lines: the error then falls smoothly, with the second power of the mesh, and is extrapolated.
ContactMechanics holds the far end, not the load: the load is found by secants. (Its stiffness at q = 0 is that of the first harmonic unless it is given, so
`offset` is not the penetration; a given stiffness of 0 raises an IndexError in one dimension. The mean of its displacement is subtracted here.)
"""

import logging

import numpy as np

from shared import PERIOD, digits, extrapolated, row, wave_position, write

# Edges at these parts of a half period: multiples of the coarsest mesh.
PARTS = {"quarter": 0.25, "half": 0.5, "three_quarters": 0.75, "seven_eighths": 0.875}
GRIDS = [128, 256, 512, 1024, 2048]
COLUMNS = ["peer", "case", "quantity", "mean_pressure", "position", "value", "error", "scale"]


def quantities(points, pressure, displacement, mean_pressure):
    """Of reduced fields on the grid."""
    x = wave_position(points)
    displacement = displacement - displacement.mean()
    crest = displacement[0]             # w = penetration at the crest
    gap = displacement - (np.cos(x) - 1.0 + crest)
    yield "penetration", "", crest
    yield "interface_work", "", 0.5 * np.mean(pressure * displacement) * PERIOD
    yield "pressure", "0.0", pressure[0]
    # An eighth of a half period off the crest, inside every contact; a sixteenth off the trough, outside every contact.
    yield "pressure", "0.125", pressure[points // 16]
    yield "gap", "0.9375", gap[points // 2 - points // 32]
    yield "gap", "1.0", gap[points // 2]
    assert abs(pressure.mean() - mean_pressure) < 1e-9, (pressure.mean(), mean_pressure)


def by_tamaas(points, mean_pressure):
    import tamaas
    tamaas.set_log_level(tamaas.LogLevel.error)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_1d, [PERIOD], [points])
    model.E, model.nu = 2.0, 0.0
    surface = np.ascontiguousarray(np.cos(wave_position(points)))
    solver = tamaas.PolonskyKeerRey(model, surface, 1e-14)
    solver.max_iter = 20000
    solver.solve(mean_pressure)
    return model.traction.ravel().copy(), model.displacement.ravel().copy()


def by_contact_mechanics(points, mean_pressure):
    from ContactMechanics import PeriodicFFTElasticHalfSpace
    from ContactMechanics.Systems import NonSmoothContactSystem
    from SurfaceTopography import UniformLineScan
    topography = UniformLineScan(np.cos(wave_position(points)) - 1.0, PERIOD, periodic=True)
    system = NonSmoothContactSystem(PeriodicFFTElasticHalfSpace((points,), 2.0, (PERIOD,)), topography)

    def load(offset):
        found = system.minimize_proxy(offset=offset, pentol=1e-13, maxiter=20000)
        assert found.success, found.message
        return system.compute_normal_force() / PERIOD

    offsets = [mean_pressure + 0.5, mean_pressure + 0.6]
    loads = [load(offset) for offset in offsets]
    for _ in range(40):
        if abs(loads[-1] - mean_pressure) < 1e-13:
            break
        (one, other), (first, second) = offsets[-2:], loads[-2:]
        if first == second:
            break
        offsets.append(other - (second - mean_pressure) * (other - one) / (second - first))
        loads.append(load(offsets[-1]))
    return -np.asarray(system.force) * points / PERIOD, np.asarray(system.disp).copy()


def rows():
    for peer, solve in (("Tamaas", by_tamaas), ("ContactMechanics", by_contact_mechanics)):
        for case, part in PARTS.items():
            mean_pressure = float(np.sin(0.5 * np.pi * part) ** 2)
            runs = []
            for points in GRIDS:
                pressure, displacement = solve(points, mean_pressure)
                sign = 1.0 if pressure.mean() > 0.0 else -1.0
                runs.append(list(quantities(points, sign * pressure, displacement, mean_pressure)))
            for index, (quantity, position, _) in enumerate(runs[0]):
                sequence = [run[index][2] for run in runs]
                value, error = extrapolated(sequence, 2, [2, 3])
                print(f"{peer:17} {case:15} {quantity:15} {position:6} {value:.10f} +- {error:.1e}   changes", " ".join(f"{b - a:.1e}" for a, b in zip(sequence, sequence[1:])), flush=True)
                yield row(error, peer=peer, case=case, quantity=quantity, mean_pressure=repr(mean_pressure), position=position, value=digits(value))


if __name__ == "__main__":
    logging.disable(logging.WARNING)
    write("peers_elastic_wave.csv", "an elastic wave without adhesion, by two other programs; position in half periods from the crest", COLUMNS, list(rows()),
          f"grids of {GRIDS[0]} to {GRIDS[-1]} points, edges on grid lines, extrapolated; `error` is twice the change by the last refinement", ["tamaas", "ContactMechanics"],
          "elastic_wave.py")
