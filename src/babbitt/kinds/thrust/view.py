"""How the solutions of thrust bearings are shown."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from babbitt.core.kind import LazyFunction
from babbitt.kinds.thrust.report.columns import COLUMNS
from babbitt.report.citations import REYNOLDS
from babbitt.report.view import View, lubricant_of

if TYPE_CHECKING:
    from babbitt.kinds.thrust.design import ThrustDesign

__all__ = ["FILM", "LEFT_OUT"]


def _citations(problem: ThrustDesign) -> Iterable[str]:
    yield REYNOLDS
    if problem.turbulence is not None:
        yield problem.turbulence.source


FIGURES = LazyFunction("babbitt.kinds.thrust.report.figures:thrust_figures")

LEFT_OUT = {
    "Hot oil carried over": ("oil.carry_over",),
    "Temperature of the films": ("thermal",),
    "Backing ring": ("ring_stiffness",),
    "Crown": ("pads.crown",),
    "Runout of the collar": ("runout",),
    "Phase of the runout": ("runout.phase",),
}
"""Inputs that a case may leave out (`babbitt.report.view.View`)."""

FILM = View(
    title="Film in two dimensions",
    inputs=LazyFunction("babbitt.kinds.thrust.report.inputs:thrust_inputs"),
    left_out=LEFT_OUT,
    sections=LazyFunction("babbitt.kinds.thrust.report.calculation:thrust_calculation"),
    figures=FIGURES,
    report_figures=FIGURES,
    tables=LazyFunction("babbitt.kinds.thrust.report.tables:tables"),
    sentences=LazyFunction("babbitt.kinds.thrust.report.sentences:answers"),
    columns=COLUMNS,
    sweep=(
        "minimum_film_thickness",
        "friction_power",
        "outlet_temperature",
        "maximum_pressure",
        "total_flow",
        "axial_stiffness",
        "pad_load_ratio",
    ),
    citations=_citations,
    oil=lubricant_of,
    picture=LazyFunction("babbitt.kinds.thrust.report.picture:thrust_picture"),
)
