"""The pieces of a footstep's case file: heel, groove, oil, metal, choices, ranges of figures."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.aliases import FormerWords, Moved
from babbitt.case.method_choices import MethodChoices, MethodInput
from babbitt.case.method_mapping import MethodMapping
from babbitt.case.part import Issue, Part, rule
from babbitt.case.parts.fields import WholeNumber
from babbitt.core.units import si, written

Gap = Annotated[float, si("m", "0.5 um", "1 mm")]
Diameter = Annotated[float, si("m", "0.2 mm", "2 m")]


class HeelInput(Part):
    """Lengths of the heel and of the recess in its face."""

    former_words: ClassVar[FormerWords] = {
        "radius": Moved("diameter", scale=2.0),
        "recess_radius": Moved("recess_diameter", scale=2.0),
        "bore_radius": Moved("inner_diameter", scale=2.0),
    }

    length: Annotated[float, si("m", "1 mm", "1 m")] = Field(description="Length of the cylindrical heel L.")
    diameter: Diameter = Field(description="Diameter of the heel, 2 r1.")
    recess_diameter: Diameter = Field(description="Outer diameter of the recess, 2 r3.")
    inner_diameter: Diameter = Field(description="Diameter of the bore that feeds the recess, 2 r2.")
    recess_depth: Annotated[float, si("m", "0.01 mm", "100 mm")] = Field(description="Depth of the recess H.")

    @rule
    def _radii_in_order(self) -> Iterator[Issue]:
        pairs = (("recess_diameter", "inner_diameter"), ("diameter", "recess_diameter"))
        for larger, smaller in pairs:
            if not getattr(self, larger) > getattr(self, smaller):
                says = f"{smaller} is {written(getattr(self, smaller), 'mm')}, not less than {larger}"
                yield Issue((smaller,), says, "inner_diameter < recess_diameter < diameter")


class GroovePart(Part):
    """The screw groove on the heel."""

    angle: Annotated[float, si("rad", "0.5 deg", "89.5 deg")] = Field(
        description="Angle of the groove, from the circumferential direction."
    )
    depth: Annotated[float, si("m", "1 um", "20 mm")] = Field(description="Depth of the groove h_k.")
    groove_width: Annotated[float, si("m", "0.01 mm", "200 mm")] = Field(
        description="Width of a groove a, normal to it."
    )
    land_width: Annotated[float, si("m", "0.01 mm", "200 mm")] = Field(
        description="Width of a land b, normal to the groove."
    )
    starts: Annotated[int, WholeNumber(1, 1000)] = Field(description="Number of starts z_n.")
    accept_misfit: bool = Field(
        False, description="Accept grooves and lands that do not close around the heel within 3 %."
    )


class FootstepOilInput(Part):
    """Oil whose viscosity falls exponentially: mu = viscosity exp(-exponent (T - supply.temperature))."""

    viscosity: Annotated[float, si("Pa s", "0.01 mPa s", "1000 Pa s")] = Field(
        description="Dynamic viscosity at supply.temperature."
    )
    viscosity_exponent: Annotated[float, si("1/K", "0 1/K", "0.2 1/K")] = Field(
        description="Exponent of the viscosity; 0 for a viscosity that does not change."
    )
    volumetric_heat_capacity: Annotated[float, si("J/(m3 K)", "0.1 MJ/(m3 K)", "10 MJ/(m3 K)")] = Field(
        1.76e6, description="Density times heat capacity."
    )
    density: Annotated[float, si("kg/m3", "400 kg/m3", "2000 kg/m3")] = Field(
        880.0, description="Density, for Reynolds numbers, entry loss and centrifugal pressure."
    )


class FootstepSupply(Part):
    """Oil that comes in."""

    example: ClassVar[str] = "{temperature: 25 degC, pressure: 0.63 MPa}"

    temperature: Annotated[float, si("K", "-60 degC", "300 degC")] = Field(
        description="Temperature of the oil that comes in, in the bore and at the groove inlet."
    )
    pressure: Annotated[float, si("Pa", "1 Pa", "500 MPa")] = Field(
        description="Pressure in the recess p2; absolute, or as `pressures` says."
    )


class WallPart(Part):
    """Metal that takes heat from the films (`method: narrow_groove`)."""

    temperature: Annotated[float, si("K", "-60 degC", "300 degC")] = Field(description="Temperature of the metal.")
    conductance: Annotated[float, si("W/K", "0 W/K", "100000 W/K")] = Field(
        description="Heat conductance from the films into the metal, shared by both films in equal halves."
    )


class StudyChoices(MethodChoices):
    """What the study leaves open, or prints otherwise; the defaults are the consistent choices."""

    friction_viscosity: Literal["mean", "mixed"] = Field(
        "mean",
        description="Viscosity of the friction in the clearance: mean of inlet and groove end, or at the mixed "
        "rim.",
    )
    face_outlet: Literal["consistent", "printed"] = Field(
        "consistent",
        description="Outlet temperature of the face: by its pressure loss, or as the study prints it.",
    )
    backflow_viscosity: Literal["inlet", "groove"] = Field(
        "inlet", description="Viscosity in the face gap where the rim feeds the recess."
    )
    local_loss_coefficient: Annotated[float, si("1", "0", "100")] = Field(
        0.0, description="Local loss coefficient at the groove inlet; the study lists 1 and uses none."
    )
    speed_reduction: Annotated[float, si("1", "0", "10")] = Field(
        0.0,
        description="Factor beta of the speed omega/(1 + beta) of groove and friction, which the study never "
        "defines.",
    )


class FootstepOptionsInput(StudyChoices):
    """Choices of the study's equations at their former place."""


class SuperpositionMethod(StudyChoices, MethodInput):
    """The study's equations."""

    read_in: ClassVar[tuple[str, ...]] = ("options",)

    kind: Literal["superposition"] = Field(description="The study's equations.")


class NarrowGrooveMethod(MethodInput):
    """Narrow-groove theory."""

    kind: Literal["narrow_groove"] = Field(description="Narrow-groove theory.")


METHOD_MAPPING = MethodMapping((SuperpositionMethod, NarrowGrooveMethod))


class FigureRanges(Part):
    """Ranges of the curves in report and plots."""

    face_gap_from: Gap = Field(5e-6, description="Smallest face gap drawn.")
    face_gap_to: Gap = Field(60e-6, description="Largest face gap drawn.")
    clearance_from: Gap = Field(6e-6, description="Smallest clearance drawn.")
    clearance_to: Gap = Field(60e-6, description="Largest clearance drawn.")

    map_points: Annotated[int, WholeNumber(0, 200)] = Field(
        0,
        description="Face gaps and clearances of a map of load and steady states, such as 60; 0: no map. A point "
        "takes about a millisecond.",
    )

    @rule
    def _in_order(self) -> Iterator[Issue]:
        for name in ("face_gap", "clearance"):
            low, high = getattr(self, f"{name}_from"), getattr(self, f"{name}_to")
            if not high > 1.05 * low:
                says = f"{name}_to is {written(high, 'um')}, {name}_from {written(low, 'um')}"
                yield Issue((f"{name}_to",), says, f"more than {name}_from")
