"""Numbers of a study as engineers read them: inputs in everyday units, outputs in those of the vocabulary."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.check_text import distance
from babbitt.core.notices import explanations
from babbitt.core.quantities import QUANTITIES
from babbitt.core.quantities.display import SI, in_system, written_in_system
from babbitt.core.units import KINDS
from babbitt.report.text import plain_text
from babbitt.study.rows import Columns, kelvin_name

__all__ = [
    "DASH",
    "MARGIN_DECIMALS",
    "Scale",
    "StudyTable",
    "check_title",
    "input_scale",
    "kelvin_scale",
    "margin_text",
    "output_scale",
    "percent",
    "significant",
]

MARGIN_DECIMALS = 1
"""Of margins in percent."""

DASH = "–"
"""Stands where a table has no value."""

SHOWN = {"um": "µm", "degC": "°C", "degF": "°F", "deg": "°", "mm2/s": "mm²/s", "m2": "m²", "m3": "m³", "": ""}

USUAL = {"rad/s": "rpm", "Pa": "MPa", "K": "degC", "m2/s": "mm2/s", "rad": "deg", "m3/s": "L/min", "Pa s": "mPa s"}
"""Units that are taken whatever the size of the number."""

SMALL_RATIO = 0.05
"""Numbers without unit below which permille read better."""


@dataclass(frozen=True)
class Scale:
    """A column as it is shown.

    Attributes
    ----------
    name : str
        Heading.
    unit : str
        As written in tables.
    factor, offset : float
        Shown value = SI value times factor plus offset.
    quantity : str
        Of the vocabulary, whose digits are taken; empty for inputs.
    """

    name: str
    unit: str
    factor: float = 1.0
    offset: float = 0.0
    quantity: str = ""

    @property
    def heading(self) -> str:
        """Name and unit for an axis."""
        return f"{self.name} in {self.unit}" if self.unit else self.name

    def shown(self, values: Any) -> Any:
        """Values in the unit, for numbers and arrays alike."""
        return values * self.factor + self.offset

    def text(self, value: Any) -> str:
        """One value as text; words as they are."""
        if isinstance(value, str):
            return plain_text(value)
        if not math.isfinite(value):
            return DASH
        return QUANTITIES[self.quantity].format(value) if self.quantity else significant(self.shown(value))


@dataclass(frozen=True)
class StudyTable:
    """A table of text.

    Attributes
    ----------
    title : str
    columns : tuple of (str, str)
        Heading and unit.
    rows : tuple of tuple of str
    words : int
        Columns from the left that hold words; all others hold numbers.
    notes : tuple of str
        Below it.
    """

    title: str
    columns: tuple[tuple[str, str], ...]
    rows: tuple[tuple[str, ...], ...]
    words: int = 1
    notes: tuple[str, ...] = ()


def significant(value: float, digits: int = 4) -> str:
    """A number with some significant digits.

    >>> significant(1234.56), significant(0.0123456), significant(35.0)
    ('1235', '0.01235', '35')
    """
    if not math.isfinite(value):
        return DASH
    if value != 0.0 and not 1e-4 <= abs(value) < 1e7:
        return f"{value:.{digits - 1}e}"
    text = f"{value:.{digits}g}"
    return f"{value:.0f}" if "e" in text else text


def margin_text(columns: Columns, place: int) -> str:
    """The margin of the governing check of a line, in K for temperatures."""
    kelvin = columns.get(kelvin_name(str(columns["governing_check"][place])))
    return distance(columns["margin"][place], math.nan if kelvin is None else kelvin[place], MARGIN_DECIMALS)


def percent(share: float, digits: int = 1) -> str:
    """A share in percent."""
    return f"{100.0 * share:.{digits}f} %" if math.isfinite(share) else DASH


def input_scale(one: Mapping[str, Any], values: NDArray[Any] | None = None) -> Scale:
    """How the column of an input is shown, by the size of its numbers."""
    name = plain_text(one["path"])
    if "values" in one:
        return Scale(name, "")
    largest = max((abs(end) for end in one["support"]), default=0.0)
    if values is not None and values.size:
        largest = float(np.max(np.abs(values)))
    unit = one["unit"]
    if not unit:
        return Scale(name, "‰", 1e3) if 0.0 < largest < SMALL_RATIO else Scale(name, "")
    kind = KINDS[unit]
    wanted = USUAL.get(unit) or next(
        (each for each, factor in kind.everyday.items() if 1.0 <= largest / factor < 1e4),
        next(iter(kind.everyday)),
    )
    wanted = written_in_system(wanted)
    factor = 1.0 / kind.everyday[wanted]
    return Scale(name, SHOWN.get(wanted, wanted), factor, -kind.offsets.get(wanted, 0.0) * factor)


def output_scale(name: str) -> Scale:
    """How the column of an output is shown; its name is its symbol."""
    if name not in QUANTITIES:
        return Scale(name, "")
    known = QUANTITIES[name]
    return Scale(known.symbol, known.display.label, known.display.scale, known.display.offset, name)


def kelvin_scale(name: str) -> Scale:
    """How the column of margins in K is shown."""
    unit = in_system(SI["K"])
    return Scale(name, unit.label, unit.scale)


def check_title(code: str) -> str:
    """A check with its title."""
    known = explanations().get(code)
    return f"{code} {known.title}" if known is not None else code
