"""The kernels of a constant cohesive stress and their slopes; writes or checks cohesive_kernel.csv.

    L(z) = int_0^1 (1 - e^{-z(1-r)}) artanh(sqrt r) dr                      opening
    N(z) = int_0^1 (1 - e^{-z(1-r)}) r^{-1/2} dr                            closing, stress intensity
    M(z) = int_0^1 (1 - e^{-z(1-r)}) [2 r^{-1/2} - 2 artanh(sqrt r)] dr     closing, work

    column                     meaning
    argument                   z, an exact double
    opening, opening_slope     L and dL/d ln z
    intensity, ..._slope       N and dN/d ln z
    work, work_slope           M and dM/d ln z

Method: the three integrals and z (1-r) e^{-z(1-r)} in place of 1 - e^{...} for the slopes, by Gauss panels: sqrt(r) on
0 <= r <= 1/2, then 1 - r on panels growing by 4 from 1e-50. Confirmed by hypergeometric functions at other digits:
    L = 1 - 2F2(1, 1; 3/2, 2; -z),  N = 2 - 2 1F1(1; 3/2; -z),  M = 2N - 2L, slopes by their first-order equations.
"""

import sys

sys.dont_write_bytecode = True

import time

from mpmath import mp, mpf

from common import FINE, arguments, confirmed, differences, exact, finish, gauss, geometric, number, read, write

NAME = "cohesive_kernel.csv"
COMMAND = "python3 verification/references/cohesive_kernel.py"
COLUMNS = ["argument", "opening", "opening_slope", "intensity", "intensity_slope", "work", "work_slope", "confirmed_digits"]
POINTS = sorted([10.0 ** k for k in range(-12, 13)] + [1e-30, 3e-4, 9.9e-4, 1.1e-3, 0.03, 0.2, 0.5, 0.85, 0.9999999999999999,
                1.0000000000000002, 1.3, 1.8, 2.6, 3.7, 5.5, 8.0, 12.0, 17.0, 23.0, 31.0, 39.0, 42.24, 42.26, 45.0, 60.0,
                150.0, 700.0, 3.3e5, 1e20])


def nodes():
    half = mp.sqrt(mpf(1) / 2)
    rule = gauss(FINE)
    out = []
    for lower, upper in [(mpf(0), half / 2), (half / 2, half)]:
        for x, w in rule:
            q = lower + (upper - lower) * x
            out.append((q, 1 - q * q, 2 * q * (upper - lower) * w, mp.atanh(q)))
    breaks = [mpf(0)] + geometric(mpf("1e-50"), mpf(1) / 2, 4)
    for lower, upper in zip(breaks[:-1], breaks[1:]):
        for x, w in rule:
            t = lower + (upper - lower) * x
            q = mp.sqrt(1 - t)
            out.append((q, t, (upper - lower) * w, mp.log((1 + q) ** 2 / t) / 2))
    return out


def by_quadrature(z, table):
    sums = [mpf(0)] * 4
    for q, t, w, artanh in table:
        e = mp.exp(-z * t)
        for index, (memory, kernel) in enumerate([(-mp.expm1(-z * t), artanh), (z * t * e, artanh),
                                                  (-mp.expm1(-z * t), 1 / q), (z * t * e, 1 / q)]):
            sums[index] += w * memory * kernel
    opening, opening_slope, intensity, intensity_slope = sums
    return (opening, opening_slope, intensity, intensity_slope, 2 * intensity - 2 * opening,
            2 * intensity_slope - 2 * opening_slope)


def closed(z):
    extra = int(abs(mp.log10(z))) + 10
    with mp.workdps(50 + 2 * extra):
        rest = mp.hyp2f2(1, 1, mpf(3) / 2, 2, -z)               # 1 - L
        ratio = mp.hyp1f1(1, mpf(3) / 2, -z)                    # D(sqrt z)/sqrt z
        opening, intensity = 1 - rest, 2 - 2 * ratio
        opening_slope, intensity_slope = rest - ratio, ratio - (1 - 2 * z * ratio)
        return (opening, opening_slope, intensity, intensity_slope, 2 * intensity - 2 * opening,
                2 * intensity_slope - 2 * opening_slope)


def rows_of(points):
    with mp.workdps(FINE.dps):
        table = nodes()
        out = []
        for point in points:
            z = exact(point)
            fine, other = by_quadrature(z, table), closed(z)
            row = dict(zip(COLUMNS[1:-1], map(number, fine)))
            out.append(dict(row, argument=repr(point), confirmed_digits=min(confirmed(a, b) for a, b in zip(other, fine))))
        return out


def main():
    options = arguments("Kernels of a constant cohesive stress.")
    start = time.time()
    rows = rows_of(POINTS[::4] if options.reduced else POINTS)
    if options.self_check:
        finish([f"z = {r['argument']}: only {r['confirmed_digits']} digits" for r in rows if r["confirmed_digits"] < 18],
               start, "self-check")
    if options.check:
        finish(differences(NAME, read(NAME), rows, ["argument"]), start, f"check of {len(rows)} rows")
    write(NAME, COMMAND, "memory kernels of a constant cohesive stress", COLUMNS, rows,
          precision=f"{FINE.dps} digits, {FINE.nodes} nodes a panel; confirmed by hypergeometric functions; 32 digits printed")
    print(f"written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
