"""Temperature of the oil in the film: supply plus the rise by friction and by all pressure that it loses.

What it loses in the restrictor warms it before it comes to the film.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache

from babbitt.core.result import Outcome
from babbitt.design.heat_balance import BOLD, NoFilmError, coolest_equilibrium
from babbitt.kinds.hydrostatic.answer import Answer, answer
from babbitt.kinds.hydrostatic.friction import friction_power
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.pumping import pumping_power
from babbitt.kinds.hydrostatic.state import SearchOutcome

__all__ = ["HeatedBearing", "heated"]

TOLERANCE = 1e-6
"""K, of the temperature of the oil."""

FIRST_STEP = 1.0
"""K; the first step of the search is the rise of the coldest film, at least this."""


@dataclass(frozen=True)
class HeatedBearing:
    """A bearing at the temperature of its oil.

    Attributes
    ----------
    case : HydrostaticCase
        With the oil at that temperature.
    found : Answer
        Its state. `SearchOutcome.THERMAL_RUNAWAY` where the oil is hotter than any temperature allowed.
    temperature : float or None
        Of the oil in the film, K, found or given; None where the viscosity is given.
    heat_error : float
        What the oil would be warmed by less what it is, over its rise.
    """

    case: HydrostaticCase
    found: Answer
    temperature: float | None = None
    heat_error: float = 0.0


def heated(case: HydrostaticCase) -> HeatedBearing:
    """The bearing with the oil at the temperature of its film.

    With a lubricant and a supply temperature the film is as warm as the oil leaves it, at most 300 degC
    (`babbitt.design.heat_balance.coolest_equilibrium`).

    Parameters
    ----------
    case : HydrostaticCase

    Returns
    -------
    HeatedBearing
        A film that is lost while its oil warms up ends as it was lost; one whose heat the oil does not carry
        off at 300 degC as a thermal runaway.
    """
    supply = case.oil.supply_temperature
    if supply is None or not case.oil.is_warmed:
        return HeatedBearing(case, answer(case), case.oil.film_temperature)

    lost: list[HeatedBearing] = []

    @cache
    def film_at(temperature: float) -> HeatedBearing:
        state = _at(case, temperature)
        if state.found.ending is SearchOutcome.SOLVED:
            return state
        lost.append(state)
        raise NoFilmError(Outcome.NOT_CONVERGED)

    try:
        policy = replace(BOLD, step=max(_excess(film_at(supply)), FIRST_STEP), tolerance=TOLERANCE)
    except NoFilmError:
        return lost[0]
    ended = coolest_equilibrium(film_at, lambda _, state: _excess(state), supply, policy)
    if ended.failure is not None:
        return lost[-1]  # the coldest one
    assert ended.film is not None  # that of the supply temperature is known
    ending = {Outcome.CONVERGED: SearchOutcome.SOLVED, Outcome.THERMAL_RUNAWAY: SearchOutcome.THERMAL_RUNAWAY}
    return replace(
        ended.film, found=replace(ended.film.found, ending=ending.get(ended.outcome, SearchOutcome.NOT_CONVERGED))
    )


def _at(case: HydrostaticCase, temperature: float) -> HeatedBearing:
    """The bearing with its oil at a temperature in K."""
    warm = replace(case, oil=case.oil.at(temperature))
    found = answer(warm)
    if found.ending is not SearchOutcome.SOLVED:
        return HeatedBearing(warm, found, temperature, math.nan)
    rise = temperature_rise(warm, found)
    supply = case.oil.supply_temperature
    assert supply is not None
    return HeatedBearing(warm, found, temperature, (supply + rise - temperature) / rise)


def _excess(state: HeatedBearing) -> float:
    """What the oil would be warmed by more than it is, K."""
    return state.heat_error * temperature_rise(state.case, state.found)


def temperature_rise(case: HydrostaticCase, found: Answer) -> float:
    """Rise of the oil by friction and by the pressure that it loses in restrictors and film, K."""
    flow = float(found.network.flows.sum())
    lost = pumping_power(case, found.network) + friction_power(case, found)
    return lost / (case.oil.density * case.oil.heat_capacity * flow)
