"""Power that the pumps spend, and the pressure that they must hold.

All oil is pumped to the supply pressure, P = p_s sum Q_k, constant flows too: they are metered from that pressure.
Where a recess asks for more than that, its pump or stage of a flow divider has to hold what the recess asks for.
Oil that a recess pushes back through its restrictor returns to the manifold and needs not be pumped again.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from babbitt.hydrostatics.model import HydrostaticCase
from babbitt.hydrostatics.network import NetworkState
from babbitt.hydrostatics.restrictors import CheckValve, ConstantFlow, Restrictor
from babbitt.hydrostatics.supply import Pump

__all__ = ["held_pressure", "highest_pressure", "is_pumped", "law_of", "pump_power", "pumping_power"]


def law_of(restrictor: Restrictor) -> Restrictor:
    """The restrictor behind a check valve."""
    return restrictor.restrictor if isinstance(restrictor, CheckValve) else restrictor


def is_pumped(case: HydrostaticCase) -> bool:
    """Whether every recess has its own pump."""
    return all(isinstance(law_of(one), ConstantFlow) for one in case.feeding.restrictors)


def pumping_power(case: HydrostaticCase, network: NetworkState) -> float:
    """Given to the oil that reaches the recesses, W."""
    return float(pumped_to(case, network) @ network.flows)


def pumped_to(case: HydrostaticCase, network: NetworkState) -> NDArray[np.float64]:
    """Gauge pressure to which the oil of every recess is pumped, Pa: of the supply, or what its own pump needs."""
    standing = np.full(network.pressures.size, network.supply_pressure)
    return np.maximum(network.pressures, standing) if is_pumped(case) else standing


def pump_power(case: HydrostaticCase, network: NetworkState) -> float:
    """At the shaft of the pump or pumps, with overflow and leakage, W."""
    supply = case.feeding.supply
    if is_pumped(case):
        laws = (law_of(one) for one in case.feeding.restrictors)
        moved = np.array([one.flow for one in laws if isinstance(one, ConstantFlow)])
        return float(pumped_to(case, network) @ moved) / case.pump_efficiency
    flow = supply.flow if isinstance(supply, Pump) else float(network.flows.sum())
    return network.supply_pressure * flow / case.pump_efficiency


def held_pressure(case: HydrostaticCase, network: NetworkState) -> float:
    """Gauge pressure that a pump must hold, Pa: of the supply, or of the recess with most."""
    return float(network.pressures.max()) if is_pumped(case) else network.supply_pressure


def highest_pressure(case: HydrostaticCase, network: NetworkState) -> float | None:
    """Gauge pressure that a pump can hold, Pa; None where nothing says it."""
    if case.highest_supply_pressure is not None:
        return case.highest_supply_pressure
    return network.supply_pressure if is_pumped(case) else None
