"""How the solutions of thrust bearings are shown."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from babbitt.core.result import Result
from babbitt.core.solution import Solution
from babbitt.kinds.thrust.report.columns import COLUMNS
from babbitt.report.citations import REYNOLDS
from babbitt.report.view import View

if TYPE_CHECKING:
    from babbitt.kinds.thrust.design import ThrustDesign
    from babbitt.properties.lubricants import Lubricant
    from babbitt.report.drawing import Drawing
    from babbitt.report.inputs import InputGroup

__all__ = ["FILM", "sentences_of", "tables_of"]


def _inputs(problem: ThrustDesign) -> Iterable[InputGroup]:
    from babbitt.kinds.thrust.report.inputs import thrust_inputs

    return thrust_inputs(problem)


def _figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    from babbitt.kinds.thrust.report.figures import thrust_figures

    return thrust_figures(solution, image_format)


def tables_of(result: Result) -> list[dict[str, Any]]:
    """Tables of pads, and of modes and rings of a line."""
    from babbitt.kinds.thrust.report.tables import tables

    return tables(result)


def sentences_of(result: Result) -> tuple[str, ...]:
    """What a surveyor asks, answered in sentences."""
    from babbitt.kinds.thrust.report.sentences import answers

    return answers(result)


def _citations(problem: ThrustDesign) -> Iterable[str]:
    yield REYNOLDS
    if problem.turbulence is not None:
        yield problem.turbulence.source


def _oil(problem: ThrustDesign) -> Lubricant:
    return problem.lubricant


FILM = View(
    title="Film in two dimensions",
    inputs=_inputs,
    figures=_figures,
    report_figures=_figures,
    tables=tables_of,
    sentences=sentences_of,
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
    oil=_oil,
)
