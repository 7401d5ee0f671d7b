"""The calls of the package against the program itself.

Goal: the tables are those of the program, to the bit; errors have their parts; nothing is left behind.
Oracle: the files and the exit codes of the program called directly. Tolerance: none for values.
"""

from __future__ import annotations

import csv
import json
import math
import subprocess
import time
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import viscotack as vt

from .conftest import REPOSITORY, SLIDING


def program(folder: Path, *arguments: str) -> str:
    """What the program prints."""
    command = [str(vt.program()), *arguments]
    return subprocess.run(command, cwd=folder, check=True, capture_output=True, encoding="utf-8").stdout


def test_tables_are_those_of_the_program(sliding: Path) -> None:
    """Values, errors, units, and words, of states and of fields."""
    program(sliding.parent, "run", "sliding.toml", "--out", "DIR", "--set", 'sliding.speed="2 mm/s"')
    result = vt.run(sliding, {"sliding.speed": "2 mm/s"})
    for frame, name in ((result.states, "states.csv"), (result.fields, "fields.csv")):
        assert frame is not None
        with (sliding.parent / "DIR" / name).open(encoding="utf-8", newline="") as file:
            header, *rows = list(csv.reader(file))
        assert len(frame) == len(rows) > 0
        for place, head in enumerate(header):
            column, _, unit = head.partition(" [")
            assert frame.columns[place] == column
            if unit:
                assert frame.attrs["units"][column] == unit.rstrip("]")
            for cell, row in zip(frame[column], rows, strict=True):
                expected = row[place]
                assert (expected == "" and pd.isna(cell)) or str(cell) == expected or float(cell) == float(expected)
    columns = list(result.states.columns)
    assert columns.index("friction_coefficient_error") == columns.index("friction_coefficient") + 1
    assert result.states["speed"].iloc[0] == 2e-3
    assert "friction" in result.states.attrs["meanings"]["friction_coefficient"].lower()
    assert result.path is None
    assert result.exit_code == 0
    assert (
        result.summary["provenance"]["scene_sha256"]
        == json.loads((sliding.parent / "DIR/summary.json").read_text(encoding="utf-8"))["provenance"]["scene_sha256"]
    )


def test_a_dictionary_is_a_scene(sliding: Path) -> None:
    """A template, changed, and a file as a dictionary give what their texts give."""
    content = vt.scene(sliding)
    content["sliding"]["speed"] = "2 mm/s"
    of_dictionary = vt.run(content, plots=False).states
    of_file = vt.run(sliding, {"sliding.speed": "2 mm/s"}, plots=False).states
    pd.testing.assert_frame_equal(of_dictionary, of_file, check_exact=True)
    assert {"sliding", "crack", "indentation"} <= set(vt.problems())
    template = vt.scene("sliding")
    del template["sweep"]
    template["sliding"]["speed"] = np.float64(1e-3)
    result = vt.run(template, plots=False)
    assert set(result.states["status"]) == {"solved"}
    assert vt.explain(template)["problem"] == "steady sliding"
    assert vt.schema()["type"] == "object"


def test_the_schema_is_one_and_knows_scenes() -> None:
    """A validator of JSON Schema that is not ours: every template and shipped scene is valid, a wrong key or a wrong kind is not."""
    # It comes with what executes notebooks.
    jsonschema = pytest.importorskip("jsonschema")
    jsonschema.Draft202012Validator.check_schema(vt.schema())
    validator = jsonschema.Draft202012Validator(vt.schema())
    scenes = [vt.scene(problem) for problem in vt.problems()] + [vt.scene(path) for path in sorted(REPOSITORY.glob("scenes/**/*.toml"))]
    assert len(scenes) > 40
    for scene in scenes:
        assert [error.message for error in validator.iter_errors(scene)] == [], scene.get("title")
    scene = vt.scene("sliding")
    for wrong in ({"speeed": 1}, {"speed": [1]}, {"contacts": ["sticky"]}):
        broken = {**scene, "sliding": {**scene["sliding"], **wrong}}
        assert len(list(validator.iter_errors(broken))) == 1, wrong


def test_a_history_has_its_path() -> None:
    """Rows on the way of a state, a dictionary whose material lies in a file."""
    scene = vt.scene("pull-off-test")
    result = vt.run(scene, {"accuracy": 1e-2, "indentation.instants": 4}, plots=False)
    assert result.path is not None
    assert len(result.path) > len(result.states) >= 1
    assert "pull_off_force" in result.states


def test_a_sweep_of_any_length(crack: Path) -> None:
    """Values through arguments and, where they are too long for them, through standard input; two keys; a range."""
    short = np.geomspace(1e-6, 1e-1, 5)
    long = np.geomspace(1e-6, 1e-1, 3000)
    few = vt.sweep(crack, {"crack.speed": short}, plots=False).states
    many = vt.sweep(crack, {"crack.speed": long}, plots=False).states
    assert few["crack.speed"].tolist() == short.tolist()
    assert many["crack.speed"].tolist() == long.tolist()
    assert many["energy_release_rate"].iloc[0] == few["energy_release_rate"].iloc[0]
    both = vt.sweep(crack, {"crack.speed": ["1 mm/s", "2 mm/s"], "adhesion.work_of_adhesion": {"from": 1, "to": 2, "points": 3}}, plots=False).states
    assert len(both) == 6
    assert both["crack.speed"].tolist() == [1e-3] * 3 + [2e-3] * 3


def test_errors_have_their_parts(sliding: Path) -> None:
    """Key, file, line, column and remedy of a wrong scene; the machine; a program that is not there."""
    text = SLIDING.replace("mean_pressure", "mean_presure")
    sliding.write_text(text, encoding="utf-8")
    with pytest.raises(vt.SceneError) as caught:
        vt.run(sliding)
    error = caught.value
    assert error.key is not None
    assert "mean_presure" in error.key
    assert error.file is not None
    assert Path(error.file).name == "sliding.toml"
    assert error.line == text[: text.index("mean_presure")].count("\n") + 1
    assert error.column == 1
    assert "mean_pressure" in str(error)
    assert error.exit_code == 2
    with pytest.raises(vt.SceneError, match="sliding"):
        vt.scene("slidng")
    with pytest.raises(vt.SceneError, match="cannot be read"):
        vt.run(sliding.parent / "nothing.toml")
    with pytest.raises(vt.SceneError, match=r"sliding\.speed"):
        vt.run(vt.scene("sliding"), {"sliding.speed": "1 MPa"})


def test_an_installation_without_the_program(monkeypatch: pytest.MonkeyPatch, sliding: Path) -> None:
    """The exception says what to do."""
    monkeypatch.setenv("VISCOTACK_PROGRAM", str(sliding.parent / "none"))
    with pytest.raises(vt.ProgramNotFoundError, match="none"):
        vt.run(sliding)


def test_a_state_that_does_not_exist(sliding: Path) -> None:
    """An exception with the rows and the limit; in a sweep, rows among others."""
    with pytest.raises(vt.NoSuchStateError, match="pulls harder") as caught:
        vt.run(sliding, {"sliding.mean_pressure": -9e5})
    result = caught.value.result
    assert result is not None
    assert result.states["status"].tolist() == ["no_such_state"]
    states = vt.sweep(sliding, {"sliding.mean_pressure": [-9e5, 6e3]}, plots=False).states
    assert states["status"].tolist() == ["no_such_state", "solved"]


def test_values_that_miss_the_accuracy_warn() -> None:
    """Exit code 4 is a warning, and the values are there."""
    scene = vt.scene(REPOSITORY / "scenes/sliding/two_works.toml")
    scene.pop("sweep", None)
    scene.pop("plots", None)
    with pytest.warns(vt.AccuracyWarning):
        result = vt.run(scene, {"accuracy": 1e-15}, plots=False)
    assert "inaccurate" in result.states["status"].tolist()
    assert result.exit_code == 4


def test_a_named_folder_stays_and_another_does_not(sliding: Path) -> None:
    """Files live as long as the result; those of a named folder for ever, and are not replaced unasked."""
    result = vt.run(sliding)
    folder = result.folder
    assert (folder / "states.csv").exists()
    del result
    assert not folder.exists()
    kept = sliding.parent / "kept"
    vt.run(sliding, out=kept)
    assert (kept / "summary.json").exists()
    with pytest.raises(vt.SceneError, match="exists already"):
        vt.run(sliding, out=kept)
    vt.run(sliding, out=kept, force=True)


def test_notebooks_show_tables_and_plots(sliding: Path) -> None:
    """HTML with value ± error and unit, SVG of each plot."""
    result = vt.sweep(sliding, {"sliding.speed": [1e-4, 1e-3, 1e-2]})
    html = result._repr_html_()
    assert "± " in html
    assert "[m/s]" in html
    assert "<svg" in html
    svg = result._repr_svg_()
    assert svg is not None
    assert "<svg" in svg
    assert len(result.plots) >= 3
    assert "3 states: 3 solved" in repr(result)
    plot = next(iter(result.plots.values()))
    plot.save(sliding.parent / "plot.svg")
    assert plot._repr_svg_() == (sliding.parent / "plot.svg").read_text(encoding="utf-8")


def test_progress_is_counted(sliding: Path) -> None:
    """A function receives how many states are finished; it rises, and ends with all of them."""
    seen: list[tuple[int, int]] = []
    vt.sweep(sliding, {"sliding.speed": {"from": 1e-5, "to": 1, "points": 1000}}, progress=lambda done, of: seen.append((done, of)), jobs=1)
    assert len(seen) > 1
    assert seen[-1] == (1000, 1000)
    assert all(of == 1000 for _, of in seen)
    assert [done for done, _ in seen] == sorted(done for done, _ in seen)


def test_a_fit_and_a_material() -> None:
    """Values with their intervals, residuals, a scene that runs; terms of a table of measured moduli."""
    found = vt.fit(REPOSITORY / "scenes/fits/pull_off.toml", {"accuracy": 2e-2})
    row = found.values.loc["adhesion.work_of_adhesion"]
    # The data were made with 55 mJ/m².
    assert row["lower_95"] < 0.055 < row["upper_95"]
    assert row["unit"] == "J/m²"
    assert found.residuals is not None
    assert len(found.residuals) > 100
    assert found.scene["adhesion"]["work_of_adhesion"]
    assert "<table>" in found._repr_html_()
    tread = vt.material(REPOSITORY / "scenes/materials/tread.toml")
    assert tread.terms is not None
    assert np.isclose(tread.summary["relaxed_modulus"] + tread.terms["modulus"].sum(), tread.summary["glassy_modulus"])
    assert tread.material["relaxation"]
    assert tread.moduli is not None
    assert tread.moduli.attrs["units"]["storage_modulus"] == "Pa"


def test_a_small_run_costs_little_more_than_the_program(crack: Path) -> None:
    """At most 30 ms more than the same command: the least times of turns, which other work of the machine makes no shorter."""
    count = iter(range(1000))
    alone, called = math.inf, math.inf
    for _ in range(15):
        begun = time.perf_counter()
        program(crack.parent, "run", "crack.toml", "--no-plots", "--out", f"D{next(count)}")
        between = time.perf_counter()
        assert len(vt.run(crack, plots=False).states) == 1
        alone, called = min(alone, between - begun), min(called, time.perf_counter() - between)
    print(f"program {1e3 * alone:.1f} ms, called {1e3 * called:.1f} ms")
    assert called - alone < 0.03


def test_a_long_sweep_costs_little_beside_the_program(crack: Path) -> None:
    """10,000 states in one call: at most 10 µs a state of this process's own processor time, which nobody else's work counts in."""
    speeds = np.geomspace(1e-6, 1e-1, 10_000)
    own = math.inf
    for _ in range(3):
        begun = time.process_time()
        states = vt.sweep(crack, {"crack.speed": speeds}, plots=False).states
        own = min(own, time.process_time() - begun)
        assert states["crack.speed"].tolist() == speeds.tolist()
        assert (states["status"] == "solved").all()
    print(f"{1e3 * own:.0f} ms in Python")
    assert own < 0.1
