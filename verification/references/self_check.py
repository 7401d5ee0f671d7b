"""Independent routes to the values of steady_crack.csv, shown to agree. Nothing here enters a file.

    collapsed form     the closure work equals (delta/2) K^2 times the running mean of J (or R) over 0..T, for any solid
    literal form       one work integral by plain nested tanh-sinh, in SI units, as printed in 5.19 and 5.37
    Dawson             trumpet and closing stress in closed form
    Persson-Brener     the loss integral equals c/(1 + sqrt(1 + c^2)) per term
    Dugdale            influence functions from the half-plane kernel equal the artanh forms; contact ahead stays flat
    units              a solid rewritten in MPa, mm, ms gives the same ratios
"""

from mpmath import mp, mpf

import cohesive_zone
import persson_brener
import raw_crack_work as raw
from common import COARSE, FINE, exact
from crack_cases import TRANSITS
from materials import MATERIALS


class Findings(list):
    def compare(self, what, a, b, tolerance):
        error = abs(a / b - 1) if b else abs(a)
        self.worst = max(getattr(self, "worst", mpf(0)), error)
        if error > mpf(tolerance):
            self.append(f"{what}: {mp.nstr(a, 20)} against {mp.nstr(b, 20)}, relative difference {mp.nstr(error, 3)}")

    def report(self, what):
        print(f"{what}: largest relative difference {mp.nstr(getattr(self, 'worst', mpf(0)), 3)}")
        self.worst = mpf(0)


def running_mean(material, time):
    """Mean of J or R over 0..time, in closed form."""
    def forgotten(t):
        z = time / t
        return -mp.expm1(-z) / z

    if material.kind == "creep":
        out = material.instant_compliance() + mp.fsum(
            j * (1 - forgotten(t)) for j, t in zip(material.strengths, material.times))
        return out + (time / (2 * material.viscosity) if material.viscosity else 0)
    return material.relaxed_modulus() + mp.fsum(e * forgotten(t) for e, t in zip(material.strengths, material.times))


def collapsed(found, setting, reduced):
    for material in MATERIALS.values():
        if reduced and len(material.series) > 3:
            continue
        values = TRANSITS[len(material.series)]
        for z in values[::3] if reduced else values:
            with mp.workdps(90):
                time = exact(z * min(t for _, t in material.series) * 1.0371)
                closed = running_mean(material, time)
            work = (raw.opening_work if material.kind == "creep" else raw.closing_work)(setting, material, time)
            with mp.workdps(setting.dps):
                found.compare(f"{material.name} running mean at T = {mp.nstr(time, 5)}", 2 * work, closed, "1e-24")
    found.report("closure work against the running means")


def literal(found):
    """5.19 and 5.37 exactly as printed, one term, lengths in metres, plain tanh-sinh."""
    with mp.workdps(20):
        material = MATERIALS["creep_1_beta1e3"]
        (strength,), (tau,) = material.strengths, material.times
        delta, speed, intensity = mpf("7.1e-7"), mpf("2.3e-4"), mpf("4.1e4")

        def reference(x):                      # 5.14 without E0 u0
            return intensity * mp.sqrt(8 * abs(x) / mp.pi) if x < 0 else mpf(0)

        def gap(x):                            # 5.11, memory ends at t = |x|/v
            past = mp.quad(lambda t: strength / tau * mp.exp(-t / tau) * reference(x + speed * t), [0, -x / speed])
            return material.instant_compliance() * reference(x) + past

        work = mp.quad(lambda x: intensity / mp.sqrt(2 * mp.pi * x) * gap(x - delta), [0, delta]) / 2
        found.compare("5.19 as printed", work, raw.opening_work(COARSE, material, delta / speed) * intensity ** 2 * delta, "1e-9")

        material = MATERIALS["relaxation_1_beta100"]
        (strength,), (rho,) = material.strengths, material.times
        relaxed, speed = material.relaxed_modulus(), mpf("1.9e-3")

        def stress(s):                         # 5.30 at distance s inside
            past = mp.quad(lambda t: -strength / rho * mp.exp(-t / rho) / mp.sqrt(s - speed * t), [0, s / speed])
            return (material.glassy_modulus() / mp.sqrt(s) + past) * intensity / relaxed / mp.sqrt(2 * mp.pi)

        work = mp.quad(lambda x: stress(x) * intensity / relaxed * mp.sqrt(8 * (delta - x) / mp.pi), [0, delta]) / 2
        found.compare("5.37 as printed", work,
                      raw.closing_work(COARSE, material, delta / speed) * (intensity / relaxed) ** 2 * delta, "1e-8")
    found.report("5.19 and 5.37 as printed, plain tanh-sinh at 20 digits")


def dawson(y):
    return y * mp.hyp1f1(1, mpf(3) / 2, -y * y)


def fields(found, setting, reduced):
    for name in ("creep_3_beta100", "creep_2_viscous", "relaxation_3_beta100", "relaxation_1_beta1e6"):
        material = MATERIALS[name]
        speed = exact(0.0137)
        for scale in (1e-10, 1e-3, 0.4, 0.9, 7.0, 1e4, 1e10)[::2 if reduced else 1]:
            s = exact(scale * 0.0137 * material.series[-1][1])
            with mp.workdps(setting.dps):
                root = [mp.sqrt(speed * t) for t in material.times]
                if material.kind == "creep":
                    total = material.instant_compliance() * mp.sqrt(s) + mp.fsum(
                        j * (mp.sqrt(s) - r * dawson(mp.sqrt(s) / r)) for j, r in zip(material.strengths, root))
                    if material.viscosity:
                        total += mpf(2) / 3 * s * mp.sqrt(s) / (speed * material.viscosity)
                    found.compare(f"{name} trumpet at {mp.nstr(s, 5)}", raw.trumpet(setting, material, speed, s),
                                  mp.sqrt(8 / mp.pi) * total, "1e-24")
                else:
                    total = material.glassy_modulus() / mp.sqrt(s) - mp.fsum(
                        2 * e * dawson(mp.sqrt(s) / r) / r for e, r in zip(material.strengths, root))
                    total /= material.relaxed_modulus() * mp.sqrt(2 * mp.pi)
                    value, scale_sum = raw.closing_stress(setting, material, speed, s)
                    found.compare(f"{name} stress at {mp.nstr(s, 5)}, of its scale", 1 + (value - total) / scale_sum,
                                  mpf(1), "1e-26")
    found.report("trumpet and closing stress against Dawson's function")


def loss(found, setting, reduced):
    for name, values in persson_brener.CASES.items():
        material = MATERIALS[name]
        if reduced and len(material.series) > 3:
            continue
        for value in values[::2]:
            time = exact(value * min(t for _, t in material.series))
            motion = "opening" if material.kind == "creep" else "closing"
            with mp.workdps(setting.dps):
                c = [2 * mp.pi * t / time for t in material.times]
                kappa = mp.fsum(a * x / (1 + mp.sqrt(1 + x * x)) for a, x in zip(material.strengths, c))
                relaxed = material.relaxed_modulus()
                closed = 1 / (1 - relaxed * kappa) if motion == "opening" else 1 / (1 + kappa / relaxed)
                found.compare(f"{name} Persson-Brener at a/v = {mp.nstr(time, 5)}",
                              persson_brener.ratio(setting, material, motion, time), closed, "1e-24")
    found.report("Persson-Brener loss integrals against the algebraic factor")


def influences(found, setting, reduced):
    points = ["1e-8", "0.003", "0.2", "0.5", "0.93"] if reduced else ["1e-12", "1e-8", "1e-4", "0.003", "0.05", "0.2",
                                                                   "0.5", "0.8", "0.93", "0.9999"]
    with mp.workdps(setting.dps):
        opening, closing = cohesive_zone.opening_influence(setting), cohesive_zone.closing_influence(setting)
        for point in points:
            r = mpf(point)
            artanh = mp.atanh(mp.sqrt(r))
            found.compare(f"opening influence at {point}", opening(r, 1 - r), 4 / mp.pi * artanh, "1e-24")
            found.compare(f"closing influence at {point}", closing(r, 1 - r), 4 / mp.pi * (1 / mp.sqrt(r) - artanh), "1e-24")
    found.report("Dugdale influence functions against artanh")


def contact_ahead(found):
    """Slope of the surface at y ahead of the front end; zero for a contact with a flat rigid half."""
    with mp.workdps(25):
        for y in (mpf("0.2"), mpf("1.7")):
            def principal(f):
                inside = mp.quad(lambda h: (f(y + h) - f(y - h)) / h, [0, y / 2, y])
                return inside + mp.quad(lambda q: 2 * q * f(q * q) / (q * q - y), [mp.sqrt(2 * y), 4 * mp.sqrt(y), mp.inf])

            zone = mp.log(y / (1 + y))
            ahead = principal(lambda x: 2 / mp.pi * mp.atan(1 / mp.sqrt(x)))
            found.compare(f"flat contact, opening, y = {mp.nstr(y, 3)}", ahead, -zone, "1e-10")
            place = mpf("0.37")
            ahead = principal(lambda x: mp.sqrt(x / place) / (mp.pi * (place + x)))
            found.compare(f"flat contact, closing, y = {mp.nstr(y, 3)}", ahead, 1 / (place + y), "1e-10")
    found.report("contact ahead of a cohesive zone stays flat")


def units(found):
    for name in ("creep_2_beta50", "relaxation_2_beta50"):
        first, second = MATERIALS[name], MATERIALS[name + "_mpa_mm_ms"]
        work = raw.opening_work if first.kind == "creep" else raw.closing_work
        for time in ("0.00021", "0.031", "7.9"):
            with mp.workdps(COARSE.dps):
                ratios = []
                for material, t in ((first, mpf(time)), (second, mpf(time) * 1000)):
                    factor = material.relaxed_modulus()
                    ratios.append(work(COARSE, material, t) * (factor if first.kind == "creep" else 1 / factor))
                found.compare(f"{name} in other units at {time} s", ratios[1], ratios[0], "1e-14")
    found.report("two systems of units (doubles, so 1e-16 at best)")


def run(reduced):
    found = Findings()
    setting = COARSE if reduced else FINE
    collapsed(found, setting, reduced)
    literal(found)
    fields(found, setting, reduced)
    loss(found, setting, reduced)
    influences(found, setting, reduced)
    contact_ahead(found)
    units(found)
    return list(found)
