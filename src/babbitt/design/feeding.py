"""What arrives at the supply element: the pressure left after the losses on the way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from babbitt.core.result import Outcome
from babbitt.design.conditions import OilSupply
from babbitt.design.ducts import Duct
from babbitt.design.heat_balance import NoFilmError
from babbitt.numerics.roots import bracketed_root
from babbitt.properties.lubricants import Lubricant

NO_LONGER = 0.01
"""Share of the missing pressure within which the lowest pressure with a film is sought."""

IMBALANCE = 1e-5
"""Share of the supply pressure up to which pressure and losses may miss it; flows that jump meet it nowhere."""


@dataclass(frozen=True)
class Arrival:
    """Pressure at the supply element and losses on the way in Pa, and the whole flow in m³/s that the film wants.

    `limit` is known where the losses would eat all the supply pressure: the flow in m³/s that tubes and holes pass
    at the whole of it. The element is then at ambient pressure, and the losses are those of that flow.
    """

    element_pressure: float
    tube_loss: float
    hole_loss: float
    flow: float
    limit: float | None = None


def arrival(supply: OilSupply, oil: Lubricant, flow_at: Callable[[float], float | None]) -> Arrival:
    """Balance the pressure at the supply element with the losses of the flow it drives.

    ``p_en = p_s - Δp(Q(p_en))``; the oil in tubes and holes has inlet temperature.

    Parameters
    ----------
    supply : OilSupply
    oil : Lubricant
    flow_at : callable
        Whole flow in m³/s at a pressure in Pa at the supply element, not falling with it; None where that
        pressure is too low for a film: none flows there, and the pressure rises.

    Raises
    ------
    NoFilmError
        As overloaded, with the least flow of a film, where every film takes more than tubes and holes pass; as not
        converged where the flow jumps past what they pass.
    """
    if not supply.tubes and not supply.holes:
        return Arrival(supply.pressure, 0.0, 0.0, flow_at(supply.pressure) or 0.0)
    density, kinematic = oil.density(supply.temperature), oil.kinematic_viscosity(supply.temperature)

    def losses(ducts: tuple[Duct, ...], flow: float) -> float:
        return sum(duct.pressure_loss(flow, density, kinematic) for duct in ducts)

    def surplus_with(flow: float, pressure: float) -> float:
        return supply.pressure - losses(supply.tubes, flow) - losses(supply.holes, flow) - pressure

    def surplus(pressure: float) -> float:
        return surplus_with(flow_at(pressure) or 0.0, pressure)

    wanted = flow_at(0.0)
    if wanted is not None and surplus_with(wanted, 0.0) <= 0.0:
        limit = _most_passed(supply, losses, wanted)
        return Arrival(0.0, losses(supply.tubes, limit), losses(supply.holes, limit), wanted, limit)
    low, high = 0.0, supply.pressure
    if wanted is None:
        low, high = _pressures_with_film(high, flow_at, surplus_with)
    pressure = bracketed_root(surplus, low, high, 1e-6, 1e-12)
    if abs(surplus(pressure)) > IMBALANCE * supply.pressure:
        raise NoFilmError(Outcome.NOT_CONVERGED)
    flow = flow_at(pressure) or 0.0
    return Arrival(pressure, losses(supply.tubes, flow), losses(supply.holes, flow), flow)


def _pressures_with_film(
    highest: float, flow_at: Callable[[float], float | None], surplus_with: Callable[[float, float], float]
) -> tuple[float, float]:
    """Two pressures in Pa up to `highest` with films that take less and more than the ducts pass, by bisection.

    Raises
    ------
    NoFilmError
        When the film with the lowest pressure takes more.
    """
    without = 0.0
    low = high = highest
    least = flow_at(low) or 0.0
    surplus = surplus_with(least, low)
    while surplus < 0.0:
        if low - without < NO_LONGER * -surplus:
            raise NoFilmError(Outcome.OVERLOADED, least_flow=least)
        middle = (without + low) / 2.0
        flow = flow_at(middle)
        if flow is None:
            without = middle
        else:
            low, high, least, surplus = middle, low, flow, surplus_with(flow, middle)
    return low, high


def _most_passed(supply: OilSupply, losses: Callable[[tuple[Duct, ...], float], float], too_much: float) -> float:
    """Flow in m³/s that tubes and holes pass at the whole supply pressure; one of `too_much` would need more."""
    if supply.pressure <= 0.0:
        return 0.0

    def needed(flow: float) -> float:
        return losses(supply.tubes, flow) + losses(supply.holes, flow) - supply.pressure

    return bracketed_root(needed, 0.0, too_much, 0.0, 1e-12)
