"""A section through a hydrostatic pad or ring as a drawing for the screen: lands, recesses, film and runner."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from babbitt.kinds.hydrostatic.answer import Answer
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, RectangularPad, ThrustRing, pitches_around
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.report.pressure_field import Array, pressure_field
from babbitt.report.picture import Canvas
from babbitt.report.picture_words import enlarged, round_below, sized

__all__ = ["drawn_size", "gap_at", "recess_pressure", "recess_section"]

FILM, BODY, RECESS, RUNNER, HIGHEST = 0.16, 0.34, 0.16, 0.12, 0.3
"""Thickest film at most, thickness of the pad, depth of a recess, thickness of the runner, highest pressure; over
half the length of the pad or its outer radius, as all lengths here."""


@dataclass(frozen=True, eq=False)
class _Section:
    """Gap and pressure over x, and the ends of the recesses there; the pressure is None where it is not known.

    `across` is what a metre along x is drawn as, `hole` half of what a ring leaves free in its middle.
    """

    x: Array
    gap: Array
    pressure: Array | None
    recesses: tuple[tuple[float, float], ...]
    across: float
    hole: float = 0.0


def gap_at(found: Answer, x: Array, y: Array) -> Array:
    """Gap of a pad or ring at places in m, which tilts about x and y; m."""
    rise, about_x, about_y = (*found.at, 0.0, 0.0)[:3]
    return np.asarray(found.rest_gap + rise + about_x * y - about_y * x)


def drawn_size(case: HydrostaticCase) -> float:
    """Length that is drawn as 1, m."""
    shape = case.shape
    return 0.5 * max(shape.length, shape.width) if isinstance(shape, RectangularPad) else case.reach


def recess_pressure(found: Answer, recess: int) -> str:
    """Pressure of one recess, in words."""
    return sized("recess_pressure", float(found.network.pressures[recess]))


def recess_section(canvas: Canvas, case: HydrostaticCase, found: Answer) -> None:
    """The lands at y = 0, the runner above them, the film enlarged."""
    cut = _around_ring(case, found) if isinstance(case.shape, ThrustRing) else _through_middle(case, found)
    factor = round_below(FILM / (cut.across * float(cut.gap.max())))
    runner = factor * cut.across * cut.gap
    left, right = float(cut.x[0]), float(cut.x[-1])
    for start, end in ((left, -cut.hole), (cut.hole, right)) if cut.hole > 0.0 else ((left, right),):
        under = (cut.x >= start - 1e-9) & (cut.x <= end + 1e-9)
        canvas.area((np.append(cut.x[under], [end, start]), np.append(runner[under], [0.0, 0.0])), "film")
        _pad(canvas, start, end, [one for one in cut.recesses if start < one[0] < end])
    top = runner + RUNNER
    canvas.area((np.append(cut.x, cut.x[::-1]), np.append(runner, top[::-1])), "journal")
    if cut.pressure is not None and float(cut.pressure.max()) > 0.0:
        height = top + HIGHEST * np.maximum(cut.pressure, 0.0) / float(cut.pressure.max())
        canvas.area((np.append(cut.x, cut.x[::-1]), np.append(height, top[::-1])), "pressure")
    tallest = float(top.max()) + HIGHEST
    force = float(found.response.force[0])
    canvas.arrow((0.0, tallest + 0.25), (0.0, float(np.interp(0.0, cut.x, top))), "load")
    canvas.text(0.06, tallest + 0.2, sized("load", force), anchor="start")
    _feeds(canvas, cut.recesses, found)
    _gap_words(canvas, cut, runner)
    canvas.notes(-0.98 * canvas.reach, tallest + 0.2, (enlarged("film", factor),))


def _pad(canvas: Canvas, left: float, right: float, recesses: Sequence[tuple[float, float]]) -> None:
    """The pad with notches for its recesses, filled with oil; their depth is not to scale."""
    x, y = [left], [0.0]
    for start, end in recesses:
        x += [start, start, end, end]
        y += [0.0, -RECESS, -RECESS, 0.0]
        canvas.box((start, -RECESS), (end, 0.0), "film")
    canvas.area(([*x, right, right, left], [*y, 0.0, -BODY, -BODY]), "bush")


def _feeds(canvas: Canvas, recesses: Sequence[tuple[float, float]], found: Answer) -> None:
    """Oil that comes into the recesses, their numbers where there are several, and pressures."""
    several = found.network.pressures.size > 1
    for number, (start, end) in enumerate(recesses):
        middle = 0.5 * (start + end)
        canvas.arrow((middle, -BODY - 0.14), (middle, -RECESS - 0.02), "flow")
        if several:
            canvas.text(middle, -0.5 * RECESS, f"{number + 1}")
    words = [f"p_s = {sized('recess_pressure', found.network.supply_pressure)}"]
    if not several:
        words.append(f"p_r = {recess_pressure(found, 0)}")
    canvas.text(0.0, -BODY - 0.2, ", ".join(words))


def _gap_words(canvas: Canvas, cut: _Section, runner: Array) -> None:
    """The gap at both ends, once where they are alike."""
    ends = float(cut.gap[0]), float(cut.gap[-1])
    canvas.text(cut.x[0] - 0.03, 0.5 * runner[0], sized("film_thickness", ends[0]), anchor="end")
    if not math.isclose(*ends, rel_tol=1e-3):
        canvas.text(cut.x[-1] + 0.03, 0.5 * runner[-1], sized("film_thickness", ends[1]), anchor="start")


def _through_middle(case: HydrostaticCase, found: Answer) -> _Section:
    """Along the middle of a pad with one recess."""
    shape, size, hole = case.shape, drawn_size(case), 0.0
    recesses: tuple[tuple[float, float], ...]
    if isinstance(shape, RectangularPad):
        half, recesses = 0.5 * shape.length / size, ((-0.5 * shape.recess_length, 0.5 * shape.recess_length),)
    elif isinstance(shape, CircularPad):
        half, recesses = 1.0, ((-shape.recess_radius, shape.recess_radius),)
    else:
        assert isinstance(shape, AnnularPad)
        inner, outer = shape.recess_inner_radius, shape.recess_outer_radius
        half, hole, recesses = 1.0, shape.inner_radius / size, ((-outer, -inner), (inner, outer))
    x = half * np.linspace(-1.0, 1.0, 161)
    x = np.union1d(x, [-hole, hole])
    pressure = None if found.film is None else _pressure_along(case, found, size * x)
    gap = gap_at(found, size * x, np.zeros(x.size))
    return _Section(x, gap, pressure, tuple((a / size, b / size) for a, b in recesses), 1.0 / size, hole)


def _pressure_along(case: HydrostaticCase, found: Answer, x: Array) -> Array:
    """Pressure at y = 0 over x in m; nothing inside a ring."""
    places, aside, pressure = pressure_field(case, found)
    if isinstance(case.shape, RectangularPad):
        middle = int(np.abs(aside[0]).argmin())
        return np.asarray(np.interp(x, places[:, middle], pressure[:, middle]))
    return np.asarray(np.interp(np.abs(x), places[0], pressure[0], left=0.0))


def _around_ring(case: HydrostaticCase, found: Answer) -> _Section:
    """Around the middle of the recesses, unrolled from the land before the first behind +x on."""
    shape = case.shape
    assert isinstance(shape, ThrustRing)
    turn = 2.0 * math.pi
    start = min(angle % turn for angle in shape.recess_angles) - 0.5 * pitches_around(shape.recess_angles)[-1]
    radius = 0.5 * (shape.radii.recess_inner_radius + shape.radii.recess_outer_radius)
    angle = start + np.linspace(0.0, turn, 241)
    across = 1.0 / (math.pi * radius)  # the whole turn as 2

    def place(theta: float) -> float:
        return ((theta - start) % turn) / math.pi - 1.0

    half = 0.5 * shape.recess_extent
    recesses = tuple((place(one - half), place(one + half)) for one in shape.recess_angles)
    pressure = None
    if found.film is not None:
        x, y, values = pressure_field(case, found)
        lines, radii = np.unwrap(np.arctan2(y[:, 0], x[:, 0])), np.hypot(x[0], y[0])
        column = int(np.abs(radii - radius).argmin())
        pressure = np.interp(angle, lines, values[:, column], period=turn)
    gap = gap_at(found, radius * np.cos(angle), radius * np.sin(angle))
    return _Section((angle - start) / math.pi - 1.0, gap, pressure, recesses, across)
