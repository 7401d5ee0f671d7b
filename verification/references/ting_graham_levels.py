"""Levels of a rising function of the radius: the area below a level, int (y - p) ds up to where p reaches y, on graded Chebyshev panels.

Under an imposed force each instant asks for such a level: q at a place is the level of the penetration above that of the place.
"""

import numpy as np

from ting_graham_chebyshev import chebvander
from ting_graham_roots import bracketed


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


def graded_panels(breaks):
    """Panels between breaks, finer towards each of them."""
    edges = [np.array(breaks[:1])]
    for low, high in zip(breaks, breaks[1:]):
        left = low + (high - low) * GRADES
        right = high - (high - low) * GRADES[::-1]
        edges.append(np.where(GRADES < 0.5, left, right)[1:])
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
        """Integrals, and the radii reached."""
        rows = np.arange(len(levels))
        ends = self.values[:, :, -1]
        panel = np.minimum(np.sum(ends < levels[:, None], axis=1), ends.shape[1] - 1)
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
        return levels * (radius - self.edges[0]) - area, radius
