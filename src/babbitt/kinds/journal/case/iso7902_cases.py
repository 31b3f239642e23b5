"""From a bearing, as the engineer wrote it, to the design case of ISO 7902."""

from __future__ import annotations

import math
from dataclasses import replace

from babbitt.case.part import is_given
from babbitt.design.conditions import PrescribedEccentricity, PrescribedLoad, PrescribedPosition, Surfaces
from babbitt.kinds.journal.case.as_given import words_of
from babbitt.kinds.journal.case.assumptions import assumptions_of
from babbitt.kinds.journal.case.free_arc import free_arcs
from babbitt.kinds.journal.case.joined_inputs import (
    Inputs,
    Point,
    clearance_limits,
    duty,
    expansions,
    housing_cooling,
    journal_speed,
    oil_supply,
)
from babbitt.kinds.journal.case.operating_point import OperatingPoint
from babbitt.kinds.journal.case.warnings import warnings_about
from babbitt.kinds.journal.iso7902.model import Bearing, Curves, DesignCase, Friction
from babbitt.properties.materials import LoadCharacter


def iso7902_case(inputs: Inputs, at: Point) -> DesignCase:
    """Design case of ISO 7902 of one bearing at one operating point and clearance (relative, at 20 °C)."""
    bearing, point = inputs.bearing, at.given
    return DesignCase(
        name=at.name,
        bearing=_iso_bearing(inputs, at),
        duty=_duty(inputs, point),
        journal_speed=journal_speed(bearing, point),
        lubricant=inputs.lubricant,
        oil_supply=oil_supply(inputs, point),
        cooling=housing_cooling(inputs),
        bearing_speed=bearing.bearing_speed,
        friction=Friction(bearing.friction.model),
        friction_factor=bearing.friction.factor,
        curves=Curves(bearing.characteristics),
        limits=bearing.limits.limits(),
        given=words_of(bearing, point, at.clearance_case, inputs.cooling, inputs.materials),
        assumptions=(
            *inputs.shared_assumptions,
            *bearing.assumptions,
            *assumptions_of(bearing, point, inputs.supply, inputs.cooling, inputs.materials),
        ),
        warnings=warnings_about(inputs, point),
        kind=bearing.kind,
        effective_temperature=bearing.effective_temperature,
        free_arcs=free_arcs(bearing, point),
        rotor_mass=bearing.rotor_mass,
        clearance_limits=clearance_limits(inputs, at),
        load_angle=bearing.load_angle if is_given(bearing, "load_angle") else None,
    )


def _duty(inputs: Inputs, point: OperatingPoint | None) -> PrescribedLoad | PrescribedEccentricity:
    given = duty(inputs, point)
    if isinstance(given, PrescribedPosition):
        raise ValueError("a case that was not validated: the standard takes no position")
    return given


def _iso_bearing(inputs: Inputs, at: Point) -> Bearing:
    bearing, materials, point = inputs.bearing, inputs.materials, at.given
    span, element = bearing.span_at(point), bearing.element_at(point)
    if span is None:
        raise ValueError("a case that was not validated: the bearing has no span")
    of_bearing, of_journal = expansions(inputs)
    return Bearing(
        diameter=bearing.diameter,
        width=inputs.width,
        relative_clearance=at.clearance,
        span=span,
        expansion_bearing=of_bearing,
        expansion_journal=of_journal,
        supply_element=element.element(bearing.diameter, span) if element is not None else None,
        surfaces=_surfaces(inputs),
        metal=materials.metal(),
        load_character=LoadCharacter(materials.load_character or LoadCharacter.CALM),
        clearance_tolerance=at.tolerance,
        mean_clearance=at.mean,
        axis_slope=math.hypot(*bearing.slope_of_shaft),
    )


def _surfaces(inputs: Inputs) -> Surfaces | None:
    """Surfaces of the case, with the offset of a sloping shaft over the width."""
    bearing = inputs.bearing
    if bearing.surfaces is None:
        return None
    given = bearing.surfaces.surfaces()
    offset = math.hypot(*bearing.slope_of_shaft) * inputs.width
    return replace(given, tilt_offset=given.tilt_offset + offset)
