"""A shear series with a bulk modulus: complex moduli, relaxation, and the force on a sphere; writes or checks isotropic_solid.csv.

Method: no poles, no residues, no terms of the results. Young's and the plane modulus are the rational functions
    E(s) = 9 K G/(3 K + G),   E*(s) = 4 G (3 K + G)/(3 K + 4 G),   G(s) = G0 + sum g s/(s + 1/rho), K(s) likewise,
evaluated at s = i w. Relaxation functions and forces are inverse Laplace transforms by Talbot's contour, at two degrees.
    R(t) from E(s)/s
    F(t) of a rigid sphere of radius R pressed in at the speed v (Lee and Radok 1960): the transform is
         (4/3) sqrt(R) v^(3/2) Gamma(5/2) E*(s)/s^(5/2),   as F = (4/3) sqrt(R) E* d^(3/2) of an elastic half-space

Solids named deck_... are those of tests/inputs/deck-*, whose numbers were put into SI units by hand here.

Columns: solid, role (input, check), key, index, argument, value, confirmed_digits.
"""

import sys

sys.dont_write_bytecode = True

import time as clock

from mpmath import mp, mpf

from common import DIGITS, arguments, confirmed, differences, double, exact, finish, number, read, write

NAME = "isotropic_solid.csv"
COMMAND = "python3 verification/references/isotropic_solid.py"
WORKING = {"coarse": (60, 70), "fine": (80, 100)}

RADIUS, DEPTH, DURATION = 1e-3, 1e-5, 1.0


def prony(glassy, fractions):
    """(long-term modulus, [(modulus, time)]) of an instantaneous modulus and fractions of it."""
    left = 1 - mp.fsum(exact_decimal(g) for g, _ in fractions)
    return glassy * left, [(glassy * exact_decimal(g), t) for g, t in fractions]


def exact_decimal(text):
    return mpf(str(text))


def by_youngs(youngs, ratio, moduli, shear, bulk):
    """Shear and bulk series of Young's modulus and Poisson's ratio, with fractions of the instantaneous moduli."""
    youngs, ratio = exact_decimal(youngs), exact_decimal(ratio)
    out = []
    for modulus, terms in ((youngs / (2 * (1 + ratio)), shear), (youngs / (3 * (1 - 2 * ratio)), bulk)):
        if moduli == "long_term":
            modulus = modulus / (1 - mp.fsum(exact_decimal(g) for g, _ in terms))
        out.append(prony(modulus, terms))
    return out


def solids():
    """name: (shear, bulk); each (long-term modulus, [(modulus, time)]), or a number for a constant bulk modulus."""
    d = exact_decimal
    psi = d("6894.757293168361")
    return {
        "constant_bulk_2": ((d("0.31e6"), [(d("0.7e6"), "0.02"), (d("1.9e6"), "3.7")]), (d("2.3e6"), [])),
        "nearly_incompressible_3": ((d("0.21e6"), [(d("0.4e6"), "1e-3"), (d("0.9e6"), "0.3"), (d("0.2e6"), "40")]), (d("2.1e9"), [])),
        "bulk_series": ((d("11e6"), [(d("70e6"), "0.01"), (d("30e6"), "1.3")]), (d("90e6"), [(d("25e6"), "0.01"), (d("60e6"), "0.4")])),
        "liquid_in_shear": ((d(0), [(d("3e6"), "0.05"), (d("1e6"), "2")]), (d("40e6"), [])),
        "soft_bulk": ((d("5e6"), [(d("45e6"), "0.2")]), (d("3e6"), [])),
        "deck_abaqus_long_term": by_youngs("3e6", "0.49", "long_term", [("0.3", "0.1"), ("0.4", "10")], []),
        "deck_abaqus_instantaneous": by_youngs("1e9", "0.35", "instantaneous", [("0.2", "0.05"), ("0.3", "5")], [("0.1", "0.05"), ("0.15", "5")]),
        "deck_abaqus_default_moduli": by_youngs("12e6", "0.45", "long_term", [("0.25", "0.5")], []),
        "deck_abaqus_two_materials": by_youngs("2e6", "0.4", "instantaneous", [("0.6", "0.2")], []),
        "deck_abaqus_trs": by_youngs("5e6", "0.48", "instantaneous", [("0.5", slower("1", "8.86", "101.6", "15")), ("0.2", slower("20", "8.86", "101.6", "15"))], []),
        "deck_abaqus_alike": by_youngs("40e6", "0.3", "instantaneous", [("0.4", "2")], [("0.4", "2")]),
        "deck_abaqus_psi_minutes": by_youngs(450 * psi, "0.495", "long_term", [("0.2", "6"), ("0.1", "120")], []),
        "deck_ansys_shear": by_youngs("2700e6", "0.37", "instantaneous", [("0.3", "0.01"), ("0.2", "1"), ("0.1", "100")], []),
        "deck_ansys_shear_bulk": ([*prony(d("1.2e6"), [("0.35", "0.02"), ("0.25", "0.7")])], [*prony(d("1.2e6") * 2 * d("1.42") / (3 * (1 - 2 * d("0.42"))), [("0.15", "0.3")])]),
        "deck_dyna_076": ((d("0.25e6"), [(d("0.8e6"), "0.05"), (d("0.35e6"), "2")]), (d("1500e6"), [])),
        "deck_dyna_076_free": ((d("2e6"), [(d("6e6"), "0.02"), (d("3e6"), "0.5")]), (d("60e6"), [(d("20e6"), "0.02")])),
        "deck_dyna_006": ((d("0.4e9"), [(d("0.9e9"), "0.125")]), (d("3.2e9"), [])),
        "deck_comsol_parameters": ([d("3e6") / (2 * d("1.45")), [(d("0.9e6"), "0.03"), (d("0.5e6"), "4")]], [d("3e6") / (3 * (1 - 2 * d("0.45"))), []]),
        "deck_comsol_rows": ((d("0.6e9"), [(d("0.3e9"), "0.002"), (d("0.2e9"), "0.15"), (d("0.1e9"), "9")]), (d("2.5e9"), [])),
        "deck_comsol_instantaneous": ((d("0.5e6"), [(d("0.5e6"), "0.25")]), (d("4e6"), [])),
        "deck_moose": by_youngs("10e9", "0.2", "instantaneous", [("0.3", "1"), ("0.25", "10")], [("0.3", "1"), ("0.25", "10")]),
        "deck_moose_ratios": stiffness_ratios("10e9", "0.2", [("3e9", "0.25", "1"), ("2e9", "0.1", "10")]),
        "deck_keys_decay_rates": ((d("1.5e6") * d("0.4"), [(d("1.5e6") * d("0.35"), "0.05"), (d("1.5e6") * d("0.25"), "0.8")]), (d("9e6"), [])),
        "deck_keys_times_ulps_apart": ((d("1e6"), [(d("6e6"), "0.7"), (d("2e6"), "0.02")]), (d("5e6"), [])),
    }


def slower(time, c1, c2, above):
    """A time at `above` kelvin over the reference temperature, by Williams, Landel and Ferry."""
    c1, c2, above = (exact_decimal(x) for x in (c1, c2, above))
    return exact_decimal(time) * mpf(10) ** (-c1 * above / (c2 + above))


def stiffness_ratios(youngs, ratio, parts):
    """Instantaneous stiffness less the parts that relax, each by Young's modulus and Poisson's ratio."""
    shear = lambda e, n: exact_decimal(e) / (2 * (1 + exact_decimal(n)))
    bulk = lambda e, n: exact_decimal(e) / (3 * (1 - 2 * exact_decimal(n)))
    out = []
    for of in (shear, bulk):
        terms = [(of(e, n), t) for e, n, t in parts]
        out.append((of(youngs, ratio) - mp.fsum(g for g, _ in terms), terms))
    return out


def modulus(series, s):
    relaxed, terms = series
    return relaxed + mp.fsum(g * s * exact_decimal(t) / (1 + s * exact_decimal(t)) for g, t in terms)


def youngs(solid, s):
    g, k = modulus(solid[0], s), modulus(solid[1], s)
    return 9 * k * g / (3 * k + g)


def plane(solid, s):
    g, k = modulus(solid[0], s), modulus(solid[1], s)
    return 4 * g * (3 * k + g) / (3 * k + 4 * g)


def force(solid, t, degree):
    speed = exact_decimal(DEPTH) / exact_decimal(DURATION)
    factor = mpf(4) / 3 * mp.sqrt(exact_decimal(RADIUS)) * speed ** mpf("1.5") * mp.gamma(mpf("2.5"))
    return mp.invertlaplace(lambda s: factor * plane(solid, s) / s ** mpf("2.5"), t, method="talbot", degree=degree)


def rows_at(name, digits, degree):
    with mp.workdps(digits):
        solid = solids()[name]
        out = []
        for kind, series in (("shear", solid[0]), ("bulk", solid[1])):
            out.append(("input", f"{kind}_relaxed", "", "", series[0]))
            for index, (g, t) in enumerate(series[1]):
                out.append(("input", f"{kind}_strength", index, "", g))
                out.append(("input", f"{kind}_time", index, "", exact_decimal(t)))
        for w in ("1e-3", "0.02", "0.5", "3", "70", "4e3"):
            s = mp.mpc(0, exact_decimal(w))
            for key, function in (("youngs", youngs), ("plane", plane)):
                value = function(solid, s)
                out.append(("check", f"{key}_storage", "", w, value.real))
                out.append(("check", f"{key}_loss", "", w, value.imag))
        for t in ("0.01", "0.3", "6"):
            for key, function in (("youngs", youngs), ("plane", plane)):
                value = mp.invertlaplace(lambda s: function(solid, s) / s, exact_decimal(t), method="talbot", degree=degree)
                out.append(("check", f"{key}_relaxation", "", t, value))
        for t in ("0.5", "1"):
            out.append(("check", "force", "", t, force(solid, exact_decimal(t), degree)))
        return [row[:4] + (+row[4],) for row in out]


def rows_of(name):
    coarse, fine = (rows_at(name, *WORKING[key]) for key in ("coarse", "fine"))
    rows = []
    with mp.workdps(WORKING["fine"][0]):
        for (*_, rough), (role, key, index, argument, value) in zip(coarse, fine):
            rows.append(dict(solid=name, role=role, key=key, index=index, argument=argument and double(argument),
                             value=number(value), confirmed_digits=confirmed(rough, value)))
    return rows


COLUMNS = ["solid", "role", "key", "index", "argument", "value", "confirmed_digits"]


def self_check():
    """The force of an elastic solid is Hertz's; a constant Poisson ratio gives 2 G/(1 - nu)."""
    wrong = []
    with mp.workdps(60):
        elastic = (mpf(10) ** 6, []), (mpf(5) * 10 ** 6, [])
        hertz = mpf(4) / 3 * plane(elastic, 1) * mp.sqrt(exact_decimal(RADIUS)) * exact_decimal(DEPTH) ** mpf("1.5")
        if abs(force(elastic, mpf(1), 70) / hertz - 1) > mpf("1e-25"):
            wrong.append("an elastic solid does not give Hertz's force")
        alike, s = solids()["deck_abaqus_alike"], mp.mpc(0, 1)
        if abs(plane(alike, s) / (2 * modulus(alike[0], s) / (1 - mpf("0.3"))) - 1) > mpf("1e-40"):
            wrong.append("a constant Poisson ratio does not give 2 G/(1 - nu)")
    return wrong


def main():
    options = arguments("A shear series with a bulk modulus.")
    start = clock.time()
    if options.self_check:
        finish(self_check(), start, "self-check")
    with mp.workdps(WORKING["fine"][0]):
        names = list(solids())
    rows = [row for name in (names[:4] if options.reduced else names) for row in rows_of(name)]
    if options.check:
        stored = read(NAME)
        wrong = differences(NAME, stored, rows, ["solid", "role", "key", "index", "argument"])
        if not options.reduced and len(stored) != len(rows):
            wrong.append(f"{NAME}: {len(stored)} rows in the file, {len(rows)} computed")
        finish(wrong, start, f"check of {len(rows)} rows")
    write(NAME, COMMAND, "a shear series with a bulk modulus: Young's and the plane modulus, force on a sphere", COLUMNS, rows,
          precision=f"Talbot's contour of degree {WORKING['fine'][1]}, confirmed against {WORKING['coarse'][1]}; {DIGITS} digits printed")
    print(f"written in {clock.time() - start:.1f} s")


if __name__ == "__main__":
    main()
