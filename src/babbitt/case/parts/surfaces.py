"""What keeps the surfaces apart at least: roughness, tilt, deflection, waviness."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Part
from babbitt.core.units import si
from babbitt.design.conditions import Surfaces

Height = Annotated[float, si("m", "0 um", "1 mm")]


class _Rough(Part):
    roughness_bearing: Height = Field(description="Mean peak-to-valley height Rz of the bearing.")
    roughness_journal: Height = Field(description="Mean peak-to-valley height Rz of the journal.")
    mean_deflection: Height = Field(0.0, description="Mean deflection of the journal within the bearing, y.")
    wave_factor: Annotated[float, si("1", "0", "10")] = Field(
        1.0,
        description="Effective over actual waviness, E/G. 1 is an assumption, as the functions are not public.",
    )


class DirectSurfaces(_Rough):
    """Tilt and waviness as they are."""

    kind: Literal["direct"] = Field(description="Tilt and waviness are given.")
    tilt_offset: Height = Field(0.0, description="Offset of the journal axis over the bearing width, B_y.")
    waviness: Height = Field(0.0, description="Wave height of both surfaces together, h_wav.")

    def surfaces(self) -> Surfaces:
        """Give the surfaces of the calculation."""
        return Surfaces(
            self.roughness_bearing,
            self.roughness_journal,
            self.tilt_offset,
            self.mean_deflection,
            self.waviness,
            self.wave_factor,
        )


class DrawingSurfaces(_Rough):
    """Tilt and waviness from the form tolerances of the drawing."""

    kind: Literal["drawing"] = Field(description="Tilt and waviness follow from form tolerances.")
    profile_tolerance_bearing: Height = Field(
        description="Tolerance of the longitudinal profile of the bore, TFP."
    )
    profile_tolerance_journal: Height = Field(
        description="Tolerance of the longitudinal profile of the journal, TFP."
    )
    roundness_tolerance_bearing: Height = Field(description="Roundness tolerance of the bore, TFR.")
    roundness_tolerance_journal: Height = Field(description="Roundness tolerance of the journal, TFR.")

    def surfaces(self) -> Surfaces:
        """Give the surfaces of the calculation.

        Substitutes of a published gearbox study (2023): the tilt offset is the sum of the profile tolerances,
        the waviness the mean of the roundness tolerances.
        """
        return Surfaces(
            self.roughness_bearing,
            self.roughness_journal,
            self.profile_tolerance_bearing + self.profile_tolerance_journal,
            self.mean_deflection,
            (self.roundness_tolerance_bearing + self.roundness_tolerance_journal) / 2.0,
            self.wave_factor,
        )


SurfacesInput = Annotated[DirectSurfaces | DrawingSurfaces, Discriminator("kind")]
