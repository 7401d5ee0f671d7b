"""The sphere: dense annuli on the raw equation; the closure in real space; Lee-Radok and Ting; passing times."""

from values import Value, floats, made_independently, relative, rows

PRESCRIBED, CLOSED = 1e-4, 1e-2


def material(harness, text):
    """Glassy modulus; J_j,tau_j; ..."""
    glassy, *terms = text.split(";")
    pairs = [floats(term, ",") for term in terms]
    return harness.Material.from_creep(float(glassy), [j for j, _ in pairs], [tau for _, tau in pairs])


def relaxation_material(harness, text):
    relaxed, *terms = text.split(";")
    pairs = [floats(term, ",") for term in terms]
    return harness.Material.from_relaxation(float(relaxed), [e for e, _ in pairs], [rho for _, rho in pairs])


def annuli(harness):
    file = "sphere_annuli.csv"
    histories = {}
    for row in rows(file):
        histories.setdefault(row["case"], []).append(row)
    for case, own in histories.items():
        yield from (prescribed if own[0]["kind"] == "prescribed" else closed)(harness, file, case, own)


def prescribed(harness, file, case, own):
    first = own[0]
    path = [floats(part, ",") for part in first["path"].split(";")]
    places = sorted({float(row["place"]) for row in own if row["place"]})
    found = harness.prescribed_contact(material(harness, first["material"]), first["shape"], float(first["size"]), first["start"], path[0][0], path[0][1],
                                       [number for part in path[1:] for number in part], places, process_zone=float(first["zone"]))
    for row in own:
        index = int(row["instant"])
        if row["quantity"] == "displacement":
            value = found["displacement"][index * len(places) + places.index(float(row["place"]))]
        else:
            value = found[row["quantity"]][index]
        yield Value("sphere", file, " ".join(filter(None, [case, row["instant"], row["place"]])), row["quantity"], float(value), row["value"],
                    float(row["scale"]), PRESCRIBED, 1e-11, state=case)


def closed(harness, file, case, own):
    first = own[0]
    by_name = {row["quantity"]: row for row in own if row["quantity"].endswith("penetration")}
    begin, speed = float(by_name["start_penetration"]["value"]), float(first["speed"])
    asked = [row for row in own if row["time"]]
    times = sorted({float(row["time"]) for row in asked})
    approach = first["start"] == "untouched"
    segments, origin = [], begin
    if "turn_penetration" in by_name:
        origin = float(by_name["turn_penetration"]["value"])
        segments.append(("penetration", origin, (origin - begin) / speed))
        approach = False
    skipped, last = len(segments), 0.0
    for time in times:
        segments.append(("penetration", origin + (speed if approach else -speed) * time, time - last))
        last = time
    found = harness.indentation(material(harness, first["material"]), first["shape"], float(first["size"]), first["start"], "penetration", begin, segments,
                                work_of_adhesion=float(first["work"]), process_zone=float(first["zone"]), accuracy=1e-7)
    # Instants: the start, then the end of each segment.
    for row in asked:
        index = 1 + skipped + times.index(float(row["time"]))
        yield Value("sphere, closed loop", file, f"{case} {row['instant']}", row["quantity"], float(found[row["quantity"]][index]), row["value"],
                    float(row["scale"]), CLOSED, 1e-6, state=case)


def named(text):
    return dict(part.split("=", 1) for part in text.split(" "))


def line(harness):
    """Closures of given fields (real space) and elastic contacts at a finite zone."""
    file = "indentation.csv"
    for row in rows(file):
        given = named(row["inputs"])
        if row["quantity"] == "closure":
            pieces = []
            for text in (given["load"], given["factor"]):
                lower, *parts = text.split("|")
                pieces.append((float(lower), [floats(part, ",") for part in parts]))
            ends = [[lower] + [part[0] for part in parts] for lower, parts in pieces]

            def polynomial(parts):
                def at(s):
                    coefficients = next((part[1:] for part in parts if s <= part[0]), parts[-1][1:])
                    total = 0.0
                    for c in reversed(coefficients):
                        total = total * s + c
                    return total
                return at

            load, factor = (polynomial(parts) for _, parts in pieces)
            value = harness.sphere_closure(float(given["a"]), float(given["zone"]), ends[0], load, ends[1], factor)
            yield relative("sphere line", file, row["case"], "closure", value, row["value"], 1e-12, 50.0, state=row["case"])
        elif row["case"] == "elastic":
            numbers = [float(given[k]) for k in ("modulus", "work", "zone", "penetration")]
            state = harness.elastic_indentation(given["shape"], float(given["size"]), *numbers)
            # The force passes through zero: its scale is E a f(a).
            a, value = state[0], state[0] if row["quantity"] == "contact_radius" else state[2]
            depth = harness.line_profile(given["shape"], float(given["size"]), a)[0]
            scale = a if row["quantity"] == "contact_radius" else numbers[0] * a * depth
            yield Value("sphere line", file, row["inputs"], row["quantity"], value, row["value"], scale, 1e-10, 1e-12, state=row["inputs"], independent=made_independently(row))
    for row in rows("indentation_shape.csv"):
        points = [number for pair in row["points"].split(";") for number in floats(pair, ",")]
        value = harness.line_profile("table", points, float(row["place"]))[0]
        yield relative("sphere line", "indentation_shape.csv", f"{row['case']} {row['place']}", "line", value, row["line"], 1e-12, 50.0, state=row["case"])


def values(harness):
    yield from annuli(harness)
    yield from line(harness)
