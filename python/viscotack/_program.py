"""Where the program is, and how it is called."""

from __future__ import annotations

import functools
import os
import shutil
import subprocess
import sys
import sysconfig
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path

from ._errors import ProgramNotFoundError, from_program

Progress = Callable[[int, int], None]
"""Receives how many states are finished, and how many there are."""

_NAME = "viscotack" + (sysconfig.get_config_var("EXE") or "")
_POLL = 0.2


def program() -> Path:
    """The program that is called: that of `VISCOTACK_PROGRAM`, else of this installation, else of the search path."""
    chosen = os.environ.get("VISCOTACK_PROGRAM")
    return Path(chosen) if chosen else _installed()


@functools.cache
def _installed() -> Path:
    folders = [sysconfig.get_path("scripts"), sysconfig.get_path("scripts", scheme=sysconfig.get_preferred_scheme("user"))]
    # `pip install --target` puts the program beside the package.
    folders.append(str(Path(__file__).parent.parent / "bin"))
    for folder in folders:
        path = Path(folder) / _NAME
        if path.is_file():
            return path
    found = shutil.which("viscotack")
    if found is None:
        raise ProgramNotFoundError("the program `viscotack` is not there: `pip install .` in its repository installs it, or name it in VISCOTACK_PROGRAM")
    return Path(found)


def version() -> str:
    """Version and commit of the program."""
    return call(["--version"]).stdout.strip()


def call(
    arguments: Sequence[str],
    *,
    text: str | None = None,
    folder: str | None = None,
    good: Sequence[int] = (0,),
    progress: Progress | None = None,
    journal: Path | None = None,
) -> subprocess.CompletedProcess[str]:
    """Calls the program; `text` goes to its standard input. An exit code that is not good is an exception."""
    command = [str(program()), "--errors=json", *arguments]
    try:
        process = subprocess.Popen(
            command,
            cwd=folder,
            stdin=subprocess.PIPE if text is not None else subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            encoding="utf-8",
            errors="replace",
        )
    except OSError as error:
        raise ProgramNotFoundError(f"`{command[0]}` cannot be started: {error}") from error
    ended = threading.Event()
    watcher = None
    total: list[int] = []
    if progress is not None and journal is not None:
        watcher = threading.Thread(target=_watch, args=(journal, progress, ended, total), daemon=True)
        watcher.start()
    try:
        stdout, stderr = process.communicate(text)
    except BaseException:
        # An interrupted cell leaves no program behind. What is finished stays in DIR.partial, if a folder is named.
        process.terminate()
        process.wait()
        raise
    finally:
        ended.set()
        if watcher is not None:
            watcher.join()
    if process.returncode not in good:
        raise from_program(process.returncode, stderr)
    if progress is not None and total:
        progress(total[0], total[0])
    return subprocess.CompletedProcess(command, process.returncode, stdout, stderr)


def _watch(journal: Path, progress: Progress, ended: threading.Event, total: list[int]) -> None:
    """Counts the states in the journal of a run while it is under way: a line each, after a line that says how many there are."""
    from json import loads

    position, lines = 0, 0
    while not ended.wait(_POLL):
        try:
            with journal.open("rb") as file:
                file.seek(position)
                piece = file.read()
        except OSError:
            continue
        if not total:
            head, found, _ = piece.partition(b"\n")
            if not found:
                continue
            total.append(int(loads(head)[1]["states"]))
        position += len(piece)
        lines += piece.count(b"\n")
        progress(max(lines - 1, 0), total[0])


def in_notebook() -> bool:
    """Whether the code runs in a notebook's kernel."""
    shell = sys.modules.get("IPython")
    if shell is None:
        return False
    current = shell.get_ipython()
    return current is not None and "IPKernelApp" in getattr(current, "config", {})


class NotebookProgress:
    """One line below the cell that says how far a run is, from its first second on."""

    def __init__(self) -> None:
        """Nothing is shown yet."""
        self._begun = time.monotonic()
        self._handle: object | None = None

    def __call__(self, finished: int, total: int) -> None:
        """Shows how far the run is."""
        seconds = time.monotonic() - self._begun
        if total < 2 or (seconds < 1.0 and self._handle is None):
            return
        from IPython.display import display

        left = f", about {seconds * (total - finished) / finished:.0f} s left" if 0 < finished < total else ""
        words = {"text/plain": f"{finished} of {total} states{left}"}
        if self._handle is None:
            self._handle = display(words, raw=True, display_id=True)  # type: ignore[no-untyped-call]
        else:
            self._handle.update(words, raw=True)  # type: ignore[attr-defined]
