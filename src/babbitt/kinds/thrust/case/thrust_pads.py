"""Pads of a thrust bearing, what they stand on, and what displaces them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Discriminator, Field

from babbitt.case.aliases import FormerWords, Moved
from babbitt.case.part import Issue, Part, rule
from babbitt.case.parts.fields import WholeNumber
from babbitt.case.parts.materials import MetalInput
from babbitt.core.units import si, written
from babbitt.kinds.thrust.bearing import HousingTilt
from babbitt.kinds.thrust.face import PlaneFace, SteppedFace, TaperedFace
from babbitt.kinds.thrust.thermal_crown import thermal_crown
from babbitt.properties.materials import BearingMetal

Diameter = Annotated[float, si("m", "2 mm", "20 m")]
Radius = Annotated[float, si("m", "1 mm", "10 m")]
Share = Annotated[float, si("1", "0.01", "0.99")]
Depth = Annotated[float, si("m", "0.1 um", "10 mm", "um")]
Inertia = Annotated[float, si("kg m2", "0 kg m2", "1e6 kg m2")]
Stiffness = Annotated[float, si("N/m", "1 kN/m", "1e18 N/m", "GN/m")]
Damping = Annotated[float, si("N s/m", "0 N s/m", "1e12 N s/m")]
PartMass = Annotated[float, si("kg", "0 kg", "10000 t")]


class TiltingPivot(Part):
    """A pad that tilts without friction about a point, or about a line along the radius."""

    kind: Literal["point", "line"] = Field(description="Tilts about two axes, or about a radius only.")
    radius: Radius = Field(description="Radius of the pivot, r_p.")
    fraction: Share = Field(
        description="Angle of the pivot from the leading edge over the angle of the pad, at positive speed. A "
        "plane pad "
        "needs more than 0.5."
    )


class FixedPad(Part):
    """A pad that does not tilt."""

    kind: Literal["fixed"] = Field(description="Does not tilt.")


class TaperFace(Part):
    """A taper before a land."""

    kind: Literal["taper"] = Field(description="Taper from the leading edge to a land.")
    depth: Depth = Field(description="Depth of the taper at the leading edge.")
    fraction: Share = Field(description="Length of the taper over the angle of the pad.")

    def face(self) -> TaperedFace:
        """Give the face of the calculation."""
        return TaperedFace(self.depth, self.fraction)


class StepFace(Part):
    """A step before a land."""

    kind: Literal["step"] = Field(description="Step from the leading edge to a land.")
    depth: Depth = Field(description="Depth of the step.")
    fraction: Share = Field(description="Length before the step over the angle of the pad.")

    def face(self) -> SteppedFace:
        """Give the face of the calculation."""
        return SteppedFace(self.depth, self.fraction)


PivotInput = Annotated[TiltingPivot | FixedPad, Discriminator("kind")]
FaceInput = Annotated[TaperFace | StepFace, Discriminator("kind")]


class ThrustPads(Part):
    """Equal pads on a ring."""

    former_words: ClassVar[FormerWords] = {
        "inner_radius": Moved("inner_diameter", scale=2.0),
        "outer_radius": Moved("outer_diameter", scale=2.0),
    }

    number: Annotated[int, WholeNumber(2, 100)] = Field(description="Number of pads.")
    inner_diameter: Diameter = Field(description="Inner diameter of the pads.")
    outer_diameter: Diameter = Field(description="Outer diameter of the pads.")
    extent: Annotated[float, si("rad", "1 deg", "179 deg")] = Field(description="Angle of one pad.")
    pivot: PivotInput = Field(description="How a pad may move.")
    face: FaceInput | None = Field(None, description="What is taken off the face. None: plane.")
    crown: Annotated[float, si("m", "-1 mm", "1 mm", "um")] = Field(
        0.0,
        description="Crown: how much farther from the collar the middle of every edge is than the middle of the "
        "pad, by parabolas along and across; a sphere where the pad is as long as wide. It stands for grinding, "
        "or for bending and heat as known from elsewhere.",
    )
    mass: PartMass = Field(0.0, description="Mass of one pad.")
    inertia_radial: Inertia = Field(0.0, description="Moment of inertia of a pad for tilting along the radius.")
    inertia_along: Inertia = Field(0.0, description="Moment of inertia of a pad for tilting along the motion.")
    heights: tuple[Annotated[float, si("m", "-5 mm", "5 mm", "um")], ...] = Field(
        (), max_length=100, description="How much each pad stands higher than the mean, pad 1 first. Empty: none."
    )

    @rule
    def _radii_in_order(self) -> Iterator[Issue]:
        if self.outer_diameter <= self.inner_diameter:
            yield Issue(
                ("outer_diameter",),
                f"{written(self.outer_diameter, 'mm')} is not beyond inner_diameter "
                f"{written(self.inner_diameter, 'mm')}",
                f"more than {written(self.inner_diameter, 'mm')}",
                "are the two exchanged?",
            )

    @rule
    def _pads_do_not_touch(self) -> Iterator[Issue]:
        room = 6.283185307179586 / self.number
        if self.extent >= room:
            yield Issue(
                ("extent",),
                f"{self.number} pads of {written(self.extent, 'deg')} overlap",
                f"less than {written(room, 'deg')} for {self.number} pads",
            )

    @rule
    def _pivot_under_the_pad(self) -> Iterator[Issue]:
        pivot = self.pivot
        inner, outer = self.radii()
        beside = isinstance(pivot, TiltingPivot) and not inner < pivot.radius < outer
        if isinstance(pivot, TiltingPivot) and inner < outer and beside:
            yield Issue(
                ("pivot", "radius"),
                f"the pivot at {written(pivot.radius, 'mm')} is not under the pad",
                f"between {written(inner, 'mm')} and {written(outer, 'mm')}",
            )

    @rule
    def _one_height_each(self) -> Iterator[Issue]:
        if self.heights and len(self.heights) != self.number:
            yield Issue(
                ("heights",),
                f"{len(self.heights)} heights are given for {self.number} pads",
                f"{self.number} heights, or leave them out",
            )

    @rule
    def _fixed_pads_need_a_wedge(self) -> Iterator[Issue]:
        if isinstance(self.pivot, FixedPad) and self.face is None and self.crown == 0.0:
            yield Issue(
                ("face",),
                "a fixed plane pad in oil of one viscosity carries nothing",
                "a face of kind taper or step, a crown, or a pivot",
            )

    def radii(self) -> tuple[float, float]:
        """Give the inner and the outer radius, m."""
        return 0.5 * self.inner_diameter, 0.5 * self.outer_diameter

    @property
    def crowned_by_heat(self) -> bool:
        """Whether plane pads on a pivot in their middle are taken to carry by the crown that heat gives them."""
        pivot = self.pivot
        centred = isinstance(pivot, TiltingPivot) and pivot.fraction == 0.5
        return centred and self.face is None and "crown" not in self.model_fields_set

    def crown_at_work(self) -> float:
        """Give the crown of the calculation, m: as given, or as heat makes it."""
        if not self.crowned_by_heat:
            return self.crown
        return thermal_crown(0.5 * sum(self.radii()) * self.extent)

    def plane_or_face(self) -> PlaneFace | TaperedFace | SteppedFace:
        """Give the face of the calculation."""
        return PlaneFace() if self.face is None else self.face.face()


class PadMaterials(Part):
    """What the pads are made of."""

    example: ClassVar[str] = "{bearing_metal: B83}"

    bearing_metal: MetalInput | None = Field(
        None,
        description="Bearing metal of the faces. None: B83, an assumption, unless limits.temperature is given.",
    )

    def metal(self) -> BearingMetal | None:
        """Give the bearing metal; None where it is not named."""
        return None if self.bearing_metal is None else self.bearing_metal.metal()


class ThrustLimits(Part):
    """Limits in place of those by experience."""

    example: ClassVar[str] = "{minimum_film_thickness: 10 um, temperature: 100 degC}"

    minimum_film_thickness: Annotated[float, si("m", "0.1 um", "1 mm", "um")] | None = Field(
        None, description="Least film permitted. None: 10 um, an assumption."
    )
    temperature: Annotated[float, si("K", "20 degC", "250 degC")] | None = Field(
        None,
        description="Greatest permissible temperature of the hottest oil known. None: what experience allows at "
        "the outlet, and the limit of the bearing metal.",
    )


class Tilt(Part):
    """Tilt of the housing against the collar."""

    offset: Annotated[float, si("m", "0 um", "10 mm", "um")] = Field(
        description="Axial departure at the outer edge of the pads, e_o: half the difference across the diameter."
    )
    direction: Annotated[float, si("rad", "-360 deg", "360 deg")] = Field(
        0.0, description="Where the housing comes closest to the collar, counter-clockwise from pad 1."
    )

    def tilt(self) -> HousingTilt:
        """Give the tilt of the calculation."""
        return HousingTilt(self.offset, self.direction)
