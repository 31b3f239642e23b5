"""From a bearing, as the engineer wrote it, to the design case of ISO 7902."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.cases.assumptions import assumptions_of
from babbitt.cases.joined_inputs import Inputs, duty, housing_cooling, journal_speed, oil_supply
from babbitt.cases.journal import JournalBearing
from babbitt.cases.operating_point import OperatingPoint
from babbitt.cases.supply_element import UnevenPockets
from babbitt.materials import LoadCharacter, bearing_metal
from babbitt.notices import Notice
from babbitt.standards.iso7902.model import Bearing, Curves, DesignCase, Friction


def iso7902_case(
    inputs: Inputs,
    point: OperatingPoint | None,
    suffix: str,
    clearance: float,
    tolerance: tuple[float, float] | None,
) -> DesignCase:
    """Design case of ISO 7902 of one bearing at one operating point and clearance (relative, at 20 °C)."""
    bearing = inputs.bearing
    name = bearing.name if point is None else f"{bearing.name} [{point.name}]"
    return DesignCase(
        name=name + suffix,
        bearing=_iso_bearing(inputs, point, clearance, tolerance),
        duty=duty(inputs, point),
        journal_speed=journal_speed(bearing, point),
        lubricant=inputs.lubricant,
        oil_supply=oil_supply(inputs.supply, point),
        cooling=housing_cooling(inputs),
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
        effective_temperature=bearing.effective_temperature,
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


def _iso_bearing(
    inputs: Inputs, point: OperatingPoint | None, clearance: float, tolerance: tuple[float, float] | None
) -> Bearing:
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
        clearance_tolerance=tolerance,
    )
