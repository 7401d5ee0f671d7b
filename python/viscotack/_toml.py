"""Python values as TOML, for scenes that are dictionaries and for values that are put into a scene."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from typing import Any

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def value(item: Any) -> str:
    """One value on one line: texts, numbers, flags, lists, tables; arrays and numbers of NumPy, too."""
    if hasattr(item, "tolist"):
        item = item.tolist()
    if isinstance(item, bool):
        return "true" if item else "false"
    if isinstance(item, int):
        return str(item)
    if isinstance(item, float):
        return repr(item)
    if isinstance(item, str):
        return _text(item)
    if isinstance(item, Mapping):
        return "{ " + ", ".join(f"{_key(str(key))} = {value(inner)}" for key, inner in item.items()) + " }" if item else "{}"
    if isinstance(item, list) and all(type(inner) is float for inner in item):
        # Sweeps have thousands of them; Python writes a list of numbers as TOML does.
        return repr(item)
    if isinstance(item, Sequence):
        return "[" + ", ".join(value(inner) for inner in item) + "]"
    raise TypeError(f"a {type(item).__name__} has no place in a scene: use numbers, texts with units, flags, lists and dictionaries")


def document(scene: Mapping[str, Any]) -> str:
    """A whole scene as text, with a header for each table, as people write it."""
    lines: list[str] = []
    _table(scene, "", lines)
    return "\n".join(lines) + "\n"


def _table(table: Mapping[str, Any], path: str, lines: list[str]) -> None:
    later: list[tuple[str, Any]] = []
    for key, item in table.items():
        name = _key(str(key))
        if isinstance(item, Mapping) or _is_tables(item, path):
            later.append((f"{path}.{name}" if path else name, item))
        else:
            lines.append(f"{name} = {value(item)}")
    for name, item in later:
        if isinstance(item, Mapping):
            lines.extend(["", f"[{name}]"])
            _table(item, name, lines)
        else:
            for entry in item:
                lines.extend(["", f"[[{name}]]"])
                _table(entry, name, lines)


def _is_tables(item: Any, path: str) -> bool:
    """Whether a list at the top of a scene is written as one header for each of its tables."""
    is_list = isinstance(item, Sequence) and not isinstance(item, str)
    return path == "" and is_list and len(item) > 0 and all(isinstance(entry, Mapping) for entry in item)


def _key(key: str) -> str:
    return key if _BARE.fullmatch(key) else _text(key)


def _text(text: str) -> str:
    # The escapes of JSON are escapes of TOML, but for the character 127.
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007F")
