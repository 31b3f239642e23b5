"""What a program gives, in the words of the case language: mappings, lists, text, numbers in SI."""

from __future__ import annotations

import math
import numbers
from collections.abc import Iterable, Mapping
from enum import Enum
from pathlib import PurePath
from typing import Any

from babbitt.case.case_file import CaseFile
from babbitt.case.error_messages import Path
from babbitt.case.field_types import quantity_in
from babbitt.case.part import Part
from babbitt.case.parts.fields import TabulatedSpan
from babbitt.case.problems import CaseError, Problem
from babbitt.core.units.foreign import as_python

__all__ = ["as_given", "content_of"]


def as_given(value: Any, where: str, path: Path = ()) -> Any:
    """Bring a value to what a case file could hold; a number stays in SI.

    Parameters
    ----------
    value : object
        Text, a number of Python or numpy, a pint quantity, a member of an enumeration, a part, or mappings and
        sequences of them.
    where : str
        What to call the whole in messages.
    path : tuple
        From the whole to the value.

    Raises
    ------
    CaseError
        For a number that is not finite, and for an object of another kind.
    """
    value = as_python(value)
    match value:
        case None | bool():
            return value
        case Enum():
            return as_given(value.value if isinstance(value.value, str) else value.name.lower(), where, path)
        case str() | PurePath():
            return str(value)
        case Part():
            return content_of(value)
        case Mapping():
            return {
                str(name): as_given(one, where, (*path, str(name)))
                for name, one in value.items()
                if one is not None
            }
        case numbers.Integral():
            return int(value)
        case numbers.Real():
            if not math.isfinite(value):
                raise _refused(where, path, f"{value} is not a finite number", "a finite number")
            return float(value)
        case Iterable():
            return [as_given(one, where, (*path, number)) for number, one in enumerate(value)]
    raise _refused(where, path, f"a {type(value).__name__} is not a value", "text with a unit, or a number in SI")


def content_of(part: Part) -> dict[str, Any]:
    """What a part was given, in the words of the case language; in SI where it no longer knows.

    Parameters
    ----------
    part : Part
        From a file, of a class of this package, or made by a program of another.
    """
    known = getattr(part, "given", None)
    if known is None and isinstance(part, CaseFile) and part.origin is not None:
        known = part.origin.given
    if known is not None:
        return dict(known)
    fields = type(part).model_fields
    written = part.model_fields_set | {"kind"}
    kept = {name: value for name, value in vars(part).items() if name in written}
    return {
        name: _content(value, fields[name].rebuild_annotation())
        for name, value in kept.items()
        if value is not None
    }


def _content(value: Any, annotation: Any) -> Any:
    if isinstance(value, Part):
        return content_of(value)
    if isinstance(quantity_in(annotation), TabulatedSpan):
        return f"{value} deg"
    return [_content(one, annotation) for one in value] if isinstance(value, tuple) else value


def _refused(where: str, path: Path, says: str, allowed: str) -> CaseError:
    field = "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in path).removeprefix(".")
    return CaseError([Problem(where, 0, field, says, allowed=allowed)])
