"""From the shape of a bearing to the surface that the film kernels solve."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.hydrostatic.geometry import AnnularPad, CircularPad, RecessedJournal, RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.lines import Grid, across, between
from babbitt.reynolds.lands.axial import AxialMesh
from babbitt.reynolds.recess.recess_film import FilmScales, RecessSurface
from babbitt.reynolds.surface._surface_film import Surface
from babbitt.reynolds.surface.mesh_lines import within
from babbitt.reynolds.surface.unwrapped_mesh import gauss_angles

__all__ = ["FilmOil", "journal_surface", "pad_surface", "ring_surface"]

Array = NDArray[np.float64]
TURN = 2.0 * math.pi
DRAIN_GAP = 20.0  # gap over a drain groove, in clearances: deep, and never the smallest
EDGE = 0.12
"""Part of a land beside the recess that has an element of its own: the corner's singularity stays in it."""


@dataclass(frozen=True)
class FilmOil:
    """What the film needs of oil and operation.

    Attributes
    ----------
    viscosity : float
        Pa s.
    angular_speed : float
        rad/s, positive counter-clockwise.
    unit_pressure : float
        Pa, the size of pressures to come.
    cavitation_pressure : float
        Gauge, Pa, zero or below.
    """

    viscosity: float
    angular_speed: float
    unit_pressure: float
    cavitation_pressure: float = 0.0


def journal_surface(bearing: RecessedJournal, oil: FilmOil, grid: Grid, thinnest: float = 1.0) -> RecessSurface:
    """Half the width of a recessed journal bearing.

    Parameters
    ----------
    bearing : RecessedJournal
    oil : FilmOil
    grid : Grid
    thinnest : float
        Smallest gap to come over the clearance: with thin films two elements cover the outer land.

    Returns
    -------
    RecessSurface
        Motions x and y.
    """
    radius, c = bearing.radius, bearing.clearance
    theta, drained, open_at = lines_around(bearing, grid)
    recess_end = bearing.recess_length / bearing.width
    land = 1.0 - recess_end
    near = max(2, grid.degree // 2)
    mesh = across(
        (0.0, recess_end * 0.8, recess_end, recess_end + EDGE * land, 1.0),
        (max(2, grid.degree // 2), near, near, grid.degree),
    )
    cyclic = bearing.groove_extent == 0.0
    lines = theta.size - 1 if cyclic else theta.size
    recess = np.full((lines, mesh.nodes.size), -1)
    covered = mesh.nodes <= recess_end + 1e-9
    for k, angle in enumerate(bearing.recess_angles):
        half = 0.5 * bearing.recess_extent
        recess[np.ix_(within(theta[:lines], angle - half, angle + half), covered)] = k
    recess[open_at[:lines]] = -2
    recess[:, -1] = -2
    a, b = gauss_angles(theta)
    gap = np.where(drained[:, None], DRAIN_GAP, np.ones((theta.size - 1, mesh.points.size)))
    rate = oil.unit_pressure * (c / radius) ** 2 / oil.viscosity
    scales = FilmScales(
        np.array([c, c]), c, oil.unit_pressure, rate, rate * radius * c * bearing.width, radius * bearing.width
    )
    ones = np.ones_like(mesh.share)
    surface = film_surface(
        theta, mesh, recess, oil, scales, np.array([np.cos(a), np.sin(a)]), np.array([np.cos(b), np.sin(b)]),
        np.ones((2, ones.size)), gap, ones, mesh.share, (bearing.diameter / bearing.width) ** 2 / 12.0, cyclic,
    )  # fmt: skip
    return RecessSurface(
        surface, theta, mesh, recess, bearing.count, scales, np.zeros((2, bearing.count)),
        -oil.cavitation_pressure,
    )  # fmt: skip


def ring_surface(
    ring: ThrustRing | CircularPad | AnnularPad, height: float, oil: FilmOil, grid: Grid
) -> RecessSurface:
    """A whole ring, or a round pad from the edge of its recess outwards.

    Parameters
    ----------
    ring : ThrustRing, CircularPad or AnnularPad
    height : float
        Gap at rest, m.
    oil : FilmOil
    grid : Grid
        Pads whose recess goes all around take a twelfth of the lines.

    Returns
    -------
    RecessSurface
        Motions z and the tilts about x and y; all open the gap where they are positive.
    """
    round_pad = isinstance(ring, CircularPad)
    full = not isinstance(ring, ThrustRing)
    core = np.zeros((3, 1))
    near = max(2, grid.degree // 2)
    if isinstance(ring, CircularPad):
        outer, inner = ring.outer_radius, ring.recess_radius
        edges: tuple[float, ...] = (inner / outer, 1.0)
        degrees: tuple[int, ...] = (max(8, grid.degree),)
        core[0, 0] = ring.recess_area
        recess_radii = (0.0, inner / outer)
    else:
        radii = ring if isinstance(ring, AnnularPad) else ring.radii
        outer = radii.outer_radius
        r1, r2, r3, r4 = (r / outer for r in radii.radii)
        recess_radii = (r2, r3)
        edges = (r1, r2 - EDGE * (r2 - r1), r2, r3, r3 + EDGE * (r4 - r3), r4)
        degrees = (grid.degree, near, max(2, grid.degree // 2), near, grid.degree)
    mesh = across(edges, degrees)
    count = len(ring.recess_angles) if isinstance(ring, ThrustRing) else 1
    if isinstance(ring, ThrustRing):
        theta, drained, open_at = lines_around(ring, grid)
        cyclic = ring.groove_extent == 0.0
    else:
        theta = np.linspace(0.0, TURN, max(12, grid.per_turn // 4) + 1)
        drained, open_at = np.zeros(theta.size - 1, dtype=bool), np.zeros(theta.size, dtype=bool)
        cyclic = True
    lines = theta.size - 1 if cyclic else theta.size
    recess = np.full((lines, mesh.nodes.size), -1)
    covered = (mesh.nodes >= recess_radii[0] - 1e-9) & (mesh.nodes <= recess_radii[1] + 1e-9)
    if isinstance(ring, ThrustRing):
        half = 0.5 * ring.recess_extent
        for k, angle in enumerate(ring.recess_angles):
            recess[np.ix_(within(theta[:lines], angle - half, angle + half), covered)] = k
    else:
        recess[:, covered] = 0
    recess[open_at[:lines]] = -2
    recess[:, -1] = -2
    if not round_pad:
        recess[:, 0] = -2
    core = core if full else np.zeros((3, count))
    rate = oil.unit_pressure * (height / outer) ** 2 / oil.viscosity
    scales = FilmScales(
        -np.array([height, height / outer, height / outer]), height, oil.unit_pressure, rate,
        rate * outer**2 * height, outer**2,
    )  # fmt: skip
    a, b = gauss_angles(theta)
    radius = mesh.points
    gap = np.where(drained[:, None], DRAIN_GAP, np.ones((theta.size - 1, radius.size)))
    surface = film_surface(
        theta, mesh, recess, oil, scales, plane_shapes(a), plane_shapes(b),
        np.array([np.ones_like(radius), radius, radius]), gap, radius,
        mesh.share * (edges[-1] - edges[0]), 1.0 / 12.0, cyclic,
    )  # fmt: skip
    return RecessSurface(surface, theta, mesh, recess, count, scales, core, -oil.cavitation_pressure)


def plane_shapes(angle: Array) -> Array:
    """Gap of a ring that rises, and tilts about x and y: h = z + phi_x r sin - phi_y r cos."""
    return np.array([np.ones_like(angle), np.sin(angle), -np.cos(angle)])


def pad_surface(pad: RectangularPad, height: float, oil: FilmOil, grid: Grid) -> RecessSurface:
    """A rectangular pad, half of its width.

    Parameters
    ----------
    pad : RectangularPad
    height : float
        Gap at rest, m.
    oil : FilmOil
        Its speed is not used.
    grid : Grid

    Returns
    -------
    RecessSurface
        The only motion is z.
    """
    land, _ = pad.lands
    edges = np.array([0.0, land, land + pad.recess_length, pad.length]) / pad.length
    lines = between(edges, grid.per_turn, max(8, grid.per_turn // 4))
    end = pad.recess_width / pad.width
    near = max(2, grid.degree // 2)
    mesh = across(
        (0.0, 0.8 * end, end, end + EDGE * (1.0 - end), 1.0), (max(2, grid.degree // 2), near, near, grid.degree)
    )
    recess = np.full((lines.size, mesh.nodes.size), -1)
    inside = (lines >= edges[1] - 1e-12) & (lines <= edges[2] + 1e-12)
    recess[np.ix_(inside, mesh.nodes <= end + 1e-9)] = 0
    recess[0], recess[-1], recess[:, -1] = -2, -2, -2
    rate = oil.unit_pressure * (height / pad.length) ** 2 / oil.viscosity
    scales = FilmScales(
        -np.array([height]), height, oil.unit_pressure, rate, rate * pad.length * height * pad.width, pad.area
    )
    ones = np.ones_like(mesh.share)
    shape = np.ones((1, lines.size - 1))
    still = FilmOil(oil.viscosity, 0.0, oil.unit_pressure)
    surface = film_surface(
        lines, mesh, recess, still, scales, shape, shape, np.ones((1, ones.size)),
        np.ones((lines.size - 1, ones.size)), ones, mesh.share, (2.0 * pad.length / pad.width) ** 2 / 12.0, False,
    )  # fmt: skip
    return RecessSurface(surface, lines, mesh, recess, 1, scales, np.zeros((1, 1)))


def film_surface(
    theta: Array, mesh: AxialMesh, recess: NDArray[np.int64], oil: FilmOil, scales: FilmScales, shape_a: Array,
    shape_b: Array, lever: Array, gap: Array, radius: Array, weights: Array, kappa: float, cyclic: bool,
) -> Surface:  # fmt: skip
    """Surface for the kernels: laminar, of one viscosity, with Reynolds' condition."""
    ambient = -oil.cavitation_pressure / scales.pressure
    held = recess != -1
    ones = np.ones_like(gap)
    return Surface(
        nodes=mesh.nodes.size, points=mesh.points.size, motions=lever.shape[0],
        step=np.diff(theta), shape_a=shape_a, shape_b=shape_b, lever=lever, gap_a=gap, gap_b=gap.copy(),
        opening_a=np.zeros_like(gap), opening_b=np.zeros_like(gap),
        viscosity=ones, drag=ones.copy(), turbulence=np.zeros(0), radius=radius, share=weights * radius,
        along=weights / radius, node=mesh.node_of_point, slope=mesh.slope, held=held,
        held_pressure=np.full(recess.shape, ambient), held_fill=np.ones(recess.shape), piezo=np.zeros((3, 0)),
        cyclic=cyclic, reference=ambient, kappa=kappa, speed=oil.angular_speed / scales.rate, conserving=False,
    )  # fmt: skip


def lines_around(
    bearing: RecessedJournal | ThrustRing, grid: Grid
) -> tuple[Array, NDArray[np.bool_], NDArray[np.bool_]]:
    """Lines over a turn, which intervals are drain grooves, and which lines stand at ambient pressure."""
    angles = sorted(angle % TURN for angle in bearing.recess_angles)
    half, groove = 0.5 * bearing.recess_extent, 0.5 * bearing.groove_extent
    drains = []
    if groove > 0.0:
        ends = [*angles[1:], angles[0] + TURN]
        drains = [(0.5 * (one + two) - groove, 0.5 * (one + two) + groove)
                  for one, two in zip(angles, ends, strict=True)]  # fmt: skip
    start = drains[-1][1] - TURN if drains else angles[0] - half
    marks = {0.0, TURN}
    for first, last in [*((angle - half, angle + half) for angle in angles), *drains]:
        marks |= {round((edge - start + 1e-9) % TURN - 1e-9, 11) + 0.0 for edge in (first, last)}
    edges = np.array(sorted(marks))
    edges = edges[np.concatenate(([True], np.diff(edges) > 1e-8))]
    theta = between(edges, grid.per_turn / TURN)
    centre = 0.5 * (theta[1:] + theta[:-1]) + start
    theta = theta + start
    drained, open_at = np.zeros(centre.size, dtype=bool), np.zeros(theta.size, dtype=bool)
    for first, last in drains:
        drained |= within(centre, first, last)
        open_at |= within(theta, first, last)
    return theta, drained, open_at
