"""How a plane slider is shown."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from babbitt.core.quantities.quantity import quantity
from babbitt.report.columns import column_of
from babbitt.report.inputs import InputGroup, Row
from babbitt.report.view import View
from plane_slider.method import Slider

QUANTITIES = (quantity("film_ratio", "a", "1", "", 4, "Film thickness at the inlet over that at the outlet"),)


def inputs(problem: Slider) -> Iterator[InputGroup]:
    """Dimensions and operation."""
    yield InputGroup("Geometry", (Row("Length", f"{1e3 * problem.length:.4g}", None, "mm"),))
    yield InputGroup("Operation", (Row("Speed of the runner", f"{problem.speed:.4g}", None, "m/s"),))


CLOSED_FORM = View(
    title="Closed form of the infinitely wide slider",
    inputs=inputs,
    columns=(column_of("minimum_film_thickness", 0), column_of("load", 1), column_of("film_ratio", 2)),
)

QUADRATURE = replace(CLOSED_FORM, title="Trapezoidal rule over the infinitely wide slider")
