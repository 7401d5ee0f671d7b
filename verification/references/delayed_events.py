"""What happens to cracks under random load histories, by another route: writes or checks delayed_events.csv.

    python3 verification/references/delayed_events.py            regenerate the file (needs numpy; minutes)
    python3 verification/references/delayed_events.py --check    recompute all, compare

The scenes are those of delayed_scenes/, drawn by verification/src/studies/event_lists/scenes.rs (seed and number in the name of a file), some of one constant load.
Thesis (5.54) and (5.67) in collapsed form, w = (K/2) {K/E_glassy + int J'(t - t1) K(t1) [1 - (x - x(t1))/zone]_+ dt1}, as a sum over ALL earlier pieces
of the history at each instant: loads and places are straight in each piece and the integral of a piece is exact. No window sums, no grid of lines, no
parabola, no speed: the tip is where w is the work of adhesion, found by bisection, or where it was. Starts are bisected in time; stops are closed in on by
halving the step. Second order in the step. `uncertainty` is four times what half the step changes.
Independence: the collapsed closure is shared with the solver (delayed_fracture_raw.csv checks it against the thesis's own double sum); nothing else is.
"""

import sys

sys.dont_write_bytecode = True

import glob
import os
import time as clock
import tomllib

import numpy as np

from common import arguments, double, finish, read, write

COMMAND = "python3 verification/references/delayed_events.py"
COLUMNS = ["scene", "number", "event", "time", "uncertainty"]
SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "delayed_scenes")


def moments(z):
    """int_0^1 e^{-zv} v^k dv for k = 0, 1, 2."""
    small = z < 1.0
    zs, zl = np.where(small, z, 0.5), np.where(small, 1.0, z)
    out, series = [], np.exp(-zl)
    upward = -np.expm1(-zl) / zl
    for k in range(3):
        if k:
            upward = (k * upward - series) / zl
        term, total = np.ones_like(zs), np.zeros_like(zs)
        for n in range(22):
            total += term / (n + k + 1)
            term = term * -zs / (n + 1)
        out.append(np.where(small, total, upward))
    return out


class Scene:
    def __init__(self, text):
        scene = tomllib.loads(text)
        reduced = scene.get("units") == "reduced"
        material, crack = scene["material"], scene["crack"]
        stiff = 1 / (1 - material["poisson_ratio"] ** 2) if crack.get("plane") == "strain" else 1.0
        self.relaxed = stiff * (1.0 if reduced else material["relaxed_modulus"])
        self.glassy = stiff * material["glassy_modulus"]
        gained = 1 / self.relaxed - 1 / self.glassy
        self.tau = np.array([term["retardation_time"] for term in material["creep"]])
        self.rate = np.array([gained * term["fraction"] for term in material["creep"]]) / self.tau
        halves = 2 if crack.get("body", "against_rigid") == "two_halves" else 1
        work = 1.0 if reduced else scene["adhesion"]["work_of_adhesion"]
        self.wanted = 2 * work / halves
        unit = np.sqrt(2 * work * self.relaxed) if reduced else 1.0
        if "strip" in crack:
            unit = np.sqrt(crack["strip"]["half_height"])
        self.stretches, load, time = [], 0.0, 0.0

        def line(duration, to):
            nonlocal load, time
            if duration > 0:
                self.stretches.append((time, duration, load * unit, to * unit))
                time += duration
            load = to

        for segment in scene["history"]:
            value = segment.get("stress_intensity", segment.get("stress"))
            if "hold" in segment:
                line(segment["hold"], load)
            elif "cycles" in segment:
                lower, upper, half = segment["lower"], segment["upper"], segment["period"] / 2
                for _ in range(segment["cycles"]):
                    if segment.get("wave") == "square":
                        load = upper
                        line(half, upper)
                        load = lower
                        line(half, lower)
                    else:
                        load = lower
                        line(half, upper)
                        line(half, lower)
            elif "rate" in segment:
                line(abs(value - load) / segment["rate"], value)
            elif "duration" in segment:
                line(segment["duration"], value)
            else:
                load = value
        self.limit = np.sqrt(self.wanted * self.glassy)
        peak = max(max(first, last) for _, _, first, last in self.stretches)
        zone = scene["adhesion"]["process_zone"]
        self.follows = "length" not in zone and zone.get("law", "growing") == "growing"
        self.peak = peak

    def zone(self, load):
        """Over the greatest one."""
        return max((load / self.peak) ** 2, 1e-9) if self.follows else 1.0


class March:
    def __init__(self, scene, fineness):
        self.s, self.n = scene, fineness
        self.pieces = np.zeros((0, 6))
        self.x, self.moving, self.moved, self.rests, self.events = 0.0, False, False, [], []

    def excess(self, x, t, load, now=None):
        """w over the work of adhesion, less one; `now` is the piece that ends here."""
        s, zone = self.s, self.s.zone(load)
        p = self.pieces if now is None else np.vstack([self.pieces, now])
        p = p[p[:, 5] > x - zone]
        if len(p) == 0:
            return load * load / s.glassy / s.wanted - 1
        t0, t1, k0, k1, x0, x1 = p.T
        way = x1 - x0
        cut = np.where((x0 < x - zone) & (way > 0), (x - zone - x0) / np.where(way > 0, way, 1), 0.0)
        h = (t1 - t0) * (1 - cut)
        k0, x0 = k0 + cut * (k1 - k0), x0 + cut * way
        a0, a1 = 1 - (x - x0) / zone, 1 - (x - x1) / zone
        # v from the end of the piece backwards.
        dk, da = k0 - k1, a0 - a1
        total = 0.0
        for tau, rate in zip(s.tau, s.rate):
            n0, n1, n2 = moments(h / tau)
            fade = np.exp(-(t - t1) / tau)
            total += rate * float(np.sum(fade * h * (k1 * a1 * n0 + (k1 * da + dk * a1) * n1 + dk * da * n2)))
        return load * (load / s.glassy + total) / s.wanted - 1

    def event(self, kind, t):
        self.events.append((kind, t))

    def keep(self, now):
        self.pieces = np.vstack([self.pieces, now])
        if len(self.pieces) % 64 == 0:
            self.pieces = self.pieces[self.pieces[:, 5] > self.x - 1.0]

    def start(self, t):
        self.event("restart" if self.moved else "onset", t)
        self.rests.append(self.x)
        self.moving = self.moved = True

    def root(self, low, high, f):
        """Where f falls through zero."""
        f_low, f_high = f(low), f(high)
        for _ in range(80):
            x = low + (high - low) * f_low / (f_low - f_high) if f_high < 0 else high
            x = min(max(x, low + 0.02 * (high - low)), high - 0.02 * (high - low))
            value = f(x)
            if value > 0:
                low, f_low = x, value
            else:
                high, f_high = x, value
            if abs(value) < 1e-13 or high - low < 1e-14:
                break
        return x

    def run(self):
        s, last_load = self.s, 0.0
        for t0, duration, first, last in s.stretches:
            if first >= s.limit:
                self.event("unbounded", t0)
                return self.events
            breaks = last >= s.limit
            load = lambda t: first + (last - first) * (t - t0) / duration
            if first > last_load and self.excess(self.x, t0, first) > 0:
                if not self.moving:
                    self.start(t0)
                else:
                    self.rests.append(self.x)
                self.event("jump", t0)
                self.x = self.root(self.x, self.x + s.zone(first), lambda x: self.excess(x, t0, first))
            elif first < last_load and self.moving:
                self.event("arrest", t0)
                self.moving = False
            last_load = last
            t, end = t0, t0 + duration
            if breaks:
                end = t0 + duration * (s.limit - first) / (last - first)
            longest = duration / (3 * self.n)
            step = 1e-4 * longest
            shortest = 1e-7 * longest
            grown = 0.0
            while t < end * (1 - 1e-13):
                step = min(step, end - t, longest)
                t1, k0, k1 = t + step, load(t), load(t + step)
                zone = s.zone(k1)
                if breaks and k1 > s.limit * (1 - 1e-6):
                    break
                rest = np.array([t, t1, k0, k1, self.x, self.x])
                held = self.excess(self.x, t1, k1, rest)
                if not self.moving:
                    if held > 1e-13:
                        low, high = t, t1
                        for _ in range(60):
                            middle = (low + high) / 2
                            if self.excess(self.x, middle, load(middle), np.array([t, middle, k0, load(middle), self.x, self.x])) > 1e-13:
                                high = middle
                            else:
                                low = middle
                        self.keep(np.array([t, high, k0, load(high), self.x, self.x]))
                        t = high
                        self.start(t)
                        step = 1e-3 * longest
                        continue
                    self.keep(rest)
                    t, step = t1, 1.3 * step
                    continue
                if held <= 0:
                    if step > shortest:
                        step *= 0.4
                        continue
                    self.event("arrest", t)
                    self.moving = False
                    self.keep(rest)
                    t = t1
                    continue
                x0 = self.x
                most = zone / self.n
                f = lambda x: self.excess(x, t1, k1, np.array([t, t1, k0, k1, x0, x]))
                if f(x0 + most) > 0 and step > 1e-9 * duration:
                    step *= 0.5
                    continue
                self.x = self.root(x0, x0 + max(most, 1e-12), f)
                before = [r for r in self.rests if r + s.zone(k0) > x0 + 1e-9]
                left = [r for r in before if r + zone <= self.x]
                if left:
                    r = left[0]
                    a, b = x0 - r - s.zone(k0), self.x - r - zone
                    self.event("kink", t + step * (-a / (b - a)))
                self.rests = [r for r in self.rests if r > self.x - 1.0]
                self.keep(np.array([t, t1, k0, k1, x0, self.x]))
                advance, t = self.x - x0, t1
                grown += advance
                step *= 1.25 if advance < 0.7 * most else 1.0
                if first == last and grown > 25 * zone:
                    # Steady by now: the rest of the stretch at this speed, the last zone in as many pieces.
                    speed = advance / (t - self.pieces[-1, 0])
                    self.x += speed * (end - t)
                    back = np.linspace(1.0, 0.0, 4 * self.n + 1) * zone
                    self.pieces = np.array([[end - a / speed, end - b / speed, first, first, self.x - a, self.x - b] for a, b in zip(back, back[1:])])
                    self.rests = []
                    t = end
            if breaks:
                self.event("unbounded", end)
                return self.events
        return self.events


def scenes():
    for path in sorted(glob.glob(os.path.join(SCENES, "*.toml"))):
        with open(path) as file:
            yield os.path.basename(path)[:-5], file.read()


def rows(reduced):
    out = []
    for index, (name, text) in enumerate(scenes()):
        if reduced and index % 4:
            continue
        scene = Scene(text)
        coarse, fine = March(scene, 30).run(), March(scene, 60).run()
        same = [kind for kind, _ in coarse] == [kind for kind, _ in fine]
        if not same:
            print(f"{name}: {coarse}\n   {fine}", file=sys.stderr)
        for number, (kind, time) in enumerate(fine):
            off = abs(time - coarse[number][1]) if same else float("inf")
            out.append(dict(scene=name, number=number, event=kind, time=double(time), uncertainty=f"{4 * off + 1e-9 * time:.3e}"))
        if not fine:
            out.append(dict(scene=name, number=0, event="none", time="0.0", uncertainty="0"))
    return out


def main():
    options = arguments("Events of cracks under random load histories.")
    start = clock.time()
    fresh = rows(options.reduced)
    if options.check:
        key = lambda row: (row["scene"], int(row["number"]))
        old = {key(row): row for row in read("delayed_events.csv")}
        wrong = [f"{key(row)}" for row in fresh if key(row) not in old or old[key(row)]["event"] != row["event"]
                 or abs(float(old[key(row)]["time"]) - float(row["time"])) > 1e-9 * float(row["time"]) + 1e-3 * float(row["uncertainty"])]
        finish(wrong, start, f"check of {len(fresh)} rows")
    write("delayed_events.csv", COMMAND, "events of cracks under random load histories; columns in the opening of the script", COLUMNS, fresh,
          precision="double; two step sizes, no digit confirmed")


if __name__ == "__main__":
    main()
