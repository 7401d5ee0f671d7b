"""Every value of reference_data/ that the harness can be asked for: within its target, within its budget, and enough of them.

A value counts if it is compared within a tolerance (its budget) of at most ten times the observed difference. Where both agree to the last bit the
difference is a part of an ulp by chance, and the budget some eps: such values are guarded, and not counted.
"""

from collections import defaultdict

import ratchet
import tools
import values

# Group: values at least, states or histories at least, the tolerance that they must be held to.
PROMISED = {"special": (80, 0, 1e-13), "cracks": (80, 0, 1e-12), "sliding": (100, 25, 1e-4), "sphere": (100, 20, 1e-4), "finite elements": (20, 10, 1e-3), "peers": (60, 20, 2e-3)}


def test_every_value_is_within_its_target(everything):
    late = [f"{v.file}: {v.row} {v.quantity}: {v.value!r} against {v.reference}, error {v.error:.2e} above {v.target:.0e}" for v in everything
            if not v.error <= v.target]
    assert not late, "\n".join(late)


def test_no_error_outgrew_its_budget(everything):
    table, _ = ratchet.read()
    assessment = ratchet.assess(everything, table)
    tools.SUMMARY.append(f"ratchet: {len(everything)} values, {len(assessment.worse)} worse, {len(assessment.better)} better than recorded")
    assert assessment.passes, "\n".join(assessment.sentences())


def test_enough_values_are_read_tightly(everything):
    table, _ = ratchet.read()
    count, states, loosest, worst, all_of = defaultdict(int), defaultdict(set), defaultdict(float), defaultdict(float), defaultdict(int)
    for value in everything:
        tolerance = float(table[value.key]["budget"])
        all_of[value.group] += 1
        worst[value.group] = max(worst[value.group], value.error)
        if value.independent and tolerance <= 10.0 * value.error and tolerance <= value.target:
            count[value.group] += 1
            states[value.group].add(value.state)
            loosest[value.group] = max(loosest[value.group], tolerance)
    for group in all_of:
        tools.SUMMARY.append(f"{group}: {all_of[group]} values compared, worst error {worst[group]:.1e}; {count[group]} count (independent, tolerance within "
                             f"ten times the difference), {len(states[group] - {''})} states, loosest tolerance {loosest[group]:.1e}")
    for group, (least, least_states, tolerance) in PROMISED.items():
        assert count[group] >= least and len(states[group]) >= least_states and loosest[group] <= tolerance, group


def test_loads_and_works_of_sliding_are_held_to_their_own_tolerances(everything):
    table, _ = ratchet.read()
    for value in everything:
        if value.group == "sliding":
            assert float(table[value.key]["budget"]) <= value.target, value.key


def test_every_reference_file_says_where_it_comes_from():
    for name, header in values.headers().items():
        # Published numbers have a source and what was chosen of it; what a script of ours made, the script.
        published = "source" in header and "tool" not in header
        for key in ("file", "about", "source", "selection", "columns", "sha256") if published else ("file", "about", "tool", "precision", "command", "sha256"):
            assert header.get(key), f"{name} has no {key}"
        table = values.rows(name)       # refuses a wrong hash
        if not published and name != "steady_crack_materials.csv":
            words = {row.get("independence") for row in table if row.get("role") not in ("input",)}
            assert words <= {"independent", "fallback"}, f"{name}: {words}"
