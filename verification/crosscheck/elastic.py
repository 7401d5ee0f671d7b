"""Elastic closed forms: the sphere by its energy, the wave by its raw relation and its kernel."""

import math

from values import EPS, Value, made_independently, relative, rows


def values(harness):
    file = "elastic.csv"
    for row in rows(file):
        inputs = [float(row[f"x{i}"]) for i in range(1, 6) if row[f"x{i}"]]
        place = " ".join([row["branch"]] + [row[f"x{i}"] for i in range(1, 6)])
        asked = row["asked"]
        if row["problem"] == "jkr":
            (value, bar), _, _ = harness.jkr(*inputs[:3], asked.rsplit("_by_", 1)[1], inputs[3], row["branch"])
        elif row["problem"] == "field":
            modulus, wavelength, amplitude, work, position = inputs
            half_width = wavelength / 5.0
            penetration = harness.johnson_wave(modulus, wavelength, amplitude, work, "half_width", half_width)[3]
            surface = -2.0 * amplitude * math.sin(math.pi * position / wavelength) ** 2 + penetration
            surface += harness.johnson_wave_gap(modulus, wavelength, amplitude, work, half_width, position)
            yield Value("elastic", file, place, asked, surface, row["value"], amplitude, 1e-13, 4.0 * EPS, state=place)
            continue
        elif "_by_" in asked:
            found = harness.johnson_wave(*inputs[:4], asked.rsplit("_by_", 1)[1], inputs[4], row["branch"])
            value, bar = found[1] if asked.startswith("gap") else found[0]
        else:
            name, place_of = asked.split("_at_")
            found = harness.johnson_wave(*inputs[:4], {"pull_off": "pull_off", "snap_in": "snap_in", "fold": "separation"}[place_of])
            value = {"pressure": found[2], "penetration": found[3], "half_width": found[0][0]}[name]
            bar = 0.0
        # Next to a fold the last bit of what is imposed moves the contact: the solver says by how much at most, and that is the target there.
        yield relative("elastic", file, place, asked, value, row["value"], max(1e-13, bar / abs(value)), state=place, independent=made_independently(row))
