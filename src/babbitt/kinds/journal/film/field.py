"""Pressure, liquid fraction and gap of a solved film over the whole bore, wherever they are asked for."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.model import FilmStart, JournalFilm
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.surface.mesh_lines import groove_arcs
from babbitt.reynolds.surface.unwrapped_mesh import axial_gain, bore_gap

__all__ = [
    "FilmField",
    "StepPatch",
    "SupplyPatch",
    "between",
    "clearance_outline",
    "field_of",
    "inside",
    "journal_gap",
    "highest_pressure",
    "narrowest_gap_angle",
    "pressure_on",
    "step_patches",
    "supply_patches",
]

Array = NDArray[np.float64]
TURN = 2.0 * math.pi

AXIAL_POINTS = 41
"""Across the width; odd, so that the mid-plane is one of them."""

ALL_AROUND = 1440
"""Directions in which the narrowest gap is looked for; a parabola refines it."""

EDGE = 1e-7
"""Angle in rad by which a point must lie inside a groove to count as in it."""


@dataclass(frozen=True, eq=False)
class FilmField:
    """A film on a rectangular grid over the unrolled bore.

    Attributes
    ----------
    theta : ndarray, shape (n,)
        rad, counter-clockwise from +x, ascending over one turn, both ends included. The lines of the film are
        among them.
    z : ndarray, shape (k,)
        m, from one side edge to the other.
    pressure : ndarray, shape (n, k)
        Gauge, Pa.
    liquid_fraction : ndarray, shape (n, k)
        1 where the film is full.
    film_thickness : ndarray, shape (n, k)
        m; not a number over grooves, pockets and holes.
    """

    theta: Array
    z: Array
    pressure: Array
    liquid_fraction: Array
    film_thickness: Array

    @property
    def mid_plane_pressure(self) -> Array:
        """Gauge pressure in the mid-plane, Pa, shape (n,)."""
        return self.pressure[:, self.z.size // 2]


@dataclass(frozen=True)
class SupplyPatch:
    """A groove, pocket or hole on the unrolled bore: rad and m, from the lower to the upper end."""

    theta: tuple[float, float]
    z: tuple[float, float]
    pressure: float


@dataclass(frozen=True)
class StepPatch:
    """A step on the unrolled bore: rad and m, from the lower to the upper end, and its depth in m."""

    theta: tuple[float, float]
    z: tuple[float, float]
    depth: float


def field_of(solution: FilmSolution, start: float = 0.0) -> FilmField:
    """Film over the bore, from an angle once around.

    Parameters
    ----------
    solution : FilmSolution
    start : float
        First angle, rad.

    Returns
    -------
    FilmField

    Notes
    -----
    Across the width the pressure of a full line is the polynomial that the film engine solved for. On a line that
    is partly ruptured, or on the edge of a groove, it is monotone between the nodes, where a polynomial would
    swing. Around the bore it is linear between the lines.
    """
    film, half = solution.film, 0.5 * solution.film.width
    z = np.linspace(-half, half, AXIAL_POINTS)
    lines = solution.angles.ravel()
    patches = supply_patches(film)
    flanks = [
        end
        for first, last in (patch.theta for patch in patches)
        for end in (first + 2.0 * EDGE, last - 2.0 * EDGE)
    ]
    inner = start + np.remainder(np.concatenate((lines, flanks)) - start, TURN)
    theta = np.unique(np.concatenate(([start], inner, [start + TURN])).round(12))
    pressure = _around(theta, lines, _across(solution, z))
    void = _around(theta, lines, _void_across(solution, z))
    gap = journal_gap(solution, theta, z)
    for patch in patches:
        over = np.ix_(inside(theta, patch.theta), between(z, patch.z))
        pressure[over], void[over], gap[over] = patch.pressure, 0.0, math.nan
    return FilmField(theta, z, pressure, 1.0 - void, gap)


def pressure_on(solution: FilmSolution, theta: Array, z: Array) -> Array:
    """Gauge pressure in Pa at angles (rad) and axial places (m), as `field_of` has it; shape (theta, z)."""
    return _around(theta, solution.angles.ravel(), _across(solution, z))


def highest_pressure(solution: FilmSolution) -> float:
    """Highest gauge pressure of the field, Pa: it may lie between the nodes, where the sides are not alike."""
    lines = solution.pressure.reshape(-1, solution.axial_positions.size)[~_monotone(solution)]
    z = np.linspace(-0.5, 0.5, AXIAL_POINTS) * solution.film.width
    places = np.abs(z) if solution.axial_positions[0] >= 0.0 else z
    return max(solution.maximum_pressure, float((lines @ _polynomials(solution, places).T).max(initial=0.0)))


def journal_gap(solution: FilmSolution, theta: Array, z: Array) -> Array:
    """Gap between bore and journal, depth of grooves and pockets left out, m, shape (theta, z)."""
    x, y = solution.position
    bore = centred_gap(solution.film, theta, z)
    return np.asarray(bore - x * np.cos(theta)[:, None] - y * np.sin(theta)[:, None])


def centred_gap(film: JournalFilm, theta: Array, z: Array) -> Array:
    """Gap around the centred journal with tilt, steps, crowning and displacement, m, shape (theta, z)."""
    gap = film.clearance * bore_gap(film, theta)[:, None] + axial_gain(film, theta, z)
    for step in step_patches(film):
        gap[np.ix_(inside(theta, step.theta), between(z, step.z))] += step.depth
    return np.asarray(gap)


def bore_outline(film: JournalFilm, theta: Array) -> Array:
    """Least gap across the width around the centred journal, m, shape (theta,)."""
    return np.asarray(centred_gap(film, theta, np.linspace(-0.5, 0.5, 9) * film.width).min(axis=1))


def narrowest_gap_angle(solution: FilmSolution) -> float:
    """Direction of the narrowest gap outside grooves, pockets and holes, rad within (-pi, pi]."""
    theta, film = np.linspace(-math.pi, math.pi, ALL_AROUND, endpoint=False), solution.film
    alike = film.is_straight and not (film.steps or film.pockets)  # then one place of the width tells all
    z = np.linspace(-0.5, 0.5, 1 if alike else AXIAL_POINTS) * film.width
    gap = journal_gap(solution, theta, z)
    for patch in supply_patches(film):
        gap[np.ix_(inside(theta, patch.theta), between(z, patch.z))] = math.inf
    least = gap.min(axis=1)
    place = int(least.argmin())
    before, here, behind = least[[place - 1, place, (place + 1) % ALL_AROUND]]
    bend = before - 2.0 * here + behind
    aside = 0.5 * (before - behind) / bend if math.isfinite(bend) and bend > 0.0 else 0.0
    return math.pi - (math.pi - float(theta[place] + aside * TURN / ALL_AROUND)) % TURN


def step_patches(film: JournalFilm) -> tuple[StepPatch, ...]:
    """Every step of the bore."""
    return tuple(
        StepPatch(
            (step.centre_angle - 0.5 * step.extent, step.centre_angle + 0.5 * step.extent),
            (step.axial_centre - 0.5 * step.axial_length, step.axial_centre + 0.5 * step.axial_length),
            step.depth,
        )
        for step in film.steps
    )


def supply_patches(film: JournalFilm) -> tuple[SupplyPatch, ...]:
    """Everything that feeds a film, lines of supply without an extent included."""
    half = 0.5 * film.width
    grooves = groove_arcs(film) if film.film_start is FilmStart.GROOVE else ()
    return (
        *(SupplyPatch((arc.first, arc.last), (-half, half), arc.pressure) for arc in grooves),
        *(
            SupplyPatch(
                (pocket.centre_angle - 0.5 * pocket.extent, pocket.centre_angle + 0.5 * pocket.extent),
                (
                    pocket.axial_centre - 0.5 * pocket.axial_length,
                    pocket.axial_centre + 0.5 * pocket.axial_length,
                ),
                pocket.pressure,
            )
            for pocket in film.pockets
        ),
    )


def clearance_outline(film: JournalFilm, directions: Array) -> Array:
    """How far the centre of an aligned journal can move in each direction before it touches the bore, m.

    Parameters
    ----------
    film : JournalFilm
    directions : ndarray, shape (n,)
        rad.

    Returns
    -------
    ndarray, shape (n,)
        The radial clearance everywhere for a round bore without grooves.
    """
    angles = np.linspace(0.0, TURN, 1440, endpoint=False)
    gap = bore_outline(film, angles)
    towards = np.cos(angles[None, :] - directions[:, None])
    return np.asarray(np.where(towards > 1e-9, gap / np.maximum(towards, 1e-9), math.inf).min(axis=1))


def _around(theta: Array, lines: Array, rows: Array) -> Array:
    """Linear between the lines of the film, once around; shape (theta, columns of rows)."""
    within, wanted = lines % TURN, theta % TURN
    order = np.argsort(within)
    order = np.concatenate((order[-1:], order, order[:1]))
    at, values = within[order], rows[order]
    at[0], at[-1] = at[0] - TURN, at[-1] + TURN
    left = np.minimum(np.searchsorted(at, wanted, side="right") - 1, at.size - 2)
    slope = (values[left + 1] - values[left]) / (at[left + 1] - at[left])[:, None]
    return np.asarray(slope * (wanted - at[left])[:, None] + values[left])


def inside(theta: Array, ends: tuple[float, float]) -> NDArray[np.bool_]:
    """Which angles lie inside an arc of the unrolled bore."""
    first, last = ends
    return np.asarray(np.remainder(theta - first - EDGE, TURN) < last - first - 2.0 * EDGE)


def between(z: Array, ends: tuple[float, float]) -> NDArray[np.bool_]:
    """Which axial places lie between two ends, these included."""
    return np.asarray((z >= ends[0] - 1e-12) & (z <= ends[1] + 1e-12))


def _across(solution: FilmSolution, z: Array) -> Array:
    """Pressure of every line at axial places; shape (lines, z)."""
    from scipy.interpolate import PchipInterpolator

    nodes = solution.axial_positions
    symmetric = nodes[0] >= 0.0
    places = np.abs(z) if symmetric else z
    count = nodes.size
    lines = solution.pressure.reshape(-1, count)
    values = lines @ _polynomials(solution, places).T
    monotone = _monotone(solution)
    if symmetric:  # the mirror image makes the slope vanish in the mid-plane
        own, nodes = lines[monotone], np.concatenate((-nodes[:0:-1], nodes))
        mirrored = np.concatenate((own[:, :0:-1], own), axis=1)
    else:
        mirrored = lines[monotone]
    if monotone.any():
        values[monotone] = PchipInterpolator(nodes, mirrored, axis=1)(z)
    return np.asarray(np.maximum(values, solution.film.cavitation_pressure))


def _monotone(solution: FilmSolution) -> NDArray[np.bool_]:
    """Lines partly ruptured, and edges of grooves: level, and a step at the side; shape (lines,)."""
    count = solution.axial_positions.size
    ruptured = (solution.void.reshape(-1, count)[:, : count - 1] > 0.0).any(axis=1)
    level = np.ptp(solution.pressure.reshape(-1, count)[:, 1 : count - 1], axis=1) == 0.0
    return np.asarray(ruptured | level)


def _void_across(solution: FilmSolution, z: Array) -> Array:
    """Void of every line at axial places, linear between the nodes; shape (lines, z)."""
    nodes = solution.axial_positions
    void = solution.void.reshape(-1, nodes.size).copy()
    if solution.film.is_surface and solution.film.cavitation_pressure == 0.0:
        void[:, -1] = void[:, -2]  # no pressure drives oil in from the sides: the void reaches the edge
        if nodes[0] < 0.0:
            void[:, 0] = void[:, 1]
    places = np.abs(z) if nodes[0] >= 0.0 else z
    return np.array([np.interp(places, nodes, line) for line in void])


def _polynomials(solution: FilmSolution, places: Array) -> Array:
    """Matrix from the nodes of a line to axial places, shape (places, nodes): one polynomial per axial element."""
    nodes, breaks = solution.axial_positions, solution.axial_breaks
    if not breaks:
        full = np.concatenate((-nodes[:0:-1], nodes))
        matrix = _lagrange(full, places)
        folded = matrix[:, nodes.size - 1 :].copy()
        folded[:, 1:] += matrix[:, nodes.size - 2 :: -1]
        return folded
    matrix = np.zeros((places.size, nodes.size))
    for first, last in pairwise(breaks):
        here = (places >= nodes[first] - 1e-12) & (places <= nodes[last] + 1e-12)
        matrix[here] = 0.0
        matrix[here, first : last + 1] = _lagrange(nodes[first : last + 1], places[here])
    return matrix


def _lagrange(nodes: Array, places: Array) -> Array:
    """Values of the Lagrange polynomials of the nodes, shape (places, nodes)."""
    if nodes.size < 2:
        return np.ones((places.size, 1))
    apart = nodes[:, None] - nodes[None, :]
    np.fill_diagonal(apart, 1.0)
    factors = (places[:, None, None] - nodes[None, None, :]) / apart[None, :, :]
    own = np.arange(nodes.size)
    factors[:, own, own] = 1.0
    return np.asarray(factors.prod(axis=2))
