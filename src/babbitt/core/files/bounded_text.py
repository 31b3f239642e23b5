"""TOML and JSON that others wrote, read within bounds.

The readers of the standard library recurse, and that of TOML takes a time that grows with the square of the
parts of a dotted key.
"""

from __future__ import annotations

import json
import re
import tomllib
from typing import Any

__all__ = ["DEEPEST", "loads_json", "loads_toml"]

DEEPEST = 20
"""Tables and lists of TOML within each other, and parts of a dotted key; the shipped tables need four."""

_TOO_DEEP = "nested too deeply"

# a text that does not end is taken to its end: the reader refuses it there
_TEXT_OR_COMMENT = re.compile(
    r'"""(?:[^\\]|\\.)*?(?:"""|\Z)|\'\'\'.*?(?:\'\'\'|\Z)|"(?:[^"\\\n]|\\.)*+"?|\'[^\'\n]*+\'?|#[^\n]*', re.DOTALL
)
_DOTTED = re.compile(rf"(?<![\w-])(?:[\w-]++\s*+\.\s*+){{{DEEPEST}}}[\w-]")


def loads_toml(text: str) -> dict[str, Any]:
    """Read TOML whose nesting is bounded, in a time that grows with its length.

    Parameters
    ----------
    text : str

    Returns
    -------
    dict

    Raises
    ------
    ValueError
        When it is no TOML (`tomllib.TOMLDecodeError`), or nests deeper than `DEEPEST`.

    Examples
    --------
    >>> loads_toml("a.b = [1, 2]")
    {'a': {'b': [1, 2]}}
    >>> loads_toml("a = " + "[" * 5000)
    Traceback (most recent call last):
    ValueError: nested too deeply; allowed: at most 20 levels
    """
    plain = _TEXT_OR_COMMENT.sub("x", text)
    depth = deepest = 0
    for letter in plain:
        if letter in "[{":
            depth += 1
            deepest = max(deepest, depth)
        elif letter in "]}":
            depth -= 1
    if deepest > DEEPEST or _DOTTED.search(plain):
        raise ValueError(f"{_TOO_DEEP}; allowed: at most {DEEPEST} levels")
    return tomllib.loads(text)


def loads_json(text: str) -> Any:
    """Read JSON.

    Raises
    ------
    ValueError
        When it is no JSON, or nests deeper than its reader can follow.

    Examples
    --------
    >>> loads_json("[" * 200_000)
    Traceback (most recent call last):
    ValueError: nested too deeply
    """
    try:
        return json.loads(text)
    except RecursionError:
        raise ValueError(_TOO_DEEP) from None
