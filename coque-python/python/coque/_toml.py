"""Scenes of Python's own values as text, in the order in which they were given."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

_BARE = re.compile(r"[A-Za-z0-9_-]+\Z")
# What dictionaries hold at most, one within another; the reader refuses deeper tables as well.
_DEEPEST = 60


def text(scene: Mapping[str, Any]) -> str:
    """A scene as TOML: a line for each innermost table."""
    return "".join(f"{line}\n" for line in _lines((), scene, 0))


def value(given: Any, depth: int = 0) -> str:
    """One value, on one line."""
    if depth > _DEEPEST:
        raise ValueError("the scene is nested too deeply, or holds itself")
    if isinstance(given, np.ndarray) or isinstance(given, np.generic):
        given = given.tolist()
    if isinstance(given, bool):
        return "true" if given else "false"
    if isinstance(given, int):
        return str(int(given))
    if isinstance(given, float):
        # The shortest digits that read back to the same bits.
        return repr(float(given))
    if isinstance(given, str):
        return _string(given)
    if isinstance(given, Mapping):
        inner = ", ".join(f"{_key(k)} = {value(v, depth + 1)}" for k, v in given.items() if v is not None)
        return f"{{ {inner} }}" if inner else "{}"
    if isinstance(given, Sequence) and not isinstance(given, (bytes, bytearray)):
        return f"[{', '.join(value(item, depth + 1) for item in given)}]"
    raise TypeError(f"a scene holds numbers, words, lists and tables, no {type(given).__name__}: {given!r}")


def _lines(path: tuple[str, ...], table: Mapping[str, Any], depth: int) -> list[str]:
    """A line for each value and for each table that holds no further one."""
    if depth > _DEEPEST:
        raise ValueError("the scene is nested too deeply, or holds itself")
    lines: list[str] = []
    for key, given in table.items():
        if given is None:
            continue
        here = (*path, _key(key))
        if isinstance(given, Mapping) and any(isinstance(inner, Mapping) for inner in given.values()):
            lines += _lines(here, given, depth + 1)
        else:
            lines.append(f"{'.'.join(here)} = {value(given)}")
    return lines


def _key(key: Any) -> str:
    if not isinstance(key, str):
        raise TypeError(f"keys of a scene are words, not {key!r}")
    return key if _BARE.match(key) else _string(key)


def _string(given: str) -> str:
    # Both have the same escapes but for one character.
    return json.dumps(given, ensure_ascii=False).replace("\x7f", "\\u007f")
