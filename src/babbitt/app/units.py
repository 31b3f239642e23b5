"""A quantity as a number beside its unit."""

from __future__ import annotations

from collections.abc import Sequence

from babbitt.core.units import KINDS

__all__ = ["in_unit", "split"]


def split(text: str, units: Sequence[str]) -> tuple[str, str]:
    """Number and unit of a quantity, as far as both can be told; else the whole text, and no unit.

    >>> split("120 mm", ["mm", "m"]), split("0", ["mm"]), split("H7/e7", ["mm"])
    (('120', 'mm'), ('0', 'mm'), ('H7/e7', ''))
    """
    number, _, unit = text.strip().partition(" ")
    try:
        float(number)
    except ValueError:
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
            si = float(number) * kind.everyday[unit] + kind.offsets.get(unit, 0.0)
            return f"{kind.from_si(si, other):.6g}"
    return number
