"""Python values as TOML.

Goal: what is written reads back as the same value. Oracle: the reader of the standard library. Tolerance: none.
"""

from __future__ import annotations

import math
import random
import tomllib
from typing import Any

import numpy as np
import pytest
from viscotack import _toml

from .conftest import REPOSITORY


def drawn(random_: random.Random, depth: int) -> Any:
    """A value of any kind."""
    kind = random_.randrange(7 if depth else 4)
    if kind == 0:
        return random_.choice([0, -3, 10**15, True, False])
    if kind == 1:
        return random_.choice([0.1, -1e-300, 1.7976931348623157e308, 5e-324, random_.uniform(-1, 1), math.inf])
    if kind in (2, 3):
        return "".join(random_.choice("aµ√ \"\\'\n\t\x7f\x01#=[]{}é😀") for _ in range(random_.randrange(8)))
    if kind in (4, 5):
        return {drawn_key(random_): drawn(random_, depth - 1) for _ in range(random_.randrange(4))}
    return [drawn(random_, depth - 1) for _ in range(random_.randrange(4))]


def drawn_key(random_: random.Random) -> str:
    """A key, some of which must be quoted."""
    return random_.choice(["speed", "work_of_adhesion", "a b", "µ", 'quo"te', "", "1"])


def test_what_is_written_reads_back_as_the_same() -> None:
    """Values of any kind, in documents and on one line."""
    random_ = random.Random(17)
    for _ in range(500):
        scene = {drawn_key(random_): drawn(random_, 3) for _ in range(4)}
        assert tomllib.loads(_toml.document(scene)) == scene
        assert tomllib.loads(f"x = {_toml.value(scene)}")["x"] == scene


def test_arrays_and_numbers_of_numpy_are_written() -> None:
    """Arrays and scalars; the digits are those of the double."""
    values = np.geomspace(1e-9, 1, 7)
    assert tomllib.loads(f"x = {_toml.value(values)}")["x"] == values.tolist()
    assert tomllib.loads(f"x = {_toml.value(np.float64(0.1))}")["x"] == 0.1
    assert tomllib.loads(f"x = {_toml.value(list(values))}")["x"] == values.tolist()
    assert _toml.value([math.inf, -math.inf, math.nan, -0.0, 1e22]) == "[inf, -inf, nan, -0.0, 1e+22]"
    assert str(tomllib.loads(f"x = {_toml.value([math.inf, -math.inf, math.nan, -0.0, 1e22])}")["x"]) == "[inf, -inf, nan, -0.0, 1e+22]"
    assert tomllib.loads(f"x = {_toml.value(np.int32(3))}")["x"] == 3
    with pytest.raises(TypeError, match="no place in a scene"):
        _toml.value(object())


def test_every_scene_of_the_repository_survives() -> None:
    """As dictionaries and back."""
    paths = sorted(REPOSITORY.glob("scenes/**/*.toml"))
    assert len(paths) > 30
    for path in paths:
        content = tomllib.loads(path.read_text(encoding="utf-8"))
        assert tomllib.loads(_toml.document(content)) == content, path
