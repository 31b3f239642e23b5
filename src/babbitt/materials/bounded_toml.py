"""TOML that others wrote, read within bounds: the reader of the standard library recurses, and takes a time that
grows with the square of the parts of a dotted key."""

from __future__ import annotations

import re
import tomllib
from typing import Any

__all__ = ["DEEPEST", "loads"]

DEEPEST = 20
"""Tables and lists within each other, and parts of a dotted key; the shipped tables need four."""

_TEXT_OR_COMMENT = re.compile(
    r'"""(?:[^\\]|\\.)*?"""|\'\'\'.*?\'\'\'|"(?:[^"\\\n]|\\.)*"|\'[^\'\n]*\'|#[^\n]*', re.DOTALL
)
_DOTTED = re.compile(rf"(?:[\w-]+\s*\.\s*){{{DEEPEST}}}[\w-]")


def loads(text: str) -> dict[str, Any]:
    """Read TOML whose nesting is bounded.

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
    >>> loads("a.b = [1, 2]")
    {'a': {'b': [1, 2]}}
    >>> loads("a = " + "[" * 5000)
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
        raise ValueError(f"nested too deeply; allowed: at most {DEEPEST} levels")
    return tomllib.loads(text)
