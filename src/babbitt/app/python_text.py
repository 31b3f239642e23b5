"""The Python that makes the same case with the public classes."""

from __future__ import annotations

import json
import pprint
from typing import Any

from babbitt.app.answer import NAME
from babbitt.core.files.reading import Reach

__all__ = ["python_of"]

WIDEST = 84
"""Characters of a line."""

LEFT_OUT = ("babbitt", "kind", "study")
"""What a class says by itself, and what is asked of a case and not part of it."""


def python_of(text: str) -> str:
    """A program that makes and solves the case of a text.

    Raises
    ------
    CaseError
        With all that is wrong with the case.
    """
    import babbitt
    from babbitt.api.cases import parse_case

    case = parse_case(text, NAME, Reach.NOWHERE)
    name = type(case).__name__
    if getattr(babbitt, name, None) is not type(case):  # a kind of another package has no class of its own there
        return f"import babbitt\n\ncase = babbitt.parse_case(\n    {text!r}\n)\nprint(case.solve())\n"
    fields = {field: value for field, value in case.given.items() if field not in LEFT_OUT}
    lines = [f"    {field}={_literal(value, len(field) + 5)}," for field, value in fields.items()]
    body = "\n".join([f"case = babbitt.{name}(", *lines, ")"])
    return f"import babbitt\n\n{body}\nprint(case.solve())\n"


def _literal(value: Any, indent: int) -> str:
    """A value as Python writes it, in lines of bounded length."""
    plain = json.loads(json.dumps(value))  # names with marks of their own become plain text
    text = pprint.pformat(plain, width=WIDEST - indent, sort_dicts=False)
    return text.replace("\n", "\n" + " " * indent)
