"""The film at a prescribed position of the journal, by the rupture condition that it names."""

from __future__ import annotations

import math

from babbitt.core.notices import InputError
from babbitt.reynolds.equilibrium.cavitating_film import cavitating_film_at
from babbitt.reynolds.equilibrium.half_sommerfeld import half_sommerfeld_at
from babbitt.reynolds.model import ENGINEERING, Cavitation, JournalFilm, Resolution
from babbitt.reynolds.solution import FilmSolution

__all__ = ["film_at_position"]


def film_at_position(
    film: JournalFilm,
    position: tuple[float, float],
    velocity: tuple[float, float] = (0.0, 0.0),
    resolution: Resolution = ENGINEERING,
) -> FilmSolution:
    """Film at a prescribed journal position and velocity.

    Parameters
    ----------
    film : JournalFilm
    position, velocity : tuple of float
        Of the journal centre, m and m/s.
    resolution : Resolution

    Returns
    -------
    FilmSolution

    Raises
    ------
    InputError
        E101 if position or velocity are not finite, neither rotation nor velocity drive the film, or a
        mass-conserving film is only squeezed.
    """
    if not all(math.isfinite(part) for part in (*position, *velocity)):
        raise InputError(
            "E101", f"position is {position} and velocity {velocity}; every component must be finite."
        )
    if film.cavitation is Cavitation.HALF_SOMMERFELD:
        return half_sommerfeld_at(film, position, velocity, resolution)
    return cavitating_film_at(film, position, velocity, resolution)
