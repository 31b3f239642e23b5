"""The unrolled bearing of a film that differs across the width: lines, nodes, what is held, and the gap.

One surface from a groove once round the bearing (or a closed ring where no groove spans the width). Lines fall on
every groove and pocket edge; axial elements end on every pocket edge, for the pressure has kinks there.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from babbitt.film._surface_film import Surface
from babbitt.film.axial import AxialMesh, element_axial_mesh, even_axial_mesh
from babbitt.film.model import Cavitation, FilmStart, JournalFilm, Land

__all__ = ["Ring", "build_ring", "circumferential_lines"]

Array = NDArray[np.float64]
TURN = 2.0 * math.pi
GROOVE_GAP = 20.0  # gap over a groove or pocket, in clearances: deep, and never the smallest


@dataclass(frozen=True, eq=False)
class Ring:
    """A surface for the kernels with what belongs to its nodes.

    Attributes
    ----------
    surface : Surface
    theta : ndarray, shape (n + 1,)
        Lines; the last closes the turn.
    mesh : AxialMesh
    supply : ndarray of int, shape (lines, nodes)
        Which groove or pocket holds a node, -1 none, -2 the side edge. Grooves count first, pockets after them.
    """

    surface: Surface
    theta: Array
    mesh: AxialMesh
    supply: NDArray[np.int64]


def build_ring(film: JournalFilm, pressure_unit: float, per_turn: int, degree: int, density: Array | None) -> Ring:
    """Surface of a film in dimensionless quantities (counter-clockwise journal).

    Parameters
    ----------
    film : JournalFilm
    pressure_unit : float
        mu omega (R/c)^2, Pa.
    per_turn : int
        Intervals around the bearing.
    degree : int
        Unknowns across the half width, or degree of the elements.
    density : ndarray, shape (k,), or None
        Wanted density of lines at k equal steps from angle 0; None: uniform.

    Returns
    -------
    Ring
    """
    mesh = axial_mesh(film, degree)
    grooves = [gap for gap in groove_arcs(film) if film.film_start is not FilmStart.PERIODIC]
    pockets = [(p.centre_angle - 0.5 * p.extent, p.centre_angle + 0.5 * p.extent) for p in film.pockets]
    start = grooves[0][1] if grooves else film.lands[0].start_angle
    theta = circumferential_lines(start, grooves, pockets, per_turn, density)
    n = theta.size - 1
    closed = not grooves
    lines = n if closed else n + 1
    base = -film.cavitation_pressure / pressure_unit  # ambient above cavitation
    held = np.zeros((lines, mesh.nodes.size), dtype=bool)
    pressure = np.zeros_like(held, dtype=float)
    supply = np.full(held.shape, -1)
    inside = np.zeros(n, dtype=bool)  # intervals that lie over a groove
    middle = 0.5 * (theta[1:] + theta[:-1])
    for number, (first, last, value) in enumerate(grooves):
        touched = within(theta[:lines], first, last)
        held[touched], pressure[touched], supply[touched] = True, value / pressure_unit + base, number
        inside |= within(middle, first, last)
    for number, (pocket, (first, last)) in enumerate(zip(film.pockets, pockets, strict=True), len(grooves)):
        covered = axial_cover(film, pocket.axial_centre, pocket.axial_length, mesh)
        touched = within(theta[:lines], first, last)[:, None] & covered[None, :]
        held |= touched
        pressure[touched], supply[touched] = pocket.pressure / pressure_unit + base, number
    sides = list(mesh.side_nodes)
    held[:, sides], pressure[:, sides], supply[:, sides] = True, base, -2
    gap_a, gap_b, trigonometry = gaps(film, theta, mesh)
    gap_a[inside], gap_b[inside] = GROOVE_GAP, GROOVE_GAP
    viscosity = np.ones_like(gap_a)
    if film.axial_viscosity:
        places = np.linspace(-1.0, 1.0, len(film.axial_viscosity))
        viscosity *= np.interp(mesh.points, places, film.axial_viscosity)[None, :]
    surface = Surface(
        step=np.diff(theta), trigonometry=trigonometry, gap_a=gap_a, gap_b=gap_b, viscosity=viscosity,
        zeta=mesh.points, share=mesh.share, node=mesh.node_of_point, slope=mesh.slope, held=held,
        held_pressure=pressure, motions=2, cyclic=closed, reference=base,
        kappa=(film.diameter / film.width) ** 2 / 12.0, speed=1.0 if film.angular_speed else 0.0,
        conserving=film.cavitation is Cavitation.MASS_CONSERVING,
    )  # fmt: skip
    return Ring(surface, theta, mesh, supply)


def axial_mesh(film: JournalFilm, degree: int) -> AxialMesh:
    """Mesh of half the width where everything is symmetric, of the whole width otherwise."""
    half = 0.5 * film.width
    ends = sorted(
        {round(end / half, 12) for p in film.pockets
         for end in (p.axial_centre - 0.5 * p.axial_length, p.axial_centre + 0.5 * p.axial_length)}
    )  # fmt: skip
    symmetric = (
        film.misalignment == (0.0, 0.0)
        and all(p.axial_centre == 0.0 for p in film.pockets)
        and tuple(film.axial_viscosity) == tuple(reversed(film.axial_viscosity))
    )
    if symmetric and not ends:
        return even_axial_mesh(degree)
    inner = [end for end in ends if -1.0 + 1e-9 < end < 1.0 - 1e-9 and (not symmetric or end > 1e-9)]
    boundaries = (0.0 if symmetric else -1.0, *inner, 1.0)
    if not inner:
        return element_axial_mesh(boundaries, (2 * degree,))
    lengths = np.diff(boundaries)
    degrees = tuple(int(max(2, min(degree, round(2 * degree * length + 1)))) for length in lengths)
    return element_axial_mesh(boundaries, degrees)


def axial_cover(film: JournalFilm, centre: float, length: float, mesh: AxialMesh) -> NDArray[np.bool_]:
    """Nodes that a pocket covers, its edges included."""
    half = 0.5 * film.width
    low, high = (centre - 0.5 * length) / half, (centre + 0.5 * length) / half
    return np.asarray((mesh.nodes >= low - 1e-9) & (mesh.nodes <= high + 1e-9))


def groove_arcs(film: JournalFilm) -> list[tuple[float, float, float]]:
    """Grooves between the lands: start, end (rad, end >= start) and gauge pressure."""
    lands = sorted(film.lands, key=lambda land: land.start_angle % TURN)
    arcs = []
    for land, following in zip(lands, [*lands[1:], lands[0]], strict=True):
        start = land.end_angle
        extent = (following.start_angle - start + 1e-9) % TURN - 1e-9
        arcs.append((start, start + max(extent, 0.0), 0.5 * (land.end_pressure + following.start_pressure)))
    return arcs


def within(angles: Array, first: float, last: float) -> NDArray[np.bool_]:
    """Which angles lie between first and last, edges included, whatever the turn."""
    return np.asarray((angles - first + 1e-9) % TURN <= last - first + 2e-9)


def circumferential_lines(
    start: float,
    grooves: list[tuple[float, float, float]],
    pockets: list[tuple[float, float]],
    per_turn: int,
    density: Array | None,
) -> Array:
    """Lines over one turn: on every edge, between them at the wanted density, none inside a groove."""
    edges = {0.0, TURN}
    for first, last, *_ in [*grooves, *pockets]:
        for edge in (first, last):
            edges.add(round((edge - start + 1e-9) % TURN - 1e-9, 10) + 0.0)
    marks = np.array(sorted(edge for edge in edges if edge >= 0.0))
    marks = marks[np.concatenate(([True], np.diff(marks) > 1e-8))]
    marks[-1] = TURN
    fine = np.linspace(0.0, TURN, 721)
    wanted = np.ones(721)
    if density is not None:
        steps = np.linspace(0.0, TURN, density.size + 1)
        wanted = np.interp((fine + start) % TURN, steps, np.append(density, density[0]))
    mass = np.concatenate(([0.0], np.cumsum(0.5 * (wanted[1:] + wanted[:-1]))))
    mass *= per_turn / mass[-1]
    pieces = [np.zeros(1)]
    for left, right in pairwise(marks):
        count = 1
        if not any(
            within(np.array([start + 0.5 * (left + right)]), first, last)[0] for first, last, *_ in grooves
        ):
            low, high = np.interp((left, right), fine, mass)
            count = max(2, round(high - low))
            inner = np.interp(np.linspace(low, high, count + 1)[1:-1], mass, fine)
            pieces.append(inner)
        pieces.append(np.array([right]))
    return start + np.concatenate(pieces)


def gaps(film: JournalFilm, theta: Array, mesh: AxialMesh) -> tuple[Array, Array, Array]:
    """Gap of the centred journal at both Gauss points of every interval and axial point, and cos, sin there."""
    step, middle = np.diff(theta), 0.5 * (theta[1:] + theta[:-1])
    offset = step * (0.5 / math.sqrt(3.0))
    a, b = middle - offset, middle + offset
    tilt = np.asarray(film.misalignment) * (0.5 * film.width / film.clearance)
    found = []
    for angle in (a, b):
        gap = np.repeat(bore_gap(film, angle)[:, None], mesh.points.size, axis=1)
        gap -= mesh.points[None, :] * (tilt[0] * np.cos(angle) + tilt[1] * np.sin(angle))[:, None]
        found.append(gap)
    return found[0], found[1], np.array([np.cos(a), np.sin(a), np.cos(b), np.sin(b)])


def bore_gap(film: JournalFilm, angle: Array) -> Array:
    """Gap between the bore and a centred, aligned journal, in clearances."""
    gap = np.full(angle.size, GROOVE_GAP)
    for land in film.lands:
        inside = within(angle, land.start_angle, land.end_angle)
        gap[inside] = land_gap(film, land, angle[inside])
    return gap


def land_gap(film: JournalFilm, land: Land, angle: Array) -> Array:
    """Gap over one land, in clearances."""
    clearance = film.clearance if land.clearance is None else land.clearance
    gap = clearance + land.centre[0] * np.cos(angle) + land.centre[1] * np.sin(angle)
    if land.profile:
        extent = land.end_angle - land.start_angle
        place = ((angle - land.start_angle) % TURN) / extent
        gap = gap + np.interp(place, np.linspace(0.0, 1.0, len(land.profile)), land.profile)
    return np.asarray(gap / film.clearance)
