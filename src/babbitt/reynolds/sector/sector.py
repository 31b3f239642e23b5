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

from babbitt.core.notices import InputError
from babbitt.reynolds.lands.axial import AxialMesh
from babbitt.reynolds.model import Cavitation
from babbitt.reynolds.oil.turbulence import FilmTurbulence
from babbitt.reynolds.sector._sector_surface import reference_height, runner_torque, sector_mesh, sector_surface
from babbitt.reynolds.surface._surface_film import (
    Surface,
    SurfaceWork,
    liquid,
    new_surface_film,
    new_surface_work,
    smallest_surface_gap,
)
from babbitt.reynolds.surface._surface_forces import carry_streamers, drain_edge, evaluate_surface

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
    lengths = motion_lengths(pad, height)
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
    torque = (
        runner_torque(pad, surface, work, at) * pad.viscosity * pad.angular_speed * pad.outer_radius**4 / height
    )
    answers = (forces, stiffness, damping)
    return sector_answer(
        pad, surface, work, answers, (theta, mesh, height, unit), lowest, torque, rounds < MOST_ROUNDS
    )


def sector_answer(
    pad: SectorPad, surface: Surface, work: SurfaceWork, answers: tuple[Array, Array, Array],
    scales: tuple[Array, AxialMesh, float, float], lowest: float, torque: float, solved: bool,
) -> SectorFilm:  # fmt: skip
    """Film in SI from what the kernels left.

    Parameters
    ----------
    answers : tuple
        Forces, stiffness and damping of the kernels, in the motions of which the gap closes.
    scales : tuple
        Lines, mesh across, unit of the gap (m) and of the pressure (Pa).
    lowest : float
        Least gap over its unit.
    torque : float
        N m.
    """
    theta, mesh, height, unit = scales
    forces, stiffness, damping = answers
    lengths = motion_lengths(pad, height)
    # the motions of the kernels close the gap, and their forces push the pad's runner off: both signs turn
    area, flow = pad.outer_radius**2, pad.angular_speed * pad.outer_radius**2 * height
    levers = np.array([1.0, pad.outer_radius, pad.outer_radius])
    row = work.row * flow
    free = np.abs(row[~surface.held]).sum()
    leading = float(row[0].sum())
    return SectorFilm(
        pad=pad,
        solved=solved,
        theta=theta,
        radius=mesh.nodes * pad.outer_radius,
        pressure=work.pressure * unit,
        liquid_fraction=liquid(work.fill),
        forces=-forces * levers * (unit * area),
        stiffness=stiffness * np.outer(levers, 1.0 / lengths) * (unit * area),
        damping=damping * np.outer(levers, 1.0 / lengths) * (unit * area / pad.angular_speed),
        minimum_film_thickness=lowest * height,
        inner_flow=float(-row[1:-1, 0].sum()),
        outer_flow=float(-row[1:-1, -1].sum()),
        leading_flow=leading,
        trailing_flow=float(-row[-1].sum()),
        friction_torque=torque,
        mass_balance_error=float(free / max(abs(leading), 1e-300)),
    )


def motion_lengths(pad: SectorPad, height: float) -> Array:
    """Units of height and slopes: the gap, and the gap over the outer radius."""
    return np.array([height, height / pad.outer_radius, height / pad.outer_radius])
