"""Checks of this program by routes that share less with the solver: `python3 verification/references/ting_graham.py --self-check`.

- Two cycles and a reload against a superposition of R at the instants of a grid. It uses no exponential: every step adds R(t - t') times what W changed,
  and three grids are extrapolated (Richardson).
- The maps between relaxation and creep states of random series against the identity.
- Histories of the penetration against the quadratures of `adhesiveless.csv`, which follow no place and keep no state.
"""

import time

import numpy as np

from adhesiveless import CASES
from common import finish, read
from ting_graham_contact import Contact
from ting_graham_history import History
from ting_graham_shapes import cone, power_law, sphere
from ting_graham_solid import Solid


def superposed(solid, shape, ways, steps, places):
    """Force at the end of straight ways (depth, duration) by superposition: W of each place is linear in each step, q = sum of int R over the step times its slope.

    The memory is the whole past, R is asked for by its values alone (its integral over a step by Gauss's rule)."""
    depths, times = [0.0], [0.0]
    for depth, duration in ways:
        first, start = depths[-1], times[-1]
        for k in range(1, steps + 1):
            depths.append(first + (depth - first) * k / steps)
            times.append(start + duration * k / steps)
    depths, times = np.array(depths), np.array(times)
    x, w = np.polynomial.legendre.leggauss(places)
    radius = float(shape.radius(np.array(np.max(depths))))
    s = 0.5 * radius * (1.0 + x)
    h = shape.line(s)
    node, weight = np.polynomial.legendre.leggauss(6)
    displaced = np.zeros((len(times), places))
    load = np.zeros(places)
    changes = np.zeros((len(times) - 1, places))
    for n in range(1, len(times)):
        widths = np.diff(times[: n + 1])
        middle = times[n] - (times[:n, None] + 0.5 * widths[:, None] * (1.0 + node))
        means = 0.5 * solid.relaxation(middle) @ weight
        past = means[:-1] @ changes[: n - 1] if n > 1 else np.zeros(places)
        free = displaced[n - 1] - past / means[-1]
        displaced[n] = np.maximum(depths[n] - h, free)
        changes[n - 1] = displaced[n] - displaced[n - 1]
        load = past + means[-1] * changes[n - 1]
    return 2.0 * float((0.5 * radius * w) @ np.maximum(load, 0.0))


def self_check():
    start, wrong = time.time(), []
    # Two cycles and a reload of a solid of two terms in SI units, and of one in reduced ones: no exponential on the other side.
    cases = [(Solid(1.5e9 / 0.8556, [7e8 / 0.8556, 5e8 / 0.8556], [1.0, 0.1]), sphere(1e-2), [(1e-5, 1.0), (5e-6, 1.0), (1e-5, 1.0), (5e-6, 1.0), (1.2e-5, 1.0)]),
             (Solid(1.0, [3.0], [2.0]), cone(0.1), [(0.01, 1.0), (0.004, 0.3), (0.012, 0.5)])]
    for solid, shape, ways in cases:
        contact = Contact(solid, shape)
        for depth, duration in ways:
            contact.corner()
            contact.straight(depth, duration)
        mine = float(contact.forces([len(ways) - 1], [ways[-1][1]])[0][0])
        coarse, middle, fine = (superposed(solid, shape, ways, steps, 400) for steps in (20, 40, 80))
        best = fine + (fine - middle) / 3.0
        allowed = 4.0 * abs(best - (middle + (middle - coarse) / 3.0)) + 1e-5 * abs(best)
        print(f"superposition {best:.10g}, this program {mine:.10g}, apart {abs(mine / best - 1.0):.1e}")
        if abs(mine - best) > allowed:
            wrong.append(f"superposition gives {best}, this program {mine}")
    # State maps of random series are inverse to each other.
    random = np.random.default_rng(5)
    for trial in range(60):
        count = int(random.integers(1, 13))
        solid = Solid(float(random.integers(0, 2)), random.uniform(0.1, 30.0, count), 10.0 ** np.sort(random.uniform(-5.0, 5.0, count)))
        defect = np.abs((solid.rates[:, None] / solid.gap) @ solid.to_voigt - np.eye(count)).max()
        if defect > 1e-11:
            wrong.append(f"the state maps of {count} terms are inverse to {defect:.1e} only")
    # Quadratures over the history.
    cases = {}
    for row in read("adhesiveless.csv"):
        cases.setdefault(row["case"], []).append(row)
    for name, case in CASES.items():
        one = 1.0 - case.solid["ratio"] ** 2
        solid = Solid(case.solid["relaxed"] / one, [e / one for e, _ in case.solid["terms"]], [1.0 / rho for _, rho in case.solid["terms"]])
        shape = cone(case.shape["slope"]) if "slope" in case.shape else power_law(case.shape["radius"], float(case.shape["exponent"]))
        history = History(solid, shape)
        history.begin("penetration", 0.0, False)
        here = 0.0
        for depth, duration in case.ways:
            here = here if depth is None else depth
            history.ramp("penetration", here, duration)
        for row in cases[name]:
            right, scale = float(row["value"]), float(row["scale"])
            if row["quantity"] == "detachment_time":
                found = [history.time_of(e[1], e[2]) for e in history.contact.events if e[0] == "detachment"][0]
            else:
                depth, force, radius, _, _ = history.values([history.at_time(float(row["time"]))])
                found = float(force[0] if row["quantity"] == "force" else radius[0])
            if abs(found - right) > 1e-11 * scale:
                wrong.append(f"{name} {row['quantity']} at {row['time']}: {found!r}, by quadrature {right!r}")
    finish(wrong, start, "self-check")
