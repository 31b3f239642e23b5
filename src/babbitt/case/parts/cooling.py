"""Heat given to the surroundings through the housing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Discriminator, Field

from babbitt.case.part import Issue, Part, at_most_one, rule
from babbitt.core.units import si, written
from babbitt.design.cooling import (
    MACHINE_SURFACE_FACTORS,
    STILL_AIR_COEFFICIENT,
    cylindrical_housing_surface,
    pedestal_surface,
    surface_in_machine,
)

HousingSize = Annotated[float, si("m", "1 mm", "10 m")]


class CylinderHousing(Part):
    """A cylindrical housing."""

    kind: Literal["cylinder"] = Field(description="Cylindrical housing.")
    diameter: HousingSize = Field(description="Outside diameter of the housing, D_H.")
    width: HousingSize = Field(description="Width of the housing, B_H.")

    def surface(self, bearing_diameter: float, bearing_width: float) -> float:
        """Give the emitting surface in m2."""
        return cylindrical_housing_surface(self.diameter, self.width, bearing_diameter)


class PedestalHousing(Part):
    """A pedestal bearing."""

    kind: Literal["pedestal"] = Field(description="Pedestal bearing.")
    height: HousingSize = Field(description="Height of the pedestal, H.")
    width: HousingSize = Field(description="Width of the pedestal, B_H.")

    def surface(self, bearing_diameter: float, bearing_width: float) -> float:
        """Give the emitting surface in m2."""
        return pedestal_surface(self.height, self.width)


class InMachine(Part):
    """A bearing inside a machine."""

    kind: Literal["in_machine"] = Field(description="Bearing inside a machine.")
    factor: Annotated[float, si("1", "15", "20")] = Field(
        MACHINE_SURFACE_FACTORS[0], description="Emitting surface over B D. 15 is safe."
    )

    def surface(self, bearing_diameter: float, bearing_width: float) -> float:
        """Give the emitting surface in m2."""
        return surface_in_machine(bearing_width, bearing_diameter, self.factor)


Housing = Annotated[CylinderHousing | PedestalHousing | InMachine, Discriminator("kind")]


class Cooling(Part):
    """Heat given to the surroundings. A bearing may give single fields and take the others from its machine."""

    example: ClassVar[str] = "{ambient_temperature: 20 degC, surface: 0.3 m2}"
    alternatives: ClassVar[tuple[tuple[str, ...], ...]] = (
        ("heat_transfer_coefficient", "air_speed"),
        ("surface", "housing"),
    )

    ambient_temperature: Annotated[float, si("K", "-60 degC", "100 degC")] | None = Field(
        None, description="Temperature of the air around the housing, T_amb."
    )
    heat_transfer_coefficient: Annotated[float, si("W/(m2 K)", "1 W/(m2 K)", "1000 W/(m2 K)")] | None = Field(
        None,
        description="Heat transfer coefficient k_A of the housing. Without it and without air_speed "
        f"{STILL_AIR_COEFFICIENT:g} W/(m2 K) is assumed.",
    )
    air_speed: Annotated[float, si("m/s", "0 m/s", "100 m/s")] | None = Field(
        None, description="Speed of the air along the housing, in place of the heat transfer coefficient."
    )
    surface: Annotated[float, si("m2", "1 cm2", "1000 m2")] | None = Field(
        None, description="Heat-emitting surface of the housing, A."
    )
    housing: Housing | None = Field(None, description="Shape of the housing, in place of its surface.")

    @rule
    def _one_coefficient(self) -> Iterator[Issue]:
        yield from at_most_one(self, "heat_transfer_coefficient", "air_speed")

    @rule
    def _one_surface(self) -> Iterator[Issue]:
        yield from at_most_one(self, "surface", "housing")


def issues_of(cooling: Cooling, diameter: float) -> Iterator[Issue]:
    """Complain about a housing that its bearing does not fit into."""
    housing = cooling.housing
    if isinstance(housing, CylinderHousing) and housing.diameter <= diameter:
        says = f"the housing, {written(housing.diameter, 'mm')}, is not larger than the bearing"
        yield Issue(("cooling", "housing", "diameter"), says, f"more than {written(diameter, 'mm')}")
