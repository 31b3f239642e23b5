"""The pressure of the header at which the bearings take what the pump gives."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from babbitt.core.picklable_error import PicklableError
from babbitt.core.solution import Calculation, Solution
from babbitt.design.conditions import OilSupply
from babbitt.design.values import pumped_flow
from babbitt.kinds.journal.limits_of_clearance import for_values
from babbitt.kinds.journal.oil_balance.model import Line, OilSystemProblem
from babbitt.numerics.roots import Root, find_root

__all__ = ["Balance", "FedBearing", "UnsolvedBearingError", "balanced", "fed", "header_of"]

PRESSURE_TOLERANCE = 1e-14
"""Relative, of the pressure of the header: to round-off, for the flows to agree to 1e-8."""


class UnsolvedBearingError(PicklableError):
    """A bearing has no film at a pressure of the header, or one that does not tell what it draws by itself."""

    def __init__(self, solution: Solution, pressure: float) -> None:
        super().__init__(f"{solution.result.name} at {pressure} Pa")
        self.solution, self.pressure = solution, pressure


@dataclass(frozen=True, eq=False)
class FedBearing:
    """A bearing behind its line.

    Attributes
    ----------
    solution : Solution
        Of the bearing at this pressure of the header.
    supplied : float
        What flows through its line, m3/s: what its film takes, no more than the line passes.
    needed : float
        What its film draws by its own pressure (Q3), m3/s; with less it starves.
    pressure : float
        Gauge, at the end of the line, Pa.
    tube_reynolds_number : float
        Of the tube of the line, NaN without one.
    """

    solution: Solution
    supplied: float
    needed: float
    pressure: float
    tube_reynolds_number: float

    @property
    def ratio(self) -> float:
        """Oil supplied over oil needed."""
        return self.supplied / self.needed if self.needed > 0.0 else math.inf


@dataclass(frozen=True, eq=False)
class Balance:
    """Flows of a machine in balance.

    Attributes
    ----------
    header_pressure : float
        Pa.
    bearings : tuple of FedBearing
    delivery, relief_flow : float
        Of the pump, and what of it returns over the relief valve, m3/s.
    error : float
        What the flows miss of their balance, over the delivery; infinite where the search has not ended at one.
    """

    header_pressure: float
    bearings: tuple[FedBearing, ...]
    delivery: float
    relief_flow: float
    error: float


def balanced(problem: OilSystemProblem) -> Balance:
    """Find the pressure of the header between zero and that of the relief valve.

    The flow of every line rises with the pressure, that of the pump does not: there is one balance.

    Raises
    ------
    UnsolvedBearingError
        Where a bearing has no film at a pressure that the search looks at.
    """
    pump, lines = problem.system.pump, problem.system.lines
    found = header_of(problem, PRESSURE_TOLERANCE)
    header, delivery = found.value, pump.delivery(found.value)
    pairs = zip(problem.calculations, lines, strict=True)
    bearings = tuple(fed(one, line, header) for one, line in pairs)
    excess = sum(one.supplied for one in bearings) - delivery
    relieved = max(-excess, 0.0) if header == pump.relief_pressure else 0.0
    error = abs(excess + relieved) / delivery if found.converged else math.inf
    return Balance(header, bearings, delivery, relieved, error)


def header_of(problem: OilSystemProblem, tolerance: float) -> Root:
    """Pressure of the header in Pa to a relative tolerance, of bearings solved as far as their flows go.

    Raises
    ------
    UnsolvedBearingError
    """
    pump = problem.system.pump
    lines = [(for_values(one), line) for one, line in zip(problem.calculations, problem.system.lines, strict=True)]

    @cache
    def excess(pressure: float) -> float:
        taken = sum(fed(one, line, pressure).supplied for one, line in lines) if pressure > 0.0 else 0.0
        return taken - pump.delivery(pressure)

    relief = pump.relief_pressure
    if excess(relief) <= 0.0:
        return Root(relief, True)
    return find_root(excess, 0.0, relief, relative=tolerance)


def fed(calculation: Calculation, line: Line, pressure: float) -> FedBearing:
    """Solve a bearing whose line begins at a pressure in Pa.

    Raises
    ------
    UnsolvedBearingError
    """
    problem: Any = calculation.problem
    supply: OilSupply = problem.oil_supply
    solution = calculation.method.solve_one(problem.fed_by(replace(supply, pressure=pressure)))
    values = solution.result.values
    if not solution.result.outcome.solved or "side_flow" not in values:
        raise UnsolvedBearingError(solution, pressure)
    supplied = min(pumped_flow(values), values.get("supply_limit", math.inf))
    oil = problem.lubricant
    density, kinematic = oil.density(supply.temperature), oil.kinematic_viscosity(supply.temperature)
    lost = sum(duct.pressure_loss(supplied, density, kinematic) for duct in line.ducts)
    reynolds = math.nan if line.tube is None else line.tube.reynolds_number(supplied, kinematic)
    return FedBearing(solution, supplied, values["side_flow"], max(pressure - lost, 0.0), reynolds)
