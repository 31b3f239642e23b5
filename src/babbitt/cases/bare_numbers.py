"""Numbers without unit that look as if another unit was meant."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.cases.part import Part, is_bare
from babbitt.notices import Notice
from babbitt.units import KINDS

__all__ = ["about_load", "about_speed"]

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
