"""Steady cracks by quadrature of the printed integrals, cohesive zones, Persson-Brener, delayed fracture."""

import math
from decimal import Decimal

from values import EPS, Value, made_independently, relative, rows

TARGET = 1e-12


def materials(harness):
    parts = {}
    for row in rows("steady_crack_materials.csv"):
        parts.setdefault(row["material"], {}).setdefault(row["key"], []).append(row["value"])
    out = {}
    for name, part in parts.items():
        numbers = {key: [float(v) for v in column] for key, column in part.items() if key not in ("kind", "units")}
        if part["kind"] == ["creep"]:
            out[name] = harness.Material.from_creep(numbers["glassy_modulus"][0], numbers["creep_strength"], numbers["retardation_time"],
                                                    numbers.get("flow_viscosity", [None])[0])
        else:
            out[name] = harness.Material.from_relaxation(numbers["relaxed_modulus"][0], numbers["relaxation_strength"], numbers["relaxation_time"])
    return out


def steady(harness, solids):
    for row in rows("steady_crack.csv"):
        material, quantity = solids[row["material"]], row["quantity"]
        place = f"{row['case']} {row['model']} {row['process_zone']} {row['distance']}".strip()
        number = lambda column: float(row[column])
        reference, scale, condition = Decimal(row["value"]), None, 1.0
        if quantity == "mean_creep":
            value = material.mean_creep(number("transit_time"))[0]
        elif quantity == "mean_relaxation":
            value = material.mean_relaxation(number("transit_time"))[0]
        elif quantity == "trumpet":
            value = harness.tip_displacement(material, "opening", 1.0, number("speed"), number("distance"))[0][0]
        elif quantity == "closing_stress":
            value = harness.closing_stress(material, 1.0 / material.relaxed_modulus, number("speed"), number("distance"))[0][0]
            scale = number("scale")
        else:
            kind = row["process_zone"]
            numbers = [number("process_zone_length")] if kind == "constant" else [number("cohesive_stress")] + (
                [number("alpha")] if kind != "cohesive" else [])
            theory = {"energy_closure": "virtual_work", "persson_brener": "persson_brener", "dugdale_schapery": "cohesive_zone"}[row["model"]]
            found = harness.steady_crack(material, row["motion"], theory, number("work_of_adhesion"), kind, numbers, speed=number("speed"))
            exponent = found["speed_exponent"]
            value = found["energy_release_rate_ratio"][0] if quantity == "energy_release_rate_ratio" else math.sqrt(found["intensity_squared"])
            # The reference belongs to a speed of 32 digits, the solver to its double: the reference goes along, to first order.
            moved = float((Decimal(number("speed")) - Decimal(row["speed"])) / Decimal(row["speed"]))
            slope = exponent * (1.0 if quantity == "energy_release_rate_ratio" else 0.5)
            signed = -slope if row["motion"] == "closing" and slope > 0.0 else slope
            reference = reference * (1 + Decimal(signed) * Decimal(moved))
            condition += abs(exponent)
        common = dict(state=row["case"], independent=made_independently(row))
        text = f"{reference:.34e}" if scale is None and condition != 1.0 else row["value"]
        if scale is None:
            yield relative("cracks", "steady_crack.csv", place, quantity, value, text, TARGET, condition, **common)
        else:
            yield Value("cracks", "steady_crack.csv", place, quantity, float(value), text, scale, TARGET, 4.0 * EPS, **common)


def delayed(harness, solids):
    """Delays and first speeds by the onset; places of one-term solids by the trajectory, at the times of the exact solution."""
    zone = 3.7e-6
    for row in rows("delayed_fracture.csv"):
        material, quantity = solids[row["material"]], row["quantity"]
        work, intensity = float(row["work_of_adhesion"]), float(row["intensity"])
        if quantity in ("delay", "initial_speed"):
            delay, speed = harness.delayed_onset(material, work, "constant", [zone], intensity)
            value = delay[0] if quantity == "delay" else speed[0] / zone
            bar = (delay[1] / delay[0]) if quantity == "delay" else speed[1] / speed[0]
            yield relative("cracks", "delayed_fracture.csv", row["case"], quantity, value, row["value"], TARGET, max(1.0, bar / EPS), state=row["case"],
                           independent=made_independently(row))
        elif quantity == "time_at":
            found = harness.delayed_trajectory(material, work, "constant", [zone], [intensity], [float(row["value"])], reference=intensity,
                                               lines_per_zone=2048)
            # The place is exact; the time is its reference. Convergence is algebraic: 1e-10.
            place = float(row["place"])
            yield Value("cracks, late", "delayed_fracture.csv", f"{row['case']} {row['place']}", "place_at", found["growth"][0] / zone, row["place"], place,
                        1e-10, 1e-12, state=row["case"], independent=made_independently(row))


def stepped(harness, solids):
    """The thesis's own stepping of (5.54) with (5.67), at its finest: second order in the steps, so some 1e-5 of a zone are its own."""
    file = "delayed_fracture_raw.csv"
    finest = [row for row in rows(file) if row["steps"] == "192" and not row["load"].startswith("follow")]
    for case in dict.fromkeys(row["case"] for row in finest):
        own = [row for row in finest if row["case"] == case]
        first, last, end = map(float, own[0]["load"].split()[1:])
        zone = float(own[0]["process_zone"])
        found = harness.delayed_trajectory(solids[own[0]["material"]], float(own[0]["work_of_adhesion"]), "constant", [zone], [first, end, last],
                                           [float(row["time"]) for row in own], reference=last, lines_per_zone=128)
        for row, growth in zip(own, found["growth"]):
            yield Value("cracks, stepped", file, f"{case} {row['time']}", "place", growth / zone, row["place"], 1.0, 1e-4, 1e-9, state=case,
                        independent=made_independently(row))


def values(harness):
    solids = materials(harness)
    yield from steady(harness, solids)
    yield from stepped(harness, solids)
    yield from delayed(harness, solids)
