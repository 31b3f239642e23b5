"""Gears, couplings, masses and forces on a shaft, as an engineer writes them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from babbitt.case.part import Issue, Part, at_most_one, exactly_one, rule
from babbitt.case.parts.fields import Name, WholeNumber
from babbitt.core.units import si
from babbitt.kinds.shaft.case.torque import PartMass, Station, TorquePart
from babbitt.kinds.shaft.gears import Gear, Helix
from babbitt.kinds.shaft.model import STANDARD_GRAVITY, PointLoad

__all__ = ["CouplingInput", "ForceInput", "GearInput", "MassInput", "weight"]

Component = Annotated[float, si("N", "-1000 MN", "1000 MN")]
Moment = Annotated[float, si("N m", "-1e9 N m", "1e9 N m")]


class GearInput(TorquePart):
    """An external spur or helical gear."""

    alternatives: ClassVar[tuple[tuple[str, ...], ...]] = (("pitch_diameter", "teeth"),)

    pitch_diameter: Annotated[float, si("m", "1 mm", "20 m")] | None = Field(
        None, description="Pitch diameter d, at which the tooth force acts; the working one where it differs."
    )
    teeth: Annotated[int, WholeNumber(5, 2000)] | None = Field(
        None, description="Number of teeth z, with normal_module in place of the diameter: d = z m_n / cos beta."
    )
    normal_module: Annotated[float, si("m", "0.1 mm", "100 mm", "mm")] | None = Field(
        None, description="Normal module m_n, with the number of teeth."
    )
    pressure_angle: Annotated[float, si("rad", "10 deg", "35 deg")] = Field(
        math.radians(20.0), description="Normal pressure angle alpha_n. 20 deg if not given."
    )
    helix_angle: Annotated[float, si("rad", "0 deg", "45 deg")] = Field(
        0.0, description="Helix angle beta. 0 if not given: a spur gear."
    )
    helix: Literal["right", "left", "double"] | None = Field(
        None,
        description="Hand of the helix; a double helix has no axial force. The mating gear has the other hand.",
    )
    mesh_angle: Annotated[float, si("rad", "-360 deg", "360 deg")] = Field(
        description="Direction from the axis of the shaft to that of the mating gear, counter-clockwise from +x."
    )

    @rule
    def _one_diameter(self) -> Iterator[Issue]:
        yield from exactly_one(self, "pitch_diameter", "teeth")
        yield from at_most_one(self, "pitch_diameter", "normal_module")
        if self.teeth is not None and self.normal_module is None:
            yield Issue(("normal_module",), "is missing", "a length such as '5 mm', with the teeth", code="E003")

    @rule
    def _hand_of_a_helix(self) -> Iterator[Issue]:
        if self.helix_angle > 0.0 and self.helix is None:
            yield Issue(("helix",), "is missing", "right, left or double", code="E003")

    @property
    def diameter(self) -> float:
        """Pitch diameter, m."""
        if self.pitch_diameter is not None:
            return self.pitch_diameter
        return (self.teeth or 0) * (self.normal_module or 0.0) / math.cos(self.helix_angle)

    def gear(self, torque: float) -> Gear:
        """Give the gear of the calculation, with its torque on the shaft in N m."""
        helix = Helix[(self.helix or "right").upper()]
        return Gear(
            self.name, self.station, self.diameter, self.pressure_angle, self.helix_angle, helix, self.mesh_angle,
            torque,
        )  # fmt: skip


class CouplingInput(TorquePart):
    """A coupling, which hands on torque and weighs on the shaft."""

    def load(self, torque: float) -> PointLoad:
        """Give the torque of the calculation, N m."""
        return PointLoad(self.name, self.station, (0.0, 0.0, 0.0), (0.0, 0.0, torque))


class MassInput(Part):
    """A mass on the shaft."""

    name: Name = Field(description="Name in tables and figures.")
    station: Station = Field(description="Place of its centre along the shaft.")
    mass: PartMass = Field(description="Mass.")


class ForceInput(Part):
    """A force, or a couple, on the shaft: of a belt, an impeller, a magnet, or a gear whose force is known."""

    name: Name = Field(description="Name in tables and figures.")
    station: Station = Field(description="Place along the shaft.")
    x: Component = Field(0.0, description="Force to the right.")
    y: Component = Field(0.0, description="Force upward.")
    z: Component = Field(0.0, description="Force along the shaft.")
    moment_x: Moment = Field(0.0, description="Couple about the x axis.")
    moment_y: Moment = Field(0.0, description="Couple about the y axis.")

    def load(self) -> PointLoad:
        """Give the load of the calculation."""
        return PointLoad(self.name, self.station, (self.x, self.y, self.z), (self.moment_x, self.moment_y, 0.0))


def weight(part: TorquePart | MassInput) -> PointLoad:
    """The weight of what has a mass on the shaft."""
    return PointLoad(f"{part.name}, weight", part.station, (0.0, -STANDARD_GRAVITY * part.mass, 0.0))
