"""Indentation without adhesion through the command line: textbook cases by quadrature, and random scenes against a bed of springs.

A value is right if it differs from the reference by no more than its own error bound and rounding; a bound must also meet the accuracy that the scene asks for.
"""

import json
import os
import subprocess
import tempfile

import pytest

import tools

ROUNDING = 2e-13


@pytest.fixture(scope="module")
def binary():
    path = os.path.join(tools.TARGET, "release", "viscotack")
    if not os.path.exists(path):
        if tools.must_not_be_missing():
            pytest.fail(f"CI=true, and {path} is not built")
        pytest.skip(f"{path} is not built: cargo build --release")
    return path


def rows_of(binary, text):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        done = subprocess.run([binary, "run", path, "--json"], capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr[-500:]
    return [row for row in json.loads(done.stdout)["results"] if row["row"] != "summary"]


def references():
    import sys
    sys.path.insert(0, tools.REFERENCES)
    from common import read
    cases = {}
    for row in read("adhesiveless.csv"):
        cases.setdefault(row["case"], []).append(row)
    return cases


@pytest.mark.parametrize("case", ["press_one", "press_cone", "press_power", "press_blunt", "press_hold_press", "liquid_hold", "retract_one", "retract_three",
                                  "retract_liquid", "burgers_force"])
def test_textbook_case(case, binary, need):
    need("mpmath")
    wanted = references()[case]
    rows = rows_of(binary, wanted[0]["scene"].replace("\\n", "\n"))
    end = max(row["values"]["time"]["value"] for row in rows)
    for reference in wanted:
        time, right, scale = float(reference["time"]), float(reference["value"]), float(reference["scale"])
        if reference["quantity"] == "detachment_time":
            found = [row["values"]["time"] for row in rows if row["row"] == "event" and row["event"] == "detachment"]
            assert len(found) == 1, found
            cell = found[0]
        else:
            cells = [row["values"][reference["quantity"]] for row in rows if row["row"] == "instant" and abs(row["values"]["time"]["value"] - time) < 1e-12 * end]
            assert cells, f"no instant at {time}"
            cell = cells[-1]
        assert abs(cell["value"] - right) <= cell["error"] + ROUNDING * scale, (reference["quantity"], time, cell, right)
        assert cell["error"] <= 1e-6 * scale, (reference["quantity"], time, cell)


def study():
    import adhesiveless_study
    return adhesiveless_study


def test_random_scenes(binary, need):
    """Every shape, control and start, up to five turns; values to three digits, events, nothing refused."""
    for module in ("numpy", "scipy", "mpmath"):
        need(module)
    of = study()
    results, seconds = of.study(40, 5, binary, jobs=2, truths=of.BLUNT)
    text, failed = of.report(results, seconds)
    assert failed == 0, text + "\n" + "\n".join(f"{r['seed']} {r['number']}: {r['wrong'] or r['skipped']}" for r in results if r["wrong"] or r["skipped"])
    assert sum(len(r["compared"]) for r in results) > 2000, text


def test_the_two_references_agree(need):
    """A bed of springs that follows no edge, and times of equal radius: they share no step."""
    for module in ("numpy", "scipy", "mpmath"):
        need(module)
    import numpy as np
    of, scenes = study(), 0
    for number in range(60):
        scene = of.Draw(6, number).scene()
        if scene["kind"]["control"] != "penetration" or scene["start"][0] != "penetration" or scene["kind"]["special"] == "oscillation":
            continue
        right, blunt = of.truth(scene), of.blunt_truth(scene)
        scenes += 1
        assert np.allclose(right["time"], blunt["time"], rtol=1e-12, atol=0.0)
        for name in ("penetration", "force", "contact_radius"):
            assert np.all(np.abs(np.array(right[name]) - blunt[name]) <= np.array(blunt["off"][name]) + np.array(right["off"][name])), (number, name)
        if scenes == 6:
            break
    assert scenes == 6
