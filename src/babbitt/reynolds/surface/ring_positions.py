"""A film that differs across the width at many positions of its journal: forces without the rest of a solution."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome
from babbitt.reynolds.model import JournalFilm, Resolution
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.surface.closed_pocket_coefficients import closed_coefficients
from babbitt.reynolds.surface.surface_equilibrium import coarse_ring, ring_from
from babbitt.reynolds.surface.surface_solution import mirrored, outcome_of
from babbitt.reynolds.surface.unwrapped_mesh import UnwrappedMesh

__all__ = ["RingForces", "RingPositions"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class RingForces:
    """How the film at one position was found, and its force (N), stiffness (N/m) and damping (N s/m)."""

    outcome: Outcome
    force: Array
    stiffness: Array
    damping: Array


class RingPositions:
    """One film of a turning journal, prepared for many positions.

    Parameters
    ----------
    film : JournalFilm
        Of an angular speed.
    resolution : Resolution

    Notes
    -----
    The numbers are those of `babbitt.reynolds.equilibrium.position.film_at_position` to the last bit: the ring on
    which every position begins is built once, and flows, torques and fields are left out.
    """

    def __init__(self, film: JournalFilm, resolution: Resolution) -> None:
        self.resolution, self.scales = resolution, Scales.of(film, abs(film.angular_speed))
        self.seen = mirrored(film) if film.angular_speed < 0.0 else film

    @cached_property
    def _first(self) -> UnwrappedMesh:
        return coarse_ring(self.seen, self.scales.pressure, self.resolution)

    def at(self, position: Array, velocity: Array) -> RingForces:
        """Film at a position (m) and velocity (m/s) of the journal, each of shape (2,)."""
        scales = self.scales
        place = position * scales.sense / scales.length
        rate = velocity * scales.sense / (scales.length * scales.rate)
        settled = ring_from(self._first, self.seen, scales.pressure, place, rate, self.resolution)
        stiffness, damping = closed_coefficients(settled)
        frame, unit = np.outer(scales.sense, scales.sense), scales.force / scales.length
        return RingForces(
            outcome_of(settled),
            scales.sense * settled.sample.force * scales.force,
            frame * stiffness * unit,
            frame * damping * (unit / scales.rate),
        )
