"""The calculation of a tilting-pad bearing as lines that can be followed with a pocket calculator.

What the films answer is stated; what follows from it is shown with its formula. A test holds every formula against
the result.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.core.solution import Solution
from babbitt.kinds.tilting_pad_journal.check import PadSolutionState
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.report.line import Line, Section
from babbitt.report.worksheet import Worksheet

__all__ = ["pad_calculation"]

FOUND = "Found with the films in two dimensions and the tilts at which no moment acts on a pivot."


def pad_calculation(solution: Solution) -> tuple[Section, ...]:
    """Lines of a solved bearing; none of one that is not."""
    if not solution.result.outcome.solved:
        return ()
    case: PadCase = solution.problem
    state: PadSolutionState = solution.state
    sheet = sheet_of(case, solution, state)
    return (
        Section("Place and load of the journal", tuple(_place(sheet)), FOUND),
        Section("The pad that carries most", tuple(_pad(case, state, sheet))),
        Section("Friction, oil and heat", tuple(_heat(state, sheet))),
        *_stability(sheet, state),
    )


def sheet_of(case: PadCase, solution: Solution, state: PadSolutionState) -> Worksheet:
    """Values of the result, and what they follow from."""
    films = state.films.solution
    number = films.most_loaded
    pad, at = films.bearing.pads[number], films.pads[number]
    known = dict(solution.result.values) | {
        "this_pivot": pad.pivot_angle,
        "this_clearance": pad.clearance,
        "this_gap": pad.assembled_clearance,
        "this_retreat": at.position.pivot_displacement,
        "this_radial": float(at.stiffness[0, 0]),
        "this_cross": float(at.stiffness[0, 1]),
        "this_back": float(at.stiffness[1, 0]),
        "this_along": float(at.stiffness[1, 1]),
        "entering_flow": sum(one.inflow for one in films.pads),
        "trailing_flow": sum(one.outflow for one in films.pads),
        "carried_share": case.feed.carry_over,
    }
    if case.pedestal is not None:
        known["pedestal_stiffness_x"], known["pedestal_stiffness_y"] = case.pedestal.stiffness
    return Worksheet(known)


def _place(sheet: Worksheet) -> Iterator[Line]:
    yield sheet.given("journal_x")
    yield sheet.given("journal_y")
    yield sheet.line("eccentric", "sqrt(journal_x**2 + journal_y**2)")
    yield sheet.line("eccentricity_ratio", "eccentric / assembled_clearance")
    yield sheet.line("specific_load", "load / (width * diameter)")
    if "pedestal_stiffness_x" in sheet:
        yield sheet.line("pedestal_x", "load * cos(load_angle) / pedestal_stiffness_x", "of the housing")
        yield sheet.line("pedestal_y", "load * sin(load_angle) / pedestal_stiffness_y", "of the housing")
    turns = "angular_speed / (2 * pi)"
    if sheet["angular_speed"] < 0.0:
        turns = "abs(angular_speed) / (2 * pi)"
    yield sheet.line(
        "american_sommerfeld_number",
        f"effective_viscosity * {turns} * width * diameter * (diameter / (2 * assembled_clearance))**2 / load",
        "with the assembled clearance",
    )


def _pad(case: PadCase, state: PadSolutionState, sheet: Worksheet) -> Iterator[Line]:
    solution = state.films.solution
    number = solution.most_loaded
    at = solution.pads[number]
    yield sheet.given("this_pivot", f"pad {number + 1}")
    yield sheet.line("this_preload", "1 - this_gap / this_clearance")
    towards = "journal_x * cos(this_pivot) + journal_y * sin(this_pivot)"
    gives_way = at.position.pivot_displacement > 0.0
    if gives_way:
        yield sheet.given("this_retreat", "under its load, by the law of the pivot")
    yield sheet.line("this_approach", f"{towards} - this_retreat" if gives_way else towards)
    yield sheet.line("this_ratio", "this_preload + this_approach / this_clearance")
    yield sheet.line("this_film", "this_clearance * (1 - this_ratio)")
    yield sheet.given("largest_pad_load", "of its film, free to tilt")
    if at.load > 0.0 and case.bearing.pads[number].rotational_stiffness == 0.0:
        for name in ("this_radial", "this_cross", "this_back", "this_along"):
            yield sheet.given(name)
        condensed = "this_radial - this_cross * this_back / this_along"
        yield sheet.line("this_stiffness", condensed, "the pad follows with its tilt", digits=6)
        if math.isfinite(at.pivot_stiffness):
            yield sheet.given("this_pivot_stiffness", "under its load", value=at.pivot_stiffness)
            yield sheet.line("this_together", "1 / (1 / this_stiffness + 1 / this_pivot_stiffness)")


def _heat(state: PadSolutionState, sheet: Worksheet) -> Iterator[Line]:
    yield sheet.given("friction_torque", "shear of all films, those of unloaded pads among them")
    speed = "abs(angular_speed)" if sheet["angular_speed"] < 0.0 else "angular_speed"
    yield sheet.line("friction_power", f"friction_torque * {speed}")
    yield sheet.given("entering_flow", "of the films")
    yield sheet.given("trailing_flow", "of the films")
    if state.films.thermal is None:
        yield sheet.line("total_flow", "entering_flow - carried_share * trailing_flow", digits=7)
    else:
        yield from _own_heat(sheet)
    if state.films.temperatures is not None:
        spread = "trailing_flow + (entering_flow - trailing_flow) / 2"
        yield sheet.line("pad_warming", f"friction_power / (volumetric_heat_capacity * ({spread}))", digits=6)
        mixed = "carried_share * trailing_flow * pad_warming / (entering_flow - carried_share * trailing_flow)"
        yield sheet.line("pad_inlet_temperature", f"supply_temperature + {mixed}", digits=7)
        yield sheet.line("trailing_temperature", "pad_inlet_temperature + pad_warming")
        yield sheet.line("effective_temperature", "pad_inlet_temperature + pad_warming / 2",
                         "at which the viscosity was taken")  # fmt: skip
        yield from _outlet(sheet, "friction_power")
    yield sheet.line(
        "film_reynolds_number", "density * surface_speed * largest_pad_clearance / effective_viscosity"
    )
    yield sheet.line("critical_reynolds_number", "41.3 * sqrt(diameter / (2 * largest_pad_clearance))")


def _own_heat(sheet: Worksheet) -> Iterator[Line]:
    """Heat of films with their own temperatures."""
    yield sheet.given("total_flow", "fresh oil, of the films and the mixing before them")
    yield sheet.given("film_dissipation", "of the films")
    yield sheet.given("heat_to_pads", "of the films")
    yield sheet.given("heat_to_oil", "of the films, above the temperature of the fresh oil")
    yield from _outlet(sheet, "heat_to_oil")


def _outlet(sheet: Worksheet, heat: str) -> Iterator[Line]:
    """The oil that leaves with a heat; nothing of pads that starve."""
    if "outlet_temperature" not in sheet:
        return
    passing = "given_flow" if "given_flow" in sheet else "total_flow"
    yield sheet.line("outlet_temperature", f"supply_temperature + {heat} / (volumetric_heat_capacity * {passing})")


def _stability(sheet: Worksheet, state: PadSolutionState) -> Iterator[Section]:
    motions = state.dynamics.motions
    if motions is None:
        return
    least = motions.decisive
    if least.frequency == 0.0:
        return
    yield Section(
        "Log decrement",
        (
            sheet.given("mode_decay", "below zero it grows", value=-least.growth),
            sheet.given("mode_frequency", value=least.frequency),
            sheet.line("log_decrement", "2 * pi * mode_decay / mode_frequency"),
        ),
        "From the matrices of journal, pads and rotor together.",
    )
    if "critical_cross_coupling" in sheet:
        yield Section(
            "Cross-coupling",
            (
                sheet.given("critical_cross_coupling", "threshold, at which a motion begins to grow"),
                sheet.line("cross_coupling_ratio", "critical_cross_coupling / anticipated_cross_coupling"),
            ),
            "Of the whole rotor, each of both bearings bears half of it.",
        )
