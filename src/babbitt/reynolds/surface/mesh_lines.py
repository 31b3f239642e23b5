"""Lines and axial elements of an unrolled bearing: on every edge of what the bore has, crowded around supplies.

Oil leaves a hole through its rim, and the pressure falls within a distance of the size of the hole; a grid that
does not see this distance sends out too much oil. Out of a long slot it leaves through the long sides, and the
pressure falls evenly: the longer side of a supply is its size.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import accumulate, pairwise

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.lands.axial import AxialMesh, element_axial_mesh, even_axial_mesh
from babbitt.reynolds.model import END_DAM, FilmStart, JournalFilm, Pocket, Step

__all__ = ["Density", "GrooveArc", "axial_mesh", "groove_arcs", "ring_lines", "within"]

Array = NDArray[np.float64]
Density = Callable[[Array], Array]
TURN = 2.0 * math.pi
WHOLE_TURN = TURN * (1.0 - 1e-9)
RIM_CELLS = 40.0
"""Lines per turn at which a line stands one size of a supply from its rim; of more lines, nearer in proportion."""

RIM_GROWTH = 0.7
"""Growth of the spacing of lines with the distance from a rim."""

RIM_ELEMENTS = (0.7, 2.5)
"""Where axial elements end beside a small supply: distances from its rim over its size."""

GROOVE_ELEMENTS = (0.1, 0.3, 0.6)
"""Where axial elements end beside a groove around the whole bore: shares of the land from its rim.

The film is full along it and breaks a little farther out, where the gap widens, so that the pressure has a kink. A
single polynomial spreads that over the land: too much cool oil came into the gap, and thermal films were up to 8 %
too thick."""

PLACES, RIM_PLACES = 240, 720
"""Places per turn at which a wanted density is known, without and with the rims of supplies."""

MOST_NODES = 24
"""Nodes across the width above which elements are not split beside supplies: cost grows with their square."""


@dataclass(frozen=True)
class GrooveArc:
    """A groove between two lands: rad, gauge Pa, and the share of the gap that it fills."""

    first: float
    extent: float
    pressure: float
    fill: float = 1.0

    @property
    def last(self) -> float:
        """Where the groove ends, rad."""
        return self.first + self.extent

    def spans(self, angle: float) -> bool:
        """Whether an angle lies in the groove."""
        return (angle - self.first) % TURN <= self.extent


def groove_arcs(film: JournalFilm) -> list[GrooveArc]:
    """Grooves between the lands, each behind its land of ``film.land_order``."""
    lands = [film.lands[number] for number in film.land_order]
    arcs = []
    for land, following in zip(lands, [*lands[1:], lands[0]], strict=True):
        extent = (following.start_angle - land.end_angle + 1e-9) % TURN - 1e-9
        pressure = 0.5 * (land.end_pressure + following.start_pressure)
        arcs.append(GrooveArc(land.end_angle, max(extent, 0.0), pressure, following.start_fill))
    return arcs


def within(angles: Array, first: float, last: float) -> NDArray[np.bool_]:
    """Which angles lie between first and last, edges included, whatever the turn."""
    turns = (angles - (first - 1e-9)) * (1.0 / TURN)
    return np.asarray(turns - np.floor(turns) <= (last - first + 2e-9) / TURN)


def ring_lines(film: JournalFilm, start: float, per_turn: int, density: Density | None) -> Array:
    """Lines over one turn: on every edge, between them at the wanted density, none inside a groove.

    Parameters
    ----------
    film : JournalFilm
    start : float
        First line, rad.
    per_turn : int
        Intervals around the bearing, those that crowd around supplies not counted.
    density : callable or None
        Wanted density of lines at given angles, in any unit; None: uniform.

    Returns
    -------
    ndarray, shape (n + 1,)
        rad, from ``start`` over a turn.
    """
    grooves = [] if film.film_start is FilmStart.PERIODIC else groove_arcs(film)
    marks = marked_angles(start, [(arc.first, arc.last) for arc in grooves] + rectangles(film))
    rims = supply_rims(film)
    per_turn_known = RIM_PLACES if rims else PLACES
    places = []  # where the density is known, from mark to mark
    for left, right in pairwise(marks):
        closed = any(arc.spans(0.5 * (left + right)) for arc in grooves)
        known = 2 if closed else 8 + int(per_turn_known * (right - left) / TURN)
        places.append(left + (right - left) / (known - 1) * np.arange(known))
    ends = [0, *accumulate(part.size for part in places)]
    fine = np.concatenate(places)
    open_film = np.ones(fine.size)
    for first, last in pairwise(ends):
        if last - first == 2:
            open_film[first:last] = 0.0
    wanted = open_film if density is None else open_film * density(fine)
    mass = cumulative_trapezoid(wanted, fine)
    per_mass = per_turn / mass[-1]
    if rims:
        at_rims = open_film * rim_density(rims, fine, per_turn)
        mass = cumulative_trapezoid(np.maximum(per_mass * wanted, at_rims), fine)
    else:
        mass *= per_mass
    targets, starts = [], [0]
    for first, last in pairwise(ends):
        whole = mass[last - 1] - mass[first]
        count = max(2, round(whole)) if whole > 0.0 else 1
        targets.append(mass[first] + whole / count * np.arange(count))
        starts.append(starts[-1] + count)
    lines = np.interp(np.concatenate([*targets, mass[-1:]]), mass, fine)
    lines[starts] = marks
    return np.asarray(lines)


def marked_angles(start: float, arcs: list[tuple[float, float]]) -> Array:
    """Edges of arcs over the turn that begins at ``start``, both its ends included, ascending.

    Edges closer than 1e-8 rad are one. None is rounded: that would lay the lines by the frame, not by the edges.
    """
    edges = [(edge - start + 1e-9) % TURN - 1e-9 for arc in arcs for edge in arc]
    marks = np.array([0.0, *sorted(edge for edge in edges if edge > 1e-8), TURN])
    marks = start + marks[np.concatenate(([True], marks[1:] - marks[:-1] > 1e-8))]
    marks[-1] = start + TURN
    return np.asarray(marks)


def supply_rims(film: JournalFilm) -> list[tuple[float, float, float]]:
    """Centre and extent (rad) of supplies that leak over a rim, and their size over the radius.

    Of an open groove the ends leak, over a length of the size of its dams.
    """
    radius = 0.5 * film.diameter
    rims = [(one.centre_angle, one.extent, max(one.extent, one.axial_length / radius)) for one in film.pockets]
    for arc in groove_arcs(film) if film.film_start is not FilmStart.PERIODIC else []:
        if arc.pressure > 0.0:
            rims.append((arc.first + 0.5 * arc.extent, arc.extent, 2.0 * END_DAM * film.width / radius))
    return rims


def rim_density(rims: list[tuple[float, float, float]], angle: Array, per_turn: int) -> Array:
    """Lines per radian that the rims of supplies ask for; none within them."""
    wanted = np.zeros(angle.size)
    for centre, extent, size in rims:
        away = np.abs((angle - centre + math.pi) % TURN - math.pi) - 0.5 * extent
        spacing = size * RIM_CELLS / per_turn + RIM_GROWTH * np.maximum(away, 0.0)
        wanted = np.where(away > -1e-9, np.maximum(wanted, 1.0 / spacing), wanted)
    return np.asarray(wanted)


def rectangles(film: JournalFilm) -> list[tuple[float, float]]:
    """Arcs of pockets and steps, rad."""
    parts: tuple[Pocket | Step, ...] = (*film.pockets, *film.steps)
    return [(part.centre_angle - 0.5 * part.extent, part.centre_angle + 0.5 * part.extent) for part in parts]


def cumulative_trapezoid(values: Array, at: Array) -> Array:
    """Integral from the first place to every other, shape (n,)."""
    integral = np.zeros(at.size)
    np.cumsum(0.5 * (values[1:] + values[:-1]) * (at[1:] - at[:-1]), out=integral[1:])
    return integral


def axial_mesh(film: JournalFilm, degree: int, *, halved: bool) -> AxialMesh:
    """Mesh of half the width where everything is symmetric, of the whole width otherwise."""
    ends = axial_ends(film)
    inner = [end for end in sorted(ends) if -1.0 + 1e-9 < end < 1.0 - 1e-9 and (not halved or end > 1e-9)]
    if halved and not inner:
        return even_axial_mesh(degree)
    boundaries = (0.0 if halved else -1.0, *inner, 1.0)
    if not inner:
        return element_axial_mesh(boundaries, (2 * degree,))
    boundaries = tuple(sorted({*boundaries, *groove_elements(film, boundaries)}))
    degrees = element_degrees(boundaries, degree)
    for part in RIM_ELEMENTS:
        finer = tuple(sorted({*boundaries, *rim_elements(film, boundaries, part)}))
        if sum(element_degrees(finer, degree)) > max(MOST_NODES, sum(degrees)):
            break
        boundaries, degrees = finer, element_degrees(finer, degree)
    return element_axial_mesh(boundaries, degrees)


def element_degrees(boundaries: tuple[float, ...], degree: int) -> tuple[int, ...]:
    """Degrees of elements between boundaries."""
    return tuple(max(2, min(degree, round(2 * degree * (end - begin) + 1))) for begin, end in pairwise(boundaries))


def axial_ends(film: JournalFilm) -> set[float]:
    """Where pockets, steps and the dams of open grooves end across the width, over half of it."""
    half = 0.5 * film.width
    parts: tuple[Pocket | Step, ...] = (*film.pockets, *film.steps)
    ends = {
        round(end / half, 12) for part in parts
        for end in (part.axial_centre - 0.5 * part.axial_length, part.axial_centre + 0.5 * part.axial_length)
    }  # fmt: skip
    if has_end_dams(film):
        ends |= {-1.0 + 2.0 * END_DAM, 1.0 - 2.0 * END_DAM}
    return ends


def has_end_dams(film: JournalFilm) -> bool:
    """Whether the pressure of an open groove falls to that of a side."""
    if film.film_start is FilmStart.PERIODIC:
        return False
    return any(arc.pressure != side for arc in groove_arcs(film) for side in film.side_pressures)


def groove_elements(film: JournalFilm, boundaries: tuple[float, ...]) -> set[float]:
    """Further boundaries beside grooves around the whole bore that press oil out, `GROOVE_ELEMENTS`."""
    half, more = 0.5 * film.width, set()
    for groove in film.pockets:
        if groove.extent < WHOLE_TURN or groove.pressure <= 0.0:
            continue
        for sense in (-1.0, 1.0):
            rim = (groove.axial_centre + 0.5 * sense * groove.axial_length) / half
            room = min((sense * (end - rim) for end in boundaries if sense * (end - rim) > 1e-9), default=0.0)
            more |= {round(rim + sense * share * room, 12) for share in GROOVE_ELEMENTS if room > 0.0}
    return {end for end in more if boundaries[0] < end}


def rim_elements(film: JournalFilm, boundaries: tuple[float, ...], part: float) -> set[float]:
    """Further boundaries at a part of the size of supplies from their rims, where elements reach farther."""
    half, more = 0.5 * film.width, set()
    for pocket in film.pockets:
        size = max(pocket.axial_length, 0.5 * pocket.extent * film.diameter) / half
        for sense in (-1.0, 1.0):
            rim = (pocket.axial_centre + 0.5 * sense * pocket.axial_length) / half
            room = min((sense * (end - rim) for end in boundaries if sense * (end - rim) > 1e-9), default=0.0)
            if part * size < 0.6 * room:
                more.add(round(rim + sense * part * size, 12))
    return {end for end in more if boundaries[0] < end}
