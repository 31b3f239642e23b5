"""What a report says of one bearing, as plain data."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from babbitt.notices import EXPLANATIONS
from babbitt.quantities import QUANTITIES
from babbitt.report import verdict as judge
from babbitt.report.calculation import calculation
from babbitt.report.columns import is_film
from babbitt.report.drawing import Drawing
from babbitt.report.expression import text
from babbitt.report.figures import clearance_range, draw
from babbitt.report.inputs import inputs
from babbitt.report.labels import label
from babbitt.report.line import Line
from babbitt.report.symbols import symbol_node
from babbitt.report.text import plain_text
from babbitt.results import Bound, Check, Result
from babbitt.standards.iso7902.model import DesignCase

if TYPE_CHECKING:
    from babbitt.cases.build import AnyDesign

Data = dict[str, Any]

KEY_RESULTS = (
    "specific_load",
    "surface_speed",
    "operating_relative_clearance",
    "sommerfeld_number",
    "eccentricity_ratio",
    "attitude_angle",
    "minimum_film_thickness",
    "maximum_pressure",
    "friction_coefficient",
    "friction_power",
    "side_flow",
    "supply_flow",
    "total_flow",
    "effective_temperature",
    "outlet_temperature",
    "bearing_temperature",
    "effective_viscosity",
    "film_reynolds_number",
    "transition_speed",
    *(f"{name}_{axes}" for name in ("stiffness", "damping") for axes in ("xx", "xy", "yx", "yy")),
    "critical_mass",
    "whirl_frequency_ratio",
    "threshold_speed",
    "lobe_clearance",
    "preload",
)
"""Results shown at the head of a bearing; kinds without a film show all they have."""

NOT_FOR_PAPER = ("wall_time", "iterations")
"""Results that tell of the run rather than of the bearing, and differ from run to run."""


def bearing_content(case: AnyDesign | None, result: Result) -> Data:
    """Everything that the report says of one bearing.

    Parameters
    ----------
    case : DesignCase, FilmCase or None
        What the result was computed from; None for kinds without a film.
    result : Result

    Returns
    -------
    dict
        Strings, numbers, lists and dictionaries only.
    """
    solved = result.outcome.solved
    sources = list(dict.fromkeys(plain_text(check.source) for check in result.checks)) if solved else []
    drawings: tuple[Drawing, ...] = ()
    by_standard = case if isinstance(case, DesignCase) else None
    if by_standard is not None and solved:
        drawings = draw(by_standard, result, clearance_range(by_standard))
    return {
        "name": plain_text(result.name),
        "verdict": judge.verdict(result).value,
        "method": _method(result),
        "outcome": _outcome(result),
        "heading": "Operating point" if is_film(result) else "Results",
        "results": _key_results(result) if solved else [],
        "inputs": [
            {"title": group.title, "rows": [vars(row) for row in group.rows]}
            for group in (inputs(case) if case is not None else ())
        ],
        "assumptions": list(dict.fromkeys(plain_text(said) for said in result.assumptions)),
        "sections": [
            {
                "title": section.title,
                "remark": section.remark,
                "lines": [_line(line) for line in section.lines],
            }
            for section in (calculation(by_standard, result) if by_standard is not None else ())
        ],
        "checks": [check_content(check, sources) for check in result.checks] if solved else [],
        "sources": sources,
        "warnings": [
            {
                "code": notice.code,
                "title": EXPLANATIONS[notice.code].title,
                "message": plain_text(notice.message),
                "meaning": EXPLANATIONS[notice.code].meaning,
                "remedy": EXPLANATIONS[notice.code].remedy,
            }
            for notice in result.warnings
        ],
        "figures": [
            {"name": drawing.name, "caption": drawing.caption, "svg": drawing.image.decode()}
            for drawing in drawings
        ],
    }


def _method(result: Result) -> str:
    return {"iso7902": "ISO 7902", "film": "Film in two dimensions", "statics": "Statics of the shaft"}.get(
        result.method, plain_text(result.method)
    )


def _outcome(result: Result) -> Data | None:
    if result.outcome.solved:
        return None
    explanation = EXPLANATIONS.get(result.outcome.code)
    message = plain_text(result.message).removesuffix(".")
    return {
        "code": result.outcome.code,
        "title": result.outcome.value,
        "message": message[:1].upper() + message[1:],
        "remedy": explanation.remedy if explanation else "",
    }


def _key_results(result: Result) -> list[Data]:
    film = "minimum_film_thickness" in result.values
    names = KEY_RESULTS if film else [name for name in result.values if name not in NOT_FOR_PAPER]
    rows = []
    for name in names:
        value = result.values.get(name, math.nan)
        if name in QUANTITIES and math.isfinite(value):
            quantity = QUANTITIES[name]
            rows.append(
                {
                    "label": label(name),
                    "symbol": symbol_node(quantity.symbol),
                    "value": quantity.format(value),
                    "unit": quantity.display.label,
                }
            )
    return rows


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


def check_content(check: Check, sources: Sequence[str] = ()) -> Data:
    """One check; its source as the place in a list of `sources`, counted from 1."""
    quantity = QUANTITIES.get(check.quantity)
    return {
        "code": check.code,
        "quantity": label(check.quantity),
        "symbol": symbol_node(quantity.symbol) if quantity else None,
        "value": judge.written(check.quantity, check.value),
        "sign": "≤" if check.bound is Bound.AT_MOST else "≥",
        "limit": judge.written(check.quantity, check.limit),
        "margin": judge.margin(check).replace("-", "−"),
        "verdict": judge.check_verdict(check).value,
        "advisory": check.advisory,
        "source": str(1 + sources.index(plain_text(check.source))) if sources else "",
    }
