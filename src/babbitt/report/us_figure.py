"""A figure drawn in units of the SI, with its scales and texts in those of the US.

What is drawn stays where it is: ticks stand at round numbers of the partner of the unit that an axis names, and
texts, labels of contours among them, say their numbers in it. Figures that draw in the units that are spoken name
none of the SI, and stay.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.contour import ContourSet
from matplotlib.projections.polar import RadialLocator
from matplotlib.text import Text
from matplotlib.ticker import FixedLocator, FuncFormatter, Locator, LogFormatter, NullFormatter, NullLocator

from babbitt.report.us_words import (
    OF_RESULTS,
    PARTNERS,
    UNITS,
    in_us_units,
    numbers_in_us_units,
    units_named_in_us_units,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

__all__ = ["Elsewhere", "turn_figure"]

COLOURBAR = "<colorbar>"
"""Label by which matplotlib tells the axes of a colour bar."""

LONG = 1e5
"""Number from which the label of an axis takes a power of ten."""

_NAMED = re.compile(rf" in ({UNITS})(?=$|[ ),])")


def turn_figure(figure: Figure) -> None:
    """Turn the scales and texts of a finished figure."""
    contours = [(one, _unit_of(one, figure)) for one in figure.findobj(ContourSet)]
    for axes in figure.axes:
        for axis, unit in _scales(axes):
            _turn(axis, unit)
    levels = [text for one, _ in contours for text in one.labelTexts]
    for one, unit in contours:
        for text in one.labelTexts if unit else ():
            text.set_text(numbers_in_us_units(text.get_text(), unit))
    for text in figure.findobj(Text):
        if text not in levels and isinstance(text, Text):
            text.set_text(units_named_in_us_units(in_us_units(text.get_text(), OF_RESULTS)))


def _scales(axes: Axes) -> Iterator[tuple[Axis, str]]:
    """The axes whose numbers have a unit of the SI; that of a radius stands alone."""
    for axis in (axes.xaxis, axes.yaxis):
        if unit := _named(axis.get_label_text()):
            yield axis, unit
    if axes.name == "polar":
        for text in axes.texts:
            if (unit := text.get_text()) in PARTNERS:
                text.set_text(PARTNERS[unit][0])
                yield axes.yaxis, unit


def _named(said: str) -> str:
    found = _NAMED.search(said)
    return found[1] if found else ""


def _unit_of(contours: ContourSet, figure: Figure) -> str:
    """The unit of contours: that of lines named at an axis, of a text over the panel, or of the colour bar."""
    axes: Any = contours.axes
    labels = (axis.get_label_text() for axis in (axes.xaxis, axes.yaxis))
    said = [one.partition("(")[2] for one in labels if "(lines: " in one]
    said += [text.get_text() for text in axes.texts]
    bars = (one for one in figure.axes if one.get_label() == COLOURBAR)
    said += [axis.get_label_text() for one in bars for axis in (one.yaxis, one.xaxis)]
    return next(filter(None, map(_named, said)), "")


def _turn(axis: Axis, unit: str) -> None:
    partner, factor, offset = PARTNERS[unit]
    low, high = sorted(axis.get_view_interval())
    major, minor = axis.get_major_locator(), axis.get_minor_locator()
    largest = max(abs(one * factor + offset) for one in (low, high))
    power = 3 * int(math.log10(largest) // 3) if largest >= LONG else 0
    if power:
        said = f" in $10^{{{power}}}$ {partner}"
        axis.set_label_text(_NAMED.sub(lambda _: said, axis.get_label_text()))
    digits = 3 if isinstance(major, FixedLocator) else 6
    written = FuncFormatter(lambda value, _: f"{(value * factor + offset) / 10.0**power:.{digits}g}")
    formatter = axis.get_minor_formatter()
    axis.set_major_locator(_elsewhere(major, factor, offset))
    axis.set_major_formatter(written)
    if not isinstance(minor, NullLocator):
        axis.set_minor_locator(_elsewhere(minor, factor, offset))
        unsaid = isinstance(formatter, NullFormatter) or (
            isinstance(formatter, LogFormatter) and high > 10.0 * low
        )
        axis.set_minor_formatter(NullFormatter() if unsaid else written)


def _elsewhere(inner: Locator, factor: float, offset: float) -> Locator:
    if isinstance(inner, FixedLocator | NullLocator):
        return inner
    if isinstance(inner, RadialLocator):  # leaves out what lies within the middle
        inner.base = Elsewhere(inner.base, factor, offset)
        inner.base.set_axis(inner.base.inner.axis)
        return inner
    return Elsewhere(inner, factor, offset)


class Elsewhere(Locator):
    """Ticks where another locator would set them on the scale ``factor * value + offset``."""

    def __init__(self, inner: Locator, factor: float, offset: float) -> None:
        self.inner, self._factor, self._offset = inner, factor, offset

    def __call__(self) -> Any:
        """Places of the ticks in view."""
        assert self.axis is not None
        return self.tick_values(*self.axis.get_view_interval())

    def tick_values(self, vmin: float, vmax: float) -> Any:
        """Places of the ticks between two."""
        ends = (one * self._factor + self._offset for one in (vmin, vmax))
        return (np.asarray(self.inner.tick_values(*ends)) - self._offset) / self._factor
