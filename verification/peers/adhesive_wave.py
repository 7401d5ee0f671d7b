#!/usr/bin/env python3
"""An elastic adhesive wave by Tamaas and by Adhesion, as the range of an exponential attraction vanishes (Johnson's wave): load, pressure and gap at a penetration.

    FOLDER/bin/python verification/peers/adhesive_wave.py        writes reference_data/peers_adhesive_wave.csv

FOLDER is made by verification/peers/setup.sh. Work of adhesion Gamma pi E0* k Lambda^2, tension falling as e^(-gap/range) beyond a hard wall. Per range the
mesh is refined and extrapolated (first order: the edge falls between two points), then the finest range is taken, as the error in the range changes its sign.
Tamaas holds the mean gap by its gap-based solver with an adhesion functional. Adhesion's bounded smooth system holds the far end, by L-BFGS-B; its
penetration is found by secants.
"""

import logging
import sys

import numpy as np

from shared import PERIOD, SAFETY, digits, extrapolated, row, wave_position, write

# Gamma, half-width over half a period of the contact of no range, whose penetration is held.
CASES = {"weak": (0.003, 0.3), "middle": (0.01, 0.4), "wide": (0.01, 0.5)}
# Range over the amplitude, and meshes for it.
RANGES = {"Tamaas": [0.1 / 2 ** (0.5 * k) for k in range(5)], "Adhesion": [0.2 / 2 ** (0.5 * k) for k in range(5)]}
GRIDS = {"Tamaas": [2048, 4096, 8192], "Adhesion": [512, 1024, 2048]}
COLUMNS = ["peer", "case", "reduced_work", "penetration", "quantity", "position", "value", "error", "scale"]


def penetration_of(work, part):
    sine = np.sin(0.5 * np.pi * part)
    return sine ** 2 * (1 - 2 * np.log(sine)) + 4 * np.sqrt(work * np.tan(0.5 * np.pi * part)) * np.log(sine)


def quantities(points, pressure, displacement):
    x = wave_position(points)
    displacement = displacement - displacement.mean()
    gap = displacement - (np.cos(x) - 1.0 + displacement[0])
    yield "mean_pressure", "", pressure.mean()
    yield "pressure", "0.0", pressure[0]
    yield "gap", "1.0", gap[points // 2]


def by_tamaas(points, work, reach, penetration, _):
    import tamaas
    tamaas.set_log_level(tamaas.LogLevel.error)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_1d, [PERIOD], [points])
    model.E, model.nu = 2.0, 0.0
    surface = np.ascontiguousarray(np.cos(wave_position(points)))
    kind = tamaas.PolonskyKeerRey.gap
    solver = tamaas.PolonskyKeerRey(model, surface, 1e-10, kind, kind)
    functional = tamaas.ExponentialAdhesionFunctional(surface)
    functional.parameters = {"rho": reach, "surface_energy": 2.0 * np.pi * work}
    solver.addFunctionalTerm(functional)
    solver.max_iter = 1000000
    residual = solver.solve(1.0 - penetration)
    assert residual <= 1e-10, residual
    return model.traction.ravel().copy(), model.displacement.ravel().copy(), None


def by_adhesion(points, work, reach, penetration, known):
    from Adhesion.Interactions import Exponential
    from Adhesion.System.Systems import BoundedSmoothContactSystem
    from ContactMechanics import PeriodicFFTElasticHalfSpace
    from SurfaceTopography import UniformLineScan
    topography = UniformLineScan(np.cos(wave_position(points)) - 1.0, PERIOD, periodic=True)
    half_space = PeriodicFFTElasticHalfSpace((points,), 2.0, (PERIOD,))
    system = BoundedSmoothContactSystem(half_space, Exponential(2.0 * np.pi * work, reach), topography)
    options = {"ftol": 0.0, "gtol": 1e-11, "maxiter": 100000, "maxfun": 100000, "maxcor": 40}
    state = {"start": np.zeros(points) + 0.2}

    def depth(offset):
        system.minimize_proxy(offset=offset, initial_displacements=state["start"], options=options)
        state["start"] = np.asarray(system.disp).copy()
        # Stiffness of the mean displacement: that of the first harmonic, E0*/2 = 1.
        return offset - state["start"].mean()

    offsets = list(known or (penetration + 0.1, penetration + 0.15))
    depths = [depth(offset) for offset in offsets]
    for _ in range(12):
        if abs(depths[-1] - penetration) < 3e-10 or depths[-1] == depths[-2]:
            break
        slope = (offsets[-1] - offsets[-2]) / (depths[-1] - depths[-2])
        offsets.append(offsets[-1] - slope * (depths[-1] - penetration))
        depths.append(depth(offsets[-1]))
    assert abs(depths[-1] - penetration) < 1e-8, depths
    displacement = state["start"]
    pressure = -np.asarray(half_space.evaluate_force(displacement)) * points / PERIOD
    # What holds the mean displacement is the load itself.
    return pressure, displacement, offsets[-2:]


def rows(peers):
    for peer, solve in (("Tamaas", by_tamaas), ("Adhesion", by_adhesion)):
        if peer not in peers:
            continue
        for case, (work, part) in CASES.items():
            penetration = float(penetration_of(work, part))
            by_range, errors, known = [], [], None
            for reach in RANGES[peer]:
                runs = []
                for points in GRIDS[peer]:
                    pressure, displacement, known = solve(points, work, reach, penetration, known)
                    if pressure[0] < 0.0:
                        pressure = -pressure
                    runs.append(list(quantities(points, pressure, displacement)))
                found = [extrapolated([run[index][2] for run in runs], 2, [1]) for index in range(len(runs[0]))]
                by_range.append([value for value, _ in found])
                errors.append([error for _, error in found])
            for index, (quantity, position, _) in enumerate(runs[0]):
                sequence = [values[index] for values in by_range]
                # The error changes its sign on the way, so that no power of the range fits: the finest one, and the three last changes.
                value = sequence[-1]
                error = SAFETY * max(abs(after - before) for before, after in zip(sequence[-4:], sequence[-3:])) + max(one[index] for one in errors[-2:])
                print(f"{peer:9} {case:7} {quantity:15} {value:.8f} +- {error:.1e}   by range", " ".join(f"{one:.7f}" for one in sequence),
                      "  mesh", " ".join(f"{one[index]:.1e}" for one in errors), flush=True)
                yield row(error, peer=peer, case=case, reduced_work=repr(work), penetration=repr(penetration), quantity=quantity, position=position, value=digits(value))


if __name__ == "__main__":
    logging.disable(logging.WARNING)
    peers = sys.argv[1:] or ["Tamaas", "Adhesion"]
    found = list(rows(peers))
    if len(peers) == 2:
        write("peers_adhesive_wave.csv", "an elastic adhesive wave in the limit of no range, by two other programs; position in half periods from the crest", COLUMNS, found,
              "meshes refined per range and extrapolated, ranges of the attraction down to 0.025 (Tamaas) and 0.05 (Adhesion) of the amplitude; `error` from the changes of both", ["tamaas", "Adhesion", "ContactMechanics"],
              "adhesive_wave.py")
