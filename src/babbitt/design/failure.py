"""How far an unsolved case came and what to try, in words."""

from __future__ import annotations

from babbitt.core.notices import explanations
from babbitt.core.result import Outcome
from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.conditions import CheckedProblem, PrescribedLoad
from babbitt.design.heat_balance import Equilibrium, FilmT

__all__ = ["STARVED", "STARVED_REMEDY", "failure"]

STARVED = (
    "a closed pocket or hole (flow: 0 L/min) runs empty: at the pressure at which the film breaks it would still "
    "send off more oil than reaches it"
)
STARVED_REMEDY = "a place where the film is full, or a pressure that feeds it."


def failure(case: CheckedProblem, found: Equilibrium[FilmT]) -> str:
    """Say how far an unsolved case came, and what to try."""
    least_flow = found.failure.least_flow if found.failure else None
    reached = f"{found.last_temperature - ZERO_CELSIUS:.1f} °C"
    match found.outcome:
        case Outcome.OVERLOADED if least_flow is not None:
            needed = f"a film needs about {least_flow * 6e4:.3g} L/min"
            return (
                f"at {reached} the oil given is too little for this load: {needed}. Try: more oil, less load, "
                "a more viscous or cooler oil."
            )
        case Outcome.OVERLOADED:
            far = f"at {reached} {_carried(found.failure.capacity if found.failure else None)}"
            if isinstance(case.duty, PrescribedLoad):
                far += f", less than the load of {_kilonewtons(case.duty.load)} kN"
        case Outcome.THERMAL_RUNAWAY:
            far = f"at {reached} the friction power still exceeds the heat carried away"
        case Outcome.NO_CLEARANCE:
            far = f"the clearance is used up at {reached}"
        case Outcome.NO_LUBRICANT_DATA:
            far = f"the laws of {case.lubricant.name} were followed to {reached}"
        case Outcome.STARVED_RECESS:
            return f"at {reached} {STARVED}. Try: {STARVED_REMEDY}"
        case Outcome.OUTSIDE_CLEARANCE:
            far = f"at {reached} the journal would touch or cut the bore there"
        case Outcome.WORK_BOUND:
            far = f"at {reached} the search for the equilibrium had used up the work allowed for its grid"
        case _ if found.film is None:
            far = f"no equilibrium of the journal was found at {reached}"
        case _:
            far = f"the last effective temperature was {reached}"
    remedy = explanations()[found.outcome.code].remedy
    supply = case.oil_supply
    if supply is not None and supply.flow is None and supply.pressure <= 0.0:
        far += "; no pressure presses oil into the film"
        remedy = f"A supply pressure, or {remedy[0].lower()}{remedy[1:]}"
    return f"{far}. Try: {remedy[0].lower()}{remedy[1:]}"


def _carried(capacity: float | None) -> str:
    if capacity is None:
        return "the film carries too little"
    return f"the film carries {_kilonewtons(capacity)} kN at the largest eccentricity, 0.99"


def _kilonewtons(force: float) -> str:
    """A force in kN with four digits and no exponent."""
    return f"{force / 1e3:.0f}" if force >= 1e6 else f"{force / 1e3:.4g}"
