"""Steady sliding contacts on a wave, by collocation of the integral equation itself; writes or checks sliding_wave.csv.

Independent of the solver: nothing is inverted in closed form and no memory operator is divided out. The pressure is the unknown,
    p(y) dy = sum_n c_n T_n(t) dt/sqrt(1 - t^2),     t = tan(y/2)/tan(a/2),     y = x - e, |y| < a,
its elastic displacement (thesis 3.24 with beta = 1) is known in and out of the contact, because
    log|2 sin((y - h)/2)| = log|t - t'| + log(2 tan(a/2)) + log cos(y/2) + log cos(h/2),
    int T_n(t') log|t - t'| dt'/sqrt(1 - t'^2) = -(pi/n) T_n(t) inside, -(pi/n) rho^-n outside, rho = t + sqrt(t^2 - 1)
(n = 0: -pi log 2 and pi log(rho/2)), and every creep term is its exponential memory, as the thesis defines it,
    w_j(y) = int_0^inf e^-z u(y + zeta_j z) dz = int_y^(y + 2 pi) e^-((x - y)/zeta_j) u(x) dx/zeta_j / (1 - e^-(2 pi/zeta_j)),
by Gauss panels: between neighbouring collocation points inside, graded to both edges and to zeta_j in the gap. Then
    sum_n c_n [u_n/beta + sum_j j_j w_jn](y_k) - penetration = cos(y_k + e) - 1        at the N Chebyshev points y_k,     c_0 = 2 mean_pressure
is solved by Gaussian elimination. Edge amplitudes are sum(+-1)^n c_n (p ~ k/sqrt(2 sin a d)), the rest are Gauss-Chebyshev sums.
Without adhesion the half-width is given, and the eccentricity and mean pressure at which both amplitudes vanish follow linearly.
Adhesive equilibrium: half-width, mean pressure and process zone are given; each edge work (1/2 zone) int tension gap is a Gauss sum over the window of the
pressure of the contact collocated anew with that edge moved out (same penetration) times the gap of the contact; the secant method in the eccentricity makes
both equal, to 2 pi times the reduced work. The releases G/work of adhesion are differences of 1/2 int p w.
Full contact: friction half the loss modulus at the rate of the first harmonic, E(i kv) from the creep series.

Plain double precision and the standard library (mpmath only for printing). Every value is computed with N and with a larger N and finer panels;
`confirmed_digits` is their agreement relative to the `scale` of the quantity (at most 11).
    asked      given_edges, adhesiveless, equilibrium, full
    terms      j_j:zeta_j separated by blanks (1/beta is what is left of one), exact doubles
    a, e, mean_pressure   exact doubles for given_edges; for adhesiveless a is exact, for equilibrium a and mean_pressure; the others are values
    zone       length of the process zone of both edges (equilibrium), exact double
    quantity   penetration, friction_stress, interface_work, trailing_amplitude, leading_amplitude, pressure (at position y/a), gap (at the fraction
               `position` of the gap from the trailing edge backwards), eccentricity, mean_pressure, reduced_work, trailing_release, leading_release
"""

import sys

sys.dont_write_bytecode = True

import math
import multiprocessing
import time

from common import arguments, differences, double, finish, read, write

COMMAND = "python3 verification/references/sliding_wave.py"
FILE = "sliding_wave.csv"
COLUMNS = ["asked", "case", "terms", "a", "e", "mean_pressure", "zone", "quantity", "position", "value", "scale", "confirmed_digits"]
MOST_DIGITS = 11
PI = math.pi


def spectrum(beta, ratios, slope=0.0):
    """Compliances j_j that grow as zeta^slope and add up to 1 - 1/beta."""
    weights = [z ** slope for z in ratios]
    return [((1.0 - 1.0 / beta) * w / math.fsum(weights), z) for w, z in zip(weights, ratios)]


SOLIDS = {
    "one, slower": spectrum(10.0, [0.01]),
    "one, slow": spectrum(10.0, [0.05]),
    "one": spectrum(10.0, [0.6]),
    "one, fast": spectrum(4.0, [30.0]),
    "two": spectrum(20.0, [3.0, 0.3]),
    "six": spectrum(30.0, [30.0, 10.0, 3.0, 1.0, 0.3, 0.1], 0.2),
    "twelve": spectrum(15.0, [30.0 * 2.07 ** -k for k in range(12)], 0.1),
    "twelve, wide": spectrum(40.0, [1e6 * 4.5 ** -k for k in range(12)], 0.05),
}
# name, solid, a, e, mean pressure, N
GIVEN = [
    ("one, slower", 0.8, -0.15, 0.02, 250),
    ("one, slow", 0.9, -0.1, 0.05, 120),
    ("one", 1.2, 0.15, 0.2, 70),
    ("one, fast", 2.2, 0.02, -0.1, 110),
    ("two", 1.0, 0.1, 0.1, 70),
    ("six", 0.7, 0.05, 0.05, 90),
    ("twelve", 1.3, -0.04, 0.15, 110),
    ("twelve, wide", 0.8, 0.03, 0.1, 70),
]
SMOOTH = [("one", 0.8, 60), ("two", 1.1, 70), ("six", 0.6, 90), ("twelve", 1.0, 110)]
# name, a, mean pressure, zone, eccentricities to start from, N, additional nodes in the window (where a layer is thinner than it)
ADHESIVE = [("one", 1.0, 0.25, 0.005, (0.06, 0.07), 60, 0), ("two", 0.9, 0.2, 0.002, (-0.05, -0.04), 66, 0),
            ("one, slow", 0.7, 0.05, 0.02, (-0.1, -0.08), 110, 18), ("twelve", 0.9, 0.2, 0.003, (-0.05, -0.04), 96, 0)]
# The same, of further states; their cases are told apart by the half-width.
MORE = [("one", 0.5, 0.02, 0.02, (-0.07, -0.055), 60, 0), ("one", 0.7, 0.12, 0.01, (0.03, 0.042), 60, 0), ("one", 1.0, -0.05, 0.005, (-0.37, -0.356), 70, 0),
        ("one", 1.5, 0.3, 0.005, (-0.17, -0.157), 80, 0), ("one", 2.0, 0.7, 0.01, (0.02, 0.03), 90, 0), ("one, fast", 1.2, 0.2, 0.01, (0.004, 0.011), 60, 0),
        ("one, fast", 0.9, 0.1, 0.05, (0.002, 0.007), 60, 0), ("two", 0.6, 0.05, 0.01, (-0.1, -0.088), 66, 0), ("two", 1.3, 0.3, 0.005, (-0.17, -0.157), 76, 0),
        ("two", 1.7, 0.5, 0.01, (-0.21, -0.196), 84, 0), ("six", 0.9, 0.15, 0.01, (-0.16, -0.149), 100, 6), ("twelve", 1.3, 0.35, 0.01, (-0.14, -0.128), 110, 6),
        ("twelve, wide", 0.9, 0.15, 0.01, (-0.21, -0.2), 80, 0)]
INSIDE = [-0.95, -0.3, 0.4, 0.98]
OUTSIDE = [0.03, 0.5, 0.95]


def gauss(count):
    """Gauss-Legendre nodes and weights on (0, 1)."""
    out = []
    for k in range(1, count + 1):
        x = math.cos(PI * (k - 0.25) / (count + 0.5))
        for _ in range(100):
            p0, p1 = 1.0, x
            for m in range(2, count + 1):
                p0, p1 = p1, ((2 * m - 1) * x * p1 - (m - 1) * p0) / m
            slope = count * (x * p1 - p0) / (x * x - 1.0)
            step = p1 / slope
            x -= step
            if abs(step) < 1e-16:
                break
        out.append(((1.0 + x) / 2.0, 1.0 / ((1.0 - x * x) * slope * slope)))
    return out


class Elastic:
    """Displacements u_n of the pressures c_n = 1, modulus E0, zero mean over the period."""

    def __init__(self, a, count):
        self.a, self.count = a, count
        self.tangent = math.tan(a / 2.0)
        # int T_n log cos(h/2) dt/sqrt: log(1 + T^2 cos^2) = 2 log((1 + 1/cos(a/2))/2) + 2 sum (-1)^(k+1) q^k cos(2 k th)/k, q = tan^2(a/4).
        q = math.tan(a / 4.0) ** 2
        self.shift = [0.0] * count
        self.shift[0] = -PI * math.log((1.0 + 1.0 / math.cos(a / 2.0)) / 2.0)
        for k in range(1, (count + 1) // 2):
            self.shift[2 * k] = -0.5 * PI * (-1.0) ** (k + 1) * q ** k / k

    def inside(self, y):
        """u_n at |y| <= a."""
        t = max(-1.0, min(1.0, math.tan(y / 2.0) / self.tangent))
        out = [-(PI * (math.log(2.0 * self.tangent * math.cos(y / 2.0)) - math.log(2.0)) + self.shift[0]) / PI]
        previous, here = 1.0, t
        for n in range(1, self.count):
            out.append(here / n - self.shift[n] / PI)
            previous, here = here, 2.0 * t * here - previous
        return out

    def outside(self, from_leading, from_trailing):
        """u_n in the gap at the distances from both edges, which add up to 2 pi - 2 a."""
        near_leading = from_leading < from_trailing
        half = 0.5 * (self.a + min(from_leading, from_trailing))
        sine, cosine = math.sin(half), math.cos(half)
        # sin^2 - (T cos)^2 = sin((y - a)/2) sin((y + a)/2)/cos^2(a/2), from the distances.
        root = math.sqrt(math.sin(0.5 * from_leading) * math.sin(0.5 * from_trailing)) / math.cos(self.a / 2.0)
        out = [-(PI * (math.log(2.0 * (sine + root)) - math.log(2.0)) + self.shift[0]) / PI]
        # 1/rho = T cos/(sin + root), of the sign of t: positive near the leading edge.
        factor = self.tangent * cosine / (sine + root) * (1.0 if near_leading else -1.0)
        power = 1.0
        for n in range(1, self.count):
            power *= factor
            out.append(power / n - self.shift[n] / PI)
        return out


def combine(weights, vectors, count):
    out = [0.0] * count
    for w, v in zip(weights, vectors):
        if w != 0.0:
            for n in range(count):
                out[n] += w * v[n]
    return out


class Contact:
    """All displacement rows of a contact, for any eccentricity and mean pressure."""

    def __init__(self, terms, a, count, nodes):
        self.terms, self.a, self.count = terms, a, count
        self.rule = gauss(nodes)
        self.elastic = Elastic(a, count)
        self.glassy = 1.0 - math.fsum(j for j, _ in terms)
        self.points = sorted(2.0 * math.atan(self.elastic.tangent * math.cos(PI * (k + 0.5) / count)) for k in range(count))
        self.gap_points = self.panels(0.0)
        self.gap_values = [self.elastic.outside(d, r) for d, r, _ in self.gap_points]
        self.rows, self.at_trailing = self.displacement_rows()

    def panels(self, first):
        """(distance from the leading edge, from the trailing edge, weight) over the gap beyond `first`, both roots mapped away."""
        length = 2.0 * (PI - self.a)
        angles = {0.0, PI}
        for k in range(1, 10):
            angles |= {PI * 0.5 ** k, PI * (1.0 - 0.5 ** k)}
        for _, zeta in self.terms:
            for multiple in (0.25, 1.0, 3.0, 8.0, 16.0, 26.0, 40.0):
                part = (first + multiple * zeta) / length
                if part < 1.0:
                    angles.add(2.0 * math.asin(math.sqrt(part)))
        start = 2.0 * math.asin(math.sqrt(first / length))
        breaks = [start] + sorted(x for x in angles if x > start + 1e-9)
        out = []
        for low, high in zip(breaks[:-1], breaks[1:]):
            for node, weight in self.rule:
                half = 0.5 * (low + (high - low) * node)
                sine, cosine = math.sin(half), math.cos(half)
                out.append((length * sine * sine, length * cosine * cosine, weight * (high - low) * length * sine * cosine))
        return out

    def displacement_rows(self):
        """Rows sum_n of u_n/beta + sum_j j_j w_jn at the collocation points, and every w_j at the trailing edge."""
        count, a = self.count, self.a
        ends = [-a] + self.points + [a]
        pieces = []
        for low, high in zip(ends[:-1], ends[1:]):
            spots = [(low + (high - low) * node, weight * (high - low)) for node, weight in self.rule]
            pieces.append((low, high, spots, [self.elastic.inside(y) for y, _ in spots]))
        rows = [[self.glassy * u for u in self.elastic.inside(y)] for y in self.points]
        at_trailing = []
        length = 2.0 * (PI - a)
        for j, zeta in self.terms:
            out = combine([w * math.exp(-d / zeta) / zeta for d, _, w in self.gap_points], self.gap_values, count)
            parts = [combine([w * math.exp(-(y - low) / zeta) / zeta for y, w in spots], values, count) for low, _, spots, values in pieces]
            # From the leading edge to the trailing edge with nothing behind, then once around.
            march = out
            for (low, high, _, _), part in zip(reversed(pieces), reversed(parts)):
                decay = math.exp(-(high - low) / zeta)
                march = [decay * m + p for m, p in zip(march, part)]
            around = -math.expm1(-2.0 * PI / zeta)
            trailing = [m / around for m in march]
            at_trailing.append(trailing)
            decay = math.exp(-length / zeta)
            here = [o + decay * t for o, t in zip(out, trailing)]
            for index in range(count, 0, -1):
                low, high = ends[index], ends[index + 1]
                decay = math.exp(-(high - low) / zeta)
                here = [decay * h + p for h, p in zip(here, parts[index])]
                row = rows[index - 1]
                for n in range(count):
                    row[n] += j * here[n]
        return rows, at_trailing

    def displacement_outside(self, from_trailing):
        """The row at a point of the gap."""
        length = 2.0 * (PI - self.a)
        first = length - from_trailing
        row = [self.glassy * u for u in self.elastic.outside(first, from_trailing)]
        spots = self.panels(first)
        values = [self.elastic.outside(d, r) for d, r, _ in spots]
        for (j, zeta), trailing in zip(self.terms, self.at_trailing):
            part = combine([w * math.exp(-(d - first) / zeta) / zeta for d, _, w in spots], values, self.count)
            decay = math.exp(-from_trailing / zeta)
            for n in range(self.count):
                row[n] += j * (part[n] + decay * trailing[n])
        return row

    def solve(self, sides):
        """(c, penetration) for right-hand sides (values at the points, mean pressure)."""
        size = self.count + 1
        matrix = [row + [-1.0] for row in self.rows] + [[1.0] + [0.0] * self.count]
        columns = [[values[k] for k in range(self.count)] + [2.0 * mean] for values, mean in sides]
        solutions = eliminate(matrix, columns)
        return [(x[:self.count], x[size - 1]) for x in solutions]

    def basis(self):
        """Solutions for cos e, sin e and the mean pressure; the constant -1 belongs to the penetration."""
        cosines = [math.cos(y) for y in self.points]
        sines = [-math.sin(y) for y in self.points]
        return self.solve([(cosines, 0.0), (sines, 0.0), ([0.0] * self.count, 1.0)])

    def pressure(self, c, y):
        t = math.tan(y / 2.0) / self.elastic.tangent
        theta = math.acos(t)
        slope = 0.5 / (math.cos(y / 2.0) ** 2 * self.elastic.tangent)
        return math.fsum(value * math.cos(n * theta) for n, value in enumerate(c)) / math.sin(theta) * slope

    def integral(self, c, function):
        """int p function dy."""
        nodes = 4 * self.count
        total = []
        for k in range(nodes):
            theta = PI * (k + 0.5) / nodes
            y = 2.0 * math.atan(self.elastic.tangent * math.cos(theta))
            total.append(math.fsum(value * math.cos(n * theta) for n, value in enumerate(c)) * function(y))
        return math.fsum(total) * PI / nodes


def eliminate(matrix, columns):
    """Gaussian elimination with partial pivoting, and one step of refinement with exactly rounded residuals."""
    size = len(matrix)
    rows = [list(row) for row in matrix]
    order = list(range(size))
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        order[k], order[pivot] = order[pivot], order[k]
        head = rows[k]
        for i in range(k + 1, size):
            row = rows[i]
            factor = row[k] / head[k]
            row[k] = factor
            if factor != 0.0:
                for j in range(k + 1, size):
                    row[j] -= factor * head[j]

    def substitute(column):
        x = [column[i] for i in order]
        for i in range(size):
            x[i] -= math.fsum(rows[i][j] * x[j] for j in range(i))
        for i in range(size - 1, -1, -1):
            x[i] = (x[i] - math.fsum(rows[i][j] * x[j] for j in range(i + 1, size))) / rows[i][i]
        return x

    out = []
    for column in columns:
        x = substitute(column)
        residual = [math.fsum([column[i]] + [-matrix[i][j] * x[j] for j in range(size)]) for i in range(size)]
        out.append([a + b for a, b in zip(x, substitute(residual))])
    return out


def given_values(terms, a, e, mean, count, nodes):
    """{(quantity, position): (value, scale)}"""
    contact = Contact(terms, a, count, nodes)
    parts = [math.cos(e), math.sin(e), mean]
    solved = contact.basis()
    c = [math.fsum(f * s[0][n] for f, s in zip(parts, solved)) for n in range(count)]
    # Rows are sum c u - D = cos(y + e), D = penetration - 1.
    penetration = 1.0 + math.fsum(f * s[1] for f, s in zip(parts, solved))
    out = {}
    out["penetration", ""] = penetration, 1.0
    out["friction_stress", ""] = contact.integral(c, lambda y: math.sin(y + e)) / (2.0 * PI), 1.0
    out["interface_work", ""] = 0.5 * contact.integral(c, lambda y: math.cos(y + e) - 1.0 + penetration), 1.0
    leading, trailing = math.fsum(c), math.fsum(value * (-1.0) ** n for n, value in enumerate(c))
    scale = max(1.0, abs(leading), abs(trailing))
    out["trailing_amplitude", ""] = trailing, scale
    out["leading_amplitude", ""] = leading, scale
    for part in INSIDE:
        value = contact.pressure(c, part * a)
        out["pressure", part] = value, max(1.0, abs(value))
    for part in OUTSIDE:
        distance = part * 2.0 * (PI - a)
        row = contact.displacement_outside(distance)
        w = math.fsum(x * y for x, y in zip(row, c))
        # x = -a - distance (one period back) + e
        out["gap", part] = w - (math.cos(e - a - distance) - 1.0 + penetration), 1.0
    return out


class Solved:
    """A contact with given edges and penetration or mean pressure."""

    def __init__(self, terms, a, e, count, nodes, mean=None, penetration=None):
        self.contact, self.e = Contact(terms, a, count, nodes), e
        solved = self.contact.basis()
        parts = [math.cos(e), math.sin(e)]
        if mean is None:
            mean = (penetration - 1.0 - math.fsum(f * s[1] for f, s in zip(parts, solved))) / solved[2][1]
        parts.append(mean)
        self.mean = mean
        self.c = [math.fsum(f * s[0][n] for f, s in zip(parts, solved)) for n in range(count)]
        self.penetration = 1.0 + math.fsum(f * s[1] for f, s in zip(parts, solved)) if penetration is None else penetration

    def energy(self):
        return 0.5 * self.contact.integral(self.c, lambda y: math.cos(y + self.e) - 1.0 + self.penetration)

    def pressure_near(self, side, distance):
        """p at a distance inside an edge (side -1 trailing, +1 leading), the angle from the distance."""
        elastic = self.contact.elastic
        y = self.contact.a - distance
        # 1 - t = sin(distance/2)/(cos(y/2) cos(a/2))/T
        lack = math.sin(0.5 * distance) / (math.cos(0.5 * y) * math.cos(0.5 * self.contact.a) * elastic.tangent)
        theta = 2.0 * math.asin(math.sqrt(0.5 * lack))
        slope = 0.5 / (math.cos(0.5 * y) ** 2 * elastic.tangent)
        return math.fsum(value * side ** n * math.cos(n * theta) for n, value in enumerate(self.c)) / math.sin(theta) * slope

    def gap_near(self, side, distance):
        length = 2.0 * (PI - self.contact.a)
        row = self.contact.displacement_outside(distance if side < 0 else length - distance)
        x = self.e + side * (self.contact.a + distance)
        return math.fsum(u * v for u, v in zip(row, self.c)) - (math.cos(x) - 1.0 + self.penetration)


def equilibrium_values(terms, a, mean, zone, starts, count, nodes, more):
    window = gauss(nodes + more)

    def works(e):
        here = Solved(terms, a, e, count, nodes, mean=mean)
        out = []
        for side in (-1, 1):
            moved = Solved(terms, a + 0.5 * zone, e + 0.5 * side * zone, count, nodes, penetration=here.penetration)
            total = []
            for node, weight in window:
                theta = 0.5 * PI * node
                sine, cosine = math.sin(theta), math.cos(theta)
                # (1/2 zone) int tension(d) gap(zone - d) dd, d = zone sin^2
                tension = -moved.pressure_near(side, zone * sine * sine)
                total.append(0.5 * PI * weight * tension * here.gap_near(side, zone * cosine * cosine) * sine * cosine)
            out.append((math.fsum(total), (moved.energy() - here.energy()) / zone))
        return here, out

    low, high = starts
    here, first = works(low)
    below = first[0][0] - first[1][0]
    for _ in range(30):
        here, both = works(high)
        above = both[0][0] - both[1][0]
        # 1e-15 is the rounding of the works.
        if abs(above) < 1e-15 or abs(high - low) < 1e-14:
            break
        low, high, below = high, high - above * (high - low) / (above - below), above
    work = 0.5 * (both[0][0] + both[1][0])
    return {
        ("eccentricity", ""): (here.e, 1.0),
        ("reduced_work", ""): (work / (2.0 * PI), work / (2.0 * PI)),
        ("penetration", ""): (here.penetration, 1.0),
        ("trailing_release", ""): (both[0][1] / work, max(1.0, both[0][1] / work)),
        ("leading_release", ""): (both[1][1] / work, 1.0),
        ("friction_stress", ""): (here.contact.integral(here.c, lambda y: math.sin(y + here.e)) / (2.0 * PI), 1.0),
    }


def smooth_values(terms, a, count, nodes):
    contact = Contact(terms, a, count, nodes)
    (c1, d1), (c2, d2), (c3, d3) = contact.basis()

    def ends(c):
        return math.fsum(c), math.fsum(value * (-1.0) ** n for n, value in enumerate(c))
    (l1, t1), (l2, t2), (l3, t3) = ends(c1), ends(c2), ends(c3)
    # (cos e, sin e, mean) is across both rows of amplitudes.
    x, y, z = l2 * t3 - l3 * t2, l3 * t1 - l1 * t3, l1 * t2 - l2 * t1
    size = math.copysign(math.hypot(x, y), x)
    parts = [x / size, y / size, z / size]
    e, mean = math.atan2(parts[1], parts[0]), parts[2]
    c = [math.fsum(f * v for f, v in zip(parts, values)) for values in zip(c1, c2, c3)]
    out = {}
    out["eccentricity", ""] = e, 1.0
    out["mean_pressure", ""] = mean, 1.0
    out["penetration", ""] = 1.0 + math.fsum(f * d for f, d in zip(parts, (d1, d2, d3))), 1.0
    out["friction_stress", ""] = contact.integral(c, lambda y: math.sin(y + e)) / (2.0 * PI), 1.0
    return out


def full_values(terms):
    real, imaginary = 1.0 - math.fsum(j for j, _ in terms), 0.0
    for j, zeta in terms:
        real += j / (1.0 + zeta * zeta)
        imaginary += j * zeta / (1.0 + zeta * zeta)
    return {("friction_stress", ""): (0.5 * imaginary / (real * real + imaginary * imaginary), 1.0)}


def agreement(coarse, fine, scale):
    difference = abs(coarse - fine) / scale
    return MOST_DIGITS if difference == 0.0 else max(0, min(MOST_DIGITS, int(-math.log10(difference))))


def rows_of(asked, case, terms, a, e, mean, coarse, fine, zone=None):
    text = " ".join(f"{double(j)}:{double(z)}" for j, z in terms)
    out = []
    for (quantity, position), (value, scale) in fine.items():
        out.append({
            "asked": asked, "case": case, "terms": text, "a": "" if a is None else double(a), "e": "" if e is None else double(e),
            "mean_pressure": "" if mean is None else double(mean), "zone": "" if zone is None else double(zone), "quantity": quantity, "position": "" if position == "" else double(position),
            "value": f"{value:.14e}", "scale": f"{scale:.3e}", "confirmed_digits": agreement(coarse[quantity, position][0], value, scale),
        })
    return out


def job(task):
    asked, solid = task[0], task[1]
    terms = SOLIDS[solid]
    if asked == "given_edges":
        a, e, mean, count = task[2:]
        coarse, fine = (given_values(terms, a, e, mean, n, q) for n, q in ((count, 10), (count + count // 3, 14)))
        return rows_of(asked, solid, terms, a, e, mean, coarse, fine)
    if asked == "adhesiveless":
        a, count = task[2:]
        coarse, fine = (smooth_values(terms, a, n, q) for n, q in ((count, 10), (count + count // 3, 14)))
        return rows_of(asked, solid, terms, a, None, None, coarse, fine)
    if asked == "equilibrium":
        a, mean, zone, starts, count, more = task[2:8]
        coarse, fine = (equilibrium_values(terms, a, mean, zone, starts, n, q, more) for n, q in ((count, 10), (count + count // 4, 14)))
        return rows_of(asked, f"{solid}, a = {a}" if len(task) > 8 else solid, terms, a, None, mean, coarse, fine, zone)
    values = full_values(terms)
    return rows_of(asked, solid, terms, None, None, None, values, values)


def tasks(reduced):
    given, smooth = (GIVEN[2:5], SMOOTH[:2]) if reduced else (GIVEN, SMOOTH)
    adhesive = [] if reduced else [("equilibrium", *case) for case in ADHESIVE] + [("equilibrium", *case, "more") for case in MORE]
    return [("given_edges", *case) for case in given] + [("adhesiveless", *case) for case in smooth] + adhesive + [("full", name) for name in SOLIDS]


def self_check():
    """The elastic rows against the kernel by brute force, and the elastic contact against Westergaard and Johnson."""
    wrong = []
    elastic = Elastic(0.9, 8)
    for y, spots in ((0.4, None), (2.0, (1.1, 2.0 * PI - 1.8 - 1.1)), (-1.3, (2.0 * (PI - 0.9) - 0.4, 0.4))):
        row = elastic.inside(y) if spots is None else elastic.outside(*spots)
        for n in (0, 1, 2, 5):
            # -(1/pi) int log|2 sin((y - h)/2)| T_n dt/sqrt by the midpoint rule, its error at a logarithm 1/N: two counts extrapolated.
            def rule(nodes):
                total = []
                for k in range(nodes):
                    theta = PI * (k + 0.5) / nodes
                    h = 2.0 * math.atan(elastic.tangent * math.cos(theta))
                    total.append(math.log(abs(2.0 * math.sin((y - h) / 2.0))) * math.cos(n * theta))
                return -math.fsum(total) / nodes
            error = abs(rule(200001) - row[n])
            if error > (1e-4 if spots is None else 1e-12):
                wrong.append(f"elastic displacement n = {n} at {y}: {rule(200001)} {row[n]}")
    values = given_values([], 1.1, 0.0, 0.2, 24, 10)
    s = math.sin(0.55)
    expected = 1.0 - (1.0 - s * s + 2.0 * s * s * math.log(s)) - 2.0 * (0.2 - s * s) * math.log(s)
    if abs(values["penetration", ""][0] - expected) > 1e-13:
        wrong.append(f"elastic penetration {values['penetration', ''][0]} {expected}")
    smooth = smooth_values([], 1.3, 40, 10)
    if abs(smooth["mean_pressure", ""][0] - math.sin(0.65) ** 2) > 1e-13:
        wrong.append(f"Westergaard {smooth}")
    return wrong


def main():
    options = arguments("Steady sliding contacts on a wave by collocation.")
    start = time.time()
    if options.self_check:
        finish(self_check(), start, "self-check")
    todo = tasks(options.reduced)
    if options.jobs > 1:
        with multiprocessing.Pool(options.jobs) as pool:
            rows = [row for part in pool.map(job, todo, chunksize=1) for row in part]
    else:
        rows = [row for task in todo for row in job(task)]
    if options.check:
        wrong = differences(FILE, read(FILE), rows, ["asked", "case", "quantity", "position"])
        finish(wrong, start, f"check of {len(rows)} rows")
    write(FILE, COMMAND, "steady sliding contacts on a wave by collocation of the integral equation (thesis 3.23, 3.24)", COLUMNS, rows,
          precision="double precision, Chebyshev collocation; confirmed with a third more points and finer panels")
    print(f"fewest confirmed digits {min(r['confirmed_digits'] for r in rows)}, written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
