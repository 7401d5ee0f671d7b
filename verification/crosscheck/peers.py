"""Waves by other programs: elastic without adhesion, elastic in the limit of no range of adhesion, and on a Maxwell solid stepped in time.

The target of a value is what the peer knows of it itself, by its own refinement (`error` of the file).
"""

import math

from values import Value, rows

RATE, ACCURACY = 1.0, 1e-10
# The peers' limit has no process zone; half of this length is what the edges of ours may be off.
ZONE = 1e-8
# Of our elastic contacts; of edges that are found; of what was asked of a path.
NOISE, FOUND, ASKED = 2e-13, 1e-12, 1e-11


def value(row, file, state, quantity, found, noise):
    scale = float(row["scale"])
    place = " ".join(filter(None, [state, row.get("position", "")]))
    return Value("peers", file, place, quantity, float(found), row["value"], scale, float(row["error"]) / scale, noise / scale, state=f"{file} {state}")


def field(contact, half_width, quantity, position):
    """Pressure or gap at a part of half a period from the crest."""
    angle = math.pi * float(position)
    if quantity == "pressure":
        return contact.pressure(angle / half_width)[0]
    # Parts of the opening, from the trailing edge backwards.
    return contact.gap(0.5 * (angle - half_width) / (math.pi - half_width))[0]


def elastic(harness):
    file = "peers_elastic_wave.csv"
    solid = harness.Material.from_creep(1.0, [], [])
    known = {}
    for row in rows(file):
        load = float(row["mean_pressure"])
        if load not in known:
            found = harness.sliding_steady(solid, RATE, "mean_pressure", load, accuracy=ACCURACY)
            known[load] = found, harness.SlidingContact(solid, RATE, found["half_width"][0], 0.0, "mean_pressure", load)
        found, contact = known[load]
        quantity, state = row["quantity"], f"{row['peer']} {row['case']}"
        one = field(contact, found["half_width"][0], quantity, row["position"]) if row["position"] else found[quantity][0]
        yield value(row, file, state, quantity, one, NOISE)


def adhesive(harness):
    file = "peers_adhesive_wave.csv"
    solid = harness.Material.from_creep(1.0, [], [])
    for row in rows(file):
        work, depth = float(row["reduced_work"]), float(row["penetration"])
        # E0* = 1, k = 1, amplitude 1: pressures in halves, penetrations as they are.
        closed = harness.johnson_wave(1.0, 2.0 * math.pi, 1.0, math.pi * work, "penetration", depth)
        edges = [work, work, ZONE, ZONE]
        found = harness.sliding_equilibrium(solid, RATE, edges, "penetration", depth, [closed[0][0], 0.0])
        quantity, state = row["quantity"], f"{row['peer']} {row['case']}"
        if quantity == "mean_pressure":
            yield value(row, file, state, quantity, found[quantity], FOUND)
            yield value(row, file, state, "mean_pressure_in_closed_form", 2.0 * closed[2], NOISE)
            continue
        contact = harness.SlidingContact(solid, RATE, found["half_width"], 0.0, "penetration", depth)
        yield value(row, file, state, quantity, field(contact, found["half_width"], quantity, row["position"]), FOUND)


def maxwell(harness):
    file = "peers_maxwell.csv"
    known = {}
    for row in rows(file):
        terms = [tuple(map(float, term.split(":"))) for term in row["terms"].split()]
        solid = harness.Material.from_relaxation(1.0, [ratio for ratio, _ in terms], [time for _, time in terms])
        load, asked, quantity = float(row["mean_pressure"]), row["asked"], row["quantity"]
        state = " ".join(filter(None, [asked, row["solid"], row["speed"], row["mean_pressure"], row["time"]]))
        if asked == "relaxation":
            one = solid.relaxation(float(row["time"]))[0]
        elif asked == "creep":
            # A contact that grows is the elastic one under the load E0 J(t) p; amplitude and k are 1, pressures in halves of E0*.
            one = harness.westergaard_wave(1.0, 2.0 * math.pi, 1.0, 0.5 * load * solid.creep(float(row["time"]))[0])[1]
        else:
            if state not in known:
                known[state] = harness.sliding_steady(solid, float(row["speed"]), "mean_pressure", load, accuracy=ACCURACY)
            one = known[state][quantity][0]
        yield value(row, file, state, quantity, one, ASKED)


def values(harness):
    yield from elastic(harness)
    yield from adhesive(harness)
    yield from maxwell(harness)
