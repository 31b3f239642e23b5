"""What stands against the limits of a clearance whose mean alone is solved and passes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Any

from babbitt.core.notices import Notice
from babbitt.core.result import Result, Verdict
from babbitt.design.conditions import PrescribedLoad
from babbitt.kinds.journal.iso7902.model import DesignCase

__all__ = ["at_limits", "beside_limits"]


def beside_limits(case: DesignCase, solve: Callable[[DesignCase], Result]) -> Result:
    """Solve a bearing at its clearance, and say what stands against limits of which it passes the mean alone."""
    found = solve(case)
    if not (case.mean_alone and found.verdict is Verdict.PASS):
        return found
    missed = _about_missed_limits((limit, solve(other)) for limit, other in at_limits(case))
    return replace(found, warnings=(*found.warnings, *missed))


def at_limits(case: DesignCase) -> Iterator[tuple[Any, DesignCase]]:
    """The least and the greatest relative clearance at 20 °C, and the bearing with each under its load.

    Nothing where the position is prescribed, whose load goes with the clearance.
    """
    bearing = case.bearing
    if bearing.clearance_tolerance is None or not isinstance(case.duty, PrescribedLoad):
        return
    for limit in bearing.clearance_tolerance:
        yield limit, case.at_clearance(limit)


def _about_missed_limits(found: Iterable[tuple[float, Result]]) -> Iterator[Notice]:
    """Warn of clearances at which a bearing misses limits that it keeps at the mean, or is questioned.

    Parameters
    ----------
    found : iterable of (float, Result)
        Relative clearances, and what the bearing comes to there.
    """
    missed = tuple(notice for clearance, result in found for notice in _missed(clearance, result))
    if missed:
        yield Notice("W174", "missed", {"missed": missed})


def _missed(clearance: float, result: Result) -> Iterator[Notice]:
    if not result.outcome.solved:
        yield Notice("W174", "no_film", {"clearance": clearance})
        return
    codes = tuple(dict.fromkeys(one.code for one in result.limits if not one.ok))
    if codes:
        yield Notice("W174", "misses", {"clearance": clearance, "checks": codes})
    elif result.verdict is Verdict.NO_VERDICT:
        yield Notice("W174", "no_verdict", {"clearance": clearance})
    elif result.verdict is Verdict.REMARKS:
        yield Notice("W174", "questioned", {"clearance": clearance, "remarks": result.questioning_codes})
