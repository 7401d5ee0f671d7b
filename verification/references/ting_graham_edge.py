"""The edge follows the penetration, piece after piece: it runs outwards while places are met, and inwards while their load comes down to zero.

How far it runs within a piece is the first place that does not switch. The passage times of the places before are bracketed roots.
"""

import numpy as np

from ting_graham_chebyshev import chebval
from ting_graham_line import Line
from ting_graham_pieces import LONG, Jump, Smooth, Straight
from ting_graham_roots import EPS, bracketed
from ting_graham_runs import RUN_NODES, Run

# Chebyshev terms of a piece that follows a given function of time.
FOLLOWED = 18


class MovingEdge(Line):
    """The edge now, and how it goes on."""

    SAMPLES = np.concatenate([[0.0], np.logspace(-9.0, -0.2, 30), np.linspace(0.7, 1.0, 6)])

    def __init__(self, solid):
        super().__init__(solid)
        self.edge, self.open = 0.0, True
        self.depth, self.memory, self.time = 0.0, np.zeros(len(solid.rates)), LONG(0.0)
        self.turns = []                 # depths at which a run ended, with the number of runs by then
        self.events = []
        self.reached = 0.0              # deepest place that was ever touched
        self.largest = 0.0              # largest |D|, for rounding

    def relaxed_at(self, depth):
        """A relaxed contact at this penetration."""
        self.depth = depth
        self.open = depth <= 0.0
        self.edge = max(depth, 0.0)
        self.relaxed_edge = depth if depth > 0.0 else -1.0
        self.reached = self.edge
        self.largest = abs(depth)
        self.turns.append((self.edge, 0))

    # ---- a piece

    def go(self, piece):
        """Follows one more piece; the edge runs as far as it does."""
        self.pieces.append(piece)
        self.largest = max(self.largest, abs(piece.end), abs(float(piece.depth(0.0))))
        if isinstance(piece, Jump):
            self.corner()
            self._jump(piece)
            self.corner()
        else:
            self._run(piece)
        self.depth, self.memory = piece.end, piece.end_memory
        self.time = piece.start + LONG(piece.length)

    def led(self, piece, end, path):
        """Follows a piece along which the edge goes to `end` by a monotonic path that is known already; without a path it rests."""
        index = len(self.pieces)
        self.pieces.append(piece)
        self.largest = max(self.largest, abs(piece.end))
        if path is not None and end != self.edge:
            start = self.edge
            _, left, right, _ = RUN_NODES
            h = np.where(left < 0.5, start + (end - start) * left, end - (end - start) * right)
            sign = 1.0 if end > start else -1.0
            clipped = lambda x: np.clip(path(x), min(start, end), max(start, end))
            times = bracketed(lambda x: sign * (clipped(x) - h), np.zeros(len(h)), np.full(len(h), piece.length), sign * (start - h), sign * (end - h))
            run = Run(int(sign), index, start, end, 0.0, piece.length, np.maximum.accumulate(np.clip(times, 0.0, piece.length)), clipped)
            if start == 0.0 and sign > 0.0:
                run.low = -1.0
            if end <= 0.0:
                run.low = -1.0
                self.events.append(("detachment", index, piece.length, 0.0))
                self.open = True
            self._add_run(run)
            self.edge = max(end, 0.0)
        self.depth, self.memory = piece.end, piece.end_memory
        self.time = piece.start + LONG(piece.length)

    def straight(self, depth, length):
        self.go(Straight(self.solid, self.time, length, self.depth, depth, self.memory))

    def jump(self, depth):
        if depth != self.depth:
            self.go(Jump(self.solid, self.time, self.depth, depth, self.memory))

    def follow(self, way, breaks, duration):
        """The penetration follows a smooth function of time, pieces between the given times."""
        times = [0.0] + [b for b in breaks if 1e-12 * duration < b < duration * (1.0 - 1e-12)] + [duration]
        count = FOLLOWED
        z = np.cos(np.pi * (np.arange(count) + 0.5) / count)
        for low, high in zip(times, times[1:]):
            x = low + 0.5 * (high - low) * (1.0 + z)
            values = way(x)
            coefficients = 2.0 / count * np.cos(np.outer(np.arange(count), np.pi * (np.arange(count) + 0.5) / count)) @ values
            coefficients[0] *= 0.5
            # It goes on exactly from where it is.
            coefficients[0] += self.depth - chebval(-1.0, coefficients)
            self.go(Smooth(self.solid, self.time, high - low, coefficients, self.memory))

    def _noise(self, way):
        return 4.0 * EPS * self.largest * (self.solid.glassy if way < 0 else 1.0) + 1e-300

    def _inner_breaks(self, low, high):
        """Depths between two at which the past of the places changes."""
        least = 1e-11 * max(high, 1e-300)
        found = sorted({h for h, _ in self.turns if low + least < h < high - least})
        return [low] + [h for k, h in enumerate(found) if k == 0 or h - found[k - 1] > least] + [high]

    def corner(self):
        """The history has a corner now: places that the edge has and has not passed by now differ in a derivative."""
        if not self.open:
            self.turns.append((self.edge, len(self.runs)))

    def _add_run(self, run):
        if self.runs and self.runs[-1].way != run.way:
            self.turns.append((max(run.start, 0.0), len(self.runs)))
        self.runs.append(run)
        self.reached = max(self.reached, run.high)

    def _jump(self, piece):
        if piece.after == piece.before:
            return
        rising = piece.after > piece.before
        index = len(self.pieces) - 1
        if rising:
            # The outermost place that is met.
            value = lambda h: self.gap(self.places(h), piece, np.zeros(len(h)))
            if self.open and value(np.zeros(1))[0] >= -self._noise(1):
                return
            edge = self._crossing(value, self.edge, max(self.reached, piece.after) * (1.0 + 1e-9) + 1e-300)
            if edge > self.edge:
                if self.open:
                    self.events.append(("touch", index, 0.0))
                self._add_run(Run(1, index, self.edge, edge, 0.0, 0.0))
                self.edge, self.open = edge, False
        elif not self.open:
            def value(h):
                found = self.places(h)
                springs = found.state * np.exp(-np.multiply.outer(self.lag(found, piece, np.zeros(len(h))), self.solid.rates)) + piece.memory_after
                return -(self.solid.relaxed * (piece.after - h) + springs @ self.solid.moduli)
            if value(np.zeros(1))[0] >= -self._noise(-1):
                self._add_run(Run(-1, index, self.edge, -1.0, 0.0, 0.0))
                self.events.append(("detachment", index, 0.0, self.edge))
                self.edge, self.open = 0.0, True
                return
            edge = self._crossing(value, 0.0, self.edge)
            if edge < self.edge:
                self._add_run(Run(-1, index, self.edge, edge, 0.0, 0.0))
                self.edge = edge

    def _crossing(self, value, low, high):
        """The h at which a rising function of it comes from below to zero; it is negative at `low`."""
        for _ in range(6):
            h = low + (high - low) * np.linspace(0.0, 1.0, 10)[1:-1]
            found = value(h)
            above = np.flatnonzero(found >= 0.0)
            first = above[0] if len(above) else 8
            low, high = (h[first - 1] if first else low), (h[first] if first < 8 else high)
        ends = value(np.array([low, high]))
        for _ in range(3):
            if ends[1] == ends[0] or not ends[0] < 0.0 <= ends[1]:
                break
            middle = low - ends[0] * (high - low) / (ends[1] - ends[0])
            width = 1e-3 * (high - low)
            trial = np.clip(np.array([middle - width, middle + width]), low, high)
            found = value(trial)
            if found[0] < 0.0:
                low, ends[0] = trial[0], found[0]
            if found[1] >= 0.0:
                high, ends[1] = trial[1], found[1]
        if ends[0] < 0.0 <= ends[1]:
            return low - ends[0] * (high - low) / (ends[1] - ends[0])
        return 0.5 * (low + high)

    def _run(self, piece):
        index, x = len(self.pieces) - 1, 0.0
        forced = 0
        for _ in range(40):
            if x >= piece.length:
                return
            if self.open:
                x = self._until_touch(piece, x)
                if x is None:
                    return
                self.events.append(("touch", index, x))
                self.open, self.edge, forced = False, 0.0, 1
                fresh = True
            else:
                fresh = False
                way = forced or self._direction(piece, x)
                forced = way
            if forced == 0:
                return
            way, forced = forced, 0
            end, last, turned = self._pass(piece, index, way, x, fresh)
            if end is None:
                # Nothing moves that could be told from rounding.
                if fresh:
                    self.open = True
                return
            x = last
            if way < 0 and end < 0.0:
                self.events.append(("detachment", index, last, 0.0))
                self.edge, self.open = 0.0, True
                continue
            self.edge = end
            if not turned:
                return
            forced = -way
        raise RuntimeError("the edge turned too often within one piece")

    def _times(self, piece, x):
        return x + (piece.length - x) * self.SAMPLES

    def _until_touch(self, piece, x):
        places = self.places(np.zeros(1))
        times = self._times(piece, x)
        if isinstance(piece, Smooth):
            times = np.unique(np.concatenate([times, np.linspace(x, piece.length, 33)]))
        gaps = self.gap(places, piece, times[None, :])[0]
        gaps[0] = abs(gaps[0])
        below = np.flatnonzero(gaps < -self._noise(1))
        if len(below) == 0:
            return None
        first = below[0]
        value = lambda x: self.gap(places, piece, x)
        return float(bracketed(value, np.array([times[max(first - 1, 0)]]), np.array([times[first]]))[0])

    def _direction(self, piece, x):
        """Whether the place at the edge, if it stayed in contact, would pull (inwards, -1) or press (outwards, 1) next; 0 while it does neither."""
        places = self.places(np.array([self.edge]))
        times = self._times(piece, x)[1:]
        if places.contact[0]:
            loads = self.load(places, piece, times[None, :])[0]
            noise = self._noise(-1)
        else:
            loads = -self.gap(places, piece, times[None, :])[0]
            noise = self._noise(1)
        clear = np.flatnonzero(np.abs(loads) > 4.0 * noise)
        return 0 if len(clear) == 0 else (1 if loads[clear[0]] > 0.0 else -1)

    def _least(self, places, piece, way, x):
        """The least load (inwards) or gap (outwards) that places would have in the rest of the piece, and when."""
        value = self.load if way < 0 else self.gap
        times = self._times(piece, x)
        if isinstance(piece, Smooth):
            times = np.unique(np.concatenate([times, np.linspace(x, piece.length, 25)]))
        values = value(places, piece, np.broadcast_to(times, (len(places.h), len(times))))
        best = np.argmin(values, axis=1)
        least, when = values[np.arange(len(best)), best], times[best]
        inside = np.flatnonzero((best > 0) & (best < len(times) - 1))
        if len(inside):
            part = self._some(places, inside)
            low, high = times[best[inside] - 1], times[best[inside] + 1]
            for _ in range(7):
                trial = low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, 7)
                found = value(part, piece, trial)
                k = np.argmin(found, axis=1)
                rows = np.arange(len(k))
                least[inside], when[inside] = found[rows, k], trial[rows, k]
                low, high = trial[rows, np.maximum(k - 1, 0)], trial[rows, np.minimum(k + 1, 6)]
        return least, when

    def _pass(self, piece, index, way, x, fresh):
        """One run of the edge from time x of a piece: (depth at its end, time, whether it turns there)."""
        here = self.edge
        if way > 0:
            far = max(self.reached, piece.highest()) * (1.0 + 1e-9) + 1e-300
            if far <= here:
                return None, x, False
        else:
            far = 0.0
        breaks = self._inner_breaks(min(here, far), max(here, far))
        if way < 0:
            breaks = breaks[::-1]
        noise = self._noise(way)
        # How far it goes: the first place that does not switch in the rest of the piece.
        end, last = None, piece.length
        inner = breaks[0]
        for near, off in zip(breaks, breaks[1:]):
            parts = np.array([1e-6, 1e-3, 0.05, 0.2, 0.4, 0.6, 0.8, 0.95, 0.999, 1.0])
            h = near + (off - near) * parts
            h[-1] = off
            if off != far:
                h = h[:-1]
            places = self.places(h)
            # Within rounding of a break a place may be counted on its other side.
            sound = np.flatnonzero(places.contact == (way < 0))
            if len(sound) == 0:
                inner = off
                continue
            h = h[sound]
            least, _ = self._least(self._some(places, sound), piece, way, x)
            holds = np.flatnonzero(least > -noise)
            if len(holds):
                first = holds[0]
                inner = h[first - 1] if first else near
                end, last = self._limit(piece, way, x, inner, h[first])
                break
            inner = off
        if end is None:
            if way < 0:
                end = -1.0
            else:
                end = far
        stop = max(end, 0.0)
        if abs(stop - here) <= 4.0 * EPS * max(here, stop):
            if way < 0 and end < 0.0:
                # A contact of no size.
                self._add_run(Run(-1, index, here, -1.0, x, x))
                return -1.0, x, False
            return None, x, False
        turned = end >= 0.0 and last < piece.length * (1.0 - 1e-9)
        # Passage times between the breaks.
        inner = [here] + [b for b in breaks[1:-1] if (b - here) * (b - stop) < 0.0] + [stop]
        first_time = x
        for number, (near, off) in enumerate(zip(inner, inner[1:])):
            _, left, right, _ = RUN_NODES
            h = np.where(left < 0.5, near + (off - near) * left, off - (off - near) * right)
            places = self.places(h)
            times = self._passages(places, piece, way, x, last if end >= 0.0 else piece.length)
            final = number == len(inner) - 2
            if final and end >= 0.0:
                final_time = last
            else:
                probe = self.places(np.array([off * (1.0 + (1e-12 if way < 0 else -1e-12)) if off > 0.0 else 0.0]))
                final_time = float(self._passages(probe, piece, way, x, piece.length)[0])
            times = np.where(places.contact == (way < 0), times, np.where(left < 0.5, first_time, final_time))
            times = np.maximum.accumulate(np.clip(times, first_time, final_time))
            run = Run(way, index, near, off, first_time, final_time, times)
            if final and end < 0.0:
                run.low = -1.0
            if way > 0 and fresh and number == 0:
                run.low = -1.0
            self._add_run(run)
            first_time = final_time
        return end, first_time, turned

    def _limit(self, piece, way, x, switching, holding):
        """The place between one that switches and one that does not, whose least load or gap is zero; and when."""
        low, high = switching, holding
        least, times = self._least(self.places(np.array([low, high])), piece, way, x)
        ends, when = list(least), times[0]
        for level in range(14):
            if level < 3:
                trial = low + (high - low) * np.linspace(0.0, 1.0, 9)[1:-1]
            else:
                if not ends[0] < 0.0 < ends[1]:
                    break
                # The least is nearly linear in h by now.
                middle = low - ends[0] * (high - low) / (ends[1] - ends[0])
                width = 10.0 ** -min(level - 1, 4) * (high - low)
                trial = np.array([middle - width, middle + width])
                inside = (trial - low) * (trial - high) < 0.0
                trial = trial[inside]
                if len(trial) == 0:
                    break
            least, times = self._least(self.places(trial), piece, way, x)
            holds = np.flatnonzero(least > 0.0)
            if len(holds) == 0:
                low, ends[0], when = trial[-1], least[-1], times[-1]
            else:
                first = holds[0]
                high, ends[1] = trial[first], least[first]
                if first > 0:
                    low, ends[0], when = trial[first - 1], least[first - 1], times[first - 1]
            if abs(high - low) <= 4.0 * EPS * max(abs(high), abs(low)):
                break
        if ends[0] <= 0.0 <= ends[1] and ends[1] > ends[0]:
            return low - ends[0] * (high - low) / (ends[1] - ends[0]), float(when)
        return (high if abs(ends[1]) < abs(ends[0]) else low), float(when)

    def _passages(self, places, piece, way, x, last):
        """First times from x on at which places switch; `last` where they do only there."""
        value = self.load if way < 0 else self.gap
        times = x + (last - x) * self.SAMPLES
        if isinstance(piece, Smooth):
            times = np.unique(np.concatenate([times, np.linspace(x, last, 17)]))
        values = value(places, piece, np.broadcast_to(times, (len(places.h), len(times))))
        values[:, 0] = np.maximum(values[:, 0], 0.0)
        below = values < 0.0
        first = np.argmax(below, axis=1)
        any_below = below.any(axis=1)
        rows = np.arange(len(places.h))
        low, high = times[np.maximum(first - 1, 0)], times[first]
        found = np.full(len(places.h), last)
        pick = np.flatnonzero(any_below)
        if len(pick):
            part = self._some(places, pick)
            found[pick] = bracketed(lambda t: value(part, piece, t), low[pick], high[pick], values[rows, np.maximum(first - 1, 0)][pick], values[rows, first][pick])
        return found
