#!/usr/bin/python3
"""A viscoelastic half-space in finite elements under a rigid sphere or punch; writes or checks reference_data/fenicsx.csv.

    /usr/bin/python3 verification/fenicsx/run.py [--check [--reduced]]        Debian's python3-dolfinx

Independent of the solver: the body is meshed, its memory is kept in the bulk, its edges are nodes. Nothing is reduced to a line or to a surface kernel.
mesh.py, maxwell.py, halfspace.py, contact.py, edge.py and j_integral.py say how; cases.py says what.

kind prescribed, cycle   radius and depth go linearly from row to row of `path` (radius,depth,duration); `instant` is the row at whose end a value is taken. A cycle
                         is the solver's own history of an adhesive contact (fenicsx_cycle.csv). Quantities: force; stress_intensity_factor (energy difference of the
                         body with frozen memory; none where the edge creeps by less than an element in a relaxation time); zone_work (the closure over `zone`); displacement of the surface at radius `place`. Three
                         meshes, elements and steps a half and a third of the coarsest: value by the parabola in h (errors go with h and h^2); `change`: what the
                         straight line through the finer two says less, over the scale.
kind punch               pressed at once, held; `instant` counts the times in `path`. Mesh graded to the edge, degree 4, last element 1e-4 of the radius; steps per
                         octave of time halved twice, value extrapolated from order 2. `by_mesh`: coarser meshes at the finest steps.
kind elastic             sphere at rest, elastic: force; energy_release_rate by energy difference (four other radii, each on its own graded mesh) and by J on rings
                         (`place`: the method; inner and outer over the radius). Degrees 2, 3, 4; value: degree 4.
kind increment           a fixed edge, drawn in a time, then at once: K before and after the glassy increment by energy differences, and K of the increment, an
                         elastic field, by J. Meshes and extrapolation as for `prescribed`.
`material` is what the solver takes: glassy E*; J_j,tau_j of 1/E*. `by_mesh` holds raw values, coarsest first; `scale` the largest magnitude of the quantity
in its case. Double precision.
"""

import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(os.path.dirname(HERE), "references")]

import math
import time as clock

from common import arguments, double, finish, read, write

COMMAND = "/usr/bin/python3 verification/fenicsx/run.py"
FILE, CYCLES = "fenicsx.csv", "fenicsx_cycle.csv"
COLUMNS = ["kind", "case", "solid", "poisson", "material", "shape", "size", "start", "path", "zone", "instant", "quantity", "place", "value", "scale", "change",
           "by_mesh", "by_step", "confirmed_digits", "independence"]
REFINEMENTS = (1, 2, 3)
STEPS = (4, 8, 16)
# Raw values are recomputed to this of their scale: another machine, another order of sums.
SAME = 1e-7


def modules():
    try:
        import dolfinx
    except ImportError:
        sys.exit("run.py needs dolfinx (Debian: apt-get install python3-dolfinx)")
    import cases
    import integration
    return cases, integration, f"dolfinx {dolfinx.__version__}, generator version 1.0.0"


def material_text(solid):
    from maxwell import creep_of_half_space
    glassy, terms = creep_of_half_space(solid)
    return ";".join([double(glassy)] + [f"{double(j)},{double(tau)}" for j, tau in terms])


def poisson_text(solid):
    from maxwell import poisson
    return f"{poisson(*solid.glassy):.6g} to {poisson(solid.bulk, solid.shear):.6g}"


def path_text(rows):
    return ";".join(",".join(double(x) for x in row) for row in rows)


def cycles(cases):
    """The adhesive cycles of fenicsx_cycle.csv."""
    out = {}
    for row in read(CYCLES):
        out.setdefault(row["case"], []).append(row)
    for name, rows in out.items():
        path = tuple((float(r["radius"]), float(r["penetration"]), float(r["duration"])) for r in rows)
        asked = tuple(k for k, r in enumerate(rows) if r["asked"] == "1")
        yield cases.History("cycle", name, cases.SOLIDS[rows[0]["solid"]], "untouched", path, asked, resting=1)


def in_space(raw):
    """(value, change) of three meshes, widths 1, 1/2, 1/3: the parabola through them at none, and how far the straight line through the finer two is from it."""
    value = 0.5 * raw[0] - 4.0 * raw[1] + 4.5 * raw[2]
    return value, abs(value - (3.0 * raw[2] - 2.0 * raw[1]))


def in_time(raw):
    first, second = (4.0 * raw[1] - raw[0]) / 3.0, (4.0 * raw[2] - raw[1]) / 3.0
    return second, abs(second - first)


def row_of(common, value, change, raw, scale, **more):
    change /= scale
    digits = max(0, min(15, int(-math.log10(max(change, 1e-15)))))
    return {**common, **more, "value": f"{value:.12e}", "scale": f"{scale:.3e}", "change": f"{change:.1e}", "by_mesh": " ".join(f"{v:.9e}" for v in raw),
            "confirmed_digits": digits}


def rows_of_meshes(common, meshes):
    """Rows of three meshes, {(instant, quantity, place): value} each."""
    largest = {}
    for key, value in meshes[-1].items():
        largest[key[1]] = max(largest.get(key[1], 0.0), abs(value))
    for key in meshes[-1]:
        raw = [mesh[key] for mesh in meshes]
        yield row_of(common, *in_space(raw), raw, largest[key[1]], instant=key[0], quantity=key[1], place=key[2])


def common_of(kind, name, solid, start, path, zone, shape="paraboloid", size=1.0):
    return {"kind": kind, "case": name, "solid": solid.name, "poisson": poisson_text(solid), "material": material_text(solid), "shape": shape,
            "size": double(size), "start": start, "path": path_text(path), "zone": double(zone) if zone else ""}


def of_histories(cases, integration):
    for case in [*cases.histories(), *cycles(cases)]:
        begun = clock.time()
        meshes = [integration.history(case, refinement) for refinement in REFINEMENTS]
        print(f"{case.name}: {clock.time() - begun:.1f} s", flush=True)
        yield from rows_of_meshes(common_of(case.kind, case.name, case.solid, case.start, case.path, case.zone), meshes)


def of_punches(cases, integration):
    radius, depth = cases.PUNCH_RADIUS, cases.PUNCH_DEPTH
    for name, solid in cases.punches():
        steps = []
        body, candidates = integration.graded_body(solid, radius, *integration.PUNCH)
        for count in STEPS:
            steps.append(integration.punch(solid, body, candidates, count))
        coarse = [integration.punch(solid, *integration.graded_body(solid, radius, *mesh), STEPS[-1]) for mesh in ((1e-3, 2.0, 2), (1e-4, 2.0, 3))]
        path = [(radius, depth, 0.0)] + [(radius, depth, b - a) for a, b in zip((0.0, *cases.PUNCH_TIMES), cases.PUNCH_TIMES)]
        common = common_of("punch", name, solid, "untouched", path, None, "flat_punch", radius)
        largest = {}
        for key, value in steps[-1].items():
            largest[key[1]] = max(largest.get(key[1], 0.0), abs(value))
        for key in steps[-1]:
            by_step, finest = [s[key] for s in steps], largest[key[1]]
            value, change = in_time(by_step)
            raw = [mesh[key] for mesh in (*coarse, steps[-1])]
            # What the mesh leaves is no more than what the next coarser one does.
            change = max(change, abs(raw[2] - raw[1]) * 0.1)
            yield row_of(common, value, change, raw, finest, instant=key[0], quantity=key[1], place=key[2], by_step=" ".join(f"{v:.9e}" for v in by_step))
        print(name, flush=True)


def of_edges(cases, integration):
    fineness = ((1e-4, 1.5, 2), (1e-4, 1.5, 3), (integration.SMALL, integration.SMALL_RATIO, integration.SMALL_DEGREE))
    for name, solid, radius, penetration in cases.states():
        found = [integration.elastic_state(solid, radius, penetration, *mesh) for mesh in fineness]
        yield from methods(common_of("elastic", name, solid, "untouched", [(radius, penetration, 0.0)], None), found, lambda raw: (raw[2], abs(raw[2] - raw[1])))
    for name, solid, radius, drawn, size in cases.increments():
        found = [integration.increment(solid, radius, drawn, size, refinement) for refinement in REFINEMENTS]
        path = [(radius, drawn[0], 0.0), (radius, drawn[1], drawn[2]), (radius, drawn[1] + size, 0.0)]
        yield from methods(common_of("increment", name, solid, "relaxed", path, None), found, in_space)
    print("edges", flush=True)


def methods(common, found, limit):
    for method, quantity in found[-1]:
        raw = [f[method, quantity] for f in found]
        value, change = limit(raw)
        yield row_of(common, value, change, raw, abs(value), instant=len(common["path"].split(";")) - 1, quantity=quantity, place=method)


def compare(stored, fresh, keys):
    """Raw values of the meshes that both have, to SAME of their scale."""
    known = {tuple(row[k] for k in keys): row for row in stored}
    wrong = []
    for row in fresh:
        key = tuple(str(row[k]) for k in keys)
        if key not in known:
            wrong.append(f"{FILE}: {key} is not in the file")
            continue
        old = known[key]
        for column in ("by_mesh", "by_step"):
            pairs = zip(str(old.get(column) or "").split(), str(row.get(column) or "").split())
            wrong += [f"{FILE}: {key} {column}: file {a}, recomputed {b}" for a, b in pairs if not abs(float(a) - float(b)) <= SAME * float(old["scale"])]
    return wrong


def reduced(cases, integration):
    """Two meshes of two histories, raw values only."""
    for case in cases.histories():
        if case.name in cases.REDUCED:
            meshes = [integration.history(case, refinement) for refinement in REFINEMENTS[:2]]
            for key in meshes[-1]:
                yield {"kind": case.kind, "case": case.name, "instant": key[0], "quantity": key[1], "place": key[2],
                       "by_mesh": " ".join(f"{mesh[key]:.9e}" for mesh in meshes)}


def main():
    options = arguments(__doc__.splitlines()[0])
    start = clock.time()
    cases, integration, tool = modules()
    keys = ["kind", "case", "instant", "quantity", "place"]
    if options.reduced:
        finish(compare(read(FILE), list(reduced(cases, integration)), keys), start, "fenicsx, reduced")
    rows = [*of_histories(cases, integration), *of_punches(cases, integration), *of_edges(cases, integration)]
    if options.check:
        finish(compare(read(FILE), rows, keys), start, "fenicsx")
    write(FILE, COMMAND, "viscoelastic half-space in finite elements; columns in the opening of the script", COLUMNS, rows,
          precision="double; meshes and steps extrapolated", tool=tool)
    print(f"{clock.time() - start:.0f} s")


if __name__ == "__main__":
    main()
