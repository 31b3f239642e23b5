"""How the steady states of a footstep are shown."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING

from babbitt.core.kind import LazyFunction
from babbitt.core.solution import Solution
from babbitt.kinds.footstep.report.citations import KIRICHENKO
from babbitt.kinds.footstep.report.citations import NARROW_GROOVE as NARROW_GROOVE_THEORY
from babbitt.kinds.footstep.report.columns import COLUMNS
from babbitt.report.view import View

if TYPE_CHECKING:
    from babbitt.kinds.footstep.model_case import FootstepProblem
    from babbitt.report.drawing import Drawing
    from babbitt.report.inputs import InputGroup
    from babbitt.report.line import Section

__all__ = ["NARROW_GROOVE", "SUPERPOSITION"]


def _inputs(problem: FootstepProblem) -> Iterable[InputGroup]:
    from babbitt.kinds.footstep.report.inputs import heel_inputs
    from babbitt.report.inputs import groups_in_words

    return groups_in_words(heel_inputs(problem))


def _sections(solution: Solution) -> tuple[Section, ...]:
    from babbitt.kinds.footstep.report.calculation import heel_calculation

    return heel_calculation(solution.problem, solution.result)


def _figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    from babbitt.kinds.footstep.report.figures import heel_figures

    return heel_figures(solution.problem, solution.result, image_format)


def _alike(problem: FootstepProblem) -> FootstepProblem:
    return replace(problem, footstep=problem.smooth, other=None)


def _study(_: FootstepProblem) -> tuple[str, ...]:
    return (KIRICHENKO,)


def _narrow_groove(_: FootstepProblem) -> tuple[str, ...]:
    return (KIRICHENKO, NARROW_GROOVE_THEORY)


LEFT_OUT = {
    "Eccentricity over clearance at rim, outer end": ("eccentricity_ratio", "tilt"),
    "Density times heat capacity": ("oil.volumetric_heat_capacity",),
    "Density": ("oil.density",),
    "Pressure of the surroundings, absolute": ("ambient_pressure",),
    "Equations": ("method",),
    "Load counts": ("load_reference",),
    "Friction in the clearance": ("options.friction_viscosity",),
    "Face gap heats the oil": ("options.face_outlet",),
    "Viscosity of backflow": ("options.backflow_viscosity",),
}
"""Inputs that a case may leave out (`babbitt.report.view.View`)."""

SUPERPOSITION = View(
    title="Groove beside a slit (equations of the study, corrected)",
    inputs=_inputs,
    left_out=LEFT_OUT,
    sections=_sections,
    figures=_figures,
    report_figures=_figures,
    of_every_state=True,
    columns=COLUMNS,
    in_machine_table=False,
    state_table=LazyFunction("babbitt.kinds.footstep.report.table:heel_table"),
    alike=_alike,
    citations=_study,
    picture=LazyFunction("babbitt.kinds.footstep.report.picture:heel_picture"),
)

NARROW_GROOVE = replace(SUPERPOSITION, title="Narrow-groove theory", citations=_narrow_groove)
