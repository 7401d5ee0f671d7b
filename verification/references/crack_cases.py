"""Which steady cracks are computed: the list of tasks behind steady_crack.csv.

One task is one quadrature (or a few) and gives one or more rows. A task names its arguments only; values come from
raw_crack_work.py, persson_brener.py and cohesive_zone.py.

    transit time   T = delta/v; z = T/tau is the only group a term sees
    constant law   delta and v given: v a double, delta = T v exactly (32 digits hold the product of two doubles)
    growing law    delta = alpha K^2/(2 pi sigma_c^2) = alpha a0 G/(Delta gamma), a0 = E0 Delta gamma/(pi sigma_c^2):
                   T is chosen, the work gives K, K gives delta, delta gives v = delta/T
"""

from mpmath import mp

import cohesive_zone
import persson_brener
import raw_crack_work as raw
from common import COARSE, FINE, confirmed, exact, number
from condition import of_energy_closure
from materials import MATERIALS, short

COLUMNS = ["case", "model", "material", "motion", "process_zone", "quantity", "transit_time", "speed",
           "process_zone_length", "alpha", "cohesive_stress", "work_of_adhesion", "distance", "value", "scale",
           "condition", "confirmed_digits", "independence", "method"]


def both(function, *arguments):
    coarse = function(COARSE, *arguments)
    fine = function(FINE, *arguments)
    return coarse, fine


def row(task, quantity, coarse, fine, **more):
    out = dict(case=task["case"], model=task["model"], material=task["material"], motion=task["motion"],
               process_zone="none", quantity=quantity, value=number(fine),
               confirmed_digits=confirmed(coarse, fine), independence="independent")
    out.update(more)
    return out


# ---------------------------------------------------------------- the energy closure over a finite process zone

def closure_rows(task):
    material = MATERIALS[task["material"]]
    opening = task["motion"] == "opening"
    work = raw.opening_work if opening else raw.closing_work
    time = exact(task["transit_time"])
    coarse, fine = both(work, material, time)
    with mp.workdps(FINE.dps):
        mean = [2 * coarse, 2 * fine]
        shared = dict(transit_time=number(time))
        method = ("nested quadrature of 5.19 with 5.11; 5.12; 5.14" if opening
                  else "nested quadrature of 5.37 with 5.30; 5.32")
        rows = [row(task, "mean_creep" if opening else "mean_relaxation", *mean, method=method,
                    condition=of_energy_closure(material, time, "none"), **shared)]

        relaxed = material.relaxed_modulus()
        adhesion = exact(material.adhesion)
        # K^2 from work = adhesion * delta; for closing the work is per (K1/E0)^2
        squared = [adhesion / w * (1 if opening else relaxed ** 2) for w in (coarse, fine)]
        if material.viscosity:
            quantity, result = "stress_intensity_factor", [mp.sqrt(k) for k in squared]
        else:
            quantity, result = "energy_release_rate_ratio", [k / (2 * relaxed * adhesion) for k in squared]

        speed = exact(task["speed"])
        rows.append(row(task, quantity, *result, process_zone="constant", speed=number(speed),
                        process_zone_length=number(speed * time), method=method,
                        work_of_adhesion=number(adhesion),
                        condition=of_energy_closure(material, time, "constant"), **shared))
        cohesive, alpha = exact(material.cohesive), exact(task["alpha"])
        length = alpha * squared[1] / (2 * mp.pi * cohesive ** 2)
        rows.append(row(task, quantity, *result, process_zone="growing", speed=number(length / time),
                        process_zone_length=number(length), alpha=number(alpha), cohesive_stress=number(cohesive),
                        work_of_adhesion=number(adhesion), condition=of_energy_closure(material, time, "growing"),
                        method=method + "; length from 5.25 or 5.41", **shared))
    return rows


# ---------------------------------------------------------------- fields

def trumpet_rows(task):
    material = MATERIALS[task["material"]]
    arguments = exact(task["speed"]), exact(task["distance"])
    coarse, fine = both(raw.trumpet, material, *arguments)
    return [row(task, "trumpet", coarse, fine, speed=number(arguments[0]), distance=number(arguments[1]),
                scale=number(fine), method="quadrature of 5.11 with 5.14; per unit K")]


def stress_rows(task):
    material = MATERIALS[task["material"]]
    arguments = exact(task["speed"]), exact(task["distance"])
    (coarse, _), (fine, scale) = both(raw.closing_stress, material, *arguments)
    return [row(task, "closing_stress", coarse, fine, speed=number(arguments[0]), distance=number(arguments[1]),
                scale=number(scale), method="quadrature of 5.30; per unit K1")]


# ---------------------------------------------------------------- the list

TRANSITS = {  # z = T/time of a term, for the terms at the two ends of the spectrum
    1: [1e-16, 1e-12, 1e-8, 1e-4, 0.03, 0.7, 4.0, 35.0, 1e3, 1e6, 1e12, 1e16],
    2: [1e-10, 1e-4, 0.02, 1.0, 60.0, 1e5, 1e12],
    3: [1e-9, 1e-3, 0.5, 300.0, 1e6, 1e11],
    6: [1e-8, 0.05, 40.0, 1e5, 1e9],
    12: [1e-12, 0.1, 1e4, 1e8, 1e12],
    20: [1e-10, 1.0, 1e4, 1e8, 1e14],
}
SPEEDS = [3.7e-9, 2.3e-5, 0.19, 8.1e-3, 41.0, 1.7e-7]
ALPHAS = [1.0, 0.3, 0.5, 2.5]


def irregular(k):
    """A factor near 1 with a full mantissa."""
    return 1 + ((37 * k + 11) % 101) / 211


def collapsed_tasks():
    tasks = []
    count = 0
    for material in MATERIALS.values():
        motion = "opening" if material.kind == "creep" else "closing"
        times = [t for _, t in material.series]
        for i, z in enumerate(TRANSITS[len(times)]):
            count += 1
            tasks.append(dict(case=f"{material.name}_transit_{i:02}", model="energy_closure", material=material.name,
                              motion=motion, transit_time=short(z * min(times) * irregular(count)),
                              speed=short(SPEEDS[count % len(SPEEDS)] * irregular(count + 5)),
                              alpha=ALPHAS[count % len(ALPHAS)], rows=closure_rows,
                              reduced=len(times) == 1 and i % 3 == 1 or len(times) in (2, 3) and i == 2))
    return tasks


FIELD_MATERIALS = {
    "opening": ["creep_1_beta1e3", "creep_1_beta1e6", "creep_3_beta100", "creep_12_beta1e3", "creep_2_viscous",
                "creep_2_beta50", "creep_2_beta50_mpa_mm_ms"],
    "closing": ["relaxation_1_beta100", "relaxation_1_beta1e6", "relaxation_3_beta100", "relaxation_12_beta1e3",
                "relaxation_20_beta1e6", "relaxation_2_beta50", "relaxation_2_beta50_mpa_mm_ms"],
}
DISTANCES = [1e-10, 1e-7, 1e-4, 0.01, 0.3, 1.3, 6.0, 50.0, 1e3, 1e6, 1e10]  # in units of speed * a time
NEAR_ZERO = [0.80, 0.86, 0.8738, 0.90, 1.0, 1.5, 1.86, 2.2]  # one term: stress changes sign at 0.87 and peaks at 1.86


def field_tasks():
    tasks = []
    count = 0
    for motion, names in FIELD_MATERIALS.items():
        for name in names:
            material = MATERIALS[name]
            times = sorted(t for _, t in material.series)
            middle = times[len(times) // 2]
            scales = list(DISTANCES)
            if motion == "closing" and len(times) == 1:
                scales += NEAR_ZERO
            for i, scale in enumerate(scales):
                count += 1
                speed = short(SPEEDS[count % len(SPEEDS)] * irregular(count))
                exactly = scale if i >= len(DISTANCES) else scale * irregular(count + 3)
                tasks.append(dict(case=f"{name}_distance_{i:02}", model="energy_closure", material=name, motion=motion,
                                  speed=speed, distance=short(exactly * speed * middle),
                                  rows=trumpet_rows if motion == "opening" else stress_rows,
                                  reduced=len(times) <= 3 and i % 3 == 1))
    return tasks


def tasks():
    return collapsed_tasks() + field_tasks() + persson_brener.tasks() + cohesive_zone.tasks()
