"""Executes the notebooks of python/notebooks, each in a kernel of its own: an error in a cell is a failure.

python ci/notebooks.py                     all of them
python ci/notebooks.py --render            and writes each as a page of the documentation, docs/src/notebooks/NAME.md, with its plots beside it

Without --render the pages must hold the cells of the notebooks as they are. The package must be installed in this Python (`pip install ".[notebooks]"`).
"""

from __future__ import annotations

import argparse
import base64
import os
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


def source(cell: NotebookNode) -> str:
    """A cell as a page shows it."""
    return f"```python\n{cell.source}\n```\n" if cell.cell_type == "code" else f"{cell.source}\n"


def output(page: str, number: int, result: NotebookNode) -> str:
    """What a cell gave: a plot as a file beside the page, a table as Markdown or text."""
    data = result.get("data", {})
    if "image/png" in data:
        picture = f"{page}_{number}.png"
        (PAGES / picture).write_bytes(base64.b64decode(data["image/png"]))
        return f"![plot {number} of this notebook]({picture})\n"
    text = data.get("text/plain", result.get("text", ""))
    return f"```text\n{text.rstrip()}\n```\n" if text.strip() else ""


def rendered(page: str, book: NotebookNode) -> str:
    """A notebook that has been executed, as a page."""
    parts, number = [HEAD.format(name=page)], 0
    for cell in book.cells:
        parts.append(source(cell))
        for result in cell.get("outputs", []):
            number += 1
            parts.append(output(page, number, result))
    return "\n".join(part for part in parts if part)


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
        if given.render:
            PAGES.mkdir(exist_ok=True)
            page.write_text(rendered(path.stem, book), encoding="utf-8")
        else:
            text = page.read_text(encoding="utf-8")
            old = [cell for cell in book.cells if source(cell) not in text]
            if old:
                failed += 1
                print(f"{page}: older than its notebook, run ci/notebooks.py --render; not in it:\n{old[0].source}", file=sys.stderr)
    return 1 if failed or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
