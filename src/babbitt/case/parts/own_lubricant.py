"""What is known of an own oil in addition to its viscosity, and the points of its viscosity laws."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from babbitt.case.part import Issue, Part, exactly_one, refused, rule
from babbitt.case.parts.fields import Name
from babbitt.core.units import si
from babbitt.properties.lubricants import Lubricant, OilProperties

KinematicViscosity = Annotated[float, si("m2/s", "0.1 mm2/s", "100000 mm2/s")]
DynamicViscosity = Annotated[float, si("Pa s", "0.01 mPa s", "1000 Pa s")]
OilDataTemperature = Annotated[float, si("K", "-60 degC", "300 degC")]
VolumetricHeatCapacity = Annotated[float, si("J/(m3 K)", "0.1 MJ/(m3 K)", "10 MJ/(m3 K)")]


class KinematicPoint(Part):
    """A kinematic viscosity at a temperature."""

    temperature: OilDataTemperature = Field(description="Temperature of the point.")
    kinematic_viscosity: KinematicViscosity = Field(description="Kinematic viscosity there.")

    @property
    def pair(self) -> tuple[float, float]:
        """Temperature in K and viscosity in m2/s."""
        return self.temperature, self.kinematic_viscosity


class DynamicPoint(Part):
    """A dynamic viscosity at a temperature."""

    temperature: OilDataTemperature = Field(description="Temperature of the point.")
    dynamic_viscosity: DynamicViscosity = Field(description="Dynamic viscosity there.")

    @property
    def pair(self) -> tuple[float, float]:
        """Temperature in K and viscosity in Pa s."""
        return self.temperature, self.dynamic_viscosity


class ViscosityPoint(Part):
    """A viscosity at a temperature, dynamic or kinematic."""

    temperature: OilDataTemperature = Field(description="Temperature of the point.")
    dynamic_viscosity: DynamicViscosity | None = Field(None, description="Dynamic viscosity there.")
    kinematic_viscosity: KinematicViscosity | None = Field(None, description="Kinematic viscosity there.")

    @property
    def pair(self) -> tuple[float, float]:
        """Temperature in K and viscosity in Pa s or m2/s."""
        return self.temperature, self.dynamic_viscosity or self.kinematic_viscosity or 0.0

    @rule
    def _one_viscosity(self) -> Iterator[Issue]:
        yield from exactly_one(self, "dynamic_viscosity", "kinematic_viscosity")


class OwnLubricant(Part):
    """Data of an own oil in addition to its viscosity; what is missing is that of a typical mineral oil."""

    name: Name = Field("own oil", description="As it shall appear in reports.")
    source: Name = Field("given in the case", description="Where the numbers come from.")
    density: Annotated[float, si("kg/m3", "500 kg/m3", "2500 kg/m3")] | None = Field(
        None, description="Density at density_temperature. Assumed as of a typical mineral oil if not given."
    )
    density_temperature: OilDataTemperature = Field(
        288.15, description="Temperature of the density. 15 degC as on data sheets."
    )
    density_slope: Annotated[float, si("kg/(m3 K)", "-5 kg/(m3 K)", "0 kg/(m3 K)")] | None = Field(
        None, description="Change of density per kelvin. Needs density."
    )
    heat_capacity: Annotated[float, si("J/(kg K)", "500 J/(kg K)", "10 kJ/(kg K)")] | None = Field(
        None, description="Heat capacity at heat_capacity_temperature. Assumed if not given."
    )
    heat_capacity_temperature: OilDataTemperature = Field(323.15, description="Temperature of the heat capacity.")
    heat_capacity_slope: Annotated[float, si("J/(kg K2)", "-20 J/(kg K2)", "20 J/(kg K2)")] | None = Field(
        None, description="Change of heat capacity per kelvin. Needs heat_capacity."
    )
    conductivity: Annotated[float, si("W/(m K)", "0.01 W/(m K)", "10 W/(m K)")] | None = Field(
        None, description="Thermal conductivity. Assumed if not given."
    )
    volumetric_heat_capacity: VolumetricHeatCapacity | None = Field(
        None, description="Constant density times heat capacity. Usual in design checks: 1.8 MJ/(m3 K)."
    )

    @property
    def properties(self) -> OilProperties:
        """What is known in addition to viscosity."""
        return OilProperties(
            self.density,
            self.density_temperature,
            self.density_slope,
            self.heat_capacity,
            self.heat_capacity_temperature,
            self.heat_capacity_slope,
            self.conductivity,
            self.volumetric_heat_capacity,
        )

    @abstractmethod
    def lubricant(self) -> Lubricant:
        """Give the lubricant of the calculation."""

    @rule
    def _slopes_have_values(self) -> Iterator[Issue]:
        for name in ("density", "heat_capacity"):
            if getattr(self, f"{name}_slope") is not None and getattr(self, name) is None:
                yield Issue((f"{name}_slope",), f"{name}_slope is given without {name}", "both or none")

    @rule
    def _lubricant_can_be_made(self) -> Iterator[Issue]:
        yield from refused((), self.lubricant)
