"""Loads of the two bearings of a gear shaft with a coupling that hangs over the second one.

Two simple supports; the gear sits at mid-span; half of the coupling's weight acts a quarter of the coupling's
length beyond the flange. Equilibrium of forces and moments, as in a published gearbox study (2023).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum

STANDARD_GRAVITY = 9.80665
"""Standard acceleration of gravity in m/s² (CGPM 1901)."""


class MeshForce(Enum):
    """Which way the vertical part of the mesh force pushes the gear."""

    UPWARD = "upward"
    DOWNWARD = "downward"


@dataclass(frozen=True)
class OverhungCoupling:
    """A gear between two bearings and a coupling beyond the second.

    Attributes
    ----------
    mesh_force : float
        N, at mid-span.
    mesh_angle : float
        Of the mesh force to the vertical, rad.
    mesh_direction : MeshForce
    bearing_distance : float
        m.
    gear_mass, coupling_mass : float
        kg.
    flange_distance : float
        From bearing 2 to the coupling flange, m.
    coupling_length : float
        m.
    """

    mesh_force: float
    mesh_angle: float
    mesh_direction: MeshForce
    bearing_distance: float
    gear_mass: float
    coupling_mass: float
    flange_distance: float
    coupling_length: float

    @property
    def coupling_arm(self) -> float:
        """Where half the coupling's weight acts, beyond bearing 2, in m."""
        return self.flange_distance + self.coupling_length / 4.0


@dataclass(frozen=True)
class BearingLoads:
    """Loads in N and their directions from the vertical in rad; bearing 2 is beside the coupling."""

    reaction_1: float
    reaction_2: float
    reaction_without_coupling: float
    angle_1: float
    angle_2: float


def bearing_loads(shaft: OverhungCoupling) -> BearingLoads:
    """Static loads of both bearings.

    With ``V`` and ``H`` the vertical and horizontal half of the mesh force (downward positive), ``G1`` the weight
    of the gear, ``G2`` half the weight of the coupling, ``l`` the bearing distance and ``a`` the arm:
    ``V1 = V + G1/2 - G2 a/l``, ``V2 = V + G1/2 + G2 (l + a)/l``, ``R = sqrt(V² + H²)``.

    Parameters
    ----------
    shaft : OverhungCoupling

    Returns
    -------
    BearingLoads
    """
    gear_weight = shaft.gear_mass * STANDARD_GRAVITY
    half_coupling = shaft.coupling_mass * STANDARD_GRAVITY / 2.0
    lever = shaft.coupling_arm / shaft.bearing_distance
    sense = -1.0 if shaft.mesh_direction is MeshForce.UPWARD else 1.0
    mesh_vertical = sense * shaft.mesh_force * math.cos(shaft.mesh_angle) / 2.0
    horizontal = shaft.mesh_force * math.sin(shaft.mesh_angle) / 2.0
    alone = mesh_vertical + gear_weight / 2.0
    vertical_1 = alone - half_coupling * lever
    vertical_2 = alone + half_coupling * (1.0 + lever)
    return BearingLoads(
        math.hypot(vertical_1, horizontal),
        math.hypot(vertical_2, horizontal),
        math.hypot(alone, horizontal),
        math.atan2(horizontal, vertical_1),
        math.atan2(horizontal, vertical_2),
    )
