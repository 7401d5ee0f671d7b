"""Flat and round punches pulled off by their rim, on the raw closure (thesis 4.9) by plain quadrature; writes or checks punch_rim.csv.

Independent of the solver: no kernel series, no panels, no polynomial path. An edge that only recedes from the rim leaves every place inside bonded since time zero,
so that the line load is one number Q(t) of the history of the penetration alone, from an initial-value problem (SciPy's solve_ivp). Then
    tension(r) = -Q/(pi sqrt(c^2 - r^2)),   gap(r) = (2/pi) int_c^r D(s)/sqrt(r^2 - s^2) ds,   (1/2 delta) int tension(c - d) gap(c + delta - d) dd = work
with the strains of a place decayed from the instant at which the edge passed it (c < s < a), and beyond the rim D of one chain that is pressed, but not held, by
the face (theory notes, section 9). The edge goes by parts of the process zone, the instant of each from the closure by bracketing.
A round face s^2/sphere (empty: flat) that starts relaxed, all of it in contact, adds what never changes: a load -E0 s^2/sphere of the line, the pressure
(2 E0/(pi sphere)) sqrt(c^2 - r^2), and strains -J_j E0 s^2/sphere of a place; the chain beyond the rim meets its face at the height of the rim.

zone_law  constant: delta = zone; growing: delta = zone K^2/(2 relaxed work), K^2 = Q^2/(pi c).
law       empty, or speed;exponent: the work is multiplied by 1 + (|dc/dt|/speed)^exponent.
path      penetration,duration; ... from `start` (relaxed at the first penetration, or untouched and at once there).
quantities  let_go_time, let_go_force (the edge leaves the rim), pull_off (largest tension), edge_at_pull_off.
`change` is the relative change when the steps of the edge are doubled. Forces are tension. Double precision; needs numpy and scipy.
"""

import sys

sys.dont_write_bytecode = True

import math
import time as clock

from common import arguments, double, finish, read, write

COMMAND = "python3 verification/references/punch_rim.py"
FILE = "punch_rim.csv"
COLUMNS = ["case", "material", "radius", "work", "zone", "sphere", "zone_law", "law", "start", "path", "quantity", "value", "change", "independence"]
STEPS = 60          # of the edge per process zone

# glassy modulus; J_j, tau_j
ONE = (10.0, ((0.9, 1.0),))
SOFT = (7.5, ((4.0 / 15.0, 2.0),))                       # relaxed 2.5, beta 3
HARD = (100.0, ((0.99, 1.0),))
TWO = (20.0, ((0.5, 4.0), (0.45, 0.3)))
THREE = (10.0, ((0.3, 0.1), (0.3, 1.0), (0.3, 10.0)))
RUBBER = (1.3333333333333333e7, ((6.75e-7, 0.1),))       # E0* = 4/3 MPa, beta 10


def numpy():
    try:
        import numpy as np
        import scipy
        from scipy.integrate import solve_ivp
        from scipy.optimize import brentq
    except ImportError:
        sys.exit("punch_rim.py needs numpy and scipy (Debian: apt-get install python3-numpy python3-scipy)")
    return np, solve_ivp, brentq, f"numpy {np.__version__}, scipy {scipy.__version__}, generator version 1.0.0"


class History:
    """Penetration, and the strains of a place that stays bonded and of the chain beyond the rim."""

    def __init__(self, material, start, path, radius, sphere):
        self.np, self.solve_ivp, _, _ = numpy()
        np = self.np
        self.glassy, terms = material
        self.j = np.array([t[0] for t in terms])
        self.tau = np.array([t[1] for t in terms])
        self.relaxed = 1.0 / (1.0 / self.glassy + self.j.sum())
        self.ends, self.depths = [0.0], [path[0][0]]
        for depth, duration in path[1:]:
            self.ends.append(self.ends[-1] + duration)
            self.depths.append(depth)
        first, self.curvature = path[0][0], 1.0 / sphere if sphere else 0.0
        held = self.j * self.relaxed if start == "relaxed" else 0.0 * self.j
        self.height = 0.0
        self.bonded = self.chain(held * first, False)
        self.height = self.face(radius)
        self.ghost = self.chain(held * max(first - self.height, 0.0), True)

    def face(self, s):
        return self.curvature * s * s

    def depth(self, t):
        return float(self.np.interp(t, self.ends, self.depths))

    def chain(self, strains, one_sided):
        """Dense solutions from kink to kink; a face that does not hold lets go and meets again at zeros of its load."""
        pieces = []
        for begin, end in zip(self.ends[:-1], self.ends[1:]):
            now = begin
            while now < end:
                def load(t, e):
                    return self.glassy * (self.depth(t) - self.height - e.sum())

                free = one_sided and (load(now, strains) < 0.0 or (abs(load(now, strains)) < 1e-12 * self.glassy and self.opening_next(now, strains)))

                def rate(t, e, free=free):
                    return (self.j * (0.0 if free else load(t, e)) - e) / self.tau

                def changes(t, e):
                    return load(t, e)

                changes.terminal = one_sided
                changes.direction = 1.0 if free else -1.0
                found = self.solve_ivp(rate, (now, end), strains, method="DOP853", rtol=1e-11, atol=1e-14, dense_output=True, events=changes)
                stop = found.t[-1]
                pieces.append((now, stop, found.sol, free))
                strains = found.y[:, -1]
                if stop >= end or stop <= now:
                    break
                now = stop
        return pieces

    def opening_next(self, t, e):
        step = 1e-9 * (self.ends[-1] - self.ends[0])
        return self.depth(t + step) - self.height - (e - step * e / self.tau).sum() < 0.0

    def strains(self, chain, t):
        for begin, end, sol, free in chain:
            if t <= end:
                return sol(min(max(t, begin), end)), free
        return chain[-1][2](chain[-1][1]), chain[-1][3]

    def load(self, t, c):
        """Q at a place, or at the edge."""
        return self.glassy * (self.depth(t) - float(self.strains(self.bonded, t)[0].sum())) - self.relaxed * self.face(c)

    def strain(self, t, s):
        """Of a place that is bonded yet."""
        return self.strains(self.bonded, t)[0] - self.j * self.relaxed * self.face(s)

    def force(self, t, c):
        """Tension."""
        return -2.0 * c * (self.load(t, 0.0) - self.relaxed * self.face(c) / 3.0)

    def opening(self, t):
        e, free = self.strains(self.ghost, t)
        return max(0.0, float(e.sum()) - self.depth(t) + self.height) if free else 0.0


def pulled(case, steps):
    np, _, brentq, _ = numpy()
    history = History(case["material"], case["start"], case["path"], case["radius"], case["sphere"])
    a, work, zone = case["radius"], case["work"], case["zone"]
    nodes = np.cos(np.pi * (np.arange(24) + 0.5) / 24)
    h = zone / steps

    def kernel(c, s, delta, load):
        """(1/2 delta)(2/pi) int_s^(c+delta) dr tension(r - delta)/sqrt(r^2 - s^2) by Gauss and Chebyshev, pi tension(r) = -Q/root - 2 E0 root/sphere, root^2 = c^2 - r^2."""
        r = 0.5 * (c + delta + s)[:, None] + 0.5 * (c + delta - s)[:, None] * nodes
        tension = -load - 2.0 * history.relaxed * history.curvature * (c + r - delta) * (c + delta - r)
        inner = tension / np.sqrt((r + s[:, None]) * (c + r - delta))
        return inner.sum(axis=1) * (np.pi / 24) / (np.pi**2 * delta)

    x, weight = np.polynomial.legendre.leggauss(12)
    places, released = [a], []

    def closure(c, t, k):
        load = history.load(t, c)
        if load >= 0.0:
            return -1.0
        delta = zone
        if case["zone_law"] == "growing":
            delta = zone * load * load / (math.pi * c) / (2.0 * history.relaxed * work)
            if delta < 1e-4 * zone:
                return -1.0
        total = 0.0
        far = c + delta
        if k > 0:
            # Places passed so far, the present one now; those beyond the zone do not count.
            s = np.array(places[: k + 1])[::-1]
            e = np.array([history.strain(t, c)] + released[::-1])
            then = np.array([t] + times[::-1])
            every = (e * np.exp(-(t - then)[:, None] / history.tau)).sum(axis=1) - history.depth(t) + history.face(s)
            last = np.interp(far, s, every)
            s, gap = s[s <= far], every[: (s <= far).sum()]
            if far < a:
                s, gap = np.append(s, far * (1.0 - 1e-15)), np.append(gap, last)
            values = gap * kernel(c, s, delta, load)
            total += float((0.5 * (values[1:] + values[:-1]) * np.diff(s)).sum())
        if far > a:
            s = 0.5 * (far + a) + 0.5 * (far - a) * x
            total += history.opening(t) * float((weight * kernel(c, s, delta, load)).sum()) * 0.5 * (far - a)
        return total / work

    times = []

    def excess(c, t, k):
        level = 1.0
        if case["law"] and k > 0:
            speed, exponent = case["law"]
            level += ((places[k - 1] - c) / (t - times[-1]) / speed) ** exponent if t > times[-1] else math.inf
        return closure(c, t, k) / level - 1.0

    end = history.ends[-1]
    # The first instant at which the rim lets go: looked for in small parts of the history.
    grid = np.unique(np.concatenate([np.linspace(b, e, 400) for b, e in zip(history.ends[:-1], history.ends[1:])]))
    before = grid[0]
    let_go = None
    for t in grid[1:]:
        if excess(a, t, 0) > 0.0:
            let_go = brentq(lambda t: excess(a, t, 0), before, t, xtol=1e-15 * end, rtol=1e-13)
            break
        before = t
    assert let_go is not None, case["case"]
    times.append(let_go)
    released.append(history.strain(let_go, a))
    forces = [(history.force(let_go, a), a)]
    k, last = 0, 1e-3 * let_go
    while True:
        k += 1
        c = a - k * h
        places.append(c)
        if c < 3.0 * zone or (excess(c, times[-1], k) >= 0.0):
            break
        low, step = times[-1], last
        while low + step < end and excess(c, low + step, k) < 0.0:
            low, step = low + step, 1.5 * step
        if low + step >= end:
            break
        t = brentq(lambda t: excess(c, t, k), low, low + step, xtol=1e-15 * end, rtol=1e-13)
        last = max(0.5 * (t - times[-1]), 1e-9 * t)
        times.append(t)
        released.append(history.strain(t, c))
        forces.append((history.force(t, c), c))
        if len(forces) > 20 and forces[-1][0] < 0.97 * max(f[0] for f in forces):
            break
    best = max(range(len(forces)), key=lambda i: forces[i][0])
    return {"let_go_time": let_go, "let_go_force": forces[0][0], "pull_off": forces[best][0], "edge_at_pull_off": forces[best][1]}


def cases():
    root = math.sqrt(2.0 * math.pi)

    def reduced(name, material, preload, end, duration, zone, zone_law="constant", law=None, start="relaxed", between=(), sphere=None):
        path = [(preload * root, 0.0), *((d * root, t) for d, t in between), (end * root, duration)]
        return {"case": name, "material": material, "radius": 1.0, "work": 1.0, "zone": zone, "sphere": sphere, "zone_law": zone_law, "law": law,
                "start": start, "path": path}

    return [
        reduced("beta 10, zone 0.01", ONE, 5.0, -6.0, 9.19, 0.01),
        reduced("beta 10, growing", ONE, 5.0, -6.0, 30.0, 0.01, "growing"),
        reduced("beta 3", SOFT, 2.0, -4.0, 12.0, 0.01),
        reduced("beta 100", HARD, 1.0, -8.0, 40.0, 0.01),
        reduced("two terms", TWO, 3.0, -6.0, 6.0, 0.005),
        reduced("three terms", THREE, 0.5, -6.0, 20.0, 0.005, "growing"),
        reduced("pressed shortly before", ONE, 0.0, -6.0, 9.0, 0.01, start="untouched", between=((2.0, 0.3),)),
        reduced("pressed and held", TWO, 0.0, -6.0, 7.0, 0.01, start="untouched", between=((1.0, 0.1), (1.0, 2.0))),
        reduced("pulled, pushed, pulled", ONE, 1.0, -6.0, 9.0, 0.01, between=((0.8, 0.02), (1.0, 0.02))),
        reduced("work by speed", ONE, 2.0, -9.0, 20.0, 0.01, law=(0.02, 0.5)),
        reduced("work by speed, growing", TWO, 1.0, -9.0, 40.0, 0.01, "growing", law=(0.05, 1.0)),
        {"case": "rubber", "material": RUBBER, "radius": 1e-4, "work": 0.05, "zone": 1e-6, "sphere": None, "zone_law": "constant", "law": None,
         "start": "relaxed", "path": [(3e-6, 0.0), (-2e-5, 2.0)]},
        reduced("round face, beta 10", ONE, 1.0, -6.0, 9.0, 0.01, sphere=3.0),
        reduced("steep face, two terms", TWO, 3.0, -6.0, 6.0, 0.005, sphere=0.4),
        reduced("round face, pulled, pushed, pulled", ONE, 1.0, -6.0, 9.0, 0.01, between=((0.9, 0.02), (1.2, 0.02)), sphere=2.0),
        reduced("round face, work by speed", SOFT, 2.0, -9.0, 20.0, 0.01, law=(0.02, 0.5), sphere=1.5),
        {"case": "round face of rubber", "material": RUBBER, "radius": 1e-4, "work": 0.05, "zone": 1e-6, "sphere": 2e-3, "zone_law": "constant", "law": None,
         "start": "relaxed", "path": [(8e-6, 0.0), (-2e-5, 2.0)]},
    ]


def rows(reduced):
    out = []
    for case in cases()[:2] if reduced else cases():
        fine, coarse = pulled(case, STEPS), pulled(case, STEPS // 2)
        glassy, terms = case["material"]
        for quantity, value in fine.items():
            out.append({
                "case": case["case"],
                "material": ";".join([double(glassy)] + [f"{double(j)},{double(tau)}" for j, tau in terms]),
                "radius": double(case["radius"]), "work": double(case["work"]), "zone": double(case["zone"]), "sphere": double(case["sphere"]) if case["sphere"] else "",
                "zone_law": case["zone_law"],
                "law": ";".join(map(double, case["law"])) if case["law"] else "", "start": case["start"],
                "path": ";".join(f"{double(d)},{double(t)}" for d, t in case["path"]),
                "quantity": quantity, "value": double(value), "change": f"{abs(coarse[quantity] / value - 1.0):.1e}",
                "independence": "independent",
            })
    return out


def self_check():
    """Kendall: an elastic punch lets go at sqrt(8 pi E work a^3) as the zone vanishes, and that is its pull-off."""
    case = {"case": "elastic", "material": (2.0, ((1e-9, 1.0),)), "radius": 1.0, "work": 1.0, "zone": 1e-4, "sphere": None, "zone_law": "constant", "law": None,
            "start": "relaxed", "path": [(0.0, 0.0), (-4.0, 1.0)]}
    found, kendall = pulled(case, 8), math.sqrt(16.0 * math.pi)
    return [] if abs(found["pull_off"] / kendall - 1.0) < 2e-4 else [f"Kendall: {found['pull_off']} instead of {kendall}"]


def main():
    options = arguments("Flat and round punches pulled off by their rim.")
    start = clock.time()
    if options.self_check:
        finish(self_check(), start, "punch_rim.py --self-check")
    fresh = rows(options.check and options.reduced)
    if options.check:
        known = {(r["case"], r["quantity"]): r for r in read(FILE)}
        wrong = [
            f"{FILE}: {r['case']} {r['quantity']}: file {known[r['case'], r['quantity']]['value']}, recomputed {r['value']}"
            for r in fresh
            if abs(float(known[r["case"], r["quantity"]]["value"]) / float(r["value"]) - 1.0) > 1e-7
        ]
        finish(wrong, start, f"punch_rim.py --check of {len(fresh)} rows")
    write(FILE, COMMAND, "flat and round punches pulled off by their rim, raw closure (thesis 4.9) by quadrature", COLUMNS, fresh,
          precision="double precision; change is that of half the steps", tool=numpy()[3])


if __name__ == "__main__":
    main()
