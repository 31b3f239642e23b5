"""One film under many loads and at many speeds, its clearance, viscosity and supply kept: what maps and curves
show."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.kinds.journal.film.model import Accuracy, FilmCase
from babbitt.reynolds.model import FilmStart, JournalFilm, Resolution
from babbitt.reynolds.solution import attitude_angle, sommerfeld_number
from babbitt.reynolds.stability.rotor import RIGID, stable_masses_of_rotor

if TYPE_CHECKING:
    from babbitt.kinds.journal.film.isothermal import FilmState
    from babbitt.reynolds.lands.batch import BatchSolution
    from babbitt.reynolds.solution import FilmSolution

__all__ = ["FilmPoints", "ProgressCallback", "film_points", "no_progress"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class FilmPoints:
    """Equilibria of one film; every array has the points as its first axis.

    Attributes
    ----------
    film : JournalFilm
        At the operating point, from which the points differ in load and speed alone.
    load_angle : float
        rad.
    loads, speeds : ndarray, shape (n,)
        N; rad/s, positive whatever the sense of rotation.
    solved : ndarray of bool, shape (n,)
        Where there is an equilibrium; elsewhere the arrays below hold no numbers.
    position : ndarray, shape (n, 2)
        m.
    minimum_film_thickness : ndarray, shape (n,)
        m.
    stiffness, damping : ndarray, shape (n, 2, 2)
        N/m and N s/m.
    """

    film: JournalFilm
    load_angle: float
    loads: Array
    speeds: Array
    solved: NDArray[np.bool_]
    position: Array
    minimum_film_thickness: Array
    stiffness: Array
    damping: Array

    def converged(self) -> FilmPoints:
        """The points that have an equilibrium."""
        names = ("loads", "speeds", "solved", "position", "minimum_film_thickness", "stiffness", "damping")
        kept: dict[str, Any] = {name: getattr(self, name)[self.solved] for name in names}
        return replace(self, **kept)

    @property
    def eccentricity_ratio(self) -> Array:
        """Eccentricity over radial clearance, shape (n,)."""
        return np.asarray(np.hypot(*self.position.T) / self.film.clearance)

    @property
    def attitude_angle(self) -> Array:
        """From the load to the line of centres in the sense of rotation, rad, within (-π, π], shape (n,)."""
        return attitude_angle(self.film, self.position, self.load_angle)

    @property
    def sommerfeld_number(self) -> Array:
        """So of ISO 7902, shape (n,)."""
        return sommerfeld_number(self.film, self.loads, self.speeds)

    def stable_masses(self, shaft_stiffness: float = RIGID) -> tuple[Array, Array]:
        """Least and greatest mass of a rotor that is stable, kg, shape (n,) each; no numbers without film.

        The least is zero where light rotors are stable, the greatest infinite where heavy ones are; where none is
        stable the least is infinite and the greatest zero.
        """
        least, greatest = np.full(self.loads.shape, np.nan), np.full(self.loads.shape, np.nan)
        for place in np.flatnonzero(self.solved):
            found = stable_masses_of_rotor(self.stiffness[place], self.damping[place], shaft_stiffness)
            least[place], greatest[place] = found.least, found.greatest
        return least, greatest

    def critical_mass(self, shaft_stiffness: float = RIGID) -> Array:
        """Mass above which a rotor whirls, kg, shape (n,); infinite where none does, no number without film."""
        return self.stable_masses(shaft_stiffness)[1]


def film_points(
    case: FilmCase, state: FilmState, loads: ArrayLike, speeds: ArrayLike, watch: ProgressCallback = no_progress
) -> FilmPoints:
    """Find the equilibria of a film under other loads and at other speeds.

    Parameters
    ----------
    case : FilmCase
        Says the accuracy; a film each of whose points takes long is seen on a draft grid.
    state : FilmState
        The film at the operating point; the direction of its load, its sense of rotation, clearance, viscosity and
        supply pressures are kept.
    loads, speeds : array_like
        N and rad/s, positive; they broadcast to one axis of points.
    watch : ProgressCallback
        Follows the points of films that are solved one by one.

    Returns
    -------
    FilmPoints
        In the order of the points, those without an equilibrium included.
    """
    some_loads, some_speeds = (
        np.array(one, dtype=float) for one in np.broadcast_arrays(np.atleast_1d(loads), np.atleast_1d(speeds))
    )
    film, (fx, fy) = state.solution.film, state.solution.force
    angle = math.atan2(-fy, -fx)
    if _is_plain(film):
        return _at_once(film, angle, some_loads, some_speeds, case.accuracy.resolution)
    from babbitt.kinds.journal.film.isothermal import is_expensive
    from babbitt.kinds.journal.film.stable_equilibrium import place_of

    grid = (Accuracy.DRAFT if is_expensive(state) else case.accuracy).resolution
    return _one_by_one(film, angle, some_loads, some_speeds, grid, place_of(state.solution), watch)


def _is_plain(film: JournalFilm) -> bool:
    """Whether the film is one of those that are solved many at once."""
    round_lands = all(
        land.clearance in (None, film.clearance) and land.centre == (0.0, 0.0) and not land.profile
        for land in film.lands
    )
    counter_clockwise, vented = film.angular_speed > 0.0, film.cavitation_pressure == 0.0
    grooved = film.film_start is FilmStart.GROOVE and not film.is_surface
    return round_lands and counter_clockwise and vented and grooved


def _at_once(film: JournalFilm, angle: float, loads: Array, speeds: Array, grid: Resolution) -> FilmPoints:
    from babbitt.reynolds.lands.batch import solve_batch

    direction = np.array([math.cos(angle), math.sin(angle)])
    found: BatchSolution = solve_batch(
        film.diameter, film.width, film.clearance, film.viscosity, speeds, loads[:, None] * direction,
        tuple(replace(land, clearance=None) for land in film.lands), film.cavitation, grid,
    )  # fmt: skip
    one, four = np.where(found.solved, 1.0, np.nan), np.where(found.solved, 1.0, np.nan)[:, None, None]
    return FilmPoints(
        film, angle, loads, speeds, found.solved, found.position * one[:, None],
        found.minimum_film_thickness * one, found.stiffness * four, found.damping * four,
    )  # fmt: skip


def _one_by_one(
    film: JournalFilm,
    angle: float,
    loads: Array,
    speeds: Array,
    grid: Resolution,
    near: tuple[float, float],
    watch: ProgressCallback,
) -> FilmPoints:
    from babbitt.kinds.journal.film.stable_equilibrium import converged_film

    solved = np.zeros(loads.shape, dtype=bool)
    position, least = np.full((loads.size, 2), np.nan), np.full(loads.size, np.nan)
    stiffness, damping = np.full((loads.size, 2, 2), np.nan), np.full((loads.size, 2, 2), np.nan)
    for place in watch(range(loads.size)):
        turning = replace(film, angular_speed=math.copysign(float(speeds[place]), film.angular_speed))
        load = float(loads[place]) * math.cos(angle), float(loads[place]) * math.sin(angle)
        found: FilmSolution = converged_film(turning, load, grid, near)
        solved[place] = found.outcome.solved
        if found.outcome.solved:
            position[place], least[place] = found.position, found.minimum_film_thickness
            stiffness[place], damping[place] = found.stiffness, found.damping
    return FilmPoints(film, angle, loads, speeds, solved, position, least, stiffness, damping)
