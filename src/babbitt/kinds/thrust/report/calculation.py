"""The calculation of a thrust bearing as lines that can be followed with a pocket calculator.

What the films in two dimensions answer is stated; what follows from it is shown with its formula. A test holds
every formula against the result.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from babbitt.core.result import Result
from babbitt.report.worksheet import Worksheet

if TYPE_CHECKING:
    from babbitt.core.solution import Solution
    from babbitt.kinds.shaft_line.answer import LineAnswer
    from babbitt.kinds.thrust.design import ThrustDesign, ThrustState
    from babbitt.report.line import Line, Section

__all__ = ["line_calculation", "thrust_calculation"]

FOUND = "Found with the films in two dimensions, at tilts and heights at which the pads carry the thrust together."
SAME = 1e-9
"""Relative difference up to which a flow is what its formula says."""


def thrust_calculation(solution: Solution) -> tuple[Section, ...]:
    """Lines of a solved thrust bearing; none of one that is not."""
    return _calculation(solution.problem, solution.state, solution.result)


def line_calculation(solution: Solution) -> tuple[Section, ...]:
    """Lines of the thrust bearing of a shaft line at rest; none of one that is not solved."""
    answer: LineAnswer | None = solution.state
    return () if answer is None else _calculation(solution.problem.thrust, answer.static, solution.result)


def _calculation(design: ThrustDesign, state: ThrustState | None, result: Result) -> tuple[Section, ...]:
    from babbitt.report.line import Section

    if state is None or not result.outcome.solved:
        return ()
    sheet = _sheet(design, state, result)
    sections = (
        Section("Area, load and speed", tuple(_load(sheet))),
        Section("The pad that carries most", tuple(_pad(sheet)), FOUND),
        Section("Friction", tuple(_friction(sheet))),
        Section("Oil flow", tuple(_flow(sheet))),
        Section("Heat balance of the pad that carries most", tuple(_heat_of_pad(sheet))),
        Section("Heat balance of the bearing", tuple(_heat(design, state, sheet))),
        Section("Reynolds number", tuple(_validity(sheet))),
    )
    return tuple(section for section in sections if section.lines)


def _sheet(design: ThrustDesign, state: ThrustState, result: Result) -> Worksheet:
    """Values of the result, and what they follow from."""
    share, pad, oil = state.share, design.bearing.pad, design.oil
    worst = share.states[int(share.loads.argmax())]
    known = dict(result.values) | {
        "inner_radius": pad.inner_radius,
        "outer_radius": pad.outer_radius,
        "pad_extent": pad.extent,
        "thickest_film": float(share.heights.max()),
        "entering_flow": sum(one.leading_flow for one in share.states),
        "trailing_flow": sum(one.trailing_flow for one in share.states),
        "carried_share": oil.carry_over,
        "this_minimum_film": worst.minimum_film_thickness,
        "this_power": worst.friction_power,
        "this_trailing_flow": worst.trailing_flow,
        "this_side_flow": worst.side_flow,
        "this_viscosity": worst.viscosity,
    }
    if "temperature_rise" in known:
        known["passing_warming"] = known.pop("temperature_rise")
    temperature = known.get("effective_temperature")
    if temperature is not None:
        known["density"] = float(design.lubricant.density(temperature))
    capacity = _capacity(design, state)
    if capacity is not None:
        known["volumetric_heat_capacity"] = capacity
    if worst.balance is not None:
        known["this_inlet_temperature"] = worst.balance.inlet
    elif state.temperatures is not None and worst.heat is None:  # pads that share evenly are all alike
        known["this_inlet_temperature"] = state.temperatures.inlet
    return Worksheet(known)


def _capacity(design: ThrustDesign, state: ThrustState) -> float | None:
    """rho c of the heat balance, J/(m3 K); None where the oil is known by its viscosity alone."""
    from babbitt.kinds.thrust.balanced_films import BalancedFilms

    if design.oil.thermal is not None:
        return design.oil.thermal.heat().volumetric_heat_capacity
    if isinstance(state.films, BalancedFilms):
        return state.films.capacity
    at = state.temperatures.effective if state.temperatures is not None else design.oil.effective_temperature
    return None if at is None else float(design.lubricant.volumetric_heat_capacity(at))


def _speed(sheet: Worksheet) -> str:
    return "abs(angular_speed)" if sheet["angular_speed"] < 0.0 else "angular_speed"


def _load(sheet: Worksheet) -> Iterator[Line]:
    yield sheet.line("mean_radius", "(inner_radius + outer_radius) / 2")
    yield sheet.line("pad_area", "pad_extent / 2 * (outer_radius**2 - inner_radius**2)")
    yield sheet.line("specific_load", "load / (pad_number * pad_area)")
    yield sheet.line("surface_speed", f"{_speed(sheet)} * mean_radius")


def _pad(sheet: Worksheet) -> Iterator[Line]:
    yield sheet.given("largest_pad_load")
    yield sheet.line("pad_load_ratio", "largest_pad_load * pad_number / load")
    yield sheet.line("largest_specific_load", "largest_pad_load / pad_area")
    yield sheet.line("pressure_speed_product", "largest_specific_load * surface_speed")
    yield sheet.given("pivot_film_thickness", "over its pivot")
    yield sheet.given("this_minimum_film", "at its edges")
    yield sheet.line("film_thickness_ratio", "this_minimum_film / pivot_film_thickness")
    if not math.isclose(sheet["this_minimum_film"], sheet["minimum_film_thickness"], rel_tol=SAME):
        yield sheet.given("minimum_film_thickness", "of another pad")
    yield sheet.given("maximum_pressure", "of all films")


def _friction(sheet: Worksheet) -> Iterator[Line]:
    yield sheet.given("friction_torque", "shear of all films")
    yield sheet.line("friction_power", f"friction_torque * {_speed(sheet)}")
    yield sheet.line("friction_of_thrust", "friction_torque / (load * mean_radius)")


def _flow(sheet: Worksheet) -> Iterator[Line]:
    yield sheet.given("trailing_flow", "of the films")
    yield sheet.given("side_flow", "of the films")
    yield sheet.line("entering_flow", "trailing_flow + side_flow", digits=7)
    if "total_flow" not in sheet:
        return
    carried = sheet["entering_flow"] - sheet["total_flow"]
    if math.isclose(carried, sheet["carried_share"] * sheet["trailing_flow"], rel_tol=SAME):
        sheet.note(carried_flow=carried)
        yield sheet.line("carried_flow", "carried_share * trailing_flow", digits=7)
    else:
        yield sheet.given("carried_flow", "no more than the next pad draws in", value=carried)
    yield sheet.line("total_flow", "entering_flow - carried_flow", digits=7)


def _heat_of_pad(sheet: Worksheet) -> Iterator[Line]:
    """Balance of a film of one temperature; films that vary along the pad have none to follow by hand."""
    if "this_inlet_temperature" not in sheet:
        return
    yield sheet.given("this_inlet_temperature", "hot oil carried over, mixed with fresh oil")
    yield sheet.given("this_power", "shear of its film")
    yield sheet.given("this_trailing_flow", "of its film")
    yield sheet.given("this_side_flow", "of its film")
    yield sheet.given("volumetric_heat_capacity")
    rise = "this_power / (volumetric_heat_capacity * (this_trailing_flow + this_side_flow / 2))"
    yield sheet.line("pad_warming", rise, "oil over the sides takes half of it", digits=7)
    yield sheet.line("this_temperature", "this_inlet_temperature + pad_warming / 2")
    yield sheet.given("this_viscosity", "of the oil at this temperature")
    hottest = "hottest_trailing_temperature"
    rises = sheet["this_inlet_temperature"] + sheet["pad_warming"]
    alike = hottest in sheet and math.isclose(rises, sheet[hottest], rel_tol=SAME)
    yield sheet.line(hottest if alike else "this_trailing_temperature", "this_inlet_temperature + pad_warming")


def _heat(design: ThrustDesign, state: ThrustState, sheet: Worksheet) -> Iterator[Line]:
    if state.temperatures is None:
        if "volumetric_heat_capacity" in sheet and "passing_warming" in sheet:
            yield sheet.line("passing_flow", "trailing_flow + side_flow", digits=7)
            rise = "friction_power / (volumetric_heat_capacity * passing_flow)"
            yield sheet.line("passing_warming", rise, "if all heat went with the oil of the films")
        return
    heat = "friction_power"
    if design.oil.thermal is not None:
        heat = "heat_to_oil"
        carried = sheet["outlet_temperature"] - sheet["supply_temperature"]
        yield sheet.given(
            heat,
            "of the films, above the temperature of the fresh oil",
            value=carried * sheet["volumetric_heat_capacity"] * sheet["total_flow"],
        )
    drain = f"supply_temperature + {heat} / (volumetric_heat_capacity * total_flow)"
    yield sheet.line("outlet_temperature", drain, "all heat goes with the oil", digits=7)


def _validity(sheet: Worksheet) -> Iterator[Line]:
    if "density" in sheet:
        reynolds = "density * surface_speed * thickest_film / effective_viscosity"
        yield sheet.given("density")
        yield sheet.given("effective_viscosity")
        yield sheet.line("film_reynolds_number", reynolds, "at the pivot of the thickest film")
