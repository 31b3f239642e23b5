"""Figures of a shaft: its drawing with loads, shear, bending moment and torque, deflection and slope."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.solution import Solution
from babbitt.kinds.shaft.answer import ShaftAnswer
from babbitt.kinds.shaft.model import Array
from babbitt.kinds.shaft.problem import ShaftProblem
from babbitt.kinds.shaft.report.side_view import side_views
from babbitt.report.drawing import GREY, INK, Drawing, Sheet, limit_line, rendered, style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["shaft_figures"]

PLANES = (("x", "--"), ("y", "-"))
"""Planes and how their curves are drawn."""
PLACE = "place along the shaft in mm"


def shaft_figures(solution: Solution, image_format: str = "svg") -> tuple[Drawing, ...]:
    """Every figure of a solved shaft.

    Parameters
    ----------
    solution : Solution
        Of a shaft.
    image_format : {"svg", "pdf", "png"}
    """
    with style():
        painted = _figures(solution.problem, solution.state)
        return tuple(
            Drawing(name, caption, rendered(figure, image_format), True) for name, caption, figure in painted
        )


def _figures(problem: ShaftProblem, answer: ShaftAnswer) -> Iterator[tuple[str, str, Figure]]:
    yield (
        "shaft",
        "The shaft from the side (above, y upward) and from above (below, x upward on the page), diameters "
        "enlarged. Arrows: forces on the shaft in kN, black of what loads it, grey of the bearings; the longest "
        "is the largest. Horizontal arrows: thrust.",
        side_views(problem, answer),
    )
    yield (
        "shear-and-moment",
        "Shear force, bending moment and torque along the shaft in the planes z-y (full) and z-x (broken); grey: "
        "size of both. Dotted: bearings.",
        shear_and_moment(answer),
    )
    if answer.bends:
        yield (
            "deflection",
            "Deflection and slope of the shaft in the planes z-y (full) and z-x (broken); grey: size of both. "
            "Dotted: bearings.",
            deflection(problem, answer),
        )


def shear_and_moment(answer: ShaftAnswer) -> Figure:
    """Shear, moment and torque over the place."""
    figure, ((above,), (middle,), (below,)) = Sheet(166.0, 100.0, rows=3, left=16.0).panels(sharex=True)
    places = 1e3 * answer.curves.stations
    _both(above, places, 1e-3 * answer.curves.shear, steps=True)
    _both(middle, places, 1e-3 * answer.curves.moment)
    below.step(places, 1e-3 * answer.torque(), where="post", color=INK, linewidth=1.1)
    for panel, name in ((above, "shear in kN"), (middle, "moment in kN m"), (below, "torque in kN m")):
        panel.set_ylabel(name)
    _bearings(answer, (above, middle, below))
    _named(above)
    return figure


def deflection(problem: ShaftProblem, answer: ShaftAnswer) -> Figure:
    """Deflection and slope over the place."""
    figure, ((above,), (below,)) = Sheet(166.0, 76.0, rows=2, left=16.0).panels(sharex=True)
    places = 1e3 * answer.curves.stations
    _both(above, places, 1e6 * answer.curves.deflection)
    _both(below, places, 1e3 * answer.curves.slope)
    for panel, limit, scale in ((above, problem.limits.deflection, 1e6), (below, problem.limits.slope, 1e3)):
        if limit is not None and scale * limit < 3.0 * panel.get_ylim()[1]:
            limit_line(panel, scale * limit, "permissible")
    above.set_ylabel("deflection in µm")
    below.set_ylabel("slope in mm/m")
    _bearings(answer, (above, below))
    _named(above)
    return figure


def _both(panel: Axes, places: Array, curves: Array, *, steps: bool = False) -> None:
    drawn = "steps-post" if steps else "default"
    size = np.hypot(curves[:, 0], curves[:, 1])
    panel.plot(places, size, color=GREY, linewidth=0.7, drawstyle=drawn, label="size", zorder=1)
    for (name, dashes), values in zip(PLANES, curves.T, strict=True):
        panel.plot(places, values, dashes, color=INK, linewidth=1.0, drawstyle=drawn, label=f"z-{name}")
    panel.axhline(0.0, color=INK, linewidth=0.4)


def _named(panel: Axes) -> None:
    """Names of the curves, on white where nothing else leaves room."""
    panel.legend(
        fontsize=7, loc="best", ncols=3, handlelength=2.4, edgecolor="none", facecolor="white", framealpha=0.9
    )


def _bearings(answer: ShaftAnswer, panels: tuple[Axes, ...]) -> None:
    for panel in panels:
        for one in answer.shaft.supports:
            panel.axvline(1e3 * one.station, color=GREY, linestyle=":", linewidth=0.7, zorder=0)
    places = 1e3 * answer.curves.stations
    panels[-1].set_xlim(places[0], places[-1])
    panels[-1].set_xlabel(PLACE)
