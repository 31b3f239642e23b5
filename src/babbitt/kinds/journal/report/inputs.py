"""What a journal bearing was computed from, as rows that an engineer can check against the drawing."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.design.conditions import PrescribedPosition
from babbitt.design.ducts import Duct
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902.model import Curves, DesignCase, Friction, PrescribedEccentricity
from babbitt.kinds.journal.iso7902.supply import (
    Arrangement,
    CircumferentialGroove,
    HalfCircumferentialGroove,
    Holes,
    Pockets,
    SupplyElement,
)
from babbitt.kinds.journal.problems import JournalDesign
from babbitt.kinds.journal.report.film_inputs import (
    CAVITATION,
    describe_bore,
    describe_bush,
    describe_changing_load,
    describe_feed,
    describe_flow,
    describe_heat,
    describe_journal,
    describe_pressure,
    describe_start,
    describe_step,
)
from babbitt.kinds.journal.report.one_dimension import describe
from babbitt.report.inputs import InputGroup, Row, metal_rows, named_row, oil_rows, surface_rows

__all__ = ["journal_inputs"]

FRICTION = {
    Friction.FULL: "film around the whole circumference",
    Friction.ARC: "film on the loaded arc only",
    Friction.CURVE360: "friction number of the full bearing at the same eccentricity",
}


PLACES = {
    Arrangement.OPPOSITE: "opposite the load",
    Arrangement.SIDE: "at 90° to the load",
    Arrangement.BOTH_SIDES: "on both sides, ±90° to the load",
}


def journal_inputs(case: JournalDesign) -> Iterator[InputGroup]:
    """Inputs of a journal bearing, by its method."""
    match case:
        case LongFilmCase() | SegmentCase():
            geometry, method = _one_dimension_geometry(case), _one_dimension_method(case)
        case FilmCase():
            geometry, method = _film_geometry(case), _film_method(case)
        case _:
            geometry, method = _geometry(case), _method(case)
    yield InputGroup("Geometry", tuple(geometry))
    yield InputGroup("Operation", tuple(_operation(case)))
    yield InputGroup("Lubricant", tuple(oil_rows(case.lubricant)))
    yield InputGroup("Oil supply", tuple(_supply(case)))
    yield InputGroup("Cooling by the surroundings", tuple(_cooling(case)))
    yield InputGroup("Surfaces", tuple(surface_rows(case.bearing.surfaces)))
    yield InputGroup("Material", tuple(_material(case)))
    yield InputGroup("Method", (*method, *_limits(case)))


def _geometry(case: DesignCase) -> Iterator[Row]:
    bearing = case.bearing
    yield named_row("diameter", bearing.diameter)
    yield named_row("width", bearing.width)
    yield named_row("width_ratio", bearing.width_ratio)
    yield named_row("relative_clearance", bearing.relative_clearance)
    yield named_row("angular_span", math.radians(bearing.span))
    yield named_row("expansion_bearing", bearing.expansion_bearing)
    yield named_row("expansion_journal", bearing.expansion_journal)
    if bearing.supply_element is not None:
        yield from _element(bearing.supply_element)


def _holes(number: float) -> str:
    """How many round holes; a slot is as many equivalent ones as come out, which is no whole number."""
    if number == 1.0:
        return "Hole"
    return f"{number:.0f} holes" if number.is_integer() else f"{number:.4g} holes (a slot: equivalent holes)"


def _place_of_pockets(pockets: Pockets) -> str:
    """Where pockets stand; of two in places of their own, which of them counts for what."""
    if pockets.behind is None or pockets.edge is None:
        return f"Pocket {PLACES[pockets.arrangement]}"
    before, behind = (math.degrees(angle) for angle in (pockets.edge + 0.5 * pockets.extent, pockets.behind))
    return f"Pockets {before:.4g}° before and {behind:.4g}° behind the load"


def _element(element: SupplyElement) -> Iterator[Row]:
    match element:
        case Holes():
            yield Row("Supply element", f"{_holes(element.number)} {PLACES[element.arrangement]}")
            yield named_row("hole_diameter", element.diameter)
        case Pockets():
            yield Row("Supply element", _place_of_pockets(element))
            yield named_row("pocket_width", element.width)
        case CircumferentialGroove():
            yield Row("Supply element", "Groove around the circumference, between two half bearings")
            yield named_row("groove_width", element.width)
        case HalfCircumferentialGroove():
            yield Row("Supply element", "Groove around the unloaded half")
            yield named_row("groove_width", element.width)
        case _:
            yield Row("Supply element", type(element).__name__)


def _film_geometry(case: FilmCase) -> Iterator[Row]:
    bearing = case.bearing
    yield named_row("diameter", bearing.diameter)
    yield named_row("width", bearing.width)
    yield named_row("width_ratio", bearing.width_ratio)
    yield named_row("relative_clearance", bearing.relative_clearance)
    yield named_row("expansion_bearing", bearing.expansion_bearing)
    yield named_row("expansion_journal", bearing.expansion_journal)
    yield Row("Form of the bore", bearing.own_form or describe_bore(bearing.bore))
    for feed in bearing.feeds:
        yield Row(*describe_feed(feed))
    if bearing.misalignment != (0.0, 0.0):
        for name, slope in zip(("misalignment_x", "misalignment_y"), bearing.misalignment, strict=True):
            yield named_row(name, slope)
    for step in bearing.steps:
        yield Row("Step of the bore", describe_step(step))
    if bearing.crowning:
        ends = ", ".join(f"{1e6 * drop:.4g}" for drop in (bearing.crowning[0], bearing.crowning[-1]))
        yield Row("Crowning of the journal, drop at the sides", ends, None, "µm")
    if bearing.displacement:
        values = [value for row in bearing.displacement for value in row]
        gains = "Departure of the bore from the circle" if bearing.own_form else "Displacement of the gap"
        yield Row(gains, f"{1e6 * min(values):.4g} to {1e6 * max(values):.4g}", None, "µm")
    for one in bearing.compliance:
        yield Row("Elastic bore", one.premise)
    if bearing.side_pressures != (0.0, 0.0):
        sides = ", ".join(f"{1e-3 * pressure:.4g}" for pressure in bearing.side_pressures)
        yield Row("Pressures at the sides z = -B/2, B/2 (gauge)", sides, None, "kPa")


def _one_dimension_geometry(case: LongFilmCase | SegmentCase) -> Iterator[Row]:
    bearing = case.bearing
    yield named_row("diameter", bearing.diameter)
    yield named_row("width", bearing.width)
    yield named_row("width_ratio", bearing.width_ratio)
    yield named_row("relative_clearance", bearing.relative_clearance)


def _one_dimension_method(case: LongFilmCase | SegmentCase) -> Iterator[Row]:
    for what, words in describe(case):
        yield Row(what, words)


def _film_method(case: FilmCase) -> Iterator[Row]:
    if case.heat is None:
        yield Row("Film", "Reynolds equation in two dimensions, one viscosity")
    else:
        yield Row("Film", "generalised Reynolds equation in two dimensions and energy equation")
    yield Row("Flow", describe_flow(case.turbulence))
    yield Row("Viscosity under pressure", describe_pressure(case.pressure_viscosity))
    yield Row("Temperature", describe_heat(case.heat, case.effective_temperature))
    if case.heat is not None and case.heat.walls is not None:
        yield Row("Bush and housing", describe_bush(case.heat.walls))
        yield Row("Journal", describe_journal(case.heat.walls))
    if case.heat is not None and case.heat.growth is not None:
        yield Row("Distortion by heat", case.heat.growth.premise)
    yield Row("Where the film breaks up", CAVITATION[case.cavitation])
    yield Row("Where the film begins", describe_start(case.bearing))
    yield Row("Grid", case.accuracy.value)
    yield from _asperities(case)
    if case.cavitation_pressure:
        yield Row("Cavitation pressure (gauge)", f"{1e-3 * case.cavitation_pressure:.4g}", None, "kPa")
    if case.friction_factor != 1.0:
        yield named_row("friction_factor", case.friction_factor)


def _asperities(case: FilmCase) -> Iterator[Row]:
    one = case.asperities
    if one is not None:
        yield named_row("composite_roughness", one.roughness)
        yield named_row("contact_modulus", one.modulus)
        yield Row("Asperities: η_s β_s σ, σ/β_s", f"{one.density:g}, {one.sharpness:g}")
        yield Row("Coefficient of boundary friction", f"{one.friction:g}")


def _operation(case: JournalDesign) -> Iterator[Row]:
    if isinstance(case.duty, PrescribedEccentricity):
        yield named_row("eccentricity_ratio", case.duty.eccentricity_ratio, "Prescribed eccentricity e/c")
        if case.duty.attitude_angle is not None:
            yield named_row("attitude_angle", case.duty.attitude_angle, "Prescribed attitude angle")
    elif isinstance(case.duty, PrescribedPosition):
        yield Row("Prescribed position x, y", f"{1e6 * case.duty.x:.4g}, {1e6 * case.duty.y:.4g}", None, "µm")
    elif case.duty is not None:
        yield named_row("load", case.duty.load)
    yield named_row("angular_speed", case.journal_speed)
    if case.bearing_speed:
        yield Row("Rotational speed of the bearing", f"{case.bearing_speed * 30.0 / math.pi:.4g}", None, "rpm")
    if isinstance(case, FilmCase):
        yield Row("Sense of rotation (x right, y up)", case.rotation.value.replace("_", "-"))
    if case.load_angle is not None and not isinstance(case.duty, PrescribedPosition):
        yield Row("Direction of the load from +x", f"{math.degrees(case.load_angle):.4g}", None, "°")
    if isinstance(case, FilmCase):
        if case.rotor_mass is not None:
            yield named_row("rotor_mass", case.rotor_mass)
        if case.shaft_stiffness is not None:
            yield named_row("shaft_stiffness", case.shaft_stiffness)
        if case.changing_load is not None:
            yield Row("Changing load, added", describe_changing_load(case.changing_load))
        if case.moving_mass:
            yield Row("Mass that moves with the journal", f"{case.moving_mass:.4g}", None, "kg")
    if case.effective_temperature is not None:
        yield named_row("effective_temperature", case.effective_temperature, "Prescribed effective temperature")


def _supply(case: JournalDesign) -> Iterator[Row]:
    supply = case.oil_supply
    if supply is None:
        return
    yield named_row("supply_temperature", supply.temperature)
    if supply.flow is not None:
        yield named_row("given_flow", supply.flow)
    elif not isinstance(case, LongFilmCase | SegmentCase):  # their pressure drives nothing
        yield named_row("supply_pressure", supply.pressure)
    for kind, ducts in (("Tube", supply.tubes), ("Hole", supply.holes)):
        for duct in ducts:
            yield Row(f"{kind} on the way", _duct(duct))
    if supply.circulation_time is not None:
        yield Row("Oil volume over flow", f"{supply.circulation_time / 60.0:.4g}", None, "min")


def _duct(duct: Duct) -> str:
    said = f"d = {1e3 * duct.diameter:.4g} mm, l = {1e3 * duct.length:.4g} mm, ζ = {duct.loss_coefficient:.4g}"
    return said if duct.number == 1.0 else f"{duct.number:.4g} × ({said})"


def _cooling(case: JournalDesign) -> Iterator[Row]:
    if case.cooling is not None:
        yield named_row("ambient_temperature", case.cooling.ambient_temperature)
        yield named_row("heat_transfer_coefficient", case.cooling.heat_transfer_coefficient)
        yield named_row("cooling_surface", case.cooling.surface)


def _material(case: JournalDesign) -> Iterator[Row]:
    yield from metal_rows(case.bearing.metal)
    if case.bearing.metal is not None:
        yield Row("Character of the load", case.bearing.load_character.value)


def _method(case: DesignCase) -> Iterator[Row]:
    yield Row("Procedure", "ISO 7902-1 (steady state, laminar, isoviscous film)")
    computed = case.curves is Curves.COMPUTED
    yield Row(
        "Characteristics", "own solutions of the Reynolds equation" if computed else "closed forms, DIN 31652"
    )
    yield Row("Friction", FRICTION[case.friction])
    if case.friction_factor != 1.0:
        yield named_row("friction_factor", case.friction_factor)


def _limits(case: JournalDesign) -> Iterator[Row]:
    limits = case.limits
    for name, value, said in (
        ("minimum_film_thickness", limits.minimum_film_thickness, "Least film thickness set"),
        ("specific_load", limits.specific_load, "Largest specific load set"),
        ("outlet_temperature", limits.temperature, "Highest temperature set"),
        ("transition_film_thickness", limits.transition_film_thickness, "Film at transition set"),
    ):
        if value is not None:
            yield named_row(name, value, said)
