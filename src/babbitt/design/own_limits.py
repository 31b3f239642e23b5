"""Limits that the case sets, or a bearing metal of one's own, in place of stricter ones."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.checks import highest_specific_load, limit_checks
from babbitt.design.conditions import CheckedProblem, Limits, Values
from babbitt.design.missed_limit import missed_limit

__all__ = ["asked_for_margins", "checks_by_experience", "missed_but_for_own"]

REPLACED = ("C101", "C103", "C104", "C105", "C106", "C107", "C108")
"""Checks whose limits a case may set."""

OF_MARGINS = ("C101", "C108")
"""Those of them of which films are asked for margins; C104 holds for the oil that leaves."""


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
    """Checks of the case, and limits of film and metal that those of the case stand in place of."""
    known = {(check.code, check.source) for check in checks}
    beside = (one for one in replaced if one.code in OF_MARGINS and (one.code, one.source) not in known)
    return (*checks, *beside)


def checks_by_experience(case: CheckedProblem, values: Values) -> tuple[Check, ...]:
    """Checks by experience and catalogue where the case has limits of its own; none where it has none."""
    own, metal = case.limits, case.bearing.metal
    usual = None if metal is None else metal.stands_for
    if own == Limits(tables=own.tables) and usual is None:
        return ()
    whole: Any = case
    plain = replace(
        whole,
        limits=Limits(tables=own.tables),
        bearing=whole.bearing if usual is None else replace(whole.bearing, metal=usual),
    )
    found = tuple(check for check in limit_checks(plain, values) if check.code in REPLACED)
    if any(check.code == "C103" for check in found):
        return found
    return (*found, highest_specific_load("specific_load", values, own.tables))
