"""From a bearing, as the engineer wrote it, to the cases of the long film and of the heat balance by segments."""

from __future__ import annotations

from typing import Any

from babbitt.design.conditions import OilSupply, PrescribedEccentricity, PrescribedLoad, PrescribedPosition
from babbitt.kinds.journal.case.as_given import words_of
from babbitt.kinds.journal.case.assumptions import common_assumptions_of
from babbitt.kinds.journal.case.joined_inputs import Inputs, Point, duty, journal_speed
from babbitt.kinds.journal.case.one_dimension import METHODS
from babbitt.kinds.journal.case.warnings import warnings_about_numbers
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import (
    Discretisation,
    ExchangeZone,
    LongFilmCase,
)
from babbitt.kinds.journal.one_dimension import LongBearing
from babbitt.properties.materials import LoadCharacter

SECTORS = {"draft": 90, "engineering": 180, "reference": 360}
"""Sectors of the long film by the `accuracy` of a case."""

INTERVALS = {"draft": 720, "engineering": 1000, "reference": 2000}
"""Intervals of the segments by the `accuracy` of a case."""


def long_film_case(inputs: Inputs, at: Point) -> LongFilmCase:
    """Long film of one bearing at one operating point and clearance."""
    bearing, given = inputs.bearing, inputs.bearing.heat_exchange
    zone = given.exchange_zone
    return LongFilmCase(
        bearing=LongBearing(**_sizes(inputs, at)),
        duty=_duty(inputs, at),
        exchange=given.exchange(),
        discretisation=Discretisation(given.discretisation),
        exchange_zone=None if zone is None else ExchangeZone(zone),
        cells=SECTORS[bearing.accuracy],
        supply_angle=given.supply_angle,
        **_shared(inputs, at),
    )


def segment_case(inputs: Inputs, at: Point) -> SegmentCase:
    """Film by segments of one bearing at one operating point and clearance."""
    bearing, given = inputs.bearing, inputs.bearing.segments
    rough = given.roughness
    return SegmentCase(
        bearing=LongBearing(
            **_sizes(inputs, at), roughness=None if rough is None else (rough.bearing, rough.journal)
        ),
        duty=None if given.profile else _duty(inputs, at),
        groove=None if given.groove is None else given.groove.groove(),
        start=given.film_start,
        compliance=given.compliance,
        profile=given.points(),
        cells=INTERVALS[bearing.accuracy],
        **_shared(inputs, at),
    )


def _duty(inputs: Inputs, at: Point) -> PrescribedLoad | PrescribedEccentricity:
    found = duty(inputs, at.given)
    assert not isinstance(found, PrescribedPosition)  # refused with the case
    return found


def _sizes(inputs: Inputs, at: Point) -> dict[str, Any]:
    bearing, materials = inputs.bearing, inputs.materials
    return {
        "diameter": bearing.diameter,
        "width": inputs.width,
        "relative_clearance": at.clearance,
        "surfaces": bearing.surfaces.surfaces() if bearing.surfaces is not None else None,
        "metal": materials.metal(),
        "load_character": LoadCharacter(materials.load_character or LoadCharacter.CALM),
        "clearance_tolerance": at.tolerance,
        "mean_clearance": at.mean,
    }


def _shared(inputs: Inputs, at: Point) -> dict[str, Any]:
    bearing, point = inputs.bearing, at.given
    return {
        "name": at.name,
        "journal_speed": journal_speed(bearing, point),
        "lubricant": inputs.lubricant,
        "oil_supply": _supply(inputs, at),
        "load_angle": bearing.load_angle,
        "limits": bearing.limits.limits(),
        "given": words_of(bearing, point, at.clearance_case, None, inputs.materials),
        "assumptions": (
            *inputs.shared_assumptions,
            *bearing.assumptions,
            *common_assumptions_of(bearing, None, None, inputs.materials),
            *_ignored(inputs, at),
        ),
        "warnings": warnings_about_numbers(inputs, point),
        "kind": bearing.kind,
    }


def _supply(inputs: Inputs, at: Point) -> OilSupply:
    """Oil at the inlet of the film; its pressure drives nothing."""
    supply, point = inputs.supply, at.given
    temperature = point.supply_temperature if point is not None else None
    if supply is not None:
        temperature = temperature or supply.temperature
    if supply is None or temperature is None:
        raise ValueError("a case that was not validated: the supply has no temperature")
    return OilSupply(temperature, supply.pressure or 0.0, circulation_time=supply.circulation_time)


def _ignored(inputs: Inputs, at: Point) -> tuple[str, ...]:
    bearing, found = inputs.bearing, []
    method = METHODS[bearing.method].capitalize()
    supplies = (inputs.supply.pressure, inputs.supply.flow) if inputs.supply is not None else ()
    own = (at.given.supply_pressure, at.given.supply_flow) if at.given is not None else ()
    if bearing.element_at(at.given) is not None or any((*supplies, *own)):
        found.append(f"{method} takes oil of the supply temperature; pressure, flow and element are ignored.")
    if inputs.cooling is not None:
        found.append(f"{method} ignores `cooling`; heat leaves as the method itself describes.")
    if inputs.supply is not None and inputs.supply.circulation_time is None:
        found.append("The circulation time of the oil is not known: the lower limit of temperature holds.")
    return tuple(found)
