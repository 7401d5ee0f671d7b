"""Runs of the edge: within one piece of the penetration the edge passes each place once, and a run says when.

The passage times are known at double-exponential nodes between the ends of the run, and interpolated between these.
"""

import numpy as np
from scipy.interpolate import PchipInterpolator

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
