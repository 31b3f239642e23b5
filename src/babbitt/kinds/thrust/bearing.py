"""A thrust bearing: equal pads on a ring, and what displaces them against the collar."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.state import TiltInertia

__all__ = ["HousingTilt", "ThrustBearing"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class HousingTilt:
    """Tilt of the housing against the collar.

    Attributes
    ----------
    offset : float
        e_o: axial departure at the outer radius of the pads, m; 0 or more.
    direction : float
        theta_t: where the housing comes closest, rad.
    """

    offset: float = 0.0
    direction: float = 0.0

    def __post_init__(self) -> None:
        if not self.offset >= 0.0:
            raise InputError("E201", f"tilt of the housing is {self.offset:g} m; it must be 0 or more.")


@dataclass(frozen=True)
class ThrustBearing:
    """Equal pads on a backing ring.

    Attributes
    ----------
    pad : ThrustPad
    number : int
        Of pads, 2 or more.
    ring_stiffness : float
        c: of the support under each pad, N/m; infinite for a rigid ring.
    pad_mass : float
        m4, kg.
    inertia : TiltInertia
    tilt : HousingTilt
    height_errors : tuple of float
        How much each pad stands higher than the mean, m; empty for none.
    sense : float
        1 where the shaft turns counter-clockwise, towards growing pad numbers; -1 for the other sense.
    """

    pad: ThrustPad
    number: int
    ring_stiffness: float = math.inf
    pad_mass: float = 0.0
    inertia: TiltInertia = TiltInertia()  # noqa: RUF009
    tilt: HousingTilt = HousingTilt()
    height_errors: tuple[float, ...] = ()
    sense: float = 1.0

    def __post_init__(self) -> None:
        if int(self.number) != self.number or self.number < 2:
            raise InputError("E201", f"number of pads is {self.number:g}; allowed: a whole number from 2.")
        if self.number * self.pad.extent >= 2.0 * math.pi:
            room = 360.0 / self.number
            raise InputError(
                "E201",
                f"{self.number} pads of {math.degrees(self.pad.extent):g} deg overlap; allowed: "
                f"less than {room:g} deg each.",
            )
        if not self.ring_stiffness > 0.0:
            raise InputError("E201", f"stiffness of the ring is {self.ring_stiffness:g} N/m; it must be positive.")
        if not self.pad_mass >= 0.0:
            raise InputError("E201", f"mass of a pad is {self.pad_mass:g} kg; it must be 0 or more.")
        if self.height_errors and len(self.height_errors) != self.number:
            raise InputError("E201", f"{len(self.height_errors)} pad heights are given for {self.number} pads.")

    @property
    def angles(self) -> Array:
        """gamma_i = 2 pi (i - 1)/z, rad."""
        return 2.0 * math.pi * np.arange(self.number) / self.number

    @property
    def area(self) -> float:
        """Of all pads, m2."""
        return self.number * self.pad.area

    def departures(self) -> Array:
        """What tilt and heights add to the film under each pad (S1), m.

        e_i = -e_o (r_p/r_o) cos(gamma_i - theta_t), less the height of the pad.
        """
        lever = self.pad.pivot_radius / self.pad.outer_radius
        away = -self.tilt.offset * lever * np.cos(self.angles - self.tilt.direction)
        return away - (np.array(self.height_errors) if self.height_errors else 0.0)

    def phases(self) -> Array:
        """Angles by which the collar passes each pad later than pad 1, rad."""
        return self.sense * self.angles
