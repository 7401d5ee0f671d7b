"""Sliding contacts by collocation of the raw integral equation, edges solved again."""

from values import Value, rows

RELAXED, RATE = 2.3e6, 7.0
LOADS, WORKS = 1e-6, 1e-4
# A few eps of the linear systems; of edges that are found; of releases, which are differences of energies over a short zone.
NOISE, FOUND, RELEASES = 4e-15, 2e-14, 1e-12


def material(harness, text):
    terms = [tuple(map(float, term.split(":"))) for term in text.split()]
    glassy = 1.0
    for compliance, _ in terms:
        glassy -= compliance
    return harness.Material.from_creep(RELAXED / glassy, [j / RELAXED for j, _ in terms], [ratio / RATE for _, ratio in terms])


def value(row, file, state, found, noise=NOISE):
    quantity = row["quantity"]
    target = WORKS if quantity.endswith(("work", "release")) else LOADS
    place = " ".join(filter(None, [row.get("asked", ""), row["case"], row["a"], row.get("position", "")]))
    return Value("sliding", file, place, quantity, float(found), row["value"], float(row["scale"]), target, noise, state=state)


def wave(harness):
    file = "sliding_wave.csv"
    for (asked, case, *_), own in grouped_states(rows(file)).items():
        solid, first = material(harness, own[0]["terms"]), own[0]
        state = f"{asked} {case} {first['a']}"
        by_name = {row["quantity"]: row for row in own if not row["position"]}
        if asked == "full":
            yield value(first, file, state, harness.full_contact(solid, RATE)[0])
            continue
        if asked == "given_edges":
            contact = harness.SlidingContact(solid, RATE, float(first["a"]), float(first["e"]), "mean_pressure", float(first["mean_pressure"]))
            totals = contact.totals()
            for row in own:
                part = float(row["position"] or 0.0)
                found = {"pressure": contact.pressure, "gap": contact.gap}[row["quantity"]](part)[0] if row["position"] else totals[row["quantity"]]
                yield value(row, file, state, found)
            continue
        if asked == "adhesiveless":
            found = harness.sliding_steady(solid, RATE, "half_width", float(first["a"]), accuracy=1e-12)
            for row in own:
                yield value(row, file, state, found[row["quantity"]][0], FOUND)
            continue
        # Adhesive: works and load of the reference are given, edges are found.
        work, zone = float(by_name["reduced_work"]["value"]), float(first["zone"])
        start = [1.01 * float(first["a"]), float(by_name["eccentricity"]["value"]) - 0.003]
        found = harness.sliding_equilibrium(solid, RATE, [work, work, zone, zone], "mean_pressure", float(first["mean_pressure"]), start)
        yield from equilibrium(own, file, state, found, float(first["a"]))
        # The works at the edges of the reference themselves.
        contact = harness.SlidingContact(solid, RATE, float(first["a"]), float(by_name["eccentricity"]["value"]), "mean_pressure",
                                         float(first["mean_pressure"]))
        trailing, leading = contact.edge_works([zone, zone])
        for name, done in (("trailing_work_at_edges", trailing), ("leading_work_at_edges", leading)):
            yield Value("sliding", file, f"{asked} {case} {first['a']}", name, done / 6.283185307179586, by_name["reduced_work"]["value"], work, WORKS, FOUND,
                        state=state)


def grouped_states(table):
    """Rows of one state: asked, case, half-width, mean pressure as given."""
    out = {}
    for row in table:
        out.setdefault((row["asked"], row["case"], row["a"], row["mean_pressure"]), []).append(row)
    return out


def equilibrium(own, file, state, found, half_width):
    for row in own:
        if row["quantity"] in ("reduced_work", "trailing_work", "leading_work"):
            continue
        noise = RELEASES if row["quantity"].endswith("release") else FOUND
        yield value(row, file, state, found[row["quantity"]], noise)
    place = " ".join(filter(None, [own[0].get("asked", ""), own[0]["case"], own[0]["a"]]))
    yield Value("sliding", file, place, "half_width", found["half_width"], own[0]["a"], 1.0, LOADS, FOUND, state=state)


def hysteresis(harness):
    file = "sliding_hysteresis.csv"
    states = {}
    for row in rows(file):
        states.setdefault(row["case"], []).append(row)
    for case, own in states.items():
        first = own[0]
        by_name = {row["quantity"]: float(row["value"]) for row in own}
        zone = float(first["zone"])
        edges = [by_name["trailing_work"], by_name["leading_work"], zone, zone]
        start = [1.01 * float(first["a"]), float(first["e"]) - 0.003]
        found = harness.sliding_equilibrium(material(harness, first["terms"]), RATE, edges, "mean_pressure", float(first["mean_pressure"]), start)
        yield from equilibrium(own, file, f"two works {case}", found, float(first["a"]))


def values(harness):
    yield from wave(harness)
    yield from hysteresis(harness)
