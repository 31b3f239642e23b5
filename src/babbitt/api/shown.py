"""Objects of the Python front door in a few lines of a terminal."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

__all__ = ["MOST_LINES", "shown_call"]

MOST_LINES = 20
"""Fields that are shown of an object; more are counted."""

LONGEST_VALUE = 90
"""Characters that are shown of a value."""


def shown_call(name: str, given: Mapping[str, Any], missing: Sequence[str] = ()) -> str:
    """Show an object as the call that makes it, a field on each line where it has several.

    >>> shown_call("Lobes", {"preload": 0.5}), shown_call("Bearing", {}, ["load", "speed"])
    ('Lobes(preload=0.5)', 'Bearing()  # missing: load, speed')
    """
    lines = [f"{field}={_short(value)}" for field, value in given.items()]
    if (more := len(lines) - MOST_LINES) > 0:
        lines = [*lines[:MOST_LINES], f"...  # and {more} more"]
    remark = f"  # missing: {', '.join(missing)}"[:LONGEST_VALUE] if missing else ""
    if len(lines) < 3:
        return f"{name}({', '.join(lines)}){remark}"
    return "\n".join([f"{name}(", *(f"    {line}," for line in lines), f"){remark}"])


def _short(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= LONGEST_VALUE else f"{text[: LONGEST_VALUE - 3]}..."
