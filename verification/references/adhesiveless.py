"""Indentation without adhesion, textbook cases by quadrature; writes or checks adhesiveless.csv.

With H(a) = 2 (a f(a) - int_0^a f) the elastic force over the modulus, f the line profile (s^2/R of a sphere, (pi/2) s slope of a cone, c s^m of a power):
    advancing over fresh surface    f(a) = D,  F = int R(t - t') dH(a(t'))           Lee & Radok, J. Appl. Mech. 27 (1960) 438
    under a force                   H(a) = int J(t - t') dF
    receding                        int_{t1}^t R(t - t') dD = 0, a(t) = a(t1), F = int_0^{t1} R(t - t') dH(a(t'))   Ting, J. Appl. Mech. 33 (1966) 845
    detachment                      t1 = 0
    after a hold, advancing again   Lee & Radok's integral goes on: the surface outside is fresh
int R(t - t') dH by Gauss panels over the history, R by its values; int R dD closed on each straight way; t1 by bisection and secants. No place of a line is followed in time, no state is kept.
`scene` is the scene for the command line, a line break written as a backslash and n; `scale` the largest value of the quantity in the case.
Confirmed at 42 and 60 digits. Multiple turns are in ting_graham.py, which judges the study of random scenes.
"""

import sys

sys.dont_write_bytecode = True

import time as clock

from mpmath import mp, mpf

from common import COARSE, FINE, arguments, confirmed, differences, double, exact, finish, number, panels, read, write

NAME = "adhesiveless.csv"
COMMAND = "python3 verification/references/adhesiveless.py"
COLUMNS = ["case", "scene", "time", "quantity", "value", "scale", "confirmed_digits"]


def material(lines, ratio):
    return "[material]\n" + "\n".join(lines) + f"\npoisson_ratio = {double(ratio)}\n"


def relaxing(relaxed, terms, ratio):
    series = ", ".join(f"{{ modulus = {double(e)}, relaxation_time = {double(rho)} }}" for e, rho in terms)
    return dict(text=material([f"relaxed_modulus = {double(relaxed)}", f"relaxation = [{series}]"], ratio), relaxed=relaxed, terms=terms, ratio=ratio)


# Non-unit moduli, one, two and three terms, a Maxwell liquid of two.
ONE = relaxing(1.1e6, ((7.3e6, 0.8),), 0.49)
TWO = relaxing(0.83e6, ((2.1e6, 3.0), (4.7e6, 0.05)), 0.31)
THREE = relaxing(2.2e3, ((3.1e3, 0.02), (1.7e4, 0.6), (5.0e2, 40.0)), 0.5)
LIQUID = relaxing(0.0, ((1e6, 1.0), (1e5, 10.0)), 0.5)

SPHERE = dict(text="sphere = { radius = 1.3e-3 }", radius=1.3e-3, exponent=2)
CONE = dict(text="cone = { slope = 0.12 }", slope=0.12, exponent=1)
POWER = dict(text="power_law = { radius = 2.1e-3, exponent = 3.5 }", radius=2.1e-3, exponent=3.5)
BLUNT = dict(text="power_law = { radius = 4.0e-4, exponent = 8.0 }", radius=4.0e-4, exponent=8.0)


class Case:
    def __init__(self, solid, shape, ways, instants=4, accuracy=1e-6):
        """`ways`: (depth, duration), from zero on; at most one of them goes back, the last one."""
        self.solid, self.shape, self.ways = solid, shape, ways
        history = "".join(
            f"[[history]]\nhold = {double(duration)}\n" if depth is None else f"[[history]]\npenetration = {double(depth)}\nduration = {double(duration)}\n"
            for depth, duration in ways)
        self.scene = f"accuracy = {double(accuracy)}\n{solid['text']}[indentation]\n{shape['text']}\ninstants = {instants}\n{history}"
        self.instants = instants

    def corners(self):
        t, depth, out = mpf(0), mpf(0), [(mpf(0), mpf(0))]
        for to, duration in self.ways:
            t += exact(duration)
            depth = depth if to is None else exact(to)
            out.append((t, depth))
        return out

    def relaxation(self, t):
        one = 1 - exact(self.solid["ratio"]) ** 2
        return (exact(self.solid["relaxed"]) + mp.fsum(exact(e) * mp.exp(-t / exact(rho)) for e, rho in self.solid["terms"])) / one

    def coefficient(self):
        """c of f = c s^m."""
        shape, m = self.shape, exact(self.shape["exponent"])
        if "slope" in shape:
            return mp.pi / 2 * exact(shape["slope"])
        return mp.sqrt(mp.pi) * mp.gamma(m / 2 + 1) / (mp.gamma(m / 2 + mpf(1) / 2) * m * exact(shape["radius"]) ** (m - 1))

    def radius(self, depth):
        return (depth / self.coefficient()) ** (1 / exact(self.shape["exponent"]))

    def integral(self, setting, t, low, high, weight):
        """int R(t - t') weight(D(t')) dD over a part of the history, finer towards t, corners and first touch."""
        total = mpf(0)
        for (start, first), (end, last) in zip(self.corners(), self.corners()[1:]):
            a, b = max(start, low), min(end, high)
            if b <= a or first == last:
                continue
            speed = (last - first) / (end - start)
            # Finer towards the root at the first touch, and where the memory of a term begins.
            fine = [a + (b - a) * mpf(8) ** -k for k in range(22, 0, -1)] if first == 0 else []
            back = [t - exact(rho) * many for _, rho in self.solid["terms"] for many in (1, 5, 15, 40, 100)]
            breaks = sorted(set([a] + [x for x in fine + back if a < x < b] + [b]))
            total += panels(setting, lambda x: self.relaxation(t - x) * weight(first + speed * (x - start)) * speed, breaks)
        return total

    def values(self, setting, t):
        corners = self.corners()
        turn = corners[-2][0]
        goes_back = corners[-1][1] < corners[-2][1]
        depth = next(first + (last - first) * (t - start) / (end - start) for (start, first), (end, last) in zip(corners, corners[1:]) if t <= end)
        if not goes_back or t <= turn:
            here, contact = t, max(d for when, d in corners if when <= t) if t in [c[0] for c in corners] else depth
            radius = self.radius(max(contact, depth))
            return self.integral(setting, t, mpf(0), here, lambda d: 2 * self.radius(d)), radius
        first = self.equal(setting, t)
        if first is None:
            return mpf(0), mpf(0)
        met = next(a + (b - a) * (first - start) / (end - start) for (start, a), (end, b) in zip(corners, corners[1:]) if first <= end)
        return self.integral(setting, t, mpf(0), first, lambda d: 2 * self.radius(d)), self.radius(met)

    def pull(self, setting, first, t):
        """int_first^t R(t - t') dD, closed on each straight way."""
        one = 1 - exact(self.solid["ratio"]) ** 2

        def whole(x):
            return (exact(self.solid["relaxed"]) * x + mp.fsum(exact(e) * exact(rho) * (1 - mp.exp(-x / exact(rho))) for e, rho in self.solid["terms"])) / one

        total = mpf(0)
        for (start, a), (end, b) in zip(self.corners(), self.corners()[1:]):
            low, high = max(start, first), min(end, t)
            if high > low and a != b:
                total += (b - a) / (end - start) * (whole(t - low) - whole(t - high))
        return total

    def equal(self, setting, t):
        """t1 of equal radius on the way back; none once the contact is open."""
        if self.pull(setting, mpf(0), t) <= 0:
            return None
        low, high = mpf(0), self.corners()[-2][0]
        return root(lambda x: self.pull(setting, x, t), low, high)

    def detachment(self, setting):
        low, high = self.corners()[-2][0], self.corners()[-1][0]
        return root(lambda t: self.pull(setting, mpf(0), t), low, high)


def root(function, low, high):
    """A root between two places of opposite sign, by bisection and then secants."""
    at_low, at_high = function(low), function(high)
    for step in range(200):
        middle = (low + high) / 2 if step < 6 or step % 3 == 0 else low - at_low * (high - low) / (at_high - at_low)
        if not low < middle < high:
            middle = (low + high) / 2
        value = function(middle)
        if (value > 0) == (at_low > 0):
            moved, low, at_low = middle - low, middle, value
        else:
            moved, high, at_high = high - middle, middle, value
        if min(abs(moved), high - low) < mpf(10) ** (-mp.dps + 8) * high or value == 0:
            return middle
    return middle


CASES = {
    "press_one": Case(ONE, SPHERE, [(2e-5, 0.7)]),
    "press_cone": Case(TWO, CONE, [(3e-5, 2.0)]),
    "press_power": Case(THREE, POWER, [(4e-6, 0.3)]),
    "press_blunt": Case(TWO, BLUNT, [(1e-6, 1.5)]),
    "press_hold_press": Case(ONE, SPHERE, [(1e-5, 1.0), (None, 10.0), (2e-5, 1.0), (None, 10.0)]),
    "liquid_hold": Case(LIQUID, SPHERE, [(1e-5, 1.0), (None, 20.0)]),
    "retract_one": Case(ONE, SPHERE, [(1e-5, 1.0), (None, 1.0), (1e-6, 0.9)], instants=6),
    "retract_three": Case(THREE, CONE, [(1e-5, 0.5), (None, 30.0), (0.0, 0.25)], instants=6),
    "retract_liquid": Case(LIQUID, POWER, [(5e-6, 2.0), (2e-6, 6.0)], instants=6),
}


def burgers():
    """a^3 = (3/4) R (1 - nu^2) F J(t) of a sphere under a constant force: no quadrature at all."""
    glassy, viscosity, compliance, tau, ratio, radius, force = 9.5e9, 1.3e11, 1.4e-10, 0.7, 0.2, 1.1e-2, 90.0
    text = (f"accuracy = 1e-6\n[material]\nglassy_modulus = {double(glassy)}\npoisson_ratio = {double(ratio)}\nviscosity = {double(viscosity)}\n"
            f"creep = [{{ compliance = {double(compliance)}, retardation_time = {double(tau)} }}]\n[indentation]\nsphere = {{ radius = {double(radius)} }}\n"
            f"instants = 4\n[[history]]\nforce = {double(force)}\n[[history]]\nhold = 12.0\n")
    rows = []
    for t in (3.0, 6.0, 12.0):
        # The instants of a hold of 12 s with four of them: 12 (10^-4.5, 10^-1.5, 1/2, 1).
        if t == 3.0:
            continue
        values = []
        for setting in (COARSE, FINE):
            with mp.workdps(setting.dps):
                j = 1 / exact(glassy) + exact(t) / exact(viscosity) + exact(compliance) * (1 - mp.exp(-exact(t) / exact(tau)))
                a = (mpf(3) / 4 * exact(radius) * (1 - exact(ratio) ** 2) * exact(force) * j) ** (mpf(1) / 3)
                values.append((a, a * a / exact(radius)))
        for k, quantity in enumerate(("contact_radius", "penetration")):
            rows.append(("burgers_force", text, t, quantity, values[0][k], values[1][k]))
    return rows


def rows_of(reduced):
    found = []
    for name, case in CASES.items():
        if reduced and name not in ("press_one", "retract_one"):
            continue
        with mp.workdps(FINE.dps):
            corners = case.corners()
            times = []
            for (start, first), (end, last) in zip(corners, corners[1:]):
                if first != last:
                    times += [float(start + (end - start) * k / case.instants) for k in range(1, case.instants + 1)]
                else:
                    times.append(float(end))
        if reduced:
            times = times[-2:]
        for t in times:
            pair = []
            for setting in (COARSE, FINE):
                with mp.workdps(setting.dps):
                    pair.append(case.values(setting, exact(t)))
            for k, quantity in enumerate(("force", "contact_radius")):
                found.append((name, case.scene, t, quantity, pair[0][k], pair[1][k]))
        if name.startswith("retract") and name != "retract_liquid":
            pair = []
            for setting in (COARSE, FINE):
                with mp.workdps(setting.dps):
                    pair.append(case.detachment(setting))
            found.append((name, case.scene, float(pair[1]), "detachment_time", *pair))
    found += burgers()
    scales = {}
    for name, _, _, quantity, _, value in found:
        scales[name, quantity] = max(scales.get((name, quantity), mpf(0)), abs(value))
    out = []
    for name, scene, t, quantity, coarse, fine in found:
        with mp.workdps(FINE.dps):
            digits = confirmed(coarse, fine) if fine != 0 else 32
            out.append(dict(case=name, scene=scene.replace("\n", "\\n"), time=double(t), quantity=quantity, value=number(fine), scale=double(scales[name, quantity]),
                            confirmed_digits=digits))
    return out


def main():
    options = arguments("Indentation without adhesion, textbook cases.")
    start = clock.time()
    rows = rows_of(options.reduced)
    if options.self_check:
        finish([f"{r['case']} {r['quantity']} at {r['time']}: only {r['confirmed_digits']} digits" for r in rows if r["confirmed_digits"] < 14], start, "self-check")
    if options.check:
        for row in rows:
            if options.reduced:
                row.pop("scale")
        finish(differences(NAME, read(NAME), rows, ["case", "time", "quantity"]) if not options.reduced else
               differences(NAME, [{k: v for k, v in row.items() if k != "scale"} for row in read(NAME)], rows, ["case", "time", "quantity"]),
               start, f"check of {len(rows)} rows")
    write(NAME, COMMAND, "indentation without adhesion by quadrature over the history (Lee and Radok, Ting)", COLUMNS, rows)
    print(f"written in {clock.time() - start:.1f} s")


if __name__ == "__main__":
    main()
