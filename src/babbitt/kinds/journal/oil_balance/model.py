"""Pump, lines and bearings of an oil system, in SI."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from babbitt.core.notices import Notice
from babbitt.core.solution import Calculation
from babbitt.design.ducts import Duct

__all__ = ["Line", "OilSystem", "OilSystemProblem", "Pump", "orifice_duct"]


def orifice_duct(diameter: float, discharge_coefficient: float) -> Duct:
    """An orifice that passes ``Q = C_d A sqrt(2 Δp/ρ)``: a duct without length, of loss coefficient ``1/C_d²``."""
    return Duct(diameter, 0.0, 1.0 / discharge_coefficient**2)


@dataclass(frozen=True)
class Pump:
    """Delivery over the pressure of the header, as far as the relief valve lets it rise.

    Attributes
    ----------
    curve : tuple of (pressure, flow)
        Pa and m3/s, pressures rising, flows not rising; straight between the points, level beyond.
    relief_pressure : float
        At which the relief valve takes what the bearings do not, Pa.
    """

    curve: tuple[tuple[float, float], ...]
    relief_pressure: float

    def delivery(self, pressure: float) -> float:
        """Flow into the header in m3/s at a pressure in Pa."""
        pressures, flows = zip(*self.curve, strict=True)
        return float(np.interp(pressure, pressures, flows))


@dataclass(frozen=True)
class Line:
    """From the header to one bearing: a tube, an orifice, or both.

    Attributes
    ----------
    bearing : str
    tube : Duct or None
    orifice_diameter : float or None
        m.
    discharge_coefficient : float
    """

    bearing: str
    tube: Duct | None
    orifice_diameter: float | None
    discharge_coefficient: float = 0.6

    @property
    def ducts(self) -> tuple[Duct, ...]:
        """What the oil passes, one after the other."""
        tube = (self.tube,) if self.tube is not None else ()
        if self.orifice_diameter is None:
            return tube
        return (*tube, orifice_duct(self.orifice_diameter, self.discharge_coefficient))

    def orifice_for(self, flow: float, pressure: float, density: float) -> float:
        """Diameter in m of the orifice that passes a flow in m3/s at a pressure difference in Pa."""
        area = flow / (self.discharge_coefficient * math.sqrt(2.0 * pressure / density))
        return math.sqrt(4.0 * area / math.pi)


@dataclass(frozen=True)
class OilSystem:
    """Pump, lines in the order of the bearings, and the margin of the orifices that are proposed."""

    pump: Pump
    lines: tuple[Line, ...]
    margin: float = 0.2


@dataclass(frozen=True)
class OilSystemProblem:
    """The bearings of a machine with the system that feeds them.

    Attributes
    ----------
    name, kind : str
    system : OilSystem
    calculations : tuple of Calculation
        One for each line; the supply of its problem begins with the ducts of the line.
    given, warnings, assumptions : tuple
        As of every problem.
    """

    name: str
    kind: str
    system: OilSystem
    calculations: tuple[Calculation, ...]
    given: tuple[tuple[str, str], ...] = ()
    warnings: tuple[Notice, ...] = ()
    assumptions: tuple[str, ...] = ()

    @property
    def with_limits(self) -> tuple[int, ...]:
        """Places of the bearings whose clearance has limits."""
        return tuple(place for place, one in enumerate(self.calculations) if _limits(one) is not None)

    def at_limits(self, limits: Sequence[int]) -> OilSystemProblem:
        """The system with the first (0) or the second (1) limit of each clearance that has some."""
        made = tuple(_at_limit(one, place) for one, place in zip(self.calculations, limits, strict=True))
        return replace(self, calculations=made)


def _limits(calculation: Calculation) -> tuple[float, float] | None:
    """The least and the greatest clearance over diameter at 20 °C of a bearing; None without tolerance."""
    problem: Any = calculation.problem
    limits: tuple[float, float] | None = problem.bearing.clearance_tolerance
    return limits


def _at_limit(calculation: Calculation, place: int) -> Calculation:
    """A bearing at the first or second limit of its clearance; as it is without limits."""
    problem: Any = calculation.problem
    limits = _limits(calculation)
    return calculation if limits is None else replace(calculation, problem=problem.at_clearance(limits[place]))
