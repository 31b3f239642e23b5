"""A lubricant: viscosity, density, heat capacity and conductivity over temperature, with their sources."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self

from babbitt.core.units import read
from babbitt.core.units.foreign import as_python
from babbitt.properties.lubricants._evaluation import Value, require_positive, require_range
from babbitt.properties.lubricants.property_laws import PropertyLaw
from babbitt.properties.lubricants.viscosity_laws import ViscosityKind, ViscosityLaw


@dataclass(frozen=True)
class PropertySources:
    """Where the numbers of each property come from; empty where the source of the whole entry says it."""

    viscosity: str = ""
    density: str = ""
    heat_capacity: str = ""
    conductivity: str = ""


@dataclass(frozen=True)
class Lubricant:
    """A fluid as a bearing calculation sees it.

    All methods take a float or an array of temperatures in K and return the same shape in SI. Outside
    `temperature_range` they still answer, since an iteration may pass there; ask `covers` before reporting.

    Parameters
    ----------
    name : str
        As printed in reports.
    viscosity_law : ViscosityLaw
        Kinematic or dynamic; the other one follows with the density.
    density_law, heat_capacity_law, conductivity_law : PropertyLaw
        In kg/m³, J/(kg K) and W/(m K).
    temperature_range : tuple of float
        Lowest and highest temperature in K for which the numbers are meant.
    source : str
        Where the entry comes from.
    fixed_volumetric_heat_capacity : float, optional
        A constant ρc in J/(m³ K) that replaces the product of the two laws; 1.8e6 is the usual value of the
        design check (DIN 31652, ISO 7902).
    assumptions : tuple of str
        What is not published and was assumed, one sentence each.
    heat_capacity_assumptions : tuple of str
        Those of `assumptions` that tell of c or ρc and fall away where ρc is given.
    conductivity_assumptions : tuple of str
        Those of `assumptions` that tell of the conductivity.
    viscosity_index : float, optional
        By ISO 2909, where one of the two viscosities of the law follows from it.
    sources : PropertySources
        Sources of single properties where they differ from `source`.
    aliases : tuple of str
        Other names under which the catalogue finds it.
    origin : str
        File of the user's own catalogue that it stands in; empty for all others.
    """

    name: str
    viscosity_law: ViscosityLaw
    density_law: PropertyLaw
    heat_capacity_law: PropertyLaw
    conductivity_law: PropertyLaw
    temperature_range: tuple[float, float]
    source: str
    fixed_volumetric_heat_capacity: float | None = None
    assumptions: tuple[str, ...] = ()
    heat_capacity_assumptions: tuple[str, ...] = ()
    conductivity_assumptions: tuple[str, ...] = ()
    viscosity_index: float | None = None
    sources: PropertySources = PropertySources()
    aliases: tuple[str, ...] = ()
    origin: str = ""

    def __post_init__(self) -> None:
        require_range(self.name, self.temperature_range)
        if self.fixed_volumetric_heat_capacity is not None:
            require_positive(self.name, fixed_volumetric_heat_capacity=self.fixed_volumetric_heat_capacity)

    def with_volumetric_heat_capacity(self, given: float) -> Self:
        """Give the same oil with a constant ρc in J/(m³ K), of which nothing is assumed any more."""
        others = tuple(one for one in self.assumptions if one not in self.heat_capacity_assumptions)
        return replace(
            self, fixed_volumetric_heat_capacity=given, assumptions=others, heat_capacity_assumptions=()
        )

    @property
    def assumptions_but_of_conduction(self) -> tuple[str, ...]:
        """The assumptions of a method that lets no heat flow through its film, and uses no conductivity."""
        return tuple(one for one in self.assumptions if one not in self.conductivity_assumptions)

    def density(self, temperature: Value) -> Value:
        """Density in kg/m³."""
        return self.density_law(temperature)

    def kinematic_viscosity(self, temperature: Value) -> Value:
        """Kinematic viscosity ν in m²/s."""
        viscosity = self.viscosity_law(temperature)
        if self.viscosity_law.kind is ViscosityKind.KINEMATIC:
            return viscosity
        return viscosity / self.density_law(temperature)

    def viscosity(self, temperature: object) -> float:
        """Dynamic viscosity in Pa s at one temperature: in K, or text with its unit, or a pint quantity.

        >>> from babbitt.properties.lubricants import lubricant
        >>> f"{lubricant('ISO VG 46').viscosity('60 degC'):.4f} Pa s"
        '0.0173 Pa s'
        """
        return float(self.dynamic_viscosity(read(as_python(temperature), "K")))

    def dynamic_viscosity(self, temperature: Value) -> Value:
        """Dynamic viscosity η = ν ρ in Pa s."""
        viscosity = self.viscosity_law(temperature)
        if self.viscosity_law.kind is ViscosityKind.DYNAMIC:
            return viscosity
        return viscosity * self.density_law(temperature)

    def heat_capacity(self, temperature: Value) -> Value:
        """Specific heat capacity c in J/(kg K)."""
        return self.heat_capacity_law(temperature)

    def volumetric_heat_capacity(self, temperature: Value) -> Value:
        """Heat capacity per volume ρc in J/(m³ K): the fixed value if there is one, else the product."""
        if self.fixed_volumetric_heat_capacity is not None:
            return self.fixed_volumetric_heat_capacity + 0.0 * temperature
        return self.density_law(temperature) * self.heat_capacity_law(temperature)

    def conductivity(self, temperature: Value) -> Value:
        """Thermal conductivity in W/(m K)."""
        return self.conductivity_law(temperature)

    def covers(self, temperature: float) -> bool:
        """Whether a temperature in K lies in the range for which the numbers are meant."""
        lower, upper = self.temperature_range
        return lower <= temperature <= upper
