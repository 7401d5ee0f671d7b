"""Sudden steps of the radius, the force or the frame: the solid answers with its glassy modulus, and the new penetration is one root."""

import math

import numpy as np

from ting_graham_equations import Equations, Moment
from ting_graham_levels import Level, graded_panels
from ting_graham_pieces import Jump
from ting_graham_roots import bracketed


class Steps(Equations):
    """A quantity other than the penetration that goes to a value at once."""

    def _step(self, quantity, value):
        """Jumps to the penetration at which the quantity has its new value."""
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
        """q of places in contact (whether or not they would be) now."""
        q = self.solid.relaxed * (self.contact.depth - places.h)
        if len(self.solid.rates):
            springs = places.state * np.exp(-np.multiply.outer(self.contact.lag(places, moment, 0.0), self.solid.rates)) + self.contact.memory
            q = q + springs @ self.solid.moduli
        return q

    def _surface_if_freed(self):
        """The penetration at which nothing carries any more."""
        places, moment = self.contact.places(np.zeros(1)), Moment(self.contact.time)
        return self.contact.depth - self._now_load(places, moment)[0] / self.solid.glassy - 1e-9 * self.contact.largest
