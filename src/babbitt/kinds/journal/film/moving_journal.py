"""A journal that moves in its film under a changing load, as the right-hand side of an equation of motion.

Without mass the velocity is that at which the film carries the load, found by Newton's method with the exact
damping; with mass the film force accelerates the journal. Lengths in clearances, times in radians that the journal
has turned.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.journal.film.changing_load import ChangingLoad
from babbitt.reynolds.equilibrium.many_positions import FilmPositions, PositionForces
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.model import JournalFilm, Resolution
from babbitt.reynolds.solution import FilmSolution

__all__ = ["MOST_FILMS", "HeavyJournal", "MasslessJournal", "MovingJournal", "NoMotionError"]

Array = NDArray[np.float64]

BALANCED, BALANCED_WHILE_MARCHING = 1e-7, 1e-4
"""Last Newton step of the velocity, relative; the error is of its square."""


MOST_FILMS = 20_000
"""Films of a march after which no further cycle begins, and of which no cycle takes twice as many more: ordinary
orbits take one to ten thousand (an assumption)."""


class NoMotionError(Exception):
    """The film gave no answer, or no velocity at which it carries the load, or the march took too many films."""


@dataclass(frozen=True, eq=False)
class FilmForce:
    """Force (N), stiffness (N/m) and damping (N s/m) of the film at one place and velocity."""

    force: Array
    stiffness: Array
    damping: Array


class MovingJournal:
    """The film as the right-hand side of an equation of motion."""

    def __init__(
        self, film: JournalFilm, steady: Array, changing: ChangingLoad, speed: float, resolution: Resolution
    ) -> None:
        self.film, self.steady, self.changing, self.resolution = film, steady, changing, resolution
        self.speed = speed
        self.c, self.rate = film.clearance, abs(speed)
        self.films = 0
        self._positions = FilmPositions(film, resolution)
        self._last_velocity = np.zeros(2)

    def load(self, turned: float) -> Array:
        """Load when the journal has turned by an angle in its own sense, N."""
        changing = self.changing.at(math.copysign(turned, self.speed))
        return np.asarray(self.steady + np.asarray(changing), dtype=np.float64)

    def film_at(self, place: Array, velocity: Array) -> FilmForce | None:
        """Film at a place and velocity; None where the journal touches the bore."""
        found = self._positions.coefficients(self._row(place, velocity))
        return FilmForce(found.force[0], found.stiffness[0], found.damping[0]) if _inside(found) else None

    def force_at(self, place: Array, velocity: Array) -> Array | None:
        """Force of the film, N, without the film that its coefficients cost; None where the journal touches."""
        found = self._positions.forces(self._row(place, velocity))
        return np.asarray(found.force[0]) if _inside(found) else None

    def _row(self, place: Array, velocity: Array) -> Array:
        """Place (m) and velocity (m/s) of one more film, shape (1, 4)."""
        self.films += 1
        if self.films > 3 * MOST_FILMS:
            raise NoMotionError
        row = np.concatenate(self.in_metres(place, velocity))[None, :]
        if not np.isfinite(row).all():  # a step has led nowhere
            raise NoMotionError
        return row

    def in_metres(self, place: Array, velocity: Array) -> tuple[Array, Array]:
        """Place (m) and velocity (m/s)."""
        return place * self.c, velocity * (self.c * self.rate)

    def solution_at(self, place: Array, velocity: Array) -> FilmSolution:
        """The film with its pressure, flows and torques."""
        at, moving = self.in_metres(place, velocity)
        found = film_at_position(
            self.film, (float(at[0]), float(at[1])), (float(moving[0]), float(moving[1])), self.resolution
        )
        if not found.outcome.solved:
            raise NoMotionError
        return found

    def balanced(self, turned: float, place: Array, last_step: float) -> tuple[Array, FilmForce | None]:
        """Velocity at which the film carries the load, and the film there; inward where there is contact."""
        load = self.load(turned)
        velocity = self._last_velocity
        before = math.inf
        for _ in range(40):
            film = self.film_at(place, velocity)
            if film is None:
                return -place / math.hypot(*place), None
            step = np.linalg.solve(film.damping, film.force + load) / (self.c * self.rate)
            size = math.hypot(*step)
            velocity = velocity + step * (1.0 if size < 2.0 * before else 0.5)
            before = size
            if size < last_step * (1.0 + math.hypot(*velocity)):
                self._last_velocity = velocity
                return velocity, film
        raise NoMotionError


def _inside(found: PositionForces) -> bool:
    """Whether a film stands at the only position asked for; False where the journal touches the bore."""
    if found.outside[0]:
        return False
    if not found.settled[0]:
        raise NoMotionError
    return True


class MasslessJournal(MovingJournal):
    """State: position."""

    def start(self, place: Array) -> Array:
        """State of a journal that stands at a place."""
        return place

    def slope(self, turned: float, state: Array) -> Array:
        """Change of the state over the angle turned."""
        return self.balanced(turned, state, BALANCED_WHILE_MARCHING)[0]

    def jacobian(self, turned: float, state: Array) -> Array:
        """Derivative of the slope by the state."""
        film = self.balanced(turned, state, BALANCED_WHILE_MARCHING)[1]
        if film is None:
            return -np.eye(2, dtype=np.float64)
        return np.asarray(-np.linalg.solve(film.damping, film.stiffness) / self.rate, dtype=np.float64)

    def film_of(self, turned: float, state: Array) -> tuple[Array, FilmSolution]:
        """Velocity and film of a state."""
        velocity, _ = self.balanced(turned, state, BALANCED)
        return velocity, self.solution_at(state, velocity)


class HeavyJournal(MovingJournal):
    """State: position and velocity. ``mass`` in kg."""

    def __init__(
        self,
        film: JournalFilm,
        steady: Array,
        changing: ChangingLoad,
        speed: float,
        resolution: Resolution,
        mass: float,
    ) -> None:
        super().__init__(film, steady, changing, speed, resolution)
        self.mass = mass

    def start(self, place: Array) -> Array:
        """State of a journal that stands at a place."""
        return np.concatenate((place, np.zeros(2)))

    def slope(self, turned: float, state: Array) -> Array:
        """Change of the state over the angle turned."""
        force = self.force_at(state[:2], state[2:])
        if force is None:
            return np.concatenate((-state[:2] / math.hypot(*state[:2]), np.zeros(2)))
        push = force + self.load(turned)
        return np.concatenate((state[2:], push / (self.mass * self.c * self.rate**2)))

    def jacobian(self, turned: float, state: Array) -> Array:
        """Derivative of the slope by the state."""
        film = self.film_at(state[:2], state[2:])
        whole = np.zeros((4, 4))
        whole[:2, 2:] = np.eye(2)
        if film is not None:
            whole[2:, :2] = -film.stiffness / (self.mass * self.rate**2)
            whole[2:, 2:] = -film.damping / (self.mass * self.rate)
        return whole

    def film_of(self, turned: float, state: Array) -> tuple[Array, FilmSolution]:
        """Velocity and film of a state."""
        return state[2:], self.solution_at(state[:2], state[2:])
