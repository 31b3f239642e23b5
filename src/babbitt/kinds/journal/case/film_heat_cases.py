"""From what a case says of heat to the heat model of its film, and what is assumed where it is silent."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from babbitt.core.units import written
from babbitt.design.cooling import STILL_AIR_COEFFICIENT
from babbitt.kinds.journal.case.film_heat import (
    BUSH_OVER_BORE,
    CONTACT_THICKNESS,
    HOUSING_OVER_BUSH,
    OWN_TEMPERATURES,
    WallsInput,
    may_have_own_temperatures,
)
from babbitt.kinds.journal.case.joined_inputs import Inputs, housing_cooling, oil_supply
from babbitt.kinds.journal.case.operating_point import OperatingPoint
from babbitt.kinds.journal.film.heat_model import AxialTemperature, HeatModel, TemperatureCoefficients
from babbitt.properties.materials import structural_material
from babbitt.reynolds.heat.heat_model import BushRing, ConductingWalls, JournalHeat
from babbitt.reynolds.heat.thermal_growth import RingGrowth

__all__ = ["fuller_heat_model", "heat_assumptions", "heat_model"]

STEEL_CONDUCTIVITY = 45.0
"""W/(m K), where the material of the bearing is given by its expansion only: an assumption."""
ROOM = 293.15
"""Temperature of the surroundings in K where none is given: an assumption."""


@dataclass(frozen=True)
class _Outside:
    """Heat transfer coefficient in W/(m2 K), surroundings in K, and what was assumed."""

    coefficient: float
    ambient: float
    assumed: tuple[str, ...]


def heat_model(inputs: Inputs, thermal: str | None = None) -> HeatModel | None:
    """Heat model of a bearing; None where its film has one temperature.

    Parameters
    ----------
    inputs : Inputs
    thermal : str, optional
        ``adiabatic`` or ``full`` in place of what the case says.
    """
    bearing = inputs.bearing
    chosen = thermal or bearing.thermal
    if chosen not in OWN_TEMPERATURES:
        return None
    walls = _walls(inputs) if chosen == "full" else None
    return HeatModel(
        walls,
        AxialTemperature(bearing.axial_temperature),
        TemperatureCoefficients(bearing.temperature_coefficients),
        bearing.carry_over,
        _growth(inputs, walls),
    )


def fuller_heat_model(
    inputs: Inputs, point: OperatingPoint | None, thermal: str | None = None
) -> HeatModel | None:
    """Walls that conduct, for a film of one temperature; None where that is given, or such a film not known.

    Parameters
    ----------
    inputs : Inputs
    point : OperatingPoint or None
    thermal : str, optional
        As of `heat_model`.
    """
    bearing, supply = inputs.bearing, oil_supply(inputs, point)
    given = bearing.effective_temperature is not None and thermal is None
    own = (thermal or bearing.thermal) in OWN_TEMPERATURES
    if given or own or supply is None or supply.flow is not None or not may_have_own_temperatures(bearing):
        return None
    return heat_model(inputs, "full")


def heat_assumptions(inputs: Inputs, thermal: str | None = None) -> tuple[str, ...]:
    """What was taken in place of what the case does not say of its walls."""
    return tuple(_assumed(inputs)) if (thermal or inputs.bearing.thermal) == "full" else ()


def _walls(inputs: Inputs) -> ConductingWalls:
    """Rings from the bore outwards: liner, bush, contact, housing."""
    bearing, given = inputs.bearing, inputs.bearing.walls or WallsInput()
    bush, housing, journal = given.bush, given.housing, given.journal
    radii, conductivities = [0.5 * bearing.diameter], []
    if bush.liner is not None:
        radii.append(radii[0] + bush.liner.thickness)
        conductivities.append(bush.liner.conductivity)
    conductivity = bush.conductivity or _conductivity(inputs)
    outside = _outside(inputs)
    bush_radius, housing_radius = _radii(inputs)
    radii.append(bush_radius)
    conductivities.append(conductivity)
    if housing.contact_coefficient is not None:
        radii.append(bush_radius + CONTACT_THICKNESS)
        conductivities.append(housing.contact_coefficient * CONTACT_THICKNESS)
    radii.append(housing_radius)
    conductivities.append(housing.conductivity or conductivity)
    ring = BushRing(tuple(radii), tuple(conductivities), outside.coefficient, outside.ambient)
    around = journal.ambient_temperature if journal.ambient_temperature is not None else outside.ambient
    return ConductingWalls(ring, JournalHeat(journal.temperature, journal.shaft_conductance, around))


def _growth(inputs: Inputs, walls: ConductingWalls | None) -> RingGrowth | None:
    """The bush behind its liner, where its heat is to distort the bore."""
    given, material = inputs.bearing.walls, inputs.materials.bearing
    if walls is None or given is None or not given.thermal_distortion:
        return None
    if material is None:
        raise ValueError("a case that was not validated: the bearing has no material")
    return RingGrowth(walls.bush, 0 if given.bush.liner is None else 1, material.expansion())


def _radii(inputs: Inputs) -> tuple[float, float]:
    """Outside radius of bush and housing, m."""
    given = inputs.bearing.walls or WallsInput()
    bush = given.bush.outer_diameter or BUSH_OVER_BORE * inputs.bearing.diameter
    return 0.5 * bush, 0.5 * (given.housing.outer_diameter or HOUSING_OVER_BUSH * bush)


def _conductivity(inputs: Inputs) -> float:
    """Of the material of the bearing, W/(m K)."""
    material = inputs.materials.bearing
    if material is None or material.name is None:
        return STEEL_CONDUCTIVITY
    return structural_material(material.name).thermal_conductivity


def _outside(inputs: Inputs) -> _Outside:
    """The outside of the housing: its own, else that of the cooling spread over it, else still air."""
    given = (inputs.bearing.walls or WallsInput()).housing
    cooling, assumed = housing_cooling(inputs), []
    ambient, coefficient = given.ambient_temperature, given.heat_transfer_coefficient
    if ambient is None:
        ambient = cooling.ambient_temperature if cooling is not None else ROOM
        if cooling is None:
            assumed.append(f"Air around the housing of {written(ROOM, 'degC')}.")
    if coefficient is None and cooling is not None:
        surface = math.tau * _radii(inputs)[1] * inputs.width
        coefficient = cooling.heat_transfer_coefficient * cooling.surface / surface
        assumed.append(
            f"Cooling of {written(cooling.heat_transfer_coefficient * cooling.surface, 'W/K')} spread over the "
            "outside of the housing ring."
        )
    elif coefficient is None:
        coefficient = STILL_AIR_COEFFICIENT
        assumed.append(f"Heat transfer coefficient of a housing in still air, {STILL_AIR_COEFFICIENT:g} W/(m2 K).")
    return _Outside(coefficient, ambient, tuple(assumed))


def _assumed(inputs: Inputs) -> Iterator[str]:
    given = inputs.bearing.walls or WallsInput()
    bush, housing = _radii(inputs)
    if given.bush.outer_diameter is None:
        yield f"Outside diameter of the bush {written(2.0 * bush, 'mm')}, {BUSH_OVER_BORE:g} times the bore."
    if given.housing.outer_diameter is None:
        yield (
            f"Outside diameter of the housing {written(2.0 * housing, 'mm')}, {HOUSING_OVER_BUSH:g} times that of "
            "the bush."
        )
    if given.bush.conductivity is None:
        material = inputs.materials.bearing
        named = material is not None and material.name is not None
        of = (
            f"of {structural_material(material.name or '').name}" if material is not None and named else "of steel"
        )
        yield f"Thermal conductivity of the bush {written(_conductivity(inputs), 'W/(m K)')}, that {of}."
    if given.bush.liner is None:
        yield "The bearing metal conducts heat as the bush does."
    if given.housing.conductivity is None:
        yield "The housing conducts heat as the bush does."
    if given.housing.contact_coefficient is None:
        yield "Perfect thermal contact between bush and housing."
    yield from _outside(inputs).assumed
    if given.journal.temperature is None and given.journal.shaft_conductance == 0.0:
        yield "No heat leaves the journal along the shaft."
