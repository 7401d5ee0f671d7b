"""Creep series to relaxation series and back, to 50 digits; writes or checks material_conversion.csv.

Method: the complex compliance as a function of s = i w is rational; its poles are the retardation rates, its zeros the
relaxation rates, and they interlace. Each wanted rate is alone between two known poles (or beyond the last one) and is
found by bisection of the secular function in the logarithm of its distance to the nearer pole, at 120 digits, then
polished by Newton steps. Strengths are residues. No start value, no tolerance, no polynomial coefficients.

    symbol    meaning                                   symbol    meaning
    l, tau    retardation rate and time, l = 1/tau      J_j       creep strengths
    r, rho    relaxation rate and time, r = 1/rho       E_i       relaxation strengths
    E_inf     glassy modulus                            E_0       relaxed modulus (0: a fluid)
    eta       viscosity of steady flow, 1/eta = J'(inf)

    creep -> relaxation    zeros r of  1/E_inf + sum J_j l_j/(l_j - r) - 1/(eta r)
                           E_i = 1/(r_i [sum J_j l_j/(l_j - r_i)^2 + 1/(eta r_i^2)])
    relaxation -> creep    zeros l of  E_0 - sum E_i l/(r_i - l);  J_j = 1/(l_j sum E_i r_i/(r_i - l_j)^2)
                           a fluid: one zero is l = 0, the flow: 1/eta = 1/sum E_i/r_i

Independent of the roots: complex moduli come from the given series alone. `--self-check` shows that given and converted
series have the same complex modulus, that R(t) is the inverse Laplace transform of 1/(s^2 J(s)), that the polynomial
roots agree, and that converting back returns the input.

Columns: material, role (input, output, check), key, index, argument, value, confirmed_digits, independence, method.
"""

import sys

sys.dont_write_bytecode = True

import time as clock
from dataclasses import dataclass

from mpmath import mp, mpf

from common import DIGITS, arguments, confirmed, differences, double, exact, finish, number, read, write
from materials import MATERIALS, Material, short, spectrum

NAME = "material_conversion.csv"
COMMAND = "python3 verification/references/material_conversion.py"
WORKING = {"coarse": 70, "fine": 120}


def zeros(function, slope, poles, beyond):
    """The zero of `function` between each two neighbouring poles, and beyond the last one if `beyond`.

    `function(pole, shift)` and `slope(pole, shift)` take the rate as pole + shift, so that no digits are lost near a pole.
    """
    found = []
    intervals = list(zip(poles[:-1], poles[1:])) + ([(poles[-1], None)] if beyond else [])
    for lower, upper in intervals:
        if upper is None:
            width = poles[-1] if poles[-1] > 0 else mpf(1)
            base, sign, reach = lower, 1, width
            while mp.sign(function(base, reach)) == mp.sign(function(base, reach * mpf(10) ** -(mp.dps // 2))):
                reach *= 16
        else:
            middle = (upper - lower) / 2
            near_lower = mp.sign(function(lower, (upper - lower) * mpf(10) ** (-mp.dps // 2)))
            base, sign = (upper, -1) if mp.sign(function(lower, middle)) == near_lower else (lower, 1)
            reach = middle
        top, bottom = mp.log(reach), mp.log(reach) - mp.dps * mp.ln10
        side = mp.sign(function(base, sign * mp.exp(top)))
        for _ in range(60):
            centre = (top + bottom) / 2
            if mp.sign(function(base, sign * mp.exp(centre))) == side:
                top = centre
            else:
                bottom = centre
        shift = sign * mp.exp((top + bottom) / 2)
        for _ in range(12):
            step = function(base, shift) / slope(base, shift)
            shift -= step
            if abs(step) <= abs(shift) * mpf(10) ** (5 - mp.dps):
                break
        else:
            raise ArithmeticError("Newton polish did not settle")
        found.append((base, shift))
    return found


@dataclass(frozen=True)
class Converted:
    """The other series of a solid. Rates are kept as (pole, shift)."""
    modulus: object
    strengths: list
    times: list
    viscosity: object = mpf(0)

    def instant_compliance(self):
        return 1 / self.modulus


def to_relaxation(modulus, strengths, times, viscosity):
    """(E_0, [E_i], [rho_i]) of a creep series."""
    terms = sorted((1 / t, j) for j, t in zip(strengths, times))
    rates = [l for l, _ in terms]
    flow = 1 / viscosity if viscosity else mpf(0)

    def gaps(base, shift):
        return [(l, j, (l - base) - shift) for l, j in terms]

    def function(base, shift):
        return 1 / modulus + mp.fsum(j * l / d for l, j, d in gaps(base, shift)) - (flow / (base + shift) if flow else 0)

    def slope(base, shift):
        return (mp.fsum(j * l / d ** 2 for l, j, d in gaps(base, shift))
                + (flow / (base + shift) ** 2 if flow else 0))

    poles = ([mpf(0)] if flow else []) + rates
    pairs = zeros(function, slope, poles, beyond=True)
    out = [(1 / ((b + s) * slope(b, s)), 1 / (b + s)) for b, s in pairs]
    out.sort(key=lambda pair: pair[1])
    relaxed = mpf(0) if flow else 1 / (1 / modulus + mp.fsum(j for _, j in terms))
    return relaxed, [e for e, _ in out], [t for _, t in out]


def to_creep(modulus, strengths, times):
    """(E_inf, [J_j], [tau_j], eta) of a relaxation series."""
    terms = sorted((1 / t, e) for e, t in zip(strengths, times))
    rates = [r for r, _ in terms]

    def function(base, shift):  # divided by the rate: E_0/l - sum E_i/(r_i - l)
        rate = base + shift
        return (modulus / rate if modulus else 0) - mp.fsum(e / ((r - base) - shift) for r, e in terms)

    def slope(base, shift):
        rate = base + shift
        return -(modulus / rate ** 2 if modulus else 0) - mp.fsum(e / ((r - base) - shift) ** 2 for r, e in terms)

    poles = ([mpf(0)] if modulus else []) + rates
    pairs = zeros(function, slope, poles, beyond=False) if len(poles) > 1 else []
    out = [(1 / ((b + s) * mp.fsum(e * r / ((r - b) - s) ** 2 for r, e in terms)), 1 / (b + s)) for b, s in pairs]
    out.sort(key=lambda pair: pair[1])
    glassy = modulus + mp.fsum(e for _, e in terms)
    viscosity = mpf(0) if modulus else mp.fsum(e / r for r, e in terms)
    return glassy, [j for j, _ in out], [t for _, t in out], viscosity


def creep_twin(material, dps):
    """The creep series of a relaxation material, with the interface of a material."""
    with mp.workdps(dps + 20):
        glassy, strengths, times, viscosity = to_creep(material.relaxed_modulus(), material.strengths, material.times)
        return Converted(glassy, strengths, times, viscosity)


# ---------------------------------------------------------------- the solids

def _close_times(time):
    return time, short(time * 1.000001)


def _solids():
    named = ["creep_1_beta1e3", "creep_2_beta50", "creep_12_beta1e3", "creep_2_viscous", "creep_20_beta1e6",
             "relaxation_1_beta100", "relaxation_2_beta50", "relaxation_12_beta1e3", "relaxation_20_beta1e6"]
    solids = [MATERIALS[name] for name in named]
    first, second = 0.0123, 0.0123 * (1 + 1e-6)
    return solids + [
        Material("creep_40_beta1e4", "creep", 2.9e9, spectrum(40, 1.9e-7, 1.9e5, (1e4 - 1) / 2.9e9, 0.17)),
        Material("relaxation_40_beta1e4", "relaxation", 2.3e5, spectrum(40, 7.3e-8, 7.3e4, (1e4 - 1) * 2.3e5, -0.17)),
        Material("creep_3_nearly_equal", "creep", 6.1e8, ((2.3e-8, first), (3.1e-8, second), (5.7e-8, 1.7))),
        Material("relaxation_3_nearly_equal", "relaxation", 3.7e6, ((8.3e7, first), (4.9e7, second), (2.1e7, 1.7))),
        Material("relaxation_3_fluid", "relaxation", 0.0, ((6.7e8, 3.1e-4), (4.3e7, 0.029), (1.9e6, 2.3))),
        Material("relaxation_1_maxwell", "relaxation", 0.0, ((6.7e8, 3.1e-4),)),
    ]


# ---------------------------------------------------------------- responses

def creep_response(modulus, strengths, times, viscosity, t):
    return (1 / modulus - mp.fsum(j * mp.expm1(-t / tau) for j, tau in zip(strengths, times))
            + (t / viscosity if viscosity else 0))


def relaxation_response(modulus, strengths, times, t):
    return modulus + mp.fsum(e * mp.exp(-t / rho) for e, rho in zip(strengths, times))


def complex_modulus(material, frequency):
    """From the given series alone."""
    if material.kind == "relaxation":
        return exact(material.modulus) + mp.fsum(
            e * mp.mpc(0, frequency * t) / mp.mpc(1, frequency * t) for e, t in zip(material.strengths, material.times))
    compliance = 1 / exact(material.modulus) + mp.fsum(
        j / mp.mpc(1, frequency * t) for j, t in zip(material.strengths, material.times))
    if material.viscosity:
        compliance += 1 / mp.mpc(0, frequency * material.viscosity)
    return 1 / compliance


def both_series(material):
    """((E_inf, J, tau, eta), (E_0, E, rho)) at the current precision."""
    if material.kind == "creep":
        creep = exact(material.modulus), material.strengths, material.times, material.viscosity
        return creep, to_relaxation(*creep)
    relaxation = exact(material.modulus), material.strengths, material.times
    return to_creep(*relaxation), relaxation


def sample_points(material):
    """Times or frequencies over the spectrum, exact doubles."""
    fastest, slowest = (f(t for _, t in material.series) for f in (min, max))
    count = 3 if len(material.series) == 1 else 6
    low, high = fastest / 30, slowest * 30
    return [short(low * (high / low) ** (k / (count - 1))) for k in range(count)]


def outputs(material):
    """[(key, index, argument, value, independence, method)] at the current precision."""
    (glassy, creeps, retardations, viscosity), (relaxed, relaxations, relaxing) = both_series(material)
    out = []

    def add(role, key, value, index="", argument="", independence="independent", method="secular roots and residues"):
        out.append((role, key, index, argument, value, independence, method))

    if material.kind == "creep":
        add("output", "relaxed_modulus", relaxed, method="sum of the series")
        for i, (e, rho) in enumerate(zip(relaxations, relaxing)):
            add("output", "relaxation_strength", e, i)
            add("output", "relaxation_time", rho, i)
    else:
        add("output", "glassy_modulus", glassy, method="sum of the series")
        if viscosity:
            add("output", "flow_viscosity", viscosity, method="sum of the series")
        for j, (c, tau) in enumerate(zip(creeps, retardations)):
            add("output", "creep_strength", c, j)
            add("output", "retardation_time", tau, j)
    for point in sample_points(material):
        t = exact(point)
        add("check", "creep", creep_response(glassy, creeps, retardations, viscosity, t), argument=double(point),
            method="given series" if material.kind == "creep" else "converted series")
        add("check", "relaxation", relaxation_response(relaxed, relaxations, relaxing, t), argument=double(point),
            method="given series" if material.kind == "relaxation" else "converted series")
        frequency = double(1 / point)
        modulus = complex_modulus(material, exact(1 / point))
        add("check", "storage_modulus", modulus.real, argument=frequency, method="given series")
        add("check", "loss_modulus", modulus.imag, argument=frequency, method="given series")
    return out


def rows_of(material):
    results = []
    for name in ("coarse", "fine"):
        with mp.workdps(WORKING[name]):
            results.append(outputs(material))
    given = [dict(material=material.name, role="input", key=r["key"], index=r["index"], value=r["value"])
             for r in material.rows()]
    with mp.workdps(WORKING["fine"]):
        for coarse, fine in zip(*results):
            role, key, index, argument, value, independence, method = fine
            given.append(dict(material=material.name, role=role, key=key, index=index, argument=argument,
                              value=number(value), confirmed_digits=confirmed(coarse[4], value),
                              independence=independence, method=method))
    return given


COLUMNS = ["material", "role", "key", "index", "argument", "value", "confirmed_digits", "independence", "method"]


def self_check(reduced):
    """Independent routes to the same series; returns a list of failures."""
    wrong = []
    for material in _solids():
        if reduced and len(material.series) > 12:
            continue
        with mp.workdps(WORKING["fine"]):
            (glassy, creeps, retardations, viscosity), (relaxed, relaxations, relaxing) = both_series(material)
            for point in sample_points(material):
                w = exact(1 / point)
                modulus = relaxed + mp.fsum(e * mp.mpc(0, w * t) / mp.mpc(1, w * t) for e, t in zip(relaxations, relaxing))
                compliance = 1 / glassy + mp.fsum(j / mp.mpc(1, w * t) for j, t in zip(creeps, retardations))
                compliance += 1 / mp.mpc(0, w * viscosity) if viscosity else 0
                error = abs(modulus * compliance - 1)
                if error > mpf(10) ** -50:
                    wrong.append(f"{material.name}: modulus times compliance differs from 1 by {mp.nstr(error, 3)}")
            rates = sorted([1 / t for t in retardations] + [1 / t for t in relaxing])
            order = [1 / t in [1 / x for x in relaxing] for t in sorted(retardations + relaxing, reverse=True)]
            if any(a == b for a, b in zip(order[:-1], order[1:])):
                wrong.append(f"{material.name}: relaxation and retardation rates do not interlace")
            if material.kind == "creep":
                back = to_creep(relaxed, relaxations, relaxing)
                pairs = list(zip(back[1], creeps)) + list(zip(back[2], retardations))
            else:
                back = to_relaxation(glassy, creeps, retardations, viscosity)
                pairs = list(zip(back[1], relaxations)) + list(zip(back[2], relaxing))
            worst = max([abs(a / b - 1) for a, b in pairs], default=mpf(1))
            if worst > mpf(10) ** -50:
                wrong.append(f"{material.name}: converting back differs by {mp.nstr(worst, 3)}")
            if material.kind == "creep" and len(material.series) <= 3:
                wrong += _inverse_laplace(material, relaxed, relaxations, relaxing)
            if len(material.series) <= 12 and material.kind == "creep":
                wrong += _polynomial(material, relaxing)
        print(f"{material.name}: modulus x compliance, interlacing, round trip ({mp.nstr(worst, 2)})")
    return wrong


def _inverse_laplace(material, relaxed, relaxations, relaxing):
    with mp.workdps(60):
        t = exact(sample_points(material)[1])

        def image(s):
            compliance = 1 / exact(material.modulus) + mp.fsum(
                j / (1 + s * tau) for j, tau in zip(material.strengths, material.times))
            if material.viscosity:
                compliance += 1 / (s * material.viscosity)
            return 1 / (s * compliance)

        a = mp.invertlaplace(image, t, method="talbot", degree=100)
        b = relaxation_response(relaxed, relaxations, relaxing, t)
        error = abs(a / b - 1)
    return [f"{material.name}: R(t) from the inverse transform differs by {mp.nstr(error, 3)}"] if error > mpf("1e-25") else []


def _polynomial(material, relaxing):
    """Numerator of the compliance as a polynomial in s, roots by Durand-Kerner."""
    with mp.workdps(200):
        rates = [1 / t for t in material.times]

        def product(factors):
            out = [mpf(1)]
            for rate in factors:
                out = [a + b for a, b in zip(out + [mpf(0)], [mpf(0)] + [rate * c for c in out])]
            return out

        def add(a, b):
            size = max(len(a), len(b))
            a, b = [mpf(0)] * (size - len(a)) + a, [mpf(0)] * (size - len(b)) + b
            return [x + y for x, y in zip(a, b)]

        flow = 1 / material.viscosity if material.viscosity else mpf(0)
        total = [c / exact(material.modulus) for c in product(rates)] + ([mpf(0)] if flow else [])
        for k, (j, rate) in enumerate(zip(material.strengths, rates)):
            part = [j * rate * c for c in product(rates[:k] + rates[k + 1:])] + ([mpf(0)] if flow else [])
            total = add(total, part)
        if flow:
            total = add(total, [flow * c for c in product(rates)])
        roots = mp.polyroots([c / total[0] for c in total], maxsteps=2000, extraprec=800)
        times = sorted(-1 / mp.re(r) for r in roots)
        worst = max(abs(a / b - 1) for a, b in zip(times, relaxing))
    return [f"{material.name}: polynomial roots differ by {mp.nstr(worst, 3)}"] if worst > mpf("1e-40") else []


def main():
    options = arguments("Creep and relaxation series of one solid.")
    start = clock.time()
    if options.self_check:
        finish(self_check(options.reduced), start, "self-check")
    solids = [m for m in _solids() if not options.reduced or len(m.series) <= 12]
    rows = [row for material in solids for row in rows_of(material)]
    if options.check:
        stored = read(NAME)
        wrong = differences(NAME, stored, rows, ["material", "role", "key", "index", "argument"])
        if not options.reduced and len(stored) != len(rows):
            wrong.append(f"{NAME}: {len(stored)} rows in the file, {len(rows)} computed")
        finish(wrong, start, f"check of {len(rows)} rows")
    write(NAME, COMMAND, "creep and relaxation series of one solid, both ways, with responses", COLUMNS, rows,
          precision=f"{WORKING['fine']} digits; confirmed against {WORKING['coarse']} digits; {DIGITS} digits printed")
    print(f"written in {clock.time() - start:.1f} s")


if __name__ == "__main__":
    main()
