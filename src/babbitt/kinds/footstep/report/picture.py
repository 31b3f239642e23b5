"""A footstep in a section along its axis, as a drawing for the screen."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from babbitt.core.language import translated
from babbitt.core.result import Result
from babbitt.core.solution import Solution
from babbitt.kinds.footstep.model import Footstep, ScrewGroove
from babbitt.kinds.footstep.model_case import FootstepProblem
from babbitt.report.names import shown_name
from babbitt.report.picture import Canvas, Picture
from babbitt.report.picture_words import enlarged, millimetres, round_below, sized

__all__ = ["heel_picture"]

Array = NDArray[np.float64]

FILM, WALL, FLOOR, SHAFT = 0.14, 0.3, 0.4, 0.45
"""Thickest film at most, thickness of the cup around and under the heel, and how much of the shaft is seen above;
over the radius of the heel, as all lengths here."""

REACH = 1.0 + FILM + WALL + 0.6


def heel_picture(solution: Solution) -> Picture:
    """The heel in its cup: grooves, bore and recess, films enlarged, load, pressures and flows."""
    problem: FootstepProblem = solution.problem
    step, values, name = problem.footstep, solution.result.values, shown_name(solution.result.name)
    length = step.geometry.length / step.geometry.radius
    gap, play = (_factor(step) * size / step.geometry.radius for size in (step.face_gap, step.clearance))
    said = translated("{name}: heel in its cup, in a section along the axis", name=name)
    if solution.result.outcome.solved:
        said = translated(
            "{name}: heel in its cup, in a section along the axis, carrying {load}",
            name=name,
            load=sized("load", values["load"]),
        )
    low, high = -gap - FLOOR - 0.35, length + SHAFT + 0.5
    picture = Picture(REACH, said, low, high)
    _cup(picture, step, gap, play, length)
    _heel(picture, step, play, length)
    _sizes(picture, step, length)
    if solution.result.outcome.solved:
        _loaded(picture, solution.result, length)
        _flows(picture, step, solution.result, gap, play, length)
    return picture


def _factor(step: Footstep) -> float:
    """By how much both films are drawn larger."""
    return round_below(FILM * step.geometry.radius / max(step.face_gap, step.clearance))


def _cup(canvas: Canvas, step: Footstep, gap: float, play: float, length: float) -> None:
    """The cup in section with the bore in its floor, and the oil in both films."""
    inner, outer = 1.0 + play, 1.0 + play + WALL
    bore = step.geometry.bore_radius / step.geometry.radius
    floor = -gap - FLOOR
    canvas.box((-inner, -gap), (inner, length), "film")
    canvas.box((-bore, floor), (bore, -gap), "film")
    for side in (-1.0, 1.0):
        x = [side * one for one in (bore, outer, outer, inner, inner, bore)]
        canvas.area((x, [floor, floor, length, length, -gap, -gap]), "bush")


def _heel(canvas: Canvas, step: Footstep, play: float, length: float) -> None:
    """The heel as it is seen, the recess of its face in section, grooves on its front."""
    part = step.geometry
    recess, depth = part.recess_radius / part.radius, min(part.recess_depth / part.radius, 0.8 * length)
    rim, end = (play * ratio for ratio in step.end_eccentricities)

    def aside(y: Array | float) -> Array:
        """Where the axis stands, from the rim at 0 to the outer end."""
        return np.asarray(rim + (end - rim) * np.clip(np.asarray(y) / length, 0.0, 1.0))

    x = np.array([-1.0, -1.0, -0.7, -0.7, 0.7, 0.7, 1.0, 1.0])
    y = np.array([0.0, length, length, length + SHAFT, length + SHAFT, length, length, 0.0])
    canvas.area((x + aside(y), y), "journal")
    if step.groove is not None:
        for band in _grooves(step.groove, part.radius, length):
            canvas.area((band[0] + aside(band[1]), band[1]), "groove")
    x, y = recess * np.array([-1.0, -1.0, 1.0, 1.0]), np.array([0.0, depth, depth, 0.0])
    canvas.area((x + aside(0.0), y), "pocket")
    canvas.area((x + aside(0.0), y), "film")
    canvas.outline((x + aside(0.0), y), "thin")
    canvas.outline((aside(np.array([0.0, length + SHAFT])), [0.0, length + SHAFT]), "dashed")


def _grooves(groove: ScrewGroove, radius: float, length: float) -> list[tuple[Array, Array]]:
    """Grooves on the front of the heel, which moves to the right there.

    They rise with the motion: the cup, which drags oil to the left over the heel, drags it down to the rim.
    """
    rise, wide = math.tan(groove.angle), groove.groove_width / radius / math.cos(groove.angle)
    lead = 2.0 * math.pi * rise  # of one groove around the heel
    arc = np.linspace(-0.5 * math.pi, 0.5 * math.pi, 41)
    bands = []
    for start in np.arange(-lead, length + lead, lead / groove.starts):
        lower = start + rise * (arc + 0.5 * math.pi)
        x = np.concatenate((np.sin(arc), np.sin(arc[::-1])))
        y = np.concatenate((lower, lower[::-1] + wide))
        if y.max() > 0.0 and y.min() < length:
            bands.append((x, np.clip(y, 0.0, length)))
    return bands


def _sizes(canvas: Canvas, step: Footstep, length: float) -> None:
    part = step.geometry
    sizes = millimetres("D", 2.0 * part.radius), millimetres("L", part.length)
    films = f"h_f = {sized('face_gap', step.face_gap)}", f"δ = {sized('heel_clearance', step.clearance)}"
    side, top = 0.98 * canvas.reach, length + SHAFT + 0.38
    canvas.notes(-side, top, (*sizes, enlarged("film", _factor(step))))
    canvas.notes(side, top, films, "end")


def _loaded(canvas: Canvas, result: Result, length: float) -> None:
    top = length + SHAFT
    canvas.arrow((0.0, top + 0.42), (0.0, top), "load")
    canvas.text(0.1, top + 0.3, sized("load", result.values["load"]), anchor="start")
    canvas.arrow((-0.45, top - 0.5 * SHAFT), (0.45, top - 0.5 * SHAFT), "rotation")


def _flows(canvas: Canvas, step: Footstep, result: Result, gap: float, play: float, length: float) -> None:
    """Oil in the bore, in the face gap and in the clearance, and the pressures of recess and rim."""
    part, values = step.geometry, result.values
    floor = -gap - FLOOR
    canvas.arrow((0.0, floor - 0.22), (0.0, -gap + 0.1), "flow")
    canvas.text(0.1, floor - 0.15, f"p₂ = {sized('rim_pressure', step.supply_pressure)}", anchor="start")
    rim = sized("rim_pressure", values["rim_pressure"])
    canvas.text(-1.0 - play - WALL + 0.05, -gap - 0.18, f"p₁ = {rim}", anchor="start")
    recess = part.recess_radius / part.radius
    ends = (recess + 0.05, 1.0) if values["face_flow"] >= 0.0 else (1.0, recess + 0.05)
    up = (0.0, 0.35) if values["heel_net_flow"] >= 0.0 else (0.35, 0.0)
    for side in (-1.0, 1.0):
        canvas.arrow((side * ends[0], -0.5 * gap), (side * ends[1], -0.5 * gap), "flow")
        x = side * (1.0 + 0.5 * play)
        canvas.arrow((x, length + up[0]), (x, length + up[1]), "flow")
