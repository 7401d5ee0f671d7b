"""Indentation without adhesion: Lee and Radok's, Ting's and Graham's contact, by times of equal radius; the judge of the solver.

A place of the line, at the depth h = f(s) of the indenter's line profile, is in contact from the time at which the edge passes it outwards to the time at
which the edge passes it inwards, and so on. With these times of equal radius t1(h) < t2(h) < ... (Ting, J. Appl. Mech. 33 (1966) 845 and 35 (1968) 248;
Graham, Q. Appl. Math. 26 (1968) 167; Argatov & Popov, ZAMM 96 (2016) 956, for any number of turns on the line)
    in contact   W(h, t) = D(t) - h,         free   q(h, t) = 0,           q = int R(t - t') dW(h, t')
    a contact without adhesion carries no tension and no overlap: a place lets go when q comes down to zero and is met when the free surface is.
    F(t) = 2 int_0^a q(f(s), t) ds,          a(t) the radius with q = 0 there
All places follow one penetration D(t) independently of each other, and in h they know nothing of the shape, which only enters the force.

What is computed here
    passage times   at double-exponential nodes between the turning radii, by bracketed roots, first sign change from the start of each leg
    q               the hereditary integral over the intervals of contact of that place; R and J are sums of exponentials, so that each interval is closed
    F               double-exponential quadrature between the turning radii; its error from every second node
    force, frame and contact radius   the penetration is a polynomial on each piece of a leg, by collocation
The judge's own error: of the quadrature by every second node, for each force; of the collocation 3e-9 of the largest value under loads and 2e-11 under radii.

The solver (Rust) follows the edge and keeps segments of a line in Maxwell and Voigt state. Shared with it is that Sneddon's transform makes the places
independent of each other. Three routes share less:
    python3 verification/references/ting_graham.py --self-check
compares this program with the quadratures of adhesiveless.csv (no place is followed, no state kept), with a superposition of R at the instants of a grid for
two cycles and a reload (no exponential is used: every step adds R(t - t') times what W changed, Richardson's extrapolation from three grids), and its
conversion between relaxation and creep with the identity of both state maps.
"""

import sys

sys.dont_write_bytecode = True

import math

import numpy as np
from scipy.interpolate import PchipInterpolator

EPS = 2.0 ** -52
LONG = np.longdouble


def chebvander(z, degree):
    """Chebyshev's polynomials at places, as NumPy's, without its care for every kind of argument."""
    z = np.asarray(z, dtype=float)
    found = np.empty((degree + 1, *z.shape))
    found[0] = 1.0
    if degree > 0:
        found[1] = z
        twice = 2.0 * z
        for k in range(2, degree + 1):
            np.multiply(twice, found[k - 1], out=found[k])
            found[k] -= found[k - 2]
    return np.moveaxis(found, 0, -1) if z.ndim != 1 else found.T


def chebval(z, coefficients):
    """A series of them, by Clenshaw's sum."""
    z = np.asarray(z, dtype=float)
    twice, first, second = 2.0 * z, np.zeros_like(z), np.zeros_like(z)
    for coefficient in coefficients[:0:-1]:
        first, second = twice * first - second + coefficient, first
    return z * first - second + coefficients[0]


def chebder(coefficients):
    """The series of its slope."""
    count = len(coefficients)
    slope = np.zeros(max(count - 1, 1))
    for k in range(count - 1, 0, -1):
        slope[k - 1] = 2.0 * k * coefficients[k] + (slope[k + 1] if k + 1 < count - 1 else 0.0)
    slope[0] *= 0.5
    return slope


# ---------------------------------------------------------------- material

def poles_between(function, poles, sign, last):
    """Roots of a function that is monotone between neighbouring poles: for each the nearer pole and the signed distance from it, to full relative precision.

    `function(pole_index, distance)` for arrays; `sign` times it is positive just right of a pole and negative just left of the next one. With `last`, also
    one root beyond the last pole."""
    nearest, distances = [], []
    count = len(poles)
    for k in range(count - 1 + bool(last)):
        if k + 1 < count:
            half = 0.5 * (poles[k + 1] - poles[k])
            right = sign * function(k, half) > 0.0
        else:
            half, right = poles[k] + 1e-300, False
            while sign * function(k, half) > 0.0:
                half *= 2.0
        base, direction = (k + 1, -1.0) if right else (k, 1.0)
        low, high = math.log(half) - 650.0, math.log(half)
        low = max(low, -690.0)
        for _ in range(70):
            middle = 0.5 * (low + high)
            positive = sign * function(base, direction * math.exp(middle)) > 0.0
            # Towards the right-hand pole the function falls; seen from it, it rises with the distance.
            if positive == (direction > 0.0):
                low = middle
            else:
                high = middle
        nearest.append(base)
        distances.append(direction * math.exp(0.5 * (low + high)))
    return np.array(nearest, dtype=int), np.array(distances)


class Solid:
    """E0 + sum E_i exp(-r_i t) and its compliance: moduli E* = E/(1 - nu^2); `gap[i, j]` = r_i - l_j without cancellation."""

    def __init__(self, relaxed, moduli, rates):
        order = np.argsort(rates)
        self.relaxed = float(relaxed)
        self.moduli = np.asarray(moduli, dtype=float)[order]
        self.rates = np.asarray(rates, dtype=float)[order]
        self.glassy = self.relaxed + self.moduli.sum()
        n = len(self.rates)
        if n == 0:
            self.slow = self.charge = np.zeros(0)
            self.gap = np.zeros((0, 0))
            return
        poles = np.concatenate([[0.0], self.rates]) if self.relaxed > 0.0 else self.rates

        def stiffness(base, distance):
            # E0 - sum E_i l/(r_i - l) at l = pole + distance
            l = poles[base] + distance
            gaps = (self.rates - poles[base]) - distance
            return self.relaxed - np.sum(self.moduli * l / gaps)

        if self.relaxed > 0.0:
            nearest, distance = poles_between(stiffness, poles, 1.0, False)
            # l in (0, r_1): E0 at zero, -inf at r_1; elsewhere +inf right of a pole.
            self.slow = poles[nearest] + distance
            self.gap = (self.rates[:, None] - poles[nearest][None, :]) - distance[None, :]
        else:
            nearest, distance = poles_between(stiffness, self.rates, 1.0, False)
            self.slow = np.concatenate([[0.0], self.rates[nearest] + distance])
            gap = (self.rates[:, None] - self.rates[nearest][None, :]) - distance[None, :]
            self.gap = np.concatenate([self.rates[:, None], gap], axis=1)
        # J_j l_j of a term, 1/viscosity of the flow (l = 0).
        self.charge = 1.0 / np.sum(self.moduli[:, None] * self.rates[:, None] / self.gap ** 2, axis=0)
        self.to_springs = -(self.slow[None, :] / self.gap)
        self.to_voigt = self.charge[:, None] * self.moduli[None, :] / self.gap.T

    @classmethod
    def from_compliance(cls, glassy, compliances, slow, flow=0.0):
        """1/glassy + sum J_j (1 - exp(-l_j t)) + flow t."""
        order = np.argsort(slow)
        compliances, slow = np.asarray(compliances, dtype=float)[order], np.asarray(slow, dtype=float)[order]
        poles = np.concatenate([[0.0], slow]) if flow > 0.0 else slow
        weights = np.concatenate([[flow], compliances * slow]) if flow > 0.0 else compliances * slow
        if len(poles) == 0:
            return cls(glassy, [], [])

        def softness(base, distance):
            # 1/glassy + sum J_j l_j/(l_j - r)
            gaps = (poles - poles[base]) - distance
            return 1.0 / glassy + np.sum(weights / gaps)

        nearest, distance = poles_between(softness, poles, -1.0, True)
        rates = poles[nearest] + distance
        gap = (poles[None, :] - poles[nearest][:, None]) - distance[:, None]
        moduli = 1.0 / (rates * np.sum(weights[None, :] / gap ** 2, axis=1))
        relaxed = 0.0 if flow > 0.0 else 1.0 / (1.0 / glassy + compliances.sum())
        return cls(relaxed, moduli, rates)

    def relaxation(self, t):
        return self.relaxed + np.exp(-np.multiply.outer(t, self.rates)) @ self.moduli


# ---------------------------------------------------------------- shapes

class Power:
    """f(s) = coefficient s^m."""

    rim = math.inf
    knots = ()

    def __init__(self, coefficient, exponent):
        self.coefficient, self.exponent = coefficient, exponent

    def line(self, s):
        return self.coefficient * np.power(s, self.exponent)

    def radius(self, h):
        return np.power(np.maximum(h, 0.0) / self.coefficient, 1.0 / self.exponent)

    def elastic(self, s):
        """Force over the modulus, 2 (s f - int f)."""
        return 2.0 * self.line(s) * s * self.exponent / (self.exponent + 1.0)


def sphere(radius=1.0):
    return Power(1.0 / radius, 2.0)


def cone(slope):
    return Power(0.5 * math.pi * slope, 1.0)


def power_law(radius, exponent):
    m = exponent
    moment = 0.5 * math.sqrt(math.pi) * math.exp(math.lgamma(0.5 * m + 1.0) - math.lgamma(0.5 * m + 1.5))
    return Power((m + 1.0) * moment / (m * radius ** (m - 1.0)), m)


class Punch:
    """A flat face: all places alike, up to the rim."""

    knots = ()

    def __init__(self, radius):
        self.rim = radius

    def radius(self, h):
        return np.where(np.asarray(h) >= 0.0, self.rim, 0.0)


class Table:
    """z(r) through points: monotone cubics with the slopes of indentation_shape.py, f in closed form, its inverse by Newton's steps."""

    rim = math.inf

    def __init__(self, points):
        from indentation_shape import cubics
        from mpmath import mp
        with mp.workdps(40):
            pieces = cubics(points)
        self.low, self.high = (np.array([float(p[k]) for p in pieces]) for k in (0, 1))
        self.terms = np.array([[float(c) for c in p[2]] for p in pieces])
        self.knots = self.low[1:]
        self.end = float(points[-1][0])
        self.grid = np.unique(np.concatenate([np.linspace(self.low[k], self.high[k], 65) for k in range(len(self.low))]))
        self.lines = self.line(self.grid)
        # 2 (s f - int f) from grid place to grid place: six Gauss nodes each.
        x, w = np.polynomial.legendre.leggauss(6)
        width = np.diff(self.grid)
        places = self.grid[:-1, None] + 0.5 * width[:, None] * (1.0 + x)
        parts = 0.5 * width * (self.line(places.ravel()).reshape(places.shape) @ w)
        self.areas = np.concatenate([[0.0], np.cumsum(parts)])

    def line(self, s, slope=False):
        s = np.asarray(s, dtype=float)
        flat = np.maximum(s.ravel(), 1e-300)[:, None]
        low, high = np.minimum(self.low[None, :], flat), np.minimum(self.high[None, :], flat)
        a, b, c = self.terms.T
        angle = np.arcsin(high / flat) - np.arcsin(low / flat)
        upper, lower = np.sqrt((flat - high) * (flat + high)), np.sqrt((flat - low) * (flat + low))
        moment = high * upper - low * lower
        one, two = lower - upper, 0.5 * (flat ** 2 * angle - moment)
        if slope:
            value = np.sum(a * angle + 2.0 * b * one + 3.0 * c * two, axis=1)
        else:
            value = flat[:, 0] * np.sum(a * angle + b * one + c * two, axis=1)
        return value.reshape(s.shape)

    def radius(self, h):
        h = np.maximum(np.asarray(h, dtype=float), 0.0)
        s = np.interp(h, self.lines, self.grid)
        place = np.clip(np.searchsorted(self.lines, h) - 1, 0, len(self.grid) - 2)
        low, high = self.grid[place], self.grid[place + 1]
        for _ in range(4):
            s = np.clip(s - (self.line(s) - h) / np.maximum(self.line(s, True), 1e-300), low, high)
        return s

    def elastic(self, s):
        s = np.asarray(s, dtype=float)
        flat = s.ravel()
        place = np.clip(np.searchsorted(self.grid, flat) - 1, 0, len(self.grid) - 2)
        x, w = np.polynomial.legendre.leggauss(6)
        width = flat - self.grid[place]
        nodes = self.grid[place][:, None] + 0.5 * width[:, None] * (1.0 + x)
        area = self.areas[place] + 0.5 * width * (self.line(nodes.ravel()).reshape(nodes.shape) @ w)
        return (2.0 * (flat * self.line(flat) - area)).reshape(s.shape)


# ---------------------------------------------------------------- pieces of the penetration

class Jump:
    """The penetration goes to a value at once."""

    length = 0.0

    def __init__(self, solid, start, before, after, memory):
        self.start, self.before, self.after = start, before, after
        self.memory_before, self.memory_after = memory, memory + (after - before)

    def depth(self, x):
        return np.full(np.shape(x), self.after)

    def memory(self, x):
        return np.broadcast_to(self.memory_after, np.shape(x) + self.memory_after.shape)

    end = property(lambda self: self.after)
    end_memory = property(lambda self: self.memory_after)


class Straight:
    """The penetration goes straight. P_i(t) = int exp(-r_i (t - t')) dD, `memory`, is the same for every place."""

    def __init__(self, solid, start, length, first, last, memory):
        self.rates, self.start, self.length = solid.rates, start, length
        self.first, self.last, self.memory_start = first, last, memory
        self.slope = (last - first) / length

    def depth(self, x):
        return self.first + (self.last - self.first) * (np.asarray(x) / self.length)

    def memory(self, x):
        decay = -np.multiply.outer(np.asarray(x, dtype=float), self.rates)
        return self.memory_start * np.exp(decay) - (self.slope / self.rates) * np.expm1(decay)

    def speed(self, x):
        return np.full(np.shape(x), self.slope)

    def highest(self):
        return max(self.first, self.last)

    end = property(lambda self: self.last)
    end_memory = property(lambda self: self.memory(self.length))


class Smooth:
    """The penetration is a polynomial (Chebyshev coefficients on the piece)."""

    DEGREE = 26
    STIFF = 10.0

    def __init__(self, solid, start, length, coefficients, memory):
        self.rates, self.start, self.length, self.memory_start = solid.rates, start, length, memory
        self.coefficients = np.asarray(coefficients, dtype=float)
        slope = chebder(self.coefficients) * (2.0 / length) if len(self.coefficients) > 1 else np.zeros(1)
        n = len(solid.rates)
        self.decaying = np.zeros(n)
        width = max(self.DEGREE, len(slope) + 18)
        polynomials = np.zeros((width + 1, n))
        for i, rate in enumerate(solid.rates):
            if rate * length > self.STIFF:
                # p' + r p = D', the polynomial solution, from its last coefficient down.
                p = np.zeros(len(slope))
                for _ in range(len(slope)):
                    change = np.zeros(len(slope))
                    if len(slope) > 1:
                        derivative = chebder(p) * (2.0 / length)
                        change[: len(derivative)] = derivative
                    p = (slope - change) / rate
                polynomials[: len(p), i] = p
                self.decaying[i] = memory[i] - chebval(-1.0, p)
            else:
                polynomials[:, i] = self._gentle(slope, rate, length, memory[i], width)
        self.polynomials = polynomials

    _matrices = {}

    @classmethod
    def _gentle(cls, slope, rate, length, initial, width):
        """p' + r p = D' with an initial value, all of it a polynomial, by collocation."""
        if width not in cls._matrices:
            z = -np.cos(np.pi * (np.arange(width) + 0.5) / width)
            values = chebvander(z, width)
            slopes = np.stack([chebval(z, chebder(row)) if k else np.zeros(width) for k, row in enumerate(np.eye(width + 1))], axis=1)
            cls._matrices[width] = z, values, slopes
        z, values, slopes = cls._matrices[width]
        system = np.zeros((width + 1, width + 1))
        system[0] = (-1.0) ** np.arange(width + 1)
        system[1:] = slopes + 0.5 * length * rate * values
        right = np.concatenate([[initial], 0.5 * length * chebval(z, slope)])
        return np.linalg.solve(system, right)

    def depth(self, x):
        return chebval(2.0 * np.asarray(x) / self.length - 1.0, self.coefficients)

    def memory(self, x):
        x = np.asarray(x, dtype=float)
        basis = chebvander((2.0 * x / self.length - 1.0).ravel(), len(self.polynomials) - 1)
        smooth = (basis @ self.polynomials).reshape(*x.shape, len(self.rates))
        if self.decaying.any():
            smooth = smooth + self.decaying * np.exp(-np.multiply.outer(x, self.rates))
        return smooth

    def speed(self, x):
        return chebval(2.0 * np.asarray(x) / self.length - 1.0, chebder(self.coefficients)) * (2.0 / self.length)

    def highest(self):
        return float(np.max(self.depth(np.linspace(0.0, self.length, 33))))

    end = property(lambda self: float(self.depth(self.length)))
    end_memory = property(lambda self: self.memory(self.length))


# ---------------------------------------------------------------- double-exponential nodes

REACH = 3.0


def exponential_nodes(count):
    """Places in (0, 1), their distances from 1, and weights; count odd, so that every second one is a rule of its own."""
    theta = np.linspace(-REACH, REACH, count)
    step = theta[1] - theta[0]
    y = np.pi * np.sinh(theta)
    left, right = 1.0 / (1.0 + np.exp(-y)), 1.0 / (1.0 + np.exp(y))
    weight = np.pi * np.cosh(theta) * left * right * step
    return theta, left, right, weight


RUN_NODES = exponential_nodes(81)
NEWTON_STEPS = 3
FOLLOWED = 18
FORCE_NODES = exponential_nodes(85)


class Run:
    """The edge passes from h to h within one piece, outwards (+1) or inwards (-1): when it passes each place."""

    def __init__(self, way, piece, start, end, first, last, times=None, path=None):
        self.path = path                # depth of the edge by time, where it is imposed and not found
        self.way, self.piece, self.start, self.end = way, piece, start, end
        self.first, self.last = first, last
        self.low, self.high = min(start, end), max(start, end)
        self.spline = None
        if times is not None:
            self.times = times
            self.spline = PchipInterpolator(RUN_NODES[0], self.odds(times))

    def odds(self, times):
        """Logarithm of the part of the run gone by over the part left: times of all scales."""
        least = 1e-15 * (self.last - self.first) + 1e-300
        return np.log(np.maximum(times - self.first, least)) - np.log(np.maximum(self.last - times, least))

    def when(self, h):
        if self.spline is None:
            return np.full(np.shape(h), self.first)
        span = self.end - self.start
        part = np.clip((h - self.start) / span, 1e-300, 1.0)
        rest = np.clip((self.end - h) / span, 1e-300, 1.0)
        theta = np.arcsinh((np.log(part) - np.log(rest)) / np.pi)
        odds = self.spline(np.clip(theta, -REACH, REACH))
        late = self.last - (self.last - self.first) / (1.0 + np.exp(odds))
        return np.where(odds > 0.0, late, self.first + (self.last - self.first) / (1.0 + np.exp(-odds)))

    def between(self, h):
        """Times between which the edge passes places: those of the nodes beside them."""
        span = self.end - self.start
        part = np.clip((h - self.start) / span, 1e-300, 1.0)
        rest = np.clip((self.end - h) / span, 1e-300, 1.0)
        theta = np.arcsinh((np.log(part) - np.log(rest)) / np.pi)
        place = np.searchsorted(RUN_NODES[0], theta)
        times = np.concatenate([[self.first], self.times, [self.last]])
        return times[place], times[place + 1]


# ---------------------------------------------------------------- contact

class Places:
    """What places at depths h carry: since when they are in contact or free, and with what memory."""

    __slots__ = ("h", "contact", "since", "offset", "state")


class Contact:
    """A contact that has followed its penetration so far."""

    SAMPLES = np.concatenate([[0.0], np.logspace(-9.0, -0.2, 30), np.linspace(0.7, 1.0, 6)])

    def __init__(self, solid, shape):
        self.solid, self.shape = solid, shape
        self.pieces, self.runs = [], []
        self.relaxed_edge = -1.0        # places below were in contact from ever on
        self.edge, self.open = 0.0, True
        self.depth, self.memory, self.time = 0.0, np.zeros(len(solid.rates)), LONG(0.0)
        self.turns = []                 # depths at which a run ended, with the number of runs by then
        self.events = []
        self.reached = 0.0              # deepest place that was ever touched
        self.largest = 0.0              # largest |D|, for rounding

    def relaxed_at(self, depth):
        """A relaxed contact at this penetration."""
        self.depth = depth
        self.open = depth <= 0.0
        self.edge = max(depth, 0.0)
        self.relaxed_edge = depth if depth > 0.0 else -1.0
        self.reached = self.edge
        self.largest = abs(depth)
        self.turns.append((self.edge, 0))

    # ---- state of places

    def places(self, h, runs=None):
        """State of places after so many runs (all, or a number for each)."""
        solid = self.solid
        h = np.asarray(h, dtype=float)
        count, n = len(h), len(solid.rates)
        found = Places()
        found.h = h
        found.contact = h < self.relaxed_edge
        found.since = np.zeros(count, dtype=LONG)
        found.offset = np.zeros(count)
        found.state = np.zeros((count, n))
        limit = len(self.runs) if runs is None else int(np.max(runs))
        least, most = float(np.min(h)), float(np.max(h))
        for index, run in enumerate(self.runs[:limit]):
            if run.low > most or run.high <= least:
                continue
            touched = (h >= run.low) & (h < run.high) & (found.contact == (run.way < 0))
            if runs is not None and not np.isscalar(runs):
                touched &= index < runs
            rows = np.flatnonzero(touched)
            if len(rows) == 0:
                continue
            piece = self.pieces[run.piece]
            own = h[rows]
            x = run.when(own)
            if n:
                jump = isinstance(piece, Jump)
                lag = np.maximum((piece.start - found.since[rows]).astype(float) + (x - found.offset[rows]), 0.0)
                if run.spline is not None:
                    low, high = run.between(own)
                    for _ in range(NEWTON_STEPS if run.path is None else 1):
                        if run.way < 0:
                            springs = found.state[rows] * np.exp(-np.multiply.outer(lag, solid.rates)) + piece.memory(x)
                            value = solid.relaxed * (piece.depth(x) - own) + springs @ solid.moduli
                            slope = solid.glassy * piece.speed(x) - springs @ (solid.moduli * solid.rates)
                        else:
                            strains = found.state[rows] * np.exp(-np.multiply.outer(lag, solid.slow))
                            value = strains.sum(axis=1) - piece.depth(x) + own
                            slope = -piece.speed(x) - strains @ solid.slow
                        with np.errstate(all="ignore"):
                            better = x - value / slope
                        x = np.where(np.isfinite(better), np.clip(better, low, high), x)
                        lag = np.maximum((piece.start - found.since[rows]).astype(float) + (x - found.offset[rows]), 0.0)
                if run.way < 0:
                    springs = found.state[rows] * np.exp(-np.multiply.outer(lag, solid.rates)) + (piece.memory_before if jump else piece.memory(x))
                    width = (piece.before if jump else piece.depth(x)) - own
                    found.state[rows] = (width[:, None] - springs) @ solid.to_voigt.T
                else:
                    strains = found.state[rows] * np.exp(-np.multiply.outer(lag, solid.slow))
                    gap = piece.depth(x) - own - strains.sum(axis=1)
                    found.state[rows] = strains @ solid.to_springs.T + gap[:, None] - piece.memory(x)
            found.contact[rows] = run.way > 0
            found.since[rows] = piece.start
            found.offset[rows] = x
        return found

    def lag(self, places, piece, x):
        # A place within rounding of a break may be counted on the other side of it: its lag is then none.
        base = (piece.start - places.since).astype(float) - places.offset
        return np.maximum(base + x if np.ndim(x) < 2 else base[:, None] + x, 0.0)

    def load(self, places, piece, x):
        """q of places in contact (whether or not they would be), at times x of a piece: one each, or rows of several."""
        h = places.h if np.ndim(x) < 2 else places.h[:, None]
        q = self.solid.relaxed * (piece.depth(x) - h)
        if len(self.solid.rates):
            state = places.state if np.ndim(x) < 2 else places.state[:, None, :]
            springs = state * np.exp(-np.multiply.outer(self.lag(places, piece, x), self.solid.rates)) + piece.memory(x)
            q = q + springs @ self.solid.moduli
        return q

    def gap(self, places, piece, x):
        """Free surface over the indenter, of places that are free (whether or not they would be)."""
        h = places.h if np.ndim(x) < 2 else places.h[:, None]
        overlap = h - piece.depth(x)
        if len(self.solid.rates):
            state = places.state if np.ndim(x) < 2 else places.state[:, None, :]
            overlap = overlap + np.sum(state * np.exp(-np.multiply.outer(self.lag(places, piece, x), self.solid.slow)), axis=-1)
        return overlap

    def freed(self, places, piece, x):
        """Voigt strains of places in contact."""
        springs = places.state * np.exp(-np.multiply.outer(self.lag(places, piece, x), self.solid.rates)) + piece.memory(x)
        return ((piece.depth(x) - places.h)[:, None] - springs) @ self.solid.to_voigt.T

    # ---- a piece

    def go(self, piece):
        """Follows one more piece; the edge runs as far as it does."""
        self.pieces.append(piece)
        self.largest = max(self.largest, abs(piece.end), abs(float(piece.depth(0.0))))
        if isinstance(piece, Jump):
            self.corner()
            self._jump(piece)
            self.corner()
        else:
            self._run(piece)
        self.depth, self.memory = piece.end, piece.end_memory
        self.time = piece.start + LONG(piece.length)

    def led(self, piece, end, path):
        """Follows a piece along which the edge goes to `end` by a monotonic path that is known already; without a path it rests."""
        index = len(self.pieces)
        self.pieces.append(piece)
        self.largest = max(self.largest, abs(piece.end))
        if path is not None and end != self.edge:
            start = self.edge
            _, left, right, _ = RUN_NODES
            h = np.where(left < 0.5, start + (end - start) * left, end - (end - start) * right)
            sign = 1.0 if end > start else -1.0
            clipped = lambda x: np.clip(path(x), min(start, end), max(start, end))
            times = bracketed(lambda x: sign * (clipped(x) - h), np.zeros(len(h)), np.full(len(h), piece.length), sign * (start - h), sign * (end - h))
            run = Run(int(sign), index, start, end, 0.0, piece.length, np.maximum.accumulate(np.clip(times, 0.0, piece.length)), clipped)
            if start == 0.0 and sign > 0.0:
                run.low = -1.0
            if end <= 0.0:
                run.low = -1.0
                self.events.append(("detachment", index, piece.length, 0.0))
                self.open = True
            self._add_run(run)
            self.edge = max(end, 0.0)
        self.depth, self.memory = piece.end, piece.end_memory
        self.time = piece.start + LONG(piece.length)

    def straight(self, depth, length):
        self.go(Straight(self.solid, self.time, length, self.depth, depth, self.memory))

    def jump(self, depth):
        if depth != self.depth:
            self.go(Jump(self.solid, self.time, self.depth, depth, self.memory))

    def _noise(self, way):
        return 4.0 * EPS * self.largest * (self.solid.glassy if way < 0 else 1.0) + 1e-300

    def _inner_breaks(self, low, high):
        """Depths between two at which the past of the places changes."""
        least = 1e-11 * max(high, 1e-300)
        found = sorted({h for h, _ in self.turns if low + least < h < high - least})
        return [low] + [h for k, h in enumerate(found) if k == 0 or h - found[k - 1] > least] + [high]

    def corner(self):
        """The history has a corner now: places that the edge has and has not passed by now differ in a derivative."""
        if not self.open:
            self.turns.append((self.edge, len(self.runs)))

    def _add_run(self, run):
        if self.runs and self.runs[-1].way != run.way:
            self.turns.append((max(run.start, 0.0), len(self.runs)))
        self.runs.append(run)
        self.reached = max(self.reached, run.high)

    def _jump(self, piece):
        if piece.after == piece.before:
            return
        rising = piece.after > piece.before
        index = len(self.pieces) - 1
        if rising:
            # The outermost place that is met.
            value = lambda h: self.gap(self.places(h), piece, np.zeros(len(h)))
            if self.open and value(np.zeros(1))[0] >= -self._noise(1):
                return
            edge = self._crossing(value, self.edge, max(self.reached, piece.after) * (1.0 + 1e-9) + 1e-300, piece.after)
            if edge > self.edge:
                if self.open:
                    self.events.append(("touch", index, 0.0))
                self._add_run(Run(1, index, self.edge, edge, 0.0, 0.0))
                self.edge, self.open = edge, False
        elif not self.open:
            def value(h):
                found = self.places(h)
                springs = found.state * np.exp(-np.multiply.outer(self.lag(found, piece, np.zeros(len(h))), self.solid.rates)) + piece.memory_after
                return -(self.solid.relaxed * (piece.after - h) + springs @ self.solid.moduli)
            if value(np.zeros(1))[0] >= -self._noise(-1):
                self._add_run(Run(-1, index, self.edge, -1.0, 0.0, 0.0))
                self.events.append(("detachment", index, 0.0, self.edge))
                self.edge, self.open = 0.0, True
                return
            edge = self._crossing(value, 0.0, self.edge, None)
            if edge < self.edge:
                self._add_run(Run(-1, index, self.edge, edge, 0.0, 0.0))
                self.edge = edge

    def _crossing(self, value, low, high, guess):
        """The h at which a rising function of it comes from below to zero; it is negative at `low`."""
        for _ in range(6):
            h = low + (high - low) * np.linspace(0.0, 1.0, 10)[1:-1]
            found = value(h)
            above = np.flatnonzero(found >= 0.0)
            first = above[0] if len(above) else 8
            low, high = (h[first - 1] if first else low), (h[first] if first < 8 else high)
        ends = value(np.array([low, high]))
        for _ in range(3):
            if ends[1] == ends[0] or not ends[0] < 0.0 <= ends[1]:
                break
            middle = low - ends[0] * (high - low) / (ends[1] - ends[0])
            width = 1e-3 * (high - low)
            trial = np.clip(np.array([middle - width, middle + width]), low, high)
            found = value(trial)
            if found[0] < 0.0:
                low, ends[0] = trial[0], found[0]
            if found[1] >= 0.0:
                high, ends[1] = trial[1], found[1]
        if ends[0] < 0.0 <= ends[1]:
            return low - ends[0] * (high - low) / (ends[1] - ends[0])
        return 0.5 * (low + high)

    def _run(self, piece):
        index, x = len(self.pieces) - 1, 0.0
        forced = 0
        for _ in range(40):
            if x >= piece.length:
                return
            if self.open:
                x = self._until_touch(piece, x)
                if x is None:
                    return
                self.events.append(("touch", index, x))
                self.open, self.edge, forced = False, 0.0, 1
                fresh = True
            else:
                fresh = False
                way = forced or self._direction(piece, x)
                forced = way
            if forced == 0:
                return
            way, forced = forced, 0
            end, last, turned = self._pass(piece, index, way, x, fresh)
            if end is None:
                # Nothing moves that could be told from rounding.
                if fresh:
                    self.open = True
                return
            x = last
            if way < 0 and end < 0.0:
                self.events.append(("detachment", index, last, 0.0))
                self.edge, self.open = 0.0, True
                continue
            self.edge = end
            if not turned:
                return
            forced = -way
        raise RuntimeError("the edge turned too often within one piece")

    def _times(self, piece, x):
        return x + (piece.length - x) * self.SAMPLES

    def _until_touch(self, piece, x):
        places = self.places(np.zeros(1))
        times = self._times(piece, x)
        if isinstance(piece, Smooth):
            times = np.unique(np.concatenate([times, np.linspace(x, piece.length, 33)]))
        gaps = self.gap(places, piece, times[None, :])[0]
        gaps[0] = abs(gaps[0])
        below = np.flatnonzero(gaps < -self._noise(1))
        if len(below) == 0:
            return None
        first = below[0]
        value = lambda x: self.gap(places, piece, x)
        return float(bracketed(value, np.array([times[max(first - 1, 0)]]), np.array([times[first]]))[0])

    def _direction(self, piece, x):
        """Whether the place at the edge, if it stayed in contact, would pull (inwards, -1) or press (outwards, 1) next; 0 while it does neither."""
        places = self.places(np.array([self.edge]))
        times = self._times(piece, x)[1:]
        if places.contact[0]:
            loads = self.load(places, piece, times[None, :])[0]
            noise = self._noise(-1)
        else:
            loads = -self.gap(places, piece, times[None, :])[0]
            noise = self._noise(1)
        clear = np.flatnonzero(np.abs(loads) > 4.0 * noise)
        return 0 if len(clear) == 0 else (1 if loads[clear[0]] > 0.0 else -1)

    def _least(self, places, piece, way, x):
        """The least load (inwards) or gap (outwards) that places would have in the rest of the piece, and when."""
        value = self.load if way < 0 else self.gap
        times = self._times(piece, x)
        if isinstance(piece, Smooth):
            times = np.unique(np.concatenate([times, np.linspace(x, piece.length, 25)]))
        values = value(places, piece, np.broadcast_to(times, (len(places.h), len(times))))
        best = np.argmin(values, axis=1)
        least, when = values[np.arange(len(best)), best], times[best]
        inside = np.flatnonzero((best > 0) & (best < len(times) - 1))
        if len(inside):
            part = self._some(places, inside)
            low, high = times[best[inside] - 1], times[best[inside] + 1]
            for _ in range(7):
                trial = low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, 7)
                found = value(part, piece, trial)
                k = np.argmin(found, axis=1)
                rows = np.arange(len(k))
                least[inside], when[inside] = found[rows, k], trial[rows, k]
                low, high = trial[rows, np.maximum(k - 1, 0)], trial[rows, np.minimum(k + 1, 6)]
        return least, when

    @staticmethod
    def _some(places, rows):
        part = Places()
        part.h, part.contact, part.since, part.offset, part.state = (
            places.h[rows], places.contact[rows], places.since[rows], places.offset[rows], places.state[rows])
        return part

    def _pass(self, piece, index, way, x, fresh):
        """One run of the edge from time x of a piece: (depth at its end, time, whether it turns there)."""
        here = self.edge
        if way > 0:
            far = max(self.reached, piece.highest()) * (1.0 + 1e-9) + 1e-300
            if far <= here:
                return None, x, False
        else:
            far = 0.0
        breaks = self._inner_breaks(min(here, far), max(here, far))
        if way < 0:
            breaks = breaks[::-1]
        noise = self._noise(way)
        # How far it goes: the first place that does not switch in the rest of the piece.
        end, last = None, piece.length
        inner = breaks[0]
        for near, off in zip(breaks, breaks[1:]):
            parts = np.array([1e-6, 1e-3, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95, 0.999, 1.0])
            h = near + (off - near) * parts
            h[-1] = off
            if off != far:
                h = h[:-1]
            places = self.places(h)
            # Within rounding of a break a place may be counted on its other side.
            sound = np.flatnonzero(places.contact == (way < 0))
            if len(sound) == 0:
                inner = off
                continue
            h = h[sound]
            least, when = self._least(self._some(places, sound), piece, way, x)
            holds = np.flatnonzero(least > -noise)
            if len(holds):
                first = holds[0]
                inner = h[first - 1] if first else near
                end, last = self._limit(piece, way, x, inner, h[first], noise)
                break
            inner = off
        if end is None:
            if way < 0:
                end = -1.0
            else:
                end = far
        stop = max(end, 0.0)
        if abs(stop - here) <= 4.0 * EPS * max(here, stop):
            if way < 0 and end < 0.0:
                # A contact of no size.
                self._add_run(Run(-1, index, here, -1.0, x, x))
                return -1.0, x, False
            return None, x, False
        turned = end >= 0.0 and last < piece.length * (1.0 - 1e-9)
        # Passage times between the breaks.
        inner = [here] + [b for b in breaks[1:-1] if (b - here) * (b - stop) < 0.0] + [stop]
        first_time = x
        for number, (near, off) in enumerate(zip(inner, inner[1:])):
            _, left, right, _ = RUN_NODES
            h = np.where(left < 0.5, near + (off - near) * left, off - (off - near) * right)
            places = self.places(h)
            times = self._passages(places, piece, way, x, last if end >= 0.0 else piece.length)
            final = number == len(inner) - 2
            if final and end >= 0.0:
                final_time = last
            else:
                probe = self.places(np.array([off * (1.0 + (1e-12 if way < 0 else -1e-12)) if off > 0.0 else 0.0]))
                final_time = float(self._passages(probe, piece, way, x, piece.length)[0])
            times = np.where(places.contact == (way < 0), times, np.where(left < 0.5, first_time, final_time))
            times = np.maximum.accumulate(np.clip(times, first_time, final_time))
            run = Run(way, index, near, off, first_time, final_time, times)
            if final and end < 0.0:
                run.low = -1.0
                run.end_mark = -1.0
            if way > 0 and fresh and number == 0:
                run.low = -1.0
            self._add_run(run)
            first_time = final_time
        return end, first_time, turned

    def _limit(self, piece, way, x, switching, holding, noise):
        """The place between one that switches and one that does not, whose least load or gap is zero; and when."""
        low, high = switching, holding
        least, times = self._least(self.places(np.array([low, high])), piece, way, x)
        ends, when = list(least), times[0]
        for level in range(14):
            if level < 3:
                trial = low + (high - low) * np.linspace(0.0, 1.0, 9)[1:-1]
            else:
                if not ends[0] < 0.0 < ends[1]:
                    break
                # The least is nearly linear in h by now.
                middle = low - ends[0] * (high - low) / (ends[1] - ends[0])
                width = 10.0 ** -min(level - 1, 4) * (high - low)
                trial = np.array([middle - width, middle + width])
                inside = (trial - low) * (trial - high) < 0.0
                trial = trial[inside]
                if len(trial) == 0:
                    break
            least, times = self._least(self.places(trial), piece, way, x)
            holds = np.flatnonzero(least > 0.0)
            if len(holds) == 0:
                low, ends[0], when = trial[-1], least[-1], times[-1]
            else:
                first = holds[0]
                high, ends[1] = trial[first], least[first]
                if first > 0:
                    low, ends[0], when = trial[first - 1], least[first - 1], times[first - 1]
            if abs(high - low) <= 4.0 * EPS * max(abs(high), abs(low)):
                break
        if ends[0] <= 0.0 <= ends[1] and ends[1] > ends[0]:
            return low - ends[0] * (high - low) / (ends[1] - ends[0]), float(when)
        return (high if abs(ends[1]) < abs(ends[0]) else low), float(when)

    def _passages(self, places, piece, way, x, last):
        """First times from x on at which places switch; `last` where they do only there."""
        value = self.load if way < 0 else self.gap
        times = x + (last - x) * self.SAMPLES
        if isinstance(piece, Smooth):
            times = np.unique(np.concatenate([times, np.linspace(x, last, 17)]))
        values = value(places, piece, np.broadcast_to(times, (len(places.h), len(times))))
        values[:, 0] = np.maximum(values[:, 0], 0.0)
        below = values < 0.0
        first = np.argmax(below, axis=1)
        any_below = below.any(axis=1)
        rows = np.arange(len(places.h))
        low, high = times[np.maximum(first - 1, 0)], times[first]
        found = np.full(len(places.h), last)
        pick = np.flatnonzero(any_below)
        if len(pick):
            part = self._some(places, pick)
            found[pick] = bracketed(lambda t: value(part, piece, t), low[pick], high[pick], values[rows, np.maximum(first - 1, 0)][pick], values[rows, first][pick])
        return found


    # ---- what is asked at an instant

    def edge_at(self, index, x):
        """Edge at times x of pieces `index`: depths, whether there is contact, and how many runs count for the places in contact."""
        index, x = np.asarray(index), np.asarray(x, dtype=float)
        edges, runs = np.zeros(len(x)), np.zeros(len(x), dtype=int)
        contact = np.zeros(len(x), dtype=bool)
        active = np.full(len(x), -1)
        for k in range(len(x)):
            edge, touching, count = (self.relaxed_edge, True, 0) if self.relaxed_edge > 0.0 else (0.0, False, 0)
            for number, run in enumerate(self.runs):
                if (run.piece, run.first) > (index[k], x[k]):
                    break
                after = run.piece < index[k] or run.last <= x[k]
                if after:
                    touching = run.way > 0 or run.low >= 0.0
                    edge, count = (run.end if touching else 0.0), number + 1
                else:
                    active[k] = number
                    touching, count = True, number + (run.way > 0)
                    break
            edges[k], contact[k], runs[k] = edge, touching, count
        led = np.array([k for k in np.flatnonzero(active >= 0) if self.runs[active[k]].path is not None], dtype=int)
        if len(led):
            # A path is a polynomial, good to its collocation: near it the place that just carries or is just met.
            numbers, rows = active[led].copy(), index[led]
            edges[led] = [float(self.runs[number].path(np.array([t]))[0]) for number, t in zip(numbers, x[led])]
            low, high = edges[led] * (1.0 - 1e-4), edges[led] * (1.0 + 1e-4)
            ends = [self._passed(h, numbers, rows, x[led]) for h in (low, high)]
            fine = np.flatnonzero(ends[0] * ends[1] < 0.0)
            if len(fine):
                value = lambda h: self._passed(h, numbers[fine], rows[fine], x[led][fine])
                edges[led[fine]] = bracketed(value, low[fine], high[fine], ends[0][fine], ends[1][fine], iterations=40)
            active[led] = -1
        moving = np.flatnonzero(active >= 0)
        if len(moving):
            edges[moving] = self._moving_edges(active[moving], index[moving], x[moving])
        return edges, contact, runs

    def _moving_edges(self, numbers, index, x):
        low, high = np.zeros(len(x)), np.zeros(len(x))
        for k, number in enumerate(numbers):
            run = self.runs[number]
            theta, left, right, _ = RUN_NODES
            h = np.where(left < 0.5, run.start + (run.end - run.start) * left, run.end - (run.end - run.start) * right)
            h = np.concatenate([[run.start], h, [run.end]])
            times = np.concatenate([[run.first], run.times, [run.last]])
            place = int(np.clip(np.searchsorted(times, x[k], side="right") - 1, 0, len(h) - 2))
            low[k], high[k] = h[max(place - 1, 0)], h[min(place + 2, len(h) - 1)]
        return bracketed(lambda h: self._passed(h, numbers, index, x), low, high, iterations=40)

    def _passed(self, h, numbers, index, x):
        """Positive where the edge has not come by in runs under way: q inwards, the gap outwards."""
        ways = np.array([self.runs[number].way for number in numbers])
        places = self.places(h, numbers)
        found = np.zeros(len(h))
        for piece in np.unique(index):
            for way in (-1, 1):
                rows = np.flatnonzero((index == piece) & (ways == way))
                if len(rows):
                    part = self._some(places, rows)
                    of = self.load if way < 0 else self.gap
                    found[rows] = of(part, self.pieces[piece], x[rows])
        return found

    def forces(self, index, x, edges=None):
        """Forces at times of pieces, with errors of the quadrature."""
        edges, contact, runs = self.edge_at(index, x) if edges is None else edges
        index, x = np.asarray(index), np.asarray(x, dtype=float)
        if math.isfinite(self.shape.rim):
            places = self.places(np.zeros(len(x)), runs)
            q = np.zeros(len(x))
            for piece in np.unique(index):
                rows = np.flatnonzero((index == piece) & contact)
                q[rows] = self.load(self._some(places, rows), self.pieces[piece], x[rows])
            return 2.0 * self.shape.rim * q, np.zeros(len(x))
        theta, left, right, weight = FORCE_NODES
        s_all, h_all, w_all, owner = [], [], [], []
        knots = [float(self.shape.line(np.array(k))) for k in self.shape.knots]
        for k in range(len(x)):
            if not contact[k] or edges[k] <= 0.0:
                continue
            least = 1e-9 * edges[k]
            inner = sorted(h for h, number in self.turns if number <= runs[k] and least < h < edges[k] - least)
            inner += [h for h in knots if least < h < edges[k] - least]
            breaks = [0.0]
            for h in sorted(inner):
                if h - breaks[-1] > least:
                    breaks.append(h)
            breaks.append(edges[k])
            radii = self.shape.radius(np.array(breaks))
            for near, off in zip(radii, radii[1:]):
                s = np.where(left < 0.5, near + (off - near) * left, off - (off - near) * right)
                s_all.append(s)
                w_all.append((off - near) * weight)
                owner.append(np.full(len(s), k))
        force, error = np.zeros(len(x)), np.zeros(len(x))
        if not s_all:
            return force, error
        s, w, owner = np.concatenate(s_all), np.concatenate(w_all), np.concatenate(owner)
        h = np.minimum(self.shape.line(s), edges[owner])
        places = self.places(h, runs[owner])
        q = np.zeros(len(h))
        index, x = np.asarray(index), np.asarray(x, dtype=float)
        for piece in np.unique(index):
            rows = np.flatnonzero(index[owner] == piece)
            if len(rows):
                q[rows] = self.load(self._some(places, rows), self.pieces[piece], x[owner[rows]])
        q = np.where(places.contact, q, 0.0)
        np.add.at(force, owner, 2.0 * w * q)
        coarse = np.zeros(len(x))
        every = np.tile(np.arange(len(left)) % 2 == 0, len(s) // len(left))
        np.add.at(coarse, owner[every], 4.0 * w[every] * q[every])
        error = np.abs(force - coarse)
        return force, error


def bracketed(value, low, high, at_low=None, at_high=None, iterations=120):
    """Roots between brackets, all at once: Chandrupatla's inverse quadratic steps, bisection where they are not safe (Adv. Eng. Softw. 28 (1997) 145)."""
    low, high = np.array(low, dtype=float), np.array(high, dtype=float)
    at_low = np.array(value(low) if at_low is None else at_low, dtype=float)
    at_high = np.array(value(high) if at_high is None else at_high, dtype=float)
    new, at_new, other, at_other = low, at_low, high, at_high
    with np.errstate(all="ignore"):
        part = np.full(len(low), 0.5)
        for _ in range(iterations):
            nearer = np.abs(at_other) < np.abs(at_new)
            root, left = np.where(nearer, other, new), np.where(nearer, at_other, at_new)
            least = 2.0 * EPS * np.abs(root) / np.abs(other - new)
            done = ~(least < 0.5) | (left == 0.0)
            if done.all():
                break
            trial = new + np.clip(part, least, 1.0 - least) * (other - new)
            trial = np.where(done, root, trial)
            found = value(trial)
            same = (found > 0.0) == (at_new > 0.0)
            last, at_last = np.where(same, new, other), np.where(same, at_new, at_other)
            other, at_other = np.where(same, other, new), np.where(same, at_other, at_new)
            new, at_new = trial, np.where(done, left, found)
            way, rise = (new - other) / (last - other), (at_new - at_other) / (at_last - at_other)
            smooth = (rise * rise < way) & ((1.0 - rise) ** 2 < 1.0 - way)
            inverse = at_new / (at_other - at_new) * at_last / (at_other - at_last) + (last - new) / (other - new) * at_new / (at_last - at_new) * at_other / (at_last - at_other)
            part = np.where(smooth, inverse, 0.5)
    return root


# ---------------------------------------------------------------- levels

def lobatto(count):
    """Chebyshev's extreme places on (0, 1), values to coefficients, and coefficients to integrals from 0 (coefficients again)."""
    z = -np.cos(np.pi * np.arange(count) / (count - 1))
    to_coefficients = np.linalg.inv(chebvander(z, count - 1))
    integral = np.zeros((count + 1, count))
    for k in range(count):
        unit = np.zeros(count)
        unit[k] = 1.0
        own = np.polynomial.chebyshev.chebint(unit, lbnd=-1.0) * 0.5
        integral[: len(own), k] = own
    return 0.5 * (1.0 + z), to_coefficients, integral


PANEL_NODES = 13
PANEL, TO_COEFFICIENTS, INTEGRAL = lobatto(PANEL_NODES)
GRADES = np.concatenate([[0.0], 10.0 ** np.arange(-8.0, -1.0), [0.05, 0.14, 0.3, 0.5]])
GRADES = np.concatenate([GRADES, 1.0 - GRADES[-2::-1]])


def graded_panels(breaks, fine=True):
    """Panels between breaks, finer towards each of them."""
    parts = GRADES if fine else np.array([0.0, 0.5, 1.0])
    edges = [np.array(breaks[:1])]
    for low, high in zip(breaks, breaks[1:]):
        left = low + (high - low) * parts
        right = high - (high - low) * parts[::-1]
        edges.append(np.where(parts < 0.5, left, right)[1:])
    edges = np.concatenate(edges)
    keep = np.concatenate([[True], np.diff(edges) > 1e-15 * edges[-1]])
    return edges[keep]


class Level:
    """Places on panels of s with values p that rise with s, one row an instant: int (y - p) ds up to where p reaches y."""

    def __init__(self, edges):
        self.edges = edges
        self.width = np.diff(edges)
        self.s = edges[:-1, None] + self.width[:, None] * PANEL
        self.s[:, -1] = edges[1:]

    def take(self, values):
        """values [instants, panels, nodes of a panel]."""
        self.values = values
        self.coefficients = values @ TO_COEFFICIENTS.T
        areas = np.sum((self.coefficients @ INTEGRAL.T), axis=-1) * self.width
        self.areas = np.concatenate([np.zeros((len(values), 1)), np.cumsum(areas, axis=1)], axis=1)

    def whole(self):
        return self.areas[:, -1]

    def integral(self, levels):
        """Integrals, radii reached, and whether the last panel was passed."""
        rows = np.arange(len(levels))
        ends = self.values[:, :, -1]
        panel = np.minimum(np.sum(ends < levels[:, None], axis=1), ends.shape[1] - 1)
        beyond = levels > ends[:, -1]
        own = self.coefficients[rows, panel]
        low, high = np.zeros(len(levels)), np.ones(len(levels))
        first, last = self.values[rows, panel, 0] - levels, self.values[rows, panel, -1] - levels
        inside = (first < 0.0) & (last > 0.0)
        part = np.where(last <= 0.0, 1.0, 0.0)
        pick = np.flatnonzero(inside)
        if len(pick):
            chosen = own[pick]

            def value(z):
                return np.sum(chebvander(2.0 * z - 1.0, chosen.shape[1] - 1) * chosen, axis=1) - levels[pick]

            part[pick] = bracketed(value, low[pick], high[pick], first[pick], last[pick])
        radius = self.edges[panel] + self.width[panel] * part
        rest = np.sum(chebvander(2.0 * part - 1.0, PANEL_NODES) * (own @ INTEGRAL.T), axis=1) * self.width[panel]
        area = self.areas[rows, panel] + rest
        return levels * (radius - self.edges[0]) - area, radius, beyond


class Moment:
    """A place in time that a lag can be counted to, before its piece is known."""

    def __init__(self, start):
        self.start = start


# ---------------------------------------------------------------- histories

class History:
    """What is done, leg after leg, in any quantity; `legs` holds the pieces of each."""

    def __init__(self, solid, shape, stiffness=None):
        self.contact = Contact(solid, shape)
        self.solid, self.shape, self.stiffness = solid, shape, stiffness
        self.legs = []
        self.here = None
        self.afloat = set()
        self.known = {}
        self.collocation = 0.0

    # Positions are (piece, time in it).

    def now(self):
        return len(self.contact.pieces) - 1, self.contact.pieces[-1].length

    def begin(self, quantity, value, relaxed):
        contact = self.contact
        if relaxed:
            depth = self._elastic_depth(quantity, value, self.solid.relaxed)
            contact.relaxed_at(depth)
        contact.go(Jump(self.solid, contact.time, contact.depth, contact.depth, contact.memory))
        self.here = (quantity, value)
        if not relaxed:
            depth = self._elastic_depth(quantity, value, self.solid.glassy)
            contact.jump(depth)

    def _elastic_depth(self, quantity, value, modulus):
        shape = self.shape
        if quantity == "penetration" or (value <= 0.0 and quantity != "force"):
            return value
        punch = math.isfinite(shape.rim)
        if quantity == "contact_radius":
            return float(shape.line(np.array(value)))
        imposed = {"force": lambda depth, force: force, "frame": lambda depth, force: depth + force / self.stiffness}[quantity]
        if punch:
            slope = 2.0 * shape.rim * modulus
            return value / slope if quantity == "force" else value * self.stiffness / (self.stiffness + slope)
        if value <= 0.0:
            return 0.0
        elastic = lambda s: imposed(float(shape.line(np.array(s))), modulus * float(shape.elastic(np.array(s))))
        low, high = 0.0, shape.knots[-1] if len(shape.knots) else 1.0
        while elastic(high) < value:
            high *= 2.0
        while elastic(0.5 * high) > value:
            high *= 0.5
        radius = bracketed(lambda s: np.array([elastic(s[0]) - value]), np.array([0.5 * high]), np.array([high]))[0]
        return float(shape.line(np.array(radius)))

    def step(self, quantity, value):
        first = len(self.contact.pieces)
        self.contact.corner()
        if quantity == "penetration":
            self.contact.jump(value)
        else:
            self._step(quantity, value)
        self.here = (quantity, value)
        self.legs.append((first, len(self.contact.pieces)))

    def ramp(self, quantity, end, duration, oscillation=None):
        """Straight to a value, or with an oscillation (function of the time in the leg, and the times of its extremes) about the straight way."""
        if duration <= 0.0:
            self.step(quantity, end)
            return
        first = len(self.contact.pieces)
        self.contact.corner()
        start = self.value_of(quantity)
        if quantity == "penetration":
            if oscillation is None:
                self.contact.straight(end, duration)
            else:
                self._follow(lambda x: start + (end - start) * (x / duration) + oscillation[0](x), oscillation[1], duration)
        else:
            way = (lambda x: start + (end - start) * (x / duration)) if oscillation is None else (
                lambda x: start + (end - start) * (x / duration) + oscillation[0](x))
            self._ramp(quantity, way, duration, start, end, oscillation)
        self.here = (quantity, end if oscillation is None else end + float(oscillation[0](duration)))
        self.legs.append((first, len(self.contact.pieces)))

    def value_of(self, quantity):
        """The present value of a quantity."""
        if self.here[0] == quantity:
            return self.here[1]
        contact = self.contact
        if quantity == "penetration":
            return contact.depth
        position = self.now()
        edge = contact.edge_at([position[0]], [position[1]])
        if quantity == "contact_radius":
            return float(self.shape.radius(edge[0])[0]) if edge[1][0] else 0.0
        force = float(contact.forces([position[0]], [position[1]], edge)[0][0])
        return force if quantity == "force" else contact.depth + force / self.stiffness

    def _follow(self, way, breaks, duration):
        """The penetration follows a smooth function of time, pieces between the given times."""
        contact = self.contact
        times = [0.0] + [b for b in breaks if 1e-12 * duration < b < duration * (1.0 - 1e-12)] + [duration]
        count = FOLLOWED
        z = np.cos(np.pi * (np.arange(count) + 0.5) / count)
        for low, high in zip(times, times[1:]):
            x = low + 0.5 * (high - low) * (1.0 + z)
            values = way(x)
            coefficients = 2.0 / count * np.cos(np.outer(np.arange(count), np.pi * (np.arange(count) + 0.5) / count)) @ values
            coefficients[0] *= 0.5
            # It goes on exactly from where it is.
            coefficients[0] += contact.depth - chebval(-1.0, coefficients)
            contact.go(Smooth(self.solid, contact.time, high - low, coefficients, contact.memory))

    # ---- other quantities: at each instant an equation for the level of the penetration (Graham)

    NODES = 13
    TAIL = 1e-12
    SHORTEST = 1e-10
    TOWARDS_END = 0.36

    def _breaks(self, low, high):
        """Radii between two at which the past of the places, or the shape, changes."""
        contact = self.contact
        inner = [h for h, _ in contact.turns] + [float(self.shape.line(np.array(k))) for k in self.shape.knots]
        depths = [low] + sorted(h for h in inner if low + 1e-9 * high < h < high * (1.0 - 1e-9)) + [high]
        kept = [depths[0]]
        for h in depths[1:]:
            if h - kept[-1] > 1e-10 * high:
                kept.append(h)
        kept[-1] = high
        return self.shape.radius(np.array(kept))

    def _held(self, places, moment, x):
        """-(q - kappa) of places in contact at times x [places, times]: what the level kappa = int R dD must reach for q > 0."""
        memory = places.state[:, None, :] * np.exp(-np.multiply.outer(self.contact.lag(places, moment, x), self.solid.rates)) if len(self.solid.rates) else None
        hold = np.repeat(self.solid.relaxed * places.h[:, None], x.shape[1], axis=1)
        return hold - memory @ self.solid.moduli if memory is not None else hold

    def _free(self, places, moment, x):
        """h + W of free places at times x: what the penetration must reach to meet them."""
        free = np.repeat(places.h[:, None], x.shape[1], axis=1)
        if len(self.solid.rates):
            free = free + np.sum(places.state[:, None, :] * np.exp(-np.multiply.outer(self.contact.lag(places, moment, x), self.solid.slow)), axis=-1)
        return free

    def _profile(self, level, moment, x, inside):
        h = self.shape.line(level.s.ravel())
        edge = self.contact.edge
        h = np.minimum(h, edge * (1.0 - 1e-14)) if inside else np.maximum(h, edge)
        key = (len(self.contact.pieces), inside, level.edges.tobytes())
        if key not in self.known:
            # Another length of the same piece asks for the same places.
            self.known = {old: value for old, value in self.known.items() if old[0] == key[0]}
            self.known[key] = self.contact.places(h)
        places = self.known[key]
        # Exactly at a turn the last run may have gone by or not: both are the same place.
        times = np.broadcast_to(x, (len(h), len(x)))
        held, free = self._held, self._free
        want = np.full(len(h), inside)
        found = (held if inside else free)(places, moment, times)
        odd = np.flatnonzero(places.contact != want)
        for row in odd:
            near = np.array([h[row] * (1.0 - 1e-11) if inside else h[row] * (1.0 + 1e-11) + 1e-300])
            other = self.contact.places(near)
            if other.contact[0] == inside:
                found[row] = (held if inside else free)(other, moment, x[None, :])[0]
            else:
                found[row] = np.nan
        if len(odd):
            bad = np.isnan(found).any(axis=1)
            good = np.flatnonzero(~bad)
            for row in np.flatnonzero(bad):
                found[row] = found[good[np.argmin(np.abs(good - row))]]
        values = found.T.reshape(len(x), *level.s.shape)
        level.take(values)

    def _operators(self, length):
        """Nodes, their time operators: int R dD = relaxing @ D + history."""
        count = self.NODES
        z = -np.cos(np.pi * np.arange(count) / (count - 1))
        x = 0.5 * length * (1.0 + z)
        relaxing = self.solid.relaxed * np.eye(count)
        history = np.zeros(count)
        for i, rate in enumerate(self.solid.rates):
            relaxing = relaxing + self.solid.moduli[i] * memory_matrix(rate * length, count)
            history = history + self.solid.moduli[i] * self.contact.memory[i] * np.exp(-rate * x)
        return x, relaxing, history

    def _imposed(self, quantity, depth, force):
        return force if quantity == "force" else depth + force / self.stiffness

    def _ramp(self, quantity, way, duration, start, end, oscillation):
        contact = self.contact
        # Measured against tighter pieces and more nodes: below 1e-9 under loads, 1e-11 under radii.
        self.collocation = max(self.collocation, 2e-11 if quantity == "contact_radius" else 3e-9)
        marks = [0.0, duration]
        if oscillation is not None:
            marks[1:1] = [b for b in oscillation[1] if 1e-12 * duration < b < duration * (1.0 - 1e-12)]
        for low, high in zip(marks, marks[1:]):
            if quantity == "contact_radius":
                self._radius_stretch(way, low, high)
            else:
                self._load_stretch(quantity, way, low, high)

    def _accept(self, length, depths):
        coefficients = np.linalg.inv(chebvander(-np.cos(np.pi * np.arange(len(depths)) / (len(depths) - 1)), len(depths) - 1)) @ depths
        scale = max(self.contact.largest, float(np.max(np.abs(depths))))
        return coefficients, float(np.sum(np.abs(coefficients[-2:]))) / scale if scale else 0.0

    def _go(self, length, coefficients, end, path):
        contact = self.contact
        if math.isfinite(self.shape.rim):
            # All places are the tip, whatever depth a punch would have them at.
            contact.go(Smooth(self.solid, contact.time, length, coefficients, contact.memory))
            return
        contact.led(Smooth(self.solid, contact.time, length, coefficients, contact.memory), end, path)

    def _radius_stretch(self, way, low, high):
        contact = self.contact
        total, done, length = high - low, 0.0, 1e-3 * (high - low)
        while done < total * (1.0 - 1e-13):
            length = min(length, total - done)
            if total - done - length < 1e-9 * total:
                length = total - done
            x, relaxing, history = self._operators(length)
            radius = np.maximum(np.array([way(low + done + t) for t in x]), 0.0)
            h = self.shape.line(radius)
            moment = Moment(contact.time)
            rising = h[-1] > h[0]
            own = np.minimum(h, contact.edge * (1.0 - 1e-14)) if not rising else np.maximum(h, contact.edge * (1.0 + 1e-14))
            kinks = [b for b, _ in contact.turns if (b - h[0]) * (b - h[-1]) < 0.0 and min(abs(b - h[0]), abs(b - h[-1])) > 1e-9 * max(h[0], h[-1])]
            if kinks:
                kink = min(kinks, key=lambda b: abs(b - h[0]))
                cut = bracketed(lambda t: self.shape.line(np.array([max(way(low + done + v), 0.0) for v in t])) - kink, np.array([0.0]), np.array([length]))[0]
                if cut > self.SHORTEST * total:
                    length = cut
                    continue
            places = contact.places(own)
            if rising:
                depths = self._free(places, moment, x[:, None])[:, 0]
            else:
                level = self._held(places, moment, x[:, None])[:, 0] - history
                depths = np.concatenate([[contact.depth], np.zeros(len(x) - 1)])
                depths[1:] = np.linalg.solve(relaxing[1:, 1:], level[1:] - relaxing[1:, 0] * contact.depth)
            depths[0] = contact.depth
            coefficients, tail = self._accept(length, depths)
            if tail > self.TAIL and length > self.SHORTEST * total:
                length *= 0.35
                continue
            if contact.open and rising:
                contact.events.append(("touch", len(contact.pieces), 0.0))
                contact.open = False
            self._go(length, coefficients, h[-1], lambda t, at=low + done: self.shape.line(np.maximum(np.array([way(at + v) for v in np.atleast_1d(t)]), 0.0)))
            done += length
            length *= 3.0

    def _float(self, length):
        """Nothing holds the indenter for a while."""
        contact = self.contact
        contact.pieces.append(Jump(self.solid, contact.time, contact.depth, contact.depth, contact.memory))
        if length > 0.0:
            piece = Straight(self.solid, contact.time, length, contact.depth, contact.depth, contact.memory)
            self.afloat.add(len(contact.pieces))
            contact.pieces.append(piece)
            contact.memory, contact.time = piece.end_memory, piece.start + LONG(length)
        # The surface comes up to it and takes it along.
        surface = self._surface()
        if surface < contact.depth:
            contact.pieces.append(Jump(self.solid, contact.time, contact.depth, surface, contact.memory))
            contact.memory, contact.depth = contact.memory + (surface - contact.depth), surface
            self.afloat.add(len(contact.pieces) - 1)

    def _surface(self):
        """Where the free surface is under the tip."""
        contact = self.contact
        return float(self._free(contact.places(np.zeros(1)), Moment(contact.time), np.zeros((1, 1)))[0, 0])

    def _load_stretch(self, quantity, way, low, high):
        contact = self.contact
        total, done = high - low, 0.0
        first = 1e-4 * total
        length = first
        punch = math.isfinite(self.shape.rim)
        guard = 0
        zero = math.inf                 # when the contact lets go, at the latest
        while done < total * (1.0 - 1e-13):
            guard += 1
            if guard > 600:
                raise RuntimeError("a stretch under load has too many pieces")
            if contact.open:
                if quantity == "force":
                    # Until it is pushed.
                    samples = np.linspace(low + done, high, 65)
                    pushed = np.flatnonzero(np.array([way(t) for t in samples]) > 0.0)
                    if len(pushed) == 0:
                        self._float(total - done)
                        return
                    if pushed[0] > 0:
                        root = bracketed(lambda t: np.array([way(t[0])]), samples[pushed[0] - 1 : pushed[0]], samples[pushed[0] : pushed[0] + 1])[0]
                        self._float(max(root - low - done, 0.0))
                        done = root - low
                    self._touch_again()
                    length = min(first, 1e-6 * (total - done))
                else:
                    # The far end moves and nothing pushes: the indenter goes with it.
                    rest = total - done
                    before = len(contact.pieces)
                    start, end = way(low + done), way(high)
                    straight = abs(way(low + done + 0.5 * rest) - 0.5 * (start + end)) <= 1e-13 * (abs(start) + abs(end))
                    touch = self._frame_touch(way, low + done, rest)
                    free = rest if touch is None else touch
                    if free > 0.0:
                        if straight:
                            contact.straight(start + (end - start) * (free / rest), free)
                        else:
                            self._follow(lambda x, at=low + done: np.array([way(at + t) for t in x]), [], free)
                    done += free
                    if touch is None:
                        return
                    if contact.open:
                        self._touch_again()
                    length = min(first, 1e-6 * (total - done))
                continue
            length = min(length, total - done)
            if total - done - length < 1e-9 * total:
                length = total - done
            if zero < math.inf:
                # Towards the end of a contact everything goes with roots of the time left.
                if zero - done <= self.SHORTEST * total:
                    self._let_go(max(zero - done, 0.0), way(low + zero) if quantity == "frame" else None)
                    done, length, zero = max(zero, done), first, math.inf
                    continue
                length = min(length, self.TOWARDS_END * (zero - done))
            outcome = self._load_piece(quantity, way, low + done, length, punch)
            kind = outcome[0]
            if kind == "zero":
                zero = done + outcome[1]
                if quantity == "force":
                    # The time at which the force is gone is given.
                    zero = float(bracketed(lambda t: np.array([way(low + v) for v in t]), np.array([done]), np.array([zero]))[0])
                length *= 0.9
                continue
            if kind == "cut":
                # The edge turns, passes a kink, or lets go within the piece.
                if outcome[1] > self.SHORTEST * total and outcome[1] < length * (1.0 - 1e-9):
                    length = outcome[1]
                    continue
                kind = "shorter"
            if kind == "shorter" and length > self.SHORTEST * total:
                length *= 0.3
                continue
            if outcome[-1] is None:
                raise RuntimeError("a stretch under load does not go on")
            coefficients, path = outcome[-1], self.path
            if path is None:
                self._go(length, coefficients, contact.edge, None)
            else:
                fit = np.linalg.solve(chebvander(np.linspace(-1.0, 1.0, 1) if len(path) == 1 else -np.cos(np.pi * np.arange(len(path)) / (len(path) - 1)), len(path) - 1), path)
                self._go(length, coefficients, float(self.shape.line(np.array(path[-1]))),
                         lambda t, fit=fit, length=length: self.shape.line(np.maximum(chebval(2.0 * np.asarray(t) / length - 1.0, fit), 0.0)))
            done += length
            length *= 3.0
            if contact.open and zero < math.inf:
                # It has let go, to rounding: nothing touches it again before the load is gone.
                if quantity == "force":
                    self._float(max(zero - done, 0.0))
                    done = max(zero, done)
                length, zero = first, math.inf

    def _touch_again(self):
        contact = self.contact
        surface = self._surface()
        contact.pieces.append(Jump(self.solid, contact.time, contact.depth, surface, contact.memory))
        contact.memory = contact.memory + (surface - contact.depth)
        contact.depth = surface
        contact.open, contact.edge = False, 0.0
        contact.events.append(("touch", len(contact.pieces) - 1, 0.0))
        self.fresh = True

    def _frame_touch(self, way, at, rest):
        contact = self.contact
        places, moment = contact.places(np.zeros(1)), Moment(contact.time)
        samples = rest * np.unique(np.concatenate([contact.SAMPLES, np.linspace(0.0, 1.0, 65)]))
        gap = lambda t: self._free(places, moment, t[None, :])[0] - np.array([way(at + v) for v in t])
        found = gap(samples)
        found[0] = abs(found[0])
        below = np.flatnonzero(found < -4.0 * EPS * contact.largest)
        if len(below) == 0:
            return None
        k = below[0]
        return float(bracketed(gap, samples[k - 1 : k], samples[k : k + 1])[0])

    def _let_go(self, length, depth):
        """The last of a contact: down to where the tip leaves the surface."""
        contact = self.contact
        sudden = length <= 1e-15 * float(contact.time)
        length = max(length, 1e-300)
        if depth is None:
            x, relaxing, history = self._operators(length)
            level = self._held(contact.places(np.zeros(1)), Moment(contact.time), x[None, :])[0] - history
            depths = np.concatenate([[contact.depth], np.linalg.solve(relaxing[1:, 1:], level[1:] - relaxing[1:, 0] * contact.depth)])
            depth = depths[-1] - 1e-9 * max(contact.largest, 1e-300)
        if sudden:
            contact.jump(depth)
        else:
            contact.straight(depth, length)
        length = contact.pieces[-1].length
        if not contact.open:
            index = len(contact.pieces) - 1
            contact._add_run(Run(-1, index, contact.edge, -1.0, length, length))
            contact.events.append(("detachment", index, length, 0.0))
            contact.edge, contact.open = 0.0, True

    def _load_piece(self, quantity, way, at, length, punch):
        contact, solid = self.contact, self.solid
        self.path = None
        x, relaxing, history = self._operators(length)
        target = np.array([way(at + t) for t in x])
        moment = Moment(contact.time)
        own = relaxing[1:, 1:]
        started = relaxing[1:, 0] * contact.depth + history[1:]
        soft = quantity == "frame"
        if punch:
            tip = self._held(contact.places(np.zeros(1)), moment, x[None, :])[0][1:]
            size = 2.0 * self.shape.rim
            if soft:
                # D + size (kappa - tip)/k = X
                system = np.eye(len(tip)) + size / self.stiffness * own
                depths = np.linalg.solve(system, target[1:] - size / self.stiffness * (started - tip))
            else:
                depths = np.linalg.solve(own, target[1:] / size + tip - started)
            force = size * (own @ depths + started - tip)
            if np.any(force < 0.0):
                return self._first_zero(x, np.concatenate([[max(self._force_now(), 0.0)], force]), None)
            coefficients, tail = self._accept(length, np.concatenate([[contact.depth], depths]))
            return ("right", coefficients) if tail <= self.TAIL else ("shorter", coefficients)
        edge_radius = float(self.shape.radius(np.array(contact.edge)))
        inner = None
        if contact.edge > 0.0:
            inner = Level(graded_panels(self._breaks(0.0, contact.edge)))
            self._profile(inner, moment, x[1:], True)
        # The place at the edge, were it just to stay: what would be imposed then.
        rising = True
        if inner is not None:
            marginal = inner.values[:, -1, -1]
            stay = np.linalg.solve(own, marginal - started)
            force = 2.0 * (marginal * edge_radius - inner.whole())
            excess = target[1:] - self._imposed(quantity, stay, force)
            scale = float(np.max(np.abs(target))) + 1e-300
            clear = np.flatnonzero(np.abs(excess) > 1e-12 * scale)
            if len(clear) == 0:
                coefficients, tail = self._accept(length, np.concatenate([[contact.depth], stay]))
                return ("right", coefficients) if tail <= self.TAIL else ("shorter", coefficients)
            rising = excess[clear[0]] > 0.0
        if not rising:
            kappa = marginal.copy()
            for _ in range(60):
                area, radius, _ = inner.integral(kappa)
                force = 2.0 * area
                depths = np.linalg.solve(own, kappa - started)
                wrong = self._imposed(quantity, depths, force) - target[1:]
                if soft:
                    inverse = np.linalg.inv(own)
                    step = np.linalg.solve(inverse + np.diag(2.0 * radius / self.stiffness), wrong)
                else:
                    step = wrong / np.maximum(2.0 * radius, 1e-3 * edge_radius)
                kappa = kappa - step
                if np.max(np.abs(step)) <= 1e-14 * np.max(np.abs(kappa)) or np.max(np.abs(wrong)) <= 2e-15 * scale:
                    break
            area, radius, _ = inner.integral(kappa)
            depths = np.linalg.solve(own, kappa - started)
            force = 2.0 * area
            if np.any(kappa <= inner.values[:, 0, 0]):
                return self._first_zero(x, np.concatenate([[max(self._force_now(), 0.0)], np.where(kappa > inner.values[:, 0, 0], np.maximum(force, 0.0), -1e-300)]), None)
        else:
            reach = float(self.shape.radius(np.array(max(contact.reached, contact.edge))))
            cap = max(1.2 * reach, 1.05 * edge_radius)
            if contact.edge == 0.0 and contact.reached == 0.0:
                cap = float(self.shape.radius(np.array(self._elastic_depth(quantity, float(np.max(target)), solid.relaxed if solid.relaxed > 0.0 else 1e-4 * solid.glassy)))) * 1.1
            for _ in range(60):
                outcome = self._advance(quantity, target, x, own, started, moment, inner, edge_radius, cap)
                if outcome is not None:
                    break
                cap *= 1.6
            else:
                return "shorter", None
            depths, radius = outcome
        coefficients, tail = self._accept(length, np.concatenate([[contact.depth], depths]))
        path = np.concatenate([[edge_radius], radius])
        steps = np.diff(path) * (1.0 if rising else -1.0)
        # Rounding does not turn the edge.
        self.path = (np.maximum if rising else np.minimum).accumulate(path)
        if np.any(steps < -1e-9 * max(path)):
            # The extreme of the path, by its polynomial.
            fit = np.linalg.solve(chebvander(2.0 * x / length - 1.0, len(x) - 1), path)
            grid = np.linspace(0.0, length, 400)
            values = chebval(2.0 * grid / length - 1.0, fit) * (1.0 if rising else -1.0)
            falls = np.flatnonzero(np.diff(values) < 0.0)
            falls = falls[falls > 0]
            place = falls[0] if len(falls) else 40
            slope = chebder(fit)
            slopes = chebval(2.0 * grid / length - 1.0, slope)
            k = min(max(place, 1), 397)
            if slopes[k - 1] * slopes[k + 1] < 0.0:
                cut = bracketed(lambda t: chebval(2.0 * t / length - 1.0, slope), grid[k - 1 : k], grid[k + 1 : k + 2])[0]
            else:
                cut = grid[place]
            return "cut", float(min(cut, 0.9 * length) if cut > 0.9 * length and tail > 1e-6 else cut), coefficients
        # A kink of the past passed within the piece.
        kinks = [self.shape.radius(np.array(h)) for h, _ in contact.turns] + list(self.shape.knots)
        near = 1e-8 * max(path)
        passed = [float(k) for k in kinks if min(path) + near < k < max(path) - near]
        if passed and length > 0.0:
            kink = min(passed, key=lambda k: abs(k - edge_radius))
            order = path if rising else -path
            sign = 1.0 if rising else -1.0
            place = int(np.searchsorted(np.maximum.accumulate(order), sign * kink))
            a, b = max(place - 1, 0), min(place, len(x) - 1)
            fit = np.linalg.solve(chebvander(2.0 * x / length - 1.0, len(x) - 1), path)
            value = lambda t: chebval(2.0 * t / length - 1.0, fit) - kink
            ends = value(np.array([x[a], x[b]]))
            cut = bracketed(value, np.array([x[a]]), np.array([x[b]]))[0] if ends[0] * ends[1] < 0.0 else x[b]
            return "cut", float(cut), coefficients
        return ("right", coefficients) if tail <= self.TAIL else ("shorter", coefficients)

    def _force_now(self):
        position = self.now()
        return float(self.contact.forces([position[0]], [position[1]])[0][0])

    @staticmethod
    def _first_zero(x, force, _):
        return "zero", float(x[int(np.argmax(force < 0.0))]), None

    def _advance(self, quantity, target, x, own, started, moment, inner, edge_radius, cap):
        """Penetrations and radii at the nodes of a piece in which the edge advances; none where the panels end before it does."""
        contact = self.contact
        depth_cap = float(self.shape.line(np.array(cap)))
        if len(self.shape.knots) and cap > self.shape.knots[-1]:
            pass
        breaks = self._breaks(contact.edge, depth_cap)
        outer = Level(graded_panels(breaks, True))
        self._profile(outer, moment, x[1:], False)
        soft = quantity == "frame"
        if inner is not None:
            base = -2.0 * inner.whole()
            depths = np.linalg.solve(own, inner.values[:, -1, -1] - started)
        else:
            base = np.zeros(len(x) - 1)
            depths = outer.values[:, 0, 0] + 1e-3 * (outer.values[:, -1, -1] - outer.values[:, 0, 0])
        size = 2.0 * edge_radius
        scale = float(np.max(np.abs(target))) + 1e-300
        best = None
        for step_number in range(80):
            # Below the edge nothing is met: the overlap is linear there, so that Newton finds its way.
            area, radius, beyond = outer.integral(np.minimum(depths, outer.values[:, -1, -1]))
            if np.any(depths > outer.values[:, -1, -1]) and step_number > 3:
                return None
            overlap = 2.0 * area
            force = size * (own @ depths + started) + base + own @ overlap
            wrong = self._imposed(quantity, depths, force) - target[1:]
            slope = size * own + own * (2.0 * np.maximum(radius - edge_radius, 1e-6 * cap))[None, :]
            if soft:
                slope = np.eye(len(depths)) + slope / self.stiffness
            step = np.linalg.solve(slope, wrong)
            depths = depths - step
            worst = float(np.max(np.abs(wrong)))
            if np.max(np.abs(step)) <= 1e-14 * max(contact.largest, float(np.max(np.abs(depths)))) or (worst <= 1e-15 * scale):
                break
            if best is None or worst < best:
                best = worst
        if np.any(depths > outer.values[:, -1, -1]):
            return None
        radius = outer.integral(depths)[1]
        return depths, radius

    def _step(self, quantity, value):
        contact, solid = self.contact, self.solid
        punch = math.isfinite(self.shape.rim)
        if quantity == "contact_radius":
            h = float(self.shape.line(np.array(value)))
            places, moment = contact.places(np.array([h])), Moment(contact.time)
            if h < contact.edge and not contact.open:
                # q = 0 after the jump.
                q = self._now_load(places, moment)[0]
                contact.jump(contact.depth - q / solid.glassy)
            else:
                contact.jump(float(self._free(places, moment, np.zeros((1, 1)))[0, 0]))
            if abs(contact.edge - h) > 1e-6 * max(h, contact.edge):
                raise NotImplementedError("a step of the radius of a contact that carries nothing any more")
            return
        if quantity == "force" and value <= 0.0:
            if not contact.open:
                contact.go(Jump(solid, contact.time, contact.depth, self._surface_if_freed(), contact.memory))
                if not contact.open:
                    raise RuntimeError("a contact without force does not open")
            return
        if contact.open and quantity == "frame" and value <= self._surface():
            contact.jump(value)
            return
        if contact.open:
            # From wherever it floats to the surface first.
            self._touch_again()
        moment = Moment(contact.time)
        x = np.zeros(1)
        if punch:
            places = contact.places(np.zeros(1))
            now = self._now_load(places, moment)[0] / solid.glassy if places.contact[0] else contact.depth - float(self._free(places, moment, np.zeros((1, 1)))[0, 0])
            size = 2.0 * self.shape.rim * solid.glassy
            # size (d + now) = F, or contact.depth + d + size (d + now)/k = X
            if quantity == "force":
                change = value / size - now
            else:
                change = (value - contact.depth - size * now / self.stiffness) / (1.0 + size / self.stiffness)
                if change + now <= 0.0:
                    change = value - contact.depth
            contact.jump(contact.depth + change)
            return
        edge_radius = float(self.shape.radius(np.array(contact.edge)))
        cap = max(1.3 * float(self.shape.radius(np.array(max(contact.reached, contact.edge, 1e-300)))), 1e-300)
        for _ in range(200):
            depth_cap = float(self.shape.line(np.array(cap)))
            level = Level(graded_panels(self._breaks(0.0, depth_cap)))
            h = self.shape.line(level.s.ravel())
            places = contact.places(h)
            held = contact.depth - self._free(places, moment, np.zeros((len(h), 1)))[:, 0]
            load = self._now_load(places, moment) / solid.glassy
            # Change of the penetration from which a place carries.
            needed = np.where(places.contact, -load, -held)
            needed = np.maximum.accumulate(needed)
            level.take(needed.reshape(1, *level.s.shape))
            top = level.values[0, -1, -1]

            def imposed(change):
                force = 2.0 * solid.glassy * float(level.integral(np.array([change]))[0][0])
                return self._imposed(quantity, contact.depth + change, force)

            if imposed(top) >= value:
                break
            cap *= 1.5
        low = level.values[0, 0, 0]
        if imposed(low) >= value:
            # Nothing carries.
            contact.jump(value if quantity == "frame" else contact.depth + low)
            return
        change = bracketed(lambda c: np.array([imposed(c[0]) - value]), np.array([low]), np.array([top]), iterations=200)[0]
        contact.jump(contact.depth + change)

    def _now_load(self, places, moment):
        q = self.solid.relaxed * (self.contact.depth - places.h)
        if len(self.solid.rates):
            springs = places.state * np.exp(-np.multiply.outer(self.contact.lag(places, moment, 0.0), self.solid.rates)) + self.contact.memory
            q = q + springs @ self.solid.moduli
        return q

    def _surface_if_freed(self):
        """The penetration at which nothing carries any more."""
        places, moment = self.contact.places(np.zeros(1)), Moment(self.contact.time)
        return self.contact.depth - self._now_load(places, moment)[0] / self.solid.glassy - 1e-9 * self.contact.largest

    # ---- what is asked

    def at_time(self, time):
        """The position of a time since the start; the last one where several pieces share it."""
        pieces = self.contact.pieces
        starts = np.array([float(piece.start) for piece in pieces])
        index = max(int(np.searchsorted(starts, time, side="right")) - 1, 0)
        return index, min(max(float(LONG(time) - pieces[index].start), 0.0), pieces[index].length)

    def in_leg(self, leg, part):
        """The position at a part of the duration of a leg."""
        first, end = self.legs[leg]
        pieces = self.contact.pieces
        total = sum(pieces[k].length for k in range(first, end))
        if first == end:
            return first - 1, pieces[first - 1].length
        left = part * total
        for k in range(first, end):
            if left <= pieces[k].length or k == end - 1:
                return k, min(left, pieces[k].length)
            left -= pieces[k].length
        return end - 1, pieces[end - 1].length

    def values(self, positions):
        """Penetration, force, radius, and the errors of quadrature of the force at positions."""
        index, x = [p[0] for p in positions], [p[1] for p in positions]
        edges = self.contact.edge_at(index, x)
        force, error = self.contact.forces(index, x, edges)
        radius = np.where(edges[1], self.shape.radius(np.maximum(edges[0], 0.0)), 0.0)
        depth = np.array([float(self.contact.pieces[k].depth(t)) for k, t in zip(index, x)])
        return depth, force, radius, error, edges

    def floating(self, position):
        """Whether the indenter is off the surface under a force, so that its place is a matter of taste."""
        return position[0] in self.afloat

    def tolerance(self, quantity):
        """Own error, over the largest value, of what collocation adds."""
        return self.collocation

    def time_of(self, piece, x):
        return float(self.contact.pieces[piece].start + LONG(x))


_BASES = {}


def memory_matrix(stiffness, count):
    """int exp(-r (x - x')) dD at the nodes of a piece from D there, r times the length being `stiffness`."""
    if count not in _BASES:
        z = -np.cos(np.pi * np.arange(count) / (count - 1))
        to_coefficients = np.linalg.inv(chebvander(z, count - 1))
        slope = np.zeros((count, count))
        for k in range(1, count):
            own = chebder(np.eye(count)[k])
            slope[: len(own), k] = own
        width = count + 20
        places = -np.cos(np.pi * (np.arange(width) + 0.5) / width)
        values = chebvander(places, width)
        slopes = np.stack([chebval(places, chebder(row)) if k else np.zeros(width) for k, row in enumerate(np.eye(width + 1))], axis=1)
        _BASES[count] = z, to_coefficients, slope, width, places, values, slopes, chebvander(z, width), chebvander(z, count - 1), chebvander(places, count - 1)
    z, to_coefficients, slope, width, places, values, slopes, fine, coarse, at_places = _BASES[count]
    half = 0.5 * stiffness
    if stiffness > Smooth.STIFF:
        # p' + r p = D' by its polynomial solution, and what decays from the start.
        p = np.linalg.solve(slope + half * np.eye(count), slope @ to_coefficients)
        at_nodes = coarse @ p
        return at_nodes - np.exp(-half * (1.0 + z))[:, None] * at_nodes[:1]
    system = np.zeros((width + 1, width + 1))
    system[0] = (-1.0) ** np.arange(width + 1)
    system[1:] = slopes + half * values
    right = np.zeros((width + 1, count))
    right[1:] = at_places @ slope @ to_coefficients
    return fine @ np.linalg.solve(system, right)


# ---------------------------------------------------------------- from descriptions

def solid_of(description):
    """("relaxation", relaxed, moduli, rates) or ("creep", glassy, compliances, rates, flow)."""
    kind, *rest = description
    return Solid(*rest) if kind == "relaxation" else Solid.from_compliance(*rest)


def shape_of(description):
    kind, *rest = description
    makers = {"sphere": sphere, "cone": cone, "flat_punch": Punch, "power_law": power_law, "profile": Table}
    return makers[kind](*rest)


# ---------------------------------------------------------------- self-check

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
    import os
    from common import finish, read
    import time
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
    from adhesiveless import CASES
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


if __name__ == "__main__":
    if "--self-check" not in sys.argv:
        sys.exit(__doc__)
    self_check()
