"""Persson-Brener cracks from their loss integrals over frequency.

Source: Persson and Brener, Phys. Rev. E 71, 036123 (2005), opening; the closing counterpart is the energy-consistent dual
used by this project (theory of closing in Persson's later work differs in its prefactor and is not meant here).

    symbol    meaning
    a, v, T   cut-off length, speed, transit time a/v
    w         frequency, up to w_c = 2 pi v/a = 2 pi/T
    M(w)      complex modulus of the solid, 1/M(w) its complex compliance
    E0        relaxed modulus

    opening   Dgamma/G = 1 - (2 E0/pi)   int_0^{w_c} (dw/w) sqrt(1 - (w/w_c)^2) |Im 1/M(w)|
    closing   Dgamma/G = 1 + (2/(pi E0)) int_0^{w_c} (dw/w) sqrt(1 - (w/w_c)^2)  Im M(w)

Note the closing form: G/Dgamma is the reciprocal of the whole right side in both cases. The integral is taken numerically
on the complex compliance or modulus; the algebraic factor c/(1 + sqrt(1 + c^2)) per term appears only in the self-check.

Cut-off: growing a = a0 G/Dgamma, a0 = E0 Dgamma/(pi sigma_c^2); or constant a (closing). T is chosen, a and v follow.
Quadrature: y = w/w_c; Gauss panels growing by 4 from below the fastest pole to 1/2, then y = 1 - r^2.
"""

from mpmath import mp, mpf

from common import COARSE, FINE, confirmed, exact, geometric, number, panels
from condition import of_persson_brener
from materials import MATERIALS, short


def loss_compliance(material, frequency):
    """|Im 1/M| from the creep series."""
    total = mp.mpc(material.instant_compliance())
    for strength, time in zip(material.strengths, material.times):
        total += strength / mp.mpc(1, frequency * time)
    return -total.imag


def loss_modulus(material, frequency):
    """Im M from the relaxation series."""
    total = mp.mpc(material.relaxed_modulus())
    for strength, time in zip(material.strengths, material.times):
        total += strength * mp.mpc(0, frequency * time) / mp.mpc(1, frequency * time)
    return total.imag


def loss_integral(setting, loss, limit, slowest):
    """int_0^limit (dw/w) sqrt(1 - (w/limit)^2) loss(w); `slowest` is the longest time in `loss`."""
    first = min(mpf(1) / 2, mpf(3) / 10 / (limit * slowest))
    lower = [mpf(0)] + (geometric(first, mpf(1) / 2, 4) if first < mpf(1) / 2 else [mpf(1) / 2])
    body = panels(setting, lambda y: mp.sqrt(1 - y * y) * loss(limit * y) / y, lower)
    edge = panels(setting, lambda r: 2 * r * r * mp.sqrt(2 - r * r) * loss(limit * (1 - r * r)) / (1 - r * r),
                  [mpf(0), mp.sqrt(mpf(1) / 2)])
    return body + edge


def ratio(setting, material, motion, transit_time):
    """G/Dgamma."""
    with mp.workdps(setting.dps):
        limit, slowest = 2 * mp.pi / transit_time, max(material.times)
        relaxed = material.relaxed_modulus()
        if motion == "opening":
            integral = loss_integral(setting, lambda w: loss_compliance(material, w), limit, slowest)
            return 1 / (1 - 2 * relaxed / mp.pi * integral)
        integral = loss_integral(setting, lambda w: loss_modulus(material, w), limit, slowest)
        return 1 / (1 + 2 / (mp.pi * relaxed) * integral)


def rows(task):
    material = MATERIALS[task["material"]]
    time = exact(task["transit_time"])
    coarse, fine = (ratio(setting, material, task["motion"], time) for setting in (COARSE, FINE))
    with mp.workdps(FINE.dps):
        adhesion, cohesive = exact(material.adhesion), exact(material.cohesive)
        elastic_length = material.relaxed_modulus() * adhesion / (mp.pi * cohesive ** 2)
        shared = dict(case=task["case"], model="persson_brener", material=material.name, motion=task["motion"],
                      quantity="energy_release_rate_ratio", transit_time=number(time), value=number(fine),
                      confirmed_digits=confirmed(coarse, fine), independence="independent",
                      work_of_adhesion=number(adhesion),
                      method="frequency integral of the loss " + ("compliance" if task["motion"] == "opening" else "modulus"))
        out = [dict(shared, process_zone="growing", process_zone_length=number(elastic_length * fine),
                    speed=number(elastic_length * fine / time), alpha="1.0", cohesive_stress=number(cohesive),
                    condition=of_persson_brener(material, time, "growing"))]
        if task["motion"] == "closing":
            speed = exact(task["speed"])
            out.append(dict(shared, process_zone="constant", process_zone_length=number(speed * time),
                            speed=number(speed), condition=of_persson_brener(material, time, "constant")))
    return out


CASES = {  # a/(v t) with t the fastest time of the solid
    "creep_1_beta1e3": [1e-8, 1e-3, 0.1, 1.0, 17.0, 1e3, 1e6, 1e11],
    "creep_3_beta100": [1e-6, 0.2, 300.0, 1e6],
    "creep_12_beta1e3": [1e-5, 1e3, 1e7, 1e12],
    "creep_20_beta1e6": [1e-3, 1e5, 1e11],
    "relaxation_1_beta100": [1e-8, 1e-3, 0.1, 1.0, 17.0, 1e3, 1e6, 1e11],
    "relaxation_3_beta100": [1e-6, 0.2, 300.0, 1e6],
    "relaxation_12_beta1e3": [1e-5, 1e3, 1e7, 1e12],
    "relaxation_20_beta1e6": [1e-3, 1e5, 1e11],
}


def tasks():
    out = []
    for name, values in CASES.items():
        material = MATERIALS[name]
        for i, value in enumerate(values):
            out.append(dict(case=f"{name}_cutoff_{i:02}", material=name,
                            motion="opening" if material.kind == "creep" else "closing",
                            transit_time=short(value * min(t for _, t in material.series) * (1 + i * 0.0737)),
                            speed=short(0.0123 * 7.3 ** i), rows=rows, reduced=len(material.series) <= 3 and i % 2 == 0))
    return out
