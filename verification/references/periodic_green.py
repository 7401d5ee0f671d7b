"""The steady periodic Green's function and the factors of a layer; writes or checks layer_factors.csv and green.csv.

layer_factors.csv: backing, poisson_ratio, product (q = m k d, exact double), correction A, compliance_factor S = 1 - A, both from the hyperbolic
forms as the thesis prints them below (2.15), with 80 + 2q digits; confirmed with 30 more.

green.csv: the kernel of -displacement in the groups of the solver,
    G(x) = -(1/pi) Re sum_{m>=1} (1 - A_m) C_m e^{imx}/m,     C_m = 1/beta + sum_j j_j/(1 - i m zeta_j)
    integral of G from 0 to x, the same sum divided by i m, less its value at 0.
by direct summation of the Fourier series, the tail of the half-plane part (A = 0) summed by parts,
    sum_{m>=M} a_m z^m = z^M/(1 - z) sum_k (z/(1 - z))^k Delta^k a_M,
no Clausen function and no memory integral. Confirmed by twice as many direct terms at other precision.
    backing          half_plane, confined, free            thickness      k d (blank for half_plane)
    glassy_compliance  1/beta       compliances, ratios    j_j and zeta_j, separated by blanks; all exact doubles
"""

import sys

sys.dont_write_bytecode = True

import time

from mpmath import mp, mpf

from common import arguments, confirmed, differences, exact, finish, number, read, write

COMMAND = "python3 verification/references/periodic_green.py"
FACTORS, GREEN = "layer_factors.csv", "green.csv"
FACTOR_COLUMNS = ["backing", "poisson_ratio", "product", "correction", "compliance_factor", "confirmed_digits"]
GREEN_COLUMNS = ["backing", "poisson_ratio", "thickness", "glassy_compliance", "compliances", "ratios", "position", "value",
                 "antiderivative", "confirmed_digits"]

PRODUCTS = [1e-12, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.9999999, 1.0, 1.0000001, 1.1, 1.5, 2.0, 3.0, 5.0, 8.0,
            12.0, 18.0, 20.0, 25.0, 30.0, 50.0, 100.0, 178.0, 200.0, 300.0, 340.0]
POISSON = [-0.9, 0.0, 0.3, 0.49, 0.4999999, 0.5]

SOLIDS = [
    (0.1, [0.9], [1e-6]), (0.1, [0.9], [0.01]), (0.1, [0.9], [0.3]), (0.1, [0.9], [1.0]), (0.1, [0.9], [10.0]), (0.1, [0.9], [1e4]),
    (0.001, [0.999], [0.08]), (0.5, [0.5], [-0.7]), (1.0, [], []),
    (0.0625, [0.25, 0.4375, 0.25], [1e3, 0.9, 0.004]),
]
POSITIONS = [0.01, 0.4, 1.0471975511965976, 2.2, 3.141592653589793, 4.0, 6.0, -0.003]
LAYERS = [("confined", 0.5, 1.0), ("confined", 0.3, 0.1), ("free", 0.0, 0.5), ("free", 0.3, 5.0), ("confined", 0.5, 0.01), ("free", 0.5, 0.03)]
CASES = [("half_plane", 0.0, 0.0, s, x) for s in SOLIDS for x in POSITIONS]
CASES += [(b, nu, d, s, x) for b, nu, d in LAYERS for s in (SOLIDS[2], SOLIDS[9]) for x in POSITIONS[::2]]


def printed(backing, nu, q):
    """A_m as the thesis prints it."""
    nu = exact(nu)
    if backing == "confined":
        return (2 * q - (3 - 4 * nu) * mp.sinh(2 * q)) / (5 + 2 * q * q - 4 * nu * (3 - 2 * nu) + (3 - 4 * nu) * mp.cosh(2 * q)) + 1
    return (2 * q + mp.sinh(2 * q)) / (1 + 2 * q * q - mp.cosh(2 * q)) + 1


def factor_rows(products):
    out = []
    for backing, nus in (("confined", POISSON), ("free", [0.3])):
        for nu in nus:
            for q in products:
                digits = 80 + int(2 * q)
                with mp.workdps(digits):
                    a = printed(backing, nu, exact(q))
                with mp.workdps(digits + 30):
                    b = printed(backing, nu, exact(q))
                    out.append(dict(backing=backing, poisson_ratio=repr(nu), product=repr(q), correction=number(b),
                                    compliance_factor=number(1 - b), confirmed_digits=min(confirmed(a, b), confirmed(1 - a, 1 - b))))
    return out


def fourier(case, digits, factor):
    backing, nu, thickness, (glassy, compliances, ratios), position = case
    with mp.workdps(digits):
        x = exact(position)
        j, zeta = [exact(v) for v in compliances], [exact(v) for v in ratios]
        z = mp.expj(x)

        def compliance(m):
            return exact(glassy) + mp.fsum(a / (1 - 1j * m * b) for a, b in zip(j, zeta))

        count = factor * (int(120 / abs(1 - z)) + 200)
        sums = [mp.mpc(0), mp.mpc(0)]
        power = mp.mpc(1)
        for m in range(1, count):
            power *= z
            term = compliance(m) / m
            sums[0] += term * power
            sums[1] += term / m * (power - 1)
        power *= z
        # The tails, by parts; the differences cancel k log10(count) digits. At x = 0 the second sum converges as 1/m^2: Euler-Maclaurin.
        order = 60
        with mp.workdps(digits + int(order * mp.log10(count)) + 20):
            z2 = mp.expj(x)
            ratio = z2 / (1 - z2)
            for which in (0, 1):
                row = [compliance(mpf(count + k)) / mpf(count + k) ** (1 + which) for k in range(order + 1)]
                tail, weight = mp.mpc(0), mp.mpc(1)
                while row:
                    tail += weight * row[0]
                    weight *= ratio
                    row = [b - a for a, b in zip(row[:-1], row[1:])]
                sums[which] += power * tail / (1 - z2)
        # sum_{m>=count} C_m/m^2: partial fractions, 1/(m^2 (1 - i m zeta)) = 1/m^2 + i zeta [1/m - 1/(m + i/zeta)].
        rest = mp.zeta(2, count) * (exact(glassy) + mp.fsum(j))
        for a, b in zip(j, zeta):
            rest += a * 1j * b * (mp.digamma(count + 1j / b) - mp.digamma(count))
        sums[1] -= rest
        if backing != "half_plane":
            m, d = 1, exact(thickness)
            while m * d < 85:
                with mp.workdps(digits + 40):
                    factor_m = printed(backing, nu, m * d)
                term = factor_m * compliance(m) / m
                power = mp.expj(m * x)
                sums[0] -= term * power
                sums[1] -= term / m * (power - 1)
                m += 1
        return -mp.re(sums[0]) / mp.pi, -mp.im(sums[1]) / mp.pi


def green_rows(cases):
    out = []
    for case in cases:
        coarse, fine = fourier(case, 40, 1), fourier(case, 56, 2)
        backing, nu, thickness, (glassy, compliances, ratios), position = case
        layer = backing != "half_plane"
        out.append(dict(backing=backing, poisson_ratio=repr(nu) if layer else "", thickness=repr(thickness) if layer else "",
                        glassy_compliance=repr(glassy), compliances=" ".join(map(repr, compliances)), ratios=" ".join(map(repr, ratios)),
                        position=repr(position), value=number(fine[0]), antiderivative=number(fine[1]),
                        confirmed_digits=min(confirmed(a, b) for a, b in zip(coarse, fine))))
    return out


def main():
    options = arguments("Periodic Green's functions and layer factors.")
    start = time.time()
    factors = factor_rows(PRODUCTS[::6] if options.reduced else PRODUCTS)
    green = green_rows([c for c in CASES[::9] if abs(c[4]) > 0.1] if options.reduced else CASES)
    if options.self_check:
        finish([f"{r}: only {r['confirmed_digits']} digits" for r in factors + green if r["confirmed_digits"] < 18], start, "self-check")
    if options.check:
        wrong = differences(FACTORS, read(FACTORS), factors, ["backing", "poisson_ratio", "product"])
        wrong += differences(GREEN, read(GREEN), green, ["backing", "poisson_ratio", "thickness", "glassy_compliance", "ratios", "position"])
        finish(wrong, start, f"check of {len(factors) + len(green)} rows")
    write(FACTORS, COMMAND, "compliance factors of a layer against a half-plane", FACTOR_COLUMNS, factors,
          precision="80 + 2q digits, confirmed with 30 more; 32 digits printed")
    write(GREEN, COMMAND, "periodic Green's function of half-planes and layers in steady sliding, by Fourier series", GREEN_COLUMNS, green,
          precision="56 digits, confirmed against 40 digits and half as many direct terms; 32 digits printed")
    print(f"fewest confirmed digits {min(r['confirmed_digits'] for r in factors + green)}, written in {time.time() - start:.1f} s")


if __name__ == "__main__":
    main()
