"""Shapes of the indenter, each by its line profile f(s) = s int_0^s z'(r)/sqrt(s^2 - r^2) dr, where z(r) is the shape itself.

A shape gives f, its inverse (the radius of a place of the line), the force of an elastic contact, its rim, and the radii at which f has kinks.
"""

import math

import numpy as np


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


def shape_of(description):
    kind, *rest = description
    makers = {"sphere": sphere, "cone": cone, "flat_punch": Punch, "power_law": power_law, "profile": Table}
    return makers[kind](*rest)
