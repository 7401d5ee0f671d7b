"""Histories: a start and legs (steps and ramps) in any quantity, and afterwards the penetration, force, radius and events at any instant.

A position is (piece, time in it).
"""

import numpy as np

from ting_graham_load import LoadRamps
from ting_graham_pieces import LONG, Jump
from ting_graham_radius import RadiusRamps
from ting_graham_step import Steps


class History(RadiusRamps, LoadRamps, Steps):
    """What is done, leg after leg, in any quantity; `legs` holds the pieces of each."""

    def __init__(self, solid, shape, stiffness=None):
        super().__init__(solid, shape, stiffness)
        self.legs = []
        self.here = None

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
                self.contact.follow(lambda x: start + (end - start) * (x / duration) + oscillation[0](x), oscillation[1], duration)
        else:
            way = (lambda x: start + (end - start) * (x / duration)) if oscillation is None else (
                lambda x: start + (end - start) * (x / duration) + oscillation[0](x))
            self._ramp(quantity, way, duration, oscillation)
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

    def _ramp(self, quantity, way, duration, oscillation):
        """A ramp of any quantity but the penetration, segments between the extremes of an oscillation."""
        # Measured against tighter pieces and more nodes: below 1e-9 under loads, 1e-11 under radii.
        self.collocation = max(self.collocation, 2e-11 if quantity == "contact_radius" else 3e-9)
        marks = [0.0, duration]
        if oscillation is not None:
            marks[1:1] = [b for b in oscillation[1] if 1e-12 * duration < b < duration * (1.0 - 1e-12)]
        for low, high in zip(marks, marks[1:]):
            if quantity == "contact_radius":
                self._radius_segment(way, low, high)
            else:
                self._load_segment(quantity, way, low, high)

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
