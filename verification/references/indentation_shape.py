"""The line profile of a shape given by points; writes or checks indentation_shape.csv.

    z(r)    piecewise cubic through the points; slopes m_i from: second derivatives equal on both sides of every inner point; third derivatives
            equal at the last inner point; on the axis m_0 = 0, or third derivatives equal at the first inner point for a sharp tip
            (ln(z_2/z_1)/ln(r_2/r_1) <= 3/2); then each m_i is cut to the range of the secants beside it
            (inner points), to 0 or more (ends), and to 3 times the smaller secant
    f(s)    s int_0^s z'(r)/sqrt(s^2 - r^2) dr, and f'(s)

Method: conditions written on second and third derivatives, dense linear system; integrals in closed form, piece by piece (arcsine and root), at
60 digits; f' by differentiating the closed form of each piece. Confirmed by Gauss panels in theta, r = s sin(theta), at 42 digits.
"""

import sys

sys.dont_write_bytecode = True

import time

from mpmath import mp, mpf

from common import COARSE, FINE, arguments, confirmed, differences, double, exact, finish, number, panels, read, write

NAME = "indentation_shape.csv"
COMMAND = "python3 verification/references/indentation_shape.py"
COLUMNS = ["case", "points", "place", "line", "line_slope", "confirmed_digits"]

CASES = {
    # 1 - sqrt(1 - r^2), rounded: only the points count
    "sphere": [(r / 10, 1 - (1 - (r / 10) ** 2) ** 0.5) for r in range(0, 9)],
    "uneven": [(0, 0), (0.05, 0.0012), (0.3, 0.046), (0.31, 0.049), (0.6, 0.185), (1.4, 1.02), (1.5, 1.17)],
    "sharp_tip": [(0, 0), (1e-6, 2e-7), (2e-6, 4.3e-7), (4e-6, 1.1e-6), (7e-6, 2.9e-6)],
    # a flat with a shoulder, where slopes are cut
    "worn": [(0, 0), (1, 1e-3), (2, 4e-3), (3, 1e-2), (4, 0.04), (5, 0.15), (6, 0.5), (7, 1.1), (8, 1.9)],
}


def slopes(r, z):
    n = len(r)
    h = [r[i + 1] - r[i] for i in range(n - 1)]
    d = [(z[i + 1] - z[i]) / h[i] for i in range(n - 1)]
    a, b = mp.zeros(n), mp.zeros(n, 1)

    def third(row, i, sign):
        # z''' = 6 (m_i + m_{i+1} - 2 d_i)/h_i^2
        a[row, i] += sign * 6 / h[i] ** 2
        a[row, i + 1] += sign * 6 / h[i] ** 2
        b[row] += sign * 12 * d[i] / h[i] ** 2

    if mp.log(z[2] / z[1]) / mp.log(r[2] / r[1]) > mpf(3) / 2:
        a[0, 0] = 1
    else:
        third(0, 0, 1)
        third(0, 1, -1)
    for i in range(1, n - 1):
        # at the right end z'' = (2 m_{i-1} + 4 m_i - 6 d_{i-1})/h, at the left end z'' = (6 d_i - 4 m_i - 2 m_{i+1})/h
        a[i, i - 1] += 2 / h[i - 1]
        a[i, i] += 4 / h[i - 1] + 4 / h[i]
        a[i, i + 1] += 2 / h[i]
        b[i] = 6 * d[i - 1] / h[i - 1] + 6 * d[i] / h[i]
    third(n - 1, n - 3, 1)
    third(n - 1, n - 2, -1)
    m = mp.lu_solve(a, b)
    cut = []
    for i in range(n):
        beside = (d[max(i - 1, 0)], d[min(i, n - 2)])
        slope = max(m[i], mpf(0)) if i in (0, n - 1) else min(max(m[i], min(beside)), max(beside))
        cut.append(min(slope, 3 * min(beside)))
    return cut


def cubics(points):
    r, z = [exact(p[0]) for p in points], [exact(p[1]) for p in points]
    m = slopes(r, z)
    out = []
    for i in range(len(r) - 1):
        h, d = r[i + 1] - r[i], (z[i + 1] - z[i]) / (r[i + 1] - r[i])
        c0, c1, c2 = m[i], 2 * (3 * d - 2 * m[i] - m[i + 1]) / h, 3 * (m[i] + m[i + 1] - 2 * d) / h ** 2
        # z' in powers of r
        p = r[i]
        out.append((r[i], r[i + 1], (c0 - c1 * p + c2 * p * p, c1 - 2 * c2 * p, c2)))
    return out


def closed(pieces, s):
    line, slope = mpf(0), mpf(0)
    for low, high, (a, b, c) in pieces:
        if low >= s:
            break
        q = min(high, s)
        angle = mp.asin(q / s) - mp.asin(low / s)
        roots = mp.sqrt(s * s - q * q) - mp.sqrt(s * s - low * low)
        moment = q * mp.sqrt(s * s - q * q) - low * mp.sqrt(s * s - low * low)
        zero, one, two = angle, -roots, (s * s * angle - moment) / 2
        line += s * (a * zero + b * one + c * two)
        # f' = int (z' + r z'')/root
        slope += a * zero + 2 * b * one + 3 * c * two
    return line, slope


def quadrature(pieces, s):
    line, slope = mpf(0), mpf(0)
    for low, high, (a, b, c) in pieces:
        if low >= s:
            break
        q = min(high, s)
        first, last = mp.asin(low / s), mp.asin(q / s)
        breaks = [first + (last - first) * k / 4 for k in range(5)]
        line += s * panels(COARSE, lambda t: a + s * mp.sin(t) * (b + s * mp.sin(t) * c), breaks)
        slope += panels(COARSE, lambda t: a + s * mp.sin(t) * (2 * b + s * mp.sin(t) * 3 * c), breaks)
    return line, slope


def rows_of(cases):
    out = []
    for case, points in cases.items():
        points = [(float(r), float(z)) for r, z in points]
        end = points[-1][0]
        places = sorted({end * k / 16 for k in range(1, 17)} | {p[0] for p in points[1:]} | {p[0] * (1 + 1e-6) for p in points[1:-1]})
        for place in places:
            with mp.workdps(FINE.dps):
                fine = closed(cubics(points), exact(place))
            with mp.workdps(COARSE.dps):
                coarse = quadrature(cubics(points), exact(place))
            with mp.workdps(FINE.dps):
                digits = min(confirmed(x, y) for x, y in zip(coarse, fine))
                out.append(dict(case=case, points=";".join(f"{double(r)},{double(z)}" for r, z in points), place=double(place),
                                line=number(fine[0]), line_slope=number(fine[1]), confirmed_digits=digits))
    return out


def main():
    options = arguments("The line profile of a shape given by points.")
    start = time.time()
    rows = rows_of({"uneven": CASES["uneven"]} if options.reduced else CASES)
    if options.self_check:
        finish([f"{r['case']} at {r['place']}: only {r['confirmed_digits']} digits" for r in rows if r["confirmed_digits"] < 20],
               start, "self-check")
    if options.check:
        finish(differences(NAME, read(NAME), rows, ["case", "place"]), start, f"check of {len(rows)} rows")
    write(NAME, COMMAND, "line profiles of shapes given by points", COLUMNS, rows)
    print(f"written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
