"""Statics of a gear shaft with an overhung coupling."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from babbitt.case.case_file import CaseFile
from babbitt.case.grouped_digits import about_grouped_digits
from babbitt.case.parts.fields import Name, Prose
from babbitt.core.solution import Calculation
from babbitt.core.units import si
from babbitt.kinds.shaft.methods import COUPLING_STATICS
from babbitt.kinds.shaft.overhung_coupling import CouplingProblem, MeshForce, OverhungCoupling

Distance = Annotated[float, si("m", "1 mm", "50 m")]
PartMass = Annotated[float, si("kg", "0 kg", "1000 t")]


class OverhungCouplingCase(CaseFile):
    """A gear between two bearings, and a coupling beyond the second: what each bearing carries."""

    kind: Literal["overhung_coupling"] = Field(description="Load share of two bearings with an overhung coupling.")
    name: Name = Field(description="Name of the shaft.")
    mesh_force: Annotated[float, si("N", "1 N", "1000 MN")] = Field(description="Mesh force at mid-span.")
    mesh_angle: Annotated[float, si("rad", "-90 deg", "90 deg")] = Field(
        description="Angle of the mesh force to the vertical."
    )
    mesh_direction: Literal["upward", "downward"] = Field(
        description="Sense of the vertical part of the mesh force."
    )
    bearing_distance: Distance = Field(description="Distance of the two bearings.")
    gear_mass: PartMass = Field(description="Mass of gear and shaft, acting at mid-span.")
    coupling_mass: PartMass = Field(description="Mass of the coupling, of which the shaft carries one half.")
    flange_distance: Annotated[float, si("m", "0 m", "50 m")] = Field(
        description="From bearing 2 to the coupling flange."
    )
    coupling_length: Annotated[float, si("m", "0 m", "50 m")] = Field(
        description="Length of the coupling. Its carried half acts a quarter of it beyond the flange."
    )
    assumptions: tuple[Prose, ...] = Field(
        (), max_length=100, description="Assumptions to be shown in the report."
    )
    notes: Prose = Field("", description="Notes to be shown in the report.")
    source: Prose = Field("", description="Where the numbers come from.")

    def calculations(self) -> tuple[Calculation, ...]:
        """Give the one calculation of the file."""
        warnings = tuple(about_grouped_digits(self))
        problem = CouplingProblem(
            self.name, self.kind, self.shaft(), warnings=warnings, assumptions=self.assumptions
        )
        return (Calculation(problem, COUPLING_STATICS),)

    def shaft(self) -> OverhungCoupling:
        """Give the shaft of the calculation."""
        return OverhungCoupling(
            mesh_force=self.mesh_force,
            mesh_angle=self.mesh_angle,
            mesh_direction=MeshForce(self.mesh_direction),
            bearing_distance=self.bearing_distance,
            gear_mass=self.gear_mass,
            coupling_mass=self.coupling_mass,
            flange_distance=self.flange_distance,
            coupling_length=self.coupling_length,
        )
