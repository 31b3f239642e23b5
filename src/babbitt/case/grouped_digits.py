"""Quantities whose three digits after the point may be grouped thousands: 12.000 N is twelve newtons here.

Doubtful are digits that no decimal needs: a zero at the end, as in 12.000 kN or 1.250 kN, or thousandths of a unit
so small that nobody gives them, as in 12.345 N.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, cast

from babbitt.case.error_messages import metadata_of
from babbitt.core.notices import Notice
from babbitt.core.units import QuantityError, SiField, read

if TYPE_CHECKING:
    from babbitt.case.part import Part

__all__ = ["about_grouped_digits", "grouped_fields"]

_GROUPED = re.compile(r"\s*([-+]?[1-9]\d{0,2})\.(\d{3})(?!\d)(\s*[^\d\s.eE].*)", re.DOTALL)


_FINE = frozenset({"N", "Pa", "W", "rpm", "1/min", "kgf", "g", "s"})
"""Units of whose thousandths no bearing knows."""


def grouped_fields(cls: type[Part], given: Mapping[str, Any]) -> tuple[tuple[str, str], ...]:
    """Give the quantities of a part whose digits may be grouped, as they are written.

    Only those whose field would take the number a thousand times as large: no bore of 80.025 mm is meant as 80 m.

    Parameters
    ----------
    cls : type
    given : Mapping
        What the part was read from.
    """
    found: dict[str, str] = {}
    for name, value in given.items():
        texts = value if isinstance(value, list | tuple) else [value]
        for text in texts:
            match = _GROUPED.fullmatch(text) if isinstance(text, str) else None
            if (
                match
                and _is_doubtful(match)
                and any(_holds(field, "".join(match.groups())) for field in metadata_of(cls, name, SiField))
            ):
                found.setdefault(str(name), text.strip())
    return tuple(found.items())


def about_grouped_digits(part: Part | None, *path: str | int) -> Iterator[Notice]:
    """Warn of every quantity of a part, and of the parts within, whose digits may be grouped.

    Parameters
    ----------
    part : Part or None
    *path : str or int
        From the case to the part.
    """
    for name, text in part._grouped if part is not None else ():
        match = _GROUPED.fullmatch(text)
        if match is not None:
            whole, thousand, unit = match.groups()
            field = ".".join(map(str, (*path, name)))
            yield Notice("W181", values={
                "field": field,
                "given": text,
                "thousands": f"{whole}{thousand}{unit}",
                "decimal": f"{float(f'{whole}.{thousand}'):g}{unit}",
            })  # fmt: skip
    for name, value in vars(part).items() if part is not None else ():
        yield from _within(value, *path, name)


def _within(value: object, *path: str | int) -> Iterator[Notice]:
    if isinstance(value, tuple):
        for index, one in enumerate(value):
            yield from _within(one, *path, index)
    elif hasattr(value, "_grouped"):
        yield from about_grouped_digits(cast("Part", value), *path)


def _is_doubtful(match: re.Match[str]) -> bool:
    _, thousand, unit = match.groups()
    return thousand.endswith("0") or unit.strip() in _FINE


def _holds(field: SiField, text: str) -> bool:
    try:
        return field.unit != "1" and field.holds(read(text, field.unit))
    except QuantityError:
        return False
