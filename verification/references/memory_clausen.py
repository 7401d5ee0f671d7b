"""Clausen's integral on the circle and with a fading memory; writes or checks clausen.csv and memory_clausen.csv.

    Cl2(x) = sum sin(m x)/m^2,   Li2(e^{ix}) = real + i Cl2(x),   L(x) = log|2 sin(x/2)|
    I(x; zeta) = int_0^inf e^{-z} Cl2(x + zeta z) dz,   M(x; zeta) = int_0^inf e^{-z} L(x + zeta z) dz

clausen.csv: angle (exact double), clausen (mpmath clsin), dilogarithm_real (mpmath polylog), log_sine.
memory_clausen.csv: angle, ratio (zeta, exact doubles), integral I, increment I(x) - I(0), memory_logarithm M.

Routes to I, which must agree; `confirmed_digits` is the worst agreement among them (absolute where I crosses zero: the
scale is 1/(1 + zeta), the largest I there is):
    definition      the integral as defined, panels graded towards every 2 pi n               zeta <= 0.5
    one period      the same over one period, the others summed as a geometric series         every zeta
    hypergeometric  Im[-zeta^2 2F1(1, i/zeta; 1 + i/zeta; e^{ix}) + zeta(zeta - i log(1 - e^{ix})) + Li2(e^{ix})]
                    (thesis Sec 3.3, third parameter mended)                                  0.01 <= zeta <= 1e4
    images          Cl2 - zeta (L + sum_n W((x - 2 pi n)/zeta)), W = e^z E1(z), far images by Hurwitz zeta   zeta < 0.05
    polylogarithms  -Im sum_k Li_{3+k}(e^{ix}) (1/(i zeta))^{k+1}                             zeta >= 30
M: (Cl2 - I)/zeta, confirmed by the one-period integral of L itself.
"""

import sys

sys.dont_write_bytecode = True

import time
from concurrent.futures import ProcessPoolExecutor

from mpmath import mp, mpf, mpc

from common import COARSE, FINE, arguments, differences, exact, finish, gauss, number, read, write

COMMAND = "python3 verification/references/memory_clausen.py"
CIRCLE = "clausen.csv"
MEMORY = "memory_clausen.csv"
CIRCLE_COLUMNS = ["angle", "clausen", "dilogarithm_real", "log_sine", "confirmed_digits"]
MEMORY_COLUMNS = ["angle", "ratio", "integral", "increment", "memory_logarithm", "routes", "confirmed_digits"]

ANGLES = sorted(set(
    [10.0 ** -k for k in (0, 1, 2, 3, 5, 8, 12, 16, 30, 100, 300)]
    + [0.25, 0.5, 0.75, 1.0471975511965976, 1.25, 1.5, 1.57, 1.75, 1.7999, 1.8, 1.8001, 2.0, 2.25, 2.5, 2.75, 3.0, 3.1, 3.14,
       3.1415926, 3.141592653589793, 3.1415926535897936, 3.2, 4.0, 4.5, 5.0, 6.0, 6.28, 6.283185307179586, 6.283185307179587, 6.3, 7.0,
       9.42477796076938, 12.566370614359172, 31.4, 100.0, 1234.5678, 1e5, 1e10, 1e22]
    + [-1e-7, -0.3, -1.0, -2.2, -3.0, -3.141592653589793, -6.283185307179586, -50.0]))

RATIOS = [1e-8, 1e-6, 1e-4, 1e-3, 0.0123, 0.05, 0.2, 0.5, 0.999, 1.0, 1.001, 2.0, 5.0, 30.0, 1e3, 1e5, 1e8]


def angles_of(ratio):
    base = [1e-10, 1e-4, 0.3, 3.1, 4.4, 6.282, -1e-6]
    if ratio < 1:
        base += [1.49 * ratio, 1.51 * ratio, -1.51 * ratio, 6 * ratio, -6 * ratio, -35 * ratio, -41 * ratio]
    return [x for x in base if abs(x) < 6.2831]


POINTS = [(x, ratio) for ratio in RATIOS for x in angles_of(ratio)]


# ---------------------------------------------------------------- Cl2 and L at many points

_SERIES = {}


def coefficients(dps):
    """zeta(2k)/(k(2k+1)) and (1 - 4^-k) times it."""
    if dps not in _SERIES:
        with mp.workdps(dps + 10):
            near = [mp.zeta(2 * k) / (k * (2 * k + 1)) for k in range(1, int(1.7 * dps) + 5)]
            far = [(1 - mpf(4) ** -(k + 1)) * c for k, c in enumerate(near)]
        _SERIES[dps] = near, far
    return _SERIES[dps]


def clausen(x):
    """Cl2 by its two power series; confirmed against clsin in clausen.csv."""
    near, far = coefficients(mp.dps)
    x = x - 2 * mp.pi * mp.nint(x / (2 * mp.pi))
    size = abs(x)
    if size == 0:
        return mpf(0)
    total = mpf(0)
    if size < mpf(9) / 5:
        t = (x / (2 * mp.pi)) ** 2
        for c in reversed(near):
            total = (total + c) * t
        return x * (1 - mp.log(size) + total)
    y = mp.pi - size
    t = (y / mp.pi) ** 2
    for c in reversed(far):
        total = (total + c) * t
    return mp.sign(x) * y * (mp.log(2) - total)


def log_sine(x):
    return mp.log(abs(2 * mp.sin(x / 2)))


# ---------------------------------------------------------------- quadrature in s = zeta z

def breaks_between(lower, upper, start, end, widest, smallest):
    """Panels from start at least to end (or to upper), graded by 4 towards both singular ends lower <= start and upper."""
    if upper - end > end - start:
        middle = end
    else:
        middle = (max(start, lower) + upper) / 2
    out = [start]
    distance = start - lower
    if distance < smallest:
        distance = smallest
        out.append(lower + distance)
    while lower + distance < middle:
        distance = min(4 * distance, distance + widest)
        out.append(min(lower + distance, middle))
    if middle == end:
        return out
    back = []
    distance = smallest
    while upper - distance > out[-1]:
        back.append(upper - distance)
        distance = min(4 * distance, distance + widest)
    return out + back[::-1] + [upper]


def remembered(setting, function, x, ratio, reach, smallest):
    """int_0^reach e^{-s/ratio} f(x + s) ds/ratio with f singular at every 2 pi n."""
    turn = 2 * mp.pi
    lower = turn * mp.floor(x / turn)
    total, start, rule = mpf(0), x, gauss(setting)
    while start < x + reach:
        upper = lower + turn
        # The last piece ends where the exponential does, or at the end of the period.
        points = breaks_between(lower, upper, start, min(upper, x + reach), 8 * ratio, smallest)
        for a, b in zip(points[:-1], points[1:]):
            a, b = max(a, start), min(b, x + reach)
            if b <= a or a - x > setting.cutoff * ratio:
                continue
            width = b - a
            total += width * mp.fsum(w * mp.exp(-(a + width * t - x) / ratio) * function(a + width * t) for t, w in rule)
        lower = start = upper
    return total / ratio


def by_definition(setting, x, ratio):
    return remembered(setting, clausen, x, ratio, setting.cutoff * ratio, mpf(10) ** -16)


def by_one_period(setting, x, ratio, function=clausen, smallest=None):
    reach = 2 * mp.pi
    if reach > setting.cutoff * ratio:
        reach = setting.cutoff * ratio
    smallest = smallest or mpf(10) ** -20
    return remembered(setting, function, x, ratio, reach, smallest) / -mp.expm1(-2 * mp.pi / ratio)


def by_hypergeometric(x, ratio, third=None):
    b = 1 / ratio
    point = mp.expj(x)
    third = 1 + 1j * b if third is None else third
    value = mp.hyp2f1(1, 1j * b, third, point, maxterms=10 ** 6)
    return mp.im(-ratio ** 2 * value + ratio * (ratio - 1j * mp.log(1 - point)) + mp.polylog(2, point))


def by_images(x, ratio):
    x = x - 2 * mp.pi * mp.nint(x / (2 * mp.pi))

    def memory(z):
        return mp.exp(z) * mp.e1(z) if z > 0 else -mp.exp(z) * mp.ei(-z)

    near = 3 + int(mp.ceil(2 * mp.dps * ratio))
    total = mp.fsum(memory((x - 2 * mp.pi * n) / ratio) for n in range(-near, near + 1))
    # W(z) = sum (-1)^k k!/z^{k+1}; the far images n > near on both sides.
    a, scale = x / (2 * mp.pi), ratio / (2 * mp.pi)
    first = near + 1
    total += scale * (mp.digamma(first - a) - mp.digamma(first + a))
    k, last = 1, mp.inf
    while True:
        # (-1)^k k! scale^{k+1} [sum (n+a)^{-k-1} + (-1)^{k+1} sum (n-a)^{-k-1}]
        magnitude = mp.factorial(k) * scale ** (k + 1)
        term = (-1) ** k * magnitude * (mp.zeta(k + 1, first + a) + (-1) ** (k + 1) * mp.zeta(k + 1, first - a))
        size = magnitude * mp.zeta(k + 1, first - abs(a))
        if size > last or size < mpf(10) ** -mp.dps:
            break
        total, last, k = total + term, size, k + 1
    return clausen(x) - ratio * (log_sine(x) + total)


def by_polylogarithms(x, ratio):
    point, total, k = mp.expj(x), mpf(0), 0
    while True:
        term = -mp.im(mp.polylog(3 + k, point) * (1 / mpc(0, ratio)) ** (k + 1))
        total += term
        k += 1
        if mpf(ratio) ** -k < mpf(10) ** -mp.dps:
            return total


# ---------------------------------------------------------------- rows

def digits_of(difference, scale):
    if difference == 0:
        return 32
    return max(0, min(32, int(mp.floor(-mp.log10(abs(difference) / scale)))))


def memory_row(point):
    angle, speed = point
    with mp.workdps(FINE.dps):
        x, ratio = exact(angle), exact(speed)
        others = {}
        # Quadrature confirms; the value that is printed comes from a closed form or a series, at 60 digits.
        with mp.workdps(COARSE.dps):
            others["one_period"] = by_one_period(COARSE, x, ratio)
            if ratio <= 0.5:
                others["definition"] = by_definition(COARSE, x, ratio)
        if mpf("0.01") <= ratio <= 10000:
            others["hypergeometric"] = by_hypergeometric(x, ratio)
        if ratio < mpf("0.05"):
            others["images"] = by_images(x, ratio)
        if ratio >= 30:
            others["polylogarithms"] = by_polylogarithms(x, ratio)
        # The one-period form loses the digits of zeta; a series does not.
        best = next(others[name] for name in ("polylogarithms", "hypergeometric", "images") if name in others)
        scale = 1 / (1 + ratio)
        confirmed = min(digits_of(other - best, scale) for other in others.values())
        at_load = ratio * (mp.re(mp.digamma(1 + 1j / ratio)) + mp.euler)
        logarithm = (clausen(x) - best) / ratio
        with mp.workdps(COARSE.dps):
            direct = by_one_period(COARSE, x, ratio, log_sine, mpf(10) ** -28)
        confirmed = min(confirmed, digits_of(direct - logarithm, max(abs(logarithm), scale)))
        return dict(angle=repr(angle), ratio=repr(speed), integral=number(best), increment=number(best - at_load),
                    memory_logarithm=number(logarithm), routes=" ".join(sorted(others)),
                    confirmed_digits=confirmed)


def circle_row(angle):
    with mp.workdps(60 + 320):
        x = exact(angle)
        reduced = x - 2 * mp.pi * mp.nint(x / (2 * mp.pi))
    with mp.workdps(60):
        value, other = mp.clsin(2, reduced), clausen(reduced)
        real = mp.re(mp.polylog(2, mp.expj(reduced))) if abs(reduced) > mpf(10) ** -25 else mp.pi ** 2 / 6 - mp.pi * abs(reduced) / 2
        return dict(angle=repr(angle), clausen=number(value), dilogarithm_real=number(real), log_sine=number(log_sine(reduced)),
                    confirmed_digits=digits_of(value - other, abs(value)))


def rows_of(function, points, jobs):
    if jobs == 1:
        return [function(point) for point in points]
    with ProcessPoolExecutor(jobs) as pool:
        return list(pool.map(function, points, chunksize=1))


def main():
    options = arguments("Clausen's integral and its memory.")
    start = time.time()
    step = 16 if options.reduced else 1
    circle = rows_of(circle_row, ANGLES[::5 if options.reduced else 1], 1)
    memory = rows_of(memory_row, POINTS[::step], options.jobs)
    if options.self_check:
        wrong = [f"{CIRCLE}: x = {r['angle']}: only {r['confirmed_digits']} digits" for r in circle if r["confirmed_digits"] < 30]
        wrong += [f"{MEMORY}: x = {r['angle']}, zeta = {r['ratio']}: only {r['confirmed_digits']} digits ({r['routes']})"
                  for r in memory if r["confirmed_digits"] < 18]
        finish(wrong, start, "self-check")
    if options.check:
        wrong = differences(CIRCLE, read(CIRCLE), circle, ["angle"])
        wrong += differences(MEMORY, read(MEMORY), memory, ["angle", "ratio"])
        finish(wrong, start, f"check of {len(circle) + len(memory)} rows")
    write(CIRCLE, COMMAND, "Clausen's integral, real part of the dilogarithm and log|2 sin(x/2)| on the circle", CIRCLE_COLUMNS, circle,
          precision="60 digits, mpmath clsin and polylog; confirmed against power series; 32 digits printed")
    write(MEMORY, COMMAND, "the memory integrals of Clausen's function and of log|2 sin(x/2)|", MEMORY_COLUMNS, memory,
          precision="60 digits by series or closed form; confirmed by every other route, quadrature with 42 digits; 32 digits printed")
    print(f"fewest confirmed digits {min(r['confirmed_digits'] for r in memory)}, written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
