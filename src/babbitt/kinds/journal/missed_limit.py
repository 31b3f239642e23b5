"""A missed limit in words, with its numbers in the unit of what is limited."""

from __future__ import annotations

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS, TEMPERATURE_CHECKS

__all__ = ["missed_limit"]

MISSED = {
    "missed_film": (*FILM_CHECKS, "minimum_film_thickness"),
    "missed_bush": ("maximum_bush_temperature",),
    "missed_temperature": ("outlet_temperature", "starved_outlet_temperature"),
    "missed_hottest": TEMPERATURE_CHECKS,
    "missed_mass": ("critical_mass", "critical_mass_elastic"),
    "missed_least_mass": ("least_stable_mass",),
    "missed_pressure": ("maximum_pressure",),
    "missed_supply": ("least_supply_ratio",),
}
"""Messages of missed limits that are no bare numbers, by code or quantity."""


def missed_limit(check: Check) -> Notice:
    """A clause that says which limit is missed, and by what."""
    variant = next(
        (one for one, codes in MISSED.items() if check.code in codes or check.quantity in codes), "missed"
    )
    return Notice("W191", variant, {"value": check.value, "limit": check.limit, "check": check.code})
