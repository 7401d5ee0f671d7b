"""What can go wrong, as exceptions."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._results import Result


class ViscotackError(Exception):
    """The program ended with an error.

    `str(error)` is what the program writes for people; the parts are attributes.
    """

    def __init__(
        self,
        text: str,
        *,
        message: str | None = None,
        key: str | None = None,
        file: str | None = None,
        line: int | None = None,
        column: int | None = None,
        remedy: str | None = None,
        exit_code: int | None = None,
    ) -> None:
        """Keeps the text and its parts."""
        super().__init__(text.strip())
        self.message = message if message is not None else text.strip()
        self.key = key
        self.file = file
        self.line = line
        self.column = column
        self.remedy = remedy
        self.exit_code = exit_code


class SceneError(ViscotackError):
    """The scene or the call is wrong: the attributes say which key, in which line, and what is allowed."""


class MachineError(ViscotackError):
    """The machine refuses: a full disk, no permission, or the program died."""


class NoSuchStateError(ViscotackError):
    """The scene asks for a state that does not exist; `result` holds its rows, with the limit that was passed."""

    result: Result | None = None


class ProgramNotFoundError(ViscotackError):
    """There is no program `viscotack`."""


class AccuracyWarning(UserWarning):
    """Some values are not as accurate as the scene asks for; their errors say how accurate they are."""


def from_program(exit_code: int, stderr: str) -> ViscotackError:
    """The exception for what the program wrote to standard error."""
    kind = SceneError if exit_code == 2 else MachineError
    for line in reversed(stderr.splitlines()):
        if not line.startswith("{"):
            continue
        try:
            parts = json.loads(line)
        except json.JSONDecodeError:
            continue
        return kind(
            parts["text"],
            message=parts["message"],
            key=parts.get("key"),
            file=parts.get("file"),
            line=parts.get("line"),
            column=parts.get("column"),
            remedy=parts.get("remedy"),
            exit_code=exit_code,
        )
    if exit_code < 0:
        return MachineError(f"the program was ended by signal {-exit_code}\n{stderr}", exit_code=exit_code)
    return kind(stderr or f"the program ended with {exit_code} and said nothing", exit_code=exit_code)
