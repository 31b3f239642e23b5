"""Units of the dimensionless film."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.model import JournalFilm

__all__ = ["Scales"]

Array = NDArray[np.float64]
MIRROR = np.array([1.0, -1.0])


@dataclass(frozen=True)
class Scales:
    """Units of the dimensionless film, and the sense of rotation."""

    length: float
    pressure: float
    force: float
    rate: float
    flow: float
    torque: float
    sense: Array  # what mirrors a vector into the counter-clockwise world and back

    @classmethod
    def of(cls, film: JournalFilm, rate: float) -> Scales:
        """Units for a film sheared at ``rate`` (rad/s, the speed unless the journal is at rest)."""
        radius = 0.5 * film.diameter
        pressure = film.viscosity * rate * (radius / film.clearance) ** 2
        return cls(
            length=film.clearance,
            pressure=pressure,
            force=pressure * radius * film.width,
            rate=rate,
            flow=rate * radius * film.clearance * film.width,
            torque=film.viscosity * rate * radius**3 * film.width / film.clearance,
            sense=MIRROR if film.angular_speed < 0.0 else np.ones(2),
        )
