"""All steady sliding contacts of a held load, by collocation and a scan; writes or checks sliding_held_loads.csv.

Independent of the solver: the integral equation is collocated as in sliding_wave.py (Chebyshev pressures, every creep term by its exponential memory), here with
NumPy; nothing is followed from a known contact. At a half-width a every field is linear in u = (cos e, sin e, p), so the work of each edge is a quadratic form in u.
For each eccentricity of a fine grid over -pi < e < pi both edges give two mean pressures each; where one of the trailing edge crosses one of the leading edge both
edges are in equilibrium. Kept are those whose edges are pulled (in the contact and in both contacts with a moved edge) and whose faces do not meet.
Over a grid of half-widths these contacts form curves p(a), e(a). A held load is met where p(a) crosses it; a limit is an extreme of p(a).
The Chebyshev points leave the trough to the last: half-widths above 2.8 converge slowly, and their confirmed digits say so.
A contact is stable under its load if the matrix d(work_i)/d(edge j) at fixed load has positive diagonal and determinant (theory: section 8), by differences of
collocated works.

    asked      contact (of a held load), limit (an extreme of the load next to stable contacts: a minimum is pull-off, a maximum snap-in)
    case       name of the problem
    terms      j_j:zeta_j separated by blanks, exact doubles
    trailing_work, leading_work, zone   reduced works of adhesion and zone of both edges, exact doubles (zero: without adhesion)
    held       the mean pressure that is held, an exact double; of a limit blank
    quantity   half_width, eccentricity, friction_stress, penetration, stable (1 or 0: under the load); stable_contacts (how many carry the load); mean_pressure (limits)
    index      contacts of a load by growing half-width; limits by their kind and number
"""

import sys

sys.dont_write_bytecode = True

import math
import multiprocessing
import time
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import brentq, minimize_scalar

from common import arguments, differences, double, finish, read, write

PI = math.pi
COMMAND = "python3 verification/references/sliding_held_loads.py"
FILE = "sliding_held_loads.csv"
COLUMNS = ["asked", "case", "terms", "trailing_work", "leading_work", "zone", "held", "quantity", "index", "value", "confirmed_digits"]


class Elastic:
    """Displacements of the pressures T_n dt/sqrt(1 - t^2), t = tan(y/2)/tan(a/2), modulus one, zero mean."""

    def __init__(self, a, count):
        self.a, self.tangent, self.orders = a, math.tan(0.5 * a), np.arange(count)
        q = math.tan(0.25 * a) ** 2
        shift = np.zeros(count)
        shift[0] = -PI * math.log(0.5 * (1.0 + 1.0 / math.cos(0.5 * a)))
        even = np.arange(1, (count + 1) // 2)
        shift[2 * even] = 0.5 * PI * (-1.0) ** even * q ** even / even
        self.shift = shift
        self.over = 1.0 / np.maximum(self.orders, 1)

    def inside(self, y):
        t = np.clip(np.tan(0.5 * y) / self.tangent, -1.0, 1.0)
        out = np.cos(np.outer(np.arccos(t), self.orders)) * self.over - self.shift / PI
        out[:, 0] = -np.log(self.tangent * np.cos(0.5 * y)) - self.shift[0] / PI
        return out

    def outside(self, from_leading, from_trailing):
        half = 0.5 * (self.a + np.minimum(from_leading, from_trailing))
        root = np.sqrt(np.sin(0.5 * from_leading) * np.sin(0.5 * from_trailing)) / math.cos(0.5 * self.a)
        factor = self.tangent * np.cos(half) / (np.sin(half) + root) * np.where(from_leading < from_trailing, 1.0, -1.0)
        out = factor[:, None] ** self.orders * self.over - self.shift / PI
        out[:, 0] = -np.log(np.sin(half) + root) - self.shift[0] / PI
        return out


class Contact:
    """Basis solutions for u = (cos e, sin e, p) at a half-width."""

    def __init__(self, terms, a, count, nodes):
        self.terms, self.a, self.count = terms, a, count
        x, w = np.polynomial.legendre.leggauss(nodes)
        self.rule = 0.5 * (1.0 + x), 0.5 * w
        self.elastic = Elastic(a, count)
        self.glassy = 1.0 - math.fsum(j for j, _ in terms)
        self.points = np.sort(2.0 * np.arctan(self.elastic.tangent * np.cos(PI * (np.arange(count) + 0.5) / count)))
        rows, self.at_trailing = self.rows()
        matrix = np.zeros((count + 1, count + 1))
        matrix[:count, :count], matrix[:count, count], matrix[count, 0] = rows, -1.0, 1.0
        sides = np.zeros((count + 1, 3))
        sides[:count, 0], sides[:count, 1], sides[count, 2] = np.cos(self.points), -np.sin(self.points), 2.0
        solved = np.linalg.solve(matrix, sides)
        solved += np.linalg.solve(matrix, sides - matrix @ solved)
        # penetration - 1 is depth.u
        self.c, self.depth = solved[:count], solved[count]
        signs = (-1.0) ** np.arange(count)
        self.amplitudes = np.array([signs @ self.c, self.c.sum(axis=0)])

    def panels(self, first):
        """(from the leading edge, from the trailing edge, weight) over the gap beyond `first`."""
        length = 2.0 * (PI - self.a)
        angles = {PI}
        for k in range(1, 10):
            angles |= {PI * 0.5 ** k, PI * (1.0 - 0.5 ** k)}
        for _, zeta in self.terms:
            for multiple in (0.25, 1.0, 3.0, 8.0, 16.0, 26.0, 40.0):
                part = (first + multiple * zeta) / length
                if part < 1.0:
                    angles.add(2.0 * math.asin(math.sqrt(part)))
        start = 2.0 * math.asin(math.sqrt(first / length))
        breaks = np.array([start] + sorted(x for x in angles if x > start + 1e-9))
        node, weight = self.rule
        widths = np.diff(breaks)[:, None]
        half = (0.5 * (breaks[:-1, None] + widths * node)).ravel()
        sine, cosine = np.sin(half), np.cos(half)
        return length * sine * sine, length * cosine * cosine, (weight * widths).ravel() * length * sine * cosine

    def rows(self):
        count, a, (node, weight) = self.count, self.a, self.rule
        ends = np.concatenate(([-a], self.points, [a]))
        widths = np.diff(ends)
        spots = ends[:-1, None] + widths[:, None] * node
        values = self.elastic.inside(spots.ravel()).reshape(count + 1, len(node), count)
        rows = self.glassy * self.elastic.inside(self.points)
        ahead, behind, gap_weight = self.panels(0.0)
        gap_values = self.elastic.outside(ahead, behind)
        length, at_trailing = 2.0 * (PI - a), []
        for j, zeta in self.terms:
            out = (gap_weight * np.exp(-ahead / zeta) / zeta) @ gap_values
            factors = np.exp(-(spots - ends[:-1, None]) / zeta) / zeta * weight * widths[:, None]
            parts = np.einsum("pk,pkn->pn", factors, values)
            decays = np.exp(-widths / zeta)
            march = out
            for piece in range(count, -1, -1):
                march = decays[piece] * march + parts[piece]
            trailing = march / -math.expm1(-2.0 * PI / zeta)
            at_trailing.append(trailing)
            here = out + math.exp(-length / zeta) * trailing
            for piece in range(count, 0, -1):
                here = decays[piece] * here + parts[piece]
                rows[piece - 1] += j * here
        return rows, at_trailing

    def gap_row(self, from_trailing):
        """The gap at a point as a form in u, without the part of the indenter."""
        length = 2.0 * (PI - self.a)
        first = length - from_trailing
        row = self.glassy * self.elastic.outside(np.array([first]), np.array([from_trailing]))[0]
        ahead, behind, weight = self.panels(first)
        values = self.elastic.outside(ahead, behind)
        for (j, zeta), trailing in zip(self.terms, self.at_trailing):
            row = row + j * ((weight * np.exp(-(ahead - first) / zeta) / zeta) @ values + math.exp(-from_trailing / zeta) * trailing)
        return row @ self.c

    def gap(self, side, distance):
        length = 2.0 * (PI - self.a)
        x = side * (self.a + distance)
        return self.gap_row(distance if side < 0 else length - distance) - np.array([math.cos(x), -math.sin(x), 0.0]) - self.depth

    def pressure(self, side, distance):
        y = self.a - distance
        lack = math.sin(0.5 * distance) / (math.cos(0.5 * y) * math.cos(0.5 * self.a) * self.elastic.tangent)
        theta = 2.0 * math.asin(math.sqrt(0.5 * lack))
        slope = 0.5 / (math.cos(0.5 * y) ** 2 * self.elastic.tangent)
        orders = self.elastic.orders
        return (float(side) ** orders * np.cos(orders * theta)) @ self.c / math.sin(theta) * slope

    def friction(self, u):
        nodes = 4 * self.count
        theta = PI * (np.arange(nodes) + 0.5) / nodes
        y = 2.0 * np.arctan(self.elastic.tangent * np.cos(theta))
        density = np.cos(np.outer(theta, self.elastic.orders)) @ (self.c @ u)
        e = math.atan2(u[1], u[0])
        return float(density @ np.sin(y + e)) * PI / nodes / (2.0 * PI)


class Width:
    """Both works as forms in u, over 2 pi times the work of adhesion."""

    def __init__(self, problem, a, numbers):
        terms, works, zone = problem.terms, problem.works, problem.zone
        count, nodes, window = numbers
        self.a, self.zone = a, zone
        self.here = Contact(terms, a, count, nodes)
        self.lines = [*self.here.amplitudes]
        self.forms = []
        if works is None:
            return
        moved = Contact(terms, a + 0.5 * zone, count, nodes)
        node, weight = np.polynomial.legendre.leggauss(window)
        angles = 0.25 * PI * (1.0 + node)
        for side, work in zip((-1, 1), works):
            cosine, sine = math.cos(0.5 * zone), side * math.sin(0.5 * zone)
            turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 0.0]])
            # The same penetration: depth'.u' = depth.u.
            turn[2] = (self.here.depth - moved.depth[:2] @ turn[:2]) / moved.depth[2]
            self.lines += [line @ turn for line in moved.amplitudes]
            form = np.zeros((3, 3))
            for angle, part in zip(angles, weight):
                s, c = math.sin(angle), math.cos(angle)
                tension = -moved.pressure(side, zone * s * s) @ turn
                form += 0.25 * PI * part * 2.0 * s * c * np.outer(tension, self.here.gap(side, zone * c * c)) / 2.0
            self.forms.append(0.5 * (form + form.T) / (2.0 * PI * work))

    def works(self, u):
        return np.array([u @ form @ u for form in self.forms])

    def open(self, u):
        length = 2.0 * (PI - self.a)
        # Without adhesion the gap opens as the distance to the power 3/2: next to an edge rounding hides it.
        parts = np.concatenate((np.geomspace(1e-5 if self.forms else 1e-2, 0.5, 14), np.linspace(0.08, 0.42, 6)))
        gaps = [self.here.gap(side, part * length) @ u for side in (-1, 1) for part in parts]
        return min(gaps) > -(1e-6 if self.forms else 1e-4) * max(gaps)

    def contacts(self, grid=1440):
        """[(e, p, penetration, friction)] of all contacts."""
        roots = []
        if not self.forms:
            u = np.cross(self.lines[0], self.lines[1])
            u = u / math.copysign(math.hypot(u[0], u[1]), u[0])
            roots = [u]
        else:
            def pressures(form, e):
                c, s = np.cos(e), np.sin(e)
                half = form[0, 2] * c + form[1, 2] * s
                rest = form[0, 0] * c * c + 2.0 * form[0, 1] * c * s + form[1, 1] * s * s - 1.0
                with np.errstate(invalid="ignore"):
                    root = np.sqrt(half * half - form[2, 2] * rest)
                return (-half - root) / form[2, 2], (-half + root) / form[2, 2]

            # Dense about zero, where narrow contacts are.
            part = np.linspace(-1.0, 1.0, grid + 1)
            scale = min(1.0, 3.0 * self.a)
            angles = np.sign(part) * PI * np.sinh(np.abs(part) * math.asinh(PI / scale)) / (PI / scale)
            sides = [pressures(form, angles) for form in self.forms]
            for one in (0, 1):
                for other in (0, 1):
                    def off(e):
                        return pressures(self.forms[0], e)[one] - pressures(self.forms[1], e)[other]
                    values = sides[0][one] - sides[1][other]
                    pieces = list(np.nonzero(values[:-1] * values[1:] < 0.0)[0])
                    brackets = [(angles[k], angles[k + 1]) for k in pieces]
                    size = np.abs(values)
                    dips = np.nonzero((size[1:-1] < size[:-2]) & (size[1:-1] < size[2:]) & (values[:-2] * values[2:] > 0.0) & (values[:-2] * values[1:-1] > 0.0))[0]
                    for k in dips:
                        sign = math.copysign(1.0, values[k + 1])
                        best = minimize_scalar(lambda e: sign * off(e), bounds=(angles[k], angles[k + 2]), method="bounded", options={"xatol": 1e-12})
                        if best.fun < 0.0:
                            brackets += [(angles[k], best.x), (best.x, angles[k + 2])]
                    for low, high in brackets:
                        e = brentq(off, low, high, xtol=1e-15, rtol=1e-14)
                        roots.append(np.array([math.cos(e), math.sin(e), pressures(self.forms[0], e)[one]]))
        out = []
        for u in roots:
            if self.forms and max(line @ u for line in self.lines) >= 0.0:
                continue
            if self.open(u):
                out.append((math.atan2(u[1], u[0]), float(u[2]), 1.0 + float(self.here.depth @ u), self.here.friction(u)))
        return sorted(out)


@dataclass(frozen=True)
class Problem:
    """A name, terms (j_j, zeta_j), both reduced works (None: without adhesion), the zone of both edges, held mean pressures, and the numbers of points, nodes, window nodes."""
    name: str
    terms: tuple
    works: tuple | None
    zone: float
    held: tuple
    numbers: tuple


def one(beta, zeta):
    return ((1.0 - 1.0 / beta, zeta),)


def template(name, work, speed, pressures):
    """The scene of `viscotack new sliding`: work in J/m2, speed in m/s, pressures in Pa."""
    modulus, k, amplitude, time_ = 1e6 / (1.0 - 0.49 ** 2), 2.0 * PI / 1e-4, 3e-6, 1e-2
    reduced = work / (PI * modulus * k * amplitude ** 2)
    unit = 0.5 * modulus * k * amplitude
    return Problem(name, one(10.0, k * speed * time_), (reduced, reduced), k * 0.16e-6, tuple(p / unit for p in pressures), (80, 10, 16))


PROBLEMS = [
    Problem("fast", one(10.0, 10.0), (0.008, 0.008), 1e-3, (0.162, 0.165, 5.5, 5.61, -0.11), (80, 10, 16)),
    Problem("slower", one(10.0, 0.1), (0.008, 0.008), 1e-3, (-0.05, -0.1, 0.0, 0.15, 0.17, -0.11), (110, 10, 20)),
    Problem("negative snap-in", one(14.0, 0.014), (0.0122, 0.0122), 5.5e-4, (-0.06, -0.07, -0.09, -0.12, 0.0, -0.17), (200, 10, 20)),
    Problem("negative snap-in, faster", one(14.0, 0.1), (0.0122, 0.0122), 5.5e-4, (-0.07, -0.09, -0.12, -0.17, -0.19), (110, 10, 20)),
    template("template, 1 cm/s", 0.02, 1e-2, (24e3, 25e3, 26e3)),
    template("template, stickier, 1.1 mm/s", 0.0315, 1.1e-3, (6e3,)),
    template("template, stickier, 13.5 mm/s", 0.0315, 1.35e-2, (6e3,)),
    Problem("without adhesion", one(10.0, 100.0), None, 0.0, (0.5, 5.0, 9.5, 9.96), (140, 12, 16)),
    Problem("without adhesion, slow", one(10.0, 0.5), None, 0.0, (0.5, 1.0, 3.0), (140, 12, 16)),
    Problem("soft", one(3.0, 0.5), (0.004, 0.004), 2e-3, (-0.06, 0.1, 0.4, 1.2), (80, 10, 16)),
    Problem("two terms", ((0.475, 3.0), (0.475, 0.3)), (0.01, 0.01), 4e-3, (-0.1, 0.05, 0.3, 2.0), (90, 10, 16)),
    Problem("two works", one(6.0, 1.0), (0.01, 0.003), 3e-3, (-0.08, 0.05, 0.3, 2.0), (80, 10, 16)),
    Problem("six terms", tuple((0.95 / 6.0, zeta) for zeta in (30.0, 10.0, 3.0, 1.0, 0.3, 0.1)), (0.006, 0.006), 4e-3, (-0.1, 0.1, 1.0, 8.0), (110, 10, 20)),
    # No contact at any half-width: the speed is between the two folds.
    Problem("none at this speed", one(100.0, 3.0), (0.02, 0.02), 2e-3, (-0.15, 0.1, 20.0), (90, 10, 16)),
    Problem("stiff", one(100.0, 300.0), (0.005, 0.005), 2e-3, (-0.3, 30.0, 70.0, 100.0), (120, 12, 20)),
    Problem("longer zone", one(20.0, 30.0), (0.006, 0.006), 1e-2, (-0.05, 0.1, 5.0, 25.0), (80, 10, 16)),
]


def margin(problem, a, e, p):
    """The least of both diagonal entries and the determinant of d(work_i)/d(edge j) at fixed load, over their sizes."""
    step = 2e-4 * min(a, PI - a)
    matrix = np.zeros((2, 2))

    def works(wider, ahead):
        return Width(problem, a + wider, problem.numbers).works(np.array([math.cos(e + ahead), math.sin(e + ahead), p]))
    for column, side in ((0, -1.0), (1, 1.0)):
        matrix[:, column] = (works(0.5 * step, 0.5 * side * step) - works(-0.5 * step, -0.5 * side * step)) / step
    size = np.abs(matrix).max()
    product, other = matrix[0, 0] * matrix[1, 1], matrix[0, 1] * matrix[1, 0]
    return min(matrix[0, 0] / size, matrix[1, 1] / size, (product - other) / (abs(product) + abs(other)))


def finer(numbers):
    count, nodes, window = numbers
    return count + count // 4, nodes + 4, window + 6


def row_of_widths(problem):
    """ln tan(a/2) of the half-widths that are looked at: to a gap of three zones."""
    narrow = 0.04 if problem.works else 0.1
    wide = max(1.5 * problem.zone, 0.02)
    return np.linspace(math.log(math.tan(0.5 * narrow)), -math.log(math.tan(0.5 * wide)), 48 if problem.works else 24)


def at_place(problem, place, numbers=None):
    a = 2.0 * math.atan(math.exp(place))
    return a, Width(problem, a, numbers or problem.numbers).contacts()


def nearest(contacts, e, p):
    return min(contacts, key=lambda contact: abs(contact[0] - e) + 0.3 * abs(contact[1] - p)) if contacts else None


def scanned(problem):
    """(held contacts, limits): of each held load [(a, e, p, penetration, friction)], and [(name, a, e beside it, p)] of the extremes of the load."""
    places = row_of_widths(problem)
    rows = [(place, *at_place(problem, place)) for place in places]
    links = []
    for (place, a, narrow), (onward, b, wide) in zip(rows[:-1], rows[1:]):
        for contact in narrow:
            other = nearest(wide, contact[0], contact[1])
            if other is not None and nearest(narrow, other[0], other[1]) == contact and abs(other[0] - contact[0]) < 0.4:
                links.append((place, contact, onward, other))

    def follow(place, link):
        low, one, high, other = link
        part = (place - low) / (high - low)
        e, p = one[0] + part * (other[0] - one[0]), one[1] + part * (other[1] - one[1])
        return nearest(at_place(problem, place)[1], e, p)
    held = {}
    for load in problem.held:
        found = []
        for link in links:
            low, one, high, other = link
            if (one[1] - load) * (other[1] - load) < 0.0:
                place = brentq(lambda x: follow(x, link)[1] - load, low, high, xtol=1e-12)
                found.append((2.0 * math.atan(math.exp(place)), follow(place, link)[0]))
        held[load] = sorted(found)
    limits = []
    for link in links:
        for onward in links:
            if link[2:] == onward[:2] and (link[3][1] - link[1][1]) * (onward[3][1] - onward[1][1]) < 0.0:
                sign = 1.0 if link[3][1] > link[1][1] else -1.0

                def off(x):
                    return -sign * follow(x, link if x < link[2] else onward)[1]
                best = minimize_scalar(off, bounds=(link[0], onward[2]), method="bounded", options={"xatol": 1e-7})
                # Beside it, on the side of the narrower contact of a maximum, contacts are stable: otherwise it is the limit of nothing.
                a = 2.0 * math.atan(math.exp(best.x))
                place = best.x - 0.05 * sign
                beside = follow(place, link if place < link[2] else onward)
                if beside is not None and margin(problem, 2.0 * math.atan(math.exp(place)), beside[0], beside[1]) > 0.0:
                    limits.append(("maximum" if sign > 0.0 else "minimum", a, beside[0], -sign * best.fun))
    return held, limits


def refined(problem, a, e, load, numbers):
    """The contact of a held load by Newton's method in (a, e), with finer numbers."""
    x = np.array([a, e])

    def off(x):
        width = Width(problem, x[0], numbers)
        if problem.works is None:
            u = np.cross(width.lines[0], width.lines[1])
            u = u / math.copysign(math.hypot(u[0], u[1]), u[0])
            return np.array([math.atan2(u[1], u[0]) - x[1], u[2] - load])
        return width.works(np.array([math.cos(x[1]), math.sin(x[1]), load])) - 1.0
    for _ in range(8):
        here, step = off(x), 1e-5
        slopes = np.array([(off(x + step * unit) - off(x - step * unit)) / (2.0 * step) for unit in np.eye(2)]).T
        move = np.linalg.solve(slopes, here)
        x = x - move
        if np.abs(move).max() < 1e-11:
            break
    width = Width(problem, x[0], numbers)
    u = np.array([math.cos(x[1]), math.sin(x[1]), load])
    return x[0], x[1], 1.0 + float(width.here.depth @ u), width.here.friction(u)


def job(problem):
    held, limits = scanned(problem)
    out = []

    def told(asked, load, quantity, index, coarse, fine):
        digits = 11 if coarse == fine else max(0, min(11, int(-math.log10(abs(coarse - fine) / max(abs(fine), 1e-2)))))
        works = problem.works or (0.0, 0.0)
        out.append({
            "asked": asked, "case": problem.name, "terms": " ".join(f"{double(j)}:{double(z)}" for j, z in problem.terms), "trailing_work": double(works[0]),
            "leading_work": double(works[1]), "zone": double(problem.zone), "held": "" if load is None else double(load), "quantity": quantity, "index": index,
            "value": f"{fine:.12e}", "confirmed_digits": digits,
        })
    for index, (name, a, e, p) in enumerate(limits):
        # At an extreme the load does not feel the last digits of the half-width.
        fine = nearest(Width(problem, a, finer(problem.numbers)).contacts(), e, p)[1]
        told("limit", None, "mean_pressure", f"{name} {index}", p, fine)
        out[-1]["confirmed_digits"] = min(8, out[-1]["confirmed_digits"])
    for load, contacts in held.items():
        count = 0
        for index, (a, e) in enumerate(contacts):
            coarse, fine = (refined(problem, a, e, load, numbers) for numbers in (problem.numbers, finer(problem.numbers)))
            for quantity, one, other in zip(("half_width", "eccentricity", "penetration", "friction_stress"), coarse, fine):
                told("contact", load, quantity, index, one, other)
            stable = 1.0 if problem.works is None or margin(problem, fine[0], fine[1], load) > 0.0 else 0.0
            told("contact", load, "stable", index, stable, stable)
            count += int(stable)
        told("contact", load, "stable_contacts", "", float(count), float(count))
    return out


def self_check():
    """The elastic contact against Westergaard and, for a short zone, Johnson; all contacts of a half-width on two grids."""
    wrong = []
    smooth = Width(Problem("", (), None, 0.0, (), (40, 10, 16)), 1.3, (40, 10, 16)).contacts()
    if abs(smooth[0][1] - math.sin(0.65) ** 2) > 1e-12:
        wrong.append(f"Westergaard {smooth}")
    zone = 1e-5
    for a in (0.6, 1.5, 2.4):
        sticky = Width(Problem("", (), (0.004, 0.004), zone, (), (60, 10, 16)), a, (60, 10, 16)).contacts()
        right = math.sin(0.5 * a) ** 2 - 2.0 * math.sqrt(0.004 * math.tan(0.5 * a))
        if not any(abs(p - right) < 10.0 * zone and abs(e) < 1e-8 for e, p, _, _ in sticky):
            wrong.append(f"Johnson {a}: {right} {sticky}")
    width = Width(PROBLEMS[0], 2.9, PROBLEMS[0].numbers)
    for coarse, fine in zip(width.contacts(720), width.contacts(5760), strict=True):
        if max(abs(x - y) for x, y in zip(coarse, fine)) > 1e-9:
            wrong.append(f"grids of eccentricity {coarse} {fine}")
    return wrong


def main():
    options = arguments("All steady sliding contacts of held loads, by collocation and a scan.")
    start = time.time()
    if options.self_check:
        finish(self_check(), start, "self-check")
    todo = [replace(problem, held=problem.held[:1]) for problem in PROBLEMS if problem.name in ("without adhesion",)] if options.reduced else PROBLEMS
    if options.jobs > 1:
        with multiprocessing.Pool(options.jobs) as pool:
            rows = [row for part in pool.map(job, todo, chunksize=1) for row in part]
    else:
        rows = [row for problem in todo for row in job(problem)]
    if options.check:
        finish(differences(FILE, read(FILE), rows, ["asked", "case", "held", "quantity", "index"]), start, f"check of {len(rows)} rows")
    write(FILE, COMMAND, "all steady sliding contacts of held loads on a wave, by collocation and a scan of half-widths and eccentricities", COLUMNS, rows,
          precision="double precision, Chebyshev collocation; confirmed with a quarter more points, finer panels and windows", tool=f"NumPy {np.__version__}")
    print(f"written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
