"""Mean pressure of the pad that carries most, and speed, against what experience and the bearing metal allow."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from operator import attrgetter

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.design.checks import specific_load_at_speed
from babbitt.kinds.thrust.temperature_limits import ASSUMED_METAL
from babbitt.properties.materials import BearingMetal, LoadCharacter, bearing_metal, specific_load_limit

__all__ = ["PRESSURE", "pressure_checks", "pressures_not_checked"]

PRESSURE = "largest_specific_load"
"""Name of the mean pressure of the pad that carries most."""

OF_METAL = (
    ("C105", PRESSURE, attrgetter("specific_load")),
    ("C106", "surface_speed", attrgetter("sliding_speed")),
    ("C107", "pressure_speed_product", attrgetter("pv")),
)
"""Code, value and limit of the metal. Speeds are those at the mean radius, to which a mean pressure belongs."""


def pressure_checks(given_metal: BearingMetal | None, values: Mapping[str, float]) -> Iterator[Check]:
    """C103 and C105 to C107, as of journal bearings; recommendations where a metal is assumed.

    Parameters
    ----------
    given_metal : BearingMetal or None
        Of the faces, as the case has it.
    values : Mapping of str to float
        Named results: `PRESSURE` in Pa, ``surface_speed`` in m/s at the mean radius, and their product.
    """
    metal = bearing_metal(ASSUMED_METAL) if given_metal is None else given_metal
    assumed = "" if given_metal is not None else f"assumption: {ASSUMED_METAL}; "
    pressure, advisory = values[PRESSURE], given_metal is None
    if (by_experience := specific_load_limit(metal.family)) is not None:
        limit, source = specific_load_at_speed(by_experience, abs(values["surface_speed"]))
        why = f"{assumed}{source} of journal bearings"
        yield Check("C103", PRESSURE, pressure, limit, Bound.AT_MOST, why, advisory)
    limits = metal.limits(LoadCharacter.CALM)
    for code, name, limit_in in OF_METAL:
        if (of_metal := limit_in(limits)) is not None:
            source = f"{assumed}{of_metal.source}"
            yield Check(code, name, values[name], of_metal.value, Bound.AT_MOST, source, advisory)


def pressures_not_checked(given_metal: BearingMetal | None) -> Iterator[Notice]:
    """Which of these checks lack data; with an assumed metal they are made, as recommendations."""
    metal = bearing_metal(ASSUMED_METAL) if given_metal is None else given_metal
    if specific_load_limit(metal.family) is None:
        yield Notice("C103", "no_public_limit", {"metal": metal.name})
    limits = metal.limits(LoadCharacter.CALM)
    for code, _, limit_in in OF_METAL:
        if limit_in(limits) is None:
            yield Notice(code, "no_public_limit", {"metal": metal.name})
