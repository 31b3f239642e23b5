"""The bearing seen along the shaft: mid-plane pressure on the bore, journal, load and attitude."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from babbitt.kinds.journal.film.field import FilmField, inside, step_patches, supply_patches
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.report.drawing import GREY, INK, Array, Sheet, arrow
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.surface.unwrapped_mesh import GROOVE_GAP, bore_gap

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

JOURNAL, PLAY, HIGHEST, DEEP = 1.0, 0.22, 0.85, 0.1
"""Radius of the journal, radial clearance, highest pressure and depth of a groove as drawn."""


def polar(case: FilmCase, solution: FilmSolution, field: FilmField) -> Figure:
    """Mid-plane pressure around the bore, the clearance enlarged."""
    figure, ((panel,),) = Sheet(81.0, 67.0, left=2.0, bottom=2.0).panels()
    seen_along_shaft(panel, case, solution, field)
    return figure


def seen_along_shaft(panel: Axes, case: FilmCase, solution: FilmSolution, field: FilmField) -> None:
    """The same on axes that are given."""
    panel.set_aspect("equal")
    panel.axis("off")
    edge = _bore(panel, solution, field)
    _pressure(panel, field, edge)
    _journal(panel, case, solution)
    aside = abs(
        math.cos(field.theta[field.mid_plane_pressure.argmax()])
    )  # the name of the highest pressure is wide
    reach = float(edge.max()) + HIGHEST + 0.25 + 0.25 * aside
    panel.set(xlim=(-reach, reach), ylim=(-reach, reach))
    _load(panel, case, solution, float(edge.max()) + 0.12)


def _bore(panel: Axes, solution: FilmSolution, field: FilmField) -> Array:
    """Draw the bore and return its drawn radius at the angles of the field: grooves and pockets are notches."""
    film = solution.film
    gap = bore_gap(film, field.theta)
    land = gap < 0.5 * GROOVE_GAP
    radius = JOURNAL + PLAY * np.interp(field.theta, field.theta[land], gap[land], period=2.0 * math.pi)
    for step in step_patches(film):
        if step.z[0] <= 0.0 <= step.z[1]:
            deeper = min(PLAY * step.depth / film.clearance, 0.8 * DEEP)
            radius = np.where(inside(field.theta, step.theta), radius + deeper, radius)
    panel.plot(radius * np.cos(field.theta), radius * np.sin(field.theta), color=INK, linewidth=0.9)
    for patch in supply_patches(film):
        if patch.z[0] <= 0.0 <= patch.z[1]:
            _notch(panel, field, radius, patch.theta)
    return np.asarray(radius)


def _notch(panel: Axes, field: FilmField, radius: Array, ends: tuple[float, float]) -> None:
    angles = np.linspace(*ends, 30)
    inner = np.interp(angles, field.theta, radius, period=2.0 * math.pi)
    outer = inner + DEEP
    x = np.concatenate((inner * np.cos(angles), (outer * np.cos(angles))[::-1]))
    y = np.concatenate((inner * np.sin(angles), (outer * np.sin(angles))[::-1]))
    panel.fill(x, y, facecolor="white", edgecolor=INK, linewidth=0.7, zorder=3)


def _pressure(panel: Axes, field: FilmField, radius: Array) -> None:
    pressure = field.mid_plane_pressure
    highest = float(pressure.max())
    if not highest > 0.0:
        return
    angles = np.linspace(field.theta[0], field.theta[-1], 721)
    height = HIGHEST * np.interp(angles, field.theta, np.maximum(pressure, 0.0)) / highest
    base = np.interp(angles, field.theta, radius)
    outer = base + height
    x, y = np.cos(angles), np.sin(angles)
    panel.fill(
        np.concatenate((base * x, (outer * x)[::-1])), np.concatenate((base * y, (outer * y)[::-1])),
        facecolor="0.85", edgecolor="none", zorder=1,
    )  # fmt: skip
    panel.plot(np.where(height > 1e-3, outer * x, np.nan), np.where(height > 1e-3, outer * y, np.nan), color="0.2",
               linewidth=0.8, zorder=2)  # fmt: skip
    for angle in (
        np.arange(math.ceil(field.theta[0] / 0.1745329), field.theta[-1] / 0.1745329) * 0.17453292519943295
    ):
        here = float(np.interp(angle, angles, height))
        low = float(np.interp(angle, angles, base))
        if here > 0.02:
            panel.plot([low * math.cos(angle), (low + here) * math.cos(angle)],
                       [low * math.sin(angle), (low + here) * math.sin(angle)],
                       color="0.55", linewidth=0.4, zorder=2)  # fmt: skip
    top = int(pressure.argmax())
    angle, out = field.theta[top], radius[top] + HIGHEST
    c, s = math.cos(angle), math.sin(angle)
    panel.annotate(
        f"{1e-6 * highest:.3g} MPa", (out * c, out * s), xytext=(11 * c, 6 * s), textcoords="offset points",
        fontsize=7, ha="center", va="center" if abs(s) < 0.3 else "bottom" if s > 0.0 else "top",
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5},
    )  # fmt: skip


def _journal(panel: Axes, case: FilmCase, solution: FilmSolution) -> None:
    """Journal at its place in the enlarged clearance, line of centres and attitude angle."""
    from matplotlib.patches import Arc, Circle

    x, y = PLAY * solution.position / solution.film.clearance
    panel.add_patch(Circle((x, y), JOURNAL, facecolor="0.96", edgecolor=INK, linewidth=0.9, zorder=4))
    panel.plot([0.0], [0.0], "+", color=GREY, markersize=6, markeredgewidth=0.8, zorder=6)
    panel.plot([x], [y], "o", color=INK, markersize=3, zorder=6)
    sense, towards, centres = case.rotation.sense, case.load_angle, math.atan2(y, x)
    reach = 0.8 * JOURNAL
    panel.plot(
        [0.0, reach * math.cos(centres)], [0.0, reach * math.sin(centres)], color=INK, linewidth=0.6, zorder=5
    )
    panel.plot([0.0, reach * math.cos(towards)], [0.0, reach * math.sin(towards)], color=GREY, linewidth=0.6,
               linestyle=(0, (6, 2, 1, 2)), zorder=5)  # fmt: skip
    first, last = sorted((towards, towards + sense * solution.attitude_angle))
    panel.add_patch(
        Arc((0.0, 0.0), 1.3, 1.3, theta1=math.degrees(first), theta2=math.degrees(last), linewidth=0.6, zorder=5)
    )
    beside = towards - sense * 0.95  # on the far side of the load line, where the arc is not
    panel.annotate(
        f"$β$ = {math.degrees(solution.attitude_angle):.1f}°", (0.53 * math.cos(beside), 0.53 * math.sin(beside)),
        fontsize=7, ha="center", va="center", zorder=7,
    )  # fmt: skip
    away = towards + math.pi
    panel.annotate(
        f"$ε$ = {solution.eccentricity_ratio:.3f}", (0.32 * math.cos(away), 0.32 * math.sin(away)), fontsize=7,
        ha="center", va="center", zorder=7,
    )  # fmt: skip
    _turning(panel, away, sense)


def _turning(panel: Axes, about: float, sense: float) -> None:
    """An arrow within the journal, in the sense of its rotation."""
    angles = about + sense * np.linspace(-0.55, 0.55, 25)
    radius = 0.72 * JOURNAL
    panel.plot(radius * np.cos(angles), radius * np.sin(angles), color=INK, linewidth=0.7, zorder=5)
    tip, tail = ((radius * math.cos(angle), radius * math.sin(angle)) for angle in (angles[-1], angles[-3]))
    arrow(panel, tip, tail, size=6.0)


def _load(panel: Axes, case: FilmCase, solution: FilmSolution, inner: float) -> None:
    """The load as an arrow onto the journal, from outside the bore."""
    away = case.load_angle + math.pi
    c, s = math.cos(away), math.sin(away)
    tail = inner + 0.62
    arrow(panel, (inner * c, inner * s), (tail * c, tail * s), size=8.0)
    level = abs(s) < 0.5  # then the text stands over the arrow and reaches inwards
    right = c < 0.0 if level else c > -0.35
    panel.annotate(
        f"$F$ = {1e-3 * solution.load:.4g} kN", (tail * c, tail * s),
        xytext=(0, 3) if level else (4 if right else -4, 0), textcoords="offset points",
        fontsize=7, va="bottom" if level else "center", ha="left" if right else "right",
    )  # fmt: skip
