"""The effective temperature of thrust pads that share evenly (`babbitt.design.pad_heat`)."""

from __future__ import annotations

from collections.abc import Callable

from babbitt.core.result import Outcome
from babbitt.design.heat_balance import BOLD, Equilibrium, FilmT, coolest_equilibrium
from babbitt.design.pad_heat import HeatBalance, Temperatures, mixed_temperatures
from babbitt.kinds.thrust.failures import OpenHeatBalanceError, ThermalRunawayError
from babbitt.kinds.thrust.load_curve import LoadCurve
from babbitt.kinds.thrust.state import PadState

__all__ = ["USUAL_CARRY_OVER", "balanced", "film_of", "temperatures_of"]

USUAL_CARRY_OVER = 0.75
"""Assumption: share of the hot oil of a pad that enters the next one; 0.7 to 0.9 are found at usual speeds."""


def temperatures_of(balance: HeatBalance, states: tuple[PadState, ...], effective: float) -> Temperatures:
    """Temperatures that follow from the films at an effective temperature (K)."""
    power = sum(state.friction_power for state in states)
    trailing = sum(state.trailing_flow for state in states)
    return mixed_temperatures(balance, power, trailing, sum(state.side_flow for state in states), effective)


def balanced(
    balance: HeatBalance,
    films: LoadCurve,
    speed: float,
    pads_on: Callable[[LoadCurve], tuple[PadState, ...]],
) -> tuple[LoadCurve, Temperatures]:
    """Effective temperature at which friction heats the oil to it.

    Parameters
    ----------
    balance : HeatBalance
    films : LoadCurve
        Of the pad at any viscosity.
    speed : float
        rad/s.
    pads_on : callable
        Gives the films of all pads in a given oil.

    Returns
    -------
    Carrying
        In the oil of the balance.
    Temperatures

    Raises
    ------
    ThermalRunawayError
        If friction outruns the oil up to 300 °C.
    """

    def film_at(temperature: float) -> tuple[LoadCurve, Temperatures]:
        in_oil = films.at(float(balance.lubricant.dynamic_viscosity(temperature)), speed)
        return in_oil, temperatures_of(balance, pads_on(in_oil), temperature)

    def surplus(temperature: float, film: tuple[LoadCurve, Temperatures]) -> float:
        return film[1].effective - temperature

    return film_of(coolest_equilibrium(film_at, surplus, balance.supply_temperature, BOLD))


def film_of(ended: Equilibrium[FilmT]) -> FilmT:
    """The film at which a heat balance ended; raises `NoPadFilmError` where it did not close."""
    if ended.film is not None and ended.outcome.solved:
        return ended.film
    if ended.failure is not None:
        raise ended.failure
    raise ThermalRunawayError if ended.outcome is Outcome.THERMAL_RUNAWAY else OpenHeatBalanceError
