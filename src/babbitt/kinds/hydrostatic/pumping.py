"""Power that the pumps spend, and the pressure that they must hold.

Oil from the supply is pumped to its pressure, P = p_s sum Q_k, metered flows too; where a recess asks for more,
its stage has to get what the recess asks for. A pump of a recess holds the pressure of the recess alone,
P = sum p_k Q_k.
Oil that a recess pushes back through its restrictor returns to the manifold and needs not be pumped again.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.network import NetworkState
from babbitt.kinds.hydrostatic.restrictors import CheckValve, ConstantFlow, MeteredFlow, Restrictor
from babbitt.kinds.hydrostatic.supply import Pump

__all__ = [
    "has_own_pump",
    "held_pressure",
    "highest_pressure",
    "is_pumped",
    "law_of",
    "pump_power",
    "pumping_power",
]


def law_of(restrictor: Restrictor) -> Restrictor:
    """The restrictor behind a check valve."""
    return restrictor.restrictor if isinstance(restrictor, CheckValve) else restrictor


def is_pumped(case: HydrostaticCase) -> bool:
    """Whether every recess has its flow from a pump of its own or a metering stage."""
    return all(isinstance(law_of(one), ConstantFlow | MeteredFlow) for one in case.feeding.restrictors)


def has_own_pump(restrictor: Restrictor) -> bool:
    """Whether a pump feeds this recess alone."""
    return isinstance(law_of(restrictor), ConstantFlow)


def pumping_power(case: HydrostaticCase, network: NetworkState) -> float:
    """Given to the oil that reaches the recesses, W."""
    return float(pumped_to(case, network) @ network.flows)


def pumped_to(case: HydrostaticCase, network: NetworkState) -> NDArray[np.float64]:
    """Gauge pressure to which the oil of every recess is pumped, Pa."""
    standing = np.full(network.pressures.size, network.supply_pressure)
    if not is_pumped(case):
        return standing
    own = np.array([has_own_pump(one) for one in case.feeding.restrictors])
    return np.where(own, network.pressures, np.maximum(network.pressures, standing))


def pump_power(case: HydrostaticCase, network: NetworkState) -> float:
    """At the shaft of the pump or pumps, with overflow and leakage, W."""
    supply = case.feeding.supply
    if is_pumped(case):
        laws = (law_of(one) for one in case.feeding.restrictors)
        moved = np.array([one.flow for one in laws if isinstance(one, ConstantFlow | MeteredFlow)])
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
