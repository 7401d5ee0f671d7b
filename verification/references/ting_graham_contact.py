"""The contact at any instant of the pieces that its edge has followed: the edge, and the force, which is the only place where the shape enters.

The force is integrated by double-exponential quadrature between the radii at which the edge turned. Its error comes from every second node.
"""

import math

import numpy as np

from ting_graham_edge import MovingEdge
from ting_graham_roots import bracketed
from ting_graham_runs import RUN_NODES, exponential_nodes

FORCE_NODES = exponential_nodes(85)


class Contact(MovingEdge):
    """A contact that has followed its penetration so far."""

    def __init__(self, solid, shape):
        super().__init__(solid)
        self.shape = shape

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
            _, left, right, _ = RUN_NODES
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
        _, left, right, weight = FORCE_NODES
        s_all, w_all, owner = [], [], []
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
