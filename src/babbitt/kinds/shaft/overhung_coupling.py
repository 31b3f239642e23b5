"""Loads of the two bearings of a gear shaft with an overhung coupling, on the statics of shafts.

The gear sits at mid-span; half of the coupling's weight acts a quarter of the coupling's length beyond the flange,
as in a published gearbox study (2023).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from enum import Enum

from babbitt.core.notices import Notice
from babbitt.core.result import Outcome, Result
from babbitt.core.solution import Solution
from babbitt.kinds.shaft.model import STANDARD_GRAVITY, PointLoad, Shaft, Support
from babbitt.kinds.shaft.statics import two_reactions

__all__ = [
    "BearingLoads",
    "CouplingProblem",
    "MeshForce",
    "OverhungCoupling",
    "bearing_loads",
    "coupling_solution",
]


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

    def shaft(self) -> Shaft:
        """The shaft on its bearings, the horizontal part of the mesh force to the right."""
        middle, end = 0.5 * self.bearing_distance, self.bearing_distance
        upward = 1.0 if self.mesh_direction is MeshForce.UPWARD else -1.0
        across = self.mesh_force * math.sin(self.mesh_angle)
        mesh = (across, upward * self.mesh_force * math.cos(self.mesh_angle), 0.0)
        half = 0.5 * self.coupling_mass
        return Shaft(
            (Support("Bearing 1", 0.0), Support("Bearing 2", end)),
            (
                PointLoad("Mesh", middle, mesh),
                PointLoad("Gear and shaft", middle, (0.0, -STANDARD_GRAVITY * self.gear_mass, 0.0)),
                PointLoad("Half the coupling", end + self.coupling_arm, (0.0, -STANDARD_GRAVITY * half, 0.0)),
            ),
        )


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

    Parameters
    ----------
    shaft : OverhungCoupling

    Returns
    -------
    BearingLoads
    """
    (right_1, up_1), (right_2, up_2) = -two_reactions(shaft.shaft())
    (right_0, up_0), _ = -two_reactions(replace(shaft, coupling_mass=0.0).shaft())
    return BearingLoads(
        math.hypot(right_1, up_1),
        math.hypot(right_2, up_2),
        math.hypot(right_0, up_0),
        math.atan2(right_1, -up_1),
        math.atan2(right_2, -up_2),
    )


@dataclass(frozen=True)
class CouplingProblem:
    """A gear shaft with an overhung coupling whose bearings share its loads."""

    name: str
    kind: str
    shaft: OverhungCoupling
    given: tuple[tuple[str, str], ...] = ()
    warnings: tuple[Notice, ...] = ()
    assumptions: tuple[str, ...] = ()


def coupling_solution(problem: CouplingProblem, method: str) -> Solution:
    """Find the loads of both bearings.

    Parameters
    ----------
    problem : CouplingProblem
    method : str
        ``statics``.
    """
    loads = bearing_loads(problem.shaft)
    values = {
        "reaction_1": loads.reaction_1,
        "reaction_2": loads.reaction_2,
        "reaction_without_coupling": loads.reaction_without_coupling,
        "reaction_angle_1": loads.angle_1,
        "reaction_angle_2": loads.angle_2,
        "coupling_arm": problem.shaft.coupling_arm,
    }
    result = Result(
        problem.name, problem.kind, method, Outcome.CONVERGED, values,
        warnings=problem.warnings, assumptions=problem.assumptions,
    )  # fmt: skip
    return Solution(problem, result)
