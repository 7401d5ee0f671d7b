"""Points that no file holds: references computed on the spot, from definitions, at places drawn by a fixed seed.

Tolerances are those of the groups: 1e-13 for special functions, 1e-12 for cracks, 1e-6 for sliding, 1e-4 for the sphere.
"""

import random
import sys

import pytest

import tools

sys.path.insert(0, tools.REFERENCES)


@pytest.fixture
def draw():
    return random.Random(20240611)


def decade(draw, low, high):
    return 10.0 ** draw.uniform(low, high)


def test_special_functions_by_definition(harness, need, draw):
    mpmath = need("mpmath")
    mp = mpmath.mp
    with mp.workdps(40):
        for _ in range(30):
            y, z, x = decade(draw, -3, 2), decade(draw, -6, 3), draw.uniform(0.01, 6.27)
            k = 1.0 - decade(draw, -14, -0.2)
            cases = [
                ("dawson", y, mp.sqrt(mp.pi) / 2 * mp.exp(-mp.mpf(y) ** 2) * mp.erfi(mp.mpf(y))),
                ("exponential_mean_complement", z, 1 - (1 - mp.exp(-mp.mpf(z))) / mp.mpf(z)),
                ("clausen", x, mp.clsin(2, mp.mpf(x))),
                ("elliptic_k_of_modulus", k, mp.ellipk(mp.mpf(k) ** 2)),
                ("elliptic_e_of_modulus", k, mp.ellipe(mp.mpf(k) ** 2)),
            ]
            for name, argument, expected in cases:
                value = harness.special(name, argument)[0]
                scale = max(abs(expected), mp.mpf(1) / 100 if name == "clausen" else 0)
                assert abs(value - expected) <= 1e-13 * scale, (name, argument)


def test_functions_that_no_file_holds(harness, need, draw):
    mp = need("mpmath").mp
    with mp.workdps(40):
        for _ in range(12):
            b, z, y = decade(draw, -3, 3), decade(draw, 0.0, 2.5), decade(draw, 0.0, 1.5)
            n, s = draw.randrange(1, 40), draw.randrange(2, 12)
            harmonic = mp.re(mp.digamma(1 + 1j * mp.mpf(b))) + mp.euler
            # W of int e^-t log|z + t| dt = log|z| + W(z), by its definition on both sides of the zero.
            behind = mp.quad(lambda t: mp.exp(-t) / (z + t), [0, 1, 10, mp.inf])
            ahead = mp.quad(lambda t: mp.exp(-t) * mp.log(abs(t - y)), [0, y, y + 1, y + 10, mp.inf]) - mp.log(y)
            tail = mp.zeta(s, n + 1)
            assert abs(harness.special("harmonic_on_imaginary_axis", b)[0] / harmonic - 1) < 1e-13, b
            assert abs(harness.special("memory_of_logarithm", z)[0] / behind - 1) < 1e-13, z
            assert abs(harness.special("memory_of_logarithm", -y)[0] - ahead) < 1e-13, y
            assert abs(harness.zeta_tail(s, n) / tail - 1) < 1e-13, (s, n)
            moments = harness.fading_moments(b)[0]
            for k in range(4):
                expected = mp.quad(lambda v: mp.exp(-b * v) * v ** k, [0, min(1.0, 5.0 / b), 1]) if b < 50 else mp.gammainc(k + 1, 0, b) / mp.mpf(b) ** (k + 1)
                assert abs(moments[k] / expected - 1) < 1e-13, (b, k)


def test_layer_factors_as_printed(harness, need, draw):
    mp = need("mpmath").mp
    with mp.workdps(80):
        for _ in range(20):
            nu, q = draw.uniform(-0.5, 0.5), decade(draw, -3, 1.5)
            n, k = mp.mpf(nu), mp.mpf(q)
            kappa = 3 - 4 * n
            # Thesis Sec 2.2.2: the compliance of a confined layer over that of a half-plane.
            confined = (kappa * mp.sinh(2 * k) - 2 * k) / (5 - 12 * n + 8 * n * n + 2 * k * k + kappa * mp.cosh(2 * k))
            free = (mp.sinh(2 * k) + 2 * k) / (mp.cosh(2 * k) - 1 - 2 * k * k)
            for backing, expected in (("confined", confined), ("free", free)):
                found = harness.layer_factors(backing, nu, q, 1.0)[1][0]
                assert abs(found / expected - 1) <= 1e-13, (backing, nu, q)


def test_opening_and_closing_work_by_nested_quadrature(harness, need, draw):
    need("mpmath")
    import raw_crack_work
    from common import COARSE, exact
    from materials import MATERIALS
    from mpmath import mp

    for name in ("creep_3_beta100", "relaxation_3_beta100"):
        solid = MATERIALS[name]
        strengths, times = [float(s) for s, _ in solid.series], [float(t) for _, t in solid.series]
        for _ in range(2):
            time = decade(draw, -1.0, 1.0) * times[0]
            with mp.workdps(COARSE.dps):
                if solid.kind == "creep":
                    material = harness.Material.from_creep(float(1 / solid.instant_compliance()), strengths, times)
                    raw, value = raw_crack_work.opening_work(COARSE, solid, exact(time)), material.mean_creep(time)[0]
                else:
                    material = harness.Material.from_relaxation(float(solid.relaxed_modulus()), strengths, times)
                    raw, value = raw_crack_work.closing_work(COARSE, solid, exact(time)), material.mean_relaxation(time)[0]
                assert abs(value / (2 * raw) - 1) <= 1e-12, (name, time)


def test_sliding_contacts_by_collocation(harness, need, draw):
    need("mpmath")
    import sliding_wave
    import sliding

    for _ in range(3):
        beta, ratio = draw.uniform(3.0, 8.0), draw.uniform(0.3, 2.0)
        terms = sliding_wave.spectrum(beta, [ratio])
        a, e, mean = draw.uniform(0.7, 1.6), draw.uniform(-0.15, 0.15), draw.uniform(0.05, 0.4)
        expected = sliding_wave.given_values(terms, a, e, mean, 64, 10)
        solid = sliding.material(harness, " ".join(f"{j!r}:{z!r}" for j, z in terms))
        found = harness.SlidingContact(solid, sliding.RATE, a, e, "mean_pressure", mean).totals()
        for quantity in ("penetration", "friction_stress", "interface_work", "trailing_amplitude", "leading_amplitude"):
            value, scale = expected[quantity, ""]
            assert abs(found[quantity] - value) <= 1e-6 * scale, (quantity, terms, a, e, mean)


def test_spheres_by_dense_annuli(harness, need, draw):
    need("numpy")
    need("scipy")
    import sphere
    import sphere_annuli as annuli

    for start in ("relaxed", "untouched"):
        unit = 0.004
        radii = [unit * draw.randrange(30, 60) for _ in range(3)]
        path = [(radii[0], 0.03, 0.0)] + [(radius, draw.uniform(0.0, 0.04), decade(draw, -1.5, 1.0)) for radius in radii[1:]]
        solid = (12.0, ((0.4, decade(draw, -1.0, 1.0)), (0.2, decade(draw, -1.0, 1.0))))
        case = ("drawn", solid, "paraboloid", 1.0, start, path, 0.024)
        row = {"kind": "prescribed", "case": "drawn"}
        table = [dict(row, **{key: str(value) for key, value in part.items()}) for part in annuli.prescribed_rows([case], 4)]
        for value in sphere.prescribed(harness, "drawn", "drawn", table):
            assert value.error <= 1e-4, value
