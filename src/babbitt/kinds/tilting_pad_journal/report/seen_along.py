"""The bearing seen along the shaft: pads and pivots to scale, films and ways of the pads enlarged, pressures."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.values import eccentricity_ratio
from babbitt.report.drawing import GREY, INK, Array, Sheet, arrow
from babbitt.reynolds.tilting_pads.pad_lands import pad_positions, tilted_land
from babbitt.reynolds.tilting_pads.solution import PadStatus, TiltingPadSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_along_shaft", "seen_along_shaft"]

FILM, PRESSURE, PIVOT = 0.24, 0.5, 0.09
"""Machined clearance, highest pressure and depth of a pivot as drawn, over the radius of the journal."""


def seen_along_shaft(case: PadCase, solution: TiltingPadSolution) -> Figure:
    """Journal among its pads; lengths of the films are drawn many times too large, all others to scale."""
    figure, ((panel,),) = Sheet(81.0, 76.0, left=2.0, bottom=2.0).panels()
    draw_along_shaft(panel, case, solution)
    return figure


def draw_along_shaft(panel: Axes, case: PadCase, solution: TiltingPadSolution) -> None:
    """The same on axes that are given."""
    from matplotlib.patches import Circle

    panel.set_aspect("equal")
    panel.axis("off")
    enlarged = FILM / case.bearing.pad_clearance
    deepest = max(pad.thickness for pad in case.bearing.pads) / solution.bearing.radius
    inner = 1.0 + FILM + deepest + PIVOT
    panel.add_patch(Circle((0.0, 0.0), inner, facecolor="none", edgecolor=INK, linewidth=0.7, zorder=1))
    for number in range(len(solution.pads)):
        _pad(panel, solution, number, enlarged, inner)
    _journal(panel, case, solution, enlarged)
    _load(panel, solution, enlarged)
    reach = inner + PRESSURE + 0.5
    panel.set(xlim=(-reach, reach), ylim=(-reach, reach))


def bore_of(solution: TiltingPadSolution, number: int, angles: Array, enlarged: float) -> Array:
    """Drawn radius of the bore of a pad at angles, rad."""
    pad = solution.bearing.pads[number]
    land = tilted_land(solution.bearing, pad, pad_positions(solution)[number])
    assert land.clearance is not None
    x, y = land.centre
    return np.asarray(1.0 + enlarged * (land.clearance + x * np.cos(angles) + y * np.sin(angles)))


def _pad(panel: Axes, solution: TiltingPadSolution, number: int, enlarged: float, inner: float) -> None:
    pad, state = solution.bearing.pads[number], solution.pads[number]
    angles = np.linspace(*solution.bearing.edges(pad), 61)
    bore = bore_of(solution, number, angles, enlarged)
    back = bore + pad.thickness / solution.bearing.radius
    c, s = np.cos(angles), np.sin(angles)
    outline = np.concatenate((bore * c, (back * c)[::-1])), np.concatenate((bore * s, (back * s)[::-1]))
    carries = state.status is not PadStatus.UNLOADED
    panel.fill(*outline, facecolor="0.88" if carries else "white", edgecolor=INK, linewidth=0.8, zorder=3)
    _pivot(panel, pad.pivot_angle, float(np.interp(pad.pivot_angle, angles, back)), inner)
    _pressure(panel, solution, number, inner)
    middle = 0.5 * (angles[0] + angles[-1])
    at = 0.5 * float(np.interp(middle, angles, bore) + np.interp(middle, angles, back))
    place = at * math.cos(middle), at * math.sin(middle)
    panel.annotate(f"{number + 1}", place, fontsize=7, ha="center", va="center", zorder=6)


def _pivot(panel: Axes, angle: float, back: float, inner: float) -> None:
    """A wedge between housing and pad, its tip on the pad."""
    wide = 0.5 * PIVOT / inner
    ends = [(inner, angle - wide), (back, angle), (inner, angle + wide)]
    x, y = zip(*((r * math.cos(a), r * math.sin(a)) for r, a in ends), strict=True)
    panel.fill(x, y, facecolor=INK, edgecolor=INK, linewidth=0.4, zorder=4)


def _pressure(panel: Axes, solution: TiltingPadSolution, number: int, inner: float) -> None:
    """Mid-plane pressure of a pad, outward from the housing, and its load."""
    state = solution.pads[number]
    highest = solution.maximum_pressure
    order = np.argsort(state.angles)
    angles, pressure = state.angles[order], np.maximum(state.pressure[order, 0], 0.0)
    middle = float(0.5 * (angles[0] + angles[-1]))
    top = 0.0
    if highest > 0.0 and state.load > 0.0:
        base, outer = inner + 0.02, inner + 0.02 + PRESSURE * pressure / highest
        c, s = np.cos(angles), np.sin(angles)
        around = np.concatenate((outer * c, (base * c)[::-1])), np.concatenate((outer * s, (base * s)[::-1]))
        panel.fill(*around, facecolor="0.8", edgecolor="0.2", linewidth=0.6, zorder=2)
        middle = float(angles[pressure.argmax()])
        top = PRESSURE * float(pressure.max()) / highest
    out = inner + top + 0.16
    said = f"{1e-3 * state.load:.3g} kN" if state.load > 0.0 else "unloaded"
    x, y = out * math.cos(middle), out * math.sin(middle)
    panel.annotate(
        said, (x, y), fontsize=7, ha="center" if abs(x) < 0.35 * out else "left" if x > 0.0 else "right",
        va="center", zorder=6, color=INK if state.load > 0.0 else GREY,
    )  # fmt: skip


def _journal(panel: Axes, case: PadCase, solution: TiltingPadSolution, enlarged: float) -> None:
    from matplotlib.patches import Circle

    x, y = enlarged * solution.position
    panel.add_patch(Circle((x, y), 1.0, facecolor="white", edgecolor=INK, linewidth=0.9, zorder=4))
    panel.plot([0.0], [0.0], "+", color=GREY, markersize=6, markeredgewidth=0.8, zorder=6)
    panel.plot([x], [y], "o", color=INK, markersize=3, zorder=6)
    ratio = eccentricity_ratio(case, solution)
    panel.annotate(
        f"$ε$ = {ratio:.3f}", (x, y), xytext=(0, 10), textcoords="offset points", fontsize=7,
        ha="center", va="bottom", zorder=7,
    )  # fmt: skip
    turn = 0.5 * math.pi + case.sense * np.linspace(-0.5, 0.5, 25)
    radius = 0.72
    panel.plot(x + radius * np.cos(turn), y + radius * np.sin(turn), color=INK, linewidth=0.7, zorder=5)
    tip, tail = ((x + radius * math.cos(a), y + radius * math.sin(a)) for a in (turn[-1], turn[-3]))
    arrow(panel, tip, tail, size=6.0)


def _load(panel: Axes, solution: TiltingPadSolution, enlarged: float) -> None:
    """The load as an arrow within the journal, from its centre on."""
    angle = math.atan2(-float(solution.force[1]), -float(solution.force[0]))
    x, y = enlarged * solution.position
    c, s = math.cos(angle), math.sin(angle)
    arrow(panel, (x + 0.52 * c, y + 0.52 * s), (x + 0.08 * c, y + 0.08 * s), size=8.0)
    place = x + 0.74 * c, y + 0.74 * s
    panel.annotate(f"$F$ = {1e-3 * solution.load:.4g} kN", place, fontsize=7, ha="center", va="center", zorder=7)
