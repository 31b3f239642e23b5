"""What of a case may be meant otherwise than it was read, as warnings that ride along to the result."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.cases.bare_numbers import about_load, about_speed
from babbitt.cases.journal import JournalBearing
from babbitt.cases.operating_point import LOADS, SPEEDS, OperatingPoint, stating
from babbitt.cases.supply_element import UnevenPockets
from babbitt.notices import Notice


def doubts_about(bearing: JournalBearing, point: OperatingPoint | None) -> tuple[Notice, ...]:
    """Give every doubt about one bearing at one operating point.

    Parameters
    ----------
    bearing : JournalBearing
    point : OperatingPoint or None
    """
    return (*_about_span(bearing, point), *doubts_about_numbers(bearing, point))


def doubts_about_numbers(bearing: JournalBearing, point: OperatingPoint | None) -> tuple[Notice, ...]:
    """Give the doubts about numbers without unit of one bearing at one operating point."""
    return (
        *about_speed(stating(SPEEDS, bearing, point), "speed"),
        *about_speed(bearing, "bearing_speed"),
        *about_load(stating(LOADS, bearing, point)),
    )


def _about_span(bearing: JournalBearing, point: OperatingPoint | None) -> Iterator[Notice]:
    """Warn where a conventional span stands for the arc between uneven pockets."""
    element = bearing.element_at(point)
    if not isinstance(element, UnevenPockets):
        return
    conventional, span = element.conventional_span(), bearing.span_at(point)
    exact = math.degrees(conventional.exact)
    yield Notice("W104", f"the arc between uneven pockets, {exact:.0f}° if centred, was taken as {span}°")
    if conventional.too_short:
        yield Notice(
            "W105", f"the pockets leave {exact:.0f}° of centred arc; the characteristics hold for {span}°"
        )
