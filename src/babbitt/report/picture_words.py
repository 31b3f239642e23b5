"""Numbers in a drawing for the screen: sizes with their units, and by how much films are enlarged."""

from __future__ import annotations

import math
from collections.abc import Mapping

from babbitt.core.language import decimal, plural, translated
from babbitt.core.quantities import QUANTITIES
from babbitt.core.units import written
from babbitt.report.us_words import in_us_units

__all__ = ["enlarged", "millimetres", "named", "round_below", "sized"]


def sized(name: str, value: float) -> str:
    """An SI value of a named quantity in the unit that suits its size."""
    return QUANTITIES[name].suited(value).with_unit(value)


def named(values: Mapping[str, float], *names: str) -> list[str]:
    """Those of some results that there are, each with its symbol and unit."""
    return [
        f"{QUANTITIES[name].symbol} = {QUANTITIES[name].with_unit(values[name])}"
        for name in names
        if name in values
    ]


def millimetres(symbol: str, length: float) -> str:
    """A length by its symbol.

    >>> millimetres("D", 0.0436)
    'D = 43.6 mm'
    """
    said: str = in_us_units(decimal(f"{symbol} = {written(length, 'mm')}"))
    return said


def enlarged(what: str, factor: float) -> str:
    """By how much something is drawn larger than the other lengths.

    >>> enlarged("film", 146.7)
    'film enlarged 147 times'
    """
    size = float(f"{factor:.3g}")
    number, times = decimal(f"{size:g}"), plural("time", int(size) if size.is_integer() else 2)
    return translated("{what} enlarged {number} {times}", what=translated(what), number=number, times=times)


def round_below(value: float) -> float:
    """The largest of 1, 2 and 5 times a power of ten that is not above a positive value.

    >>> round_below(730.0), round_below(5.0), round_below(0.15)
    (500.0, 5.0, 0.1)
    """
    decade = 10.0 ** math.floor(math.log10(value) + 1e-12)
    return next(round(step * decade, 15) for step in (5.0, 2.0, 1.0) if step * decade <= value * (1.0 + 1e-12))
