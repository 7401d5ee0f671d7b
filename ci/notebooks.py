"""Executes the notebooks of python/notebooks, each in a kernel of its own: an error in a cell is a failure.

python ci/notebooks.py                     all of them
python ci/notebooks.py --render DIR        and writes them as HTML pages, with their plots, to a folder (needs nbconvert)

The package must be installed in this Python (`pip install ".[notebooks]"`).
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

ROOT = Path(__file__).resolve().parents[1]


def main() -> int:
    """Executes all notebooks."""
    parser = argparse.ArgumentParser()
    parser.add_argument("names", nargs="*", help="notebooks; without any, all")
    parser.add_argument("--render", type=Path, metavar="DIR")
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
        if given.render is not None:
            from nbconvert import HTMLExporter

            given.render.mkdir(parents=True, exist_ok=True)
            (given.render / f"{path.stem}.html").write_text(HTMLExporter().from_notebook_node(book)[0], encoding="utf-8")
    return 1 if failed or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
