"""Pressure over the pads, unrolled, with the gaps between them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.report.drawing import GREY, INK, Array, Sheet
from babbitt.report.shading import point, round_steps
from babbitt.report.us_words import numbers_in_us_units
from babbitt.reynolds.tilting_pads.pad_lands import pad_gaps
from babbitt.reynolds.tilting_pads.solution import PadState, TiltingPadSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["AROUND", "angle_ticks", "draw_gaps", "draw_pressure", "over_width", "pressure_map", "seam", "unrolled"]

AROUND = "θ in °, counter-clockwise from $+x$"

ACROSS = 41
"""Places over the width at which a map is drawn."""


def pressure_map(case: PadCase, solution: TiltingPadSolution) -> Figure:
    """Contours of pressure over angle and width; between the pads nothing is drawn."""
    figure, ((panel,),) = Sheet(166.0, 58.0, left=12.0).panels()
    figure.subplots_adjust(top=1.0 - 6.0 / 58.0)
    draw_pressure(panel, case, solution)
    return figure


def draw_pressure(panel: Axes, case: PadCase, solution: TiltingPadSolution) -> None:
    """The same on axes that are given."""
    start = seam(case, solution)
    highest = 1e-6 * solution.maximum_pressure
    levels = np.array(round_steps(0.0, 0.98 * highest, 8))
    for number, state in enumerate(solution.pads, 1):
        _pad(panel, state, number, start, levels, highest)
        pivot = math.degrees(start + (case.bearing.pads[number - 1].pivot_angle - start) % math.tau)
        panel.plot([pivot], [0.0], "o", color=INK, markerfacecolor="white", markersize=3.5, zorder=6)
    panel.set_xlim(math.degrees(start), math.degrees(start) + 360.0)
    angle_ticks(panel)
    panel.set(xlabel=AROUND, ylabel="$z$ in mm")
    load = math.atan2(-float(solution.force[1]), -float(solution.force[0]))
    at = math.degrees(start + (load - start) % math.tau)
    panel.axvline(at, color=GREY, linewidth=0.8, linestyle=(0, (6, 2, 1, 2)), zorder=3)
    above: dict[str, Any] = {
        "xycoords": panel.get_xaxis_transform(),
        "textcoords": "offset points",
        "annotation_clip": False,
    }
    panel.annotate("load", (at, 1.0), xytext=(0, 1), fontsize=7, ha="center", va="bottom", color="0.3", **above)
    says: dict[str, Any] = {
        "xycoords": "axes fraction",
        "textcoords": "offset points",
        "xytext": (0, 1.5),
        "fontsize": 7.5,
    }
    panel.annotate("pressure in MPa", (0.0, 1.0), va="bottom", annotation_clip=False, **says)
    text = "rotation →" if case.sense > 0.0 else "← rotation"
    panel.annotate(text, (1.0, 1.0), ha="right", va="bottom", annotation_clip=False, **says)


def draw_gaps(panel: Axes, case: PadCase, solution: TiltingPadSolution) -> None:
    """Film thickness of every pad over the angle, and its pivot."""
    start = seam(case, solution)
    for number, (state, gap) in enumerate(zip(solution.pads, pad_gaps(solution), strict=True), 1):
        theta, order = unrolled(state, start)
        carries = state.load > 0.0
        panel.plot(theta, 1e6 * gap[order], color=INK if carries else GREY, linewidth=1.0,
                   linestyle="-" if carries else (0, (5, 2)))  # fmt: skip
        pivot = math.degrees(start + (case.bearing.pads[number - 1].pivot_angle - start) % math.tau)
        at_pivot = float(np.interp(pivot, theta, 1e6 * gap[order]))
        panel.plot([pivot], [at_pivot], "o", color=INK, markerfacecolor="white", markersize=3.5, zorder=6)
        panel.annotate(f"{number}", (pivot, at_pivot), xytext=(0, 4), textcoords="offset points", fontsize=7,
                       ha="center")  # fmt: skip
    panel.set_xlim(math.degrees(start), math.degrees(start) + 360.0)
    panel.set_ylim(bottom=0.0)
    angle_ticks(panel)
    panel.set(xlabel=AROUND, ylabel="$h$ in µm")


def unrolled(state: PadState, start: float) -> tuple[Array, NDArray[np.intp]]:
    """Rising angles in degrees of the lines of a pad in a map that begins at an angle in rad, and their order."""
    order = np.argsort(state.angles)
    angles = state.angles[order]
    moved = start + (float(angles[0]) - start) % math.tau - float(angles[0])
    return np.degrees(angles + moved), order


def seam(case: PadCase, solution: TiltingPadSolution) -> float:
    """Angle in rad at which the map begins: in the gap between pads that lies farthest from the load."""
    load = math.atan2(-float(solution.force[1]), -float(solution.force[0]))
    edges = sorted((solution.bearing.edges(pad) for pad in case.bearing.pads), key=lambda edge: edge[0] % math.tau)
    gaps = []
    for (_, end), (begin, _) in zip(edges, [*edges[1:], edges[0]], strict=True):
        gaps.append(end + 0.5 * ((begin - end) % math.tau))
    return min(gaps, key=lambda angle: math.cos(angle - load))


def over_width(state: PadState) -> tuple[Array, Array]:
    """Places over the whole width, m, and the pressure there, shape (lines, places): its even polynomial."""
    z = np.asarray(state.axial_positions)
    half = float(z.max())
    places = np.linspace(-half, half, ACROSS)
    coefficients = np.polyfit((z / half) ** 2, state.pressure.T, z.size - 1)
    pressure = np.array([np.polyval(one, (places / half) ** 2) for one in coefficients.T])
    return places, np.clip(pressure, 0.0, None)


def _pad(panel: Axes, state: PadState, number: int, start: float, levels: Array, highest: float) -> None:
    from matplotlib.patches import Rectangle

    places, pressure = over_width(state)
    theta, order = unrolled(state, start)
    shown, z = 1e-6 * pressure[order], 1e3 * places
    corner = (theta[0], z[0])
    unloaded = not state.load > 0.0
    panel.add_patch(Rectangle(corner, theta[-1] - theta[0], z[-1] - z[0], facecolor="none", edgecolor=INK,
                              linewidth=0.8, zorder=4))  # fmt: skip
    panel.annotate(f"{number}", corner, xytext=(3, 3), textcoords="offset points", fontsize=7, zorder=6)
    if unloaded or levels.size == 0:
        panel.annotate(
            "unloaded", (0.5 * (theta[0] + theta[-1]), 0.25 * z[-1]), fontsize=7, ha="center", color="0.3"
        )
        return
    shades = [str(round(1.0 - 0.42 * place / levels.size, 3)) for place in range(levels.size)]
    if float(shown.max()) > levels[0]:
        panel.contourf(theta, z, shown.T, levels=[*levels, 1.01 * max(highest, levels[-1])], colors=shades)
        lines = panel.contour(theta, z, shown.T, levels=levels, colors="0.25", linewidths=0.45)
        panel.clabel(lines, np.asarray(lines.levels)[1::2], fontsize=6, fmt="%g", inline_spacing=2)
    row, column = np.unravel_index(int(shown.argmax()), shown.shape)
    point(panel, float(theta[row]), float(z[column]), numbers_in_us_units(f"{float(shown.max()):.3g}", "MPa"))


def angle_ticks(panel: Axes) -> None:
    """Angles every 45 degrees, within a turn."""
    from matplotlib.ticker import FuncFormatter, MultipleLocator

    panel.xaxis.set_major_locator(MultipleLocator(45.0))
    panel.xaxis.set_major_formatter(FuncFormatter(lambda angle, _: f"{round(angle) % 360}"))
