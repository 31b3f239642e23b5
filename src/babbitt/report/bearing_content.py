"""What a chapter of the report says, as plain data: one bearing at one operating point."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from babbitt.case.designs import EveryDesign
from babbitt.core.notices import EXPLANATIONS, Effect
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.kinds.footstep.model_case import HeelCase
from babbitt.kinds.footstep.report.calculation import heel_calculation
from babbitt.kinds.footstep.report.figures import heel_figures
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.report.calculation import hydrostatic_calculation
from babbitt.kinds.hydrostatic.report.figures import hydrostatic_figures
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902.model import DesignCase
from babbitt.kinds.journal.report.calculation import Section, calculation
from babbitt.kinds.journal.report.coefficient_temperatures import beside_coefficient
from babbitt.kinds.journal.report.film_figures import report_figures
from babbitt.kinds.journal.report.one_dimension import METHOD_NAMES, OWN_RESULTS
from babbitt.kinds.journal.report.one_dimension_figures import figures_along_the_film
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.thrust.design import ThrustDesign
from babbitt.kinds.thrust.report.figures import thrust_figures
from babbitt.kinds.thrust.report.sentences import answers
from babbitt.kinds.thrust.report.tables import tables
from babbitt.report import findings
from babbitt.report import verdict as judge
from babbitt.report.bearing_table import matrix_entries, matrix_unit
from babbitt.report.chapters import Chapter, Member
from babbitt.report.check_content import check_content, compared_checks, solved_checks, sources_of
from babbitt.report.columns import ABSENT, is_fed, is_film
from babbitt.report.drawing import Drawing
from babbitt.report.expression import text
from babbitt.report.figures import clearance_range, draw
from babbitt.report.inputs import inputs
from babbitt.report.labels import label
from babbitt.report.line import Line
from babbitt.report.names import worded
from babbitt.report.symbols import symbol_node
from babbitt.report.text import plain_text

Data = dict[str, Any]

KEY_RESULTS = (
    "specific_load",
    "surface_speed",
    "operating_relative_clearance",
    "sommerfeld_number",
    "eccentricity_ratio",
    "attitude_angle",
    "narrowest_gap_angle",
    "minimum_film_thickness",
    "maximum_pressure",
    "friction_coefficient",
    "friction_power",
    "side_flow",
    "supply_flow",
    "total_flow",
    "effective_temperature",
    "outlet_temperature",
    "maximum_temperature",
    "hot_spot_angle",
    "hot_spot_position",
    "groove_temperature",
    "mean_bush_temperature",
    "maximum_bush_temperature",
    "mean_wall_temperature",
    "maximum_wall_temperature",
    "journal_temperature",
    "film_dissipation",
    "heat_to_oil",
    "returned_flow",
    "heat_returned",
    "heat_film_to_bush",
    "heat_film_to_journal",
    "energy_balance_error",
    "bearing_temperature",
    "effective_viscosity",
    "film_reynolds_number",
    "transition_speed",
    *(
        f"{name}_{axes}"
        for name in ("stiffness", "damping", "tilt_stiffness", "tilt_damping")
        for axes in ("xx", "xy", "yx", "yy")
    ),
    "film_moment_x",
    "film_moment_y",
    "critical_mass",
    "least_stable_mass",
    "whirl_frequency_ratio",
    "threshold_speed",
    "critical_mass_elastic",
    "threshold_speed_elastic",
    "orbit_largest_eccentricity_ratio",
    "orbit_minimum_film_thickness",
    "orbit_minimum_film_direction",
    "orbit_minimum_film_turned",
    "orbit_maximum_pressure",
    "orbit_specific_load",
    "orbit_pressure_speed_product",
    "orbit_friction_power",
    "lobe_clearance",
    "preload",
    "minimum_film_thickness_error",
    "position_error",
    "load_error",
    "stiffness_error",
    "damping_error",
)
"""Results shown at the head of a bearing; kinds without a film show all they have."""

METHODS = {
    "iso7902": "ISO 7902",
    "film": "Film in two dimensions",
    "quick": "Closed forms",
    "frequency domain": "Static films, vibration in the frequency domain",
    "statics": "Statics of the shaft",
    "superposition": "Groove beside a slit (equations of the study, corrected)",
    "narrow_groove": "Narrow-groove theory",
    **METHOD_NAMES,
}
"""Names of methods on paper."""

NOT_FOR_PAPER = ("wall_time", "iterations")
"""Results that tell of the run rather than of the bearing, and differ from run to run."""

WARNING_HEADINGS = {
    Effect.NO_VERDICT: "No verdict: outside the validity of the model",
    Effect.QUESTIONS_RESULT: "Remarks",
    Effect.INFORMATION: "Information",
}
"""Headings of the warnings of a bearing, by what they do to its verdict."""


def bearing_content(chapter: Chapter) -> Data:
    """Everything that the report says of one bearing.

    Parameters
    ----------
    chapter : Chapter
        One result, or several that differ in the clearance only: those stand side by side, and inputs,
        calculation and figures are those of one of them.

    Returns
    -------
    dict
        Strings, numbers, lists and dictionaries only.
    """
    shown, several = chapter.shown, len(chapter.members) > 1
    case, result = chapter.shown_case, shown.result
    sources = sources_of(chapter.results)
    checks = [check_content(check, sources) for check in solved_checks(result)]
    return {
        "name": plain_text(chapter.name),
        "clearances": [worded([member.clearance]) for member in chapter.members] if several else [],
        "shown": worded([shown.clearance]) if several and not isinstance(case, HeelCase) else "",
        "verdict": judge.worst_verdict(chapter.results).value,
        "unchecked": judge.unchecked(result),
        "lacking": [
            {"code": group.code, "title": group.title, "message": group.message}
            for group in findings.lacking(chapter.results)
        ],
        "method": _method(result),
        "outcomes": [_outcome(member) for member in chapter.members if not member.result.outcome.solved],
        "answers": [plain_text(said) for said in answers(result)],
        "tables": tables(result) if isinstance(case, ThrustDesign | LineDesign) else [],
        "heading": "Operating point" if is_film(result) else "Results",
        "results": _key_results(chapter) if result.outcome.solved else [],
        "inputs": [
            {"title": group.title, "rows": [vars(row) for row in group.rows]}
            for group in (inputs(case) if case is not None else ())
        ],
        "assumptions": list(dict.fromkeys(plain_text(said) for r in chapter.results for said in r.assumptions)),
        "sections": [
            {
                "title": section.title,
                "remark": section.remark,
                "lines": [_line(line) for line in section.lines],
            }
            for section in _sections(case, chapter)
        ],
        "checks": compared_checks(chapter, sources) if several else checks,
        "sources": sources,
        "not_checked": [
            {"code": group.code, "title": group.title, "message": _said(group)}
            for group in findings.not_checked(chapter.results)
        ],
        "warnings": [
            {"heading": heading, "found": found}
            for effect, heading in WARNING_HEADINGS.items()
            if (found := _warnings(chapter, effect))
        ],
        "figures": [
            {
                "name": drawing.name,
                "caption": drawing.caption,
                "svg": drawing.image.decode(),
                "wide": drawing.wide,
            }
            for drawing in figures_of(chapter)
        ],
    }


def figures_of(chapter: Chapter) -> tuple[Drawing, ...]:
    """Figures of a chapter, by what was computed."""
    case, result = chapter.shown_case, chapter.shown.result
    match case:
        case DesignCase() if result.outcome.solved:
            return draw(case, result, clearance_range(case))
        case FilmCase():
            return report_figures(case, result)
        case LongFilmCase() | SegmentCase():
            return figures_along_the_film(case, result)
        case HeelCase():
            states = [(member.case, member.result) for member in chapter.members]
            return tuple(one for own, of in states if isinstance(own, HeelCase) for one in heel_figures(own, of))
        case HydrostaticCase() | JackingCase():
            return hydrostatic_figures(case, result)
        case ThrustDesign() | LineDesign():
            return thrust_figures(case, result)
        case _:
            return ()


def _sections(case: EveryDesign | None, chapter: Chapter) -> tuple[Section, ...]:
    """The calculation of the member shown, or of every steady state of a heel."""
    if isinstance(case, DesignCase):
        return calculation(case, chapter.shown.result)
    if isinstance(case, HydrostaticCase | JackingCase):
        return hydrostatic_calculation(case, chapter.shown.result)
    return tuple(
        replace(section, title=f"{member.clearance.capitalize()}: {section.title.lower()}")
        for member in chapter.members
        if isinstance(member.case, HeelCase)
        for section in heel_calculation(member.case, member.result)
    )


def _method(result: Result) -> str:
    return METHODS.get(result.method, plain_text(result.method))


def _outcome(member: Member) -> Data:
    outcome = member.result.outcome
    explanation = EXPLANATIONS.get(outcome.code)
    message = plain_text(member.result.message).removesuffix(".")
    return {
        "clearance": f"{worded([member.clearance]).capitalize()}: " if member.clearance else "",
        "code": outcome.code,
        "title": outcome.value,
        "message": message[:1].upper() + message[1:],
        "remedy": explanation.remedy if explanation else "",
    }


def _key_results(chapter: Chapter) -> list[Data]:
    result = chapter.shown.result
    journal = not isinstance(chapter.shown_case, HydrostaticCase | JackingCase | ThrustDesign | LineDesign)
    film = "minimum_film_thickness" in result.values and journal
    every = dict.fromkeys(name for r in chapter.results if r.outcome.solved for name in r.values)
    ours = dict.fromkeys((*KEY_RESULTS, *OWN_RESULTS))
    names = tuple(ours if film else (name for name in every if name not in NOT_FOR_PAPER))
    if film and not is_fed(result):
        names = tuple(name for name in names if name not in ("supply_flow", "total_flow"))
    if len(chapter.members) > 1:
        names = ("relative_clearance", *names)
    rows = []
    for name in names:
        values = [r.values.get(name, math.nan) if r.outcome.solved else math.nan for r in chapter.results]
        if name in QUANTITIES and any(map(math.isfinite, values)):
            quantity = QUANTITIES[name]
            rows.append(
                {
                    "label": label(name, result.kind) + beside_coefficient(name, result),
                    "symbol": symbol_node(quantity.symbol),
                    "values": [quantity.format(value) if math.isfinite(value) else ABSENT for value in values],
                    "unit": quantity.display.label,
                }
            )
    rows += [
        {
            "label": f"{label(name, result.kind)}: {reason}",
            "symbol": symbol_node(QUANTITIES[name].symbol),
            "values": [ABSENT] * len(chapter.results),
            "unit": "",
        }
        for name, reason in result.missing.items()
    ]
    return rows + _supply_rows(chapter.results) + _recess_rows(result)


def _supply_rows(results: Sequence[Result]) -> list[Data]:
    """Fresh oil, oil that goes back and temperature of every supply of films with their own temperatures.

    Of the results side by side each has its own value.
    """
    rows = []
    result = next((one for one in results if "groove_angles" in one.arrays and one.outcome.solved), results[0])
    names = {
        "groove_pressures": "pressure",
        "groove_fresh_flows": "fresh oil",
        "groove_returned_flows": "oil that goes back",
        "groove_temperatures": "mixing temperature",
    }
    for place, angle in enumerate(result.arrays.get("groove_angles", ((),))[0], start=1):
        where = f"{QUANTITIES['groove_angles'].format(angle)} °"
        for name, said in names.items():
            if name not in result.arrays:
                continue
            values = [_of_supply(one, name, place) for one in results]
            if name != "groove_returned_flows" or any(value > 0.0 for value in values):
                rows.append(_row(name, f"Supply {place} at {where}, {said}", values, str(place)))
    return rows


def _of_supply(result: Result, name: str, place: int) -> float:
    """A value of a supply, not a number where the result has none."""
    values = result.arrays.get(name, ((),))[0] if result.outcome.solved else ()
    return values[place - 1] if place <= len(values) else math.nan


def _recess_rows(result: Result) -> list[Data]:
    """Pressure, ratio and flow of every recess where there are several, then coefficients over frequency."""
    rows = []
    several = len(result.arrays.get("recess_pressure", ((),))[0]) > 1
    for name in ("recess_pressure", "pressure_ratio", "restrictor_flow") if several else ():
        what = {"recess_pressure": "pressure", "pressure_ratio": "pressure ratio", "restrictor_flow": "flow"}[name]
        for place, value in enumerate(result.arrays[name][0], start=1):
            rows.append(_single_row(name, f"Recess {place}, {what}", value, str(place)))
    for name, said in (("dynamic_stiffness", "Stiffness"), ("dynamic_damping", "Damping")):
        for place, at in enumerate(result.arrays.get("dynamic_frequency", ((),))[0]):
            hertz = f"{QUANTITIES['dynamic_frequency'].shown(at):.6g}"
            values = result.arrays[name][place]
            for index, entry in matrix_entries(len(values)).items():
                rows.append(_single_row(name, f"{said} at {hertz} Hz", values[entry], index.removeprefix("_")))
    return rows


def _single_row(name: str, said: str, value: float, index: str) -> Data:
    return _row(name, said, [value], index)


def _row(name: str, said: str, values: Sequence[float], index: str) -> Data:
    quantity = QUANTITIES[name]
    symbol = f"{quantity.symbol.partition('_')[0]}_{index}" if index else quantity.symbol
    return {
        "label": said,
        "symbol": symbol_node(symbol),
        "values": [quantity.format(value) if math.isfinite(value) else ABSENT for value in values],
        "unit": matrix_unit(quantity, index),
    }


def _line(line: Line) -> Data:
    return {
        "meaning": label(line.name),
        "symbol": line.symbol,
        "formula": line.formula,
        "substituted": line.substituted,
        "results": [{"number": number, "unit": unit} for number, unit in line.results],
        "remark": plain_text(line.remark),
        "spoken": f"{text(line.symbol)} = {text(line.results[-1][0])} {line.results[-1][1]}".strip(),
    }


def _said(group: findings.Group) -> str:
    return group.message if set(group.names) == set(group.of) else f"{group.message}: {group.bearings}"


def _warnings(chapter: Chapter, effect: Effect) -> list[Data]:
    """Warnings of one effect of all members, one a code; those that some members lack say whose they are."""
    found: dict[str, dict[str, list[str]]] = {}
    for member in chapter.members:
        for notice in (one for one in member.result.warnings if one.effect is effect):
            messages = found.setdefault(notice.code, {})
            messages.setdefault(plain_text(notice.message), []).append(member.clearance)
    return [
        {
            "code": code,
            "title": EXPLANATIONS[code].title,
            "message": "; ".join(
                f"{message} ({worded(whose)})" if 0 < len(whose) < len(chapter.members) else message
                for message, whose in messages.items()
            ),
            "remedy": EXPLANATIONS[code].remedy,
        }
        for code, messages in found.items()
    ]
