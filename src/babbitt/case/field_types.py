"""What kind of value a field of the case language takes, found from its annotation."""

from __future__ import annotations

import typing
from collections.abc import Iterator, Sequence
from typing import Any

from babbitt.case.aliases import parts_in, todays_path
from babbitt.case.part import Part
from babbitt.case.parts.fields import TabulatedSpan
from babbitt.case.shorthand import Shorthand
from babbitt.core.units import SiField

__all__ = ["attributes_of_field", "expanded", "field_annotations", "quantity_in", "takes_list"]


def field_annotations(model: type[Part], steps: Sequence[str]) -> tuple[Any, ...]:
    """Annotations of the fields that a path may lead to, one for each branch of a union; empty for no field.

    Parameters
    ----------
    model : type
        The part where the path begins.
    steps : sequence of str
        Names, and numbers in lists; former words will do.
    """
    first, *rest = todays_path(model, steps)
    if first not in model.model_fields:
        return ()
    annotation = model.model_fields[first].rebuild_annotation()
    while rest and rest[0].isdecimal():
        rest = rest[1:]
    if not rest:
        return (annotation,)
    return tuple(found for part in parts_in(annotation) for found in field_annotations(part, rest))


def attributes_of_field(model: type[Part], steps: Sequence[str]) -> dict[str, str]:
    """Unit in SI and meaning of the field that a path leads to, as ``units`` and ``long_name``; empty if none.

    >>> from babbitt.kinds.journal.case.files import JournalCase
    >>> attributes_of_field(JournalCase, ["supply", "temperature"])["units"]
    'K'
    """
    first, *rest = todays_path(model, steps)
    if first not in model.model_fields:
        return {}
    field = model.model_fields[first]
    annotation = field.rebuild_annotation()
    while rest and rest[0].isdecimal():
        rest = rest[1:]
    if rest:
        found = (attributes_of_field(part, rest) for part in parts_in(annotation))
        return next(filter(None, found), {})
    quantity = quantity_in(annotation)
    units = {} if quantity is None else {"units": quantity.kind.unit}
    return {**units, "long_name": (field.description or first).rstrip(".")}


def quantity_in(annotation: Any) -> SiField | TabulatedSpan | None:
    """The quantity that a field takes, itself or in a list; None where it takes none.

    >>> from babbitt.kinds.journal.case.files import JournalCase
    >>> quantity_in(*field_annotations(JournalCase, ["supply", "temperature"])).unit
    'K'
    """
    return next((one for one in _metadata(annotation) if isinstance(one, SiField | TabulatedSpan)), None)


def takes_list(annotation: Any) -> bool:
    """Whether a field takes a list itself, so that a list is one value of it."""
    if typing.get_origin(annotation) is tuple:
        return True
    return any(takes_list(one) for one in typing.get_args(annotation) if not _is_part(one))


def expanded(annotation: Any, value: Any) -> Any:
    """The mapping or list for which a number stands in short; anything else unchanged."""
    short = next((one for one in _metadata(annotation) if isinstance(one, Shorthand)), None)
    return value if short is None else short.expand(value)


def _metadata(annotation: Any) -> Iterator[Any]:
    yield from getattr(annotation, "__metadata__", ())
    for one in typing.get_args(annotation):
        if not _is_part(one):
            yield from _metadata(one)


def _is_part(annotation: Any) -> bool:
    return isinstance(annotation, type) and issubclass(annotation, Part)
