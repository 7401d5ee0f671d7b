"""Equations for the penetration where another quantity is imposed: the terms that every place contributes, at the nodes of one piece.

At each instant the imposed force, frame or radius is an equation for the level of the penetration (Graham). On a piece the penetration is a polynomial,
found by collocation; its last coefficients say whether the piece is short enough.
"""

import math

import numpy as np

from ting_graham_chebyshev import chebvander
from ting_graham_contact import Contact
from ting_graham_pieces import Jump, Smooth, memory_matrix
from ting_graham_roots import bracketed


class Moment:
    """A place in time that a lag can be counted to, before its piece is known."""

    def __init__(self, start):
        self.start = start


class Equations:
    """A contact with what is imposed on it."""

    NODES = 13              # of a piece
    TAIL = 1e-12            # share of the last coefficients of a resolved piece
    SHORTEST = 1e-10        # piece, over its leg

    def __init__(self, solid, shape, stiffness=None):
        self.contact = Contact(solid, shape)
        self.solid, self.shape, self.stiffness = solid, shape, stiffness
        self.known = {}
        self.collocation = 0.0

    def now(self):
        """The present position: (piece, time in it)."""
        return len(self.contact.pieces) - 1, self.contact.pieces[-1].length

    def _elastic_depth(self, quantity, value, modulus):
        """The penetration of an elastic contact of this modulus under what is imposed."""
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
        high = shape.knots[-1] if len(shape.knots) else 1.0
        while elastic(high) < value:
            high *= 2.0
        while elastic(0.5 * high) > value:
            high *= 0.5
        radius = bracketed(lambda s: np.array([elastic(s[0]) - value]), np.array([0.5 * high]), np.array([high]))[0]
        return float(shape.line(np.array(radius)))

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
        """What the level must reach at the places and instants of `level`: by loads inside the edge, by free surfaces outside."""
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
        """The imposed quantity by penetration and force."""
        return force if quantity == "force" else depth + force / self.stiffness

    def _accept(self, depths):
        """Coefficients of a piece, and the share of the last two: how far it is from being resolved."""
        coefficients = np.linalg.inv(chebvander(-np.cos(np.pi * np.arange(len(depths)) / (len(depths) - 1)), len(depths) - 1)) @ depths
        scale = max(self.contact.largest, float(np.max(np.abs(depths))))
        return coefficients, float(np.sum(np.abs(coefficients[-2:]))) / scale if scale else 0.0

    def _go(self, length, coefficients, end, path):
        """Goes along a piece that has been found, with the edge on its path."""
        contact = self.contact
        if math.isfinite(self.shape.rim):
            # All places are the tip, whatever depth a punch would have them at.
            contact.go(Smooth(self.solid, contact.time, length, coefficients, contact.memory))
            return
        contact.led(Smooth(self.solid, contact.time, length, coefficients, contact.memory), end, path)

    def _surface(self):
        """Where the free surface is under the tip."""
        contact = self.contact
        return float(self._free(contact.places(np.zeros(1)), Moment(contact.time), np.zeros((1, 1)))[0, 0])

    def _touch_again(self):
        """The open indenter goes to the free surface at once, and a contact of no size begins."""
        contact = self.contact
        surface = self._surface()
        contact.pieces.append(Jump(self.solid, contact.time, contact.depth, surface, contact.memory))
        contact.memory = contact.memory + (surface - contact.depth)
        contact.depth = surface
        contact.open, contact.edge = False, 0.0
        contact.events.append(("touch", len(contact.pieces) - 1, 0.0))
