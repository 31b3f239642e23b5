"""Limits that the case sets, or a bearing metal of one's own, in place of stricter ones."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.design.checks import film_of_nearest_diameter, highest_specific_load, limit_checks
from babbitt.design.conditions import CheckedProblem, Limits, Values
from babbitt.design.missed_limit import missed_limit
from babbitt.properties.materials import (
    BearingMetal,
    ExperienceLimits,
    highest_metal_temperature,
    published_metal_temperature,
)

__all__ = [
    "asked_for_margins",
    "checks_by_experience",
    "missed_but_for_own",
    "of_unknown_metal",
    "sets_specific_load",
]

REPLACED = ("C101", "C103", "C104", "C105", "C106", "C107", "C108")
"""Checks whose limits a case may set; that of the transition (C111) never lets a film pass that C102 does not."""

OF_MARGINS = ("C101", "C108", "C202", "C401", "C407")
"""Checks of which films are asked for margins; C104 holds for the oil that leaves."""


def missed_but_for_own(
    checks: Iterable[Check], replaced: Iterable[Check], variant: str = "kept"
) -> Iterator[Notice]:
    """Warn of limits that are kept because the case sets them, and missed of those that they stand in place of.

    Parameters
    ----------
    checks : iterable of Check
        With the limits of the case.
    replaced : iterable of Check
        Without them.
    variant : str
        Of the message; ``orbit`` for the worst instants of one.
    """
    missed = {check.code for check in checks if not check.advisory and not check.ok}
    told = tuple(
        missed_limit(check, "W219")
        for check in replaced
        if not check.advisory and check.code not in missed and not check.ok
    )
    if told:
        yield Notice("W219", variant, {"told": told})


def asked_for_margins(checks: Iterable[Check], replaced: Iterable[Check]) -> tuple[Check, ...]:
    """Checks of the case, and the stricter limits of film and metal that they stand in place of."""
    held = tuple(checks)
    return (*held, *(one for one in replaced if one.code in OF_MARGINS and _is_stricter(one, held)))


def _is_stricter(one: Check, checks: Iterable[Check]) -> bool:
    """Whether a limit asks for more than all others of its code and quantity."""
    least = one.bound is Bound.AT_LEAST
    alike = (other for other in checks if (other.code, other.quantity) == (one.code, one.quantity))
    return all(one.limit > other.limit if least else one.limit < other.limit for other in alike)


def checks_by_experience(case: CheckedProblem, values: Values) -> tuple[Check, ...]:
    """Checks by experience and catalogue where the case has limits of its own; none where it has none.

    What a case says of a metal of no family is held against the highest limits of any, and a film thickness at a
    diameter beyond experience against that of the nearest.
    """
    own, metal = case.limits, case.bearing.metal
    usual = None if metal is None else metal.without_own_limits
    if own == Limits(tables=own.tables) and usual is metal:
        return ()
    whole: Any = case
    plain = replace(whole, limits=Limits(tables=own.tables), bearing=replace(whole.bearing, metal=usual))
    found = tuple(check for check in limit_checks(plain, values) if check.code in REPLACED)
    if own.minimum_film_thickness is not None and not any(check.code == "C101" for check in found):
        found = (*found, film_of_nearest_diameter(case, values))
    sets_load = own.specific_load is not None or sets_specific_load(metal)
    of_load = highest_specific_load("specific_load", values, own.tables) if sets_load else None
    return of_unknown_metal(found, metal, of_load, own.tables)


def sets_specific_load(metal: BearingMetal | None) -> bool:
    """Whether the case gives a specific load to its metal."""
    return metal is not None and metal.calm.specific_load != metal.without_own_limits.calm.specific_load


def of_unknown_metal(
    checks: tuple[Check, ...],
    metal: BearingMetal | None,
    of_load: Check | None,
    tables: ExperienceLimits | None = None,
) -> tuple[Check, ...]:
    """Checks with the highest limits of any family in place of what a case alone knows of a metal of no family.

    Parameters
    ----------
    checks : tuple of Check
        By experience and catalogue.
    metal : BearingMetal or None
        As the case has it.
    of_load : Check or None
        The specific load against the highest limit, where the case sets one.
    tables : ExperienceLimits, optional
    """
    usual = None if metal is None else metal.without_own_limits
    tells = metal is not usual and metal is not None and metal.limiting_temperature is not None
    if tells and published_metal_temperature(usual, tables) is None:
        highest = highest_metal_temperature(tables)
        checks = tuple(
            replace(one, limit=highest.value, source=highest.source) if one.code == "C108" else one
            for one in checks
        )
    return checks if of_load is None or any(one.code == "C103" for one in checks) else (*checks, of_load)
