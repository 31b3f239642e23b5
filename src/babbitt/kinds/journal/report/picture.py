"""A journal bearing seen along its shaft, as a drawing for the screen."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from babbitt.core.language import translated
from babbitt.core.limited_flow import quantity_held
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Matrix
from babbitt.core.solution import Solution
from babbitt.kinds.journal.film.field import Array, field_of, inside, step_patches
from babbitt.kinds.journal.film.isothermal import under_found_load
from babbitt.kinds.journal.film.model import FeedSize, FilmCase
from babbitt.kinds.journal.iso7902.supply import (
    Arrangement,
    CircumferentialGroove,
    HalfCircumferentialGroove,
    Holes,
    Pockets,
)
from babbitt.report.labels import label
from babbitt.report.names import shown_name
from babbitt.report.picture import Handle, Picture
from babbitt.report.picture_words import enlarged, named
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.surface.unwrapped_mesh import GROOVE_GAP, bore_gap

__all__ = ["film_picture", "round_picture"]

PLAY, DEEP, HIGHEST, BACK = 0.22, 0.1, 0.55, 0.25
"""Clearance, depth of a groove, highest pressure and thickness of the bush as drawn, over the radius."""

NAMES = 0.12
"""Room for the highest pressure beyond its area, over the radius."""

ALIKE = 0.995
"""Pressure of the mid-plane over the largest anywhere, from which on both read as one."""

NARROWEST = 0.02
"""Half the angle of a feed as drawn, rad, at least."""

ABOVE, BELOW = 0.94, -0.78
"""Where the sizes begin, over half the height: below where the highest pressure stands at the upper left."""

DOWN = -0.5 * math.pi


def round_picture(solution: Solution) -> Picture | None:
    """A round bore with its feed and journal; the load downward, as the methods of one dimension have it.

    Of a bearing short of oil it shows the film that limits are held against.
    """
    result = solution.result
    position = [quantity_held(result, name) for name in ("eccentricity_ratio", "attitude_angle")]
    clearance = quantity_held(result, "operating_relative_clearance")
    values = result.values
    if not {*position, clearance} <= values.keys():
        return None
    picture = _empty(solution, position)
    _sizes(picture, values, PLAY / values[clearance], clearance)
    around = np.linspace(0.0, 2.0 * math.pi, 181)
    _bush(picture, np.full_like(around, 1.0 + PLAY), around)
    sense = math.copysign(1.0, values.get("angular_speed", 1.0))
    for middle, half in _supplies(solution.problem):
        _notch(picture, DOWN - sense * middle, half)
    eccentricity, attitude = (values[name] for name in position)
    centres = DOWN + sense * attitude
    _journal(picture, PLAY * eccentricity * math.cos(centres), PLAY * eccentricity * math.sin(centres))
    picture.load(DOWN, values.get("load", math.nan), sense)
    return picture


def _supplies(problem: Any) -> Iterator[tuple[float, float]]:
    """Middle, before the load in the sense of rotation, and half the extent of each supply of ISO 7902, rad."""
    bearing = problem.bearing
    match getattr(bearing, "supply_element", None):
        case Holes() as holes:
            half = holes.diameter / bearing.diameter
            for middle in _middles(holes, math.radians(bearing.span)):
                yield middle, half
        case Pockets() as pockets:
            for middle in _middles(pockets, math.radians(bearing.span)):
                yield middle, 0.5 * pockets.extent
        case HalfCircumferentialGroove():
            yield math.pi, 0.5 * math.pi
        case CircumferentialGroove():
            yield math.pi, math.pi


def _middles(element: Holes | Pockets, span: float) -> tuple[float, ...]:
    if element.arrangement is Arrangement.OPPOSITE:
        return (math.pi,)
    before, behind = element.places(span)
    return (before, -behind) if element.arrangement is Arrangement.BOTH_SIDES else (before,)


def _notch(picture: Picture, middle: float, half: float) -> None:
    """A recess of the round bore."""
    angles = middle + np.linspace(-1.0, 1.0, 91) * max(half, NARROWEST)
    both = np.concatenate((angles, angles[::-1]))
    ring = np.repeat([1.0 + PLAY, 1.0 + PLAY + DEEP], angles.size)
    picture.area((ring * np.cos(both), ring * np.sin(both)), "feed")


def film_picture(solution: Solution) -> Picture | None:
    """Bore with grooves, pockets and steps, journal, load, and the pressure in the mid-plane."""
    if not solution.result.outcome.solved:
        return None
    case: FilmCase = under_found_load(solution.problem, solution.state)
    film: FilmSolution = solution.state.solution
    field = field_of(film, case.load_angle - math.pi)
    picture = _empty(solution)
    radius = _bore(film, field.theta)
    largest = solution.result.values.get("maximum_pressure", 0.0)
    _pressure(picture, field.theta, field.mid_plane_pressure, largest)
    enlargement = 0.5 * PLAY * case.bearing.diameter / film.film.clearance
    place = BELOW if _is_upper_left(field.theta, field.mid_plane_pressure) else ABOVE
    _sizes(picture, solution.result.values, enlargement, place=place)
    around = np.union1d(field.theta, np.linspace(field.theta[0], field.theta[-1], 181))
    _bush(picture, np.interp(around, field.theta, radius), around)
    for number, feed in enumerate(case.bearing.feeds):
        if feed.width is None or abs(feed.axial_position) <= 0.5 * feed.width:
            _feed(picture, field.theta, radius, feed, _field_of(case.bearing.feeds, number))
    if "orbit" in solution.result.arrays:
        _orbit(picture, solution.result.arrays["orbit"], case, film.film.clearance)
    else:
        x, y = PLAY * film.position / film.film.clearance
        _journal(picture, float(x), float(y))
    picture.load(case.load_angle, film.load, case.rotation.sense, Handle("load_angle", case.load_angle))
    return picture


def _empty(solution: Solution, position: Sequence[str] = ("eccentricity_ratio", "attitude_angle")) -> Picture:
    values = solution.result.values
    said = [f"{label(name)}: {QUANTITIES[name].with_unit(values[name])}" for name in position if name in values]
    return Picture(
        1.0 + PLAY + BACK + HIGHEST + NAMES,
        translated(
            "{bearing} seen along the shaft; {sizes}",
            bearing=shown_name(solution.result.name),
            sizes="; ".join(said),
        ),
    )


def _sizes(
    picture: Picture,
    values: Mapping[str, float],
    factor: float,
    clearance: str = "operating_relative_clearance",
    place: float = ABOVE,
) -> None:
    """Diameter, width and clearance from a share of the reach down, and by how much the film is enlarged."""
    picture.notes(-0.98 * picture.reach, place * picture.reach, named(values, "diameter", "width", clearance))
    picture.notes(0.98 * picture.reach, ABOVE * picture.reach, (enlarged("film", factor),), "end")


def _bore(solution: FilmSolution, theta: Array) -> Array:
    """Drawn radius of the bore: grooves closed, steps that reach the mid-plane deepened."""
    film = solution.film
    gap = bore_gap(film, theta)
    land = gap < 0.5 * GROOVE_GAP
    radius = 1.0 + PLAY * np.interp(theta, theta[land], gap[land], period=2.0 * math.pi)
    for step in step_patches(film):
        if step.z[0] <= 0.0 <= step.z[1]:
            deeper = min(PLAY * step.depth / film.clearance, DEEP)
            radius = np.where(inside(theta, step.theta), radius + deeper, radius)
    return np.asarray(radius)


def _bush(picture: Picture, radius: Array, theta: Array) -> None:
    """The metal between the bore and its back."""
    bore = radius * np.cos(theta), radius * np.sin(theta)
    back = (1.0 + PLAY + BACK) * np.cos(theta), (1.0 + PLAY + BACK) * np.sin(theta)
    picture.area(back, "bush", hole=bore)
    picture.outline(bore, "bore")


def _is_upper_left(theta: Array, pressure: Array) -> bool:
    """Whether the highest pressure of the mid-plane, which is named there, stands where the sizes usually do."""
    top = int(pressure.argmax())
    return pressure[top] > 0.0 and math.cos(theta[top]) < 0.0 < math.sin(theta[top])


def _pressure(picture: Picture, theta: Array, pressure: Array, largest: float) -> None:
    """That of the mid-plane outward from the bush, the highest as `HIGHEST`; elsewhere may be a larger one."""
    highest = float(pressure.max())
    if not highest > 0.0:
        return
    base = 1.0 + PLAY + BACK
    angles = np.linspace(theta[0], theta[-1], 361)
    outer = base + 0.9 * HIGHEST * np.interp(angles, theta, np.maximum(pressure, 0.0)) / highest
    x, y = np.cos(angles), np.sin(angles)
    picture.area(
        (np.concatenate((outer * x, base * x[::-1])), np.concatenate((outer * y, base * y[::-1]))), "pressure"
    )
    top = int(outer.argmax())
    quantity = QUANTITIES["maximum_pressure"]
    beside = outer[top] + 0.12
    where = " (z = 0)" if highest < ALIKE * largest else ""
    picture.text(beside * x[top], beside * y[top], quantity.with_unit(highest) + where)


def _feed(picture: Picture, theta: Array, radius: Array, feed: FeedSize, field: str) -> None:
    """A notch of the bore that may be turned."""
    half = max(0.5 * feed.extent, NARROWEST)
    angles = feed.angle + np.linspace(-half, half, 24)
    inner = np.interp(angles, theta, radius, period=2.0 * math.pi)
    ring = np.concatenate((inner, (inner + DEEP)[::-1]))
    both = np.concatenate((angles, angles[::-1]))
    picture.area((ring * np.cos(both), ring * np.sin(both)), "feed", Handle(field, feed.angle))


def _field_of(feeds: Sequence[FeedSize], number: int) -> str:
    """Field of a case with the angle of a feed: grooves, pockets and holes stand in lists of their own."""
    family = _family(feeds[number])
    return f"{family}.{sum(_family(one) == family for one in feeds[:number])}.angle"


def _family(feed: FeedSize) -> str:
    if feed.bore_hole is not None:
        return "holes"
    return "grooves" if feed.width is None else "pockets"


def _journal(picture: Picture, x: float, y: float) -> None:
    picture.circle(x, y, 1.0, "journal")
    picture.circle(0.0, 0.0, 0.018, "centre bearing")
    picture.circle(x, y, 0.022, "centre")
    picture.outline(([0.0, x], [0.0, y]), "centres")


def _orbit(picture: Picture, rows: Matrix, case: FilmCase, clearance: float) -> None:
    """The path of the centre, and the journal on its way, as long at each place as it stays there."""
    assert case.changing_load is not None, "an orbit is due to a changing load"
    turned, x, y = np.array(rows).T[:3]
    drawn = PLAY / clearance * np.array([np.append(x, x[0]), np.append(y, y[0])])
    path = drawn[0], drawn[1]
    times = np.append(turned / case.changing_load.cycle, 1.0)
    picture.moving(path, times).circle(0.0, 0.0, 1.0, "journal")
    picture.outline(path, "curve")
    picture.circle(0.0, 0.0, 0.018, "centre bearing")
    picture.moving(path, times).circle(0.0, 0.0, 0.022, "centre")
