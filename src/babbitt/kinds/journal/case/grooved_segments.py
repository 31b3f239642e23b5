"""The film of the heat balance by segments: a groove in the loaded zone, a compliant wall, a given profile."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.part import Issue, Part, at_most_one, is_given, rule
from babbitt.core.units import si, written
from babbitt.kinds.journal.grooved_long_bearing.model import (
    AngleOrigin,
    Groove,
    GrooveKind,
    issues_of_groove,
    issues_of_profile,
)


class LoadedGrooveInput(Part):
    """An axial groove in the loaded zone, at its place in the bush or at an angle from the widest gap."""

    example: ClassVar[str] = "{kind: through, angle_from_load: -20 deg, width: 6 mm}"

    kind: Literal["through", "blind", "none"] = Field(
        description="through: open at both ends, or fed; blind: closed at its ends; none: no groove."
    )
    angle_from_load: Annotated[float, si("rad", "-90 deg", "90 deg")] | None = Field(
        None,
        description="Place of the groove in the bush: its centre, from the load line in the direction of "
        "rotation; negative where the oil passes it before the load line.",
    )
    angle: Annotated[float, si("rad", "0 deg", "360 deg")] | None = Field(
        None,
        description="Centre of the groove from the widest gap in the direction of rotation, in place of "
        "angle_from_load: as published, the groove then moves with the journal.",
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
    end_land: Annotated[float, si("m", "0.1 mm", "1 m")] | None = Field(
        None,
        description="Land between a blind groove and each side of the bearing, for the film in two dimensions "
        "that babbitt compare puts beside it. As wide as the groove if not given, an assumption.",
    )

    @rule
    def _place_is_known(self) -> Iterator[Issue]:
        if self.kind == "none":
            return
        if not is_given(self, "angle") and not is_given(self, "angle_from_load"):
            allowed = "the place of the groove in the bush, such as '-20 deg' (20 deg before the load line)"
            yield Issue(("angle_from_load",), "is missing", allowed, code="E003")
        if not is_given(self, "width"):
            yield Issue(("width",), "is missing", "the width of the groove, such as '6 mm'", code="E003")
        yield from at_most_one(self, "angle_from_load", "angle")

    @rule
    def _blind_grooves_find_their_pressure(self) -> Iterator[Issue]:
        if self.kind == "blind" and self.pressure > 0.0:
            says = "the pressure of a blind groove follows from the oil that it passes on"
            yield Issue(("pressure",), says, "kind: through, or leave it out")

    def groove(self) -> Groove | None:
        """Give the groove of the calculation."""
        if self.kind == "none" or self.width is None:
            return None
        from_load = self.angle_from_load is not None
        angle = self.angle_from_load if from_load else self.angle
        if angle is None:
            return None
        origin = AngleOrigin.LOAD_LINE if from_load else AngleOrigin.WIDEST_GAP
        kind = GrooveKind(self.kind)
        return Groove(angle, self.width, kind, self.mixing_factor, self.pressure, origin, self.end_land)


class ProfilePoint(Part):
    """A film thickness at an angle."""

    angle: Annotated[float, si("rad", "0 deg", "360 deg")] = Field(
        description="From the widest gap in the direction of rotation."
    )
    film_thickness: Annotated[float, si("m", "0.001 um", "100 mm")] = Field(description="Film thickness there.")


class RoughnessInput(Part):
    """Arithmetic mean roughness of both surfaces."""

    example: ClassVar[str] = "{bearing: 0.63 um, journal: 0.32 um}"

    bearing: Annotated[float, si("m", "0 um", "100 um")] = Field(description="Ra of the bearing.")
    journal: Annotated[float, si("m", "0 um", "100 um")] = Field(description="Ra of the journal.")


class SegmentsInput(Part):
    """What the heat balance by segments knows of the film."""

    example: ClassVar[str] = "{groove: {kind: through, angle_from_load: -20 deg, width: 6 mm}}"

    groove: LoadedGrooveInput | None = Field(None, description="Groove in the loaded zone. None if not given.")
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
    roughness: RoughnessInput | None = Field(
        None, description="Roughness Ra, to warn of films thinner than three times 1.25 Ra of both together."
    )

    def points(self) -> tuple[tuple[float, float], ...]:
        """Angles and film thicknesses of the profile."""
        return tuple((point.angle, point.film_thickness) for point in self.profile)


def issues_of(given: SegmentsInput, diameter: float, width: float | None) -> Iterator[Issue]:
    """Complain about a groove outside the film or the bearing, and a profile that is none; sizes in m."""
    groove = given.groove.groove() if given.groove is not None else None
    if groove is not None:
        if groove.at_place_in_bush and given.profile:
            says = "a film thickness of your own has no load line before its load is found"
            yield Issue(("segments", "groove", "angle_from_load"), says, "angle, from the widest gap")
        if groove.end_land is not None and width is not None and 2.0 * groove.end_land >= width:
            says = f"two end lands of {written(groove.end_land, 'mm')} leave no groove in the bearing"
            allowed = f"less than {written(0.5 * width, 'mm')}"
            yield Issue(("segments", "groove", "end_land"), says, allowed)
        for said in issues_of_groove(groove, diameter, given.film_start):
            yield Issue(("segments", "groove"), said, "a groove inside the film, narrower than it")
    for said in issues_of_profile(given.points()):
        yield Issue(("segments", "profile"), said, "at least 8 points, angles rising from 0 to below 360 deg")
