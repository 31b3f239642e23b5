"""The unrolled bearing of a film that differs across the width: nodes, what is held, and the gap.

One surface from a groove once round the bearing (or a closed ring where no groove spans the width). Lines fall on
every groove and pocket edge; axial elements end on every pocket edge, for the pressure has kinks there
(``mesh_lines``).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.lands.axial import AxialMesh
from babbitt.reynolds.model import END_DAM, Cavitation, Field, FilmStart, JournalFilm, Land
from babbitt.reynolds.oil.piezoviscosity import pressure_table, reduced_pressure
from babbitt.reynolds.surface._surface_film import Surface
from babbitt.reynolds.surface.mesh_lines import Density, GrooveArc, axial_mesh, groove_arcs, ring_lines, within

__all__ = ["UnwrappedMesh", "build_ring"]

Array = NDArray[np.float64]
TURN = 2.0 * math.pi
GROOVE_GAP = 20.0  # gap over a groove or pocket, in clearances: deep, and never the smallest
PLUG = 1e12  # viscosity there


@dataclass(frozen=True, eq=False)
class UnwrappedMesh:
    """A surface for the kernels with what belongs to its nodes.

    Attributes
    ----------
    surface : Surface
    theta : ndarray, shape (n + 1,)
        Lines; the last closes the turn.
    mesh : AxialMesh
    supply : ndarray of int, shape (lines, nodes)
        Which groove or pocket holds a node, -1 none, -2 the side edge. Grooves count first, pockets after them.
    groove_lines : tuple of (int, int)
        First and last line of every groove.
    """

    surface: Surface
    theta: Array
    mesh: AxialMesh
    supply: NDArray[np.int64]
    groove_lines: tuple[tuple[int, int], ...]


def build_ring(
    film: JournalFilm, pressure_unit: float, per_turn: int, degree: int, density: Density | None, motions: int = 2
) -> UnwrappedMesh:
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
    density : callable or None
        Wanted density of lines at given angles, in any unit; None: uniform.
    motions : int
        2 for x and y, 4 with the tilts: what the journal axis gains in x and y from the mid-plane to the side.

    Returns
    -------
    UnwrappedMesh
    """
    mesh = axial_mesh(film, degree, halved=film.is_symmetric and motions == 2)
    grooves = _open_grooves(film)
    theta = _lines(film, per_turn, density)
    ends = tuple(lines_of_groove(arc, theta) for arc in grooves)
    inside = np.zeros(theta.size - 1, dtype=bool)
    for first, last in ends:
        inside[groove_lines(first, last, inside.size)[:-1]] = True
    base = -film.cavitation_pressure / pressure_unit  # ambient above cavitation
    table = piezo_table(film, pressure_unit, base)
    lines = theta.size if grooves else theta.size - 1
    held = hold_nodes(film, theta[:lines], mesh, grooves, ends)
    pressure = np.where(held.mask, held.pressure / pressure_unit + base, 0.0)
    places = gauss_angles(theta)
    gap_a, gap_b = gaps(film, theta, mesh, places)
    gap_a[inside], gap_b[inside] = GROOVE_GAP, GROOVE_GAP
    viscosity = viscosities(film, theta, mesh)
    viscosity[inside] = PLUG  # nothing flows in the groove itself: its ends are closed, and its nodes are held
    shapes = [shape_of_motions(angles, motions) for angles in places]
    levers = np.ones((motions, mesh.points.size))
    levers[2:] = mesh.points
    surface = Surface(
        nodes=mesh.nodes.size, points=mesh.points.size, motions=motions,
        step=theta[1:] - theta[:-1], shape_a=shapes[0], shape_b=shapes[1], lever=levers, gap_a=gap_a, gap_b=gap_b,
        opening_a=np.zeros_like(gap_a), opening_b=np.zeros_like(gap_b),
        viscosity=viscosity, drag=np.ones_like(gap_a), turbulence=turbulence_row(film),
        radius=np.ones_like(mesh.share), share=mesh.share, along=mesh.share, node=mesh.node_of_point,
        slope=mesh.slope, held=held.mask, held_pressure=reduced_in(table, pressure), held_fill=held.fill,
        piezo=table, cyclic=not grooves, reference=base + 0.5 * sum(film.side_pressures) / pressure_unit,
        kappa=(film.diameter / film.width) ** 2 / 12.0, speed=1.0 if film.angular_speed else 0.0,
        conserving=film.cavitation is Cavitation.MASS_CONSERVING,
    )  # fmt: skip
    return UnwrappedMesh(surface, theta, mesh, held.supply, ends)


def ring_shape(film: JournalFilm, per_turn: int, degree: int) -> tuple[int, int]:
    """Lines and nodes of a line of `build_ring` on uniform lines, for the motions x and y."""
    lines = _lines(film, per_turn, None).size
    nodes = axial_mesh(film, degree, halved=film.is_symmetric).nodes.size
    return (lines if _open_grooves(film) else lines - 1), nodes


def _open_grooves(film: JournalFilm) -> list[GrooveArc]:
    """Arcs that part the film; none of a closed ring."""
    return [gap for gap in groove_arcs(film) if film.film_start is not FilmStart.PERIODIC]


def _lines(film: JournalFilm, per_turn: int, density: Density | None) -> Array:
    """Angles of the lines of `build_ring`, rad, from behind the first groove or the seam of a closed ring."""
    order = film.land_order
    return ring_lines(film, film.lands[order[1 % len(order)]].start_angle, per_turn, density)


@dataclass(frozen=True, eq=False)
class HeldNodes:
    """Nodes at given pressure: which, gauge Pa, liquid fraction sent off, and by which supply (-2: the side)."""

    mask: NDArray[np.bool_]
    pressure: Array
    fill: Array
    supply: NDArray[np.int64]


def hold_nodes(
    film: JournalFilm, theta: Array, mesh: AxialMesh, grooves: list[GrooveArc], ends: Sequence[tuple[int, int]]
) -> HeldNodes:
    """Nodes held by grooves, whose first and last lines are ``ends``, pockets and sides.

    Where a groove as wide as the bearing is under pressure, its edge falls to that of the side over ``END_DAM``: a
    jump there would let out oil without bound, the more the finer the grid.
    """
    shape = (theta.size, mesh.nodes.size)
    held = HeldNodes(np.zeros(shape, dtype=bool), np.zeros(shape), np.ones(shape), np.full(shape, -1))
    sides = np.where(mesh.nodes < 0.0, film.side_pressures[0], film.side_pressures[1])
    share = np.minimum(np.maximum((1.0 - np.abs(mesh.nodes)) / (2.0 * END_DAM), 0.0), 1.0)
    for number, (arc, (first, last)) in enumerate(zip(grooves, ends, strict=True)):
        at = groove_lines(first, last, theta.size)
        held.mask[at], held.fill[at], held.supply[at] = True, arc.fill, number
        held.pressure[at] = sides + share * (arc.pressure - sides)
    for number, pocket in enumerate(film.pockets, len(grooves)):
        covered = axial_cover(film, pocket.axial_centre, pocket.axial_length, mesh)
        half = 0.5 * pocket.extent
        touched = within(theta, pocket.centre_angle - half, pocket.centre_angle + half)[:, None] & covered[None, :]
        held.mask[touched], held.fill[touched], held.supply[touched] = True, pocket.fill, number
        held.pressure[touched] = pocket.pressure
    edges = list(mesh.side_nodes)
    held.mask[:, edges], held.supply[:, edges] = True, -2  # their fill stays that of a groove that ends there
    held.pressure[:, edges] = sides[edges]
    return held


def piezo_table(film: JournalFilm, pressure_unit: float, base: float) -> Array:
    """Reduced pressure and pressure above cavitation and dp/dr of the oil; the kernels' units."""
    law = film.pressure_viscosity
    if law is None:
        return np.zeros((3, 0))
    table = pressure_table(law)
    table[:2] = table[:2] / pressure_unit + base
    return table if base == 0.0 else np.concatenate((np.array([[0.0], [0.0], [1.0]]), table), axis=1)


def reduced_in(table: Array, pressure: Array) -> Array:
    """Reduced pressure above cavitation."""
    return reduced_pressure(table, pressure) if table.size else pressure


def turbulence_row(film: JournalFilm) -> Array:
    """Law of the turbulent film as the kernels take it."""
    if film.turbulence is None:
        return np.zeros(0)
    speed = abs(film.angular_speed) * 0.5 * film.diameter
    return film.turbulence.kernel_row(film.turbulence.density * speed * film.clearance / film.viscosity)


def axial_cover(film: JournalFilm, centre: float, length: float, mesh: AxialMesh) -> NDArray[np.bool_]:
    """Nodes that a pocket covers, its edges included."""
    half = 0.5 * film.width
    low, high = (centre - 0.5 * length) / half, (centre + 0.5 * length) / half
    return np.asarray((mesh.nodes >= low - 1e-9) & (mesh.nodes <= high + 1e-9))


def lines_of_groove(arc: GrooveArc, theta: Array) -> tuple[int, int]:
    """Lines on both edges of a groove; the turn begins and closes at the last edge of the first groove."""
    first, last = ((edge - theta[0] + 1e-8) % TURN - 1e-8 for edge in (arc.first, arc.last))
    if first < 1e-7:
        first = TURN
    return int(np.abs(theta - theta[0] - first).argmin()), int(np.abs(theta - theta[0] - last).argmin())


def groove_lines(first: int, last: int, lines: int) -> NDArray[np.int64]:
    """Every line of a groove, that which closes the turn included."""
    return np.arange(first, (last if last >= first else last + lines) + 1) % lines


def gauss_angles(theta: Array) -> tuple[Array, Array]:
    """Both Gauss points of every interval, rad."""
    offset, middle = (theta[1:] - theta[:-1]) * (0.5 / math.sqrt(3.0)), 0.5 * (theta[1:] + theta[:-1])
    return middle - offset, middle + offset


def shape_of_motions(angle: Array, motions: int) -> Array:
    """cos and sin for x and y, and once more for the tilts; shape (motions, n)."""
    return np.array([np.cos(angle), np.sin(angle)] * (motions // 2))


def gaps(film: JournalFilm, theta: Array, mesh: AxialMesh, angles: tuple[Array, Array]) -> tuple[Array, Array]:
    """Gap of the centred journal at both Gauss points of every interval and axial point, in clearances.

    Grooves are not distinguished.
    """
    z = mesh.points * (0.5 * film.width)
    deeper = step_depths(film, theta, mesh)
    bores = np.split(gap_over_lands(film, np.concatenate(angles)), 2)
    more = [deeper if film.is_straight else deeper + axial_gain(film, angle, z) for angle in angles]
    first, second = (bore[:, None] + part / film.clearance for bore, part in zip(bores, more, strict=True))
    return first, second


def axial_gain(film: JournalFilm, angle: Array, z: Array) -> Array:
    """What the gap of the centred journal gains over that of the bore by tilt, crowning and displacement, m."""
    slope_x, slope_y = film.misalignment
    gain = -(slope_x * np.cos(angle) + slope_y * np.sin(angle))[:, None] * z[None, :]
    if film.crowning:
        gain = gain + np.interp(z, across(film, len(film.crowning)), film.crowning)[None, :]
    if film.displacement:
        gain = gain + field_at(film, film.displacement, angle, z)
    return np.asarray(gain)


def step_depths(film: JournalFilm, theta: Array, mesh: AxialMesh) -> Array:
    """Depth of the steps over every interval and point, m; lines and elements end on their edges."""
    depth = np.zeros((theta.size - 1, mesh.points.size))
    middle, centre = 0.5 * (theta[1:] + theta[:-1]), mesh.element_centres * (0.5 * film.width)
    for step in film.steps:
        half = 0.5 * step.extent
        along = within(middle, step.centre_angle - half, step.centre_angle + half)
        depth[np.ix_(along, np.abs(centre - step.axial_centre) < 0.5 * step.axial_length)] += step.depth
    return depth


def viscosities(film: JournalFilm, theta: Array, mesh: AxialMesh) -> Array:
    """Viscosity over the reference, at the middle of every interval and at the points, shape (n, points)."""
    z = mesh.points * (0.5 * film.width)
    found = np.ones((theta.size - 1, z.size))
    if film.axial_viscosity:
        found *= np.interp(z, across(film, len(film.axial_viscosity)), film.axial_viscosity)
    if film.viscosity_field:
        found *= field_at(film, film.viscosity_field, 0.5 * (theta[1:] + theta[:-1]), z)
    return found


def across(film: JournalFilm, count: int) -> Array:
    """Equally spaced places from side to side, m."""
    return np.linspace(-0.5 * film.width, 0.5 * film.width, count)


def field_at(film: JournalFilm, field: Field | Array, angle: Array, z: Array) -> Array:
    """Values of a field, linear between its own, shape (angles, z)."""
    values = np.asarray(field)
    columns = across(film, values.shape[1])
    share = ((angle - film.field_start) % TURN) / TURN * values.shape[0]
    row = share.astype(int) % values.shape[0]
    part = (share - np.floor(share))[:, None]
    around = (1.0 - part) * values[row] + part * values[(row + 1) % values.shape[0]]
    place = np.interp(z, columns, np.arange(columns.size))
    column = np.minimum(place.astype(int), max(columns.size - 2, 0))
    aside = place - column
    after = np.minimum(column + 1, columns.size - 1)
    return np.asarray((1.0 - aside) * around[:, column] + aside * around[:, after])


def gap_over_lands(film: JournalFilm, angle: Array) -> Array:
    """As `bore_gap` where there is a land; over grooves what is least work."""
    return np.ones(angle.size) if film.is_round else bore_gap(film, angle)


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
    gap = np.full(angle.size, clearance)
    if land.centre != (0.0, 0.0):
        gap += land.centre[0] * np.cos(angle) + land.centre[1] * np.sin(angle)
    if land.profile:
        extent = land.end_angle - land.start_angle
        place = ((angle - land.start_angle) % TURN) / extent
        gap = gap + np.interp(place, np.linspace(0.0, 1.0, len(land.profile)), land.profile)
    return np.asarray(gap / film.clearance)
