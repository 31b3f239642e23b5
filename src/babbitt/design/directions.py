"""Directions in the fixed frame of films that are described from their widest gap with the rotation."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

__all__ = ["directions_of", "narrowest_direction"]

TURN = 2.0 * math.pi


class Directed(Protocol):
    """What tells directions: that of the load in rad from +x, and the speed in rad/s, negative if clockwise."""

    @property
    def load_angle(self) -> float: ...
    @property
    def journal_speed(self) -> float: ...


def narrowest_direction(case: Directed, attitude: float) -> float:
    """Direction of the narrowest gap in rad from +x, within (-pi, pi], from the attitude angle in rad."""
    angle = case.load_angle + math.copysign(1.0, case.journal_speed) * attitude
    return math.pi - (math.pi - angle) % TURN


def directions_of(case: Directed, attitude: float, angles: Array) -> Array:
    """Directions in rad from +x, from 0 to a turn, of places at angles from the widest gap with the rotation."""
    sense = math.copysign(1.0, case.journal_speed)
    return (narrowest_direction(case, attitude) + math.pi + sense * angles) % TURN
