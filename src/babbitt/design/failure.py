"""How far an unsolved case came and what to try."""

from __future__ import annotations

from babbitt.core.notices import Notice
from babbitt.core.result import Outcome
from babbitt.design.conditions import CheckedProblem, PrescribedLoad
from babbitt.design.heat_balance import Equilibrium, FilmT

__all__ = ["failure_of"]


def failure_of(case: CheckedProblem, found: Equilibrium[FilmT]) -> Notice:
    """How far an unsolved case came, and what to try."""
    code, reached = found.outcome.code, found.last_temperature
    least_flow = found.failure.least_flow if found.failure else None
    match found.outcome:
        case Outcome.OVERLOADED if least_flow is not None:
            return Notice("S001", "little_oil", {"reached": reached, "flow": least_flow})
        case Outcome.STARVED_RECESS:
            return Notice("S302", "pocket_at", {"reached": reached, "empty": Notice("S302", "pocket")})
        case Outcome.OVERLOADED:
            far = _overloaded(case, reached, found.failure.capacity if found.failure else None)
        case Outcome.THERMAL_RUNAWAY | Outcome.NO_CLEARANCE | Outcome.OUTSIDE_CLEARANCE | Outcome.WORK_BOUND:
            far = Notice(code, "far", {"reached": reached})
        case Outcome.NO_LUBRICANT_DATA:
            far = Notice("S005", "far", {"lubricant": case.lubricant.name, "reached": reached})
        case _:
            far = Notice(code, "no_place" if found.film is None else "last_temperature", {"reached": reached})
    supply = case.oil_supply
    dry = supply is not None and supply.flow is None and supply.pressure <= 0.0
    return Notice(code, "tried_dry" if dry else "tried", {"far": far})


def _overloaded(case: CheckedProblem, reached: float, capacity: float | None) -> Notice:
    asked = Notice("S001", "asked", {"load": case.duty.load}) if isinstance(case.duty, PrescribedLoad) else ""
    if capacity is None:
        return Notice("S001", "carries_little", {"reached": reached, "asked": asked})
    return Notice("S001", "carries", {"reached": reached, "carried": capacity, "asked": asked})
