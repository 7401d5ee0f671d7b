"""The running mean of a decaying exponential; writes or checks exponential_mean.csv.

    phi(z) = (1 - e^{-z})/z

    column        meaning
    argument      z, an exact double
    mean          phi(z)
    complement    1 - phi(z), about z/2 for small z
    decline       phi(z) - e^{-z} = -z phi'(z), about z/2 for small z

Method: expm1 with as many extra digits as the subtractions lose. Confirmed by Gauss panels of the three definitions
    phi = int_0^1 e^{-zt} dt,   1 - phi = int_0^1 (1 - t) z e^{-zt} dt,   decline = int_0^1 z t e^{-zt} dt.
"""

import sys

sys.dont_write_bytecode = True

import time

from mpmath import mp, mpf

from common import COARSE, FINE, arguments, confirmed, differences, exact, finish, number, panels, read, write

NAME = "exponential_mean.csv"
COMMAND = "python3 verification/references/exponential_mean.py"
COLUMNS = ["argument", "mean", "complement", "decline", "confirmed_digits"]
POINTS = sorted([10.0 ** k for k in range(-15, 16)] + [1e-300, 1e-100, 1e-40, 1e40, 1e300, 0.03, 0.17, 0.29, 0.43, 0.6,
                0.7, 0.7499999999999999, 0.75, 0.7500000000000001, 0.8, 0.9, 1.3, 1.7, 1.793282132900761, 2.0, 2.7, 4.0,
                7.0, 15.0, 23.0, 36.0, 37.5, 50.0, 200.0, 708.0, 744.0, 746.0])


def closed(z):
    extra = max(0, int(-mp.log10(z))) + 10 if z < 1 else 10
    with mp.workdps(FINE.dps + 2 * extra):
        mean = -mp.expm1(-z) / z
        return mean, 1 - mean, mean - mp.exp(-z)


def by_quadrature(z):
    reach = min(mpf(1), COARSE.cutoff / z)
    count = max(1, int(mp.ceil(reach * z / 8)))
    breaks = [reach * k / count for k in range(count + 1)]
    return (panels(COARSE, lambda t: mp.exp(-z * t), breaks), panels(COARSE, lambda t: (1 - t) * z * mp.exp(-z * t), breaks),
            panels(COARSE, lambda t: z * t * mp.exp(-z * t), breaks))


def rows_of(points):
    out = []
    for point in points:
        with mp.workdps(FINE.dps):
            z = exact(point)
            fine = closed(z)
            with mp.workdps(COARSE.dps):
                coarse = by_quadrature(z)
            out.append(dict(argument=repr(point), mean=number(fine[0]), complement=number(fine[1]), decline=number(fine[2]),
                            confirmed_digits=min(confirmed(a, b) for a, b in zip(coarse, fine))))
    return out


def main():
    options = arguments("The running mean of a decaying exponential.")
    start = time.time()
    rows = rows_of(POINTS[::4] if options.reduced else POINTS)
    if options.self_check:
        finish([f"z = {r['argument']}: only {r['confirmed_digits']} digits" for r in rows if r["confirmed_digits"] < 18],
               start, "self-check")
    if options.check:
        finish(differences(NAME, read(NAME), rows, ["argument"]), start, f"check of {len(rows)} rows")
    write(NAME, COMMAND, "phi(z) = (1 - e^-z)/z, 1 - phi and phi - e^-z", COLUMNS, rows)
    print(f"written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
