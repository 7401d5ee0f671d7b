"""Dugdale-Schapery-Greenwood cracks: a constant cohesive stress over a zone, from the half-plane kernel.

Sources: Schapery, Int. J. Fract. 11 (1975) 141, 369, 549 and 39 (1989) 163; Greenwood, J. Phys. D 37 (2004) 2557 and
40 (2007) 1769; thesis equation 5.43 with the argument of J read as (delta - zeta)/v. One deformable half-body, plane stress.

    symbol    meaning
    sigma_0   cohesive stress
    delta     length of the cohesive zone, T = delta/v
    r         distance behind the front end of the zone (the end inside the contact), in units of delta
    y, q      distance ahead of that end in the same units, q = sqrt(y)
    J(t)      creep compliance, E0 relaxed modulus
    U         displacement of the rear end of the zone times 1/(sigma_0 delta)

Both motions need one influence function; u_rear/(sigma_0 delta) = int_0^1 J(T (1 - r)) influence(r) dr and
Dgamma = sigma_0 u_rear. The textbook form of the influence functions holds artanh(sqrt r). It is not used here: they come
from the stresses on both sides of the front end and the logarithmic kernel of the half-plane, u' = (2/pi) PV int sigma/(x'-x).

    opening   the zone carries sigma_0, the contact ahead (2 sigma_0/pi) arctan(1/q) (elastic Dugdale stress, no singularity):
              influence = (2/pi) [ ln(r/(1-r)) + int_0^inf (2/pi) arctan(1/q) 2 q dq/(q^2 + r) ]        (slope of the surface)
              delta = pi K^2/(8 sigma_0^2), G/Dgamma = 4/(pi E0 U)
    closing   material entered the zone a time (1-r)T ago, so the reference stress there is sigma_0 J((1-r)T) and ahead
              (q/pi) int_0^1 sigma_0 J dr'/(sqrt(r') (r' + q^2)):
              influence = (2/pi) [ ln((1-r)/r) + (1/(pi sqrt r)) int_0^inf 2 q^2 ln(1 + 1/q^2) dq/(r + q^2) ]
              K1 = E0 sigma_0 sqrt(2 delta/pi) N, N = int_0^1 J((1-r)T) r^{-1/2} dr, G/Dgamma = E0 N^2/(pi U)

What these values share with the textbook form: the two stress fields, the criterion Dgamma = sigma_0 u_rear, and for closing
the absence of a singularity (5.43). What they do not share: the displacement kernel.

Third law, `schapery`: the energy closure 5.37 with the length of 5.43, alpha as printed there. G from the raw closing work
(raw_crack_work.py), J from R by material_conversion.py, delta = pi G/(alpha^2 sigma_0^2 E0 N^2).

Quadrature: one table of nodes for every solid. r <= 1/2: sqrt(r) on Gauss panels. r > 1/2: 1 - r on Gauss panels growing by
4 from 1e-46, which resolves the logarithm at the rear end and any memory length at once.
"""

from mpmath import mp, mpf

import raw_crack_work as raw
from common import COARSE, FINE, confirmed, exact, gauss, geometric, number
from materials import MATERIALS, Material, short

SMALLEST = {COARSE.name: mpf("1e-36"), FINE.name: mpf("1e-44")}


def _points(setting, breaks):
    return [(lower + (upper - lower) * x, (upper - lower) * w)
            for lower, upper in zip(breaks[:-1], breaks[1:]) for x, w in gauss(setting)]


def opening_influence(setting):
    """A function of (r, 1 - r)."""
    near = [(q * q, 4 / mp.pi * mp.atan(1 / q) * q * w)
            for q, w in _points(setting, [mpf(0)] + geometric(mpf("1e-8"), mpf(1), 4))]
    far = [(p * p, 4 / mp.pi * mp.atan(p) / p * w) for p, w in _points(setting, [mpf(0), mpf(1)])]  # p = 1/q

    def influence(r, rest):
        ahead = mp.fsum(w / (q2 + r) for q2, w in near) + mp.fsum(w / (1 + r * p2) for p2, w in far)
        return 2 / mp.pi * (mp.log(r / rest) + ahead)

    return influence


def closing_influence(setting):
    """A function of (r, 1 - r)."""
    near = [(q * q, 2 * q * q * mp.log(1 + 1 / (q * q)) * w)
            for q, w in _points(setting, [mpf(0)] + geometric(mp.sqrt(SMALLEST[setting.name]) * mpf("1e3"), mpf(1), 4))]
    far = [(p * p, 2 * mp.log(1 + p * p) / (p * p) * w) for p, w in _points(setting, [mpf(0), mpf(1)])]

    def influence(r, rest):
        ahead = mp.fsum(w / (q2 + r) for q2, w in near) + mp.fsum(w / (1 + r * p2) for p2, w in far)
        return 2 / mp.pi * (mp.log(rest / r) + ahead / (mp.pi * mp.sqrt(r)))

    return influence


_TABLES = {}


def zone_table(setting, motion):
    """Rows (r, 1 - r, weight dr, influence)."""
    key = (setting.name, motion)
    if key not in _TABLES:
        with mp.workdps(setting.dps):
            half = mp.sqrt(mpf(1) / 2)
            nodes = [(q * q, 1 - q * q, 2 * q * w) for q, w in _points(setting, [mpf(0), half / 2, half])]
            nodes += [(1 - t, t, w) for t, w in
                      _points(setting, [mpf(0)] + geometric(SMALLEST[setting.name], mpf(1) / 2, 4))]
            influence = (opening_influence if motion == "opening" else closing_influence)(setting)
            _TABLES[key] = [(r, rest, w, influence(r, rest)) for r, rest, w in nodes]
    return _TABLES[key]


def creep(material, time):
    total = material.instant_compliance()
    for strength, retardation in zip(material.strengths, material.times):
        total -= strength * mp.expm1(-time / retardation)
    return total + (time / material.viscosity if material.viscosity else 0)


def zone_integrals(setting, material, motion, transit_time):
    """U = int J influence dr and N = int J r^{-1/2} dr."""
    with mp.workdps(setting.dps):
        displacement, intensity = mpf(0), mpf(0)
        for r, rest, w, influence in zone_table(setting, motion):
            compliance = w * creep(material, transit_time * rest)
            displacement += compliance * influence
            intensity += compliance / mp.sqrt(r)
        return displacement, intensity


# ---------------------------------------------------------------- rows

def rows(task):
    material = MATERIALS[task["material"]]
    time = exact(task["transit_time"])
    opening = task["motion"] == "opening"
    results = []
    for setting in (COARSE, FINE):
        displacement, intensity = zone_integrals(setting, material, task["motion"], time)
        with mp.workdps(setting.dps):
            adhesion, stress = exact(material.adhesion), exact(material.cohesive)
            length = adhesion / (stress ** 2 * displacement)
            if material.viscosity:
                value = stress * mp.sqrt(8 * length / mp.pi)
            elif opening:
                value = 4 / (mp.pi * material.relaxed_modulus() * displacement)
            else:
                value = material.relaxed_modulus() * intensity ** 2 / (mp.pi * displacement)
            results.append((value, length))
    with mp.workdps(FINE.dps):
        (coarse, _), (fine, length) = results
        return [dict(case=task["case"], model="dugdale_schapery", material=material.name, motion=task["motion"],
                     process_zone="cohesive", transit_time=number(time), speed=number(length / time),
                     quantity="stress_intensity_factor" if material.viscosity else "energy_release_rate_ratio",
                     process_zone_length=number(length), cohesive_stress=number(stress),
                     work_of_adhesion=number(adhesion), value=number(fine), confirmed_digits=confirmed(coarse, fine),
                     independence="independent",
                     method="half-plane kernel on both sides of the tip; shares stresses and criterion with the artanh form")]


def schapery_rows(task):
    import material_conversion
    material = MATERIALS[task["material"]]
    time, alpha = exact(task["transit_time"]), exact(task["alpha"])
    results = []
    for setting in (COARSE, FINE):
        twin = material_conversion.creep_twin(material, setting.dps)
        _, intensity = zone_integrals(setting, twin, "closing", time)
        work = raw.closing_work(setting, material, time)
        with mp.workdps(setting.dps):
            relaxed, stress, adhesion = material.relaxed_modulus(), exact(material.cohesive), exact(material.adhesion)
            value = relaxed / (2 * work)
            length = mp.pi * value * adhesion / (alpha ** 2 * stress ** 2 * relaxed * intensity ** 2)
            results.append((value, length))
    with mp.workdps(FINE.dps):
        (coarse, coarse_length), (fine, length) = results
        return [dict(case=task["case"], model="energy_closure", material=material.name, motion="closing",
                     process_zone="schapery", quantity="energy_release_rate_ratio", transit_time=number(time),
                     speed=number(length / time), process_zone_length=number(length), alpha=number(alpha),
                     cohesive_stress=number(stress), work_of_adhesion=number(adhesion), value=number(fine),
                     confirmed_digits=min(confirmed(coarse, fine), confirmed(coarse_length, length)),
                     independence="independent",
                     method="nested quadrature of 5.37 with 5.30; 5.32; length from quadrature of 5.43")]


CASES = {  # delta/(v t) with t the fastest time
    "creep_1_beta1e3": [1e-9, 1e-5, 1e-3, 0.03, 0.4, 3.0, 29.0, 1e3, 1e6, 1e10],
    "creep_3_beta100": [1e-6, 0.2, 300.0, 1e5],
    "creep_12_beta1e3": [1e-5, 1e3, 1e7, 1e12],
    "creep_2_viscous": [1e-3, 3.0, 1e4],
}


def tasks():
    out = []
    for name, values in CASES.items():
        material = MATERIALS[name]
        fastest = min(t for _, t in material.series)
        for motion in ("opening", "closing"):
            if motion == "closing" and material.flow:
                continue  # a fluid has no relaxed state to close from
            for i, value in enumerate(values):
                out.append(dict(case=f"{name}_zone_{motion}_{i:02}", material=name, motion=motion,
                                transit_time=short(value * fastest * (1 + i * 0.0613)), rows=rows, reduced=False))
    for name, values in {"relaxation_1_beta100": [1e-6, 0.02, 0.9, 14.0, 1e3, 1e8],
                         "relaxation_3_beta100": [1e-3, 20.0, 1e4, 1e9]}.items():
        fastest = min(t for _, t in MATERIALS[name].series)
        for i, value in enumerate(values):
            out.append(dict(case=f"{name}_schapery_{i:02}", material=name, motion="closing",
                            transit_time=short(value * fastest * (1 + i * 0.0613)), alpha=[0.5, 1.0][i % 2],
                            rows=schapery_rows, reduced=False))
    return out
