"""Forces on a gear: tangential, radial and axial, with their signs.

Decomposition of the tooth force at the pitch point as in textbooks of machine elements (Niemann and Winter,
Maschinenelemente, vol. 2; Shigley, Mechanical Engineering Design, ch. 13):
``F_t = 2 T / d``, ``F_r = F_t tan(alpha_n) / cos(beta)``, ``F_a = F_t tan(beta)``, and the axial force acts at the
radius ``d/2``, so that it bends the shaft by the couple ``F_a d/2``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum

from babbitt.kinds.shaft.model import PointLoad

__all__ = ["Gear", "Helix", "ToothForce"]


class Helix(Enum):
    """Hand of the helix; its value is the sign of the thrust on a driving gear that turns counter-clockwise."""

    RIGHT = 1.0
    LEFT = -1.0
    DOUBLE = 0.0


@dataclass(frozen=True)
class ToothForce:
    """Sizes of the components of the tooth force, N."""

    tangential: float
    radial: float
    axial: float


@dataclass(frozen=True)
class Gear:
    """An external spur or helical gear on the shaft.

    Attributes
    ----------
    name : str
    station : float
        Of the middle of its face, m.
    diameter : float
        Pitch diameter d, m.
    pressure_angle : float
        Normal pressure angle alpha_n, rad.
    helix_angle : float
        beta, rad; zero for a spur gear.
    helix : Helix
        A double helix has no axial force.
    mesh_angle : float
        Direction from the axis of the shaft to that of the mating gear, from +x, rad.
    torque : float
        That the teeth exert on the shaft, positive counter-clockwise, N m.
    """

    name: str
    station: float
    diameter: float
    pressure_angle: float
    helix_angle: float
    helix: Helix
    mesh_angle: float
    torque: float

    def tooth_force(self) -> ToothForce:
        """Sizes of the components."""
        tangential = 2.0 * abs(self.torque) / self.diameter
        double = self.helix is Helix.DOUBLE
        return ToothForce(
            tangential,
            tangential * math.tan(self.pressure_angle) / math.cos(self.helix_angle),
            0.0 if double else tangential * math.tan(self.helix_angle),
        )

    def load(self) -> PointLoad:
        """What the mating gear does to the shaft.

        With ``n = (cos phi, sin phi)`` towards the mating gear and ``t = (-sin phi, cos phi)`` in the positive
        sense of rotation, the tangential force is ``F_t t`` with the sign of the torque on the shaft, whatever the
        sense of rotation, and the radial force ``-F_r n``. On a right-hand helix the force normal to the tooth is
        parallel to ``t cos(beta) - z sin(beta)``: its axial part has the sign against that of the torque. The
        axial force at ``n d/2`` gives the moment ``(d/2) n x F_a z``.
        """
        size = self.tooth_force()
        across, up = math.cos(self.mesh_angle), math.sin(self.mesh_angle)
        sense = math.copysign(1.0, self.torque)
        axial = -sense * self.helix.value * size.axial
        force = (
            -sense * size.tangential * up - size.radial * across,
            sense * size.tangential * across - size.radial * up,
            axial,
        )
        arm = 0.5 * self.diameter
        return PointLoad(self.name, self.station, force, (arm * up * axial, -arm * across * axial, self.torque))
