"""What to say of a function of one's own that fails or gives what no table can hold."""

from __future__ import annotations

from pathlib import Path
from typing import Any

__all__ = ["failure", "named"]

LONGEST = 160
"""Characters of an error that are shown."""


def named(function: Any, describe: str) -> str:
    """A function by its name and place and by what it describes.

    >>> named(len, "length")
    "the function len of 'length'"
    """
    name = getattr(function, "__qualname__", type(function).__name__).rpartition("<locals>.")[2]
    code = getattr(function, "__code__", None)
    place = f" ({Path(code.co_filename).name}, line {code.co_firstlineno})" if code is not None else ""
    return f"the function {name}{place} of '{describe}'"


def failure(function: Any, describe: str, called_with: str, error: Exception) -> str:
    """Say in one line which function fails, with what it was called, why, and in which line of its file.

    >>> failure(len, "length", "x = 0.1", TypeError("object of type 'float' has no len()"))
    "the function len of 'length' fails at x = 0.1: TypeError: object of type 'float' has no len()"
    """
    why = " ".join(f"{type(error).__name__}: {error}".split())
    shown = why if len(why) <= LONGEST else f"{why[: LONGEST - 1]}…"
    step = error.__traceback__
    lines = []
    while step is not None:
        lines.append((step.tb_frame.f_code, step.tb_lineno))
        step = step.tb_next
    inside = [line for code, line in lines if code is getattr(function, "__code__", None)]
    return (
        f"{named(function, describe)} fails at {called_with}{f' in line {inside[-1]}' if inside else ''}: {shown}"
    )
