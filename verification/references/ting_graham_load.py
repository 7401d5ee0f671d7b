"""Ramps of the force, or of the far end of a frame: at each instant the level of the penetration is the one whose force fits.

A piece ends where the edge turns, passes a kink of its past, or lets go. Towards a detachment the pieces shrink with the time left. Without contact the
indenter floats (force) or goes with the frame until it touches.
"""

import math

import numpy as np

from ting_graham_chebyshev import chebder, chebval, chebvander
from ting_graham_equations import Equations, Moment
from ting_graham_levels import Level, graded_panels
from ting_graham_pieces import LONG, Jump, Straight
from ting_graham_roots import EPS, bracketed
from ting_graham_runs import Run


class LoadRamps(Equations):
    """A force, or a place of the far end of a frame, that is a given function of time."""

    # Part of the time left before a detachment that a piece may take.
    TOWARDS_END = 0.36

    def __init__(self, solid, shape, stiffness=None):
        super().__init__(solid, shape, stiffness)
        # Pieces in which nothing holds the indenter.
        self.afloat = set()

    def _float(self, length):
        """Nothing holds the indenter for a while."""
        contact = self.contact
        contact.pieces.append(Jump(self.solid, contact.time, contact.depth, contact.depth, contact.memory))
        if length > 0.0:
            piece = Straight(self.solid, contact.time, length, contact.depth, contact.depth, contact.memory)
            self.afloat.add(len(contact.pieces))
            contact.pieces.append(piece)
            contact.memory, contact.time = piece.end_memory, piece.start + LONG(length)
        # The surface comes up to it and takes it along.
        surface = self._surface()
        if surface < contact.depth:
            contact.pieces.append(Jump(self.solid, contact.time, contact.depth, surface, contact.memory))
            contact.memory, contact.depth = contact.memory + (surface - contact.depth), surface
            self.afloat.add(len(contact.pieces) - 1)

    def _load_segment(self, quantity, way, low, high):
        """Follows `way`, the quantity by the time in the leg, between two times of the leg."""
        contact = self.contact
        total, done = high - low, 0.0
        first = 1e-4 * total
        length = first
        punch = math.isfinite(self.shape.rim)
        guard = 0
        zero = math.inf                 # when the contact lets go, at the latest
        while done < total * (1.0 - 1e-13):
            guard += 1
            if guard > 600:
                raise RuntimeError("a stretch under load has too many pieces")
            if contact.open:
                if quantity == "force":
                    # Until it is pushed.
                    samples = np.linspace(low + done, high, 65)
                    pushed = np.flatnonzero(np.array([way(t) for t in samples]) > 0.0)
                    if len(pushed) == 0:
                        self._float(total - done)
                        return
                    if pushed[0] > 0:
                        root = bracketed(lambda t: np.array([way(t[0])]), samples[pushed[0] - 1 : pushed[0]], samples[pushed[0] : pushed[0] + 1])[0]
                        self._float(max(root - low - done, 0.0))
                        done = root - low
                    self._touch_again()
                    length = min(first, 1e-6 * (total - done))
                else:
                    # The far end moves and nothing pushes: the indenter goes with it.
                    rest = total - done
                    start, end = way(low + done), way(high)
                    straight = abs(way(low + done + 0.5 * rest) - 0.5 * (start + end)) <= 1e-13 * (abs(start) + abs(end))
                    touch = self._frame_touch(way, low + done, rest)
                    free = rest if touch is None else touch
                    if free > 0.0:
                        if straight:
                            contact.straight(start + (end - start) * (free / rest), free)
                        else:
                            contact.follow(lambda x, at=low + done: np.array([way(at + t) for t in x]), [], free)
                    done += free
                    if touch is None:
                        return
                    if contact.open:
                        self._touch_again()
                    length = min(first, 1e-6 * (total - done))
                continue
            length = min(length, total - done)
            if total - done - length < 1e-9 * total:
                length = total - done
            if zero < math.inf:
                # Towards the end of a contact everything goes with roots of the time left.
                if zero - done <= self.SHORTEST * total:
                    self._let_go(max(zero - done, 0.0), way(low + zero) if quantity == "frame" else None)
                    done, length, zero = max(zero, done), first, math.inf
                    continue
                length = min(length, self.TOWARDS_END * (zero - done))
            outcome = self._load_piece(quantity, way, low + done, length, punch)
            kind = outcome[0]
            if kind == "zero":
                zero = done + outcome[1]
                if quantity == "force":
                    # The time at which the force is gone is given.
                    zero = float(bracketed(lambda t: np.array([way(low + v) for v in t]), np.array([done]), np.array([zero]))[0])
                length *= 0.9
                continue
            if kind == "cut":
                # The edge turns, passes a kink, or lets go within the piece.
                if outcome[1] > self.SHORTEST * total and outcome[1] < length * (1.0 - 1e-9):
                    length = outcome[1]
                    continue
                kind = "shorter"
            if kind == "shorter" and length > self.SHORTEST * total:
                length *= 0.3
                continue
            if outcome[-1] is None:
                raise RuntimeError("a stretch under load does not go on")
            coefficients, path = outcome[-1], self.path
            if path is None:
                self._go(length, coefficients, contact.edge, None)
            else:
                fit = np.linalg.solve(chebvander(np.linspace(-1.0, 1.0, 1) if len(path) == 1 else -np.cos(np.pi * np.arange(len(path)) / (len(path) - 1)), len(path) - 1), path)
                self._go(length, coefficients, float(self.shape.line(np.array(path[-1]))),
                         lambda t, fit=fit, length=length: self.shape.line(np.maximum(chebval(2.0 * np.asarray(t) / length - 1.0, fit), 0.0)))
            done += length
            length *= 3.0
            if contact.open and zero < math.inf:
                # It has let go, to rounding: nothing touches it again before the load is gone.
                if quantity == "force":
                    self._float(max(zero - done, 0.0))
                    done = max(zero, done)
                length, zero = first, math.inf

    def _frame_touch(self, way, at, rest):
        """The time until an open indenter that goes with its frame touches; none if it does not within `rest`."""
        contact = self.contact
        places, moment = contact.places(np.zeros(1)), Moment(contact.time)
        samples = rest * np.unique(np.concatenate([contact.SAMPLES, np.linspace(0.0, 1.0, 65)]))
        gap = lambda t: self._free(places, moment, t[None, :])[0] - np.array([way(at + v) for v in t])
        found = gap(samples)
        found[0] = abs(found[0])
        below = np.flatnonzero(found < -4.0 * EPS * contact.largest)
        if len(below) == 0:
            return None
        k = below[0]
        return float(bracketed(gap, samples[k - 1 : k], samples[k : k + 1])[0])

    def _let_go(self, length, depth):
        """The last of a contact: down to where the tip leaves the surface."""
        contact = self.contact
        sudden = length <= 1e-15 * float(contact.time)
        length = max(length, 1e-300)
        if depth is None:
            x, relaxing, history = self._operators(length)
            level = self._held(contact.places(np.zeros(1)), Moment(contact.time), x[None, :])[0] - history
            depths = np.concatenate([[contact.depth], np.linalg.solve(relaxing[1:, 1:], level[1:] - relaxing[1:, 0] * contact.depth)])
            depth = depths[-1] - 1e-9 * max(contact.largest, 1e-300)
        if sudden:
            contact.jump(depth)
        else:
            contact.straight(depth, length)
        length = contact.pieces[-1].length
        if not contact.open:
            index = len(contact.pieces) - 1
            contact._add_run(Run(-1, index, contact.edge, -1.0, length, length))
            contact.events.append(("detachment", index, length, 0.0))
            contact.edge, contact.open = 0.0, True

    def _load_piece(self, quantity, way, at, length, punch):
        """Tries one piece: what came of it ("right", "shorter", "cut" or "zero" with a time), and last its coefficients. The radii go to `self.path`."""
        contact, solid = self.contact, self.solid
        self.path = None
        x, relaxing, history = self._operators(length)
        target = np.array([way(at + t) for t in x])
        moment = Moment(contact.time)
        own = relaxing[1:, 1:]
        started = relaxing[1:, 0] * contact.depth + history[1:]
        soft = quantity == "frame"
        if punch:
            tip = self._held(contact.places(np.zeros(1)), moment, x[None, :])[0][1:]
            size = 2.0 * self.shape.rim
            if soft:
                # D + size (kappa - tip)/k = X
                system = np.eye(len(tip)) + size / self.stiffness * own
                depths = np.linalg.solve(system, target[1:] - size / self.stiffness * (started - tip))
            else:
                depths = np.linalg.solve(own, target[1:] / size + tip - started)
            force = size * (own @ depths + started - tip)
            if np.any(force < 0.0):
                return self._first_zero(x, np.concatenate([[max(self._force_now(), 0.0)], force]))
            coefficients, tail = self._accept(np.concatenate([[contact.depth], depths]))
            return ("right", coefficients) if tail <= self.TAIL else ("shorter", coefficients)
        edge_radius = float(self.shape.radius(np.array(contact.edge)))
        inner = None
        if contact.edge > 0.0:
            inner = Level(graded_panels(self._breaks(0.0, contact.edge)))
            self._profile(inner, moment, x[1:], True)
        # The place at the edge, were it just to stay: what would be imposed then.
        rising = True
        if inner is not None:
            marginal = inner.values[:, -1, -1]
            stay = np.linalg.solve(own, marginal - started)
            force = 2.0 * (marginal * edge_radius - inner.whole())
            excess = target[1:] - self._imposed(quantity, stay, force)
            scale = float(np.max(np.abs(target))) + 1e-300
            clear = np.flatnonzero(np.abs(excess) > 1e-12 * scale)
            if len(clear) == 0:
                coefficients, tail = self._accept(np.concatenate([[contact.depth], stay]))
                return ("right", coefficients) if tail <= self.TAIL else ("shorter", coefficients)
            rising = excess[clear[0]] > 0.0
        if not rising:
            kappa = marginal.copy()
            for _ in range(60):
                area, radius = inner.integral(kappa)
                force = 2.0 * area
                depths = np.linalg.solve(own, kappa - started)
                wrong = self._imposed(quantity, depths, force) - target[1:]
                if soft:
                    inverse = np.linalg.inv(own)
                    step = np.linalg.solve(inverse + np.diag(2.0 * radius / self.stiffness), wrong)
                else:
                    step = wrong / np.maximum(2.0 * radius, 1e-3 * edge_radius)
                kappa = kappa - step
                if np.max(np.abs(step)) <= 1e-14 * np.max(np.abs(kappa)) or np.max(np.abs(wrong)) <= 2e-15 * scale:
                    break
            area, radius = inner.integral(kappa)
            depths = np.linalg.solve(own, kappa - started)
            force = 2.0 * area
            if np.any(kappa <= inner.values[:, 0, 0]):
                return self._first_zero(x, np.concatenate([[max(self._force_now(), 0.0)], np.where(kappa > inner.values[:, 0, 0], np.maximum(force, 0.0), -1e-300)]))
        else:
            reach = float(self.shape.radius(np.array(max(contact.reached, contact.edge))))
            cap = max(1.2 * reach, 1.05 * edge_radius)
            if contact.edge == 0.0 and contact.reached == 0.0:
                cap = float(self.shape.radius(np.array(self._elastic_depth(quantity, float(np.max(target)), solid.relaxed if solid.relaxed > 0.0 else 1e-4 * solid.glassy)))) * 1.1
            for _ in range(60):
                outcome = self._advance(quantity, target, x, own, started, moment, inner, edge_radius, cap)
                if outcome is not None:
                    break
                cap *= 1.6
            else:
                return "shorter", None
            depths, radius = outcome
        coefficients, tail = self._accept(np.concatenate([[contact.depth], depths]))
        path = np.concatenate([[edge_radius], radius])
        steps = np.diff(path) * (1.0 if rising else -1.0)
        # Rounding does not turn the edge.
        self.path = (np.maximum if rising else np.minimum).accumulate(path)
        if np.any(steps < -1e-9 * max(path)):
            # The extreme of the path, by its polynomial.
            fit = np.linalg.solve(chebvander(2.0 * x / length - 1.0, len(x) - 1), path)
            grid = np.linspace(0.0, length, 400)
            values = chebval(2.0 * grid / length - 1.0, fit) * (1.0 if rising else -1.0)
            falls = np.flatnonzero(np.diff(values) < 0.0)
            falls = falls[falls > 0]
            place = falls[0] if len(falls) else 40
            slope = chebder(fit)
            slopes = chebval(2.0 * grid / length - 1.0, slope)
            k = min(max(place, 1), 397)
            if slopes[k - 1] * slopes[k + 1] < 0.0:
                cut = bracketed(lambda t: chebval(2.0 * t / length - 1.0, slope), grid[k - 1 : k], grid[k + 1 : k + 2])[0]
            else:
                cut = grid[place]
            return "cut", float(min(cut, 0.9 * length) if cut > 0.9 * length and tail > 1e-6 else cut), coefficients
        # A kink of the past passed within the piece.
        kinks = [self.shape.radius(np.array(h)) for h, _ in contact.turns] + list(self.shape.knots)
        near = 1e-8 * max(path)
        passed = [float(k) for k in kinks if min(path) + near < k < max(path) - near]
        if passed and length > 0.0:
            kink = min(passed, key=lambda k: abs(k - edge_radius))
            order = path if rising else -path
            sign = 1.0 if rising else -1.0
            place = int(np.searchsorted(np.maximum.accumulate(order), sign * kink))
            a, b = max(place - 1, 0), min(place, len(x) - 1)
            fit = np.linalg.solve(chebvander(2.0 * x / length - 1.0, len(x) - 1), path)
            value = lambda t: chebval(2.0 * t / length - 1.0, fit) - kink
            ends = value(np.array([x[a], x[b]]))
            cut = bracketed(value, np.array([x[a]]), np.array([x[b]]))[0] if ends[0] * ends[1] < 0.0 else x[b]
            return "cut", float(cut), coefficients
        return ("right", coefficients) if tail <= self.TAIL else ("shorter", coefficients)

    def _force_now(self):
        position = self.now()
        return float(self.contact.forces([position[0]], [position[1]])[0][0])

    @staticmethod
    def _first_zero(x, force):
        """The first node at which the force is gone."""
        return "zero", float(x[int(np.argmax(force < 0.0))]), None

    def _advance(self, quantity, target, x, own, started, moment, inner, edge_radius, cap):
        """Penetrations and radii at the nodes of a piece in which the edge advances; none where the panels end before it does."""
        contact = self.contact
        depth_cap = float(self.shape.line(np.array(cap)))
        outer = Level(graded_panels(self._breaks(contact.edge, depth_cap)))
        self._profile(outer, moment, x[1:], False)
        soft = quantity == "frame"
        if inner is not None:
            base = -2.0 * inner.whole()
            depths = np.linalg.solve(own, inner.values[:, -1, -1] - started)
        else:
            base = np.zeros(len(x) - 1)
            depths = outer.values[:, 0, 0] + 1e-3 * (outer.values[:, -1, -1] - outer.values[:, 0, 0])
        size = 2.0 * edge_radius
        scale = float(np.max(np.abs(target))) + 1e-300
        for step_number in range(80):
            # Below the edge nothing is met: the overlap is linear there, so that Newton finds its way.
            area, radius = outer.integral(np.minimum(depths, outer.values[:, -1, -1]))
            if np.any(depths > outer.values[:, -1, -1]) and step_number > 3:
                return None
            overlap = 2.0 * area
            force = size * (own @ depths + started) + base + own @ overlap
            wrong = self._imposed(quantity, depths, force) - target[1:]
            slope = size * own + own * (2.0 * np.maximum(radius - edge_radius, 1e-6 * cap))[None, :]
            if soft:
                slope = np.eye(len(depths)) + slope / self.stiffness
            step = np.linalg.solve(slope, wrong)
            depths = depths - step
            worst = float(np.max(np.abs(wrong)))
            if np.max(np.abs(step)) <= 1e-14 * max(contact.largest, float(np.max(np.abs(depths)))) or (worst <= 1e-15 * scale):
                break
        if np.any(depths > outer.values[:, -1, -1]):
            return None
        radius = outer.integral(depths)[1]
        return depths, radius
