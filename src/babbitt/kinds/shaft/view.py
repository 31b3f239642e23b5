"""How solved shafts are shown."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from babbitt.case.parts.uniform_piece import MATERIAL
from babbitt.core.kind import LazyFunction
from babbitt.core.solution import Solution
from babbitt.kinds.shaft.report.tables import tables
from babbitt.report.citations import REVERSE_GEAR
from babbitt.report.columns import column_of
from babbitt.report.view import View

if TYPE_CHECKING:
    from babbitt.kinds.shaft.overhung_coupling import CouplingProblem
    from babbitt.kinds.shaft.problem import ShaftProblem
    from babbitt.report.drawing import Drawing
    from babbitt.report.line import Section

GEARS = (
    "G. Niemann, H. Winter: Maschinenelemente, vol. 2, 2nd ed., Springer 1983 (forces on spur and helical gears)."
)

__all__ = ["BEAM", "OVERHUNG_COUPLING", "STATICS"]


def _coupling_citations(_: CouplingProblem) -> tuple[str, ...]:
    return (REVERSE_GEAR,)


def _citations(problem: ShaftProblem) -> tuple[str, ...]:
    return (GEARS,) if problem.gears else ()


def _sections(solution: Solution) -> Iterable[Section]:
    from babbitt.kinds.shaft.report.calculation import shaft_calculation

    return shaft_calculation(solution)


def _figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    from babbitt.kinds.shaft.report.figures import shaft_figures

    return shaft_figures(solution, image_format)


STATICS = View(
    title="Equilibrium of the rigid shaft",
    left_out={**MATERIAL, "Start of the first piece": ("start",)},
    sections=_sections,
    figures=_figures,
    report_figures=_figures,
    tables=tables,
    citations=_citations,
    columns=(column_of("largest_support_load", 0), column_of("axial_load", 1)),
    in_machine_table=False,
    sweep=("largest_support_load", "axial_load", "support_slope", "shaft_deflection", "bending_moment"),
    picture=LazyFunction("babbitt.kinds.shaft.report.picture:shaft_picture"),
)
BEAM = replace(STATICS, title="Stepped beam on its bearings")
OVERHUNG_COUPLING = View(
    title="Statics of the shaft",
    sweep=("reaction_1", "reaction_2", "reaction_angle_1", "reaction_angle_2", "coupling_arm"),
    citations=_coupling_citations,
    picture=LazyFunction("babbitt.kinds.shaft.report.picture:coupling_picture"),
)
