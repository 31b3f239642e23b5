"""A hydrostatic pad or ring as a drawing for the screen: its lands and recesses seen from the runner."""

from __future__ import annotations

import math

import numpy as np

from babbitt.core.language import translated
from babbitt.core.solution import Solution
from babbitt.kinds.hydrostatic.answer import Answer
from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, RectangularPad, ThrustRing, pitches_around
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.report.picture_journal import recessed_journal_picture
from babbitt.kinds.hydrostatic.report.picture_section import drawn_size, recess_pressure, recess_section
from babbitt.kinds.hydrostatic.report.pressure_field import pressure_field
from babbitt.report.picture import Canvas, Picture, Points
from babbitt.report.picture_words import millimetres, sized

__all__ = ["recess_picture"]

REACH, PLAN, ABOVE, BELOW = 1.42, 1.2, 1.0, 0.62
"""Half the width of the picture, half the height of the plan at most, and what the section takes above and below
the lands; over half the length of the pad or its outer radius, as all lengths here."""

AROUND = np.linspace(0.0, 2.0 * math.pi, 97)


def recess_picture(solution: Solution) -> Picture:
    """A hydrostatic bearing: a journal seen along the shaft, all others from the runner and in a section."""
    case: HydrostaticCase = solution.problem
    if case.is_journal:
        return recessed_journal_picture(solution)
    name, shape = solution.result.name, case.shape
    half = _half_height(case)
    found = solution.state.found if solution.result.outcome.solved else None
    if found is None:
        picture = Picture(REACH, translated("{bearing}: lands and recesses", bearing=name), -half, half)
        _plan(picture, case, None)
        return picture
    cut = "unrolled around the recesses" if isinstance(shape, ThrustRing) else "through the middle"
    pressures = ", ".join(sized("recess_pressure", float(one)) for one in found.network.pressures)
    spoken = translated(
        "{bearing}: lands and recesses at {pressures}; below, a section {cut}",
        bearing=name,
        pressures=pressures,
        cut=translated(cut),
    )
    picture = Picture(REACH, spoken, -half - ABOVE - BELOW, half)
    _plan(picture, case, found)
    recess_section(picture.part(0.0, -half - ABOVE, 1.0), case, found)
    return picture


def _half_height(case: HydrostaticCase) -> float:
    shape = case.shape
    return 0.5 * shape.width / drawn_size(case) + 0.3 if isinstance(shape, RectangularPad) else PLAN


def _plan(canvas: Canvas, case: HydrostaticCase, found: Answer | None) -> None:
    """Lands, pressures and recesses, seen from the runner."""
    shape, size = case.shape, drawn_size(case)
    plan = canvas.part(0.0, 0.0, 1.0 / size)
    outer, hole = _edges(case)
    plan.area(outer, "bush", hole=hole)
    if found is not None and found.film is not None:
        plan.bands(*pressure_field(case, found), float(found.film.maximum_pressure))
    for number, (edge, within) in enumerate(_recesses(case)):
        plan.area(edge, "recess", hole=within)
        if isinstance(shape, ThrustRing):
            at = shape.recess_angles[number]
            radius = 0.5 * (shape.radii.recess_inner_radius + shape.radii.recess_outer_radius)
            plan.text(radius * math.cos(at), radius * math.sin(at), f"{number + 1}")
            if found is not None:
                radius = (1.1 + 0.1 * abs(math.cos(at))) * size
                plan.text(radius * math.cos(at), radius * math.sin(at), recess_pressure(found, number))
    if isinstance(shape, ThrustRing) and shape.groove_extent > 0.0:
        _drains(plan, shape)
    if case.duty.angular_speed:
        sense = math.copysign(1.0, case.duty.angular_speed)
        radius = 1.12 * size if hole is None else 0.5 * float(np.hypot(hole[0], hole[1]).max())
        plan.turning(0.0, 0.0, radius, -0.25 * math.pi, sense, "rotation")
    canvas.notes(-0.98 * canvas.reach, _half_height(case) - 0.08, _sizes(case))


def _sizes(case: HydrostaticCase) -> tuple[str, ...]:
    shape = case.shape
    if isinstance(shape, RectangularPad):
        return (f"{millimetres('L', shape.length)}, {millimetres('B', shape.width)}",)
    outer = millimetres("D", 2.0 * case.reach)
    if isinstance(shape, CircularPad):
        return outer, millimetres("d", 2.0 * shape.recess_radius)
    assert isinstance(shape, AnnularPad | ThrustRing)
    ring = shape if isinstance(shape, AnnularPad) else shape.radii
    return outer, millimetres("d", 2.0 * ring.inner_radius)


def _round(radius: float) -> Points:
    return radius * np.cos(AROUND), radius * np.sin(AROUND)


def _rectangle(length: float, width: float) -> Points:
    x, y = 0.5 * length, 0.5 * width
    return [x, -x, -x, x], [y, y, -y, -y]


def _sector(inner: float, outer: float, middle: float, extent: float) -> Points:
    arc = middle + extent * np.linspace(-0.5, 0.5, 25)
    radius = np.concatenate((np.full(25, inner), np.full(25, outer)))
    both = np.concatenate((arc, arc[::-1]))
    return radius * np.cos(both), radius * np.sin(both)


def _edges(case: HydrostaticCase) -> tuple[Points, Points | None]:
    """The outer edge, and the inner one of rings."""
    shape = case.shape
    if isinstance(shape, RectangularPad):
        return _rectangle(shape.length, shape.width), None
    if isinstance(shape, CircularPad):
        return _round(shape.outer_radius), None
    assert isinstance(shape, AnnularPad | ThrustRing)
    ring = shape if isinstance(shape, AnnularPad) else shape.radii
    return _round(ring.outer_radius), _round(ring.inner_radius)


def _recesses(case: HydrostaticCase) -> list[tuple[Points, Points | None]]:
    """Edge of each recess, and the inner one of a recess around a ring."""
    shape = case.shape
    if isinstance(shape, RectangularPad):
        return [(_rectangle(shape.recess_length, shape.recess_width), None)]
    if isinstance(shape, CircularPad):
        return [(_round(shape.recess_radius), None)]
    if isinstance(shape, AnnularPad):
        return [(_round(shape.recess_outer_radius), _round(shape.recess_inner_radius))]
    assert isinstance(shape, ThrustRing)
    inner, outer = shape.radii.recess_inner_radius, shape.radii.recess_outer_radius
    return [(_sector(inner, outer, angle, shape.recess_extent), None) for angle in shape.recess_angles]


def _drains(canvas: Canvas, shape: ThrustRing) -> None:
    """Grooves halfway between the recesses."""
    angles = sorted(angle % (2.0 * math.pi) for angle in shape.recess_angles)
    for angle, pitch in zip(angles, pitches_around(shape.recess_angles), strict=True):
        radii = shape.radii.inner_radius, shape.radii.outer_radius
        canvas.area(_sector(*radii, angle + 0.5 * pitch, shape.groove_extent), "bore")
