"""Checks of values that only bound the real ones from their favourable side: a miss is certain, a pass is none."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.conditions import CheckedProblem

__all__ = ["FILM_CHECKS", "NO_BOUNDS", "TEMPERATURE_CHECKS", "Bounds", "bounds_of", "certain", "undecided"]

Bounds = Mapping[str, Notice]
"""Codes of checks whose value flatters the bearing, each with the reason why keeping the limit says nothing."""

NO_BOUNDS: Bounds = {}

FILM_CHECKS = ("C101", "C102")
"""Limits of the film thickness."""
TEMPERATURE_CHECKS = ("C104", "C108", "C109")
"""Limits of the temperature: of the oil, and of the bearing metal."""


def bounds_of(case: CheckedProblem) -> Bounds:
    """Bounds of every method.

    Where the temperature is prescribed, the hottest place is at least that warm; a film that is prescribed cooler
    than its fresh oil is thicker than any that the oil can make; and where of the surfaces the slope of the axis
    alone is known, the least film is at least what it takes.
    """
    bearing = case.bearing
    found = {}
    if bearing.surfaces is None and bearing.edge_loss > 0.0:
        found["C102"] = Notice("C102", "slope_alone", {"loss": bearing.edge_loss})
    if case.effective_temperature is None:
        return found
    found |= {code: Notice(code, "prescribed_temperature") for code in TEMPERATURE_CHECKS}
    if case.oil_supply is not None and case.effective_temperature < case.oil_supply.temperature:
        found |= {code: Notice(code, "prescribed_cooler") for code in FILM_CHECKS}
    return found


def certain(checks: Iterable[Check], bounds: Bounds) -> tuple[Check, ...]:
    """Leave out the checks that a favourable bound keeps."""
    return tuple(check for check in checks if not _says_nothing(check, bounds)) if bounds else tuple(checks)


def undecided(checks: Iterable[Check], bounds: Bounds) -> tuple[Notice, ...]:
    """Give the reasons of those left out by `certain`."""
    return tuple(bounds[check.code] for check in checks if _says_nothing(check, bounds)) if bounds else ()


def _says_nothing(check: Check, bounds: Bounds) -> bool:
    return check.code in bounds and check.ok
