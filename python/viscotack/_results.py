"""What calls give back: tables as data frames, and plots as SVG."""

from __future__ import annotations

import functools
import html
import json
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pandas as pd

_SHOWN_ROWS = 12
# The shortest text of a double is read back as the same double: from pandas 3 on by default.
_EXACT: dict[str, Any] = {} if int(pd.__version__.split(".")[0]) >= 3 else {"float_precision": "round_trip"}


@dataclass(frozen=True)
class Plot:
    """A plot that a notebook shows."""

    name: str
    svg: str

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: str | Path) -> None:
        """Writes the SVG to a file."""
        Path(path).write_text(self.svg, encoding="utf-8")


def read_table(path: Path, meanings: Mapping[str, str] | None = None) -> pd.DataFrame:
    """Reads a table of the program: the units go from the header to `attrs["units"]`, by column; the sentences to `attrs["meanings"]`.

    Each value stands beside its error bound: the columns `x` and `x_error`.
    """
    frame: pd.DataFrame = pd.read_csv(path, keep_default_na=False, na_values=[""], encoding="utf-8", **_EXACT)
    names: list[str] = []
    units: dict[str, str] = {}
    for header in frame.columns:
        name, bracket, unit = str(header).rpartition(" [")
        if bracket and unit.endswith("]"):
            units[name] = unit[:-1]
            names.append(name)
        else:
            names.append(str(header))
    frame.columns = pd.Index(names)
    frame.attrs["units"] = units
    if meanings:
        frame.attrs["meanings"] = {name: meanings[name] for name in names if name in meanings}
    return frame


def _before(path: Path, end: bytes) -> bytes:
    """What stands before a mark in a file: megabytes may follow it, which nobody reads."""
    head = b""
    with path.open("rb") as file:
        while end not in head and (piece := file.read(1 << 16)):
            head += piece
    return head.partition(end)[0]


class Folder:
    """A folder of files that the program wrote; one that nobody has named is deleted with the result."""

    def __init__(self, path: Path, keeper: TemporaryDirectory[str] | None) -> None:
        """Of a path, and what deletes it."""
        self.path = path
        self._keeper = keeper

    def table(self, name: str, meanings: Mapping[str, str] | None = None) -> pd.DataFrame | None:
        """A table, if the program wrote it."""
        path = self.path / name
        return read_table(path, meanings) if path.exists() else None

    def plots(self) -> dict[str, Plot]:
        """All plots, by name."""
        paths = sorted(self.path.glob("*.svg"))
        return {path.stem: Plot(path.stem, path.read_text(encoding="utf-8")) for path in paths}


class _WithFolder:
    """What all results share."""

    def __init__(self, folder: Folder, exit_code: int) -> None:
        """Of a folder of the program."""
        self._folder = folder
        self.exit_code = exit_code

    @property
    def folder(self) -> Path:
        """Where the files are, as long as this result lives; for ever if a folder was named."""
        return self._folder.path

    @functools.cached_property
    def plots(self) -> dict[str, Plot]:
        """The plots that the program drew, by name; a notebook shows each."""
        return self._folder.plots()

    def _summary_text(self) -> str:
        return (self._folder.path / "summary.json").read_text(encoding="utf-8")

    def _title(self) -> str:
        raise NotImplementedError

    def _main(self) -> pd.DataFrame:
        raise NotImplementedError

    def _repr_html_(self) -> str:
        parts = [f"<p><b>{html.escape(self._title())}</b></p>", html_table(self._main())]
        parts.extend(f"<div>{plot.svg}</div>" for plot in self.plots.values())
        return "\n".join(parts)

    def _repr_svg_(self) -> str | None:
        return next((plot.svg for plot in self.plots.values()), None)


class Result(_WithFolder):
    """What `run` and `sweep` give."""

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """Everything but the rows: effects, method, characteristic numbers, validity, work, provenance."""
        # The rows stand last in the file, under a key that begins a line; texts in it hold no line feeds.
        summary: dict[str, Any] = json.loads(_before(self._folder.path / "summary.json", b',\n  "results": [') + b"\n}")
        return summary

    @functools.cached_property
    def states(self) -> pd.DataFrame:
        """A row a state; each value beside its error bound, the units in `attrs["units"]`."""
        frame = self._folder.table("states.csv", self._meanings)
        return pd.DataFrame() if frame is None else frame

    @functools.cached_property
    def path(self) -> pd.DataFrame | None:
        """What lies on the way of the states, if the problem has a history."""
        return self._folder.table("path.csv", self._meanings)

    @functools.cached_property
    def fields(self) -> pd.DataFrame | None:
        """Fields, a row a place, if the scene has a table [fields]."""
        return self._folder.table("fields.csv")

    @property
    def validity(self) -> pd.DataFrame:
        """The model's assumptions against this scene."""
        return pd.DataFrame(self.summary["validity"])

    @functools.cached_property
    def _meanings(self) -> dict[str, str]:
        return {column["name"]: column["meaning"] for column in self.summary["columns"]}

    def _title(self) -> str:
        return str(self.summary["title"])

    def _main(self) -> pd.DataFrame:
        return self.states

    def __repr__(self) -> str:
        """The title and how the states ended."""
        states = self.summary["states"]
        ended = ", ".join(f"{count} {word}" for word, count in states.items() if word != "total" and count)
        return f"<viscotack result: {self._title()}; {states['total']} states: {ended}>"


class FitResult(_WithFolder):
    """What `fit` gives."""

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """All numbers of the fit."""
        summary: dict[str, Any] = json.loads(self._summary_text())
        return summary

    @functools.cached_property
    def values(self) -> pd.DataFrame:
        """A row a fitted number: value, unit, ends of its 95 % interval; an open end is NaN."""
        rows = []
        for parameter in self.summary["parameters"]:
            row = {"key": parameter["key"], "value": parameter["value"], "unit": parameter["unit"]}
            interval = parameter.get("interval_by_profile_95") or {}
            for end in ("lower", "upper"):
                found = interval.get(end)
                row[f"{end}_95"] = found["value"] if found and not found.get("open") else float("nan")
            rows.append(row)
        return pd.DataFrame(rows).set_index("key")

    @functools.cached_property
    def residuals(self) -> pd.DataFrame | None:
        """Data, model and residual, a row a measured number."""
        return self._folder.table("residuals.csv")

    @functools.cached_property
    def scene(self) -> dict[str, Any]:
        """The scene with the fitted values, as a dictionary that `run` takes."""
        return tomllib.loads((self.folder / "fitted.toml").read_text(encoding="utf-8"))

    def _title(self) -> str:
        return str(self.summary["title"])

    def _main(self) -> pd.DataFrame:
        return self.values

    def __repr__(self) -> str:
        """The title and the fitted values."""
        return f"<viscotack fit: {self._title()}>\n{self.values}"


class MaterialResult(_WithFolder):
    """What `material` gives."""

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """All numbers of the material."""
        summary: dict[str, Any] = json.loads(self._summary_text())
        return summary

    @functools.cached_property
    def terms(self) -> pd.DataFrame | None:
        """Relaxation and retardation terms."""
        return self._folder.table("terms.csv")

    @functools.cached_property
    def moduli(self) -> pd.DataFrame | None:
        """Storage and loss modulus over the frequency."""
        return self._folder.table("moduli.csv")

    @functools.cached_property
    def responses(self) -> pd.DataFrame | None:
        """Creep compliance and relaxation modulus over the time."""
        return self._folder.table("responses.csv")

    @functools.cached_property
    def data(self) -> pd.DataFrame | None:
        """The measured values that were fitted, beside what the material gives."""
        return self._folder.table("data.csv")

    @functools.cached_property
    def material(self) -> dict[str, Any]:
        """The table [material], for a scene that is a dictionary."""
        table: dict[str, Any] = tomllib.loads((self.folder / "material.toml").read_text(encoding="utf-8"))["material"]
        return table

    def _title(self) -> str:
        return str(self.summary["title"])

    def _main(self) -> pd.DataFrame:
        return pd.DataFrame() if self.terms is None else self.terms

    def __repr__(self) -> str:
        """The title and the ends of the modulus."""
        ends = f"E0 = {self.summary['relaxed_modulus']:.6g} Pa, E∞ = {self.summary['glassy_modulus']:.6g} Pa"
        return f"<viscotack material: {self._title()}; {ends}>"


def html_table(frame: pd.DataFrame) -> str:
    """A short table for notebooks: value ± error in one cell, the unit in the header, columns without any value left out."""
    units: Mapping[str, str] = frame.attrs.get("units", {})
    columns = [str(name) for name in frame.columns]
    shown = [name for name in columns if not name.endswith("_error") or name[: -len("_error")] not in columns]
    shown = [name for name in shown if not frame[name].isna().all()]
    head = frame.head(_SHOWN_ROWS)

    def label(name: str) -> str:
        unit = units.get(name)
        return html.escape(f"{name} [{unit}]" if unit and unit != "1" else name)

    def number(item: Any) -> str:
        return f"{item:.7g}" if isinstance(item, float) else str(item)

    def cell(row: Any, name: str) -> str:
        item = row[name]
        if pd.isna(item):
            return ""
        error = row.get(f"{name}_error")
        if error is None or pd.isna(error) or error == 0 or not isinstance(item, float):
            return html.escape(number(item))
        return html.escape(f"{number(item)} ± {error:.1g}")

    named = frame.index.name is not None
    lines = ["<table>", "<tr>"]
    lines.extend(f"<th>{name}</th>" for name in ([html.escape(str(frame.index.name))] if named else []) + [label(name) for name in shown])
    lines.append("</tr>")
    for index, row in head.iterrows():
        cells = ([html.escape(str(index))] if named else []) + [cell(row, name) for name in shown]
        lines.append("<tr>" + "".join(f"<td>{text}</td>" for text in cells) + "</tr>")
    lines.append("</table>")
    if len(frame) > len(head):
        lines.append(f"<p>{len(frame) - len(head)} more rows</p>")
    return "".join(lines)
