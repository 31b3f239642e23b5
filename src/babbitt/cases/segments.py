"""The film of the heat balance by segments: a groove in the loaded zone, a compliant wall, a given profile."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.cases.part import Complaint, Part, is_given, rule
from babbitt.segments.model import Groove, GrooveKind, complaints_about_groove, complaints_about_profile
from babbitt.units import si


class LoadedGrooveGiven(Part):
    """An axial groove in the loaded zone. Its angle counts from the widest gap in the direction of rotation."""

    example: ClassVar[str] = "{kind: through, angle: 150 deg, width: 6 mm}"

    kind: Literal["through", "blind", "none"] = Field(
        description="through: open at both ends, or fed; blind: closed at its ends; none: no groove."
    )
    angle: Annotated[float, si("rad", "0 deg", "360 deg")] | None = Field(
        None, description="Centre of the groove, from the widest gap in the direction of rotation."
    )
    width: Annotated[float, si("m", "0.01 mm", "1 m")] | None = Field(
        None, description="Width around the bore. 0 mm cuts the film in two and removes nothing."
    )
    mixing_factor: Annotated[float, si("1", "0", "1")] = Field(
        1.0, description="Share of fresh oil in what enters the film behind a through groove."
    )
    pressure: Annotated[float, si("Pa", "0 Pa", "50 MPa")] = Field(
        0.0, description="Gauge pressure in a through groove."
    )

    @rule
    def _place_is_known(self) -> Iterator[Complaint]:
        for name, such in (("angle", "150 deg"), ("width", "6 mm")):
            if self.kind != "none" and not is_given(self, name):
                yield Complaint((name,), "is missing", f"where the groove is, such as '{such}'", code="E003")

    @rule
    def _blind_grooves_find_their_pressure(self) -> Iterator[Complaint]:
        if self.kind == "blind" and self.pressure > 0.0:
            says = "the pressure of a blind groove follows from the oil that it passes on"
            yield Complaint(("pressure",), says, "kind: through, or leave it out")

    def groove(self) -> Groove | None:
        """Give the groove of the calculation."""
        if self.kind == "none" or self.angle is None or self.width is None:
            return None
        return Groove(self.angle, self.width, GrooveKind(self.kind), self.mixing_factor, self.pressure)


class ProfilePoint(Part):
    """A film thickness at an angle."""

    angle: Annotated[float, si("rad", "0 deg", "360 deg")] = Field(
        description="From the widest gap in the direction of rotation."
    )
    film_thickness: Annotated[float, si("m", "0.001 um", "100 mm")] = Field(description="Film thickness there.")


class RoughnessGiven(Part):
    """Arithmetic mean roughness of both surfaces."""

    example: ClassVar[str] = "{bearing: 0.63 um, journal: 0.32 um}"

    bearing: Annotated[float, si("m", "0 um", "100 um")] = Field(description="Ra of the bearing.")
    journal: Annotated[float, si("m", "0 um", "100 um")] = Field(description="Ra of the journal.")


class SegmentsGiven(Part):
    """What the heat balance by segments knows of the film."""

    example: ClassVar[str] = "{groove: {kind: through, angle: 150 deg, width: 6 mm}}"

    groove: LoadedGrooveGiven | None = Field(None, description="Groove in the loaded zone. None if not given.")
    film_start: Annotated[float, si("rad", "0 deg", "179 deg")] = Field(
        0.0, description="Where the film begins, from the widest gap in the direction of rotation."
    )
    compliance: Annotated[float, si("m/Pa", "0 um/MPa", "100 um/MPa")] = Field(
        0.0, description="Elastic displacement of the wall per pressure at the same place. 0: rigid."
    )
    profile: tuple[ProfilePoint, ...] = Field(
        (),
        max_length=5000,
        description="Film thickness around the bearing, in place of load or eccentricity; the load is found.",
    )
    roughness: RoughnessGiven | None = Field(
        None, description="Roughness Ra, to warn of films thinner than three times both together."
    )

    def points(self) -> tuple[tuple[float, float], ...]:
        """Angles and film thicknesses of the profile."""
        return tuple((point.angle, point.film_thickness) for point in self.profile)


def complaints_about(given: SegmentsGiven, diameter: float) -> Iterator[Complaint]:
    """Complain about a groove outside the film and a profile that is none."""
    groove = given.groove.groove() if given.groove is not None else None
    if groove is not None:
        for said in complaints_about_groove(groove, diameter, given.film_start):
            yield Complaint(("segments", "groove"), said, "a groove inside the film, narrower than it")
    for said in complaints_about_profile(given.points()):
        yield Complaint(("segments", "profile"), said, "at least 8 points, angles rising from 0 to below 360 deg")
