"""Power that the pumps spend, and the pressure that they must hold.

Behind restrictors all oil is pumped to the supply pressure, P = p_s sum Q_k. A pump for every recess, or a stage
of a flow divider, holds no more than the pressure of its own recess, P = sum p_k Q_k; the pressure of the supply
is then what these pumps can reach.
"""

from __future__ import annotations

import numpy as np

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
    if is_pumped(case):
        return float(network.pressures @ network.flows)
    return network.supply_pressure * float(network.flows.sum())


def pump_power(case: HydrostaticCase, network: NetworkState) -> float:
    """At the shaft of the pump or pumps, with overflow and leakage, W."""
    supply = case.feeding.supply
    if is_pumped(case):
        laws = (law_of(one) for one in case.feeding.restrictors)
        moved = np.array([one.flow for one in laws if isinstance(one, ConstantFlow)])
        return float(network.pressures @ moved) / case.pump_efficiency
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
