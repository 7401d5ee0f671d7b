"""Reference values for cracks that start late: writes or checks delayed_fracture.csv and delayed_fracture_raw.csv.

    python3 verification/references/delayed_fracture.py                    regenerate both files (needs numpy for the second)
    python3 verification/references/delayed_fracture.py --check            recompute all, compare to the confirmed digits
    python3 verification/references/delayed_fracture.py --check --reduced  delays and every fourth case of the series; no numpy
    python3 verification/references/delayed_fracture.py --self-check       series against quadrature of its own delay equation

One deformable half against a rigid one, plane stress; solids of materials.py; every input an exact double.

delayed_fracture.csv, one value a row (key: case, quantity, place)
    delay          t_d of K^2 J(t_d)/2 = work of adhesion (thesis 5.66), by bisection of the creep series itself
    initial_speed  speed over process zone just after, J'(t_d)/(J(t_d) - J(0)) (1/s)
    time_at        time at which the tip of a one-term solid has run `place` process zones, from the exact solution
                   w(q) = e^{t/tau} of dw/dq = (w(q) - w(q-1))/c, w = 1 for q < 0, w(0+) = 1/c, c = (1 - 1/k)/(1 - 1/beta), by Laplace transform:
                   w(q) = sum_n (-a)^n {W e_n(q - n) - a [s_n(q - n) - s_n(q - n - 1)]},  a = 1/c, W = a,
                   e_n(x) = x^n e^{ax}/n!, s_n(x) = int_0^x e_n, both 0 for x < 0
    speed_at       speed over process zone there, before the kink at place 1 if any (1/s)
    independence   delays are independent; all else rests on the delay equation to which the solver, too, reduces (5.67): `fallback`

delayed_fracture_raw.csv (key: case, steps, time): the tip as the thesis steps it, nothing reduced
    (5.54) with (5.53) as printed but for the root over the distance: displacement on M points of the zone as a sum over all earlier
    steps, each with its own increment of J and the mean of u_1 at its ends; (5.67) by the midpoint rule in the angle x = a + zone sin^2; the
    place x_0(t_k+1) by bisection and secants. Double precision. `place` is in process zones; `time` in s; three numbers of steps a case.
    `load` is "hold K_0 K_1 end" or "ramp K_0 K_1 end", straight from K_0 to K_1; or "follow t_0 K_0 t_1 K_1 ...", straight between these, where the
    process zone follows the load, process_zone (K(t)/K_0)^2: at each step the points of the zone are those of the zone at that time
"""

import sys

sys.dont_write_bytecode = True

import time as clock

from mpmath import mp, mpf

from common import COARSE, FINE, arguments, confirmed, differences, double, exact, finish, number, read, write
from materials import MATERIALS

COMMAND = "python3 verification/references/delayed_fracture.py"
COLUMNS = ["case", "material", "work_of_adhesion", "intensity", "quantity", "place", "value", "confirmed_digits", "independence"]
RAW_COLUMNS = ["case", "material", "work_of_adhesion", "process_zone", "load", "steps", "time", "place"]
POSITIONS = [1e-12, 1e-8, 1e-4, 0.03, 0.3, 0.6, 0.9, 1 - 1e-4, 1 - 1e-8, 1 - 1e-11]
RISE = 0.08
PLACES = [0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.5, 7.0]


def creep(material, t):
    out = material.instant_compliance() + mp.fsum(j * -mp.expm1(-t / tau) for j, tau in zip(material.strengths, material.times))
    return out + (t / material.viscosity if material.viscosity else 0)


def creep_rate(material, t):
    out = mp.fsum(j / tau * mp.exp(-t / tau) for j, tau in zip(material.strengths, material.times))
    return out + (1 / material.viscosity if material.viscosity else 0)


def limits(material, work):
    lower = mp.sqrt(2 * work * material.relaxed_modulus()) if not material.viscosity else mpf(0)
    return lower, mp.sqrt(2 * work * material.glassy_modulus())


def delay(material, work, intensity):
    wanted = 2 * work / intensity ** 2
    scale = max(material.times) if material.series else mpf(1)
    low, high = mpf(0), scale
    while creep(material, high) < wanted:
        high *= 2
    # Bisection in the logarithm, so that early and late delays keep their digits alike.
    low = high
    while creep(material, low) > wanted:
        low /= 2
    for _ in range(int(mp.prec) + 10):
        middle = (low + high) / 2
        if creep(material, middle) < wanted:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def loads():
    """(case, material, intensity as a double)"""
    out = []
    for name, material in MATERIALS.items():
        if material.kind != "creep" or not material.series:
            continue
        with mp.workdps(60):
            lower, upper = limits(material, exact(material.adhesion))
            for index, position in enumerate(POSITIONS):
                if lower:
                    # Positions of K^2 near each limit are distances from it.
                    value = mp.sqrt(lower ** 2 + (upper ** 2 - lower ** 2) * exact(position))
                else:
                    value = upper * mp.sqrt(exact(position))
                out.append((f"{name}_{index}", name, float(value)))
    return out


def one_term(material, work, intensity, place):
    """w(q) and dw/dq just below q (the kink belongs to the motion after it)."""
    e0, einf = material.relaxed_modulus(), material.glassy_modulus()
    k = intensity ** 2 / (2 * work * e0)
    a = (1 - e0 / einf) / (1 - 1 / k)

    def e(n, x):
        return x ** n * mp.exp(a * x) / mp.factorial(n) if x >= 0 else mpf(0)

    def s(n, x):
        # int_0^x y^n e^{ay}/n! dy = (-1/a)^{n+1} [1 - e^{ax} sum_m (-ax)^m/m!]
        if x <= 0:
            return mpf(0)
        return (-1 / a) ** (n + 1) * (1 - mp.exp(a * x) * mp.fsum((-a * x) ** m / mp.factorial(m) for m in range(n + 1)))

    def w(q):
        if q < 0:
            return mpf(1)
        return mp.fsum((-a) ** n * (a * e(n, q - n) - a * (s(n, q - n) - s(n, q - n - 1))) for n in range(int(mp.floor(q)) + 1))

    before = mpf(1) if place <= 1 else w(place - 1)
    value = w(place)
    return value, a * (value - before)


def rows_of(case, name, intensity, with_series):
    material = MATERIALS[name]
    head = dict(case=case, material=name, work_of_adhesion=double(material.adhesion), intensity=double(intensity))
    found = []
    for setting in (COARSE, FINE):
        with mp.workdps(setting.dps + 30):
            work, k = exact(material.adhesion), exact(intensity)
            lower, upper = limits(material, work)
            if not lower < k < upper:
                return []
            t = delay(material, work, k)
            values = {("delay", ""): t, ("initial_speed", ""): creep_rate(material, t) / (creep(material, t) - creep(material, mpf(0)))}
            if with_series:
                tau = material.times[0]
                for place in PLACES:
                    with mp.workdps(setting.dps + 60):
                        w, slope = one_term(material, work, k, exact(place))
                        values["time_at", double(place)] = tau * mp.log(w)
                        values["speed_at", double(place)] = w / (slope * tau)
            found.append(values)
    return [dict(head, quantity=quantity, place=place, value=number(found[1][quantity, place]),
                 confirmed_digits=confirmed(found[0][quantity, place], found[1][quantity, place]),
                 independence="independent" if quantity == "delay" else "fallback") for quantity, place in found[1]]


def rows(reduced):
    out = []
    for index, (case, name, intensity) in enumerate(loads()):
        material = MATERIALS[name]
        position = int(case.rsplit("_", 1)[1])
        series = len(material.series) == 1 and not material.viscosity and 3 <= position <= 6
        if not reduced or index % 4 == 0:
            out += rows_of(case, name, intensity, series)
    return out


# ---------------------------------------------------------------- the thesis's own stepping

def raw_cases():
    """(case, material, kind of load, K^2 at its start as a part of the delayed range); a ramp rises by RISE"""
    names = [name for name, m in MATERIALS.items() if m.kind == "creep" and not m.flow and len(m.series) in (1, 3)]
    chosen = [next(n for n in names if len(MATERIALS[n].series) == 1), next(n for n in names if len(MATERIALS[n].series) == 3)]
    kinds = (("hold", 0.35), ("ramp", 0.3), ("follow", 0.3), ("swing", 0.3))
    return [(f"{name}_{kind}", name, kind, part) for name in chosen for kind, part in kinds]


# Loads over the first one, and times over the start of growth, after the ramp up to it: a zone that grows; one that shrinks and grows again.
WAYS = {"follow": [(4.0, 1 + 2 * RISE)], "swing": [(2.0, 1 + 2 * RISE), (2.75, 1 + 0.3 * RISE), (4.0, 1 + 2 * RISE)]}


def ramp_work(material, k, rise, t):
    """The work of a resting tip under K = k + rise*t."""
    load = k + rise * t
    memory = mp.fsum(j * (load - k * mp.exp(-t / tau) + rise * tau * mp.expm1(-t / tau))
                     for j, tau in zip(material.strengths, material.times))
    return load * (load * material.instant_compliance() + memory) / 2


def raw_run(material, work, zone, load, end, steps, points=1600):
    import numpy as np
    theta = (np.arange(points) + 0.5) * (np.pi / 2) / points
    longest = max(zone(t) for t in np.linspace(0.0, end, 4001))
    strengths, times = np.array([float(j) for j in material.strengths]), np.array([float(t) for t in material.times])
    glassy = float(material.instant_compliance())
    grid = np.linspace(0.0, end, steps + 1)
    k = np.array([load(t) for t in grid])
    places = np.zeros(steps + 1)

    def compliance(t):
        return glassy + (strengths * -np.expm1(-np.outer(np.atleast_1d(t), 1 / times))).sum(axis=1)

    for n in range(1, steps + 1):
        here = zone(grid[n])
        outside = np.cos(theta) ** 2 * here
        weight = (np.pi / 2) / points * 2 * np.sqrt(here) * np.cos(theta) / np.sqrt(2 * np.pi)    # sigma+/K dx
        increments = compliance(grid[n] - grid[:n]) - compliance(grid[n] - grid[1:n + 1])
        c = np.zeros(n + 1)
        c[:n] += 0.5 * increments
        c[1:] += 0.5 * increments
        c[n] += glassy
        c *= k[:n + 1] * np.sqrt(8 / np.pi)

        def excess(x):
            places[n] = x
            gaps = outside[:, None] - (x - places[None, :n + 1])
            gap = np.sqrt(np.maximum(gaps, 0.0)) @ c
            return 0.5 / here * k[n] * float(weight @ gap) - work

        low, high = places[n - 1], places[n - 1] + here
        f_low = excess(low)
        if f_low <= 0:
            places[n] = low
            continue
        f_high = excess(high)
        x = low
        for _ in range(60):
            x = low + (high - low) * f_low / (f_low - f_high)
            value = excess(x)
            if abs(value) < 1e-12 * work or high - low < 1e-13 * longest:
                break
            if value > 0:
                low, f_low, f_high = x, value, 0.5 * f_high
            else:
                high, f_high, f_low = x, value, 0.5 * f_low
        places[n] = x
    return places


def ramp_through(corners):
    def load(t):
        for (t0, k0), (t1, k1) in zip(corners, corners[1:]):
            if t <= t1:
                return k0 + (k1 - k0) * (t - t0) / (t1 - t0)
        return corners[-1][1]
    return load


def raw_rows():
    out = []
    for case, name, kind, part in raw_cases():
        material = MATERIALS[name]
        with mp.workdps(40):
            work, zone = exact(material.adhesion), material.length
            lower, upper = limits(material, work)
            k = float(mp.sqrt(lower ** 2 + (upper ** 2 - lower ** 2) * exact(part)))
            late = delay(material, work, exact(k))
            # The start of growth lies on a node, a quarter of the way: otherwise it is found to first order only.
            rise = 0.0 if kind == "hold" else RISE * k / (4 * float(late))
            end = 4 * float(mp.findroot(lambda t: ramp_work(material, k, rise, t) - work, (late / 2, late), solver="anderson"))
        last = k + rise * end
        load, text = (lambda t: k + rise * t), f"{kind} {double(k)} {double(last)} {double(end)}"
        length = lambda t: zone
        if kind in WAYS:
            # The ramp up to the start of growth, a quarter of the way, then the points of the way.
            corners = [(0.0, k), (end / 4, k + rise * end / 4)] + [(end / 4 * time, k * ratio) for time, ratio in WAYS[kind]]
            load, text = ramp_through(corners), "follow " + " ".join(f"{double(t)} {double(v)}" for t, v in corners)
            length = lambda t: zone * (load(t) / k) ** 2
        for steps in (48, 96, 192):
            places = raw_run(material, float(work), length, load, end, steps) / zone
            for index in range(16):
                node = (index + 1) * steps // 16
                out.append(dict(case=case, material=name, work_of_adhesion=double(material.adhesion), process_zone=double(zone), load=text,
                                steps=steps, time=double(end * (index + 1) / 16), place=f"{places[node]:.9e}"))
    return out


def self_check():
    wrong = []
    with mp.workdps(40):
        for case, name, intensity in loads():
            material = MATERIALS[name]
            if len(material.series) != 1 or material.viscosity or not case.endswith("_4"):
                continue
            work, k = exact(material.adhesion), exact(intensity)
            a = 1 / ((1 - 2 * work * material.relaxed_modulus() / k ** 2) / (1 - material.relaxed_modulus() / material.glassy_modulus()))
            start = one_term(material, work, k, mpf(2))[0]
            end = one_term(material, work, k, mpf(3))[0]
            gained = mp.quad(lambda q: one_term(material, work, k, q)[1], mp.linspace(2, 3, 5))
            if abs((end - start) / gained - 1) > mpf(10) ** -25:
                wrong.append(f"{case}: the series does not solve its equation, {mp.nstr((end - start) / gained - 1, 3)}")
            if abs(mp.exp(delay(material, work, k) / material.times[0]) / a - 1) > mpf(10) ** -30:
                wrong.append(f"{case}: w(0+) is not 1/c")
    return wrong


def main():
    options = arguments("Reference values for delayed fracture.")
    start = clock.time()
    if options.self_check:
        finish(self_check(), start, "self-check")
    fresh = rows(options.reduced)
    raw = [] if options.reduced else raw_rows()
    if options.check:
        wrong = differences("delayed_fracture.csv", read("delayed_fracture.csv"), fresh, ["case", "quantity", "place"])
        for row, old in zip(raw, read("delayed_fracture_raw.csv") if raw else []):
            if abs(float(row["place"]) - float(old["place"])) > 1e-8:
                wrong.append(f"delayed_fracture_raw.csv: {row['case']} {row['steps']} {row['time']}")
        finish(wrong, start, f"check of {len(fresh) + len(raw)} rows")
    write("delayed_fracture.csv", COMMAND, "cracks that start late; columns in the opening of the script", COLUMNS, fresh)
    write("delayed_fracture_raw.csv", COMMAND, "tip positions by the thesis's own stepping, Eqs 5.53, 5.54, 5.67", RAW_COLUMNS, raw,
          precision="double; three step sizes, no digit confirmed")


if __name__ == "__main__":
    main()
