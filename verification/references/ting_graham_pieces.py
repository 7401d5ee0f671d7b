"""Pieces of the penetration D(t): at once, straight, or a polynomial; each with the memory int exp(-r_i (t - t')) dD of the solid along it.

This memory is the same for every place of the line. `memory_matrix` gives it for a polynomial whose values at the nodes are not known yet.
"""

import numpy as np

from ting_graham_chebyshev import chebder, chebval, chebvander

# Times are sums of many lengths: a longer float keeps their differences.
LONG = np.longdouble


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
