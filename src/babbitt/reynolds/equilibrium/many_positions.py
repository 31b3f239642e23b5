"""The film at many positions and velocities of the journal at once: forces, stiffness and damping as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.equilibrium.cavitating_film import groove_force, kernel_bearing
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.lands._batch import films_at
from babbitt.reynolds.lands._equilibrium import CONVERGED, NO_FILM
from babbitt.reynolds.lands._forces import RESULT_SIZE
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Resolution
from babbitt.reynolds.scales import Scales

if TYPE_CHECKING:
    from babbitt.reynolds.solution import FilmSolution
    from babbitt.reynolds.surface.ring_positions import RingForces, RingPositions

__all__ = ["FilmPositions", "PositionCoefficients", "PositionForces"]

Array = NDArray[np.float64]

MOST_FILMS = 200
"""Films at one position until its active set has converged."""


@dataclass(frozen=True, eq=False)
class PositionForces:
    """Forces at positions; every array has the positions as its first axis.

    Attributes
    ----------
    outside : ndarray of bool, shape (n,)
        Whether the position lies outside the clearance. Read this and `settled` first.
    settled : ndarray of bool, shape (n,)
        Whether the film was found.
    force : ndarray, shape (n, 2)
        On the journal, N.
    """

    outside: NDArray[np.bool_]
    settled: NDArray[np.bool_]
    force: Array


@dataclass(frozen=True, eq=False)
class PositionCoefficients(PositionForces):
    """Forces with their derivatives.

    Attributes
    ----------
    stiffness, damping : ndarray, shape (n, 2, 2)
        dF = -(K dx + C dx'), N/m and N s/m.
    """

    stiffness: Array
    damping: Array


class Loop:
    """A film as the compiled loop takes it; coefficients freed from the steps of the grid cost another film."""

    def __init__(self, film: JournalFilm, resolution: Resolution, smooth: bool) -> None:
        scales = Scales.of(film, abs(film.angular_speed))
        self.bearing = kernel_bearing(film, scales)._replace(smooth=smooth)
        self.axial = kernel_operator(resolution.axial_unknowns)
        self.intervals = (resolution.coarse_intervals, resolution.intervals)
        lengths = np.array([scales.length, scales.length, *2 * (scales.length * scales.rate,)])
        self.to_kernel = np.tile(scales.sense, 2) / lengths
        self.grooves, self.force = groove_force(self.bearing), scales.sense * scales.force
        # a vector is mirrored by `sense`, a matrix from both sides
        self.stiffness = np.outer(scales.sense, scales.sense) * (scales.force / scales.length)
        self.damping = self.stiffness / scales.rate

    def run(self, places: Array) -> tuple[NDArray[np.int64], Array]:
        """Status and vector of results, dimensionless, at rows of x, y and their rates."""
        statuses, results = np.empty(len(places), np.int64), np.empty((len(places), RESULT_SIZE))
        films_at(self.axial, self.bearing, *self.intervals, places * self.to_kernel, MOST_FILMS, statuses, results)
        return statuses, results


class FilmPositions:
    """One film, prepared for many positions of its journal.

    Parameters
    ----------
    film : JournalFilm
    resolution : Resolution

    Notes
    -----
    Films that separate into modes of the width, from grooves without pressure, run through a compiled loop; those
    that differ across the width are solved one by one, node by node, and all others by
    `babbitt.reynolds.equilibrium.position.film_at_position`, whose numbers all have.
    """

    def __init__(self, film: JournalFilm, resolution: Resolution) -> None:
        self.film, self.resolution = film, resolution

    @property
    def by_loop(self) -> bool:
        """Whether the film runs through the compiled loop."""
        film = self.film
        return (
            not film.is_surface
            and film.angular_speed != 0.0
            and film.film_start is FilmStart.GROOVE
            and film.cavitation is not Cavitation.HALF_SOMMERFELD
        )

    @cached_property
    def _of_forces(self) -> Loop | None:
        return Loop(self.film, self.resolution, False) if self.by_loop else None

    @cached_property
    def _of_coefficients(self) -> Loop | None:
        return Loop(self.film, self.resolution, True) if self.by_loop else None

    @cached_property
    def _by_nodes(self) -> RingPositions | None:
        film = self.film
        if not film.is_surface or film.angular_speed == 0.0 or film.cavitation is Cavitation.HALF_SOMMERFELD:
            return None
        from babbitt.reynolds.surface.ring_positions import RingPositions

        return RingPositions(film, self.resolution)

    def forces(self, places: Array) -> PositionForces:
        """Forces at rows of x, y (m) and their rates (m/s), shape (n, 4).

        Raises
        ------
        InputError
            E101 for what is not finite, and what `film_at_position` refuses.
        """
        require_finite(places)
        loop = self._of_forces
        if loop is None:
            return self._one_by_one(places)
        statuses, results = loop.run(places)
        outside, settled = statuses == NO_FILM, statuses == CONVERGED
        found = PositionForces(outside, settled, (results[:, :2] + loop.grooves) * loop.force)
        self._solve_again(found, places)
        return found

    def coefficients(self, places: Array) -> PositionCoefficients:
        """Forces, stiffness and damping at rows of x, y (m) and their rates (m/s), shape (n, 4).

        Raises
        ------
        InputError
            As `forces`.
        """
        require_finite(places)
        loop = self._of_coefficients
        if loop is None:
            return self._one_by_one(places)
        statuses, results = loop.run(places)
        found = PositionCoefficients(
            statuses == NO_FILM,
            statuses == CONVERGED,
            (results[:, :2] + loop.grooves) * loop.force,
            results[:, 2:6].reshape(-1, 2, 2) * loop.stiffness,
            results[:, 6:].reshape(-1, 2, 2) * loop.damping,
        )
        self._solve_again(found, places)
        return found

    def _solve_again(self, found: PositionForces, places: Array) -> None:
        """Lines that share their modes may flicker as one; nodes seldom do."""
        if found.settled.all():
            return
        for row in np.flatnonzero(~(found.settled | found.outside)):
            self._put(found, int(row), places[row])

    def _one_by_one(self, places: Array) -> PositionCoefficients:
        count = len(places)
        outside, settled = np.zeros(count, dtype=bool), np.zeros(count, dtype=bool)
        two, matrix = (count, 2), (count, 2, 2)
        found = PositionCoefficients(outside, settled, np.empty(two), np.empty(matrix), np.empty(matrix))
        for row, place in enumerate(places):
            self._put(found, row, place)
        return found

    def _put(self, found: PositionForces, row: int, place: Array) -> None:
        x, y, x_rate, y_rate = (float(part) for part in place)
        one: FilmSolution | RingForces
        if self._by_nodes is not None:
            one = self._by_nodes.at(place[:2], place[2:])
        else:
            one = film_at_position(self.film, (x, y), (x_rate, y_rate), self.resolution)
        found.outside[row], found.settled[row] = one.outcome is Outcome.OVERLOADED, one.outcome.solved
        found.force[row] = one.force
        if isinstance(found, PositionCoefficients):
            found.stiffness[row], found.damping[row] = one.stiffness, one.damping


def require_finite(places: Array) -> None:
    """Refuse positions and velocities that are not numbers, with E101."""
    if (found := np.isfinite(places).all(axis=1)).all():
        return
    row = int(np.flatnonzero(~found)[0])
    x, y, vx, vy = places[row]
    raise InputError(
        "E101",
        f"place {row + 1} of {len(places)} is not a finite number: x = {x:g} m, y = {y:g} m, vx = {vx:g} m/s, "
        f"vy = {vy:g} m/s; an integration comes to such a place where its last force was none.",
    )
