"""The calculation of a hydrostatic bearing as lines that can be followed with a pocket calculator.

What a film or a network of several recesses answers is stated; what follows from it, and all of pads with one
recess by closed forms, is shown with its formula. A test holds every formula against the result.
"""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.result import Result
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, RecessedJournal, RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.pumping import law_of
from babbitt.kinds.hydrostatic.report.land_lines import annular_area, centred_lines, land_lines
from babbitt.kinds.hydrostatic.report.power_lines import power_lines
from babbitt.kinds.hydrostatic.report.restrictor_lines import is_linear, restrictor_lines
from babbitt.kinds.hydrostatic.report.sheet import HydrostaticSheet, JackingSheet
from babbitt.kinds.hydrostatic.restrictors import CheckValve, ConstantFlow, MeteredFlow
from babbitt.kinds.hydrostatic.supply import FixedPressure
from babbitt.report.line import Line, Section

__all__ = ["hydrostatic_calculation"]

SOURCES = {
    "film": "Found with the film in two dimensions, which lets out what the restrictors let in.",
    "quick": "Found with the network of lumped lands, which lets out what the restrictors let in.",
}
CENTRED = "For comparison: lumped lands of the journal in the middle, some per cent off its film."


def hydrostatic_calculation(case: HydrostaticCase | JackingCase, result: Result) -> tuple[Section, ...]:
    """Lines of a solved bearing; none of one that is not.

    Parameters
    ----------
    case : HydrostaticCase or JackingCase
    result : Result
        The answer to that case.
    """
    if not result.outcome.solved:
        return ()
    if isinstance(case, JackingCase):
        return tuple(_jacking(case, JackingSheet(case, result)))
    sheet = HydrostaticSheet(case, result)
    several = isinstance(case.shape, ThrustRing | RecessedJournal)
    sections = _several(case, sheet) if several else _pad(case, sheet)
    return (*sections, Section("Power and warming", tuple(power_lines(case, sheet))))


def _pad(case: HydrostaticCase, sheet: HydrostaticSheet) -> Iterator[Section]:
    shape, restrictor = case.shape, case.feeding.restrictors[0]
    assert isinstance(shape, CircularPad | AnnularPad | RectangularPad)
    if case.method == "film":
        yield Section("Restrictor", (sheet.given("one_recess_pressure"), *restrictor_lines(sheet, restrictor)),
                      SOURCES["film"])  # fmt: skip
        yield Section("Lands", (
            sheet.line("land_conductance", "one_restrictor_flow / one_recess_pressure", "of the film at this gap"),
            sheet.line("effective_area", "load / one_recess_pressure"),
        ))  # fmt: skip
        return
    yield Section("Lands", tuple(land_lines(sheet, shape)))
    yield Section("Restrictor and flow", tuple(_balance(case, sheet)))
    yield Section("Load and stiffness", tuple(_load(case, sheet)))


def _balance(case: HydrostaticCase, sheet: HydrostaticSheet) -> Iterator[Line]:
    restrictor = case.feeding.restrictors[0]
    lines = tuple(restrictor_lines(sheet, restrictor))
    if is_linear(law_of(restrictor)):
        yield lines[0]
        yield sheet.line("mean_pressure_ratio", "1 / (1 + land_conductance / restrictor_conductance)")
        yield sheet.line("one_recess_pressure", "mean_pressure_ratio * supply_pressure")
        yield from lines[1:]
    else:
        yield sheet.given("one_recess_pressure", "at which the lands let out what the restrictor lets in")
        yield from lines
    yield sheet.line("total_flow", "land_conductance * one_recess_pressure", "the flows agree", digits=6)


def _load(case: HydrostaticCase, sheet: HydrostaticSheet) -> Iterator[Line]:
    yield sheet.line("load", "effective_area * one_recess_pressure", digits=6)
    stands = isinstance(case.feeding.supply, FixedPressure)
    if not stands:
        return
    restrictor = case.feeding.restrictors[0]
    _, slope, _ = restrictor.law(sheet["one_recess_pressure"], sheet["supply_pressure"])
    if is_linear(law_of(restrictor)):
        through = "restrictor_conductance"
    else:
        through = "restrictor_slope"
        yield sheet.given("restrictor_slope", "of its law at these pressures", value=-slope)
    yield sheet.line("gap_stiffness", f"3 * load * land_conductance / (gap * (land_conductance + {through}))")


def _several(case: HydrostaticCase, sheet: HydrostaticSheet) -> Iterator[Section]:
    """Ring and journal: the recess with the highest pressure, all recesses, the middle."""
    restrictor = case.feeding.restrictors[sheet.highest]
    where = f"of recess {sheet.highest + 1}" + ", the highest" * (case.count > 1)
    lines = (sheet.given("one_recess_pressure", where), *restrictor_lines(sheet, restrictor))
    yield Section("Restrictor", lines, SOURCES[case.method])
    yield Section("All recesses", tuple(_whole(case, sheet)))
    if _has_closed_form(case):
        yield Section("The centred journal", tuple(centred_lines(sheet)), CENTRED)


def _whole(case: HydrostaticCase, sheet: HydrostaticSheet) -> Iterator[Line]:
    first = case.feeding.restrictors[0]
    alike = case.feeding.is_uniform and not isinstance(first, CheckValve)
    if alike and is_linear(first):
        flow = "recess_number * restrictor_conductance * supply_pressure * (1 - mean_pressure_ratio)"
        yield sheet.line("total_flow", flow, digits=6)
    elif alike and isinstance(first, ConstantFlow):
        loss = " - stage_leakage * mean_pressure_ratio * supply_pressure" if first.leakage else ""
        yield sheet.line("total_flow", f"recess_number * (stage_flow{loss})", digits=6)
    elif alike and isinstance(first, MeteredFlow):
        yield sheet.line("total_flow", "recess_number * stage_flow", digits=6)
    else:
        yield sheet.given("total_flow", "sum over the restrictors")
    if isinstance(case.shape, RecessedJournal):
        yield sheet.line("specific_load", "load / (diameter * width)")
        yield sheet.line("minimum_film_thickness", "radial_clearance * (1 - eccentricity_ratio)", digits=6)
    elif case.method == "quick":
        yield sheet.line("ring_area", annular_area())
        yield sheet.line("load", "ring_area * mean_pressure_ratio * supply_pressure", digits=6)
    else:
        yield sheet.line("ring_area", "load / (mean_pressure_ratio * supply_pressure)", "of the film")


def _has_closed_form(case: HydrostaticCase) -> bool:
    """Whether the centred journal has one: equal capillaries or slots, three recesses or more, no drains."""
    shape, feeding = case.shape, case.feeding
    return (
        isinstance(shape, RecessedJournal)
        and shape.count > 2
        and shape.is_regular
        and shape.groove_extent == 0.0
        and feeding.is_uniform
        and is_linear(law_of(feeding.restrictors[0]))
        and isinstance(feeding.supply, FixedPressure)
    )


def _jacking(case: JackingCase, sheet: JackingSheet) -> Iterator[Section]:
    found = "film in two dimensions" if case.method == "film" else "strips"
    yield Section("Breakaway", (
        sheet.given("projected_area", "of all pockets, seen along the load"),
        sheet.line("breakaway_pressure", "load / projected_area", "no oil between shaft and bore yet"),
        sheet.given("lying_pressure", f"{found} at a gap of the roughness height"),
    ))  # fmt: skip
    conductance = sheet["total_flow"] / sheet["pocket_pressure"]
    yield Section("Lift", (
        sheet.line("lift", "minimum_film_thickness - roughness_height"),
        sheet.line("eccentricity_ratio", "1 - minimum_film_thickness / radial_clearance"),
        sheet.given("effective_area", f"{found} at that gap"),
        sheet.line("pocket_pressure", "load / effective_area"),
        sheet.given("pocket_conductance", f"{found} at that gap", value=conductance),
        sheet.line("total_flow", "pocket_conductance * pocket_pressure"),
        sheet.line("pumping_power", "pocket_pressure * total_flow"),
        sheet.line("pump_power", "pocket_pressure * total_flow / efficiency_of_pump"),
    ))  # fmt: skip
