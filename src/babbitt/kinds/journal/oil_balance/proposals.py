"""Orifices that give each bearing what it needs."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

from babbitt.core.solution import Calculation
from babbitt.kinds.journal.limits_of_clearance import for_values
from babbitt.kinds.journal.oil_balance.model import Line, OilSystemProblem, Pump
from babbitt.kinds.journal.oil_balance.network import FedBearing, UnsolvedBearingError, fed
from babbitt.numerics.roots import find_root

__all__ = ["Proposal", "proposed"]

FLOW_TOLERANCE = 1e-10
"""Relative, of pressures at which a bearing takes its flow."""


@dataclass(frozen=True)
class Proposal:
    """Orifices for all bearings.

    Attributes
    ----------
    diameters : tuple of float
        m; NaN where no orifice gives the bearing its flow.
    flow : float
        Of all bearings together with them, m3/s; NaN where a bearing has none.
    header_pressure : float
        For which they are made, Pa; NaN where the pump does not give that flow.
    """

    diameters: tuple[float, ...]
    flow: float
    header_pressure: float


def proposed(problem: OilSystemProblem) -> Proposal:
    """Orifices with which every bearing is supplied with what it needs and the margin.

    Each is sized between the header and the pressure at which its bearing, without line, takes that flow; tubes of
    the lines stay. The header stands at the pressure of the relief valve where the pump gives more than that, else
    where its curve gives as much.
    """
    system = problem.system
    pairs = list(zip(problem.calculations, system.lines, strict=True))
    wanted = [_wanted(one, line, system.margin, system.pump.relief_pressure) for one, line in pairs]
    flow = sum(math.nan if one is None else one.supplied for one in wanted)
    header = _header(system.pump, flow)
    diameters = tuple(
        math.nan if one is None else _orifice(calculation, line, one, header)
        for (calculation, line), one in zip(pairs, wanted, strict=True)
    )
    return Proposal(diameters, flow, header)


def _wanted(calculation: Calculation, line: Line, margin: float, most: float) -> FedBearing | None:
    """The bearing at the pressure at its inlet at which it takes its need and the margin; None without one."""
    problem: Any = calculation.problem
    supply = problem.oil_supply
    alone = replace(supply, tubes=supply.tubes[len(line.ducts) :])
    bare = for_values(replace(calculation, problem=problem.fed_by(alone)))
    unfed = Line(line.bearing, None, None)

    def surplus(pressure: float) -> float:
        found = fed(bare, unfed, pressure)
        return found.supplied - (1.0 + margin) * found.needed

    try:
        if surplus(most) < 0.0 or surplus(0.0) > 0.0:
            return None
        root = find_root(surplus, 0.0, most, relative=FLOW_TOLERANCE)
        return fed(bare, unfed, root.value) if root.converged else None
    except UnsolvedBearingError:
        return None


def _header(pump: Pump, flow: float) -> float:
    """Pressure in Pa at which the header stands while the bearings take a flow; NaN where the pump gives less."""
    if math.isnan(flow):
        return pump.relief_pressure  # the others are sized as if this bearing took little
    if pump.delivery(pump.relief_pressure) >= flow:
        return pump.relief_pressure
    if pump.delivery(0.0) <= flow:
        return math.nan
    root = find_root(lambda pressure: pump.delivery(pressure) - flow, 0.0, pump.relief_pressure)
    return root.value if root.converged else math.nan


def _orifice(calculation: Calculation, line: Line, wanted: FedBearing, header: float) -> float:
    """Diameter in m of the orifice of a line; NaN where nothing of the pressure is left for it."""
    problem: Any = calculation.problem
    oil, supply = problem.lubricant, problem.oil_supply
    density, kinematic = oil.density(supply.temperature), oil.kinematic_viscosity(supply.temperature)
    lost = 0.0 if line.tube is None else line.tube.pressure_loss(wanted.supplied, density, kinematic)
    left = header - lost - wanted.pressure
    return line.orifice_for(wanted.supplied, left, density) if left > 0.0 else math.nan
