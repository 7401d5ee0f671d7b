"""The line: the state of any of its places, from all pieces of the penetration and all runs of the edge so far.

A place in contact has the load q, a free place the gap to the indenter. No place depends on another, and none on the shape of the indenter.
"""

import numpy as np

from ting_graham_pieces import LONG, Jump

# Newton steps from an interpolated passage time to the place's own.
NEWTON_STEPS = 3


class Places:
    """What places at depths h carry: since when they are in contact or free, and with what memory."""

    __slots__ = ("h", "contact", "since", "offset", "state")


class Line:
    """Pieces of the penetration, runs of the edge, and what the places have become by them."""

    def __init__(self, solid):
        self.solid = solid
        self.pieces, self.runs = [], []
        self.relaxed_edge = -1.0        # places below were in contact from ever on

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

    @staticmethod
    def _some(places, rows):
        part = Places()
        part.h, part.contact, part.since, part.offset, part.state = (
            places.h[rows], places.contact[rows], places.since[rows], places.offset[rows], places.state[rows])
        return part
