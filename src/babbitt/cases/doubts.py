"""What of a case may be meant otherwise than it was read, as warnings that ride along to the result."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.cases.journal import JournalBearing
from babbitt.cases.operating_point import LOADS, SPEEDS, Duty, OperatingPoint, stating
from babbitt.cases.part import Part, is_bare
from babbitt.cases.supply_element import UnevenPockets
from babbitt.notices import Notice
from babbitt.units import KINDS

SUSPICIOUS_SPEED = 100.0
"""Assumption: a whole number from here on is how people write rpm; speeds in rad/s seldom come out whole."""

SUSPICIOUS_LOAD = 1000.0
"""N. Assumption: people write a load below it in kN."""

WRITTEN_DIGITS = 4
"""Assumption: a number of more significant digits was written by a program, which knows its units."""


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
        *_about_speed(stating(SPEEDS, bearing, point), "speed"),
        *_about_speed(bearing, "bearing_speed"),
        *_about_load(stating(LOADS, bearing, point)),
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


def _about_speed(part: Part, name: str) -> Iterator[Notice]:
    speed: float | None = getattr(part, name)
    if speed is None or not is_bare(part, name):
        return
    if speed.is_integer() and abs(speed) >= SUSPICIOUS_SPEED:
        turns = KINDS["rad/s"].from_si(speed, "rpm")
        yield Notice(
            "W117",
            f"{name}: {speed:.12g} without unit was read as {speed:.12g} rad/s = {turns:.0f} rpm; "
            f"write '{speed:.12g} rpm' if that was meant",
        )


def _about_load(duty: Duty) -> Iterator[Notice]:
    load = duty.load
    if load is None or not is_bare(duty, "load"):
        return
    by_hand = float(f"{load:.{WRITTEN_DIGITS}g}") == load
    if load < SUSPICIOUS_LOAD and by_hand:
        yield Notice(
            "W117",
            f"load: {load:.12g} without unit was read as {load:.12g} N; write '{load:.12g} kN' if that was meant",
        )
