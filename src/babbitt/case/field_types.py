"""What kind of value a field of the case language takes, found from its annotation."""

from __future__ import annotations

import typing
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from babbitt.case.aliases import may_be, parts_in, todays_path
from babbitt.case.part import Part
from babbitt.case.parts.fields import TabulatedSpan
from babbitt.case.shorthand import Shorthand
from babbitt.core.units import SiField

__all__ = ["attributes_of_field", "expanded", "field_annotations", "names_within", "quantity_in", "takes_list"]


def field_annotations(model: type[Part], steps: Sequence[str], given: Any = None) -> tuple[Any, ...]:
    """Annotations of the fields that a path may lead to, one for each branch of a union; empty for no field.

    Parameters
    ----------
    model : type
        The part where the path begins.
    steps : sequence of str
        Names, and numbers in lists; former words will do.
    given : Mapping, optional
        What stands in the part, in words of today: of a union only the parts count that it may be.

    Examples
    --------
    >>> from babbitt.kinds.journal.case.files import JournalCase
    >>> mean = ["clearance", "mean"]
    >>> [quantity_in(one).unit for one in field_annotations(JournalCase, mean)]
    ['1', 'm', 'm']
    >>> clearance = {"kind": "radial", "mean": "50 um"}
    >>> [quantity_in(one).unit for one in field_annotations(JournalCase, mean, {"clearance": clearance})]
    ['m']
    """
    return tuple(part.model_fields[name].rebuild_annotation() for part, name, _ in _fields_at(model, steps, given))


def attributes_of_field(model: type[Part], steps: Sequence[str], given: Any = None) -> dict[str, str]:
    """Unit in SI and meaning of the field that a path leads to, as ``units`` and ``long_name``; empty if none.

    Parameters are those of `field_annotations`.

    >>> from babbitt.kinds.journal.case.files import JournalCase
    >>> attributes_of_field(JournalCase, ["supply", "temperature"])["units"]
    'K'
    """
    for part, name, _ in _fields_at(model, steps, given):
        field = part.model_fields[name]
        quantity = quantity_in(field.rebuild_annotation())
        units = {} if quantity is None else {"units": quantity.kind.unit}
        return {**units, "long_name": (field.description or name).rstrip(".")}
    return {}


def names_within(model: type[Part], steps: Sequence[str], given: Any = None) -> list[str]:
    """Names of the fields of what a path leads to, each once; parameters are those of `field_annotations`."""
    found = (
        part for owner, name, value in _fields_at(model, steps, given) for part, _ in _parts_of(owner, name, value)
    )
    return list(dict.fromkeys(name for part in found for name in part.model_fields))


def _fields_at(model: type[Part], steps: Sequence[str], given: Any) -> Iterator[tuple[type[Part], str, Any]]:
    """Part and name of the fields that a path may lead to, and what stands in each."""
    first, *rest = todays_path(model, steps)
    if first not in model.model_fields:
        return
    value = given.get(first) if isinstance(given, Mapping) else None
    while rest and rest[0].isdecimal():
        place = int(rest[0])
        value = value[place] if isinstance(value, list | tuple) and place < len(value) else None
        rest = rest[1:]
    if not rest:
        yield model, first, value
        return
    for part, within in _parts_of(model, first, value):
        yield from _fields_at(part, rest, within)


def _parts_of(model: type[Part], name: str, value: Any) -> Iterator[tuple[type[Part], Any]]:
    """The parts that a field may hold, of several kinds that which stands there, with what they have."""
    annotation = model.model_fields[name].rebuild_annotation()
    for one in value if isinstance(value, list | tuple) and value else (value,):
        within = one if one is None or isinstance(one, Mapping) else expanded(annotation, one)
        for part in parts_in(annotation):
            if not isinstance(within, Mapping) or may_be(part, within):
                yield part, within


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
