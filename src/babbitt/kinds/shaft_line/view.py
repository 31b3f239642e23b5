"""How the solutions of shaft lines are shown."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from babbitt.case.parts.uniform_piece import MATERIAL
from babbitt.core.kind import LazyFunction
from babbitt.kinds.shaft_line.report.citations import SIDORIKA, WITTRICK
from babbitt.kinds.thrust.report.columns import COLUMNS
from babbitt.kinds.thrust.view import LEFT_OUT
from babbitt.report.citations import REYNOLDS
from babbitt.report.view import View, lubricant_of

if TYPE_CHECKING:
    from babbitt.kinds.shaft_line.design import LineDesign
    from babbitt.report.inputs import InputGroup

__all__ = ["FREQUENCY_DOMAIN"]


def _inputs(problem: LineDesign) -> Iterable[InputGroup]:
    from babbitt.kinds.thrust.report.inputs import thrust_inputs

    return thrust_inputs(problem.thrust)


def _citations(_: LineDesign) -> tuple[str, ...]:
    return (REYNOLDS, SIDORIKA, WITTRICK)


FIGURES = LazyFunction("babbitt.kinds.shaft_line.report.figures:line_figures")

LEFT_OUT_OF_LINE = {
    **LEFT_OUT,
    **MATERIAL,
    "Propeller": ("propeller",),
    "Damping of the propeller": ("propeller.damping",),
    "Seating": ("seating",),
    "Mass of the housing": ("seating.housing_mass",),
    "Damping of the seating": ("seating.damping",),
    "Mass of a pad": ("pads.mass",),
    "Inertias of a pad": ("pads.inertia_radial", "pads.inertia_along"),
    "Thrust ripple": ("ripple",),
    "Phase of the thrust ripple": ("ripple.phase",),
}
"""Inputs that a case may leave out (`babbitt.report.view.View`)."""

FREQUENCY_DOMAIN = View(
    title="Static films, vibration in the frequency domain",
    inputs=_inputs,
    left_out=LEFT_OUT_OF_LINE,
    sections=LazyFunction("babbitt.kinds.thrust.report.calculation:line_calculation"),
    figures=FIGURES,
    report_figures=FIGURES,
    tables=LazyFunction("babbitt.kinds.thrust.report.tables:tables"),
    sentences=LazyFunction("babbitt.kinds.thrust.report.sentences:answers"),
    columns=COLUMNS,
    sweep=(
        "dynamic_minimum_film",
        "loss_mean_bound",
        "natural_frequency_1",
        "unload_margin_bound",
        "frequency_separation",
        "minimum_film_thickness",
        "axial_stiffness",
    ),
    citations=_citations,
    oil=lubricant_of,
    picture=LazyFunction("babbitt.kinds.shaft_line.report.picture:line_picture"),
)
