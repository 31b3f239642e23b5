"""Lubricants from a user's own numbers: points, viscosity index, or a finished law.

What the user does not know (density slope, heat capacity, conductivity) is taken from the typical mineral oil
of the catalogue, and each such choice is written into `Lubricant.assumptions`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from babbitt.core.notices import InputError
from babbitt.core.units import ZERO_CELSIUS
from babbitt.properties.lubricants._evaluation import Point
from babbitt.properties.lubricants.catalogue import shared_law
from babbitt.properties.lubricants.lubricant import Lubricant
from babbitt.properties.lubricants.property_laws import ConstantProperty, LinearProperty, PropertyLaw, ShiftedLaw
from babbitt.properties.lubricants.viscosity_index import nu100_from_viscosity_index
from babbitt.properties.lubricants.viscosity_laws import OIL_TEMPERATURE_RANGE, ViscosityLaw
from babbitt.properties.lubricants.walther import AstmD341, Walther

_AT_40 = 40.0 + ZERO_CELSIUS
_AT_100 = 100.0 + ZERO_CELSIUS


@dataclass(frozen=True)
class OilProperties:
    """What is known of an oil in addition to its viscosity; everything is optional.

    Parameters
    ----------
    density : float, optional
        In kg/m³ at `density_temperature`.
    density_temperature : float
        In K; 288.15 (15 °C) as on data sheets.
    density_slope : float, optional
        In kg/(m³ K), negative. Only with `density`.
    heat_capacity : float, optional
        In J/(kg K) at `heat_capacity_temperature`.
    heat_capacity_temperature : float
        In K; 323.15 (50 °C).
    heat_capacity_slope : float, optional
        In J/(kg K²). Only with `heat_capacity`.
    conductivity : float, optional
        In W/(m K), constant.
    volumetric_heat_capacity : float, optional
        Constant ρc in J/(m³ K) instead of density times heat capacity.
    """

    density: float | None = None
    density_temperature: float = 15.0 + ZERO_CELSIUS
    density_slope: float | None = None
    heat_capacity: float | None = None
    heat_capacity_temperature: float = 50.0 + ZERO_CELSIUS
    heat_capacity_slope: float | None = None
    conductivity: float | None = None
    volumetric_heat_capacity: float | None = None

    def __post_init__(self) -> None:
        if self.density_slope is not None and self.density_slope > 0.0:
            raise InputError(
                "E003",
                f"density_slope must not be above 0: an oil expands while it warms, given {self.density_slope!r}.",
            )
        for field, value, slope in (
            ("density", self.density, self.density_slope),
            ("heat_capacity", self.heat_capacity, self.heat_capacity_slope),
        ):
            if value is None and slope is not None:
                raise InputError(
                    "E004", f"{field}_slope is given without {field}. Give both, or leave out the slope."
                )


def lubricant_from_law(
    name: str,
    viscosity_law: ViscosityLaw,
    properties: OilProperties | None = None,
    *,
    source: str = "given by the user",
) -> Lubricant:
    """Build a lubricant from a viscosity law and what else is known.

    Parameters
    ----------
    name : str
        As it shall appear in reports.
    viscosity_law : ViscosityLaw
        Any law; its temperature range becomes that of the lubricant.
    properties : OilProperties, optional
        Density, heat capacity, conductivity; what is missing is assumed and said so.
    source : str
        Where the numbers come from.

    Raises
    ------
    InputError
        E003 for numbers that are not usable.
    """
    known = properties or OilProperties()
    density, density_notes = _law_of(
        "mineral_oil_density", known.density, known.density_temperature, known.density_slope
    )
    heat_capacity, heat_capacity_notes = _law_of(
        "mineral_oil_heat_capacity",
        known.heat_capacity,
        known.heat_capacity_temperature,
        known.heat_capacity_slope,
    )
    if known.volumetric_heat_capacity is not None and known.heat_capacity is None:
        heat_capacity_notes = ()  # the assumed heat capacity is not used where the product is given
    conductivity: PropertyLaw
    if known.conductivity is None:
        conductivity, conductivity_notes = _law_of("mineral_oil_conductivity", None, _AT_40, None)
    else:
        conductivity, conductivity_notes = ConstantProperty(known.conductivity), ()
    return Lubricant(
        name=name,
        viscosity_law=viscosity_law,
        density_law=density,
        heat_capacity_law=heat_capacity,
        conductivity_law=conductivity,
        temperature_range=viscosity_law.temperature_range,
        source=source,
        fixed_volumetric_heat_capacity=known.volumetric_heat_capacity,
        assumptions=(*density_notes, *heat_capacity_notes, *conductivity_notes),
        heat_capacity_assumptions=heat_capacity_notes,
        conductivity_assumptions=conductivity_notes,
    )


def lubricant_from_points(
    name: str,
    colder: Point,
    warmer: Point,
    properties: OilProperties | None = None,
    *,
    source: str = "given by the user",
    temperature_range: tuple[float, float] = OIL_TEMPERATURE_RANGE,
    law: type[Walther] | type[AstmD341] = Walther,
) -> Lubricant:
    """Build a lubricant from two kinematic viscosities, by Walther's law or the full law of ASTM D341.

    Parameters
    ----------
    name : str
        As it shall appear in reports.
    colder, warmer : tuple of float
        Temperature in K and kinematic viscosity in m²/s.
    properties, source
        As of `lubricant_from_law`.
    temperature_range : tuple of float
        Where the numbers hold, in K.
    law : type
        `Walther`, or `AstmD341` for thin oils below 2 mm²/s.

    Raises
    ------
    InputError
        E003 for numbers that are not usable, E006 when the viscosity does not fall with temperature.

    Examples
    --------
    >>> oil = lubricant_from_points("my oil", (313.15, 46e-6), (373.15, 6.8e-6), OilProperties(density=875.0))
    >>> round(oil.dynamic_viscosity(323.15) * 1e3, 2)
    25.57
    """
    through = law.through(colder, warmer, temperature_range=temperature_range)
    return lubricant_from_law(name, through, properties, source=source)


def lubricant_from_viscosity_index(
    name: str,
    nu40: float,
    viscosity_index: float,
    properties: OilProperties | None = None,
    *,
    source: str = "given by the user",
    temperature_range: tuple[float, float] = OIL_TEMPERATURE_RANGE,
) -> Lubricant:
    """Build a lubricant from its viscosity at 40 °C (m²/s) and its viscosity index, by ISO 2909 and Walther.

    Parameters, errors and result as of `lubricant_from_points`.
    """
    nu100 = nu100_from_viscosity_index(viscosity_index, nu40)
    points = (_AT_40, nu40), (_AT_100, nu100)
    found = lubricant_from_points(name, *points, properties, source=source, temperature_range=temperature_range)
    return replace(found, viscosity_index=viscosity_index)


def _law_of(
    typical: str, value: float | None, temperature: float, slope: float | None
) -> tuple[PropertyLaw, tuple[str, ...]]:
    """The law that meets the known value, and what was assumed for it."""
    law, texts = shared_law(typical)
    if value is None:
        return law, (texts["assumption"],)
    if slope is None:
        return ShiftedLaw.through(law, temperature, value), (texts["slope_assumption"],)
    return LinearProperty(value, temperature, slope), ()
