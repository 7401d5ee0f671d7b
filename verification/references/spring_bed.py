"""The bed of springs (`spring_bed.rs`) as a judge of indentation without adhesion: writes its input, and says how far its own answers may be off.

Each scene is computed on two grids, of springs and of steps, the second twice as fine; an answer's own error is OWN times their difference and FLOOR of the
largest value. It follows no edge and knows no turning radii; what it shares with `ting_graham.py` is the conversion of a creep law and the line of a shape,
both checked there.
"""

import math
import os
import subprocess
import tempfile

import numpy as np

# Springs, denser towards the axis, and steps a leg of the coarse grid; a flat face is one spring.
SPRINGS, STEPS = 500, 160
OWN, FLOOR = 4.0, 1e-3


def built(target):
    """The program, compiled where it is not newer than its source."""
    source, program = os.path.join(os.path.dirname(os.path.abspath(__file__)), "spring_bed.rs"), os.path.join(target, "spring_bed")
    if not os.path.exists(program) or os.path.getmtime(program) < os.path.getmtime(source):
        # A folder for each process: two compilers in one share their intermediate files.
        with tempfile.TemporaryDirectory(dir=target) as folder:
            own = os.path.join(folder, "spring_bed")
            subprocess.run(["rustc", "-O", "--edition", "2024", source, "-o", own], check=True)
            os.replace(own, program)
    return program


class Bed:
    """Legs as `ting_graham.History` takes them; `solve` gives what is right at every wanted instant."""

    def __init__(self, solid, shape, stiffness, reach):
        self.solid, self.shape, self.stiffness = solid, shape, stiffness
        # A table is no shape beyond its last point.
        self.end = getattr(shape, "end", math.inf)
        self.reach = min(reach, self.end)
        self.legs, self.wanted = [], [0.0]
        self.time, self.fine = 0.0, False

    def begin(self, quantity, value, relaxed):
        self.start, self.first, self.here = f"{quantity} {value!r} {int(relaxed)}", value, (quantity, value)

    def step(self, quantity, value):
        self.legs.append(("step", quantity, value))
        self.wanted.append(self.time)
        self.here = (quantity, value)

    def ramp(self, quantity, end, duration, marks=(1.0,), oscillation=None):
        if duration <= 0.0:
            self.step(quantity, end)
            return
        self.legs.append(("way", quantity, end, duration, tuple(marks), oscillation))
        self.wanted += [self.time + mark * duration for mark in marks]
        self.time += duration
        self.here = (quantity, end)

    def _times(self, duration, marks, oscillation, steps):
        parts = [np.linspace(0.0, 1.0, steps + 1)[1:], np.array(marks)]
        shortest = min(1e-6, 1e-2 / max(float(np.max(self.solid.rates, initial=0.0)) * duration, 1e-300))
        decades = -math.log10(max(shortest, 1e-14))
        parts.append(np.logspace(-decades, 0.0, int(steps / 8.0 * decades) + 1))
        if oscillation is not None:
            parts.append(np.linspace(0.0, 1.0, int(2.0 * steps * (len(oscillation[1]) + 1) / 4.0) + 1)[1:])
        times = np.unique(np.concatenate(parts))
        far = np.concatenate([np.diff(times) > 1e-9 * times[1:], [True]])
        keep = far | np.isin(times, marks)
        return times[keep]

    def _words(self, springs, steps):
        shape = self.shape
        if math.isfinite(shape.rim):
            lines = [f"1 1 {shape.rim!r} 0.0 {2.0 * shape.rim!r}"]
        else:
            # A radius that is held is a spring's own: between two it would drift by a part of their distance. So are the points of a table.
            imposed = [leg[2] for leg in self.legs if leg[1] == "contact_radius"] + [self.first] * (self.start[0] == "c")
            places = [r for r in [*imposed, *shape.knots] if 0.0 < r < self.reach]
            s = np.unique(np.concatenate([self.reach * np.linspace(0.0, 1.0, springs + 1) ** 2, places]))
            s = s[np.concatenate([[True], np.diff(s) > 1e-11 * self.reach])]
            ways = np.diff(s)
            weight = np.concatenate([ways, [ways[-1]]]) + np.concatenate([[0.0], ways])
            lines = [f"0 {len(s)}", *(" ".join(map(repr, map(float, row))) for row in (s, np.concatenate([[0.0], shape.line(s[1:])]), weight))]
        solid = self.solid
        lines.append(f"{solid.relaxed!r} {len(solid.rates)} " + " ".join(map(repr, map(float, [*solid.moduli, *solid.rates]))))
        lines += [repr(float(self.stiffness or 0.0)), self.start, str(len(self.legs))]
        for leg in self.legs:
            if leg[0] == "step":
                lines.append(f"step {leg[1]} {leg[2]!r}")
                continue
            _, quantity, end, duration, marks, oscillation = leg
            parts = self._times(duration, marks, oscillation, steps)
            added = oscillation[0](parts * duration) if oscillation is not None else np.zeros(len(parts))
            lines.append(f"way {quantity} {end!r} {len(parts)}")
            wanted = np.isin(parts, marks)
            lines += [f"{part * duration!r} {part!r} {more!r} {int(want)}" for part, more, want in zip(parts.tolist(), added.tolist(), wanted.tolist())]
        return "\n".join(lines)

    def _run(self, program, springs, steps):
        done = subprocess.run([program], input=self._words(springs, steps), capture_output=True, text=True, check=True)
        rows, events, highest = [], [], 0.0
        for line in done.stdout.splitlines():
            word, *numbers = line.split()
            if word == "at":
                rows.append([float(number) for number in numbers])
            elif word in ("begin", "end"):
                events.append((word, float(numbers[0]), float(numbers[1])))
            elif word == "highest":
                highest = float(numbers[0])
        return np.array(rows), events, max(highest, rows[0][3])

    def solve(self, program):
        """Columns at the wanted instants, how far off each may be, and the events with theirs."""
        flat = math.isfinite(self.shape.rim)
        for _ in range(60):
            coarse, rough, highest = self._run(program, SPRINGS, STEPS)
            deep = highest >= 0.95 * self.reach
            if flat or (deep and self.reach == self.end) or (0.25 * self.reach < highest and not deep):
                break
            self.reach = min(2.0 * self.reach, self.end) if deep else max(1.6 * highest, 0.1 * self.reach)
        fine, events, self.highest = self._run(program, 2 * SPRINGS, 2 * STEPS)
        off = OWN * np.abs(fine - coarse) + FLOOR * np.max(np.abs(fine), axis=0)
        off[:, 1:3] += fine[:, 5:7]
        if not flat:
            off[:, 3] += 2.0 * np.sqrt(np.maximum(fine[:, 3], 0.0) * self.reach) / SPRINGS + self.reach / SPRINGS ** 2
        return fine, off, events, rough
