"""Finite elements of the body (verification/fenicsx) against the solver: punches, spheres with given edges, adhesive cycles, edges at rest."""

import sphere
from values import Value, floats, rows

FILE = "fenicsx.csv"
TARGET = 1e-3
# What an exact update may move by, on another machine.
NOISE = 1e-10


def path_of(first):
    return [floats(part, ",") for part in first["path"].split(";")]


def solid_of(harness, first):
    glassy, *terms = first["material"].split(";")
    # An elastic solid has no term.
    return sphere.material(harness, first["material"]) if terms else harness.Material.from_creep(float(glassy), [], [])


def followed(harness, first, own):
    """(values by quantity along the path, places asked for); a state at rest is a path of one row."""
    path = path_of(first)
    places = sorted({float(row["place"]) for row in own if row["quantity"] == "displacement"})
    steps = path[1:] or [path[0][:2] + [1.0]]
    found = harness.prescribed_contact(solid_of(harness, first), first["shape"], float(first["size"]), first["start"], path[0][0], path[0][1],
                                       [number for row in steps for number in row], places, process_zone=float(first["zone"] or 0.0))
    return found, places


def value_of(row, found, places):
    """What the solver says to a row; instants count the rows of the path after the first, a punch its times from 0."""
    kind, quantity = row["kind"], row["quantity"]
    intensity = found["stress_intensity_factor"]
    if kind == "elastic":
        glassy = float(row["material"].split(";")[0])
        return found["force"][0] if quantity == "force" else intensity[0] ** 2 / (2.0 * glassy)
    if kind == "increment":
        return {"intensity_before": intensity[0], "intensity_after": intensity[1], "force_before": found["force"][0],
                "intensity_of_increment": intensity[1] - intensity[0]}[quantity]
    index = int(row["instant"]) - (0 if kind == "punch" else 1)
    if quantity == "displacement":
        return found["displacement"][index * len(places) + places.index(float(row["place"]))]
    return found[quantity][index]


def histories():
    """Rows of the file by case."""
    out = {}
    for row in rows(FILE):
        out.setdefault((row["kind"], row["case"]), []).append(row)
    return out


def values(harness):
    for (kind, case), own in histories().items():
        found, places = followed(harness, own[0], own)
        for row in own:
            name = " ".join(filter(None, [kind, case, row["instant"], row["place"]]))
            yield Value("finite elements", FILE, name, row["quantity"], float(value_of(row, found, places)), row["value"], float(row["scale"]), TARGET, NOISE,
                        state=case)
