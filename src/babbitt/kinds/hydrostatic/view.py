"""How the solutions of hydrostatic bearings and jacking pockets are shown."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from babbitt.core.kind import LazyFunction
from babbitt.core.solution import Solution
from babbitt.kinds.hydrostatic.report.columns import COLUMNS
from babbitt.kinds.hydrostatic.report.result_rows import recess_rows
from babbitt.report.citations import REYNOLDS
from babbitt.report.view import View

if TYPE_CHECKING:
    from babbitt.kinds.hydrostatic.jacking_model import JackingCase
    from babbitt.kinds.hydrostatic.model import HydrostaticCase
    from babbitt.properties.lubricants import Lubricant
    from babbitt.report.inputs import InputGroup
    from babbitt.report.line import Section

__all__ = ["FILM", "JACKING_FILM", "JACKING_QUICK", "QUICK"]


def _inputs(problem: HydrostaticCase | JackingCase) -> Iterable[InputGroup]:
    from babbitt.kinds.hydrostatic.report.inputs import groups
    from babbitt.report.inputs import groups_in_words

    return groups_in_words(groups(problem))


def _sections(solution: Solution) -> tuple[Section, ...]:
    from babbitt.kinds.hydrostatic.report.calculation import hydrostatic_calculation

    return hydrostatic_calculation(solution.problem, solution.result)


def _citations(_: object) -> tuple[str, ...]:
    return (REYNOLDS,)


def _oil(problem: HydrostaticCase) -> Lubricant | None:
    return problem.oil.lubricant


LEFT_OUT = {
    "Middles of the recesses": ("recesses.first", "recesses.angles", "pockets.first", "pockets.angles"),
    "Density": ("oil.density",),
    "Specific heat": ("oil.heat_capacity",),
    "Efficiency of the pump": ("supply.pump_efficiency", "pump_efficiency"),
    "Leakage of the pump": ("supply.leakage",),
    "Friction factor in the recesses": ("recess_oil.friction_factor",),
    "Bulk modulus of the oil": ("recess_oil.bulk_modulus",),
    "Composite roughness height": ("roughness",),
    "Film": ("method",),
    "Grid": ("accuracy",),
}
"""Inputs that a case may leave out (`babbitt.report.view.View`)."""

FIGURES = LazyFunction("babbitt.kinds.hydrostatic.report.figures:hydrostatic_figures")

JACKING_FILM = View(
    title="Film in two dimensions",
    rows=recess_rows,
    inputs=_inputs,
    left_out=LEFT_OUT,
    sections=_sections,
    figures=FIGURES,
    report_figures=FIGURES,
    columns=COLUMNS,
    citations=_citations,
    picture=LazyFunction("babbitt.kinds.hydrostatic.report.picture_journal:jacking_picture"),
)
JACKING_QUICK = replace(JACKING_FILM, title="Closed forms")
PICTURE = LazyFunction("babbitt.kinds.hydrostatic.report.picture:recess_picture")
FILM = replace(JACKING_FILM, oil=_oil, picture=PICTURE)
QUICK = replace(JACKING_QUICK, oil=_oil, picture=PICTURE)
