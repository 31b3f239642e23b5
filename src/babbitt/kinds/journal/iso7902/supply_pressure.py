"""What arrives at the supply element: pressure after the losses on the way, and the flow it drives."""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.design.feeding import arrival
from babbitt.kinds.journal.iso7902.model import DesignCase


@dataclass(frozen=True)
class Feed:
    """Supply of the film: number Qp*, flow in m³/s, pressure at the element and losses in Pa.

    `limit` is the flow in m³/s that tubes and holes pass at the whole supply pressure, where the film wants more:
    the element is then at ambient pressure.
    """

    flow_number: float
    flow: float
    element_pressure: float
    tube_loss: float
    hole_loss: float
    limit: float | None = None


def feed(
    case: DesignCase,
    eccentricity_ratio: float,
    relative_clearance: float,
    viscosity: float,
    side_flow: float,
    share: float = 1.0,
) -> Feed | None:
    """Flow through the supply element and the pressure there, balanced with the losses of the total flow.

    ``Qp = Qp* D³ ψ³ p_en/η`` and ``p_en = p_s - Δp(Q3 + Qp)``; the oil in tubes and holes has inlet temperature.
    `share` is the part of Qp* that elements give where they stand.
    """
    supply, element, bearing = case.oil_supply, case.bearing.supply_element, case.bearing
    if supply is None:
        return None
    number = 0.0
    if element is not None:
        number = share * element.supply_flow_number(eccentricity_ratio, bearing.width, bearing.width_ratio)
    conductance = number * bearing.diameter**3 * relative_clearance**3 / viscosity
    found = arrival(supply, case.lubricant, lambda pressure: side_flow + conductance * pressure)
    return Feed(
        number,
        conductance * found.element_pressure,
        found.element_pressure,
        found.tube_loss,
        found.hole_loss,
        found.limit,
    )
