"""Ramps of the contact radius: the edge is given, so that the penetration follows place by place."""

import numpy as np

from ting_graham_equations import Equations, Moment
from ting_graham_roots import bracketed


class RadiusRamps(Equations):
    """A contact radius that is a given function of time."""

    def _radius_segment(self, way, low, high):
        """Follows `way`, the radius by the time in the leg, between two times of the leg."""
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
            coefficients, tail = self._accept(depths)
            if tail > self.TAIL and length > self.SHORTEST * total:
                length *= 0.35
                continue
            if contact.open and rising:
                contact.events.append(("touch", len(contact.pieces), 0.0))
                contact.open = False
            self._go(length, coefficients, h[-1], lambda t, at=low + done: self.shape.line(np.maximum(np.array([way(at + v) for v in np.atleast_1d(t)]), 0.0)))
            done += length
            length *= 3.0
