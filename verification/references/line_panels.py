#!/usr/bin/env python3
"""Steady sliding of a periodic line with a law of attraction, by panels in real space: no Fourier transform, no grid, no modulus at a frequency.

    python3 verification/references/line_panels.py [--check [--reduced] | --self-check] [--jobs N]      writes reference_data/line_panels.csv

Equations   gap g = w - h + S. Off contact p = -tension(g); in contact with a hard wall g = 0 and p + tension(0) >= 0.
Surface     w(x) = 1/E* times the integral of p(s) [C(x - s)]: the log kernel -(2/pi) ln|2 sin(k(x - s)/2)| of the periodic half-plane, of which a panel of constant
            pressure makes differences of Clausen's integral Cl2. In steady motion a body of creep compliance 1/beta + sum j(1 - e^(-t/tau)) adds to w/beta for each term
            j M w, M f(x) = integral over z > 0 of f(x + v tau z) e^(-z): what the point met before. M Cl2 is found once by quadrature, from panel to panel against
            the motion, closed by the period, and kept as polynomials.
Layers      the half-plane, and the rest of the kernel of a layer, which is smooth: a few cosines. Their weights come from the four conditions of a strip in plane
            strain, solved as a linear system for each of them.
Mesh        panels graded to the edges of the contact and the kinks of the law, found anew on each mesh; then twice and four times as many by the same grading.
Solution    Newton's method for the panels' pressures with the contact set moved between its steps; dense elimination. From a long range of the law, where a state is
            easy, to its own, then to its own stiffening.
Accuracy    errors fall with the square of the panels. `value` is extrapolated from the last two meshes; `error` is twice its difference from the value
            extrapolated from the first two, or a quarter of that from the finest mesh if that is more. Columns coarse, middle, fine: as the three meshes have it.
Units       any one set, in which `modulus` (plane, relaxed), `wavelength`, `height`, `times`, `speed`, `work` and `range` are given: pressures in that of the modulus,
            gaps in that of the height. Amplitudes of `harmonics` are in heights. The solution is in k = 1, height = 1, E0* = 2.
"""

import math
import os
import sys
import time
from concurrent.futures import ProcessPoolExecutor

import mpmath
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import common

NAME = "line_panels.csv"
PERIOD = 2 * math.pi
COLUMNS = ["state", "law", "ramp", "work", "range", "beta", "weights", "times", "speed", "harmonics", "layer", "control", "held", "modulus", "wavelength", "height",
           "quantity", "value", "error", "coarse", "middle", "fine", "panels"]
SUBSET = ["exponential, stiffening 300", "Lennard-Jones, three terms", "five waves, held gap", "rubber"]
KEYS = ["state", "quantity"]
LEAST_PANEL = 1e-6
GROWTH = 0.16
ZETA = [float(mpmath.zeta(2 * k)) for k in range(1, 30)]


# ---------------------------------------------------------------- kernels

def clausen(x):
    """Integral of -ln(2 sin(t/2)) from 0 to x: a logarithm and a series in x, on half of the period."""
    x = np.asarray(x) - PERIOD * np.round(np.asarray(x) / PERIOD)
    size = np.abs(x)
    safe = np.where(size > 0, size, 1.0)
    total = safe - safe * np.log(safe)
    power, square = safe ** 3, safe * safe
    for k, zeta in enumerate(ZETA, 1):
        total = total + 2 * zeta / ((2 * math.pi) ** (2 * k) * 2 * k * (2 * k + 1)) * power
        power = power * square
    return np.where(size > 0, np.sign(x) * total, 0.0)


class Remembered:
    """M f for a periodic f that is smooth but for x = 0, as polynomials on panels that are graded to it."""

    POINTS = 16

    def __init__(self, function, memory):
        graded = [1e-13 * 2.0 ** k for k in range(44) if 1e-13 * 2.0 ** k < 0.5]
        breaks = [0.0, *graded, *np.linspace(0.5, PERIOD - 0.5, 12)[1:-1], *(PERIOD - g for g in reversed(graded)), PERIOD]
        fine = [0.0]
        for lower, upper in zip(breaks[:-1], breaks[1:]):
            parts = max(1, math.ceil((upper - lower) / min(2 * memory, 0.5)))
            fine.extend(np.linspace(lower, upper, parts + 1)[1:])
        self.breaks = np.array(fine)
        n = self.POINTS
        self.nodes = np.cos((2 * np.arange(n) + 1) * math.pi / (2 * n))[::-1]
        gauss, weights = np.polynomial.legendre.leggauss(24)
        lower, upper = self.breaks[:-1], self.breaks[1:]
        places = 0.5 * (lower + upper)[:, None] + 0.5 * (upper - lower)[:, None] * np.concatenate([self.nodes, [-1.0]])[None, :]
        left = upper[:, None] - places
        inner = places[:, :, None] + 0.5 * left[:, :, None] * (1 + gauss)
        local = (function(inner) * np.exp(-(inner - places[:, :, None]) / memory) * weights).sum(axis=2) * 0.5 * left / memory
        # What comes from beyond the period first: the integral over one period, over 1 - e^(-period/memory).
        once = 0.0
        for index in reversed(range(len(lower))):
            once = local[index, -1] + math.exp(-(upper[index] - lower[index]) / memory) * once
        after = once / -math.expm1(-PERIOD / memory)
        values = np.empty((len(lower), n))
        for index in reversed(range(len(lower))):
            values[index] = local[index, :-1] + np.exp(-left[index, :-1] / memory) * after
            after = local[index, -1] + math.exp(-(upper[index] - lower[index]) / memory) * after
        self.coefficients = np.linalg.solve(np.polynomial.chebyshev.chebvander(self.nodes, n - 1), values.T)

    def __call__(self, x):
        x = np.mod(x, PERIOD)
        panel = np.clip(np.searchsorted(self.breaks, x, side="right") - 1, 0, len(self.breaks) - 2)
        lower, upper = self.breaks[panel], self.breaks[panel + 1]
        t = (2 * x - lower - upper) / (upper - lower)
        c = self.coefficients
        before, last = np.zeros_like(t), np.zeros_like(t)
        for k in range(self.POINTS - 1, 0, -1):
            before, last = last, 2 * t * last - before + c[k][panel]
        return t * last - before + c[0][panel]


def strip_compliance(number_times_thickness, poisson, bonded):
    """Displacement of a strip's surface under a wave of pressure over that of a half-plane: the stress function and its four conditions, as a linear system."""
    q = number_times_thickness
    # phi = (a + b q' + ...) in depths t = y n: terms e^-t, t e^-t, e^(t-q), (t-q) e^(t-q); stresses sigma_y = -phi, tau ~ phi', sigma_x = phi''.
    decay = math.exp(-q)

    def terms(t):
        # value, first, second and third derivative of each term at depth t
        down, up = math.exp(-t), math.exp(t - q)
        s = t - q
        return np.array([[down, -down, down, -down], [t * down, (1 - t) * down, (t - 2) * down, (3 - t) * down],
                         [up, up, up, up], [s * up, (s + 1) * up, (s + 2) * up, (s + 3) * up]])

    nu = poisson
    top, bottom = terms(0.0), terms(q)
    # Plane strain, shear modulus 1/2: strain_x = (1 - nu) sigma_x - nu sigma_y with sigma_x = phi'', sigma_y = -phi (waves cos), shear strain 2 e_xy = 2 tau.
    # u ~ sin: u = (1 - nu) phi'' + nu phi; v ~ cos: v' = strain_y = (1 - nu) sigma_y - nu sigma_x, found from e_xy: u' - v = 2 tau, tau = phi'.
    u = lambda rows: (1 - nu) * rows[:, 2] + nu * rows[:, 0]
    v = lambda rows: (1 - nu) * rows[:, 3] + nu * rows[:, 1] - 2 * rows[:, 1]
    lowest = [u(bottom), v(bottom)] if bonded else [bottom[:, 0], bottom[:, 1]]
    system = np.array([top[:, 0], top[:, 1], *lowest])
    weights = np.linalg.solve(system, np.array([1.0, 0.0, 0.0, 0.0]))
    half_plane = v(np.array([[1.0, -1.0, 1.0, -1.0], [0.0, 1.0, -2.0, 3.0]])) @ np.array([1.0, 1.0])
    return (v(top) @ weights) / half_plane


class Body:
    """Influence of panels on points, for every term of the creep compliance."""

    def __init__(self, state):
        self.memories = [state["speed"] * t for t in state["times"]]
        self.kernels = [clausen, *(Remembered(clausen, memory) for memory in self.memories)]
        self.waves = []
        if state["layer"]:
            kind, thickness, poisson = state["layer"]
            for number in range(1, 400):
                factor = strip_compliance(number * thickness, poisson, kind == "bonded") - 1
                if number * thickness > 2 and abs(factor) < 1e-15:
                    break
                self.waves.append((number, factor))

    def influence(self, points, edges):
        distance = points[:, None] - edges[None, :]
        parts = []
        for index, kernel in enumerate(self.kernels):
            whole = kernel(distance)
            matrix = whole[:, :-1] - whole[:, 1:]
            for number, factor in self.waves:
                delay = 1.0 if index == 0 else 1 / (1 - 1j * number * self.memories[index - 1])
                wave = (delay * np.exp(1j * number * distance)).imag
                matrix = matrix + factor / number ** 2 * (wave[:, :-1] - wave[:, 1:])
            parts.append(matrix / math.pi)
        return parts


# ---------------------------------------------------------------- laws: tension, its slope, places that are not smooth

class Law:
    def __init__(self, name, work, reach, ramp):
        self.name, self.work, self.reach, self.ramp = name, work, reach, ramp
        self.wall = name in ("exponential", "dugdale")

    def tension(self, g):
        w, r = self.work, self.reach
        if self.name == "exponential":
            return w / r * np.exp(-g / r)
        if self.name == "dugdale":
            t = np.clip((g - (1 - self.ramp) * r) / (2 * self.ramp * r), 0, 1)
            return w / r * (1 - t * t * (3 - 2 * t))
        if self.name == "lennard_jones":
            return 8 * w / (3 * r) * ((r / g) ** 3 - (r / g) ** 9)
        return np.where(g < 0, 0.5 * w * (math.pi / r) ** 2 * g, np.where(g < r, w * math.pi / (2 * r) * np.sin(math.pi * np.clip(g, 0, r) / r), 0))

    def slope(self, g):
        w, r = self.work, self.reach
        if self.name == "exponential":
            return -w / r ** 2 * np.exp(-g / r)
        if self.name == "dugdale":
            t = np.clip((g - (1 - self.ramp) * r) / (2 * self.ramp * r), 0, 1)
            return -w / r * 6 * t * (1 - t) / (2 * self.ramp * r)
        if self.name == "lennard_jones":
            return 8 * w / (3 * r ** 2) * (-3 * (r / g) ** 4 + 9 * (r / g) ** 10)
        return np.where(g < r, 0.5 * w * (math.pi / r) ** 2 * np.cos(math.pi * np.clip(g, 0, r) / r), 0)

    def kinks(self):
        r = self.reach
        return {"dugdale": [r * (1 - self.ramp), r * (1 + self.ramp)], "cosine": [0.0, r]}.get(self.name, [])


# ---------------------------------------------------------------- mesh and solution

def profile(state, x):
    return sum(a * np.cos(m * x + p) for m, a, p in state["harmonics"])


def mesh(breaks, places, lengths, growth, largest):
    """Edges of panels: their length is the growth times the distance from the nearest break and times the local length of the pressure, at most the largest."""
    fine = np.unique(np.concatenate([np.linspace(0, PERIOD, 4001), *[(b + s * np.geomspace(1e-8, 1.0, 400)) % PERIOD for b in breaks for s in (-1, 1)],
                                     np.array(breaks, dtype=float) % PERIOD, [0.0, PERIOD]]))
    middle = 0.5 * (fine[1:] + fine[:-1])
    wanted = np.full_like(middle, largest)
    for b in breaks:
        away = np.abs(middle - b - PERIOD * np.round((middle - b) / PERIOD))
        wanted = np.minimum(wanted, LEAST_PANEL + growth * away)
    if places is not None:
        near = np.interp(middle, places, lengths, period=PERIOD)
        wanted = np.minimum(wanted, growth * near)
    count = np.concatenate([[0.0], np.cumsum(np.diff(fine) / wanted)])
    stops = np.unique(np.concatenate([[0.0], np.array(breaks, dtype=float) % PERIOD, [PERIOD]]))

    def edges(times):
        out = [0.0]
        for lower, upper in zip(stops[:-1], stops[1:]):
            first, last = np.interp([lower, upper], fine, count)
            parts = times * max(2, math.ceil(last - first))
            out.extend(np.interp(np.linspace(first, last, parts + 1)[1:], count, fine))
        out = np.array(out)
        return out[np.concatenate([[True], np.diff(out) > 1e-12])]

    return edges


class Lost(Exception):
    pass


def newton(state, law, parts, weights, x, width, gap, contact, held):
    """Pressures on panels, mean gap and mean pressure: Newton's method with the contact set moved after each step."""
    n = len(x)
    matrix = weights[0] * parts[0]
    for weight, part in zip(weights[1:], parts[1:]):
        matrix = matrix + weight * part
    height = profile(state, x)
    share = width / PERIOD
    stalled = 0
    for step in range(80):
        slope, tension = law.slope(gap), law.tension(gap)
        system = np.empty((n + 1, n + 1))
        # off contact: p + slope (K p + S - h - gap) + tension = 0; in contact: K p + S = h
        system[:n, :n] = np.where(contact[:, None], matrix, slope[:, None] * matrix)
        off = np.nonzero(~contact)[0]
        system[off, off] += 1.0
        system[:n, n] = np.where(contact, 1.0, slope)
        rhs = np.empty(n + 1)
        rhs[:n] = np.where(contact, height, slope * (height + gap) - tension)
        system[n, :n], system[n, n] = (share, 0.0) if state["control"] == "mean_pressure" else (0.0, 1.0)
        rhs[n] = held
        solution = np.linalg.solve(system, rhs)
        pressure, mean_gap = solution[:n], solution[n]
        new = matrix @ pressure - height + mean_gap
        move = new - gap
        length = 1.0
        if law.name == "lennard_jones":
            down = move < -0.4 * gap
            length = min(1.0, float((-0.4 * gap[down] / move[down]).min())) if down.any() else 1.0
        elif law.name == "cosine":
            # Its slope has a kink, so that a long step may come back.
            length = min(1.0, 0.5 * law.reach / max(np.abs(move[np.abs(gap) < 2 * law.reach]).max(initial=0.0), 1e-300)) if step > 20 else 1.0
        gap = np.where(contact, 0.0, gap + length * move)
        changed = False
        if law.wall:
            pull = pressure + law.tension(0.0)
            enter = ~contact & (gap < 0)
            leave = contact & (pull < -1e-13)
            changed = bool(enter.any() or leave.any())
            contact = (contact | enter) & ~leave
            gap = np.where(enter, 0.0, gap)
        size = float(np.abs(np.where(contact, 0.0, move)).max())
        if not np.isfinite(size):
            raise Lost("no number")
        if size < 1e-11 and not changed:
            return pressure, gap, contact, mean_gap
        # One panel at an edge may pull on one side and cross on the other: its size is that of rounding.
        stalled = stalled + 1 if size < 1e-9 else 0
        if stalled > 6:
            return pressure, gap, contact, mean_gap
    raise Lost(f"{size:.1e} after {step} steps")


def crossings(x, edges, gap, contact, law):
    """Where the contact ends, and where the gap crosses the kinks of the law."""
    n = len(x)
    found = []
    if law.wall:
        found += [edges[i + 1] for i in range(n) if contact[i] != contact[(i + 1) % n]]
    for kink in law.kinks():
        for i in range(n):
            a, b = gap[i] - kink, gap[(i + 1) % n] - kink
            if a * b < 0 and not (law.wall and (contact[i] or contact[(i + 1) % n])):
                right = x[(i + 1) % n] + (PERIOD if i + 1 == n else 0.0)
                found.append((x[i] + (right - x[i]) * a / (a - b)) % PERIOD)
    return sorted(f % PERIOD for f in found)


def lengths_of(x, gap, law):
    """Over which the tension changes: the range over the slope of the gap, where there is tension."""
    slope = np.abs(np.gradient(gap, x)) + 1e-3
    tension = np.abs(law.tension(np.maximum(gap, 0.3 * law.reach if law.name == "lennard_jones" else -law.reach)))
    peak = law.work / law.reach
    near = law.reach / slope * (1 + np.maximum(0.0, gap / law.reach) ** 2 * (tension < peak))
    return np.maximum(near, 3e-3)


class Path:
    def __init__(self, state):
        self.state, self.body = state, Body(state)

    def on(self, edges):
        x, width = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
        return x, width, self.body.influence(x, edges)

    def weights(self, stiffening):
        total = sum(self.state["weights"])
        return [1 / stiffening, *((1 - 1 / stiffening) * w / total for w in self.state["weights"])]

    def solve(self):
        """From a long range and a little stiffening to the state; then meshes that follow its edges."""
        state = self.state
        half = 0.5 * np.ptp(profile(state, np.linspace(0, PERIOD, 2001)))
        reach, beta = state["range"], state["beta"]
        held = state["held"]
        first = max(reach, 0.2 * half)
        edges = np.linspace(0, PERIOD, 321)
        x, width, parts = self.on(edges)
        h = profile(state, x)
        law = Law(state["law"], state["work"], first, state["ramp"])
        gap = np.maximum(0.3 * h.max() - h, 0.0) + (0.0 if law.wall or law.name == "cosine" else first)
        contact = (h >= 0.3 * h.max()) & law.wall
        now = min(beta, 10.0)
        pressure, gap, contact, mean = newton(state, law, parts, self.weights(now), x, width, gap, contact, held)
        step = 0.3
        while now < beta or law.reach > reach:
            grow = law.reach <= reach
            target = Law(law.name, law.work, max(reach, law.reach * math.exp(-step)), law.ramp) if not grow else law
            stiff = min(beta, now * math.exp(step)) if grow else now
            start = gap if law.name != "lennard_jones" else np.where(gap < law.reach, gap * target.reach / law.reach, gap)
            try:
                found = newton(state, target, parts, self.weights(stiff), x, width, start, contact, held)
                if abs(found[3] - mean) > 0.15 * half:
                    raise Lost("it jumps")
                pressure, gap, contact, mean = found
                law, now = target, stiff
                step = min(0.3, 1.5 * step)
            except (Lost, np.linalg.LinAlgError):
                step /= 2
                if step < 2e-3:
                    raise Lost(f"range {law.reach:.3g}, stiffening {now:.3g}") from None
            if self.due(x, width, gap, law):
                edges, x, width, parts, gap, contact = self.moved(edges, x, gap, contact, law, 2 * GROWTH)
                pressure, gap, contact, mean = newton(state, law, parts, self.weights(now), x, width, gap, contact, held)
        for _ in range(7):
            edges, x, width, parts, gap, contact = self.moved(edges, x, gap, contact, law, GROWTH)
            pressure, gap, contact, mean = newton(state, law, parts, self.weights(now), x, width, gap, contact, held)
        results = []
        for times in (1, 2, 4):
            for _ in range(2):
                edges, x, width, parts, gap, contact = self.moved(edges, x, gap, contact, law, GROWTH, times)
                pressure, gap, contact, mean = newton(state, law, parts, self.weights(now), x, width, gap, contact, held)
            results.append((len(x), self.quantities(edges, x, width, pressure, gap, contact, mean, law)))
        self.last = (edges, x, width, pressure, gap, contact, mean, law)
        return results

    def due(self, x, width, gap, law):
        """Whether the panels are too long for the law of the moment."""
        near = lengths_of(x, gap, law)
        return bool((width > 0.7 * near)[np.abs(gap) < 4 * law.reach].any())

    def moved(self, edges, x, gap, contact, law, growth, times=1):
        breaks = crossings(x, edges, gap, contact, law)
        # Breaks that lie closer than this are one.
        kept = [b for i, b in enumerate(breaks) if i == 0 or b - breaks[i - 1] > 1e-7]
        new = mesh(kept, x, lengths_of(x, gap, law), growth, 0.06)(times)
        x_new, width, parts = self.on(new)
        gap_new = np.interp(x_new, x, gap, period=PERIOD)
        nearest = np.clip(np.searchsorted(edges, x_new, side="right") - 1, 0, len(x) - 1)
        return new, x_new, width, parts, gap_new if not law.wall else np.where(contact[nearest], 0.0, np.maximum(gap_new, 0.0)), contact[nearest]

    def quantities(self, edges, x, width, pressure, gap, contact, mean, law):
        share = width / PERIOD
        rise = np.diff(profile(self.state, edges))
        out = {"friction_stress": -float(pressure @ rise) / PERIOD, "mean_gap": float(mean), "mean_pressure": float(pressure @ share)}
        tension = law.tension(gap)
        if law.wall:
            out["contact_fraction"] = float(share @ contact)
            out["adhesive_pressure"] = -float(share @ np.where(contact, law.tension(0.0), tension))
        del out["mean_pressure" if self.state["control"] == "mean_pressure" else "mean_gap"]
        return out


# ---------------------------------------------------------------- states

ONE = [(1, 1.0, 0.0)]
THREE = [(1, 1.0, 0.0), (2, 0.4, 1.0), (3, 0.25, -0.6)]
FIVE = [(1, 1.0, 0.0), (2, 0.35, 2.1), (3, 0.3, 0.5), (4, 0.15, -1.2), (5, 0.2, 1.7)]


def made(name, law, gamma, reach, beta, speed, held, weights=(1.0,), times=(1.0,), harmonics=ONE, layer=None, control="mean_pressure", ramp=0.0, si=(2.0, PERIOD, 1.0, 1.0)):
    return {"state": name, "law": law, "ramp": ramp, "work": PERIOD * gamma, "range": reach, "beta": beta, "weights": list(weights), "times": list(times), "speed": speed,
            "harmonics": harmonics, "layer": layer, "control": control, "held": held, "si": si}


def states():
    out = []
    for beta, speed in ((1.2, 0.7), (3.0, 0.3), (10.0, 1.0), (50.0, 3.0), (300.0, 20.0), (1000.0, 60.0)):
        out.append(made(f"exponential, stiffening {beta:g}", "exponential", 0.007, 0.05, beta, speed, 0.14))
    for beta, speed in ((2.0, 0.5), (10.0, 0.3), (30.0, 2.0)):
        out.append(made(f"Dugdale, stiffening {beta:g}", "dugdale", 0.006, 0.08, beta, speed, 0.15, ramp=0.3))
        out.append(made(f"Lennard-Jones, stiffening {beta:g}", "lennard_jones", 0.006, 0.12, beta, speed, 0.2))
        out.append(made(f"cosine, stiffening {beta:g}", "cosine", 0.008, 0.12, beta, speed, 0.25))
    two, three = dict(weights=(2.0, 1.0), times=(1.0, 0.05)), dict(weights=(1.0, 2.0, 1.0), times=(1.0, 0.1, 0.01))
    out.append(made("exponential, two terms", "exponential", 0.005, 0.05, 10.0, 0.5, 0.15, **two))
    out.append(made("exponential, three terms", "exponential", 0.005, 0.04, 30.0, 1.5, 0.12, **three))
    out.append(made("exponential, three terms, stiffening 1000", "exponential", 0.005, 0.06, 1000.0, 30.0, 0.12, **three))
    out.append(made("Dugdale, two terms", "dugdale", 0.005, 0.08, 20.0, 1.0, 0.2, ramp=0.4, **two))
    out.append(made("Lennard-Jones, three terms", "lennard_jones", 0.005, 0.12, 8.0, 0.2, 0.2, **three))
    out.append(made("cosine, two terms", "cosine", 0.006, 0.15, 10.0, 3.0, 0.25, **two))
    out.append(made("three waves, little load", "exponential", 0.006, 0.06, 10.0, 0.4, 0.06, harmonics=THREE))
    out.append(made("three waves, more load", "exponential", 0.006, 0.06, 10.0, 0.4, 0.3, harmonics=THREE))
    out.append(made("three waves, cosine", "cosine", 0.006, 0.12, 5.0, 1.0, 0.2, harmonics=THREE))
    out.append(made("five waves", "exponential", 0.005, 0.06, 10.0, 2.0, 0.2, harmonics=FIVE))
    out.append(made("five waves, Dugdale, two terms", "dugdale", 0.004, 0.08, 6.0, 1.0, 0.3, harmonics=FIVE, ramp=0.4, **two))
    out.append(made("five waves, held gap", "lennard_jones", 0.005, 0.12, 4.0, 0.5, 0.8, harmonics=FIVE, control="mean_gap"))
    out.append(made("held gap", "exponential", 0.006, 0.05, 10.0, 2.0, 0.75, control="mean_gap"))
    out.append(made("held gap, stiffening 100", "exponential", 0.006, 0.06, 100.0, 10.0, 0.9, control="mean_gap"))
    out.append(made("bonded layer", "exponential", 0.006, 0.05, 10.0, 0.6, 0.15, layer=("bonded", 0.8, 0.45)))
    out.append(made("bonded thin layer", "exponential", 0.006, 0.06, 5.0, 0.6, 0.2, layer=("bonded", 0.4, 0.3)))
    out.append(made("bonded layer, Lennard-Jones", "lennard_jones", 0.006, 0.12, 10.0, 0.3, 0.25, layer=("bonded", 1.0, 0.49)))
    out.append(made("free layer", "exponential", 0.004, 0.06, 10.0, 0.4, 0.12, layer=("free", 2.0, 0.5)))
    out.append(made("free layer, cosine", "cosine", 0.005, 0.15, 3.0, 1.0, 0.15, layer=("free", 1.5, 0.5)))
    rubber, gel = (8.5e6, 120e-6, 1.7e-6, 3e-3), (23e3, 4e-3, 0.15e-3, 0.8)
    out.append(made("rubber", "exponential", 0.006, 0.05, 40.0, 4.0, 0.2, si=rubber, **two))
    out.append(made("gel, Dugdale", "dugdale", 0.007, 0.1, 2.5, 0.8, 0.12, ramp=0.4, si=gel))
    out.append(made("rubber, three waves, bonded layer", "exponential", 0.006, 0.06, 12.0, 0.5, 0.2, harmonics=THREE, layer=("bonded", 1.5, 0.48), si=rubber))
    return out


def units(state):
    """Of pressure, gap, friction stress, work of adhesion and speed, in those of the row: E0* k height/2 and so on, with times in the first one."""
    modulus, wavelength, height, second = state["si"]
    wave = PERIOD / wavelength
    pressure = 0.5 * modulus * wave * height
    return {"mean_pressure": pressure, "adhesive_pressure": pressure, "mean_gap": height, "contact_fraction": 1.0, "friction_stress": pressure * wave * height,
            "work": pressure * height, "speed": 1.0 / (wave * second)}


def rows_of(state):
    start = time.time()
    results = Path(state).solve()
    unit = units(state)
    modulus, wavelength, height, second = state["si"]
    columns = {key: state[key] for key in ("state", "law", "control")}
    numbers = {"ramp": state["ramp"], "work": state["work"] * unit["work"], "range": state["range"] * height, "beta": state["beta"], "speed": state["speed"] * unit["speed"],
               "held": state["held"] * unit[state["control"]], "modulus": modulus, "wavelength": wavelength, "height": height}
    columns |= {key: common.double(value) for key, value in numbers.items()}
    columns["weights"] = " ".join(common.double(v) for v in state["weights"])
    columns["times"] = " ".join(common.double(v * second) for v in state["times"])
    columns["harmonics"] = "; ".join(" ".join([str(m), common.double(a), common.double(p)]) for m, a, p in state["harmonics"])
    columns["layer"] = " ".join([state["layer"][0], common.double(state["layer"][1] * wavelength / PERIOD), str(state["layer"][2])]) if state["layer"] else ""
    out = []
    for quantity in results[-1][1]:
        a, b, c = (values[quantity] * unit[quantity] for _, values in results)
        value, before = (4 * c - b) / 3, (4 * b - a) / 3
        error = 2 * max(abs(value - before), abs(value - c) / 8) + 1e-11 * unit[quantity]
        out.append({**columns, "quantity": quantity, "value": f"{value:.9e}", "error": f"{error:.1e}", "coarse": f"{a:.8e}", "middle": f"{b:.8e}", "fine": f"{c:.8e}",
                    "panels": results[-1][0]})
    print(f"{state['state']}: {results[-1][0]} panels, {time.time() - start:.0f} s", flush=True)
    return out


def self_check():
    """Closed forms of the parts, and the states of another program of panels (finite_range.json: Gauss nodes on panels, edges moved as unknowns)."""
    wrong = []

    def compare(what, got, want, allowed):
        if not abs(got - want) <= allowed:
            wrong.append(f"{what}: {got!r} instead of {want!r}")

    compare("Clausen's integral at a right angle (Catalan)", float(clausen(math.pi / 2)), 0.915965594177219015, 1e-15)
    for memory in (0.01, 0.3, 20.0):
        # Against its sine series, whose tail falls as the cube of the number of terms.
        n = np.arange(1, 200001)
        for x in (0.7, 2.9, 5.5):
            series = float(np.sum((np.exp(1j * n * x) / (1 - 1j * n * memory)).imag / n ** 2))
            compare(f"memory {memory} at {x}", float(Remembered(clausen, memory)(np.array([x]))[0]), series, 1e-10)
    compare("thin bonded strip", strip_compliance(1e-3, 0.3, True) / (1e-3 * 0.4 / (2 * 0.49)), 1.0, 1e-5)
    compare("thin free strip", strip_compliance(1e-2, 0.4, False) / (6 / 1e-6), 1.0, 1e-3)
    compare("thick strip", strip_compliance(25.0, 0.5, True), 1.0, 1e-12)
    import json
    with open(os.path.join(common.DATA, "finite_range.json"), encoding="utf-8") as file:
        known = json.load(file)["states"]
    for index in (0, 2, 3, 4, 6, 8, 9, 12):
        one = known[index]
        total = sum(one["material"]["j"])
        layer = one["layer"] and ("bonded" if one["layer"][1] == "confined" else "free", one["layer"][0], one["layer"][2])
        control, held = next(iter(one["control"].items()))
        state = made(one["name"], one["law"], one["Gamma"], one["range"], float(one["material"]["beta"]), one["kv"], held, [j / total for j in one["material"]["j"]],
                     one["material"]["tau"], [tuple(w) for w in one["profile"]], layer, "mean_gap" if control == "mean_gap" else "mean_pressure")
        unit = units(state)
        for row in rows_of(state):
            truth = one["values"].get(row["quantity"])
            if truth:
                compare(f"{one['name']}, {row['quantity']}", float(row["value"]) / unit[row["quantity"]], truth["value"],
                        float(row["error"]) / unit[row["quantity"]] + truth["error"])
    return wrong


def main():
    options = common.arguments("Lines that slide and attract at a distance, by panels in real space.")
    start = time.time()
    if options.self_check:
        common.finish(self_check(), start, "line_panels.py --self-check")
    wanted = [state for state in states() if not options.reduced or state["state"] in SUBSET]
    with ProcessPoolExecutor(options.jobs) as pool:
        fresh = [row for rows in pool.map(rows_of, wanted) for row in rows]
    if options.check:
        stored = {tuple(row[key] for key in KEYS): row for row in common.read(NAME)}
        wrong = []
        for row in fresh:
            old = stored.get(tuple(row[key] for key in KEYS))
            if old is None or any(old[key] != row[key] for key in COLUMNS[:COLUMNS.index("quantity")]):
                wrong.append(f"{NAME}: {row['state']}, {row['quantity']} is not in the file")
            elif abs(float(old["value"]) - float(row["value"])) > 0.1 * float(old["error"]):
                wrong.append(f"{NAME}: {row['state']}, {row['quantity']}: file {old['value']}, recomputed {row['value']}")
        common.finish(wrong, start, f"line_panels.py --check of {len(fresh)} rows")
    common.write(NAME, "python3 verification/references/line_panels.py", "steady sliding of periodic lines with a law of attraction, by panels in real space", COLUMNS, fresh,
                 precision="double precision; three meshes, each twice as fine, extrapolated by their second order; `error` by two extrapolations",
                 tool=f"numpy {np.__version__}")


if __name__ == "__main__":
    main()
