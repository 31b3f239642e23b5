"""A quantity as a number beside its unit."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

from babbitt.core.quantities.display import SYSTEMS, displayed_in, us_partner
from babbitt.core.units import KINDS

__all__ = ["SYSTEMS", "from_si", "in_unit", "is_number", "shown_in", "spoken", "split"]


def split(text: str, units: Sequence[str]) -> tuple[str, str]:
    """Number and unit of a quantity, as far as both can be told; else the whole text, and no unit.

    >>> split("120 mm", ["mm", "m"]), split("0", ["mm"]), split("H7/e7", ["mm"])
    (('120', 'mm'), ('0', 'mm'), ('H7/e7', ''))
    """
    number, _, unit = text.strip().partition(" ")
    if not is_number(number):
        return text, ""
    if not unit:
        return (number, units[0]) if units else (text, "")
    return (number, unit.strip()) if unit.strip() in units else (text, "")


def in_unit(number: str, unit: str, other: str) -> str:
    """A number of one everyday unit in another one of the same kind.

    >>> in_unit("120", "mm", "in"), in_unit("50", "degC", "degF")
    ('4.72441', '122')
    """
    for kind in KINDS.values():
        if unit in kind.everyday and other in kind.everyday:
            return f"{kind.from_si(kind.to_si(float(number), unit), other):.6g}"
    return number


def from_si(value: Any, unit: str) -> Any:
    """A value, or an array of values, in SI in an everyday unit; as it is where there is no such unit.

    >>> from_si(0.12, "mm"), round(from_si(323.15, "degC"), 9), from_si(3.0, "")
    (120.0, 50.0, 3.0)
    """
    kinds = (kind for kind in KINDS.values() if unit and unit in kind.everyday)
    return next((kind.from_si(value, unit) for kind in kinds), value)


def shown_in(system: str, number: str, unit: str, units: Sequence[str]) -> tuple[str, str]:
    """A quantity as a system of units shows it; as it is where the system has no other unit for it.

    >>> shown_in("us", "120", "mm", ["mm", "in"]), shown_in("si", "120", "mm", ["mm", "in"])
    (('4.72441', 'in'), ('120', 'mm'))
    """
    other = us_partner(unit) if system == "us" else unit
    if other == unit or other not in units:
        return number, unit
    return in_unit(number, unit, other) if is_number(number) else number, other


def spoken(system: str, function: Callable[..., Any], *given: Any) -> Any:
    """What a function says, in the units of a system."""
    with displayed_in(system):
        return function(*given)


def is_number(text: str) -> bool:
    """Whether a text is a finite number alone.

    >>> is_number("-1.5e3"), is_number("nan"), is_number("1e400"), is_number("12 mm")
    (True, False, False, False)
    """
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False
