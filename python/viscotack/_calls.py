"""The calls: each is a command of the program."""

from __future__ import annotations

import json
import os
import tomllib
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from . import _toml
from ._errors import AccuracyWarning, NoSuchStateError, from_program
from ._program import NotebookProgress, Progress, call, in_notebook
from ._results import FitResult, Folder, MaterialResult, Result

Scene = str | os.PathLike[str] | Mapping[str, Any]
"""A scene: the path of a TOML file, or a dictionary with the same tables. Paths in a dictionary start at the working folder."""

# On Linux no argument of a command may have more than 131,072 bytes; on Windows all together 32,767 characters.
_LONGEST_ARGUMENT = 10_000


def run(
    scene: Scene,
    overrides: Mapping[str, Any] | None = None,
    *,
    out: str | os.PathLike[str] | None = None,
    force: bool = False,
    jobs: int | None = None,
    plots: bool = True,
    progress: bool | Progress | None = None,
) -> Result:
    """Solves a scene, a state or a sweep.

    Args:
        scene: a path, or a dictionary as `scene()` gives it.
        overrides: values by dotted keys, such as `{"sliding.speed": "1 mm/s"}`.
        out: a folder to keep the files in; an interrupted run goes on there when it is called again. Without it they live as long as the result.
        force: replace the folder if it exists.
        jobs: threads; without it, one a core.
        plots: whether plots are drawn.
        progress: a function of the finished and of all states; True or False: a line in the notebook or none. Without it, a line in notebooks only.

    Raises:
        SceneError: the scene is wrong; the exception says which key, which line, and what is allowed.
        NoSuchStateError: there is no such state; its `result` has the rows with the reason.
        MachineError: the machine refuses.

    Warns:
        AccuracyWarning: some values are less accurate than the scene asks for.
    """
    given = _given(scene, overrides or {})
    folder = _place(out)
    options = ["run", *given.arguments, "--out", str(folder.path)]
    options += ["--force"] if force else []
    options += [] if plots else ["--no-plots"]
    options += [] if jobs is None else ["--jobs", str(jobs)]
    shown = _progress(progress)
    journal = Path(f"{folder.path}.partial") / "journal.jsonl"
    answer = call(options, text=given.text, folder=given.folder, good=(0, 2, 3, 4), progress=shown, journal=journal)
    # 2 is also the code of a scene that could not be read: then nothing was written.
    if '"message"' in answer.stderr or not (folder.path / "summary.json").exists():
        raise from_program(answer.returncode, answer.stderr)
    result = Result(folder, answer.returncode)
    if answer.returncode in (2, 3):
        reasons = [reason for reason in result.states.get("reason", []) if isinstance(reason, str)]
        error = NoSuchStateError(reasons[0] if reasons else "no such state exists", exit_code=answer.returncode)
        error.result = result
        raise error
    if answer.returncode == 4:
        warnings.warn("some values are less accurate than the scene asks for: see `status` and the errors", AccuracyWarning, stacklevel=2)
    return result


def sweep(
    scene: Scene,
    values: Mapping[str, Any],
    overrides: Mapping[str, Any] | None = None,
    **options: Any,
) -> Result:
    """Solves a scene for many values of one or several keys, in one call of the program.

    Args:
        scene: as of `run`; its own sweep is replaced.
        values: by key a list or an array of values, or `{"from": …, "to": …, "points": …}` with `"spacing": "linear"` if wanted. Several keys are
            combined, the last varies fastest.
        overrides: as of `run`.
        options: those of `run`.
    """
    tables = []
    for key, given in values.items():
        table: dict[str, Any] = {"key": key}
        table.update(given if isinstance(given, Mapping) else {"values": given})
        tables.append(table)
    return run(scene, {**(overrides or {}), "sweep": tables}, **options)


def fit(
    scene: Scene,
    overrides: Mapping[str, Any] | None = None,
    *,
    models: bool = False,
    plan: bool = False,
    out: str | os.PathLike[str] | None = None,
    force: bool = False,
    jobs: int | None = None,
) -> FitResult:
    """Finds numbers of a scene from measured curves, as its table [fit] says.

    `models` compares the simpler models that the scene contains; `plan` says which further test would shrink the intervals most.
    """
    given = _given(scene, overrides or {})
    folder = _place(out)
    options = ["fit", *given.arguments, "--out", str(folder.path)]
    options += ["--force"] if force else []
    options += ["--models"] if models else []
    options += ["--plan"] if plan else []
    options += [] if jobs is None else ["--jobs", str(jobs)]
    answer = call(options, text=given.text, folder=given.folder, good=(0, 4))
    if answer.returncode == 4:
        warnings.warn("the fit is not sound: see `summary`", AccuracyWarning, stacklevel=2)
    return FitResult(folder, answer.returncode)


def material(
    file: str | os.PathLike[str],
    overrides: Mapping[str, Any] | None = None,
    *,
    accuracy: float | None = None,
    out: str | os.PathLike[str] | None = None,
    force: bool = False,
) -> MaterialResult:
    """Fits a material to a table of measured moduli (CSV), or expands that of a TOML file: terms, curves, plots, a table for scenes."""
    folder = _place(out)
    options = ["material", os.fspath(file), *_sets({key: _toml.value(item) for key, item in (overrides or {}).items()}), "--out", str(folder.path)]
    options += ["--force"] if force else []
    options += [] if accuracy is None else ["--accuracy", repr(float(accuracy))]
    answer = call(options, good=(0, 4))
    if answer.returncode == 4:
        warnings.warn("the fit misses the wanted accuracy: see `summary`", AccuracyWarning, stacklevel=2)
    return MaterialResult(folder, answer.returncode)


def explain(scene: Scene, overrides: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """What a scene simulates and leaves out, by which method, at what cost; solves nothing."""
    given = _given(scene, overrides or {})
    answer: dict[str, Any] = json.loads(call(["explain", *given.arguments, "--json"], text=given.text, folder=given.folder).stdout)
    return answer


def scene(problem: str | os.PathLike[str]) -> dict[str, Any]:
    """The scene of a template (see `problems`) or of a file, as a dictionary to change and to run.

    Paths in a scene start at its own folder; those of a dictionary start at the working folder.
    """
    if isinstance(problem, str) and problem in problems():
        return tomllib.loads(call(["new", problem]).stdout)
    path = Path(problem)
    if path.suffix == ".toml":
        return tomllib.loads(path.read_text(encoding="utf-8"))
    return tomllib.loads(call(["new", str(problem)]).stdout)


def problems() -> list[str]:
    """The problems that have a template."""
    lines = call(["new"]).stdout.splitlines()[1:]
    return [line.split()[0] for line in lines if line.startswith("  ")]


def schema() -> dict[str, Any]:
    """The JSON schema of a scene."""
    answer: dict[str, Any] = json.loads(call(["schema"]).stdout)
    return answer


@dataclass(frozen=True)
class _Given:
    """How the program is given a scene: as a file, or as a text on its standard input, in the folder where paths in it start."""

    arguments: list[str]
    text: str | None = None
    folder: str | None = None


def _given(scene: Scene, overrides: Mapping[str, Any]) -> _Given:
    texts = {key: _toml.value(item) for key, item in overrides.items()}
    long = [key for key, text in texts.items() if len(text) > _LONGEST_ARGUMENT]
    sets = _sets({key: text for key, text in texts.items() if key not in long})
    if isinstance(scene, Mapping):
        content, folder = dict(scene), None
    elif long:
        path = Path(scene)
        content, folder = tomllib.loads(path.read_text(encoding="utf-8")), str(path.parent)
        content.setdefault("title", path.stem)
    else:
        return _Given([os.fspath(scene), *sets])
    for key in long:
        content = _put(content, key.split("."), overrides[key])
    return _Given(["-", *sets], _toml.document(content), folder)


def _put(node: Any, path: Sequence[str], item: Any) -> Any:
    """A copy of a tree with a value in one place; a number selects an item of a list."""
    if not path:
        return item
    head, *rest = path
    if isinstance(node, list):
        return [_put(inner, rest, item) if str(place) == head else inner for place, inner in enumerate(node)]
    table = dict(node) if isinstance(node, Mapping) else {}
    table[head] = _put(table.get(head), rest, item)
    return table


def _sets(texts: Mapping[str, str]) -> list[str]:
    """Values that are put into a scene, as arguments."""
    return [argument for key, text in texts.items() for argument in ("--set", f"{key}={text}")]


def _place(out: str | os.PathLike[str] | None) -> Folder:
    """The folder for the files of a call."""
    if out is not None:
        return Folder(Path(out).absolute(), None)
    keeper = TemporaryDirectory(prefix="viscotack-", ignore_cleanup_errors=True)
    return Folder(Path(keeper.name) / "result", keeper)


def _progress(wanted: bool | Progress | None) -> Progress | None:
    if callable(wanted):
        return wanted
    if wanted is None:
        wanted = in_notebook()
    return NotebookProgress() if wanted and in_notebook() else None
