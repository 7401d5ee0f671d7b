"""An elastic sphere whose work of adhesion follows its edge, by an initial-value problem on the raw closure (thesis 4.9); writes or checks edge_speed.csv.

Independent of the solver: pressure and gap of an elastic contact of any radius and depth in closed form (Johnson, Kendall and Roberts),
    p = (E/pi)[(depth - a^2/R)/sqrt(a^2 - r^2) + (2/R) sqrt(a^2 - r^2)],   gap = (2/pi)[depth asin(a/r) - (r^2 asin(a/r) - a sqrt(r^2 - a^2))/(2R)] - depth + r^2/(2R),
    C = (1/2 zone) int_0^zone (-p)(a - d) gap(a + zone - d) dd by Gauss and Legendre in d = zone sin^2;
the edge recedes with C = trailing(v), advances with C = leading(v), v = |da/dt|, and rests between the two at rest.
law       empty: constant; power;speed;exponent: both works times 1 + (v/speed)^exponent; table;v,trailing,leading;...: factors, logarithms linear in ln v.
path      depth,duration; ... from a contact in equilibrium by the leading work at the first depth.
quantities  contact_radius and force at the ends of the rows of the path, and pull_off (largest tension). Double precision (LSODA at 1e-11); needs numpy and scipy.
"""

import sys

sys.dont_write_bytecode = True

import math
import time as clock

from common import arguments, double, finish, read, write

COMMAND = "python3 verification/references/edge_speed.py"
FILE = "edge_speed.csv"
COLUMNS = ["case", "modulus", "radius", "trailing", "leading", "zone", "law", "path", "instant", "quantity", "value", "change", "independence"]


def numpy():
    try:
        import numpy as np
        import scipy
        from scipy.integrate import solve_ivp
        from scipy.optimize import brentq
    except ImportError:
        sys.exit("edge_speed.py needs numpy and scipy (Debian: apt-get install python3-numpy python3-scipy)")
    return np, solve_ivp, brentq, f"numpy {np.__version__}, scipy {scipy.__version__}, generator version 1.0.0"


class Sphere:
    def __init__(self, case, nodes):
        self.np, self.solve_ivp, self.brentq, _ = numpy()
        x, w = self.np.polynomial.legendre.leggauss(nodes)
        angle = 0.25 * math.pi * (x + 1.0)
        self.part = self.np.sin(angle) ** 2
        self.weight = 0.25 * math.pi * w * self.np.sin(2.0 * angle)
        self.case = case

    def closure(self, a, depth):
        np, c = self.np, self.case
        big, zone = c["radius"], c["zone"]
        d = zone * self.part
        inner, outer = a - d, a + (zone - d)
        root = np.sqrt(d * (a + inner))
        tension = -c["modulus"] / math.pi * ((depth - a * a / big) / root + 2.0 / big * root)
        beyond = np.sqrt((zone - d) * (outer + a))
        angle = np.arctan2(a, beyond)
        gap = 2.0 / math.pi * (depth * angle - (outer**2 * angle - a * beyond) / (2.0 * big)) - depth + outer**2 / (2.0 * big)
        value = 0.5 * float((self.weight * tension * gap).sum())
        return -value if depth > a * a / big else value

    def force(self, a, depth):
        return 2.0 * self.case["modulus"] * (a * depth - a**3 / (3.0 * self.case["radius"]))

    def equilibrium(self, work, depth):
        """The larger root of C = work."""
        high = 20.0 * (math.sqrt(max(depth, 0.0) * self.case["radius"]) + (work * self.case["radius"] ** 2 / self.case["modulus"]) ** (1.0 / 3.0))
        low = high
        while self.closure(low, depth) > work:
            low *= 0.97
            if low < 2.0 * self.case["zone"]:
                return None
        return self.brentq(lambda a: self.closure(a, depth) - work, low, low / 0.97, xtol=1e-16 * high, rtol=1e-14)

    def levels(self, v):
        c = self.case
        trailing, leading = c["trailing"], c["leading"]
        law = c["law"]
        if not law:
            return trailing, leading
        if law[0] == "power":
            factor = 1.0 + (v / law[1]) ** law[2]
            return trailing * factor, leading * factor
        speeds = [math.log(e[0]) for e in law[1]]
        at = math.log(v) if v > 0.0 else -math.inf
        by = [math.exp(float(self.np.interp(at, speeds, [math.log(e[k]) for e in law[1]]))) for k in (1, 2)]
        return trailing * by[0], leading * by[1]

    def speed(self, work):
        """da/dt at a closure."""
        law = self.case["law"]
        rest = self.levels(0.0)
        if work > rest[0]:
            if law[0] == "power":
                return -law[1] * (work / self.case["trailing"] - 1.0) ** (1.0 / law[2])
            side, sign = 0, -1.0
        elif work < rest[1] and law[0] == "table":
            side, sign = 1, 1.0
        else:
            return 0.0
        low, high = math.log(law[1][0][0]), math.log(law[1][-1][0])
        fun = lambda x: self.levels(math.exp(x))[side] - work
        if fun(low) * fun(high) > 0.0:
            return sign * math.exp(low if abs(fun(low)) < abs(fun(high)) else high)
        return sign * math.exp(self.brentq(fun, low, high, xtol=1e-13))


def marched(case, nodes, tolerance):
    sphere = Sphere(case, nodes)
    np = sphere.np
    path = case["path"]
    a = sphere.equilibrium(sphere.levels(0.0)[1], path[0][0])
    depth, out, tension = path[0][0], [], -sphere.force(a, path[0][0])
    out.append((a, sphere.force(a, depth)))
    for end, duration in path[1:]:
        at = lambda t, depth=depth, end=end, duration=duration: depth + (end - depth) * t / duration
        if case["law"]:
            def gone(t, y):
                return y[0] - 3.0 * case["zone"]
            gone.terminal = True
            scale = case["radius"]
            found = sphere.solve_ivp(lambda t, y: [sphere.speed(sphere.closure(max(y[0], 2.0 * case["zone"]), at(t)))], (0.0, duration), [a], method="LSODA", rtol=tolerance,
                                     atol=1e-4 * tolerance * scale, events=gone, dense_output=True, max_step=duration / 200)
            fine = np.linspace(0.0, found.t[-1], 40001)
            radii = found.sol(fine)[0]
            forces = np.array([sphere.force(r, at(t)) for r, t in zip(radii, fine)])
            k = int(forces.argmin())
            if 0 < k < len(fine) - 1:
                p, q, r = forces[k - 1:k + 2]
                tension = max(tension, -(q - (p - r) ** 2 / (8.0 * (p - 2.0 * q + r))))
            tension = max(tension, -float(forces.min()))
            a = float(radii[-1]) if found.t[-1] >= duration else 0.0
        else:
            # Rate-independent: the edge rests, opens or closes by constant works.
            for k in range(1, 20001):
                here = at(duration * k / 20000)
                work = sphere.closure(a, here)
                if work > case["trailing"] or work < case["leading"]:
                    moved = sphere.equilibrium(case["trailing"] if work > case["trailing"] else case["leading"], here)
                    if moved is None:
                        a = 0.0
                        break
                    a = moved
                tension = max(tension, -sphere.force(a, here))
        depth = end
        out.append((a, sphere.force(a, depth) if a > 0.0 else 0.0))
        if a == 0.0:
            break
    return out, tension


def cases():
    si = {"modulus": 1e6 / 0.75, "radius": 1e-3, "zone": 1e-7}
    reduced = {"modulus": 3.7, "radius": 2.3, "zone": 2e-3}
    rising = ("table", ((1e-4, 1.0, 1.0), (1e-2, 3.0, 0.6), (1.0, 8.0, 0.3)))
    return [
        {"case": "retraction, root law", "trailing": 0.05, "leading": 0.05, "law": ("power", 1e-5, 0.5), "path": [(2e-6, 0.0), (0.0, 2.0), (-2e-6, 2.0), (-8e-6, 6.0)], **si},
        {"case": "retraction, linear law", "trailing": 0.02, "leading": 0.02, "law": ("power", 0.004, 1.0), "path": [(0.05, 0.0), (-0.02, 7.0), (-0.3, 28.0)], **reduced},
        {"case": "approach and retraction, table", "trailing": 0.02, "leading": 0.02, "law": rising, "path": [(0.02, 0.0), (0.1, 2.0), (0.05, 1.0), (-0.02, 2.0), (-0.5, 15.0)], **reduced},
        {"case": "two works, table", "trailing": 0.02, "leading": 0.005, "law": rising, "path": [(0.02, 0.0), (0.1, 2.0), (0.0, 3.0), (0.04, 1.0), (-0.5, 20.0)], **reduced},
        {"case": "two works", "trailing": 0.05, "leading": 0.005, "law": None, "path": [(0.0, 0.0), (5e-6, 5.0), (3e-6, 2.0), (4e-6, 1.0), (0.0, 4.0), (-2e-5, 20.0)], **si},
    ]


def rows(reduced):
    out = []
    for case in cases()[:1] if reduced else cases():
        fine, coarse = marched(case, 40, 1e-11), marched(case, 24, 1e-9)
        law = case["law"]
        text = "" if not law else f"power;{double(law[1])};{double(law[2])}" if law[0] == "power" else "table;" + ";".join(",".join(map(double, e)) for e in law[1])
        base = {"case": case["case"], **{k: double(case[k]) for k in ("modulus", "radius", "trailing", "leading", "zone")}, "law": text,
                "path": ";".join(f"{double(d)},{double(t)}" for d, t in case["path"]), "independence": "independent"}
        for instant, ((a, f), (a2, f2)) in enumerate(zip(fine[0], coarse[0])):
            for quantity, value, other in (("contact_radius", a, a2), ("force", f, f2)):
                out.append({**base, "instant": instant, "quantity": quantity, "value": double(value), "change": f"{abs(other - value):.1e}"})
        out.append({**base, "instant": "", "quantity": "pull_off", "value": double(fine[1]), "change": f"{abs(coarse[1] - fine[1]):.1e}"})
    return out


def self_check():
    """The closure tends to K^2/2E as the zone vanishes."""
    case = {"modulus": 3.7, "radius": 2.3, "zone": 1e-9, "trailing": 1.0, "leading": 1.0, "law": None}
    sphere, a, depth = Sphere(case, 40), 0.4, 0.01
    intensity = case["modulus"] * (a * a / case["radius"] - depth) / math.sqrt(math.pi * a)
    ratio = sphere.closure(a, depth) / (intensity**2 / (2.0 * case["modulus"]))
    return [] if abs(ratio - 1.0) < 1e-7 else [f"closure over K^2/2E: {ratio}"]


def main():
    options = arguments("An elastic sphere whose work of adhesion follows its edge.")
    start = clock.time()
    if options.self_check:
        finish(self_check(), start, "edge_speed.py --self-check")
    fresh = rows(options.check and options.reduced)
    if options.check:
        known = {(r["case"], r["instant"], r["quantity"]): r for r in read(FILE)}
        wrong = []
        for r in fresh:
            old = known[r["case"], str(r["instant"]), r["quantity"]]
            if abs(float(old["value"]) - float(r["value"])) > 1e-7 * abs(float(r["value"])) + float(old["change"]):
                wrong.append(f"{FILE}: {r['case']} {r['instant']} {r['quantity']}: file {old['value']}, recomputed {r['value']}")
        finish(wrong, start, f"edge_speed.py --check of {len(fresh)} rows")
    write(FILE, COMMAND, "elastic spheres whose work of adhesion follows the edge (thesis 4.9)", COLUMNS, fresh,
          precision="double precision; change is that of looser integration and quadrature", tool=numpy()[3])


if __name__ == "__main__":
    main()
