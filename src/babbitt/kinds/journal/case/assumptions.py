"""What a case leaves open and what is taken in its place, in plain words for the report."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.case.parts.cooling import Cooling, InMachine
from babbitt.case.parts.materials import Materials
from babbitt.case.parts.supply import Supply
from babbitt.case.parts.surfaces import DrawingSurfaces
from babbitt.core.units import written
from babbitt.design.cooling import MOVING_AIR_FROM, STILL_AIR_COEFFICIENT
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.one_dimension import METHODS
from babbitt.kinds.journal.case.operating_point import OperatingPoint
from babbitt.kinds.journal.case.supply_element import HoleElement, SlotElement, UnevenPockets
from babbitt.kinds.journal.iso7902.supply import equivalent_holes


def assumptions_of(
    bearing: JournalBearing,
    point: OperatingPoint | None,
    supply: Supply | None,
    cooling: Cooling | None,
    materials: Materials,
) -> tuple[str, ...]:
    """Give every assumption that stands behind one bearing at one operating point.

    Parameters
    ----------
    bearing : JournalBearing
    point : OperatingPoint or None
    supply, cooling, materials
        Of the bearing, with what it shares with its machine.
    """
    return (
        *_of_span(bearing, point),
        *_of_supply_element(bearing, point, supply),
        *common_assumptions_of(bearing, supply, cooling, materials),
        *_of_friction_model(bearing),
    )


def common_assumptions_of(
    bearing: JournalBearing, supply: Supply | None, cooling: Cooling | None, materials: Materials
) -> tuple[str, ...]:
    """Give the assumptions that stand behind a bearing by any method."""
    return (
        *_of_supply(supply),
        *_of_cooling(cooling),
        *_of_surfaces(bearing),
        *_of_materials(materials),
        *_of_expansion(bearing, materials),
        *_of_friction_factor(bearing),
        *_of_limits(bearing),
    )


def _of_span(bearing: JournalBearing, point: OperatingPoint | None) -> Iterator[str]:
    element = bearing.element_at(point)
    if not isinstance(element, UnevenPockets):
        return
    span, conventional = bearing.span_at(point), element.conventional_span()
    exact = math.degrees(conventional.exact)
    if span != conventional.tabulated:
        yield f"The span of {span} deg was given; the arc between the pockets stands for {exact:.0f} deg."
        return
    side = (
        "entry side alone; the exit side ends behind the film" if conventional.exit_side_disregarded else "pockets"
    )
    yield f"The uneven arc is replaced by a centred one of {exact:.0f} deg ({side}), taken as {span} deg."
    if conventional.too_short:
        yield f"An arc of {exact:.0f} deg is shorter than any tabulated one: {span} deg flatters the bearing."
    yield "The unevenness of the pockets is ignored in the supply flow."


def _of_supply_element(
    bearing: JournalBearing, point: OperatingPoint | None, supply: Supply | None
) -> Iterator[str]:
    element = bearing.element_at(point)
    if supply is None:
        if isinstance(element, UnevenPockets):
            yield "No supply is given: the pockets set the span and are ignored otherwise."
        elif element is not None:
            yield "No supply is given: the supply element is ignored."
        return
    if element is None:
        yield "No supply element is given: the supply pressure drives no flow of its own through the film."
    if isinstance(element, HoleElement) and element.number > 1:
        yield f"The {element.number} holes at each place are taken as not interacting."
    if isinstance(element, SlotElement):
        diameter, number = equivalent_holes(element.length, element.width)
        yield f"A slot is computed as {number:.3f} holes of {written(diameter, 'mm')}, same perimeter and area."


def _of_supply(supply: Supply | None) -> Iterator[str]:
    if supply is None:
        return
    if not supply.tubes and not supply.holes:
        yield "No losses on the way: the supply pressure is that at the supply element."
    if supply.circulation_time is None:
        yield "The circulation time of the oil is not known: the lower temperature limit, for up to 5 min, holds."


def _of_cooling(cooling: Cooling | None) -> Iterator[str]:
    if cooling is None:
        return
    if cooling.heat_transfer_coefficient is None:
        if cooling.air_speed is None or cooling.air_speed <= MOVING_AIR_FROM:
            yield f"Heat transfer coefficient of a housing in still air, {STILL_AIR_COEFFICIENT:g} W/(m2 K)."
        else:
            yield "Heat transfer coefficient 7 + 12 sqrt(w) of a housing in moving air, w in m/s."
    if isinstance(cooling.housing, InMachine):
        yield f"The bearing gives heat through {cooling.housing.factor:g} times B D."


def _of_surfaces(bearing: JournalBearing) -> Iterator[str]:
    surfaces = bearing.surfaces
    if surfaces is None:
        return
    if isinstance(surfaces, DrawingSurfaces):
        yield "Tilt is the sum of the profile tolerances, waviness the mean of the roundness tolerances."
    waviness = surfaces.surfaces().waviness
    if waviness > 0.0 and "wave_factor" not in surfaces.model_fields_set:
        yield "Effective waviness is the waviness itself (factor 1), as its functions are not public."


def _of_materials(materials: Materials) -> Iterator[str]:
    if materials.bearing_metal is None:
        yield "No bearing metal is given: its limits of load and speed are not checked."
    elif materials.load_character is None:
        yield "The load is taken as calm."


def _of_expansion(bearing: JournalBearing, materials: Materials) -> Iterator[str]:
    if bearing.method in METHODS or materials.bearing is not None or materials.journal is not None:
        return
    yield "No materials of shell and journal are given: the clearance at 20 degC holds at that of the film."


def _of_friction_factor(bearing: JournalBearing) -> Iterator[str]:
    if bearing.friction.factor != 1.0:
        yield f"The friction coefficient is multiplied by {bearing.friction.factor:g}."


def _of_limits(bearing: JournalBearing) -> Iterator[str]:
    if (own := bearing.limits.own_tables()) is not None:
        yield f"Limits by experience are those of the case: {own.source}."


def _of_friction_model(bearing: JournalBearing) -> Iterator[str]:
    if bearing.friction.model == "curve360":
        yield "The friction number is that of the full bearing at the same eccentricity."
