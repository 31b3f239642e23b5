"""Films between recesses: pressures of the recesses in, flows, forces and all their derivatives out, in SI.

The recess is a region of the film that stands at one pressure. Flow of a recess: all that leaves it over its
edges, and the oil displaced inside.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.reynolds.lands.axial import AxialMesh
from babbitt.reynolds.recess._recess import unit_responses
from babbitt.reynolds.surface._surface_film import (
    Surface,
    SurfaceFilm,
    SurfaceWork,
    new_surface_film,
    new_surface_work,
    smallest_surface_gap,
)
from babbitt.reynolds.surface._surface_forces import evaluate_surface

__all__ = ["FilmScales", "RecessFilm", "RecessResponse", "RecessSurface"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class FilmScales:
    """What one of the kernels' units is in SI.

    Attributes
    ----------
    motion : ndarray, shape (motions,)
        m or rad; negative where a positive motion opens the gap.
    gap, pressure, rate, flow : float
        m, Pa, 1/s, m3/s.
    area : float
        Force over pressure, m2.
    """

    motion: Array
    gap: float
    pressure: float
    rate: float
    flow: float
    area: float


@dataclass(frozen=True, eq=False)
class RecessSurface:
    """A surface with recesses.

    Attributes
    ----------
    surface : Surface
    theta : ndarray
        Lines: rad, or a length over the unit of length.
    mesh : AxialMesh
    recess : ndarray of int, shape (lines, nodes)
        Recess of a node, -1 free, -2 at ambient pressure.
    count : int
        Number of recesses.
    scales : FilmScales
    core : ndarray, shape (motions, count)
        Force per pressure of recess area that the surface does not cover, m2 (a round pad's middle).
    ambient : float
        Ambient pressure above that of cavitation, Pa.
    """

    surface: Surface
    theta: Array
    mesh: AxialMesh
    recess: NDArray[np.int64]
    count: int
    scales: FilmScales
    core: Array
    ambient: float = 0.0


@dataclass(frozen=True, eq=False)
class RecessResponse:
    """The film at one position and recess pressures, with its derivatives at the standing active set.

    Attributes
    ----------
    force : ndarray, shape (motions,)
        N or N m.
    outflow : ndarray, shape (n,)
        Of every recess, m3/s.
    stiffness, damping : ndarray, shape (motions, motions)
        -dF/da and -dF/da' at standing recess pressures.
    conductance : ndarray, shape (n, n)
        dq/dp; symmetric.
    opening : ndarray, shape (n, motions)
        dq/da.
    area : ndarray, shape (motions, n)
        dF/dp; its transpose is dq/da'.
    changed : int
        Nodes that are on the wrong side of the rupture.
    """

    force: Array
    outflow: Array
    stiffness: Array
    damping: Array
    conductance: Array
    opening: Array
    area: Array
    changed: int


@dataclass(eq=False)
class RecessFilm:
    """A surface with its workspace; ``evaluate`` overwrites what it holds."""

    of: RecessSurface
    film: SurfaceFilm
    work: SurfaceWork
    force: Array
    stiffness: Array
    damping: Array
    psi: Array
    conductance: Array
    opening: Array
    area: Array

    @classmethod
    def on(cls, surface: RecessSurface) -> RecessFilm:
        """Workspace with all nodes wet."""
        motions, n = surface.surface.lever.shape[0], surface.count
        lines, nodes = surface.recess.shape
        return cls(
            surface,
            new_surface_film(surface.surface),
            new_surface_work(surface.surface),
            np.zeros(motions),
            np.zeros((motions, motions)),
            np.zeros((motions, motions)),
            np.zeros((n, lines, nodes)),
            np.zeros((n, n)),
            np.zeros((n, motions)),
            np.zeros((motions, n)),
        )

    def gap(self, at: Array) -> float:
        """Smallest gap at a position, m."""
        return float(smallest_surface_gap(self.of.surface, at / self.of.scales.motion)) * self.of.scales.gap

    def evaluate(self, at: Array, pressures: Array) -> RecessResponse:
        """Film at a position (m, rad) and recess pressures (gauge Pa); the active set then moves one step on."""
        of, scales = self.of, self.of.scales
        held = of.surface.held_pressure
        inside = of.recess >= 0
        held[inside] = (pressures[of.recess[inside]] + of.ambient) / scales.pressure
        changed = evaluate_surface(
            of.surface, self.film, self.work, at / scales.motion, np.zeros(at.size), False,
            self.force, self.stiffness, self.damping,
        )  # fmt: skip
        unit_responses(
            of.surface, self.film, self.work, of.recess, self.psi, self.conductance, self.opening, self.area
        )
        sense = scales.area * scales.gap / scales.motion  # forces work on motions: F_a = p A h / a
        force, flow = sense * scales.pressure, scales.flow
        rows = np.bincount(of.recess[inside], self.work.row[inside], of.count)
        outflow = np.asarray(rows * flow, dtype=np.float64)
        area = sense[:, None] * self.area
        return RecessResponse(
            force=self.force * force + of.core @ pressures,
            outflow=outflow,
            stiffness=self.stiffness * force[:, None] / scales.motion,
            damping=self.damping * force[:, None] / scales.motion / scales.rate,
            conductance=self.conductance * (flow / scales.pressure),
            opening=self.opening * flow / scales.motion,
            area=area + of.core,
            changed=int(changed),
        )

    def pressures(self) -> Array:
        """Gauge pressure on all nodes, Pa."""
        return self.work.pressure * self.of.scales.pressure - self.of.ambient
