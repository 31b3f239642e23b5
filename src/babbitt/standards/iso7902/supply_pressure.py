"""What arrives at the supply element: pressure after the losses on the way, and the flow it drives."""

from __future__ import annotations

from dataclasses import dataclass

from scipy.optimize import brentq

from babbitt.standards.iso7902.losses import Duct
from babbitt.standards.iso7902.model import DesignCase


@dataclass(frozen=True)
class Feed:
    """Supply of the film: number Qp*, flow in m³/s, pressure at the element and losses in Pa.

    `starved` means that the losses would eat all the supply pressure; the element is then at ambient pressure.
    """

    flow_number: float
    flow: float
    element_pressure: float
    tube_loss: float
    hole_loss: float
    starved: bool = False


def feed(
    case: DesignCase, eccentricity_ratio: float, relative_clearance: float, viscosity: float, side_flow: float
) -> Feed | None:
    """Flow through the supply element and the pressure there, balanced with the losses of the total flow.

    ``Qp = Qp* D³ ψ³ p_en/η`` and ``p_en = p_s - Δp(Q3 + Qp)``; the oil in tubes and holes has inlet temperature.
    """
    supply, element, bearing = case.oil_supply, case.bearing.supply_element, case.bearing
    if supply is None:
        return None
    if element is None:
        return Feed(0.0, 0.0, supply.pressure, 0.0, 0.0)
    number = element.supply_flow_number(eccentricity_ratio, bearing.width, bearing.width_ratio)
    conductance = number * bearing.diameter**3 * relative_clearance**3 / viscosity
    if not supply.tubes and not supply.holes:
        return Feed(number, conductance * supply.pressure, supply.pressure, 0.0, 0.0)

    density = case.lubricant.density(supply.temperature)
    kinematic = case.lubricant.kinematic_viscosity(supply.temperature)

    def losses(ducts: tuple[Duct, ...], flow: float) -> float:
        return sum(duct.pressure_loss(flow, density, kinematic) for duct in ducts)

    def surplus(pressure: float) -> float:
        flow = side_flow + conductance * pressure
        return supply.pressure - losses(supply.tubes, flow) - losses(supply.holes, flow) - pressure

    starved = surplus(0.0) <= 0.0
    pressure = 0.0 if starved else brentq(surplus, 0.0, supply.pressure, xtol=1e-6, rtol=1e-12)
    flow = conductance * pressure
    return Feed(
        number,
        flow,
        pressure,
        losses(supply.tubes, side_flow + flow),
        losses(supply.holes, side_flow + flow),
        starved,
    )
