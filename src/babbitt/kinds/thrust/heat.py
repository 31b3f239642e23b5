"""The effective temperature of pads that share evenly, with mixing in the grooves between them.

Of the oil that leaves a pad over its trailing edge the share ``carry_over`` enters the next pad, mixed with fresh
oil of the supply to what the leading edge draws in:

    Q_in T_in = lambda Q_t T_t + (Q_in - lambda Q_t) T_s,    T_t = T_in + dT,
    P = rho c dT (Q_t + Q_s / 2),    T_eff = T_in + dT / 2,

with the side flow Q_s leaving at the mean temperature of the pad; all heat goes with the oil. These are the
balances of M. K. Ghosh, B. C. Majumdar and M. Sarangi, Fundamentals of Fluid Film Lubrication (2014), and of
C. M. Ettles (1969) for the groove. They close the energy of the bearing: P = rho c (Q_in - lambda Q_t)(T_drain -
T_s).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from babbitt.core.result import Outcome
from babbitt.design.heat_balance import BOLD, Equilibrium, FilmT, coolest_equilibrium
from babbitt.kinds.thrust.failures import OpenHeatBalanceError, ThermalRunawayError
from babbitt.kinds.thrust.load_curve import LoadCurve
from babbitt.kinds.thrust.state import PadState, PadTemperatures
from babbitt.properties.lubricants import Lubricant

__all__ = [
    "HeatBalance",
    "Temperatures",
    "USUAL_CARRY_OVER",
    "balanced",
    "film_of",
    "pad_temperatures",
]

USUAL_CARRY_OVER = 0.75
"""Assumption: share of the hot oil of a pad that enters the next one; 0.7 to 0.9 are found at usual speeds."""


@dataclass(frozen=True)
class HeatBalance:
    """Oil and how it is mixed.

    Attributes
    ----------
    lubricant : Lubricant
    supply_temperature : float
        T_s, K.
    carry_over : float
        lambda, from 0 to 1.
    """

    lubricant: Lubricant
    supply_temperature: float
    carry_over: float = USUAL_CARRY_OVER


@dataclass(frozen=True)
class Temperatures:
    """Temperatures of the pads, K, and the flow of fresh oil, m3/s.

    ``inlet`` T_in of the pads, ``trailing`` T_t, ``drain`` of all oil that leaves the bearing, ``error`` of the
    energy over the friction power.
    """

    supply: float
    inlet: float
    trailing: float
    effective: float
    drain: float
    fresh_flow: float
    error: float


def pad_temperatures(
    balance: HeatBalance, capacity: float, power: float, trailing: float, side: float, inlet: float | None = None
) -> PadTemperatures:
    """Temperatures of pads that make heat (W) and let oil go over trailing edge and sides (m3/s).

    ``inlet`` is that of the oil taken in, K; None: of a mixture of fresh oil and of what their like send off.
    ``capacity`` is rho c, J/(m3 K).
    """
    rise = power / (capacity * (trailing + 0.5 * side))
    if inlet is None:
        carried = balance.carry_over * trailing
        inlet = balance.supply_temperature + carried * rise / (trailing + side - carried)
    return PadTemperatures(inlet, rise)


def temperatures_of(balance: HeatBalance, states: tuple[PadState, ...], effective: float) -> Temperatures:
    """Temperatures that follow from the films at an effective temperature (K)."""
    power = sum(state.friction_power for state in states)
    trailing = sum(state.trailing_flow for state in states)
    side = sum(state.side_flow for state in states)
    heat = float(balance.lubricant.volumetric_heat_capacity(effective))
    carried = balance.carry_over * trailing
    entering = trailing + side
    supply = balance.supply_temperature
    pad = pad_temperatures(balance, heat, power, trailing, side)
    inlet, rise = pad.inlet, pad.rise
    fresh = entering - carried
    drained = side * (inlet + 0.5 * rise) + (trailing - carried) * (inlet + rise)
    drain = drained / (side + trailing - carried)
    error = heat * fresh * (drain - supply) / power - 1.0
    return Temperatures(supply, inlet, inlet + rise, inlet + 0.5 * rise, drain, fresh, error)


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
