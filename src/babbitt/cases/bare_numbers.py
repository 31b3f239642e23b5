"""Numbers without unit that look as if another unit was meant."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.cases.part import Part, is_bare
from babbitt.notices import Notice
from babbitt.units import KINDS

__all__ = ["about_frequencies", "about_load", "about_speed"]

SUSPICIOUS_SPEED = 100.0
"""Assumption: a whole number from here on is how people write rpm; speeds in rad/s seldom come out whole."""

SUSPICIOUS_LOAD = 1000.0
"""N. Assumption: people write a load below it in kN."""

WRITTEN_DIGITS = 4
"""Assumption: a number of more significant digits was written by a program, which knows its units."""


def about_speed(part: Part, name: str) -> Iterator[Notice]:
    """Doubt a whole number of revolutions that was read as rad/s."""
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


def about_frequencies(part: Part, name: str = "frequencies") -> Iterator[Notice]:
    """Doubt whole numbers of swings per second that were read as rad/s."""
    given: tuple[float, ...] = getattr(part, name)
    largest = max(given, default=0.0)
    if largest == 0.0 or not is_bare(part, name) or not all(one.is_integer() for one in given):
        return
    hertz = KINDS["frequency"].from_si(largest, "Hz")
    yield Notice(
        "W117",
        f"{name}: {largest:.12g} without unit was read as {largest:.12g} rad/s = {hertz:.4g} Hz; "
        f"write '{largest:.12g} Hz' if that was meant",
    )


def about_load(part: Part, name: str = "load") -> Iterator[Notice]:
    """Doubt a load of a few newtons, which was meant as kilonewtons."""
    load: float | None = getattr(part, name)
    if load is None or not is_bare(part, name):
        return
    by_hand = float(f"{load:.{WRITTEN_DIGITS}g}") == load
    if load < SUSPICIOUS_LOAD and by_hand:
        yield Notice(
            "W117",
            f"{name}: {load:.12g} without unit was read as {load:.12g} N; "
            f"write '{load:.12g} kN' if that was meant",
        )
