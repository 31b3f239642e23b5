"""A missed limit in words, with its numbers in the unit of what is limited."""

from __future__ import annotations

from babbitt.core.limited_flow import whole
from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS, TEMPERATURE_CHECKS

__all__ = ["missed_limit"]

MISSED = {
    "missed_film": (*FILM_CHECKS, "C202", "minimum_film_thickness"),
    "missed_bush": ("maximum_bush_temperature",),
    "missed_temperature": ("outlet_temperature",),
    "missed_hottest": TEMPERATURE_CHECKS,
    "missed_mass": ("critical_mass", "critical_mass_elastic"),
    "missed_least_mass": ("least_stable_mass",),
    "missed_pressure": ("maximum_pressure", "orbit_maximum_pressure"),
    "missed_supply": ("least_supply_ratio",),
    "missed_load": ("specific_load", "largest_specific_load", "orbit_specific_load"),
    "missed_speed": ("surface_speed",),
    "missed_transition": ("hydrodynamic_speed",),
    "missed_power": ("pressure_speed_product", "orbit_pressure_speed_product"),
    "missed_decrement": ("log_decrement", "log_decrement_anticipated"),
    "missed_laminar": ("film_reynolds_number",),
}
"""Messages of missed limits that are no bare numbers, by code or quantity."""


def missed_limit(check: Check, code: str) -> Notice:
    """A clause of a code that says which limit is missed, and by what."""
    names = {check.code, check.quantity, whole(check.quantity)}
    other = "missed_degrees" if check.is_in_kelvin else "missed_other"
    variant = next((one for one, known in MISSED.items() if names & set(known)), other)
    return Notice(code, variant, {"value": check.value, "limit": check.limit, "check": check.code})
