"""A shaft as a problem: its statics, and what reports say of it."""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.core.notices import Notice
from babbitt.kinds.shaft.gears import Gear
from babbitt.kinds.shaft.model import Shaft

__all__ = ["ShaftLimits", "ShaftProblem"]


@dataclass(frozen=True)
class ShaftLimits:
    """What is permissible: slope in rad, deflection in m; None where nothing is given."""

    slope: float | None = None
    deflection: float | None = None


@dataclass(frozen=True)
class ShaftProblem:
    """A shaft whose bearings share its loads.

    Attributes
    ----------
    name, kind : str
    shaft : Shaft
        With the loads of the gears among its own.
    speed : float
        Positive counter-clockwise, rad/s.
    gears : tuple of Gear
    limits : ShaftLimits
    given, warnings, assumptions : tuple
        As of every problem.
    loads_alone : tuple of str
        Names of the bearings that have no film, but a load alone.
    """

    name: str
    kind: str
    shaft: Shaft
    speed: float = 0.0
    gears: tuple[Gear, ...] = ()
    limits: ShaftLimits = ShaftLimits()
    given: tuple[tuple[str, str], ...] = ()
    warnings: tuple[Notice, ...] = ()
    assumptions: tuple[str, ...] = ()
    loads_alone: tuple[str, ...] = ()
