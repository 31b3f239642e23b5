"""Parts of hydrostatic bearings: their lengths and angles, their oil, their recesses."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, ClassVar

from pydantic import Field

from babbitt.case.part import Issue, Part, is_given, rule
from babbitt.case.parts.fields import WholeNumber
from babbitt.case.parts.own_lubricant import DynamicViscosity
from babbitt.core.units import either_sense, si

Length = Annotated[float, si("m", "0.1 mm", "20 m")]
Gap = Annotated[float, si("m", "1 um", "2 mm")]
Load = Annotated[float, si("N", "1 N", "1000 MN")]
Angle = Annotated[float, si("rad", "-360 deg", "360 deg")]
Extent = Annotated[float, si("rad", "0.5 deg", "359 deg")]
Groove = Annotated[float, si("rad", "0 deg", "180 deg")]
Speed = Annotated[float, either_sense("rad/s", "0 rpm", "200000 rpm")]
Frequency = Annotated[float, si("frequency", "0 Hz", "100 kHz")]


class HydrostaticOil(Part):
    """The oil by its numbers, in place of a lubricant at a temperature."""

    example: ClassVar[str] = "{viscosity: 20 mPas, density: 870 kg/m3, heat_capacity: 2000 J/(kg K)}"

    viscosity: DynamicViscosity | None = Field(None, description="Viscosity in the film.")
    density: Annotated[float, si("kg/m3", "500 kg/m3", "2500 kg/m3")] = Field(
        870.0, description="Density. Used with viscosity; a lubricant has its own."
    )
    heat_capacity: Annotated[float, si("J/(kg K)", "500 J/(kg K)", "10 kJ/(kg K)")] = Field(
        2000.0, description="Specific heat. Used with viscosity; a lubricant has its own."
    )


class GapLimits(Part):
    """Limits of the user."""

    example: ClassVar[str] = "{minimum_film_thickness: 20 um}"

    minimum_film_thickness: Gap | None = Field(None, description="Least permissible gap.")


class RecessOil(Part):
    """Depth of the recesses and the oil that gives way in them."""

    example: ClassVar[str] = "{depth: 1 mm, line_volume: 2 mL}"

    depth: Annotated[float, si("m", "10 um", "100 mm", sample="1 mm")] = Field(
        description="Depth of the recesses."
    )
    line_volume: Annotated[float, si("m3", "0 mL", "100 L")] = Field(
        0.0, description="Oil between one restrictor and its recess, without the recess itself."
    )
    bulk_modulus: Annotated[float, si("Pa", "1 MPa", "10 GPa")] = Field(
        1.4e9, description="Bulk modulus of the oil with its air."
    )
    friction_factor: Annotated[float, si("1", "1", "8")] | None = Field(
        None,
        description="Wall shear in the recess over mu U/depth: 1 where the oil turns with the runner (round and "
        "annular recesses), 4 in closed recesses with recirculation. Chosen by the shape if not given.",
    )


class RecessRow(Part):
    """Equal recesses around the axis."""

    example: ClassVar[str] = "{number: 4, extent: 60 deg, first: -90 deg}"

    number: Annotated[int, WholeNumber(1, 60)] = Field(description="Number of recesses.")
    extent: Extent = Field(description="Angle that each takes.")
    first: Angle = Field(-0.5 * math.pi, description="Middle of the first, from +x counter-clockwise.")
    angles: tuple[Angle, ...] = Field(
        (), max_length=60, description="Middles of all recesses, where they do not stand at equal distances."
    )
    drain_groove: Groove = Field(
        0.0, description="Angle of drain grooves at ambient pressure halfway between the recesses; zero: none."
    )

    @rule
    def _all_angles(self) -> Iterator[Issue]:
        if self.angles and len(self.angles) != self.number:
            yield Issue(("angles",), f"{len(self.angles)} angles for {self.number} recesses", "one for each")
        if self.angles and is_given(self, "first"):
            yield Issue(("first",), "given together with angles", "first, or angles", "remove one")

    @property
    def middles(self) -> tuple[float, ...]:
        """Middles of the recesses, rad."""
        return self.angles or tuple(self.first + 2.0 * math.pi * k / self.number for k in range(self.number))
