"""Dawson's function and its two small differences; writes or checks dawson.csv.

    D(x) = int_0^x e^{t^2 - x^2} dt

    column                     meaning
    argument                   x, an exact double
    dawson                     D(x)
    argument_minus_dawson      x - D(x), about 2 x^3/3 for small x
    slope                      1 - 2 x D(x) = D'(x), about -1/(2 x^2) for large x, zero near 0.924

Method: D = x 1F1(1; 3/2; -x^2) at 90 digits. Confirmed by quadrature of the definition (Gauss panels in p, t = x(1-p),
the panels of raw_crack_work.memory) at 80 digits; both differences are formed before rounding.
"""

import sys

sys.dont_write_bytecode = True

import time

from mpmath import mp, mpf

from common import (Setting, arguments, confirmed, differences, exact, finish, number, panels, read, write)

NAME = "dawson.csv"
COMMAND = "python3 verification/references/dawson.py"
COLUMNS = ["argument", "dawson", "argument_minus_dawson", "slope", "confirmed_digits"]
QUADRATURE = Setting("dawson", 80, 64, 180)

POINTS = sorted(
    [10.0 ** k for k in range(-10, 11)] + [2.3e-8, 3.7e-5, 4.1e-3, 0.02, 0.05, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 0.92,
     0.924, 0.9241388730045916, 0.9241388730045917, 0.925, 0.95, 1.1, 1.3, 1.5, 1.5019752682, 2.0, 2.5, 3.0, 3.5, 4.0,
     4.5, 5.0, 5.5, 6.0, 6.5, 7.0, 8.0, 9.0, 11.0, 12.5, 14.0, 16.0, 18.0, 20.0, 25.0, 30.0, 50.0, 317.0, 2.9e4, 6.7e7])


def by_series(x):
    return x * mp.hyp1f1(1, mpf(3) / 2, -x * x)


def by_quadrature(x):
    """D = x int_0^1 e^{-x^2 p (2-p)} dp, cut where the exponent passes 180."""
    reach = x * x
    breaks, exponent, last = [mpf(0)], mpf(0), min(reach, mpf(QUADRATURE.cutoff))
    while exponent < last:
        exponent = min(exponent + 20, last)
        q = exponent / reach
        breaks.append(q / (1 + mp.sqrt(1 - q)) if exponent < reach else mpf(1))
    return x * panels(QUADRATURE, lambda p: mp.exp(-reach * p * (2 - p)), breaks)


def rows_of(points):
    out = []
    for point in points:
        with mp.workdps(90):
            x = exact(point)
            a = by_series(x)
            with mp.workdps(QUADRATURE.dps):
                b = by_quadrature(x)
            triples = [(a, b), (x - a, x - b), (1 - 2 * x * a, 1 - 2 * x * b)]
            out.append(dict(argument=repr(point), dawson=number(a), argument_minus_dawson=number(x - a),
                            slope=number(1 - 2 * x * a), confirmed_digits=min(confirmed(q, p) for p, q in triples)))
    return out


def main():
    options = arguments("Dawson's function.")
    start = time.time()
    rows = rows_of(POINTS[::4] if options.reduced else POINTS)
    if options.self_check:
        finish([f"x = {r['argument']}: only {r['confirmed_digits']} digits" for r in rows if r["confirmed_digits"] < 18],
               start, "self-check")
    if options.check:
        finish(differences(NAME, read(NAME), rows, ["argument"]), start, f"check of {len(rows)} rows")
    write(NAME, COMMAND, "Dawson's function D, x - D and 1 - 2 x D", COLUMNS, rows,
          precision=f"90 digits; confirmed against {QUADRATURE.dps} digits, {QUADRATURE.nodes} nodes a panel; 32 digits printed")
    print(f"written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
