"""From a case, as the engineer wrote it, to design cases: numbers in SI, all choices made."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from babbitt.cases.assumptions import assumptions_of
from babbitt.cases.cooling import Cooling
from babbitt.cases.journal import JournalBearing
from babbitt.cases.machine import Case, JournalCase, Machine
from babbitt.cases.materials import Materials
from babbitt.cases.operating_point import LOADS, SPEEDS, OperatingPoint
from babbitt.cases.overhung_coupling import OverhungCouplingCase
from babbitt.cases.shared import merged
from babbitt.cases.supply import Supply
from babbitt.cases.supply_element import UnevenPockets
from babbitt.design.cooling import STILL_AIR_COEFFICIENT, heat_transfer_coefficient
from babbitt.lubricants import Lubricant
from babbitt.materials import LoadCharacter, bearing_metal
from babbitt.notices import Notice
from babbitt.standards.iso7902.model import (
    Bearing,
    Curves,
    DesignCase,
    Friction,
    GivenEccentricity,
    GivenLoad,
    HousingCooling,
    OilSupply,
)


def design_cases(case: Case) -> tuple[DesignCase, ...]:
    """Expand a case into one design case per bearing, operating point and clearance.

    Parameters
    ----------
    case : JournalCase, Machine or OverhungCouplingCase

    Returns
    -------
    tuple of DesignCase
        In the order of the file; empty for the statics of a shaft. Names are ``Bearing``, ``Bearing [point]``,
        ``Bearing (minimum clearance)``, ``Bearing [point] (minimum clearance)``.
    """
    match case:
        case OverhungCouplingCase():
            return ()
        case Machine():
            bearings: tuple[JournalBearing, ...] = case.bearings
        case JournalCase():
            bearings = (case,)
    return tuple(design_case for bearing in bearings for design_case in _expanded(bearing, case))


def case_hash(case: Case) -> str:
    """SHA-256 of a case in canonical JSON: the same for files that differ only in layout, units and defaults.

    Parameters
    ----------
    case : JournalCase, Machine or OverhungCouplingCase

    Returns
    -------
    str
        64 hexadecimal digits.
    """
    content = case.model_dump(mode="json", exclude_defaults=True)
    canonical = json.dumps(content, sort_keys=True, separators=(",", ":"), ensure_ascii=True, allow_nan=False)
    return hashlib.sha256(canonical.encode("ascii")).hexdigest()


@dataclass(frozen=True)
class _Inputs:
    """A bearing with what it shares with its machine."""

    bearing: JournalBearing
    lubricant: Lubricant
    supply: Supply | None
    cooling: Cooling | None
    materials: Materials
    width: float
    shared_assumptions: tuple[str, ...]


def _expanded(bearing: JournalBearing, shared: JournalCase | Machine) -> Iterator[DesignCase]:
    inputs = _inputs(bearing, shared)
    relative = bearing.clearance.at_20_degrees(bearing.diameter).relative(bearing.diameter)
    tolerance = (relative.minimum, relative.maximum) if relative.minimum < relative.maximum else None
    clearances = {"": relative.mean}
    if (bearing.clearance_cases or shared.clearance_cases) == "all":
        named = {"minimum": relative.minimum, "mean": relative.mean, "maximum": relative.maximum}
        clearances = {f" ({name} clearance)": value for name, value in named.items()}
    for point in bearing.operating_points or (None,):
        for suffix, clearance in clearances.items():
            design = _design_case(inputs, point, suffix, clearance)
            yield replace(design, bearing=replace(design.bearing, clearance_tolerance=tolerance))


def _inputs(bearing: JournalBearing, shared: JournalCase | Machine) -> _Inputs:
    lubricant = bearing.lubricant or shared.lubricant
    width = bearing.actual_width
    if lubricant is None or width is None:
        raise ValueError("a case that was not validated: the bearing has no lubricant or no width")
    return _Inputs(
        bearing,
        lubricant.lubricant(),
        merged(bearing.supply, shared.supply),
        merged(bearing.cooling, shared.cooling),
        merged(bearing.materials, shared.materials) or Materials(),
        width,
        shared.assumptions if isinstance(shared, Machine) else (),
    )


def _design_case(inputs: _Inputs, point: OperatingPoint | None, suffix: str, clearance: float) -> DesignCase:
    bearing = inputs.bearing
    name = bearing.name if point is None else f"{bearing.name} [{point.name}]"
    return DesignCase(
        name=name + suffix,
        bearing=_bearing(inputs, point, clearance),
        duty=_duty(inputs, point),
        journal_speed=_journal_speed(bearing, point),
        lubricant=inputs.lubricant,
        oil_supply=_oil_supply(inputs.supply, point),
        cooling=_housing_cooling(inputs),
        bearing_speed=bearing.bearing_speed,
        friction=Friction(bearing.friction.model),
        friction_factor=bearing.friction.factor,
        curves=Curves(bearing.characteristics),
        limits=bearing.limits.limits(),
        assumptions=(
            *inputs.shared_assumptions,
            *bearing.assumptions,
            *assumptions_of(bearing, point, inputs.supply, inputs.cooling, inputs.materials),
        ),
        doubts=tuple(_doubts_about_span(bearing, point)),
        kind=bearing.kind,
    )


def _doubts_about_span(bearing: JournalBearing, point: OperatingPoint | None) -> Iterator[Notice]:
    """Warn where a conventional span stands for the arc between uneven pockets."""
    element = bearing.element_at(point)
    if not isinstance(element, UnevenPockets):
        return
    conventional, span = element.conventional_span(), bearing.span_at(point)
    exact = math.degrees(conventional.exact)
    yield Notice("W104", f"the arc between uneven pockets, {exact:.0f}° if centred, was taken as {span}°")
    if conventional.too_short:
        yield Notice(
            "W105", f"the pockets leave {exact:.0f}° of centred arc; the characteristics hold for {span}°"
        )


def _bearing(inputs: _Inputs, point: OperatingPoint | None, clearance: float) -> Bearing:
    bearing, materials = inputs.bearing, inputs.materials
    span, element = bearing.span_at(point), bearing.element_at(point)
    if span is None or materials.bearing is None or materials.journal is None:
        raise ValueError("a case that was not validated: the bearing has no span or no materials")
    return Bearing(
        diameter=bearing.diameter,
        width=inputs.width,
        relative_clearance=clearance,
        span=span,
        expansion_bearing=materials.bearing.expansion(),
        expansion_journal=materials.journal.expansion(),
        supply_element=element.element() if element is not None else None,
        surfaces=bearing.surfaces.surfaces() if bearing.surfaces is not None else None,
        metal=bearing_metal(materials.bearing_metal) if materials.bearing_metal is not None else None,
        load_character=LoadCharacter(materials.load_character or LoadCharacter.CALM),
    )


def _duty(inputs: _Inputs, point: OperatingPoint | None) -> GivenLoad | GivenEccentricity:
    bearing = inputs.bearing
    given = point if point is not None and any(getattr(point, name) is not None for name in LOADS) else bearing
    if given.eccentricity_ratio is not None:
        return GivenEccentricity(given.eccentricity_ratio)
    if given.load is not None:
        return GivenLoad(given.load)
    if given.specific_load is None:
        raise ValueError("a case that was not validated: the bearing has no load")
    return GivenLoad(given.specific_load * inputs.width * bearing.diameter)


def _journal_speed(bearing: JournalBearing, point: OperatingPoint | None) -> float:
    given = point if point is not None and any(getattr(point, name) is not None for name in SPEEDS) else bearing
    if given.speed is not None:
        return given.speed
    if given.surface_speed is None:
        raise ValueError("a case that was not validated: the bearing has no speed")
    return 2.0 * given.surface_speed / bearing.diameter


def _oil_supply(supply: Supply | None, point: OperatingPoint | None) -> OilSupply | None:
    if supply is None:
        return None
    temperature, pressure = supply.temperature, supply.pressure
    if point is not None:
        temperature = point.supply_temperature or temperature
        pressure = point.supply_pressure or pressure
    if temperature is None or pressure is None:
        raise ValueError("a case that was not validated: the supply has no temperature or no pressure")
    return OilSupply(
        temperature,
        pressure,
        tuple(tube.duct() for tube in supply.tubes),
        tuple(hole.duct() for hole in supply.holes),
        supply.circulation_time,
    )


def _housing_cooling(inputs: _Inputs) -> HousingCooling | None:
    cooling = inputs.cooling
    if cooling is None:
        return None
    coefficient, surface = cooling.heat_transfer_coefficient, cooling.surface
    if coefficient is None:
        still = cooling.air_speed is None
        coefficient = STILL_AIR_COEFFICIENT if still else heat_transfer_coefficient(cooling.air_speed or 0.0)
    if surface is None and cooling.housing is not None:
        surface = cooling.housing.surface(inputs.bearing.diameter, inputs.width)
    if surface is None or cooling.ambient_temperature is None:
        raise ValueError("a case that was not validated: the cooling has no surface or no ambient temperature")
    return HousingCooling(cooling.ambient_temperature, coefficient, surface)
