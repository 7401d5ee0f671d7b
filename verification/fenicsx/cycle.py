#!/usr/bin/python3
"""Adhesive cycles of the solver, as inputs of the finite elements: writes reference_data/fenicsx_cycle.csv. Evidence of nothing by itself.

    verification/harness/build.sh && /usr/bin/python3 verification/fenicsx/cycle.py

Each row: the time and depth at which the solver's edge stands at a node (a sixth of COARSEST apart: nodes of all meshes), so that elements can follow it. The work of
adhesion is that which makes the glassy jump-in end at START. `asked` marks rows that are compared. `force` and `stress_intensity_factor` are the solver's, in closed loop.

depth-driven     jump-in at no depth, down at a speed, rest, up at another speed: where to turn and how long to rest is found so that the edge is at a node then.
edge-driven      jump-in, the edge out at a speed, rest, back, and out again; the depth is what holds the balance.
"""

import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(os.path.dirname(HERE), "references"), os.path.join(os.path.dirname(HERE), "crosscheck")]

import numpy as np
from scipy.interpolate import CubicSpline

import tools
from cases import COARSEST, ELASTIC_BULK, ONE, ZONE
from common import double, write
from maxwell import creep_of_half_space

WIDTH = COARSEST / 6.0
START = 0.072
TOLERANCE = 1e-8
RESTS = 16      # rows of a rest, in which the depth is no straight line
COLUMNS = ["case", "solid", "work", "zone", "time", "radius", "penetration", "duration", "asked", "force", "stress_intensity_factor", "independence"]


def material(harness, solid):
    glassy, terms = creep_of_half_space(solid)
    return harness.Material.from_creep(glassy, [j for j, _ in terms], [tau for _, tau in terms])


def work_of_start(harness, solid):
    """The closure of the glassy contact at START and no depth."""
    out = harness.prescribed_contact(material(harness, solid), "paraboloid", [1.0], "untouched", START, 0.0, [START, 0.0, 0.0], [], process_zone=ZONE)
    return float(out["zone_work"][0])


def nodes(first, last):
    """Radii of nodes passed, without the first."""
    count = int(round(abs(last - first) / WIDTH))
    return [first + (last - first) * k / count for k in range(1, count + 1)]


def crossing(grid, values, wanted):
    """Where a rising curve takes a value."""
    order = np.argsort(grid)
    grid, values = np.asarray(grid)[order], np.asarray(values)[order]
    keep = np.concatenate([[True], np.diff(values) > 0.0])
    return float(CubicSpline(values[keep], grid[keep])(wanted))


def depth_driven(harness, down, up, turn, rested, last):
    solid, work = ONE, work_of_start(harness, ONE)
    stone = material(harness, solid)

    def run(segments):
        return harness.indentation(stone, "paraboloid", [1.0], "untouched", "penetration", 0.0, segments, work_of_adhesion=work, process_zone=ZONE, tolerance=TOLERANCE)

    first = run([("penetration", 0.08, 0.08 / down)])
    turned = crossing(first["penetration"][1:], first["contact_radius"][1:], turn)
    descent = ("penetration", turned, turned / down)
    held = run([descent, ("penetration", turned, 60.0)])
    after = held["time"] >= descent[2]
    ended = crossing(held["time"][after], held["contact_radius"][after], rested)
    rest = ("penetration", turned, ended - descent[2])
    whole = run([descent, rest, ("penetration", turned - 0.08, 0.08 / up)])
    time, radius, force = (np.asarray(whole[k]) for k in ("time", "contact_radius", "force"))
    depth = np.asarray(whole["penetration"])
    rows = [(0.0, START, 0.0)]
    spans = ((0.0, descent[2], START, turn), (descent[2], ended, turn, rested), (ended, time[-1], rested, last))
    for begin, end, low, high in spans:
        own = (time >= begin - 1e-12) & (time <= end + 1e-12)
        t, a, d = time[own], radius[own], depth[own]
        if high < low:
            # The edge may still go out for a moment: from its last maximum on.
            peak = int(np.argmax(a))
            t, a = t[peak:], -a[peak:]
            low, high = -low, -high
        keep = np.concatenate([[True], np.diff(a) > 1e-13])
        curve = CubicSpline(a[keep], t[keep])
        for place in nodes(low, high):
            at = float(curve(place)) if abs(place - high) > 1e-9 or high < 0 else end
            rows.append((at, abs(place), float(np.interp(at, time, depth))))
    return "cycle, depth-driven", solid, work, rows, {row[0]: float(np.interp(row[0], time, force)) for row in rows}, {}


def edge_driven(harness, turns):
    solid, work = ELASTIC_BULK, work_of_start(harness, ELASTIC_BULK)
    segments, at, rows = [], START, [(0.0, START)]
    for radius, duration in turns:
        path = nodes(at, radius) if radius != at else [radius] * RESTS
        for place in path:
            segments.append(("contact_radius", place, duration / len(path)))
            rows.append((rows[-1][0] + duration / len(path), place))
        at = radius
    found = harness.indentation(material(harness, solid), "paraboloid", [1.0], "untouched", "contact_radius", START, segments, work_of_adhesion=work,
                                process_zone=ZONE, accuracy=1e-7)
    assert found["reached"] and len(found["time"]) == len(rows), (len(found["time"]), len(rows), found["events"])
    depth = [float(d) for d in found["penetration"]]
    rows = [(t, a, d) for (t, a), d in zip(rows, depth)]
    forces = {row[0]: float(f) for row, f in zip(rows, found["force"])}
    return "cycle, edge-driven, elastic bulk", solid, work, rows, forces, {row[0]: float(k) for row, k in zip(rows, found["stress_intensity_factor"])}


def table(case, asked):
    name, solid, work, rows, forces, intensities = case
    before = 0.0
    for index, (time, radius, penetration) in enumerate(rows):
        # The last row of a rest.
        resting = index + 1 < len(rows) and rows[index + 1][1] == radius and index and rows[index - 1][1] == radius
        yield {"case": name, "solid": solid.name, "work": double(work), "zone": double(ZONE), "time": double(time), "radius": double(round(radius, 12)),
               "penetration": double(penetration), "duration": double(time - before), "asked": int(not resting and asked(index, radius)), "force": double(forces[time]),
               "stress_intensity_factor": double(intensities[time]) if time in intensities else "", "independence": "fallback"}
        before = time


def main():
    harness = tools.harness()
    first = depth_driven(harness, 0.03, 0.02, 0.168, 0.18, 0.12)
    second = edge_driven(harness, ((0.18, 1.2), (0.18, 0.5), (0.12, 0.8), (0.16, 0.8)))
    rows = []
    for case, corners in ((first, (0.12, 0.168, 0.18, 0.16, 0.14, 0.12)), (second, (0.12, 0.18, 0.16, 0.12))):
        rows += table(case, lambda index, radius, corners=corners: index > 0 and any(abs(radius - c) < 1e-9 for c in corners))
    write("fenicsx_cycle.csv", "/usr/bin/python3 verification/fenicsx/cycle.py", "adhesive cycles of the solver, imposed on finite elements; inputs", COLUMNS, rows,
          precision="double, integrations at 1e-8", tool="viscotack harness")


if __name__ == "__main__":
    main()
