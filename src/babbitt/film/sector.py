"""Film of a thrust pad: an annular sector, solved by the kernels of the journal film in another metric.

The runner turns in the sense of theta over a pad at rest. With r over the outer radius R, pressures over
mu omega (R/h_0)^2 and gaps over h_0 the Reynolds equation times r is

    d/dtheta [ r h/2 - h^3/(12 r) dp/dtheta ] - d/dr [ r h^3/12 dp/dr ] + r dh/dt = 0,

lines along r, elements of Lobatto points across the pad. Motions are those of a plane: z, and the slopes in
X = r cos(theta) and Y = r sin(theta), the gap changing by dh = z + a X + b Y.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.film._surface_film import (
    Surface,
    SurfaceWork,
    counted,
    new_surface_film,
    new_surface_work,
    smallest_surface_gap,
)
from babbitt.film._surface_forces import carry_streamers, drain_edge, evaluate_surface
from babbitt.film.axial import AxialMesh, element_axial_mesh
from babbitt.film.model import END_DAM, Cavitation
from babbitt.film.ring import gauss_angles
from babbitt.film.turbulence import FilmTurbulence
from babbitt.notices import InputError

__all__ = ["PlaneMotion", "SectorFilm", "SectorPad", "sector_film"]

Array = NDArray[np.float64]
SIDES, LEADING, TRAILING = -2, 0, 1


@dataclass(frozen=True)
class SectorPad:
    """A pad between two radii and two angles.

    Attributes
    ----------
    inner_radius, outer_radius : float
        m.
    extent : float
        From the leading edge at angle 0 to the trailing edge, rad.
    viscosity : float
        Pa s.
    angular_speed : float
        Of the runner, rad/s, positive.
    form : tuple of tuple of float
        Departure of the pad from a plane, m, positive away from the runner: rows at equally spaced angles from
        edge to edge, columns from the inner to the outer radius (crowning, taper, step). Empty: plane.
    leading_pressure : float
        Gauge, Pa, at the leading edge; the other edges are at ambient pressure, to which it falls over the last
        2.5 % of the pad at either side (``ring.END_DAM``).
    cavitation : Cavitation
        Mass-conserving or Reynolds.
    turbulence : FilmTurbulence or None
        None: laminar.
    """

    inner_radius: float
    outer_radius: float
    extent: float
    viscosity: float
    angular_speed: float
    form: tuple[tuple[float, ...], ...] = ()
    leading_pressure: float = 0.0
    cavitation: Cavitation = Cavitation.REYNOLDS
    turbulence: FilmTurbulence | None = None

    def __post_init__(self) -> None:
        if not 0.0 < self.inner_radius < self.outer_radius:
            raise InputError("E101", f"radii are {self.inner_radius} and {self.outer_radius} m; the inner must be "
                             "positive and less than the outer.")  # fmt: skip
        if not 0.0 < self.extent < 2.0 * math.pi:
            raise InputError("E101", f"extent is {self.extent} rad; it must lie between 0 and one turn.")
        for name in ("viscosity", "angular_speed"):
            if not (math.isfinite(getattr(self, name)) and getattr(self, name) > 0.0):
                raise InputError("E101", f"{name} is {getattr(self, name)}; it must be a positive number.")


@dataclass(frozen=True)
class PlaneMotion:
    """Gap of a plane, h = height + slope_x X + slope_y Y, or its rate; X = r cos(theta), Y = r sin(theta).

    m and 1, or m/s and 1/s.
    """

    height: float
    slope_x: float = 0.0
    slope_y: float = 0.0


@dataclass(frozen=True, eq=False)
class SectorFilm:
    """Film of a pad at a given gap.

    Attributes
    ----------
    pad : SectorPad
    solved : bool
        Whether the film met its cavitation condition.
    theta : ndarray, shape (n + 1,)
    radius : ndarray, shape (m,)
    pressure : ndarray, shape (n + 1, m)
        Gauge, Pa.
    liquid_fraction : ndarray, same shape
    forces : ndarray, shape (3,)
        Integrals of the pressure with 1, X and Y over the pad, N and N m.
    stiffness, damping : ndarray, shape (3, 3)
        forces change by -(K a + C a') with the motion a = (height, slope_x, slope_y).
    minimum_film_thickness : float
        At the Gauss points, m.
    inner_flow, outer_flow, leading_flow, trailing_flow : float
        Out of the pad over the inner, outer and trailing edge, and in over the leading edge, m3/s.
    friction_torque : float
        On the runner, N m.
    mass_balance_error : float
        Over the leading flow. Under the Reynolds condition a film that forms anew makes oil.
    """

    pad: SectorPad
    solved: bool
    theta: Array
    radius: Array
    pressure: Array
    liquid_fraction: Array
    forces: Array
    stiffness: Array
    damping: Array
    minimum_film_thickness: float
    inner_flow: float
    outer_flow: float
    leading_flow: float
    trailing_flow: float
    friction_torque: float
    mass_balance_error: float

    @property
    def load(self) -> float:
        """Force of the film, N."""
        return float(self.forces[0])

    @property
    def centre_of_pressure(self) -> tuple[float, float]:
        """X and Y of the resultant, m."""
        return float(self.forces[1] / self.forces[0]), float(self.forces[2] / self.forces[0])

    @property
    def maximum_pressure(self) -> float:
        """Highest gauge pressure on the nodes, Pa."""
        return float(self.pressure.max())


STILL = PlaneMotion(0.0)
MOST_ROUNDS = 200


def sector_film(
    pad: SectorPad, gap: PlaneMotion, rate: PlaneMotion = STILL, intervals: int = 32, degree: int = 8
) -> SectorFilm:
    """Film of a pad whose runner stands and moves as given.

    Parameters
    ----------
    pad : SectorPad
    gap, rate : PlaneMotion
    intervals : int
        Along the pad.
    degree : int
        Of the polynomial across it.

    Returns
    -------
    SectorFilm

    Raises
    ------
    InputError
        E101 if runner and pad touch.
    """
    height = reference_height(pad, gap)
    theta = np.linspace(0.0, pad.extent, intervals + 1)
    mesh = sector_mesh(pad, degree)
    unit = pad.viscosity * pad.angular_speed * (pad.outer_radius / height) ** 2
    surface = sector_surface(pad, theta, mesh, height, unit)
    lengths = np.array([height, height / pad.outer_radius, height / pad.outer_radius])
    at = -np.array([gap.height - height, gap.slope_x, gap.slope_y]) / lengths
    moving = -np.array([rate.height, rate.slope_x, rate.slope_y]) / (lengths * pad.angular_speed)
    lowest = float(smallest_surface_gap(surface, at))
    if not lowest > 0.0:
        raise InputError("E101", f"runner and pad touch, the least gap is {lowest * height} m; raise the height.")
    film, work = new_surface_film(surface), new_surface_work(surface)
    forces, stiffness, damping = np.zeros(3), np.zeros((3, 3)), np.zeros((3, 3))
    rounds = 0
    while rounds < MOST_ROUNDS:
        rounds += 1
        if evaluate_surface(surface, film, work, at, moving, False, forces, stiffness, damping) == 0:
            break
    evaluate_surface(surface, film, work, at, moving, True, forces, stiffness, damping)
    if not surface.conserving:
        carry_streamers(surface, film, work)
    fed = np.zeros(theta.size, dtype=bool)
    fed[[0, -1]] = True
    for edge in mesh.side_nodes:
        drain_edge(surface, film, work, edge, fed)
    # the motions of the kernels close the gap, and their forces push the pad's runner off: both signs turn
    area, flow = pad.outer_radius**2, pad.angular_speed * pad.outer_radius**2 * height
    levers = np.array([1.0, pad.outer_radius, pad.outer_radius])
    row = work.row * flow
    free = np.abs(row[~surface.held]).sum()
    leading = float(row[0].sum())
    return SectorFilm(
        pad=pad,
        solved=rounds < MOST_ROUNDS,
        theta=theta,
        radius=mesh.nodes * pad.outer_radius,
        pressure=work.pressure * unit,
        liquid_fraction=work.fill.copy(),
        forces=-forces * levers * (unit * area),
        stiffness=stiffness * np.outer(levers, 1.0 / lengths) * (unit * area),
        damping=damping * np.outer(levers, 1.0 / lengths) * (unit * area / pad.angular_speed),
        minimum_film_thickness=lowest * height,
        inner_flow=float(-row[1:-1, 0].sum()),
        outer_flow=float(-row[1:-1, -1].sum()),
        leading_flow=leading,
        trailing_flow=float(-row[-1].sum()),
        friction_torque=runner_torque(pad, surface, work, at)
        * pad.viscosity * pad.angular_speed * pad.outer_radius**4 / height,
        mass_balance_error=float(free / max(abs(leading), 1e-300)),
    )  # fmt: skip


def sector_mesh(pad: SectorPad, degree: int) -> AxialMesh:
    """Elements across the pad; short ones at its sides where oil under pressure enters at the leading edge."""
    inner = pad.inner_radius / pad.outer_radius
    if pad.leading_pressure <= 0.0:
        return element_axial_mesh((inner, 1.0), (degree,))
    dam = END_DAM * (1.0 - inner)
    return element_axial_mesh((inner, inner + dam, 1.0 - dam, 1.0), (2, degree, 2))


def reference_height(pad: SectorPad, gap: PlaneMotion) -> float:
    """Gap in the middle of the pad, m, in which gaps are measured: that at the axis may be none at all."""
    middle, angle = 0.5 * (pad.inner_radius + pad.outer_radius), 0.5 * pad.extent
    there = gap.height + middle * (gap.slope_x * math.cos(angle) + gap.slope_y * math.sin(angle))
    return there if there > 0.0 else max(abs(there), abs(gap.height))


def sector_surface(pad: SectorPad, theta: Array, mesh: AxialMesh, height: float, unit: float) -> Surface:
    """Nodes and metric of a pad; gaps in ``height``, pressures in ``unit``."""
    a, b = gauss_angles(theta)
    radius = mesh.points
    weights = mesh.share * (1.0 - pad.inner_radius / pad.outer_radius)
    held = np.zeros((theta.size, mesh.nodes.size), dtype=bool)
    held[0], held[-1], held[:, 0], held[:, -1] = True, True, True, True
    pressure = np.zeros(held.shape)
    inner = pad.inner_radius / pad.outer_radius
    aside = np.minimum(mesh.nodes - inner, 1.0 - mesh.nodes) / (1.0 - inner)
    pressure[0] = np.clip(aside / END_DAM, 0.0, 1.0) * pad.leading_pressure / unit
    ones = np.ones((theta.size - 1, radius.size))
    law = np.zeros(0) if pad.turbulence is None else pad.turbulence.kernel_row(unit_reynolds(pad, height))
    return Surface(
        **counted(mesh.nodes.size, radius.size, 3),
        step=np.diff(theta),
        shape_a=np.array([np.ones_like(a), np.cos(a), np.sin(a)]),
        shape_b=np.array([np.ones_like(b), np.cos(b), np.sin(b)]),
        lever=np.array([np.ones_like(radius), radius, radius]),
        gap_a=1.0 + form_at(pad, a, radius) / height,
        gap_b=1.0 + form_at(pad, b, radius) / height,
        viscosity=ones, drag=ones, turbulence=law, radius=radius, share=weights * radius,
        along=weights / radius, node=mesh.node_of_point, slope=mesh.slope, held=held, held_pressure=pressure,
        held_fill=np.ones(held.shape), piezo=np.zeros((3, 0)), cyclic=False, reference=0.0, kappa=1.0 / 12.0,
        speed=1.0, conserving=pad.cavitation is Cavitation.MASS_CONSERVING,
    )  # fmt: skip


def unit_reynolds(pad: SectorPad, height: float) -> float:
    """Reynolds number of a gap of ``height`` at the outer radius; 0 for a laminar film."""
    if pad.turbulence is None:
        return 0.0
    return pad.turbulence.density * pad.angular_speed * pad.outer_radius * height / pad.viscosity


def form_at(pad: SectorPad, angle: Array, radius: Array) -> Array:
    """Departure from the plane, m, linear between its values, shape (angles, radii)."""
    if not pad.form:
        return np.zeros((angle.size, radius.size))
    from scipy.interpolate import RegularGridInterpolator

    values = np.asarray(pad.form)
    rows = np.linspace(0.0, pad.extent, values.shape[0])
    columns = np.linspace(pad.inner_radius / pad.outer_radius, 1.0, values.shape[1])
    places = np.stack(np.meshgrid(angle, radius, indexing="ij"), axis=-1)
    return np.asarray(RegularGridInterpolator((rows, columns), values)(places))


def runner_torque(pad: SectorPad, surface: Surface, work: SurfaceWork, at: Array) -> float:
    """Integral of r (r mu/h + h/(2 r) dp/dtheta) r dr dtheta over mu omega R^4 / h_0."""
    pressure, fill = work.pressure, work.fill
    lift = at[:, None] * surface.lever
    ha, hb = surface.gap_a - surface.shape_a.T @ lift, surface.gap_b - surface.shape_b.T @ lift
    node, radius = surface.node, surface.radius
    half = 0.5 * surface.step[:, None]
    sheared = 1.0 / ha + 1.0 / hb
    if pad.turbulence is not None:
        reynolds = surface.turbulence[0] * radius
        sheared = pad.turbulence.shear_factor(reynolds * ha) / ha + pad.turbulence.shear_factor(reynolds * hb) / hb
    shear = surface.viscosity * half * sheared * fill[:-1][:, node] * radius**2
    slope = 0.25 * (ha + hb) * np.diff(pressure, axis=0)[:, node]
    return float(((shear + slope) @ surface.share).sum())
