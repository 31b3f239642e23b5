"""What arrives at the supply element: the pressure left after the losses on the way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from babbitt.design.conditions import OilSupply
from babbitt.design.ducts import Duct
from babbitt.design.roots import bracketed_root
from babbitt.lubricants import Lubricant


@dataclass(frozen=True)
class Arrival:
    """Pressure at the supply element and losses on the way in Pa, and the whole flow in m³/s.

    `starved` means that the losses would eat all the supply pressure; the element is then at ambient pressure.
    """

    element_pressure: float
    tube_loss: float
    hole_loss: float
    flow: float
    starved: bool = False


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

    starved = surplus(0.0) <= 0.0
    pressure = 0.0 if starved else bracketed_root(surplus, 0.0, supply.pressure, 1e-6, 1e-12)
    flow = flow_at(pressure)
    return Arrival(pressure, losses(supply.tubes, flow), losses(supply.holes, flow), flow, starved)
