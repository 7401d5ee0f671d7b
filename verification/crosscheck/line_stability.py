#!/usr/bin/env python3
"""Stability of lines that slide and attract at a distance, against the growth rates of their linearised evolution.

Random scenes are solved here on one grid: dense semi-smooth Newton steps, followed by pseudo-arclength as the load falls. At points of each branch
the evolution of the retarded strains of every term is linearised about the state, and its eigenvalues are computed densely: growth rates
under a held mean pressure and under a held mean gap. The program is asked for every state of the same mean gap; the one of the same mean
pressure is compared. A glassy body that is itself unstable under what is held moves at once: it counts as growing.

    verification/crosscheck/line_stability.py --program target/release/viscotack --scenes 60 --seed 1
"""

import argparse
import collections
import csv
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from numpy.fft import fft, ifft

NODES = 160
# Points of a branch that are compared, and how near a growth rate may be to zero, over the slowest relaxation.
POINTS = 4
MARGIN = 0.02


def free_layer(product):
    """Compliance of a free layer, ν = 1/2, over that of a half-space; product of wave number and thickness."""
    t = 2 * product
    series = np.array([sum(x ** (2 * k) / np.prod(np.arange(1.0, 2 * k + 1)) for k in range(2, 16)) for x in np.minimum(t, 6)])
    with np.errstate(over="ignore", invalid="ignore"):
        exact = (np.sinh(t) + t) / np.where(t < 3, series, np.cosh(t) - 1 - t * t / 2)
    return np.where(t < 300, exact, 1.0)


class Line:
    """One scene on a grid: A(g + h) + P = s(g), or contact with the wall."""

    def __init__(self, draw):
        self.__dict__.update(draw)
        count = np.fft.fftfreq(NODES, 1 / NODES)
        self.count, size = count, np.abs(count)
        place = 2 * np.pi * np.arange(NODES) / NODES
        self.h = sum(a * np.cos(m * place + phase) for m, a, phase in self.waves)
        factor = np.ones(NODES)
        if self.thickness:
            factor[size > 0] = free_layer(size[size > 0] * self.thickness)
        compliance = 1 / self.beta + sum(j / (1 - 1j * count * self.speed * t) for j, t in self.terms)
        self.symbol = size / (compliance * factor)
        self.symbol[NODES // 2] = abs(self.symbol[NODES // 2])
        lag = (np.arange(NODES)[:, None] - np.arange(NODES)[None, :]) % NODES
        circulant = lambda symbol: ifft(symbol).real[lag]
        self.relaxing = circulant(self.symbol)
        self.glassy = circulant(self.beta * size / factor)
        self.response = circulant(np.where(size > 0, factor / np.maximum(size, 1), 0))
        derivative = 1j * count
        derivative[NODES // 2] = 0
        self.derivative = circulant(derivative)

    def stress(self, gap):
        return -self.work / self.range * np.exp(-gap / self.range)

    def slope(self, gap):
        return self.work / self.range**2 * np.exp(-gap / self.range)

    def solve(self, gap, contact, pressure, row, steps=60):
        """Newton steps with an active set; a·mean gap + b·pressure = c."""
        a, b, c = row
        gap, contact = gap.copy(), contact.copy()
        length = 4 / np.abs(self.symbol).max()
        for step in range(steps):
            total = ifft(self.symbol * fft(gap + self.h)).real + pressure
            stress = self.stress(np.where(contact, 0, np.maximum(gap, 0)))
            wanted = length * (total - stress) > gap if step else contact | (gap < 0)
            moved = (wanted != contact).any()
            contact = wanted
            gap = np.where(contact, 0, gap)
            total = ifft(self.symbol * fft(gap + self.h)).real + pressure
            free = ~contact
            lack, control = (self.stress(gap) - total)[free], c - a * gap.mean() - b * pressure
            worst = max(np.abs(lack).max(initial=0), abs(control))
            if not np.isfinite(worst):
                return None
            if worst < 1e-11 * (1 + self.work / self.range) and not moved:
                return gap, contact, pressure
            many = free.sum()
            matrix = np.zeros((many + 1, many + 1))
            matrix[:many, :many] = self.relaxing[np.ix_(free, free)] - np.diag(self.slope(np.maximum(gap[free], 0)))
            matrix[:many, many], matrix[many, :many], matrix[many, many] = 1, a / NODES, b
            move = np.linalg.solve(matrix, np.append(lack, control))
            gap[free] += move[:many]
            pressure += move[many]
        return None

    def branch(self, start, points):
        """From a state towards smaller pressures, round the folds."""
        states, way, length = [start], np.array([0.0, -1.0]), 0.01
        unit = np.array([1.0, abs(self.symbol[1])])
        where = lambda state: np.array([state[0].mean(), state[2]]) / unit
        while len(states) < points and length > 1e-5:
            here, (gap, contact, pressure) = where(states[-1]), states[-1]
            if len(states) > 1:
                old = states[-2]
                factor = min(length / np.linalg.norm(here - where(old)), 2)
                gap = np.where(contact, 0, np.maximum(gap + factor * (gap - old[0]), 1e-12))
                pressure += factor * (pressure - old[2])
            found = self.solve(gap, contact, pressure, (*(way / unit), way @ (here + length * way)), 25)
            if found is not None:
                move = where(found) - here
                size = np.linalg.norm(move)
                straight = len(states) == 1 or move @ way > 0.6 * size
                if 0 < size < 3 * length and straight and (found[1] != states[-1][1]).mean() < 0.08:
                    states.append(found)
                    way, length = move / size, min(1.4 * length, 0.06)
                    continue
            length /= 2
        return states

    def growth(self, state, row):
        """The largest growth rate, and whether the glassy body moves at once."""
        gap, contact, _ = state
        free = ~contact
        many = free.sum()
        instant = self.glassy[np.ix_(free, free)] - np.diag(self.slope(gap[free]))
        at_once = np.linalg.eigvalsh(instant if row[1] else self.among_held_gaps(instant))[0] < -1e-9
        matrix = np.zeros((many + 1, many + 1))
        matrix[:many, :many] = instant
        matrix[:many, many], matrix[many, :many], matrix[many, many] = 1, row[0] / NODES, row[1]
        change = np.linalg.solve(matrix, np.vstack([(self.glassy @ self.response)[free], np.zeros((1, NODES))]))
        gaps = np.zeros((NODES, NODES))
        gaps[free] = change[:many]
        pressure = self.glassy @ (gaps - self.response) + change[many][None, :]
        blocks = [
            [j / t * pressure + (i == k) * (self.speed * self.derivative - np.eye(NODES) / t) for k in range(len(self.terms))]
            for i, (j, t) in enumerate(self.terms)
        ]
        rates = np.linalg.eigvals(np.block(blocks))
        return rates[np.argmax(rates.real)], at_once

    @staticmethod
    def among_held_gaps(matrix):
        many = len(matrix)
        basis = np.linalg.qr(np.column_stack([np.ones(many), np.eye(many)[:, : many - 1]]))[0][:, 1:]
        return basis.T @ matrix @ basis


def drawn(dice):
    beta, share = 2 * 500 ** dice.random(), dice.random()
    strengths = [(1 - 1 / beta) * share, (1 - 1 / beta) * (1 - share)]
    return {
        "beta": beta,
        "terms": list(zip(strengths, [1.0, 10 ** dice.uniform(-2.5, -0.3)])),
        "speed": 10 ** dice.uniform(-2, 2),
        "work": 2 * np.pi * 10 ** dice.uniform(-2.7, -1.5),
        "range": 0.08 * 3 ** dice.random(),
        "thickness": 0.4 * 20 ** dice.random() if dice.random() < 0.4 else None,
        "waves": [(m, dice.random() / m, 2 * np.pi * dice.random()) for m in (1, 2, 5)],
    }


def scene(line, gap):
    # The scene's creep terms are parts of what the glassy body lacks.
    parts = ", ".join(f"{{ fraction = {j / (1 - 1 / line.beta)!r}, retardation_time = {float(t)!r} }}" for j, t in line.terms)
    waves = ", ".join(f"{{ number = {m}, amplitude = {float(a)!r}, phase = {float(phase)!r} }}" for m, a, phase in line.waves)
    layer = f'layer = {{ thickness = {float(line.thickness)!r}, backing = "free" }}\n' if line.thickness else ""
    return f"""units = "reduced"
accuracy = 1e-2
[material]
relaxed_modulus = 1.0
glassy_modulus = {float(line.beta)!r}
creep = [{parts}]
[adhesion]
work_of_adhesion = {float(line.work / (2 * np.pi))!r}
law = "exponential"
range = {float(line.range)!r}
[sliding]
speed = {float(line.speed)!r}
mean_gap = {float(gap)!r}
reached_by = "every"
profile = {{ harmonics = [{waves}] }}
{layer}"""


def rows_of(program, text):
    with tempfile.TemporaryDirectory() as folder:
        path, out = Path(folder) / "scene.toml", Path(folder) / "out"
        path.write_text(text)
        done = subprocess.run([program, "run", path, "--out", out], capture_output=True, text=True, timeout=300)
        table = out / "states.csv"
        if not table.exists():
            raise SystemExit(done.stderr)
        rows = list(csv.DictReader(table.open()))
    return [{name.split(" ")[0]: value for name, value in row.items()} for row in rows if row["status"] != "refused"]


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--program", required=True)
    options.add_argument("--scenes", type=int, default=60)
    options.add_argument("--seed", type=int, default=1)
    options = options.parse_args()
    dice, tally = np.random.default_rng(options.seed), collections.Counter()
    for number in range(options.scenes):
        line = Line(drawn(dice))
        gap = np.maximum(0.5 * line.h.max() - line.h, 0)
        start = line.solve(gap, gap <= 0, 0.1, (0, 1, 0.1))
        if start is None:
            continue
        states = [state for state in line.branch(start, 40) if state[1].any() and not state[1].all()]
        # Points next to a fold are left out: on this coarse grid they may lie on its other side.
        runs = lambda a, b, c: (b - a) * (c - b) > 0
        clear = [
            state
            for before, state, after in zip(states, states[1:], states[2:])
            if runs(before[2], state[2], after[2]) and runs(before[0].mean(), state[0].mean(), after[0].mean())
        ]
        for state in clear[:: max(1, len(clear) // POINTS)]:
            candidates = [row for row in rows_of(options.program, scene(line, state[0].mean())) if row.get("mean_pressure")]
            near = lambda row: abs(float(row["mean_pressure"]) - state[2])
            same = [row for row in candidates if near(row) <= 0.003 + 0.03 * abs(state[2])]
            if not same:
                tally["not among the states of the program"] += 1
                continue
            row = min(same, key=near)
            for held, control in (("mean_pressure", (0, 1)), ("mean_gap", (1, 0))):
                rate, at_once = line.growth(state, control)
                flag = {"": "none", "1": "stable", "0": "unstable"}[row[f"stable_under_{held}"].removesuffix(".0")]
                truth = "grows" if at_once or (rate.real > MARGIN and rate.imag == 0) else "oscillates" if rate.real > MARGIN else "near zero"
                truth = "dies out" if truth == "near zero" and rate.real < -MARGIN else truth
                tally[f"{held}: {truth}, program: {flag}"] += 1
                if (truth, flag) in (("grows", "stable"), ("dies out", "unstable")):
                    print(f"scene {number}: held {held}, rate {rate:.3g}, {flag}; gap {state[0].mean():.5f}, pressure {state[2]:.5f}", flush=True)
    for what, many in sorted(tally.items()):
        print(f"{many:5} {what}")


if __name__ == "__main__":
    main()
