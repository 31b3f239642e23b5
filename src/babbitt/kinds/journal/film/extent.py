"""How much of the bearing carries a full film, and how much of the film is not laminar."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from babbitt.reynolds.solution import FilmSolution

__all__ = ["full_film_share", "turbulent_share"]

FULL = 1.0 - 1e-6
"""Liquid fraction from which a film counts as full."""


def full_film_share(solution: FilmSolution) -> float:
    """Share of the bearing surface with a full film, grooves, pockets and holes included."""
    from babbitt.kinds.journal.film.field import field_of

    found = field_of(solution, _first_line(solution))
    return _share(found.theta, found.liquid_fraction >= FULL)


def turbulent_share(solution: FilmSolution) -> float:
    """Share of the bearing surface where the local Reynolds number exceeds that at which vortices set in.

    Raises
    ------
    ValueError
        If the film was solved as laminar.
    """
    from babbitt.kinds.journal.film.field import field_of

    film = solution.film
    if film.turbulence is None:
        raise ValueError("the film was solved as laminar")
    found = field_of(solution, _first_line(solution))
    speed = 0.5 * film.diameter * abs(film.angular_speed)
    reynolds = film.turbulence.density * speed * found.film_thickness / film.viscosity  # nan over grooves: laminar
    return _share(found.theta, reynolds > film.turbulence.onset)


def _first_line(solution: FilmSolution) -> float:
    """Where the film begins, rad: a field that began at a place of the axes would have a line more there."""
    return float(solution.angles[0, 0])


def _share(theta: NDArray[np.float64], where: NDArray[np.bool_]) -> float:
    """Share of the unrolled surface, by the trapezoidal rule around and the mean across."""
    import numpy as np

    around = where.mean(axis=1)
    return float(np.trapezoid(around, theta) / (theta[-1] - theta[0]))
