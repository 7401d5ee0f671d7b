"""Reference values for the elastic room: adhesive sphere and wave, near and far from their folds.

    problem   x1  x2  x3  x4  x5                          value, asked for by name
    jkr       R   E*  Δγ  imposed force or penetration    contact radius
    wave      E*  λ   Λ   Δγ  imposed pressure, depth     half-width of contact, of gap; pressure or depth of an extremum
    field     E*  λ   Λ   Δγ  position                    gap or pressure-borne displacement of a wave in contact over |x| < a = λ/5

Every input column is a double, taken bit for bit. Nothing is solved in the reduced variables of the Rust code.

Routes (column `route`)
    energy    root of the numerical derivative, in a, of the total energy (elastic energy of thesis Eq 1.31, minus πa²Δγ, minus FΔ under load):
              no equilibrium equation is used. Independent of the closed forms.
    raw       root by bisection of the printed pressure or penetration relation in ka/2; its extrema by bisection of the numerical derivative.
              Independent of the inverses and of the closed form of the extrema, not of the relation itself.
    kernel    displacement by quadrature of the logarithmic kernel of the half-plane over the printed pressure. Independent of the
              printed gap and penetration.
Column `independence`: route raw is a `fallback`, as it takes the solver's relation for granted.

Command: python3 verification/references/elastic.py [--check]
"""

import time

import mpmath
from mpmath import mp, mpf

from common import COARSE, FINE, arguments, confirmed, differences, double, exact, finish, number, read, write

NAME = "elastic.csv"
COLUMNS = ["problem", "asked", "branch", "x1", "x2", "x3", "x4", "x5", "value", "route", "confirmed_digits", "independence"]
SPHERES = [(0.0137, 2.6e6, 0.083), (3.1, 0.47, 2.9e-4)]
WAVES = [(1.7e6, 2.3e-5, 1.9e-7, 2.1e-4), (1.7e6, 2.3e-5, 1.9e-7, 7.3e-3), (5.3, 0.71, 0.033, 3.7e-7), (0.9, 4.4, 0.21, 0.031)]


def bisect(function, low, high):
    """Root between two arguments of opposite sign, to all digits carried; geometric means while the ends differ by decades."""
    negative = function(low) < 0
    for _ in range(40 * mp.dps):
        middle = mp.sqrt(low * high) if high > 4 * low else (low + high) / 2
        if middle in (low, high):
            break
        if (function(middle) < 0) == negative:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def slope(function, x):
    """Central difference of fourth order with a step that costs half of the working digits, taken at twice the digits."""
    digits = mp.dps
    with mp.workdps(5 * digits):
        h = x * mpf(10) ** (-digits)
        return (8 * (function(x + h) - function(x - h)) - (function(x + 2 * h) - function(x - 2 * h))) / (12 * h)


# ---------------------------------------------------------------- sphere

def elastic_energy(R, E, a, depth):
    return E * (a * depth ** 2 - 2 * a ** 3 * depth / (3 * R) + a ** 5 / (5 * R ** 2))


def jkr_energy(R, E, w, asked, imposed):
    def total(a):
        if asked == "contact_radius_by_penetration":
            return elastic_energy(R, E, a, imposed) - mp.pi * a ** 2 * w
        depth = imposed / (2 * E * a) + a ** 2 / (3 * R)     # from F = dU/dΔ
        return elastic_energy(R, E, a, depth) - mp.pi * a ** 2 * w - imposed * depth
    return total


def jkr_cases():
    for R, E, w in SPHERES:
        with mp.workdps(60):
            weight = 3 * mp.pi * exact(R) * exact(w) / 2
            radius = (mp.pi * exact(w) * exact(R) ** 2 / (8 * exact(E))) ** (mpf(1) / 3)
            deepest = 3 * radius ** 2 / exact(R)
        for unit, asked in ((weight, "contact_radius_by_force"), (deepest, "contact_radius_by_penetration")):
            for ratio in (-1 + 1e-12, -1 + 1e-8, -1 + 1e-4, -0.7, -0.1, -1e-6, 1e-3, 1.0, 40.0, 1e6):
                imposed = float(unit * mpf(ratio))
                for branch in ("stable", "unstable"):
                    if branch == "stable" or ratio < 0:
                        yield R, E, w, imposed, asked, branch


def jkr_value(R, E, w, imposed, asked, branch):
    R, E, w, imposed = map(exact, (R, E, w, imposed))
    total = jkr_energy(R, E, w, asked, imposed)
    fold = (mp.pi * w * R ** 2 / (8 * E)) ** (mpf(1) / 3)
    if asked == "contact_radius_by_force":
        fold *= mpf(9) ** (mpf(1) / 3)
    # Under compression the energy is stationary at two larger radii, one with a pressed rim: start from the Hertz radius, where K = 0.
    hertz = (3 * imposed * R / (4 * E)) ** (mpf(1) / 3) if asked.endswith("force") else mp.sqrt(R * imposed)
    fold = max(fold, hertz) if imposed > 0 else fold
    low, high = (fold, fold * mpf(10) ** 5) if branch == "stable" else (fold * mpf(10) ** -16, fold)
    return bisect(lambda a: slope(total, a), low, high)


# ---------------------------------------------------------------- wave

class Wave:
    def __init__(self, E, length, height, w):
        self.E, self.length, self.height, self.w = map(exact, (E, length, height, w))
        self.full = mp.pi * self.E * self.height / self.length

    def pressure(self, half):
        """Mean pressure at half = ka/2."""
        return self.full * mp.sin(half) ** 2 - mp.sqrt(2 * self.E * self.w * mp.tan(half) / self.length)

    def depth(self, half):
        alpha = mp.sqrt(2 * self.E * self.w / self.length) / self.full
        s = mp.sin(half)
        return self.height * (s ** 2 * (1 - 2 * mp.log(s)) + 2 * alpha * mp.sqrt(mp.tan(half)) * mp.log(s))

    def pull_off(self):
        # The curvature of the pressure changes sign once between the extrema; the steepest place separates them.
        return bisect(lambda x: slope(self.pressure, x), mpf(10) ** -20, self.steepest())

    def snap_in(self):
        # In the complement, whose small values need the relative precision.
        return mp.pi / 2 - bisect(lambda y: slope(lambda z: self.pressure(mp.pi / 2 - z), y), mpf(10) ** -20, mp.pi / 2 - self.steepest())

    def steepest(self):
        grid = [mp.pi / 2 * (i + mpf(1) / 2) / 400 for i in range(400)]
        best = max(grid, key=lambda x: slope(self.pressure, x))
        if slope(self.pressure, best) <= 0:
            raise ValueError("no stable contact")
        return best

    def fold(self):
        return bisect(lambda x: slope(self.depth, x), mpf(10) ** -25, mpf("0.2"))


def wave_roots(wave, asked, branch, imposed):
    relation = wave.depth if asked.endswith("penetration") else wave.pressure
    residual = lambda half: relation(half) - imposed
    if asked.endswith("penetration"):
        inner, outer = wave.fold(), None
    elif branch == "narrow":
        inner, outer = wave.pull_off(), None
    else:
        inner, outer = wave.pull_off(), wave.snap_in()
    tiny = mpf(10) ** -30
    if branch in ("narrow", "unstable"):
        half = bisect(residual, tiny, inner)
    else:
        # The complement is the unknown, so that a thin gap is resolved.
        low, high = {"stable": (outer, inner), "wide": (None, outer)}[branch]
        low = tiny if low is None else mp.pi / 2 - low
        rest = bisect(lambda y: residual(mp.pi / 2 - y), low, mp.pi / 2 - high)
        return rest if asked.startswith("gap") else mp.pi / 2 - rest
    return mp.pi / 2 - half if asked.startswith("gap") else half


def wave_cases():
    for shape in WAVES:
        with mp.workdps(40):
            wave = Wave(*shape)
            try:
                lowest, highest = wave.pressure(wave.pull_off()), wave.pressure(wave.snap_in())
                for name in ("pull_off", "snap_in"):
                    yield shape, 0.0, "pressure_at_" + name, ""
                    yield shape, 0.0, "half_width_at_" + name, ""
                span = highest - lowest
                for part in (1e-12, 1e-6, 0.01, 0.3, 0.8, 1 - 1e-3, 1 - 1e-9):
                    yield shape, float(lowest + span * mpf(part)), "contact_half_width_by_mean_pressure", "stable"
                for part in (1e-9, 1e-3, 0.5, 0.99, 1 - 1e-6):
                    yield shape, float(lowest * (1 - mpf(part))), "contact_half_width_by_mean_pressure", "narrow"
                for part in (1e-9, 0.01, 1.0, 30.0, 1e4):
                    yield shape, float(highest - span * mpf(part)), "gap_half_width_by_mean_pressure", "wide"
            except ValueError:
                pass
            lowest = wave.depth(wave.fold())
            yield shape, 0.0, "penetration_at_fold", ""
            yield shape, 0.0, "half_width_at_fold", ""
            for part in (1e-10, 1e-4, 0.5, 0.95, 1 - 1e-5):
                yield shape, float(lowest * (1 - mpf(part))), "contact_half_width_by_penetration", "unstable"
                yield shape, float(lowest * (1 - mpf(part))), "contact_half_width_by_penetration", "stable"
            for part in (0.2, 0.9, 0.999):
                yield shape, shape[2] * part, "contact_half_width_by_penetration", "stable"
                yield shape, shape[2] * part, "gap_half_width_by_penetration", "stable"


def wave_value(shape, imposed, asked, branch):
    wave = Wave(*shape)
    length = wave.length / mp.pi
    if asked.endswith("fold"):
        fold = wave.fold()
        return wave.depth(fold) if asked.startswith("penetration") else length * fold
    if "_at_" in asked:
        half = wave.pull_off() if asked.endswith("pull_off") else wave.snap_in()
        return wave.pressure(half) if asked.startswith("pressure") else length * half
    return length * wave_roots(wave, asked, branch, exact(imposed))


# ---------------------------------------------------------------- fields of the wave

def field_cases():
    for shape in WAVES[:3]:
        for part in (0.0, 0.55, 0.97):
            yield shape, part * shape[1] / 5, "displacement", "contact"
        for part in (1.001, 1.2, 2.0, 2.5):
            yield shape, part * shape[1] / 5, "displacement", "gap"


def field_value(shape, position, _asked, _branch):
    """w = -(2/(πkE*)) ∫ ln|2 sin(k(x-ξ)/2)| p dkξ·½…: zero-mean surface displacement under p, by tanh-sinh between the singular points."""
    wave = Wave(*shape)
    k = 2 * mp.pi / wave.length
    edge, x = exact(double_of_fifth(shape)) * k, exact(position) * k
    s = mp.sin(edge / 2)
    pull = mp.sqrt(2 * wave.E * wave.w * mp.tan(edge / 2) / wave.length)

    def load(phi):
        # p dξ with sin(kξ/2) = s sin φ, which lifts the root singularities at the edges; ξ even.
        return 2 * (2 * wave.full * s ** 2 * mp.cos(phi) ** 2 - pull)

    def kernel(phi):
        y = 2 * mp.asin(s * mp.sin(phi))
        near = 2 * mp.sin((x - y) / 2)
        return -(mp.log(abs(near)) if near else mpf(0)) - mp.log(2 * mp.sin((x + y) / 2))

    breaks = [mpf(0), mp.pi / 2]
    if x < edge:
        split = mp.asin(mp.sin(x / 2) / s)
        breaks = [mpf(0), split, mp.pi / 2] if x > 0 else breaks
    integral = mp.quad(lambda phi: load(phi) * kernel(phi), breaks)
    return 2 * integral / (mp.pi * wave.E * k)


def double_of_fifth(shape):
    return shape[1] / 5


# ---------------------------------------------------------------- file

def rows():
    for R, E, w, imposed, asked, branch in jkr_cases():
        yield make("jkr", asked, branch, (R, E, w, imposed), "energy", lambda: jkr_value(R, E, w, imposed, asked, branch))
    for shape, imposed, asked, branch in wave_cases():
        yield make("wave", asked, branch, (*shape, imposed), "raw", lambda: wave_value(shape, imposed, asked, branch))
    for shape, position, asked, branch in field_cases():
        yield make("field", asked, branch, (*shape, position), "kernel", lambda: field_value(shape, position, asked, branch))


def make(problem, asked, branch, inputs, route, compute):
    values = []
    for setting in (COARSE, FINE):
        with mp.workdps(setting.dps):
            values.append(compute())
    row = {"problem": problem, "asked": asked, "branch": branch, "route": route, "independence": "fallback" if route == "raw" else "independent"}
    row.update({f"x{i + 1}": double(x) for i, x in enumerate(inputs)})
    with mp.workdps(60):
        row["value"] = number(values[1])
        row["confirmed_digits"] = confirmed(*values)
    return row


def main():
    start = time.time()
    options = arguments("Reference values of the elastic room")
    fresh = list(rows())
    if options.check or options.self_check:
        keys = ["problem", "asked", "branch", "x1", "x2", "x3", "x4", "x5"]
        finish(differences(NAME, read(NAME), fresh, keys), start, NAME)
    about = "adhesive sphere (energy) and wave (raw relation, kernel); columns and independence in verification/references/elastic.py"
    write(NAME, "python3 verification/references/elastic.py", about, COLUMNS, fresh)
    print(f"least agreement of the two precisions: {min(row['confirmed_digits'] for row in fresh)} digits, {time.time() - start:.0f} s")


if __name__ == "__main__":
    main()
