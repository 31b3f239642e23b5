"""What a bearing was computed from, as rows that an engineer can check against the drawing."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from babbitt.case.designs import EveryDesign, JournalDesign
from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.conditions import GivenPosition
from babbitt.design.ducts import Duct
from babbitt.kinds.footstep.model_case import HeelCase
from babbitt.kinds.footstep.report.inputs import heel_inputs
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.report.inputs import groups as hydrostatic_inputs
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902.model import Curves, DesignCase, Friction, GivenEccentricity
from babbitt.kinds.journal.iso7902.supply import (
    Arrangement,
    CircumferentialGroove,
    HalfCircumferentialGroove,
    Holes,
    Pockets,
    SupplyElement,
)
from babbitt.kinds.journal.report.film_inputs import (
    CAVITATION,
    said_of_bore,
    said_of_bush,
    said_of_changing_load,
    said_of_flow,
    said_of_heat,
    said_of_hollow,
    said_of_journal,
    said_of_pressure,
    said_of_start,
    said_of_step,
)
from babbitt.kinds.journal.report.one_dimension import said_of
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.thrust.design import ThrustDesign
from babbitt.properties.lubricants import (
    AstmD341,
    ConstantViscosity,
    Exponential,
    Lubricant,
    PowerLaw,
    ViscosityKind,
    Vogel,
    Walther,
)
from babbitt.properties.materials import BearingMetal
from babbitt.report.expression import Node, number_node, text
from babbitt.report.labels import label
from babbitt.report.text import plain_text
from babbitt.report.vocabulary import VOCABULARY, symbol

LAWS = {
    Walther: "Walther (ASTM D341, short form)",
    AstmD341: "ASTM D341",
    Vogel: "Vogel",
    Exponential: "exponential",
    PowerLaw: "power law (50/t)^m",
    ConstantViscosity: "constant",
}

FRICTION = {
    Friction.FULL: "film around the whole circumference",
    Friction.ARC: "film on the loaded arc only",
    Friction.CURVE360: "friction number of the full bearing at the same eccentricity",
}

UNITS = {"1e-6/K": "× 10⁻⁶/K"}
"""Units as they look on paper, where the vocabulary writes them for a plain terminal."""

PLACES = {
    Arrangement.OPPOSITE: "opposite the load",
    Arrangement.SIDE: "at 90° to the load",
    Arrangement.BOTH_SIDES: "on both sides, ±90° to the load",
}


@dataclass(frozen=True)
class Row:
    """One input: what it is, its symbol where it has one, its value with the unit."""

    label: str
    value: str
    symbol: Node | None = None
    unit: str = ""


@dataclass(frozen=True)
class InputGroup:
    """Inputs that belong together."""

    title: str
    rows: tuple[Row, ...]


def inputs(case: EveryDesign) -> tuple[InputGroup, ...]:
    """All inputs of a case, grouped.

    Parameters
    ----------
    case : EveryDesign

    Returns
    -------
    tuple of InputGroup
        Groups that say nothing are left out.
    """
    match case:
        case HeelCase():
            groups = _in_words(heel_inputs(case))
        case HydrostaticCase() | JackingCase():
            groups = _in_words(hydrostatic_inputs(case))
        case ThrustDesign() | LineDesign():
            groups = _thrust(case)
        case _:
            groups = _journal(case)
    return tuple(group for group in (_as_given(case), *groups) if group.rows)


def _in_words(said: Iterable[tuple[str, Iterable[tuple[str, str, str]]]]) -> Iterator[InputGroup]:
    """Groups of rows that another module has put into words."""
    for title, rows in said:
        yield InputGroup(title, tuple(Row(what, plain_text(value), None, unit) for what, value, unit in rows))


def _journal(case: JournalDesign) -> Iterator[InputGroup]:
    match case:
        case LongFilmCase() | SegmentCase():
            geometry, method = _one_dimension_geometry(case), _one_dimension_method(case)
        case FilmCase():
            geometry, method = _film_geometry(case), _film_method(case)
        case _:
            geometry, method = _geometry(case), _method(case)
    yield InputGroup("Geometry", tuple(geometry))
    yield InputGroup("Operation", tuple(_operation(case)))
    yield InputGroup("Lubricant", tuple(_oil_rows(case.lubricant)))
    yield InputGroup("Oil supply", tuple(_supply(case)))
    yield InputGroup("Cooling by the surroundings", tuple(_cooling(case)))
    yield InputGroup("Surfaces", tuple(_surfaces(case)))
    yield InputGroup("Material", tuple(_material(case)))
    yield InputGroup("Method", (*method, *_limits(case)))


def _as_given(case: EveryDesign) -> InputGroup:
    return InputGroup("As given", tuple(Row(plain_text(what), plain_text(words)) for what, words in case.given))


def _thrust(case: ThrustDesign | LineDesign) -> Iterator[InputGroup]:
    """Of a thrust bearing or a shaft line: its oil; the case file says the rest."""
    yield InputGroup("Lubricant", (*_oil_rows(case.lubricant), *_thrust_oil(case)))
    limits = (case.thrust if isinstance(case, LineDesign) else case).temperatures
    yield InputGroup("Material", tuple(_metal(limits.given_metal)))


def _thrust_oil(case: ThrustDesign | LineDesign) -> Iterator[Row]:
    oil = (case.thrust if isinstance(case, LineDesign) else case).oil
    if oil.supply_temperature is not None:
        yield _named("supply_temperature", oil.supply_temperature)
        yield Row("Hot oil carried over", f"{100.0 * oil.carry_over:.4g}", None, "%")
        across = ", across the pads" if oil.resolved else ""
        yield Row(
            "Temperature of the films",
            f"varies along the pads{across} and across the gap (adiabatic)"
            if oil.own_temperatures
            else "one (global)",
        )
    if oil.effective_temperature is not None:
        yield _named("effective_temperature", oil.effective_temperature, "Prescribed effective temperature")


def _named(name: str, value: float, given_label: str = "") -> Row:
    """An input under its name in the vocabulary, in the engineer's unit, as exactly as it was given."""
    quantity = VOCABULARY[name]
    shown = text(number_node(quantity.shown(value), 6)).replace("e−", " × 10^−")
    return Row(
        given_label or label(name), shown, symbol(name), UNITS.get(quantity.display.label, quantity.display.label)
    )


def _geometry(case: DesignCase) -> Iterator[Row]:
    bearing = case.bearing
    yield _named("diameter", bearing.diameter)
    yield _named("width", bearing.width)
    yield _named("width_ratio", bearing.width_ratio)
    yield _named("relative_clearance", bearing.relative_clearance)
    yield _named("angular_span", math.radians(bearing.span))
    yield _named("expansion_bearing", bearing.expansion_bearing)
    yield _named("expansion_journal", bearing.expansion_journal)
    if bearing.supply_element is not None:
        yield from _element(bearing.supply_element)


def _holes(number: float) -> str:
    """How many round holes; a slot is as many equivalent ones as come out, which is no whole number."""
    if number == 1.0:
        return "Hole"
    return f"{number:.0f} holes" if number.is_integer() else f"{number:.4g} holes (a slot: equivalent holes)"


def _element(element: SupplyElement) -> Iterator[Row]:
    match element:
        case Holes():
            yield Row("Supply element", f"{_holes(element.number)} {PLACES[element.arrangement]}")
            yield _named("hole_diameter", element.diameter)
        case Pockets():
            yield Row("Supply element", f"Pocket {PLACES[element.arrangement]}")
            yield _named("pocket_width", element.width)
        case CircumferentialGroove():
            yield Row("Supply element", "Groove around the circumference, between two half bearings")
            yield _named("groove_width", element.width)
        case HalfCircumferentialGroove():
            yield Row("Supply element", "Groove around the unloaded half")
            yield _named("groove_width", element.width)
        case _:
            yield Row("Supply element", type(element).__name__)


def _film_geometry(case: FilmCase) -> Iterator[Row]:
    bearing = case.bearing
    yield _named("diameter", bearing.diameter)
    yield _named("width", bearing.width)
    yield _named("width_ratio", bearing.width_ratio)
    yield _named("relative_clearance", bearing.relative_clearance)
    yield _named("expansion_bearing", bearing.expansion_bearing)
    yield _named("expansion_journal", bearing.expansion_journal)
    yield Row("Form of the bore", said_of_bore(bearing.bore))
    for hollow in bearing.hollows:
        yield Row(*said_of_hollow(hollow))
    if bearing.misalignment != (0.0, 0.0):
        slopes = ", ".join(f"{1e3 * slope:.4g}" for slope in bearing.misalignment)
        yield Row("Slopes of the journal axis dx/dz, dy/dz", slopes, None, "mm/m")
    for step in bearing.steps:
        yield Row("Step of the bore", said_of_step(step))
    if bearing.crowning:
        ends = ", ".join(f"{1e6 * drop:.4g}" for drop in (bearing.crowning[0], bearing.crowning[-1]))
        yield Row("Crowning of the journal, drop at the sides", ends, None, "µm")
    if bearing.displacement:
        values = [value for row in bearing.displacement for value in row]
        yield Row("Displacement of the gap", f"{1e6 * min(values):.4g} to {1e6 * max(values):.4g}", None, "µm")
    for one in bearing.compliance:
        yield Row("Elastic bore", one.premise)
    if bearing.side_pressures != (0.0, 0.0):
        sides = ", ".join(f"{1e-3 * pressure:.4g}" for pressure in bearing.side_pressures)
        yield Row("Pressures at the sides z = -B/2, B/2 (gauge)", sides, None, "kPa")


def _one_dimension_geometry(case: LongFilmCase | SegmentCase) -> Iterator[Row]:
    bearing = case.bearing
    yield _named("diameter", bearing.diameter)
    yield _named("width", bearing.width)
    yield _named("width_ratio", bearing.width_ratio)
    yield _named("relative_clearance", bearing.relative_clearance)


def _one_dimension_method(case: LongFilmCase | SegmentCase) -> Iterator[Row]:
    for what, words in said_of(case):
        yield Row(what, words)


def _film_method(case: FilmCase) -> Iterator[Row]:
    if case.heat is None:
        yield Row("Film", "Reynolds equation in two dimensions, one viscosity")
    else:
        yield Row("Film", "generalised Reynolds equation in two dimensions and energy equation")
    yield Row("Flow", said_of_flow(case.turbulence))
    yield Row("Viscosity under pressure", said_of_pressure(case.pressure_viscosity))
    yield Row("Temperature", said_of_heat(case.heat, case.effective_temperature))
    if case.heat is not None and case.heat.walls is not None:
        yield Row("Bush and housing", said_of_bush(case.heat.walls))
        yield Row("Journal", said_of_journal(case.heat.walls))
    if case.heat is not None and case.heat.growth is not None:
        yield Row("Distortion by heat", case.heat.growth.premise)
    yield Row("Where the film breaks up", CAVITATION[case.cavitation])
    yield Row("Where the film begins", said_of_start(case.bearing))
    yield Row("Grid", case.accuracy.value)
    if case.cavitation_pressure:
        yield Row("Cavitation pressure (gauge)", f"{1e-3 * case.cavitation_pressure:.4g}", None, "kPa")
    if case.friction_factor != 1.0:
        yield _named("friction_factor", case.friction_factor)


def _operation(case: JournalDesign) -> Iterator[Row]:
    if isinstance(case.duty, GivenEccentricity):
        yield _named("eccentricity_ratio", case.duty.eccentricity_ratio, "Prescribed eccentricity e/c")
        if case.duty.attitude_angle is not None:
            yield _named("attitude_angle", case.duty.attitude_angle, "Prescribed attitude angle")
    elif isinstance(case.duty, GivenPosition):
        yield Row("Prescribed position x, y", f"{1e6 * case.duty.x:.4g}, {1e6 * case.duty.y:.4g}", None, "µm")
    elif case.duty is not None:
        yield _named("load", case.duty.load)
    yield _named("angular_speed", case.journal_speed)
    if case.bearing_speed:
        yield Row("Rotational speed of the bearing", f"{case.bearing_speed * 30.0 / math.pi:.4g}", None, "rpm")
    if isinstance(case, FilmCase):
        yield Row("Sense of rotation (x right, y up)", case.rotation.value.replace("_", "-"))
        if not isinstance(case.duty, GivenPosition):
            yield Row("Direction of the load from +x", f"{math.degrees(case.load_angle):.4g}", None, "°")
        if case.rotor_mass is not None:
            yield _named("rotor_mass", case.rotor_mass)
        if case.shaft_stiffness is not None:
            yield _named("shaft_stiffness", case.shaft_stiffness)
        if case.changing_load is not None:
            yield Row("Changing load, added", said_of_changing_load(case.changing_load))
        if case.moving_mass:
            yield Row("Mass that moves with the journal", f"{case.moving_mass:.4g}", None, "kg")
    if case.effective_temperature is not None:
        yield _named("effective_temperature", case.effective_temperature, "Prescribed effective temperature")


def _oil_rows(oil: Lubricant) -> Iterator[Row]:
    yield Row("Name", plain_text(oil.name))
    yield Row("Viscosity law", LAWS.get(type(oil.viscosity_law), type(oil.viscosity_law).__name__))
    law = oil.viscosity_law
    if isinstance(law, ConstantViscosity):
        yield _constant(law)
    else:
        for celsius in (40, 100):
            kelvin = celsius + ZERO_CELSIUS
            if oil.covers(kelvin):
                viscosity = f"{1e6 * oil.kinematic_viscosity(kelvin):.4g}"
                yield Row(f"Kinematic viscosity at {celsius} °C", viscosity, None, "mm²/s")
    if oil.covers(293.15):
        yield Row("Density at 20 °C", f"{oil.density(293.15):.4g}", None, "kg/m³")
    if oil.fixed_volumetric_heat_capacity is not None:
        yield _named("volumetric_heat_capacity", oil.fixed_volumetric_heat_capacity)
    else:
        yield Row("Specific heat at 50 °C", f"{oil.heat_capacity(323.15):.4g}", None, "J/(kg K)")
    yield Row("Source", plain_text(oil.source))


def _constant(law: ConstantViscosity) -> Row:
    """What is constant, once: over a density that falls with temperature the other one would seem to rise."""
    if law.kind is ViscosityKind.DYNAMIC:
        return Row("Dynamic viscosity", f"{1e3 * law.viscosity:.4g}", None, "mPa s")
    return Row("Kinematic viscosity", f"{1e6 * law.viscosity:.4g}", None, "mm²/s")


def _supply(case: JournalDesign) -> Iterator[Row]:
    supply = case.oil_supply
    if supply is None:
        return
    yield _named("supply_temperature", supply.temperature)
    if supply.flow is not None:
        yield _named("given_flow", supply.flow)
    elif not isinstance(case, LongFilmCase | SegmentCase):  # their pressure drives nothing
        yield _named("supply_pressure", supply.pressure)
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
        yield _named("ambient_temperature", case.cooling.ambient_temperature)
        yield _named("heat_transfer_coefficient", case.cooling.heat_transfer_coefficient)
        yield _named("cooling_surface", case.cooling.surface)


def _surfaces(case: JournalDesign) -> Iterator[Row]:
    surfaces = case.bearing.surfaces
    if surfaces is not None:
        for name, value in vars(surfaces).items():
            yield _named(name, value)


def _metal(metal: BearingMetal | None) -> Iterator[Row]:
    if metal is not None:
        yield Row("Bearing metal", plain_text(metal.name))
        yield Row("Specified in", plain_text(metal.standard))


def _material(case: JournalDesign) -> Iterator[Row]:
    yield from _metal(case.bearing.metal)
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
        yield _named("friction_factor", case.friction_factor)


def _limits(case: JournalDesign) -> Iterator[Row]:
    limits = case.limits
    for name, value, said in (
        ("minimum_film_thickness", limits.minimum_film_thickness, "Least film thickness set"),
        ("specific_load", limits.specific_load, "Largest specific load set"),
        ("outlet_temperature", limits.temperature, "Highest temperature set"),
        ("transition_film_thickness", limits.transition_film_thickness, "Film at transition set"),
    ):
        if value is not None:
            yield _named(name, value, said)
