"""Loads that change while the journal turns: a load that rotates, a load by table."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

__all__ = ["ChangingLoad", "RotatingLoad", "TabulatedLoad"]

TURN = 2.0 * math.pi


class ChangingLoad(Protocol):
    """A load that comes back after a cycle."""

    @property
    def cycle(self) -> float:
        """Angle that the journal turns from one cycle to the next, rad."""

    @property
    def corners(self) -> tuple[float, ...]:
        """Angles of a cycle at which the load is not smooth, rad, ascending."""

    def at(self, turned: float) -> tuple[float, float]:
        """Components in N when the journal has turned by an angle (rad, counter-clockwise positive)."""


@dataclass(frozen=True)
class RotatingLoad:
    """A load of constant size that rotates, as that of an unbalance.

    Attributes
    ----------
    magnitude : float
        N.
    speed_ratio : float
        Its speed over that of the journal: 1 turns with the journal, -1 against it.
    phase : float
        Its direction when the cycle begins, rad from +x.
    """

    magnitude: float
    speed_ratio: float = 1.0
    phase: float = 0.0

    @property
    def cycle(self) -> float:
        """One turn of the load, in rad of the journal."""
        return TURN / abs(self.speed_ratio)

    @property
    def corners(self) -> tuple[float, ...]:
        """None: it is smooth."""
        return ()

    def at(self, turned: float) -> tuple[float, float]:
        """Components, N."""
        angle = self.phase + self.speed_ratio * turned
        return self.magnitude * math.cos(angle), self.magnitude * math.sin(angle)


@dataclass(frozen=True)
class TabulatedLoad:
    """A load by table, linear between its points.

    Attributes
    ----------
    angles : tuple of float
        That the journal has turned since the cycle began, in its own sense, rad; ascending, from zero to less than
        the cycle.
    fx, fy : tuple of float
        N.
    cycle : float
        Two turns for a four-stroke engine, rad.
    """

    angles: tuple[float, ...]
    fx: tuple[float, ...]
    fy: tuple[float, ...]
    cycle: float = TURN

    @property
    def corners(self) -> tuple[float, ...]:
        """Its points."""
        return self.angles

    def at(self, turned: float) -> tuple[float, float]:
        """Components, N."""
        import numpy as np

        place = abs(turned) % self.cycle
        x, y = (float(np.interp(place, self.angles, force, period=self.cycle)) for force in (self.fx, self.fy))
        return x, y
