"""Executes the notebooks of python/notebooks, each in a kernel of its own: an error in a cell is a failure.

python ci/notebooks.py                     all of them
python ci/notebooks.py --render            and writes each as a page of the documentation, docs/src/notebooks/NAME.md, with its plots beside it

Without --render each page must be what its notebook gives now: cells and words as they are, numbers to four digits, plots by their places. The package must be
installed in this Python (`pip install ".[notebooks]"`).
"""

from __future__ import annotations

import argparse
import base64
import itertools
import math
import os
import re
import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from nbformat import NotebookNode

ROOT = Path(__file__).resolve().parents[1]
PAGES = ROOT / "docs/src/notebooks"
HEAD = "<!-- Made by `python ci/notebooks.py --render` from python/notebooks/{name}.ipynb: change that one. -->\n"


NUMBER = re.compile(r"[+-]?\d+(?:\.\d*)?(?:e[+-]?\d+)?")
# How far a run is depends on the clock.
PROGRESS = re.compile(r"\d+ of \d+ states.*")


def source(cell: NotebookNode) -> str:
    """A cell as a page shows it."""
    return f"```python\n{cell.source}\n```\n" if cell.cell_type == "code" else f"{cell.source}\n"


def rendered(name: str, book: NotebookNode) -> tuple[str, dict[str, bytes]]:
    """A notebook that has been executed, as a page with its pictures: tables as text, a plot as a file beside the page."""
    parts, pictures = [HEAD.format(name=name)], {}
    for cell in book.cells:
        parts.append(source(cell))
        for result in cell.get("outputs", []):
            data = result.get("data", {})
            text = data.get("text/plain", result.get("text", "")).rstrip()
            if "image/png" in data:
                picture = f"{name}_{len(pictures) + 1}.png"
                pictures[picture] = base64.b64decode(data["image/png"])
                parts.append(f"![plot {len(pictures)} of this notebook]({picture})\n")
            elif text and not PROGRESS.fullmatch(text):
                parts.append(f"```text\n{text}\n```\n")
    return "\n".join(parts), pictures


def same(old: str, new: str) -> bool:
    """Whether two lines have the same words, and the same numbers to four digits; another machine may round the last ones otherwise."""
    if NUMBER.sub("#", old).split() != NUMBER.sub("#", new).split():
        return False
    pairs = zip(NUMBER.findall(old), NUMBER.findall(new), strict=False)
    return all(math.isclose(float(one), float(other), rel_tol=1e-4, abs_tol=1e-7) for one, other in pairs)


def first_difference(old: str, new: str) -> str | None:
    """The first line of a new page that an old one does not have in this place."""
    before, after = old.splitlines(), new.splitlines()
    for number, (one, other) in enumerate(itertools.zip_longest(before, after, fillvalue=""), 1):
        if not same(one, other):
            return f"line {number}: {one!r} is now {other!r}"
    return None


def main() -> int:
    """Executes all notebooks."""
    parser = argparse.ArgumentParser()
    parser.add_argument("names", nargs="*", help="notebooks; without any, all")
    parser.add_argument("--render", action="store_true", help="write the pages")
    given = parser.parse_args()
    os.environ["VISCOTACK_SCENES"] = str(ROOT / "scenes")
    os.environ.setdefault("MPLBACKEND", "module://matplotlib_inline.backend_inline")
    failed = 0
    paths = [path for path in sorted((ROOT / "python/notebooks").glob("*.ipynb")) if not given.names or path.stem in given.names]
    for path in paths:
        begun = time.monotonic()
        book = nbformat.read(path, as_version=4)
        try:
            NotebookClient(book, timeout=300, kernel_name="python3").execute()
        except CellExecutionError as error:
            failed += 1
            print(f"{path.name}: FAILED\n{error}", file=sys.stderr)
            continue
        print(f"{path.name}: executed in {time.monotonic() - begun:.1f} s")
        page = PAGES / f"{path.stem}.md"
        text, pictures = rendered(path.stem, book)
        if given.render:
            PAGES.mkdir(exist_ok=True)
            for old in PAGES.glob(f"{path.stem}_*.png"):
                old.unlink()
            for picture, content in pictures.items():
                (PAGES / picture).write_bytes(content)
            page.write_text(text, encoding="utf-8")
        elif difference := first_difference(page.read_text(encoding="utf-8"), text):
            failed += 1
            print(f"{page.relative_to(ROOT)} is older than its notebook, run ci/notebooks.py --render: {difference}", file=sys.stderr)
    return 1 if failed or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
