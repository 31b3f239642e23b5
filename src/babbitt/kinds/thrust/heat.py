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

import math
from collections.abc import Callable
from dataclasses import dataclass

from babbitt.kinds.thrust.failures import NoPadFilmError, ThermalRunawayError
from babbitt.kinds.thrust.load_curve import LoadCurve
from babbitt.kinds.thrust.state import PadState
from babbitt.properties.lubricants import Lubricant

__all__ = [
    "HeatBalance",
    "Temperatures",
    "USUAL_CARRY_OVER",
    "balanced",
]

USUAL_CARRY_OVER = 0.75
"""Assumption: share of the hot oil of a pad that enters the next one; 0.7 to 0.9 are found at usual speeds."""

HOTTEST = 573.15
"""Effective temperature up to which a balance is sought, K."""
STEPS = 60
THIN_WITHIN = 0.05
"""Between a temperature at which pads have a film and one at which they have none, K, where the search ends."""
TOLERANCE = 1e-7
"""Of the effective temperature, K."""


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


def temperatures_of(balance: HeatBalance, states: tuple[PadState, ...], effective: float) -> Temperatures:
    """Temperatures that follow from the films at an effective temperature (K)."""
    power = sum(state.friction_power for state in states)
    trailing = sum(state.trailing_flow for state in states)
    side = sum(state.side_flow for state in states)
    heat = float(balance.lubricant.volumetric_heat_capacity(effective))
    carried = balance.carry_over * trailing
    entering = trailing + side
    rise = power / (heat * (trailing + 0.5 * side))
    supply = balance.supply_temperature
    inlet = supply + carried * rise / (entering - carried)
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
    from babbitt.numerics.roots import bracketed_root

    def at(temperature: float) -> LoadCurve:
        return films.at(float(balance.lubricant.dynamic_viscosity(temperature)), speed)

    def excess(temperature: float) -> float:
        return temperatures_of(balance, pads_on(at(temperature)), temperature).effective - temperature

    low, high = _bracket(excess, balance.supply_temperature)
    effective = bracketed_root(excess, low, high, absolute=TOLERANCE)
    found = at(effective)
    return found, temperatures_of(balance, pads_on(found), effective)


def _bracket(excess: Callable[[float], float], supply: float) -> tuple[float, float]:
    """Temperatures between which friction stops to outrun the oil, K, sought upward from the supply.

    Oil too thin for any film bounds the search from above: the balance may lie before it.
    """
    low, high, thin = supply, supply + 10.0, math.inf
    without_film: NoPadFilmError = ThermalRunawayError()
    while low < HOTTEST and thin - low > THIN_WITHIN:
        try:
            if excess(high) <= 0.0:
                return low, min(high, HOTTEST + 60.0)
            low, high = high, high + 2.0 * (high - supply)
        except NoPadFilmError as failure:
            thin, without_film = high, failure
        if high >= thin:
            high = 0.5 * (low + thin)
    raise without_film
