"""The drawing of a shaft in two planes, with everything that acts on it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.quantities.display import SI, in_system
from babbitt.kinds.shaft.answer import ShaftAnswer
from babbitt.kinds.shaft.model import PointLoad, Shaft
from babbitt.kinds.shaft.problem import ShaftProblem
from babbitt.report.drawing import GREY, INK, PALE, Sheet, arrow

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["GEAR_WIDTH", "diameter_at", "own_weight", "side_views"]

BODY = 0.34
"""Half height of the largest body in a panel whose arrows reach to 1."""
LETTER = 0.0085
"""Width of a letter over that of the panel."""
SHORTEST = 0.04
"""Share of the largest force below which no arrow is drawn."""
GEAR_WIDTH = 0.022
"""Half width of a gear over the length of the shaft, whose face is not known."""


def side_views(problem: ShaftProblem, answer: ShaftAnswer) -> Figure:
    """The shaft in the planes z-y and z-x."""
    figure, ((side,), (top,)) = Sheet(166.0, 112.0, rows=2, left=10.0, between=3.0).panels(sharex=True)
    acting = (*problem.shaft.loads, *own_weight(problem.shaft))
    reactions = [one for one in answer.reactions() if any(one.force)]
    largest = max((float(np.abs(one.force).max()) for one in (*acting, *reactions)), default=0.0) or 1.0
    for panel, axis, name in ((side, 1, "y"), (top, 0, "x")):
        _bodies(panel, problem, answer)
        _arrows(panel, acting, axis, largest, answer, INK)
        _arrows(panel, reactions, axis, largest, answer, GREY)
        panel.set_ylim(-1.3, 1.3)
        panel.set_yticks([])
        panel.set_ylabel(name, rotation=0)
        panel.spines["left"].set_visible(False)
    low, high = 1e3 * answer.curves.stations[[0, -1]]
    top.set_xlim(low - 0.13 * (high - low), high + 0.13 * (high - low))
    top.set_xlabel("place along the shaft in mm")
    _names(side, [(one.station, one.name) for one in problem.shaft.supports], -1.28, 0.17)
    _names(side, [(gear.station, gear.name) for gear in problem.gears], 1.28, -0.17)
    return figure


def _names(panel: Axes, named: Sequence[tuple[float, str]], level: float, step: float) -> None:
    """Names at their places, one level further in where two would meet."""
    low, high = panel.get_xlim()
    before, steps = -math.inf, 0
    for station, name in sorted(named):
        place = (1e3 * station - low) / (high - low)
        half = 0.5 * LETTER * len(name)
        steps = steps + 1 if place - half < before else 0
        before = max(before, place + half)
        panel.annotate(
            name, (1e3 * station, level + steps * step), ha="center", va="bottom" if step > 0.0 else "top",
            fontsize=7, annotation_clip=False,
        )  # fmt: skip


def own_weight(shaft: Shaft) -> tuple[PointLoad, ...]:
    """The weight of all pieces in their common centre."""
    weights = shaft.weights()
    total = sum(one.force[1] for one in weights)
    if total == 0.0:
        return ()
    centre = sum(one.station * one.force[1] for one in weights) / total
    return (PointLoad("Shaft", centre, (0.0, total, 0.0)),)


def _bodies(panel: Axes, problem: ShaftProblem, answer: ShaftAnswer) -> None:
    """Pieces, gears and bearings, as high as their diameters."""
    shaft, length = problem.shaft, float(np.ptp(answer.curves.stations))
    diameters = [piece.diameter for piece in shaft.pieces] + [gear.diameter for gear in problem.gears]
    scale = 2.0 * BODY / max(diameters, default=1.0)
    for start, piece in zip(shaft.ends, shaft.pieces, strict=False):
        _box(panel, start, piece.length, scale * piece.diameter, "0.93")
    if not shaft.pieces:
        panel.plot(1e3 * answer.curves.stations[[0, -1]], [0.0, 0.0], color=INK, linewidth=2.0)
    for gear in problem.gears:
        half = GEAR_WIDTH * length
        _box(panel, gear.station - half, 2.0 * half, scale * gear.diameter, PALE)
    panel.axhline(0.0, color=GREY, linewidth=0.5, linestyle=(0, (12, 3, 2, 3)))
    for one in shaft.supports:
        below = -0.5 * scale * diameter_at(shaft, one.station) - 0.045
        panel.plot([1e3 * one.station], [below], "^" if one.radial else "|", color=INK, markersize=5.0, zorder=4)


def diameter_at(shaft: Shaft, station: float) -> float:
    """Diameter of the piece at a station, m; zero for a shaft without pieces."""
    if not shaft.pieces:
        return 0.0
    piece = int(np.clip(np.searchsorted(shaft.ends, station, side="right") - 1, 0, len(shaft.pieces) - 1))
    return shaft.pieces[piece].diameter


def _box(panel: Axes, start: float, length: float, height: float, shade: str) -> None:
    from matplotlib.patches import Rectangle

    corner = (1e3 * start, -0.5 * height)
    panel.add_patch(Rectangle(corner, 1e3 * length, height, facecolor=shade, edgecolor=INK, linewidth=0.5))


def _arrows(
    panel: Axes, acting: Sequence[PointLoad], axis: int, largest: float, answer: ShaftAnswer, colour: str
) -> None:
    """Forces of one plane as arrows that point where they push, and thrusts along the axis."""
    reach = 1e3 * 0.1 * float(np.ptp(answer.curves.stations))
    for load in acting:
        across, place = load.force[axis] / largest, 1e3 * load.station
        if abs(across) > SHORTEST:
            arrow(panel, (place, 0.0), (place, -across), colour=colour)
            _number(panel, load.force[axis], (place, -across), (3, 2 if across < 0.0 else -7))
        if axis == 1 and abs(load.force[2]) > SHORTEST * largest:
            tip = (place + math.copysign(reach, load.force[2]), 0.0)
            arrow(panel, tip, (place, 0.0), colour=colour)
            _number(panel, load.force[2], tip, (3 if load.force[2] > 0.0 else -16, 3))


def _number(panel: Axes, force: float, at: tuple[float, float], apart: tuple[int, int]) -> None:
    """Size of a force in kN, or what stands for it, near the end of its arrow."""
    shown = abs(force) * in_system(SI["kN"]).scale
    panel.annotate(
        f"{float(f'{shown:.3g}'):g}", at, xytext=apart, textcoords="offset points", fontsize=7, zorder=7,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4, "alpha": 0.8},
    )  # fmt: skip
