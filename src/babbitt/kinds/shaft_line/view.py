"""How the solutions of shaft lines are shown."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from babbitt.core.solution import Solution
from babbitt.kinds.shaft_line.report.citations import SIDORIKA, WITTRICK
from babbitt.kinds.thrust.report.columns import COLUMNS
from babbitt.kinds.thrust.view import sentences_of, tables_of
from babbitt.report.citations import REYNOLDS
from babbitt.report.view import View

if TYPE_CHECKING:
    from babbitt.kinds.shaft_line.design import LineDesign
    from babbitt.properties.lubricants import Lubricant
    from babbitt.report.drawing import Drawing
    from babbitt.report.inputs import InputGroup

__all__ = ["FREQUENCY_DOMAIN"]


def _inputs(problem: LineDesign) -> Iterable[InputGroup]:
    from babbitt.kinds.thrust.report.inputs import thrust_inputs

    return thrust_inputs(problem.thrust)


def _figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    from babbitt.kinds.shaft_line.report.figures import line_figures

    return line_figures(solution, image_format)


def _citations(_: LineDesign) -> tuple[str, ...]:
    return (REYNOLDS, SIDORIKA, WITTRICK)


def _oil(problem: LineDesign) -> Lubricant:
    return problem.lubricant


FREQUENCY_DOMAIN = View(
    title="Static films, vibration in the frequency domain",
    inputs=_inputs,
    figures=_figures,
    report_figures=_figures,
    tables=tables_of,
    sentences=sentences_of,
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
    oil=_oil,
)
