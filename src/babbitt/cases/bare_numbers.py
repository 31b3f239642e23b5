"""Numbers without unit that look as if another unit was meant."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.cases.part import Part, is_bare
from babbitt.notices import Notice
from babbitt.units import KINDS

__all__ = [
    "about_damping",
    "about_frequencies",
    "about_heavy_mass",
    "about_inertia",
    "about_load",
    "about_speed",
    "about_viscosity",
]

SUSPICIOUS_SPEED = 100.0
"""Assumption: a whole number from here on is how people write rpm; speeds in rad/s seldom come out whole."""

SUSPICIOUS_LOAD = 1000.0
"""N. Assumption: people write a load below it in kN."""

SUSPICIOUS_VISCOSITY = 1.0
"""Pa s. Assumption: no bearing oil is so viscous where it carries; people write mPa s from here on."""

SUSPICIOUS_MASS = 100.0
"""kg. Assumption: propellers, collars and housings below it are written in t."""

SUSPICIOUS_DAMPING = 1000.0
"""N s/m. Assumption: the damping of a propeller or a seating below it is written in kN s/m."""

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


def about_viscosity(part: Part, name: str = "viscosity", path: str = "oil.viscosity") -> Iterator[Notice]:
    """Doubt a viscosity that no oil has, which was meant in mPa s."""
    value: float = getattr(part, name)
    if is_bare(part, name) and value >= SUSPICIOUS_VISCOSITY:
        yield _read_as(path, value, "Pa s", "mPa s")


def about_heavy_mass(part: Part, name: str, path: str) -> Iterator[Notice]:
    """Doubt a propeller, collar or housing of a few kilograms, which was meant in tonnes."""
    value: float = getattr(part, name)
    if is_bare(part, name) and 0.0 < value < SUSPICIOUS_MASS:
        yield _read_as(path, value, "kg", "t")


def about_damping(part: Part, name: str, path: str) -> Iterator[Notice]:
    """Doubt a damping of a few newton seconds over a metre, which was meant in kN s/m."""
    value: float = getattr(part, name)
    if is_bare(part, name) and 0.0 < value < SUSPICIOUS_DAMPING:
        yield _read_as(path, value, "N s/m", "kN s/m")


def about_inertia(part: Part, name: str, path: str, mass: float, reach: float) -> Iterator[Notice]:
    """Doubt an inertia larger than that of all the mass at the farthest point of the part.

    Parameters
    ----------
    part : Part
    name, path : str
    mass : float
        kg; 0 for one that is not given, which tells nothing.
    reach : float
        Distance of the farthest point from the axis, m.
    """
    value: float = getattr(part, name)
    if is_bare(part, name) and mass > 0.0 and value > mass * reach**2:
        yield _read_as(path, value, "kg m2", "kg cm2")


def _read_as(path: str, value: float, unit: str, meant: str) -> Notice:
    return Notice(
        "W117",
        f"{path}: {value:.12g} without unit was read as {value:.12g} {unit}; "
        f"write '{value:.12g} {meant}' if that was meant",
    )
