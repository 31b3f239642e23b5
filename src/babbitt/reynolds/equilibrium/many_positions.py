"""The film at many positions and velocities of the journal at once: forces, stiffness and damping as arrays."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds._structs import Axial, Bearing
from babbitt.reynolds.equilibrium.cavitating_film import groove_force, kernel_bearing
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.lands._batch import films_at
from babbitt.reynolds.lands._equilibrium import CONVERGED, NO_FILM
from babbitt.reynolds.lands._forces import RESULT_SIZE
from babbitt.reynolds.lands.operators import kernel_operator
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Resolution
from babbitt.reynolds.scales import Scales

__all__ = ["FilmPositions", "PositionAnswers"]

Array = NDArray[np.float64]

MOST_FILMS = 200
"""Films at one position until its wet set has settled."""


@dataclass(frozen=True, eq=False)
class PositionAnswers:
    """Films at positions; every array has the positions as its first axis.

    Attributes
    ----------
    outside : ndarray of bool, shape (n,)
        Whether the position lies outside the clearance. Read this and `settled` first.
    settled : ndarray of bool, shape (n,)
        Whether the film was found.
    force : ndarray, shape (n, 2)
        On the journal, N.
    stiffness, damping : ndarray, shape (n, 2, 2)
        dF = -(K dx + C dx'), N/m and N s/m.
    """

    outside: NDArray[np.bool_]
    settled: NDArray[np.bool_]
    force: Array
    stiffness: Array
    damping: Array


class FilmPositions:
    """One film, prepared for many positions of its journal.

    Parameters
    ----------
    film : JournalFilm
    resolution : Resolution

    Notes
    -----
    Films that separate into modes of the width, from grooves without pressure, run through a compiled loop; all
    others are solved one by one by `babbitt.reynolds.equilibrium.position.film_at_position`.
    """

    def __init__(self, film: JournalFilm, resolution: Resolution) -> None:
        self.film, self.resolution = film, resolution
        self.by_loop = (
            not film.is_surface
            and film.angular_speed != 0.0
            and film.film_start is FilmStart.GROOVE
            and film.cavitation is not Cavitation.HALF_SOMMERFELD
        )
        self._forces, self._coefficients = (self._prepared(smooth) for smooth in (False, True))

    def forces(self, places: Array) -> PositionAnswers:
        """Forces at rows of x, y (m) and their rates (m/s), shape (n, 4); coefficients as far as they come along.

        Raises
        ------
        InputError
            E101 for what is not finite, and what `film_at_position` refuses.
        """
        return self._answers(places, self._forces)

    def coefficients(self, places: Array) -> PositionAnswers:
        """Forces, stiffness and damping at rows of x, y (m) and their rates (m/s), shape (n, 4).

        Raises
        ------
        InputError
            As `forces`.
        """
        return self._answers(places, self._coefficients)

    def _prepared(self, smooth: bool) -> tuple[Scales, Bearing, Axial, Array] | None:
        """What the compiled loop takes; coefficients freed from the steps of the grid cost another film."""
        if not self.by_loop:
            return None
        scales = Scales.of(self.film, abs(self.film.angular_speed))
        bearing = kernel_bearing(self.film, scales)._replace(smooth=smooth)
        return scales, bearing, kernel_operator(self.resolution.axial_unknowns), groove_force(bearing)

    def _answers(self, places: Array, prepared: tuple[Scales, Bearing, Axial, Array] | None) -> PositionAnswers:
        if not np.isfinite(places).all():
            raise InputError("E101", "a position or velocity is not a finite number.")
        if prepared is None:
            return _gathered([self._one(place) for place in places])
        scales, bearing, axial, grooves = prepared
        units = np.array([scales.length, scales.length, *2 * (scales.length * scales.rate,)])
        statuses, results = np.empty(len(places), np.int64), np.empty((len(places), RESULT_SIZE))
        films_at(
            axial, bearing, self.resolution.coarse_intervals, self.resolution.intervals,
            places * np.tile(scales.sense, 2) / units, MOST_FILMS, statuses, results,
        )  # fmt: skip
        # a vector is mirrored by `sense`, a matrix from both sides
        both = np.outer(scales.sense, scales.sense) * (scales.force / scales.length)
        found = PositionAnswers(
            outside=statuses == NO_FILM,
            settled=statuses == CONVERGED,
            force=(results[:, :2] + grooves) * scales.sense * scales.force,
            stiffness=results[:, 2:6].reshape(-1, 2, 2) * both,
            damping=results[:, 6:].reshape(-1, 2, 2) * (both / scales.rate),
        )
        for row in np.flatnonzero(~found.settled & ~found.outside):  # lines flicker as one; nodes seldom do
            self._put(found, row, self._one(places[row]))
        return found

    def _one(self, place: Array) -> PositionAnswers:
        x, y, x_rate, y_rate = (float(part) for part in place)
        one = film_at_position(self.film, (x, y), (x_rate, y_rate), self.resolution)
        return PositionAnswers(
            np.array([one.outcome is Outcome.OVERLOADED]),
            np.array([one.outcome.solved]),
            one.force[None],
            one.stiffness[None],
            one.damping[None],
        )

    @staticmethod
    def _put(found: PositionAnswers, row: int, one: PositionAnswers) -> None:
        for name in ("outside", "settled", "force", "stiffness", "damping"):
            getattr(found, name)[row] = getattr(one, name)[0]


def _gathered(answers: list[PositionAnswers]) -> PositionAnswers:
    names = ("outside", "settled", "force", "stiffness", "damping")
    shapes = ((0,), (0,), (0, 2), (0, 2, 2), (0, 2, 2))
    return PositionAnswers(
        *(
            np.concatenate([getattr(one, name) for one in answers]) if answers else np.empty(shape)
            for name, shape in zip(names, shapes, strict=True)
        )
    )
