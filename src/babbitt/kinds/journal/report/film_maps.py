"""Maps over the unrolled bore: pressure, film thickness, supplies, rupture; the pressure as a surface."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.quantities import QUANTITIES
from babbitt.kinds.journal.film.field import (
    FilmField,
    StepPatch,
    SupplyPatch,
    between,
    inside,
    step_patches,
    supply_patches,
)
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.report.drawing import GREY, INK, MILLIMETRE, Array, Sheet, in_engineers_unit
from babbitt.report.shading import point, round_steps
from babbitt.report.study_values import significant
from babbitt.reynolds.model import JournalFilm
from babbitt.reynolds.solution import FilmSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.contour import QuadContourSet
    from matplotlib.figure import Figure
    from matplotlib.patches import Rectangle

PRESSURE, GAP, LENGTH = (QUANTITIES[name] for name in ("maximum_pressure", "minimum_film_thickness", "width"))
"""In whose units pressures, gaps and places along the shaft are drawn."""

RUPTURED = 0.995
"""Liquid fraction below which the film is drawn as ruptured."""

AROUND = "θ in °, counter-clockwise from $+x$"
"""Label of the angle."""

WIDEST_LEVEL = 4.0
"""Gaps are distinguished up to this many radial clearances over the smallest."""

SURFACE_LINES = 91
"""Across the pressure surface."""


def unrolled(case: FilmCase, solution: FilmSolution, field: FilmField) -> Figure:
    """Pressure and film thickness over angle and width."""
    figure, axes = Sheet(166.0, 92.0, 2, 1, left=12.0, between=5.5).panels(sharex=True, sharey=True)
    figure.subplots_adjust(top=1.0 - 6.0 / 92.0)  # room for what stands above the upper panel
    top, bottom = axes[0][0], axes[1][0]
    pressure_map(top, case, solution, field)
    thickness_map(bottom, case, solution, field)
    bottom.set_xlabel(AROUND)
    rotation(top, case)
    return figure


def pressure_map(panel: Axes, case: FilmCase, solution: FilmSolution, field: FilmField) -> None:
    """Pressure over the unrolled bore, on axes that are given."""
    _pressure(panel, solution, field)
    _over_bore(panel, case, solution, field)
    says(panel, f"pressure in {PRESSURE.display.label}")


def thickness_map(panel: Axes, case: FilmCase, solution: FilmSolution, field: FilmField) -> None:
    """Film thickness over the unrolled bore, on axes that are given."""
    _thickness(panel, solution, field)
    _over_bore(panel, case, solution, field)
    _depths(panel, solution.film, field)
    says(panel, f"film thickness in {GAP.display.label}")


def _over_bore(panel: Axes, case: FilmCase, solution: FilmSolution, field: FilmField) -> None:
    dress(panel, case, solution, field)
    panel.set_ylabel(f"$z$ in {LENGTH.display.label}")
    degrees(panel, field)


def across(z: Array) -> Array:
    """Places along the shaft in the unit in which they are drawn."""
    return in_engineers_unit(LENGTH.name, z)


def _pressure_of(field: FilmField) -> Array:
    return in_engineers_unit(PRESSURE.name, field.pressure)


def surface(field: FilmField) -> Figure:
    """Pressure as a surface over the unrolled bore."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(130.0 * MILLIMETRE, 80.0 * MILLIMETRE))
    panel = figure.add_subplot(projection="3d")
    places, z = np.degrees(field.theta), across(field.z[::2])
    steps = np.linspace(places[0], places[-1], SURFACE_LINES)
    flanks = places[:-1][np.diff(places) < 1e-4]
    theta = np.unique(np.concatenate((steps, flanks, flanks + 2e-5)))
    pressure = np.array([np.interp(theta, places, row) for row in _pressure_of(field).T[::2]])
    panel.plot_surface(
        *np.meshgrid(theta, z), pressure, rstride=1, cstride=1, color="white", edgecolor="0.25", linewidth=0.25,
        shade=False, antialiased=True, clip_on=False,
    )  # fmt: skip
    degrees(panel, field)
    length, pressures = LENGTH.display.label, PRESSURE.display.label
    panel.set(xlabel="θ in °", ylabel=f"$z$ in {length}", zlabel=f"$p$ in {pressures}")
    panel.set_box_aspect((2.2, 1.0, 0.9), zoom=1.2)
    panel.view_init(elev=28.0, azim=-62.0)
    for axis in (panel.xaxis, panel.yaxis, panel.zaxis):
        axis.pane.set(facecolor="none", edgecolor="0.8")
        axis._axinfo["grid"].update(color="0.85", linewidth=0.3)
    figure.subplots_adjust(left=0.0, right=0.96, bottom=0.04, top=1.0)
    return figure


def degrees(panel: Axes, field: FilmField) -> None:
    """Angles on the axis, named within one turn."""
    from matplotlib.ticker import FuncFormatter, MultipleLocator

    panel.set_xlim(math.degrees(field.theta[0]), math.degrees(field.theta[-1]))
    panel.xaxis.set_major_locator(MultipleLocator(45.0))
    panel.xaxis.set_major_formatter(FuncFormatter(lambda angle, _: f"{round(angle) % 360}"))


def dress(panel: Axes, case: FilmCase, solution: FilmSolution, field: FilmField) -> None:
    """Rupture, steps, supplies and the load on an unrolled bore."""
    _ruptured(panel, field)
    _outlines(panel, solution.film, field)
    _supplies(panel, solution.film, field)
    load_line(panel, case)


def _pressure(panel: Axes, solution: FilmSolution, field: FilmField) -> None:
    shown = _pressure_of(field)
    highest = float(shown.max())
    if not highest > 0.0:
        return
    levels = np.array(round_steps(0.0, 0.98 * highest, 8))
    theta, z = np.degrees(field.theta), across(field.z)
    shades = [str(round(1.0 - 0.42 * place / levels.size, 3)) for place in range(levels.size)]
    panel.contourf(theta, z, shown.T, levels=[*levels, 1.01 * max(highest, levels[-1])], colors=shades)
    lines = panel.contour(theta, z, shown.T, levels=levels, colors="0.25", linewidths=0.45)
    level_names(panel, lines, solution.film, field)
    row, column = np.unravel_index(int(field.pressure.argmax()), field.pressure.shape)
    point(panel, theta[row], z[column], significant(highest, 3))


def level_names(panel: Axes, lines: QuadContourSet, film: JournalFilm, field: FilmField) -> None:
    """Name every second level where there is room: within the picture, beside grooves and pockets, once."""
    half, low, high = LENGTH.shown(float(field.z[-1])), math.degrees(field.theta[0]), math.degrees(field.theta[-1])
    for level, segments in list(zip(lines.levels, lines.allsegs, strict=True))[1::2]:
        places = np.concatenate([np.empty((0, 2)), *(np.asarray(line) for line in segments if len(line) > 1)])
        free = (np.abs(places[:, 1]) < 0.8 * half) & (places[:, 0] > low + 8.0) & (places[:, 0] < high - 8.0)
        for patch in supply_patches(film):
            first, last = np.degrees(patch.theta)
            around = np.remainder(places[:, 0] - first + 8.0, 360.0) < last - first + 16.0
            free &= ~(around & (places[:, 1] > LENGTH.shown(patch.z[0]) - 0.2 * half)
                      & (places[:, 1] < LENGTH.shown(patch.z[1]) + 0.2 * half))  # fmt: skip
        if free.any():
            kept = places[free]
            place = kept[np.abs(kept[:, 1] + 0.55 * half).argmin()]
            panel.clabel(lines, [level], fontsize=6, fmt="%g", inline_spacing=2, manual=[tuple(place)])


def _thickness(panel: Axes, solution: FilmSolution, field: FilmField) -> None:
    thickness = field.film_thickness.copy()
    for step in step_patches(solution.film):
        thickness[inside(field.theta, step.theta)[:, None] & between(field.z, step.z)[None, :]] = math.nan
    shown = np.ma.masked_invalid(in_engineers_unit(GAP.name, thickness))
    lowest, highest = float(shown.min()), float(shown.max())
    top = min(highest, lowest + WIDEST_LEVEL * GAP.shown(solution.film.clearance))
    levels = np.array(round_steps(lowest, top, 9))
    theta, z = np.degrees(field.theta), across(field.z)
    if levels.size:
        shades = [str(round(0.58 + 0.42 * place / levels.size, 3)) for place in range(levels.size + 1)]
        panel.contourf(
            theta, z, shown.T, levels=[0.0, *levels, max(1.01 * highest, 1.01 * levels[-1])], colors=shades
        )
        lines = panel.contour(theta, z, shown.T, levels=levels, colors="0.25", linewidths=0.45)
        level_names(panel, lines, solution.film, field)
    row, column = _thinnest(field)
    point(panel, theta[row], z[column], GAP.format(solution.minimum_film_thickness))


def _thinnest(field: FilmField) -> tuple[int, int]:
    """Place of the thinnest film; of equal ones that in the mid-plane."""
    gap = np.where(np.isnan(field.film_thickness), math.inf, field.film_thickness)
    row, column = np.unravel_index(int(gap.argmin()), gap.shape)
    middle = field.z.size // 2
    return int(row), middle if gap[row, middle] <= gap[row, column] * (1.0 + 1e-9) else int(column)


def _ruptured(panel: Axes, field: FilmField) -> None:
    """Hatch where the film is not full, and name it once."""
    if not (field.liquid_fraction < RUPTURED).any():
        return
    theta, z = np.degrees(field.theta), across(field.z)
    panel.contourf(theta, z, field.liquid_fraction.T, levels=[-1.0, RUPTURED], colors="none", hatches=["////"])
    panel.contour(theta, z, field.liquid_fraction.T, levels=[RUPTURED], colors=INK, linewidths=0.9,
                  linestyles="--")  # fmt: skip
    place = _largest_run(field.liquid_fraction[:, field.z.size // 2] < RUPTURED, theta)
    if place is not None:
        panel.annotate(
            "ruptured", (place, 0.0), ha="center", va="center", fontsize=7, zorder=5,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
        )  # fmt: skip


def _largest_run(there: Array | np.ndarray[tuple[int, ...], np.dtype[np.bool_]], places: Array) -> float | None:
    """Middle of the longest stretch that is there and wide enough for a word."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], there.astype(int), [0]))))
    runs = [(places[last - 1] - places[first], first, last) for first, last in edges.reshape(-1, 2)]
    width, first, last = max(runs, default=(0.0, 0, 1))
    return 0.5 * float(places[first] + places[last - 1]) if width > 25.0 else None


def _outlines(panel: Axes, film: JournalFilm, field: FilmField) -> None:
    """Outlines of the steps of the bore."""
    for patch in step_patches(film):
        for corner, width, height in _rectangles(patch, field):
            panel.add_patch(_rectangle(corner, width, height, "none"))


def _depths(panel: Axes, film: JournalFilm, field: FilmField) -> None:
    """How much thicker the film is over the steps, where its thickness is not drawn."""
    first, last = np.degrees(field.theta[[0, -1]])
    for patch in step_patches(film):
        for corner, width, height in _rectangles(patch, field):
            low, high = max(corner[0], first), min(corner[0] + width, last)
            if high - low > 24.0:
                panel.annotate(
                    f"{GAP.shown(patch.depth):+.4g}", (0.5 * (low + high), corner[1] + 0.5 * height), ha="center",
                    va="center", fontsize=7, zorder=5,
                )  # fmt: skip


def _supplies(panel: Axes, film: JournalFilm, field: FilmField) -> None:
    """Grooves, pockets and holes as white areas with an outline."""
    for patch in supply_patches(film):
        for corner, width, height in _rectangles(patch, field):
            panel.add_patch(_rectangle(corner, width, height, "white"))


def _rectangle(corner: tuple[float, float], width: float, height: float, fill: str) -> Rectangle:
    from matplotlib.patches import Rectangle

    return Rectangle(corner, width, height, facecolor=fill, edgecolor=INK, linewidth=0.8, zorder=4)


def _rectangles(
    patch: SupplyPatch | StepPatch, field: FilmField
) -> Iterator[tuple[tuple[float, float], float, float]]:
    """Corner, width and height as drawn; a patch over the seam shows on both sides."""
    start, turn = field.theta[0], 2.0 * math.pi
    extent = patch.theta[1] - patch.theta[0]
    first = start + (patch.theta[0] - start) % turn
    for low in (first, first - turn):
        if start - 1e-9 <= low + extent and low <= start + turn:
            first_z, last_z = map(LENGTH.shown, patch.z)
            yield (math.degrees(low), first_z), math.degrees(extent), last_z - first_z


def load_line(panel: Axes, case: FilmCase) -> None:
    """The direction of the load."""
    panel.axvline(math.degrees(case.load_angle), color=GREY, linewidth=0.8, linestyle=(0, (6, 2, 1, 2)), zorder=3)
    panel.annotate(
        "load", (math.degrees(case.load_angle), 1.0), xycoords=panel.get_xaxis_transform(), xytext=(0, 1),
        textcoords="offset points", fontsize=7, ha="center", va="bottom", color="0.3", annotation_clip=False,
    )  # fmt: skip


def says(panel: Axes, text: str) -> None:
    """What a panel shows, above it."""
    panel.annotate(text, (0.0, 1.0), xycoords="axes fraction", xytext=(0, 1.5), textcoords="offset points",
                   fontsize=7.5, va="bottom", annotation_clip=False)  # fmt: skip


def rotation(panel: Axes, case: FilmCase) -> None:
    """The sense of rotation, above a panel."""
    text = "rotation →" if case.rotation.sense > 0.0 else "← rotation"
    panel.annotate(text, (1.0, 1.0), xycoords="axes fraction", xytext=(0, 1.5), textcoords="offset points",
                   fontsize=7.5, ha="right", va="bottom", annotation_clip=False)  # fmt: skip
