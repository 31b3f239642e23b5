"""How far an unsolved bearing came and what to try."""

from __future__ import annotations

import math

from babbitt.core.notices import Notice
from babbitt.core.result import Outcome
from babbitt.design.conditions import PrescribedLoad
from babbitt.design.failure import failure_of
from babbitt.design.heat_balance import Equilibrium
from babbitt.kinds.tilting_pad_journal.model import SAME_LINE, PadCase, on_one_line
from babbitt.kinds.tilting_pad_journal.state import PadFilms

__all__ = ["failure_of_pads", "feasible_growth"]


def failure_of_pads(case: PadCase, found: Equilibrium[PadFilms]) -> Notice:
    """How far an unsolved bearing came, and what to try."""
    if (share := feasible_growth(found)) is not None:
        return Notice("S003", "pad_growth", {"growth_share": share})
    if found.outcome is Outcome.THERMAL_RUNAWAY and case.thermal.is_resolved:
        return Notice("S002", "hot_films", {"reached": found.last_temperature})
    if found.outcome is Outcome.OVERLOADED:
        return Notice("S001", "pad_touches", {"reached": found.last_temperature})
    if found.outcome is Outcome.NOT_CONVERGED and (across := load_across(case)) > 0.0:
        return Notice("S004", "one_line", {"across": across})
    if found.outcome is not Outcome.PAD_AT_LIMIT or found.film is None:
        failure = failure_of(case, found)
        dry = failure.variant == "tried_dry"  # which advises a supply pressure, and pads have none
        return Notice(failure.code, "tried", {"far": failure.values["far"]}) if dry else failure
    solution = found.film.solution
    need, least = solution.limit_loads or (math.nan, math.nan)
    return Notice("S401", values={"pad": (solution.limit_pad or 0) + 1, "need": need, "least": least})


def feasible_growth(found: Equilibrium[PadFilms]) -> float | None:
    """Largest share of the growth at which a film was found, of a bearing that its growth closes; else None."""
    thermal = None if found.film is None else found.film.thermal
    closed = thermal is not None and found.outcome is Outcome.NO_CLEARANCE
    return thermal.growth_share if closed and thermal is not None else None


def load_across(case: PadCase) -> float:
    """Load in N across the line on which the pivots of all pads stand; 0 of pads that stand on none."""
    angles = [pad.pivot_angle for pad in case.bearing.pads]
    if not isinstance(case.duty, PrescribedLoad) or not on_one_line(angles):
        return 0.0
    across = abs(math.sin(case.load_angle - angles[0]))
    return case.duty.load * across if across > SAME_LINE else 0.0
