"""Reference values for the sphere: writes or checks indentation.csv and indentation_march.csv.

    python3 verification/references/indentation.py                    regenerate both files (the second needs numpy)
    python3 verification/references/indentation.py --check            recompute all, compare to the confirmed digits
    python3 verification/references/indentation.py --check --reduced  a subset of the first file; no numpy
    python3 verification/references/indentation.py --self-check       the closure in real space against the closure on the line

indentation.csv, one value a row (key: case, quantity, place); inputs are exact doubles, named in `inputs` as name=value
    elliptic        K(m), m the parameter, from the integral of 1/sqrt(1 - m sin^2)
    closure         work of thesis 4.9, (1/2 delta) int tension(a - d) gap(a + delta - d) dd, from p(r) and the gap in REAL SPACE: two inner
                    integrals (Sneddon) at each point of the outer one. Q(s) and D(s) are polynomials in s on pieces; a jump of Q is an atom.
    elastic         radius and force of an elastic contact at a penetration, at the same process zone: root of the closure, order of
                    integration exchanged (complete elliptic kernel), no stage of which is the solver's series or panels
    prescribed      without adhesion, edge imposed: Lee & Radok (J. Appl. Mech. 27 (1960) 438) advancing, Ting (J. Appl. Mech. 33 (1966) 845)
                    receding, by quadrature of their integrals; relaxation of a flat punch
    material: relaxed modulus then E_i,rho_i pairs; moduli are E*

indentation_march.csv (key: case, time): an adhesive contact in time, double precision, by another method than the solver's
    The unknown is the time at which the edge passes each place of the line, on a grid of n places per process zone; what a place carries then
    follows in closed form from its own past (Maxwell branches while bonded; a matrix exponential while free). At each place the time is found
    by secants from the closure with the complete elliptic kernel. Values at given times by a polynomial through 6 places.
    `digits` is the agreement of the two finest grids.

independence: `fallback` where the reduction to a line is shared with the solver (elastic contacts, marches), `independent` elsewhere; marches and contacts
on the raw equation are in sphere_annuli.py.
"""

import sys

sys.dont_write_bytecode = True

import time as clock

from mpmath import mp, mpf

from common import COARSE, FINE, arguments, confirmed, differences, double, exact, finish, gauss, number, panels, read, write

COMMAND = "python3 verification/references/indentation.py"
COLUMNS = ["case", "inputs", "quantity", "place", "value", "confirmed_digits", "independence"]
MARCH_COLUMNS = ["case", "inputs", "time", "penetration", "force", "contact_radius", "digits", "independence"]

SHAPES = {"paraboloid": lambda p, s: s * s / p, "cone": lambda p, s: mp.pi / 2 * p * s}
ONE_TERM = (1.0, ((9.0, 1.0),))
THREE_TERMS = (1.0, ((3.0, 0.1), (4.0, 1.0), (2.0, 20.0)))
HARD_RUBBER = (0.83e6, ((2.1e6, 3e-4), (0.9e6, 0.02), (0.4e6, 1.7)))


def named(**values):
    return " ".join(f"{key}={value if isinstance(value, str) else double(value)}" for key, value in values.items())


def material_text(material):
    relaxed, terms = material
    return ";".join([double(relaxed)] + [f"{double(e)},{double(rho)}" for e, rho in terms])


def relaxation(material, t):
    return exact(material[0]) + mp.fsum(exact(e) * mp.exp(-t / exact(rho)) for e, rho in material[1])


# ---------------------------------------------------------------- elliptic kernel

def elliptic(setting, m):
    """int_0^{pi/2} dx / sqrt(1 - m sin^2 x): smooth and periodic, so the trapezoid converges geometrically."""
    step, total, count = mp.pi / 2, mpf(0), 1
    values = lambda x: 1 / mp.sqrt(1 - m * mp.sin(x) ** 2)
    total = (values(mpf(0)) + values(mp.pi / 2)) / 2
    last = None
    for _ in range(14):
        now = total * step
        if last is not None and abs(now - last) < abs(now) * mpf(10) ** (-setting.dps + 6):
            return now
        last = now
        total += mp.fsum(values((2 * i + 1) * step / 2) for i in range(count))
        step, count = step / 2, 2 * count
    return now


def elliptic_rows(reduced):
    for m in (-4.0, -0.7, -1e-2, -1e-9, 1e-12, 1e-5, 0.02, 0.3, 0.7, 0.97)[:: 3 if reduced else 1]:
        yield "elliptic", named(m=m), "elliptic_k", "", lambda setting, m=m: elliptic(setting, exact(m))


# ---------------------------------------------------------------- closure

class Pieces:
    """A polynomial in s on each of consecutive pieces: [(upper, [c0, c1, ...]), ...] from `lower` on."""

    def __init__(self, lower, pieces):
        self.lower, self.pieces = exact(lower), [(exact(u), [exact(c) for c in cs]) for u, cs in pieces]

    def breaks(self):
        """Inner ends only: the outer ones are those of the integrals, and their doubles may be off in the last bit."""
        return [u for u, _ in self.pieces[:-1]]

    def coefficients(self, s):
        return next((cs for u, cs in self.pieces if s <= u), self.pieces[-1][1])

    def at(self, s, cs=None):
        return mp.polyval((cs or self.coefficients(s))[::-1], s)

    def slope(self, s):
        cs = self.coefficients(s)
        return mp.polyval([k * c for k, c in enumerate(cs)][:0:-1], s)

    def jumps(self):
        return [(u, self.at(u, after) - self.at(u, before)) for (u, before), (_, after) in zip(self.pieces, self.pieces[1:])]


def between(low, high, points):
    return [low] + sorted(x for x in points if low < x < high) + [high]


def tension(setting, a, load, r):
    """-p(r) = -(1/pi)[Q(a)/sqrt(a^2 - r^2) - int_r^a dQ/sqrt(s^2 - r^2)], s = sqrt(r^2 + y^2)."""
    smooth = panels(setting, lambda y: load.slope(mp.sqrt(r * r + y * y)) / mp.sqrt(r * r + y * y),
                    [mp.sqrt(abs(s * s - r * r)) for s in between(r, a, load.breaks())])
    atoms = mp.fsum(jump / mp.sqrt((s - r) * (s + r)) for s, jump in load.jumps() if s > r)
    return -(load.at(a) / mp.sqrt((a - r) * (a + r)) - smooth - atoms) / mp.pi


def gap(setting, a, factor, r):
    """(2/pi) int_a^r D/sqrt(r^2 - s^2) ds, s = sqrt(r^2 - y^2)."""
    breaks = [mp.sqrt(abs(r * r - s * s)) for s in between(a, r, factor.breaks())][::-1]
    return 2 / mp.pi * panels(setting, lambda y: factor.at(mp.sqrt(r * r - y * y)) / mp.sqrt(r * r - y * y), breaks)


def closure_in_space(setting, a, zone, load, factor):
    breaks = between(a - zone, a, load.breaks() + [s - zone for s in factor.breaks()])
    total = mpf(0)
    for low, high in zip(breaks, breaks[1:]):
        def product(theta):
            r = low + (high - low) * mp.sin(theta) ** 2
            return tension(setting, a, load, r) * gap(setting, a, factor, r + zone) * (high - low) * mp.sin(2 * theta)
        total += panels(setting, product, [mpf(0), mp.pi / 2])
    return total / (2 * zone)


def closure_on_line(setting, a, zone, load, factor):
    """(1/pi^2 delta) int D(s') int dmu(s) K(m)/sqrt(s s'), theory of the line; used for the elastic contacts and the self-check."""
    def kernel(s, other):
        return mp.ellipk((zone - other + s) * (zone + other - s) / (4 * s * other)) / mp.sqrt(s * other)

    def inner(other):
        low = other - zone
        smooth = panels(setting, lambda s: load.slope(s) * kernel(s, other), between(low, a, load.breaks()))
        atoms = mp.fsum(jump * kernel(s, other) for s, jump in load.jumps() if s > low)
        return smooth + atoms - load.at(a) * kernel(a, other)

    breaks = between(a, a + zone, factor.breaks() + [s + zone for s in load.breaks()])
    return panels(setting, lambda other: factor.at(other) * inner(other), breaks) / (mp.pi ** 2 * zone)


def closure_cases():
    """name, a, delta, pieces of Q from 0, pieces of D from a; a relaxed paraboloid is Q = E(depth - s^2/R), D = s^2/R - depth"""
    def relaxed(a, zone, radius, modulus, depth):
        return a, zone, [(a, [modulus * depth, 0.0, -modulus / radius])], [(a + zone, [-depth, 0.0, 1 / radius])]

    yield "relaxed_point_b", *relaxed(0.245, 0.013, 1.0, 1.0, 0.032)
    yield "relaxed_wide_zone", *relaxed(0.05, 0.0251, 1.0, 1.0, -0.004)
    yield "relaxed_narrow_zone", *relaxed(0.31, 3e-4, 1.0, 10.0, 0.05)
    yield "relaxed_si", *relaxed(2.3e-4, 1.1e-5, 3.2e-3, 7.1e5, 9.1e-6)
    yield "relaxed_cone", 0.11, 0.009, [(0.11, [0.03, -0.35])], [(0.119, [-0.03, 0.35])]
    # A slope of Q that breaks inside the window, and D that jumps and bends inside the zone.
    yield "kinked_load", 0.2, 0.02, [(0.187, [0.01, 0.0, -0.5]), (0.2, [0.2905365, -1.7, 0.5])], [(0.22, [-0.03, 0.0, 1.0])]
    yield "jump_of_gap", 0.2, 0.02, [(0.2, [0.02, 0.0, -1.0])], [(0.2117, [-0.037, 0.0, 1.0]), (0.22, [-0.029, 0.0, 1.1])]
    yield "kink_and_jump", 0.2, 0.02, [(0.183, [0.01, 0.0, -0.5]), (0.2, [0.284305, -1.7, 0.5])], \
        [(0.204, [-0.037, 0.0, 1.0]), (0.22, [-0.029, 0.0, 1.1])]
    yield "atom_far_out", 0.2, 0.02, [(0.1975, [0.02, 0.0, -1.0]), (0.2, [-0.01, 0.0, -1.0])], [(0.22, [-0.03, 0.0, 1.0])]
    yield "atom_mid", 0.2, 0.02, [(0.19, [0.02, 0.0, -1.0]), (0.2, [0.025, 0.0, -1.2])], [(0.22, [-0.03, 0.0, 1.0])]
    yield "atom_deep", 0.06, 0.02, [(0.0412, [0.002, 0.0, -1.0]), (0.06, [0.0025, 0.0, -1.1])], [(0.08, [-0.002, 0.0, 1.0])]
    yield "two_atoms_and_jump", 0.2, 0.02, [(0.186, [0.01, 0.0, -1.0]), (0.193, [0.014, 0.0, -1.1]), (0.2, [0.008, 0.0, -1.0])], \
        [(0.2105, [-0.037, 0.0, 1.0]), (0.22, [-0.03, 0.0, 1.0])]


def pieces_text(lower, pieces):
    return "|".join([double(lower)] + [",".join([double(u)] + [double(c) for c in cs]) for u, cs in pieces])


def closure_rows(reduced):
    for name, a, zone, load, factor in list(closure_cases())[:: 5 if reduced else 1]:
        # The zone ends where the last piece of D says; both ends are what the double says.
        inputs = named(a=a, zone=zone, load=pieces_text(0.0, load), factor=pieces_text(a, factor))
        yield name, inputs, "closure", "", lambda setting, a=a, zone=zone, load=load, factor=factor: closure_in_space(
            setting, exact(a), exact(zone), Pieces(0.0, load), Pieces(a, factor))


# ---------------------------------------------------------------- elastic contacts

def elastic_cases():
    """shape, size, modulus, work, zone, depth"""
    yield "paraboloid", 1.0, 1.0, 1.6e-4 * 3.141592653589793, 0.013, 0.032
    yield "paraboloid", 1.0, 1.0, 1.6e-4 * 3.141592653589793, 0.013, 0.002
    yield "paraboloid", 1.0, 10.0, 1.6e-4 * 3.141592653589793, 0.013, 0.0
    yield "paraboloid", 1.0, 1.0, 1.6e-4 * 3.141592653589793, 0.0017, -0.004
    yield "paraboloid", 2.7e-3, 0.83e6, 0.061, 4.1e-6, 5.5e-6
    yield "paraboloid", 3.3, 47.0, 2.9e-4, 0.011, 0.017
    yield "cone", 0.31, 2.2e6, 0.042, 1.3e-6, 2.3e-5
    yield "cone", 0.05, 1.0, 1e-5, 2e-3, 0.004


ELASTIC = {}


def elastic_state(setting, shape, size, modulus, work, zone, depth):
    key = (setting.name, shape, size, modulus, work, zone, depth)
    if key in ELASTIC:
        return ELASTIC[key]
    size, modulus, work, zone, depth = (exact(x) for x in (size, modulus, work, zone, depth))
    curve = [-depth, mpf(0), 1 / size] if shape == "paraboloid" else [-depth, mp.pi / 2 * size]

    class Line(Pieces):
        def __init__(self, lower, upper, coefficients):
            self.lower, self.pieces = lower, [(upper, coefficients)]

    def excess(a, setting=setting):
        value = closure_on_line(setting, a, zone, Line(mpf(0), a, [-modulus * c for c in curve]), Line(a, a + zone, curve))
        overlap = mp.polyval(curve[::-1], a) < 0
        return (-value if overlap else value) / work - 1

    quick = type(setting)("quick", 18, 8, 0)
    scale = max(zone * mpf("1.02"), 3 * (size * size * work / modulus) ** (mpf(1) / 3) if shape == "paraboloid" else 3 * work / modulus / size ** 2)
    high = scale + 3 * (mp.sqrt(size * abs(depth)) if shape == "paraboloid" else abs(depth) / size)
    with mp.workdps(20):
        # The largest contact: from far out, down to the first sign change.
        while excess(high, quick) < 0:
            high *= 2
        low = high / mpf("1.03")
        while excess(low, quick) > 0:
            high, low = low, low / mpf("1.03")
        for _ in range(12):
            middle = (low + high) / 2
            low, high = (low, middle) if excess(middle, quick) > 0 else (middle, high)
    first, second = low, high
    f_first, f_second = excess(first), excess(second)
    for _ in range(20):
        third = second - f_second * (second - first) / (f_second - f_first)
        first, f_first, second, f_second = second, f_second, third, excess(third)
        if abs(second - first) < second * mpf(10) ** (-setting.dps + 8):
            break
    a = second
    force = 2 * modulus * panels(setting, lambda s: -mp.polyval(curve[::-1], s), [mpf(0), a])
    ELASTIC[key] = a, force
    return a, force


def elastic_rows(reduced):
    for shape, size, modulus, work, zone, depth in list(elastic_cases())[:: 7 if reduced else 1]:
        inputs = named(shape=shape, size=size, modulus=modulus, work=work, zone=zone, penetration=depth)
        for index, quantity in enumerate(("contact_radius", "force")):
            yield "elastic", inputs, quantity, "", lambda setting, index=index, case=(shape, size, modulus, work, zone, depth): elastic_state(
                setting, *case)[index]


# ---------------------------------------------------------------- prescribed edge, no adhesion

def elastic_force_rate(shape, size, a):
    """dF/da of the elastic contact of unit modulus: 2 a f'(a)."""
    return 4 * a * a / size if shape == "paraboloid" else mp.pi * size * a


def depth_of(shape, size, a):
    return SHAPES[shape](size, a)


def timed_breaks(material, low, high, now):
    """Panels that follow the exponentials back from `now`, out to the longest time."""
    times = [exact(rho) for _, rho in material[1]]
    marks = {now - rho * mpf(2) ** k for rho in times for k in range(-4, 8)}
    return between(low, high, marks)


def memory_force(setting, material, shape, size, peak, rise, until, now):
    """int_0^until R(now - u) dF_el(a(u)), a = peak u/rise: Lee & Radok for until = now, Ting receding for until = t_1."""
    rate = peak / rise
    return panels(setting, lambda u: relaxation(material, now - u) * elastic_force_rate(shape, size, rate * u) * rate,
                  timed_breaks(material, mpf(0), until, now))


def ting_depth(setting, material, shape, size, peak, rise, fall, bottom, now):
    """Depth while receding: the load of the edge's place vanishes, a Volterra equation for the rate of depth, solved through the creep function."""
    rate, back = peak / rise, (peak - bottom) / fall

    def forced(t):
        # -int_{t1}^{rise} R(t - u) d(depth) over the advance, t1 the time at which the edge first passed its present place.
        a = peak - back * (t - rise)
        slope = (lambda u: 2 * rate * rate * u / size) if shape == "paraboloid" else (lambda u: mp.pi / 2 * size * rate)
        return -panels(setting, lambda u: relaxation(material, t - u) * slope(u), timed_breaks(material, a / rate, rise, t))

    total, terms = creep_series(material)
    memory = panels(setting, lambda t: mp.fsum(j / tau * mp.exp(-(now - t) / tau) for j, tau in terms) * forced(t),
                    between(rise, now, {now - tau * mpf(2) ** k for _, tau in terms for k in range(-4, 8)}))
    return depth_of(shape, size, peak) + forced(now) / total + memory


def creep_series(material):
    """E_inf and (J_j, tau_j): zeros of R's transform s R(s) by bisection between its poles."""
    relaxed, terms = exact(material[0]), [(exact(e), 1 / exact(rho)) for e, rho in material[1]]
    glassy = relaxed + mp.fsum(e for e, _ in terms)
    poles = sorted(r for _, r in terms)

    def transform(l):
        return relaxed - mp.fsum(e * l / (r - l) for e, r in terms)

    out = []
    for low, high in zip([mpf(0)] + poles, poles):
        a, b = low, high
        for _ in range(4 * mp.dps):
            middle = (a + b) / 2
            # Between two poles the transform falls from +infinity (or E0) to -infinity.
            a, b = (middle, b) if transform(middle) > 0 else (a, middle)
        l = (a + b) / 2
        out.append((1 / (l * mp.fsum(e * r / (r - l) ** 2 for e, r in terms)), 1 / l))
    return glassy, out


def prescribed_cases():
    """name, material, shape, size, peak, rise, fall, bottom"""
    yield "one_term", ONE_TERM, "paraboloid", 1.0, 0.2, 2.0, 1.5, 0.05
    yield "three_terms", THREE_TERMS, "paraboloid", 1.0, 0.2, 2.0, 1.5, 0.05
    yield "hard_rubber", HARD_RUBBER, "paraboloid", 3e-3, 2e-4, 0.013, 0.3, 4e-5
    yield "cone_of_three_terms", THREE_TERMS, "cone", 0.21, 0.3, 0.4, 5.0, 0.06


def prescribed_rows(reduced):
    for name, material, shape, size, peak, rise, fall, bottom in list(prescribed_cases())[:: 3 if reduced else 1]:
        inputs = named(material=material_text(material), shape=shape, size=size, peak=peak, rise=rise, fall=fall, bottom=bottom)
        for quarter in (1, 2, 4):
            up = lambda setting, m=material, s=shape, p=(size, peak, rise), q=quarter: memory_force(
                setting, m, s, *(exact(x) for x in p), exact(p[2]) * q / 4, exact(p[2]) * q / 4)
            yield name, inputs, "advancing_force", str(quarter), up
        for quarter in (1, 2, 4):
            def down(setting, what, m=material, s=shape, p=(size, peak, rise, fall, bottom), q=quarter):
                size, peak, rise, fall, bottom = (exact(x) for x in p)
                now = rise + fall * q / 4
                a = peak - (peak - bottom) * q / 4
                if what == "force":
                    return memory_force(setting, m, s, size, peak, rise, a / peak * rise, now)
                return ting_depth(setting, m, s, size, peak, rise, fall, bottom, now)
            yield name, inputs, "receding_force", str(quarter), lambda setting, down=down: down(setting, "force")
            yield name, inputs, "receding_penetration", str(quarter), lambda setting, down=down: down(setting, "penetration")


def punch_rows(_reduced):
    """A flat punch of radius a pressed to `depth` in `rise`, then held: F = 2a int R(t - u) d(depth)."""
    for name, material, a, depth, rise, hold in (("punch_step", ONE_TERM, 0.3, 0.01, 0.0, 4.0), ("punch_ramp", HARD_RUBBER, 2e-4, 3e-6, 0.02, 1.0)):
        inputs = named(material=material_text(material), radius=a, penetration=depth, rise=rise, hold=hold)
        for quarter in (1, 2, 4):
            def force(setting, m=material, p=(a, depth, rise, hold), q=quarter):
                a, depth, rise, hold = (exact(x) for x in p)
                now = rise + hold * q / 4
                if rise == 0:
                    return 2 * a * depth * relaxation(m, now)
                return 2 * a * depth / rise * panels(setting, lambda u: relaxation(m, now - u), timed_breaks(m, mpf(0), rise, now))
            yield name, inputs, "punch_force", str(quarter), force


# ---------------------------------------------------------------- marches (numpy)

class March:
    """An edge that passes each place of the line once; n grid places per process zone."""

    def __init__(self, material, work, zone, per_zone):
        import numpy as np
        self.np, self.work, self.zone, self.n = np, work, zone, per_zone
        self.relaxed = material[0]
        self.moduli = np.array([e for e, _ in material[1]])
        self.times = np.array([rho for _, rho in material[1]])
        self.glassy = self.relaxed + self.moduli.sum()
        self.step = zone / per_zone
        # Free branches: v' = (sum E v/E_inf - v)/rho, by its eigenvectors.
        free = (np.outer(np.ones(len(self.times)), self.moduli / self.glassy) - np.eye(len(self.times))) / self.times[:, None]
        self.rates, self.modes = np.linalg.eig(free)
        self.inverse = np.linalg.inv(self.modes)
        nodes, weights = np.polynomial.legendre.leggauss(6)
        self.nodes, self.weights = 0.5 * (1 + nodes), 0.5 * weights
        nodes, weights = np.polynomial.legendre.leggauss(20)
        self.inner_nodes, self.inner_weights = 0.5 * (1 + nodes), 0.5 * weights

    def relaxation(self, t):
        return self.relaxed + (self.moduli * self.np.exp(-self.np.multiply.outer(t, 1 / self.times))).sum(axis=-1)

    def relaxation_rate(self, t):
        return -(self.moduli / self.times * self.np.exp(-self.np.multiply.outer(t, 1 / self.times))).sum(axis=-1)

    def relaxation_integral(self, t):
        return self.relaxed * t - (self.moduli * self.times * self.np.expm1(-self.np.multiply.outer(t, 1 / self.times))).sum(axis=-1)

    def ellipk(self, m):
        np = self.np
        arithmetic, geometric = np.ones_like(m), np.sqrt(1 - m)
        for _ in range(6):
            arithmetic, geometric = 0.5 * (arithmetic + geometric), np.sqrt(arithmetic * geometric)
        return 0.5 * np.pi / arithmetic

    def kernel(self, s, other):
        return self.ellipk((self.zone ** 2 - (other - s) ** 2) / (4 * s * other)) / self.np.sqrt(s * other)

    def basis(self, cell, count):
        """Places and factors (value, slope) of the grid points that carry the passing time on a cell: up to 6 in the same block of one zone."""
        np = self.np
        block = cell // self.n * self.n
        first = max(block, min(cell - 2, block + self.n - 5))
        last = min(first + 5, count, block + self.n)
        first = max(block, last - 5)
        x = np.arange(first, last + 1) - cell
        value = np.ones((len(self.nodes), len(x)))
        slope = np.zeros_like(value)
        for l in range(len(x)):
            others = [k for k in range(len(x)) if k != l]
            value[:, l] = np.prod([(self.nodes - x[k]) / (x[l] - x[k]) for k in others], axis=0)
            for k in others:
                rest = [i for i in others if i != k]
                part = np.prod([(self.nodes - x[i]) / (x[l] - x[i]) for i in rest], axis=0) if rest else 1.0
                slope[:, l] += part / (x[l] - x[k])
        return first, last, value, slope

    def spread(self, passed, cells, slopes=False):
        """The passing time at the Gauss nodes of cells, by the polynomial of each."""
        np = self.np
        count = len(passed) - 1
        out = []
        for cell in cells:
            key = (cell % self.n, min(count - cell, 8), cell)
            if key not in self.cache:
                self.cache[key] = self.basis(cell, count)
            first, last, value, slope = self.cache[key]
            out.append((slope if slopes else value) @ passed[first:last + 1])
        return np.concatenate(out) if out else np.zeros(0)

    def secant(self, function, first, second):
        f_first, f_second = function(first), function(second)
        for _ in range(60):
            if f_second == f_first:
                break
            third = second - f_second * (second - first) / (f_second - f_first)
            first, f_first, second = second, f_second, third
            f_second = function(second)
            if abs(f_second) < 1e-14 or abs(second - first) <= 1e-15 * abs(second):
                break
        return second

    def retraction(self, radius, depth, speed, start, end_time):
        """From a relaxed contact of radius `start` at `depth`; (t, a, F) at each place until end_time is passed."""
        np = self.np
        self.cache = {}
        passed, h = [0.0], self.step
        table = [(0.0, start, 2 * self.relaxed * (depth * start - start ** 3 / (3 * radius)))]

        def free(places, left, now):
            """W of places that were bonded from the start until `left`."""
            bonded = (depth - places ** 2 / radius)[:, None] - speed * (left[:, None] + self.times * np.expm1(-left[:, None] / self.times))
            modes = (bonded @ self.inverse.T) * np.exp((now - left)[:, None] * self.rates)
            return (modes @ self.modes.T) @ self.moduli / self.glassy

        while passed[-1] < end_time or len(passed) % self.n < 7:
            count = len(passed)
            a = start - count * h
            cells = list(range(max(0, count - self.n), count))          # cell k: from start - k h down to start - (k+1) h
            places = np.concatenate([start - (k + self.nodes) * h for k in cells])
            weights = np.concatenate([self.weights * h for _ in cells])
            fresh = max(a + self.zone - start, 0.0)
            if fresh > 0:
                outer = start + fresh * self.inner_nodes
                places_all, weights_all = np.concatenate([places, outer]), np.concatenate([weights, fresh * self.inner_weights])
            else:
                places_all, weights_all = places, weights
            low = places_all - self.zone
            s = low[:, None] + (a - low)[:, None] * self.inner_nodes
            sloped = -((a - low)[:, None] * self.inner_weights * 2 * s / radius * self.kernel(s, places_all[:, None])).sum(axis=1) * self.relaxed
            edge = self.kernel(a, places_all)
            trial = np.array(passed + [0.0])

            def excess(t):
                trial[-1] = t
                lifted = places_all ** 2 / radius - (depth - speed * t)
                gap = lifted.copy()
                gap[:len(places)] += free(places, self.spread(trial, cells), t)
                load = self.relaxed * (depth - a * a / radius) - speed * self.relaxation_integral(t)
                return float((weights_all * gap * (sloped - load * edge)).sum()) / (np.pi ** 2 * self.zone * self.work) - 1

            guess = 2 * passed[-1] - passed[-2] if count > 1 else 1e-3 * start / speed * h / start
            t = self.secant(excess, passed[-1] + 0.5 * (guess - passed[-1]), guess)
            passed.append(t)
            table.append((t, a, 2 * (self.relaxed * (depth * a - a ** 3 / (3 * radius)) - speed * self.relaxation_integral(t) * a)))
        return np.array(table)

    def approach(self, radius, speed, end_time):
        """From first touch at depth 0 (glassy jump-in); (t, a, F) at each place."""
        np = self.np
        self.cache = {}
        start, h = self.first_touch(radius), self.step
        passed = [0.0]
        table = [(0.0, start, -2 * self.glassy * start ** 3 / (3 * radius))]
        curve = lambda s: s * s / radius
        while passed[-1] < end_time or len(passed) % self.n < 7:
            count = len(passed)
            a = start + count * h
            cells = list(range(max(0, count - self.n), count))          # cell k: from start + k h up to start + (k+1) h
            new = np.concatenate([start + (k + self.nodes) * h for k in cells])
            new_weights = np.concatenate([self.weights * h for _ in cells])
            low = a - self.zone
            old_width = max(start - low, 0.0)
            old = low + old_width * self.inner_nodes
            s = np.concatenate([old, new, [a]])
            reach = s + self.zone - a
            other = a + reach[:, None] * self.inner_nodes
            weighted = reach[:, None] * self.inner_weights * self.kernel(s[:, None], other)
            by_curve, by_one = (weighted * curve(other)).sum(axis=1), weighted.sum(axis=1)
            trial = np.array(passed + [0.0])

            def excess(t):
                trial[-1] = t
                depth = speed * t
                touch = self.spread(trial, cells)
                touch_slope = self.spread(trial, cells, slopes=True) / h
                age = t - touch
                new_slope = -self.relaxation_rate(age) * touch_slope * (speed * touch - curve(new)) - self.relaxation(age) * 2 * new / radius
                old_slope = -self.relaxation(t) * 2 * old / radius
                window = by_curve - depth * by_one
                total = -self.glassy * (depth - curve(a)) * window[-1] + (new_weights * new_slope * window[len(old):-1]).sum()
                total += (old_width * self.inner_weights * old_slope * window[:len(old)]).sum()
                return float(total) / (np.pi ** 2 * self.zone * self.work) - 1

            guess = 2 * passed[-1] - passed[-2] if count > 1 else 1e-3 * h / speed
            t = self.secant(excess, passed[-1] + 0.5 * (guess - passed[-1]), guess)
            passed.append(t)
            every = list(range(count))
            self.cache = {key: found for key, found in self.cache.items() if key[1] == 8}
            touch = self.spread(np.array(passed), every)
            place = np.concatenate([start + (k + self.nodes) * h for k in every])
            weight = np.tile(self.weights * h, count)
            load = self.relaxation(t - touch) * (speed * touch - curve(place)) + speed * self.relaxation_integral(t - touch)
            inside = -self.relaxation(t) * start ** 3 / (3 * radius) + speed * self.relaxation_integral(t) * start
            table.append((t, a, 2 * (inside + float((weight * load).sum()))))
        return np.array(table)

    def elastic_excess(self, a, radius, modulus, depth):
        np = self.np
        other = a + self.zone * self.inner_nodes
        low = other - self.zone
        s = low[:, None] + (a - low)[:, None] * self.inner_nodes
        sloped = -modulus * ((a - low)[:, None] * self.inner_weights * 2 * s / radius * self.kernel(s, other[:, None])).sum(axis=1)
        bracket = sloped - modulus * (depth - a * a / radius) * self.kernel(a, other)
        return float((self.zone * self.inner_weights * (other ** 2 / radius - depth) * bracket).sum()) / (np.pi ** 2 * self.zone * self.work) - 1

    def elastic_radius(self, radius, modulus, depth):
        high = 3 * max(depth, 0.0) ** 0.5 * radius ** 0.5 + 3 * (radius ** 2 * self.work / modulus) ** (1 / 3) + 2 * self.zone
        low = high
        while self.elastic_excess(low, radius, modulus, depth) > 0:
            high, low = low, low / 1.01
        return self.secant(lambda a: self.elastic_excess(a, radius, modulus, depth), low, high)

    def first_touch(self, radius):
        return self.elastic_radius(radius, self.glassy, 0.0)

    def at(self, table, t):
        """a and F at a time, by a polynomial through 6 places around it that stay in one block."""
        np = self.np
        index = int(np.searchsorted(table[:, 0], t)) - 1
        block = index // self.n * self.n
        first = max(block, min(index - 2, block + self.n - 5, len(table) - 6))
        x = table[first:first + 6, 0]
        out = np.zeros(2)
        for l in range(6):
            factor = np.prod([(t - x[k]) / (x[l] - x[k]) for k in range(6) if k != l])
            out += factor * table[first + l, 1:]
        return out


def march_cases():
    """name, material, radius, work, zone, kind, depth at the start, speed, end"""
    work = 1.6e-4 * 3.141592653589793
    yield "retraction_of_one_term", ONE_TERM, 1.0, work, 0.013, "retraction", 0.032, 2e-3, 10.0
    yield "fast_retraction_of_one_term", ONE_TERM, 1.0, work, 0.013, "retraction", 0.032, 5e-2, 0.14
    yield "retraction_of_three_terms", THREE_TERMS, 1.0, work, 0.013, "retraction", 0.032, 2e-2, 0.6
    yield "approach_of_one_term", ONE_TERM, 1.0, work, 0.013, "approach", 0.0, 2e-3, 8.0
    yield "approach_of_three_terms", THREE_TERMS, 1.0, work, 0.013, "approach", 0.0, 2e-2, 1.0
    yield "retraction_in_si", HARD_RUBBER, 3.1e-3, 0.4, 3.9e-5, "retraction", 1e-4, 2e-5, 2.0


def march_rows():
    out = []
    for name, material, radius, work, zone, kind, depth, speed, end in march_cases():
        found = []
        for per_zone in (24, 48, 96):
            march = March(material, work, zone, per_zone)
            if kind == "retraction":
                start = march.elastic_radius(radius, march.relaxed, depth)
                table = march.retraction(radius, depth, speed, start, end)
            else:
                table = march.approach(radius, speed, end)
            found.append([march.at(table, end * k / 4) for k in (1, 2, 3, 4)])
        inputs = named(material=material_text(material), radius=radius, work=work, zone=zone, kind=kind, depth=depth, speed=speed)
        scale = max(abs(pair[1]) for pair in found[2])
        for k in range(4):
            (a0, f0), (a, f) = found[1][k], found[2][k]
            difference = max(abs(a / a0 - 1), abs(f - f0) / scale, 1e-12)
            now = end * (k + 1) / 4
            there = depth - speed * now if kind == "retraction" else speed * now
            out.append(dict(case=name, inputs=inputs, time=double(now), penetration=double(there), force=f"{f:.12e}",
                            contact_radius=f"{a:.12e}", digits=int(-march.np.log10(difference)), independence="fallback"))
    return out


# ---------------------------------------------------------------- file

def rows(reduced):
    out = []
    for source in (elliptic_rows, closure_rows, elastic_rows, prescribed_rows, punch_rows):
        for case, inputs, quantity, place, compute in source(reduced):
            values = []
            for setting in (COARSE, FINE):
                with mp.workdps(setting.dps):
                    values.append(compute(setting))
            with mp.workdps(60):
                out.append(dict(case=case, inputs=inputs, quantity=quantity, place=place, value=number(values[1]), confirmed_digits=confirmed(*values),
                                independence="fallback" if source is elastic_rows else "independent"))
    return out


def self_check():
    wrong = []
    with mp.workdps(COARSE.dps):
        for name, a, zone, load, factor in closure_cases():
            arguments_of = (COARSE, exact(a), exact(zone), Pieces(0.0, load), Pieces(a, factor))
            space, line = closure_in_space(*arguments_of), closure_on_line(*arguments_of)
            if abs(space / line - 1) > mpf(10) ** -20:
                wrong.append(f"{name}: real space and line differ by {mp.nstr(space / line - 1, 3)}")
    return wrong


def main():
    options = arguments("Reference values for the sphere.")
    start = clock.time()
    if options.self_check:
        finish(self_check(), start, "self-check")
    fresh = rows(options.reduced)
    marched = [] if options.reduced else march_rows()
    if options.check:
        wrong = differences("indentation.csv", read("indentation.csv"), fresh, ["case", "inputs", "quantity", "place"])
        for row, old in zip(marched, read("indentation_march.csv") if marched else []):
            for column in ("force", "contact_radius"):
                if abs(float(row[column]) / float(old[column]) - 1) > 1e-8:
                    wrong.append(f"indentation_march.csv: {row['case']} {row['time']} {column}")
        finish(wrong, start, f"check of {len(fresh) + len(marched)} rows")
    write("indentation.csv", COMMAND, "sphere: closure, elastic contacts, prescribed edges; columns in the opening of the script", COLUMNS, fresh)
    write("indentation_march.csv", COMMAND, "adhesive marches by the passing times of the edge; columns in the opening of the script", MARCH_COLUMNS,
          marched, precision="double; digits by the agreement of 48 and 96 places per process zone")


if __name__ == "__main__":
    main()
