"""A recessed journal bearing, or one with jacking pockets, seen along its shaft as a drawing for the screen."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from babbitt.core.language import translated
from babbitt.core.solution import Solution
from babbitt.kinds.hydrostatic.answer import Answer, load_vector, thinnest_film
from babbitt.kinds.hydrostatic.geometry import RecessedJournal, pitches_around
from babbitt.kinds.hydrostatic.jacking import BOTTOM
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.report.pressure_field import Array, pressure_field
from babbitt.report.picture import Handle, Picture
from babbitt.report.picture_words import enlarged, millimetres, sized

__all__ = ["jacking_picture", "recessed_journal_picture"]

PLAY, DEEP, BACK, HIGHEST = 0.16, 0.12, 0.36, 0.42
"""Clearance, depth of a recess, thickness of the bush and highest pressure as drawn, over the radius."""

REACH = 1.0 + PLAY + BACK + HIGHEST + 0.14


def recessed_journal_picture(solution: Solution) -> Picture:
    """Bore with recesses, journal, load, pressures of the recesses and in the mid-plane."""
    case: HydrostaticCase = solution.problem
    shape = case.shape
    assert isinstance(shape, RecessedJournal)
    if not solution.result.outcome.solved:
        spoken = translated("{bearing}: bore and recesses seen along the shaft", bearing=solution.result.name)
        picture = Picture(REACH, spoken)
        _bearing(picture, shape, np.zeros(2))
        return picture
    found: Answer = solution.state.found
    picture = Picture(REACH, _spoken(case, solution.result.name, found))
    if found.film is not None:
        _pressure(picture, solution.state.case, found)
    _bearing(picture, shape, found.at)
    for angle, pressure in zip(shape.recess_angles, found.network.pressures, strict=True):
        radius = 1.0 + PLAY + 0.62 * BACK
        picture.text(radius * math.cos(angle), radius * math.sin(angle), sized("recess_pressure", float(pressure)))
    force = -found.response.force if case.duty.load is None else load_vector(case)
    angle = math.atan2(float(force[1]), float(force[0]))
    handle = None if case.duty.load is None else Handle("load_angle", angle)
    speed = case.duty.angular_speed
    picture.load(angle, math.hypot(*force), math.copysign(1.0, speed) if speed else 0.0, handle)
    return picture


def jacking_picture(solution: Solution) -> Picture:
    """Bore with pockets and the lifted shaft; it lies in the bore where the pockets do not hold it."""
    case: JackingCase = solution.problem
    values, solved = solution.result.values, solution.result.outcome.solved
    gap = values["minimum_film_thickness"] if solved else case.roughness
    angle = BOTTOM + (values["attitude_angle"] if solved else 0.0)
    at = (case.bearing.clearance - gap) * np.array([math.cos(angle), math.sin(angle)])
    said = "{bearing} seen along the shaft, " + ("lifted by {film}" if solved else "lying in the bore")
    picture = Picture(REACH, translated(said, bearing=solution.result.name, film=sized("film_thickness", gap)))
    _bearing(picture, case.bearing, at)
    for pocket in case.bearing.recess_angles:
        c, s = math.cos(pocket), math.sin(pocket)
        tail, tip = 1.0 + PLAY + BACK + 0.2, 1.0 + PLAY + DEEP + 0.02
        picture.arrow((tail * c, tail * s), (tip * c, tip * s), "flow")
        if solved:
            picture.text((tail + 0.1) * c, (tail + 0.1) * s, sized("pocket_pressure", values["pocket_pressure"]))
    picture.load(BOTTOM, case.load, 0.0)
    if solved:
        thinnest = f"h_min = {sized('minimum_film_thickness', gap)}"
        picture.notes(0.98 * REACH, 0.93 * REACH - 1.3 * picture.letter, (thinnest,), "end")
    return picture


def _spoken(case: HydrostaticCase, bearing: str, found: Answer) -> str:
    return translated(
        "{bearing} seen along the shaft: thinnest film {film}, recesses at {pressures}",
        bearing=bearing,
        film=sized("film_thickness", thinnest_film(case, found)),
        pressures=", ".join(sized("recess_pressure", float(one)) for one in found.network.pressures),
    )


def _bearing(picture: Picture, shape: RecessedJournal, at: Array) -> None:
    """Bush with its recesses filled with oil, drain grooves, and the journal at a place in m."""
    theta = np.linspace(0.0, 2.0 * math.pi, 721)
    bore = np.full(theta.size, 1.0 + PLAY)
    notches = [(angle, shape.recess_extent) for angle in shape.recess_angles]
    drains = _drains(shape)
    for angle, extent in (*notches, *drains):
        away = np.abs((theta - angle + math.pi) % (2.0 * math.pi) - math.pi)
        bore[away <= 0.5 * extent] += DEEP
    c, s = np.cos(theta), np.sin(theta)
    back = 1.0 + PLAY + BACK
    picture.area((back * c, back * s), "bush", hole=(bore * c, bore * s))
    for angle, extent in notches:
        picture.area(_notch(angle, extent), "film")
    picture.outline((bore * c, bore * s), "bore")
    x, y = PLAY * at / shape.clearance
    picture.circle(float(x), float(y), 1.0, "journal")
    picture.circle(0.0, 0.0, 0.018, "centre bearing")
    picture.circle(float(x), float(y), 0.022, "centre")
    reach, clearance = picture.reach, sized("film_thickness", shape.clearance)
    sizes = millimetres("D", shape.diameter), millimetres("B", shape.width), f"c = {clearance}"
    picture.notes(-0.98 * reach, 0.93 * reach, sizes)
    picture.notes(0.98 * reach, 0.93 * reach, (enlarged("film", PLAY * shape.radius / shape.clearance),), "end")


def _notch(angle: float, extent: float) -> tuple[Array, Array]:
    arc = angle + extent * np.linspace(-0.5, 0.5, 25)
    radius = np.concatenate((np.full(25, 1.0 + PLAY), np.full(25, 1.0 + PLAY + DEEP)))
    both = np.concatenate((arc, arc[::-1]))
    return radius * np.cos(both), radius * np.sin(both)


def _drains(shape: RecessedJournal) -> Sequence[tuple[float, float]]:
    """Middles and extents of the drain grooves."""
    if not shape.groove_extent > 0.0:
        return ()
    angles = sorted(angle % (2.0 * math.pi) for angle in shape.recess_angles)
    return [
        (angle + 0.5 * pitch, shape.groove_extent)
        for angle, pitch in zip(angles, pitches_around(shape.recess_angles), strict=True)
    ]


def _pressure(picture: Picture, case: HydrostaticCase, found: Answer) -> None:
    """In the mid-plane, outward from the bush."""
    theta, aside, pressure = pressure_field(case, found)
    middle = int(np.abs(aside[0]).argmin())
    along = np.maximum(pressure[:, middle], 0.0)
    if not float(along.max()) > 0.0:
        return
    base = 1.0 + PLAY + BACK
    angles = np.linspace(0.0, 2.0 * math.pi, 361)
    outer = base + HIGHEST * np.interp(angles, theta[:, middle], along, period=2.0 * math.pi) / float(along.max())
    c, s = np.cos(angles), np.sin(angles)
    picture.area((outer * c, outer * s), "pressure", hole=(base * c, base * s))
