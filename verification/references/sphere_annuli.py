"""The sphere by dense annuli on the raw equation (thesis 4.1), prescribed edges and the closed loop; writes or checks sphere_annuli.csv.

Independent of the solver: nothing is reduced to a line, no Abel transform, no spring chain of a place. With u the displacement into the half-space,
    u(r, t) = J(0) v(r, t) + int J'(t - t1) v(r, t1) dt1,    v(r, t) = int G(r, r1) p(r1, t) dr1,    J = 1/glassy + sum J_j (1 - e^(-t/tau_j)),
p is constant on annuli of width h; G is the displacement under a uniform disk, outer less inner (thesis 4.15, SciPy's ellipe and ellipkm1). In the
contact u = depth - shape(r) is collocated at the middles, a dense system at every step, pressures vanish outside. The memory of a term,
    u_j' = (J_j v - u_j)/tau_j,   is exact for v linear within a step;
the edge passes one annulus a step (or RESTING steps go by where it rests), so time and place are refined together. Everything then has an
expansion in h, h^2, h^3, ...: four or five meshes, h halved, are extrapolated (Richardson). `by_mesh` holds the raw values, coarsest first; `observed_order` is
log2 of the ratio of the last two differences of raw values (1 expected); `change` is |value - the extrapolation that leaves the coarsest mesh out|/scale.

kind prescribed   radius and depth go linearly from row to row of `path` (radius,depth,duration; first row the start, from a `relaxed` or an `untouched`
                  glassy contact). Quantities at the end of each row: force; displacement at a radius `place`; zone_work, the closure (thesis 4.9)
                  (1/2 delta) sum p(a - d) gap(a - d + delta) h with delta = `zone`.
kind closed       the closure equals `work` at each passed annulus: the depth follows the `speed` from the contact that is in equilibrium with radius
                  `start_radius`, and each step takes the time at which the closure holds. Approach: until the edge is at `turn`; then the retraction.
                  Quantities: penetration at the start and at the turn (inputs of the comparison); force and contact_radius at times since the
                  start, or since the turn, by cubic interpolation between passed annuli.
Inputs are doubles. `scale` is the largest magnitude of the quantity in its history. Double precision; needs numpy and scipy.
"""

import sys

sys.dont_write_bytecode = True

import math
import time as clock

from common import arguments, double, finish, read, write

COMMAND = "python3 verification/references/sphere_annuli.py"
FILE = "sphere_annuli.csv"
COLUMNS = ["kind", "case", "material", "shape", "size", "start", "path", "zone", "work", "speed", "instant", "time", "quantity", "place", "value", "scale",
           "change", "observed_order", "by_mesh", "confirmed_digits", "independence"]
COARSEST = 6            # annuli per process zone on the coarsest mesh of prescribed edges, of MESHES
MESHES = 4
COARSEST_CLOSED = 2     # the same for the closed loop
MESHES_CLOSED = 5
RESTING = 24            # steps of a row in which the edge rests, on the coarsest mesh

# glassy modulus; J_j, tau_j
ONE = (10.0, ((0.9, 10.0),))
SOFT = (2.0, ((0.5, 1.3),))
TWO = (20.0, ((0.5, 4.0), (0.45, 0.3)))
THREE = (8.0, ((0.2, 0.05), (0.375, 1.0), (0.3, 12.0)))
RUBBER = (3.4e6, ((2.1e-7, 3e-4), (4.4e-7, 0.02), (3.1e-7, 1.7)))


def numpy():
    try:
        import numpy as np
        import scipy
        import scipy.linalg as linalg
        from scipy.special import ellipe, ellipkm1
    except ImportError:
        sys.exit("sphere_annuli.py needs numpy and scipy (Debian: apt-get install python3-numpy python3-scipy)")
    return np, linalg, ellipe, ellipkm1, f"numpy {np.__version__}, scipy {scipy.__version__}, generator version 1.0.0"


class HalfSpace:
    """Annuli of a width up to a radius, and what their pressures displace at their middles and at further places."""

    def __init__(self, width, count, further=()):
        np, self.linalg, ellipe, ellipkm1, _ = numpy()
        self.np, self.width, self.count = np, width, count
        rim = np.arange(count + 1) * width
        self.middles = rim[:-1] + 0.5 * width
        self.places = np.concatenate([self.middles, np.asarray(further, dtype=float)])
        self.areas = np.pi * (rim[1:] ** 2 - rim[:-1] ** 2)
        r, b = np.broadcast_arrays(self.places[:, None], rim[None, 1:])
        inside = r <= b
        ratio = np.minimum(r, b) / np.maximum(r, b)
        left = (1.0 - ratio) * (1.0 + ratio)
        second = ellipe(ratio * ratio)
        first = ellipkm1(np.where(left > 0.0, left, 1.0))      # its factor vanishes where left does
        disks = np.where(inside, 4.0 * b / np.pi * second, 4.0 * r / np.pi * (second - left * first))
        self.kernel = np.diff(np.concatenate([np.zeros((len(self.places), 1)), disks], axis=1), axis=1)


class Contact:
    """Pressures, their elastic displacement v and the memory of every term at all places."""

    def __init__(self, space, material, shape, radius, depth, relaxed):
        np = space.np
        self.space, self.glassy = space, 1.0 / material[0]
        self.terms = [(strength, time) for strength, time in material[1]]
        self.rise = shape(space.places)
        self.n = round(radius / space.width)
        total = self.glassy + (sum(s for s, _ in self.terms) if relaxed else 0.0)
        self.pressure = np.linalg.solve(space.kernel[:self.n, :self.n], (depth - self.rise[:self.n]) / total)
        self.v = space.kernel[:, :self.n] @ self.pressure
        self.memory = [s * self.v if relaxed else 0.0 * self.v for s, _ in self.terms]
        self.depth = depth

    def prepared(self, n):
        """LU of the contact of n annuli."""
        return self.space.linalg.lu_factor(self.space.kernel[:n, :n], check_finite=False)

    def stepped(self, n, depth, step, factors):
        """(pressures, v, memories) after a step to n annuli."""
        now, kept, parts = self.glassy, 0.0, []
        for (strength, time), memory in zip(self.terms, self.memory):
            x = step / time
            fade = math.exp(-x)
            mean = -math.expm1(-x) / x if x > 1e-5 else 1.0 - x / 2.0 + x * x / 6.0
            new, old = (1.0 - mean, mean - fade) if x > 1e-5 else (x / 2.0 - x * x / 6.0, x / 2.0 - x * x / 3.0)
            now += strength * new
            base = fade * memory + (strength * old) * self.v
            kept = kept + base
            parts.append((base, strength * new))
        pressure = self.space.linalg.lu_solve(factors, (depth - self.rise[:n] - kept[:n]) / now, check_finite=False)
        v = self.space.kernel[:, :n] @ pressure
        return pressure, v, [base + new * v for base, new in parts]

    def take(self, n, depth, found):
        self.n, self.depth = n, depth
        self.pressure, self.v, self.memory = found

    def force(self, pressure=None):
        pressure = self.pressure if pressure is None else pressure
        return float(self.space.areas[:len(pressure)] @ pressure)

    def displacement(self, v=None, memory=None):
        v, memory = (self.v, self.memory) if v is None else (v, memory)
        return self.glassy * v + sum(memory)

    def zone_work(self, annuli, pressure=None, depth=None, v=None, memory=None):
        """(1/2 delta) sum tension(a - d) gap(a - d + delta) h over the annuli of the zone."""
        if pressure is None:
            pressure, depth, v, memory = self.pressure, self.depth, self.v, self.memory
        n = len(pressure)
        gap = self.displacement(v, memory)[n:n + annuli] - depth + self.rise[n:n + annuli]
        return -0.5 / annuli * float(pressure[n - annuli:] @ gap)


SHAPES = {"paraboloid": lambda size: lambda r: r * r / (2.0 * size), "cone": lambda size: lambda r: r * size}


# ---------------------------------------------------------------- prescribed edges

def prescribed_cases():
    """name, material, shape, size, start, path, zone; every radius is a multiple of the coarsest annulus, a `COARSEST` part of the zone."""
    # Reduced sphere, R = E0* = 1.
    yield "retraction", ONE, "paraboloid", 1.0, "relaxed", [(0.24, 0.032, 0.0), (0.2, 0.02, 1.0), (0.16, 0.0, 1.0)], 0.012
    yield "slow retraction", ONE, "paraboloid", 1.0, "relaxed", [(0.24, 0.032, 0.0), (0.2, 0.022, 15.0), (0.16, 0.008, 15.0)], 0.012
    yield "fast retraction", ONE, "paraboloid", 1.0, "relaxed", [(0.24, 0.032, 0.0), (0.2, 0.01, 0.05), (0.16, -0.02, 0.05)], 0.012
    yield "approach", ONE, "paraboloid", 1.0, "untouched", [(0.08, 0.0, 0.0), (0.16, 0.012, 1.0), (0.24, 0.04, 1.0)], 0.012
    yield "slow approach", ONE, "paraboloid", 1.0, "untouched", [(0.08, 0.003, 0.0), (0.16, 0.02, 20.0), (0.24, 0.05, 20.0)], 0.012
    yield "approach and return", ONE, "paraboloid", 1.0, "untouched", [(0.08, 0.0, 0.0), (0.24, 0.04, 1.0), (0.12, -0.01, 0.6)], 0.012
    yield "return and approach", ONE, "paraboloid", 1.0, "relaxed", [(0.24, 0.032, 0.0), (0.16, 0.01, 0.8), (0.28, 0.05, 0.8)], 0.012
    yield "rest of a fresh contact", ONE, "paraboloid", 1.0, "untouched", [(0.2, 0.03, 0.0), (0.2, 0.03, 2.0), (0.2, 0.02, 2.0)], 0.012
    yield "three ways", ONE, "paraboloid", 1.0, "relaxed", [(0.2, 0.03, 0.0), (0.28, 0.06, 1.0), (0.28, 0.05, 1.0), (0.16, 0.0, 0.5)], 0.012
    yield "soft, retraction", SOFT, "paraboloid", 1.0, "relaxed", [(0.3, 0.07, 0.0), (0.21, 0.03, 0.7), (0.15, 0.0, 1.1)], 0.03
    yield "soft, approach and rest", SOFT, "paraboloid", 1.0, "untouched", [(0.09, 0.005, 0.0), (0.24, 0.04, 0.9), (0.24, 0.04, 1.4)], 0.03
    yield "two, retraction", TWO, "paraboloid", 1.0, "relaxed", [(0.24, 0.035, 0.0), (0.2, 0.02, 0.3), (0.16, 0.0, 0.4)], 0.012
    yield "two, approach and return", TWO, "paraboloid", 1.0, "untouched", [(0.12, 0.01, 0.0), (0.24, 0.05, 0.5), (0.16, 0.0, 0.4)], 0.012
    yield "two, return and approach", TWO, "paraboloid", 1.0, "relaxed", [(0.24, 0.035, 0.0), (0.16, 0.01, 0.4), (0.24, 0.035, 2.0)], 0.012
    yield "three, retraction", THREE, "paraboloid", 1.0, "relaxed", [(0.24, 0.04, 0.0), (0.2, 0.02, 0.2), (0.14, -0.01, 0.6)], 0.012
    yield "three, approach", THREE, "paraboloid", 1.0, "untouched", [(0.08, 0.0, 0.0), (0.16, 0.015, 0.2), (0.24, 0.04, 2.0)], 0.012
    yield "three, approach rest return", THREE, "paraboloid", 1.0, "untouched", [(0.08, 0.0, 0.0), (0.24, 0.03, 1.0), (0.24, 0.03, 2.0), (0.12, -0.01, 0.3)], 0.012
    yield "three, two returns", THREE, "paraboloid", 1.0, "relaxed", [(0.24, 0.04, 0.0), (0.18, 0.02, 0.3), (0.24, 0.03, 0.3), (0.16, 0.0, 0.3)], 0.012
    # SI.
    yield "rubber, retraction", RUBBER, "paraboloid", 3.1e-3, "relaxed", [(6e-4, 8e-5, 0.0), (4.8e-4, 4e-5, 0.01), (4e-4, 1e-5, 0.05)], 6e-5
    yield "rubber, approach and return", RUBBER, "paraboloid", 3.1e-3, "untouched", [(2e-4, 2e-6, 0.0), (6e-4, 8e-5, 0.1), (4e-4, 2e-5, 0.02)], 6e-5
    yield "rubber, slow", RUBBER, "paraboloid", 3.1e-3, "relaxed", [(4e-4, 3e-5, 0.0), (6e-4, 9e-5, 3.0), (5e-4, 5e-5, 5.0)], 6e-5
    # Cones.
    yield "cone, retraction", ONE, "cone", 0.21, "relaxed", [(0.24, 0.09, 0.0), (0.2, 0.06, 0.5), (0.16, 0.02, 0.5)], 0.012
    yield "cone, approach and return", THREE, "cone", 0.21, "untouched", [(0.08, 0.02, 0.0), (0.24, 0.09, 1.0), (0.16, 0.03, 0.4)], 0.012
    yield "cone, two", TWO, "cone", 0.13, "relaxed", [(0.2, 0.05, 0.0), (0.16, 0.03, 0.2), (0.24, 0.06, 1.0)], 0.012


def whole(x, unit):
    count = round(x / unit)
    assert abs(count * unit - x) < 1e-9 * x, (x, unit)
    return count


def prescribed(case, refinement):
    """{(row, quantity, place): value} on a mesh."""
    name, material, shape, size, start, path, zone = case
    coarse = zone / COARSEST
    radii = [row[0] for row in path]
    width = coarse / refinement
    largest = max(radii)
    count = whole(largest, coarse) * refinement + whole(zone, coarse) * refinement
    # Places on rims of the coarsest mesh, away from the edges asked for: beyond the contact, and where it has been or will be.
    out = largest + 7 * coarse
    passed = round((0.5 * (min(radii) + largest)) / coarse) * coarse
    watched = all(abs(passed - radius) > 2.5 * coarse for radius in radii)
    space = HalfSpace(width, count, [out, passed])
    contact = Contact(space, material, SHAPES[shape](size), path[0][0], path[0][1], start == "relaxed")
    values, radius, depth = {}, path[0][0], path[0][1]
    for index, (new_radius, new_depth, duration) in enumerate(path[1:]):
        before, after = round(radius / width), round(new_radius / width)
        steps = abs(after - before) or RESTING * refinement
        resting = contact.prepared(before) if after == before else None
        for step in range(1, steps + 1):
            n = before + (after - before) * step // steps if after != before else before
            here = depth + (new_depth - depth) * step / steps
            contact.take(n, here, contact.stepped(n, here, duration / steps, resting or contact.prepared(n)))
        radius, depth = new_radius, new_depth
        surface = contact.displacement()
        values[index, "force", ""] = contact.force()
        values[index, "zone_work", ""] = contact.zone_work(whole(zone, coarse) * refinement)
        values[index, "displacement", double(out)] = float(surface[-2])
        if watched and passed > new_radius:
            values[index, "displacement", double(passed)] = float(surface[-1])
    return values


# ---------------------------------------------------------------- closed loop

def closed_cases():
    """name, material, R, work, zone, start, start radius in zones, turn in zones (0 for none), last radius in zones, speed"""
    work = 1.6e-4 * math.pi
    yield "closed, retraction", ONE, 1.0, work, 0.013, "relaxed", 19, 0, 13, 2e-3
    yield "closed, fast retraction", ONE, 1.0, work, 0.013, "relaxed", 19, 0, 13, 2e-2
    yield "closed, three, retraction", THREE, 1.0, work, 0.013, "relaxed", 19, 0, 13, 2e-3
    yield "closed, approach", ONE, 1.0, work, 0.013, "untouched", 6, 0, 14, 2e-3
    yield "closed, three, approach", THREE, 1.0, work, 0.013, "untouched", 6, 0, 14, 5e-3
    yield "closed, approach and return", ONE, 1.0, work, 0.013, "untouched", 6, 14, 10, 4e-3


def depth_in_equilibrium(space, shape, n, annuli, modulus, work):
    """The depth at which the elastic contact of n annuli does the work of adhesion: a quadratic, of which tension picks the smaller root."""
    np = space.np
    rise = shape(space.places)
    solved = np.linalg.solve(space.kernel[:n, :n], np.stack([np.ones(n), rise[:n]], axis=1)) * modulus
    surface = space.kernel[n:n + annuli, :n] @ solved / modulus
    tail = solved[n - annuli:]
    # tension = -(d p1 - p2), gap = (d w1 - w2) - d + z.
    gap = [surface[:, 0] - 1.0, rise[n:n + annuli] - surface[:, 1]]
    coefficients = [-0.5 / annuli * float(c) for c in
                    (tail[:, 0] @ gap[0], tail[:, 0] @ gap[1] - tail[:, 1] @ gap[0], -(tail[:, 1] @ gap[1]))]
    quadratic, linear, constant = coefficients[0], coefficients[1], coefficients[2] - work
    roots = sorted(((-linear + sign * math.sqrt(linear * linear - 4.0 * quadratic * constant)) / (2.0 * quadratic)) for sign in (-1.0, 1.0))
    return roots[0]


def closed(case, refinement):
    """(depth at the start, at the turn, tables of passed annuli: time, radius, force) on a mesh."""
    name, material, size, work, zone, start, first, turn, last, speed = case
    annuli = COARSEST_CLOSED * refinement
    width = zone / annuli
    count = (max(first, turn, last) + 1) * annuli
    from scipy.optimize import brentq
    space = HalfSpace(width, count)
    shape = SHAPES["paraboloid"](size)
    relaxed = start == "relaxed"
    modulus = 1.0 / (1.0 / material[0] + (sum(s for s, _ in material[1]) if relaxed else 0.0))
    begin = depth_in_equilibrium(space, shape, first * annuli, annuli, modulus, work)
    contact = Contact(space, material, shape, first * zone, begin, relaxed)
    time, turned = 0.0, None
    rows = [(0.0, first * zone, contact.force())]
    goals = [turn, last] if turn else [last]
    for goal in goals:
        onward = 1 if goal * annuli > contact.n else -1
        while contact.n != goal * annuli:
            n, depth = contact.n + onward, contact.depth
            factors = contact.prepared(n)

            def excess(step):
                found = contact.stepped(n, depth + onward * speed * step, step, factors)
                return contact.zone_work(annuli, found[0], depth + onward * speed * step, found[1], found[2]) / work - 1.0

            # From no time on to the first change of sign.
            low, high = 0.0, 1e-3 * width / speed
            sign = math.copysign(1.0, excess(high * 1e-6))
            while excess(high) * sign > 0.0:
                low, high = high, 1.5 * high
                if high * speed > size:
                    raise RuntimeError(f"{name}: the closure is never met")
            step = brentq(excess, low, high, xtol=1e-15 * high, rtol=1e-13)
            time += step
            contact.take(n, depth + onward * speed * step, contact.stepped(n, depth + onward * speed * step, step, factors))
            rows.append((time, n * width, contact.force()))
        if turn and turned is None:
            turned = (time, contact.depth, len(rows) - 1)
    return begin, turned, rows


def interpolated(rows, t, first, last):
    """Radius and force at a time by a cubic through passed annuli of one stretch."""
    near = max(first, min(last - 3, next(i for i in range(first, last + 1) if rows[i][0] >= t) - 2))
    table = rows[near:near + 4]
    out = []
    for column in (1, 2):
        out.append(math.fsum(table[i][column] * math.prod((t - table[j][0]) / (table[i][0] - table[j][0]) for j in range(4) if j != i) for i in range(4)))
    return out


# ---------------------------------------------------------------- extrapolation and rows

def extrapolated(values):
    """Richardson in h, h^2, ...: (value, change without the finest mesh, observed order)."""
    def last(column):
        for power in range(1, len(column)):
            column = [(2 ** power * b - a) / (2 ** power - 1) for a, b in zip(column, column[1:])]
        return column[-1]
    ratio = abs((values[-2] - values[-3]) / (values[-1] - values[-2])) if values[-1] != values[-2] else 0.0
    return last(values), abs(last(values) - last(values[1:])), (math.log2(ratio) if ratio > 0.0 else 0.0)


def row(values, scale, **columns):
    value, change, order = extrapolated(values)
    digits = max(0, min(9, int(-math.log10(max(change / scale, 1e-12)))))
    return dict(columns, value=f"{value:.12e}", scale=f"{scale:.3e}", change=f"{change / scale:.1e}", observed_order=f"{order:.2f}",
                by_mesh=" ".join(f"{v:.9e}" for v in values), confirmed_digits=digits, independence="independent")


def text_of(material):
    return ";".join([double(material[0])] + [f"{double(j)},{double(tau)}" for j, tau in material[1]])


def prescribed_rows(cases, meshes):
    out = []
    for case in cases:
        name, material, shape, size, start, path, zone = case
        found = [prescribed(case, 2 ** k) for k in range(meshes)]
        for key in found[0]:
            index, quantity, place = key
            scale = max(abs(value) for (_, other, _), value in found[-1].items() if other == quantity)
            out.append(row([values[key] for values in found], scale, kind="prescribed", case=name, material=text_of(material), shape=shape, size=double(size),
                           start=start, path=";".join(",".join(map(double, part)) for part in path), zone=double(zone), instant=index,
                           quantity=quantity, place=place))
    return out


def closed_rows(cases, meshes):
    out = []
    for case in cases:
        name, material, size, work, zone, start, first, turn, last, speed = case
        found = [closed(case, 2 ** k) for k in range(meshes)]
        common = dict(kind="closed", case=name, material=text_of(material), shape="paraboloid", size=double(size), start=start, zone=double(zone),
                      work=double(work), speed=double(speed))
        out.append(row([begin for begin, _, _ in found], size * (first * zone / size) ** 2, instant=0, quantity="start_penetration", **common))
        if turn:
            out.append(row([turned[1] for _, turned, _ in found], size * (turn * zone / size) ** 2, instant=0, quantity="turn_penetration", **common))
        # (time, row) where the stretch that is asked about begins: the turn has its own time on each mesh.
        begins = [(turned[0], turned[2]) if turn else (0.0, 0) for _, turned, _ in found]
        whole_span = found[-1][2][-1][0] - begins[-1][0]
        tension = max(abs(force) for _, _, force in found[-1][2])
        for index, part in enumerate((0.5, 0.7, 0.9)):
            t = float(f"{part * whole_span:.3g}")
            values = []
            for (_, _, table), (origin, place) in zip(found, begins):
                values.append(interpolated([(a - origin, b, c) for a, b, c in table], t, place, len(table) - 1))
            for column, quantity, scale in ((0, "contact_radius", values[-1][0]), (1, "force", tension)):
                out.append(row([v[column] for v in values], scale, instant=index + 1, time=double(t), quantity=quantity, **common))
    return out


def rows(reduced):
    prescribed_list, closed_list = list(prescribed_cases()), list(closed_cases())
    if reduced:
        # The same cases on the same meshes give the same digits; a few of them.
        prescribed_list, closed_list = [prescribed_list[0], prescribed_list[9], prescribed_list[19]], closed_list[3:4]
    return prescribed_rows(prescribed_list, MESHES) + closed_rows(closed_list, MESHES_CLOSED)


def self_check():
    """A flat-ended limit that is known: Boussinesq's punch, F = 2 E* a depth, and a uniform disk at its middle, 2 b/E*."""
    wrong = []
    space = HalfSpace(0.0125, 80, [0.0, 3.0])
    np = space.np
    pressure = np.linalg.solve(space.kernel[:80, :80], np.ones(80))
    finer = HalfSpace(0.00625, 160)
    other = float(finer.areas @ np.linalg.solve(finer.kernel, np.ones(160)))
    force = 2.0 * other - float(space.areas @ pressure)
    if abs(force / 2.0 - 1.0) > 1e-4:
        wrong.append(f"flat punch: {force} instead of 2")
    middle = float(space.kernel[80].sum())
    if abs(middle - 2.0) > 1e-12:
        wrong.append(f"uniform disk: {middle} instead of 2")
    # Far away a disk is a point load: its area/(pi r).
    if abs(float(space.kernel[81].sum()) * 3.0 - 1.0) > 0.02:
        wrong.append("far field")
    return wrong


def main():
    options = arguments("The sphere by dense annuli.")
    start = clock.time()
    if options.self_check:
        finish(self_check(), start, "sphere_annuli.py --self-check")
    fresh = rows(options.check and options.reduced)
    if options.check:
        stored = read(FILE)
        keys = ["case", "instant", "quantity", "place"]
        known = {tuple(r[k] for k in keys): r for r in stored}
        wrong = []
        for r in fresh:
            old = known.get(tuple(str(r.get(k, "")) for k in keys))
            if old is None:
                wrong.append(f"{FILE}: {r['case']} {r['instant']} {r['quantity']} is not in the file")
            elif abs(float(old["value"]) - float(r["value"])) > 3.0 * 10.0 ** -int(old["confirmed_digits"]) * float(old["scale"]):
                wrong.append(f"{FILE}: {r['case']} {r['instant']} {r['quantity']}: file {old['value']}, recomputed {r['value']}")
        finish(wrong, start, f"sphere_annuli.py --check of {len(fresh)} rows")
    write(FILE, COMMAND, "contacts of axisymmetric indenters by dense annuli on the raw equation (thesis 4.1, 4.9)", COLUMNS, fresh,
          precision="double precision; four or five meshes extrapolated, confirmed by leaving the coarsest out", tool=numpy()[4])


if __name__ == "__main__":
    main()
