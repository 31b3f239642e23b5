"""Temperature of the oil in the film: supply plus the rise by friction and by all pressure that it loses.

What it loses in the restrictor warms it before it comes to the film.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from babbitt.design.heat_balance import CEILING
from babbitt.kinds.hydrostatic.answer import Answer, answer
from babbitt.kinds.hydrostatic.friction import friction_power
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.pumping import pumping_power
from babbitt.kinds.hydrostatic.state import SearchOutcome
from babbitt.numerics.roots import find_root

__all__ = ["HeatedBearing", "heated"]

TOLERANCE = 1e-6
"""K, of the temperature of the oil."""

FIRST_STEP = 1.0
"""K; the least by which the search for an upper bound steps."""

MOST_HALVINGS = 12
"""Halvings towards the coldest film that is known, where a warmer one carries nothing."""


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
        Of the oil in the film, K; None where the viscosity is given.
    heat_error : float
        What the oil would be warmed by less what it is, over its rise.
    """

    case: HydrostaticCase
    found: Answer
    temperature: float | None = None
    heat_error: float = 0.0


def heated(case: HydrostaticCase) -> HeatedBearing:
    """The bearing with the oil at the temperature of its film.

    With a lubricant and a supply temperature the film is as warm as the oil leaves it. The root of the heat
    balance is bracketed between the supply temperature and 300 degC (`babbitt.design.heat_balance.CEILING`).

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
    if supply is None or case.oil.lubricant is None:
        return HeatedBearing(case, answer(case))
    cold = _at(case, supply)
    if cold.found.ending is not SearchOutcome.SOLVED:
        return cold
    low, high = supply, supply + _excess(cold)
    halvings = 0
    while True:
        high = min(high, CEILING)
        hot = _at(case, high)
        if hot.found.ending is not SearchOutcome.SOLVED:
            halvings += 1
            if halvings > MOST_HALVINGS:
                return hot
            high = 0.5 * (low + high)
        elif _excess(hot) <= 0.0:
            break
        elif high >= CEILING:
            return replace(hot, found=replace(hot.found, ending=SearchOutcome.THERMAL_RUNAWAY))
        elif halvings:
            low, high = high, 2.0 * high - low
        else:
            low, high = high, high + max(2.0 * _excess(hot), FIRST_STEP)

    def excess(temperature: float) -> float:
        state = _at(case, temperature)
        return _excess(state) if state.found.ending is SearchOutcome.SOLVED else math.nan

    root = find_root(excess, low, high, absolute=TOLERANCE)
    state = _at(case, root.value)
    if not root.converged and state.found.ending is SearchOutcome.SOLVED:
        return replace(state, found=replace(state.found, ending=SearchOutcome.NOT_CONVERGED))
    return state


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
