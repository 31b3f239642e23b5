"""How the solutions of shaft lines are shown."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

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

FREQUENCY_DOMAIN = View(
    title="Static films, vibration in the frequency domain",
    inputs=_inputs,
    left_out=LEFT_OUT,
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
