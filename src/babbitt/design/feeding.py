"""What arrives at the supply element: the pressure left after the losses on the way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from babbitt.design.conditions import OilSupply
from babbitt.design.ducts import Duct
from babbitt.numerics.roots import bracketed_root
from babbitt.properties.lubricants import Lubricant


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


def arrival(supply: OilSupply, oil: Lubricant, flow_at: Callable[[float], float]) -> Arrival:
    """Balance the pressure at the supply element with the losses of the flow it drives.

    ``p_en = p_s - Δp(Q(p_en))``; the oil in tubes and holes has inlet temperature.

    Parameters
    ----------
    supply : OilSupply
    oil : Lubricant
    flow_at : callable
        Whole flow in m³/s at a pressure in Pa at the supply element, not falling with it.
    """
    if not supply.tubes and not supply.holes:
        return Arrival(supply.pressure, 0.0, 0.0, flow_at(supply.pressure))
    density, kinematic = oil.density(supply.temperature), oil.kinematic_viscosity(supply.temperature)

    def losses(ducts: tuple[Duct, ...], flow: float) -> float:
        return sum(duct.pressure_loss(flow, density, kinematic) for duct in ducts)

    def surplus(pressure: float) -> float:
        flow = flow_at(pressure)
        return supply.pressure - losses(supply.tubes, flow) - losses(supply.holes, flow) - pressure

    if surplus(0.0) <= 0.0:
        wanted = flow_at(0.0)
        limit = _most_passed(supply, losses, wanted)
        return Arrival(0.0, losses(supply.tubes, limit), losses(supply.holes, limit), wanted, limit)
    pressure = bracketed_root(surplus, 0.0, supply.pressure, 1e-6, 1e-12)
    flow = flow_at(pressure)
    return Arrival(pressure, losses(supply.tubes, flow), losses(supply.holes, flow), flow)


def _most_passed(supply: OilSupply, losses: Callable[[tuple[Duct, ...], float], float], too_much: float) -> float:
    """Flow in m³/s that tubes and holes pass at the whole supply pressure; one of `too_much` would need more."""
    if supply.pressure <= 0.0:
        return 0.0

    def needed(flow: float) -> float:
        return losses(supply.tubes, flow) + losses(supply.holes, flow) - supply.pressure

    return bracketed_root(needed, 0.0, too_much, 0.0, 1e-12)
