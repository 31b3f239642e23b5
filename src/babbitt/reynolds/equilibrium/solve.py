"""The equilibrium of a journal in its film."""

from __future__ import annotations

import math

from babbitt.core.notices import InputError
from babbitt.reynolds.equilibrium.cavitating_film import equilibrium_from
from babbitt.reynolds.equilibrium.half_sommerfeld import half_sommerfeld_equilibrium
from babbitt.reynolds.equilibrium.loaded_side import from_loaded_side
from babbitt.reynolds.frame import LoadFrame
from babbitt.reynolds.model import ENGINEERING, Cavitation, FilmStart, JournalFilm, Resolution
from babbitt.reynolds.solution import FilmSolution

__all__ = ["solve_journal", "solve_journal_from"]


def solve_journal(
    film: JournalFilm, load: tuple[float, float], resolution: Resolution = ENGINEERING, *, max_steps: int = 80
) -> FilmSolution:
    """Find where the film carries a load.

    Parameters
    ----------
    film : JournalFilm
    load : tuple of float
        Force on the journal, N: (0, -W) hangs a weight W on it.
    resolution : Resolution
    max_steps : int
        Newton steps on each grid.

    Returns
    -------
    FilmSolution
        Always; ``outcome`` says whether it is an equilibrium.

    Raises
    ------
    InputError
        E101 if the load is not finite or the journal stands still.
    """
    if not all(math.isfinite(part) for part in load):
        raise InputError("E101", f"load is {load}; both components must be finite, in N.")
    if film.angular_speed == 0.0:
        raise InputError("E101", "angular_speed is zero; a film at rest carries no steady load. Give a speed, or "
                         "prescribe position and velocity (film_at_position).")  # fmt: skip
    if film.cavitation is Cavitation.HALF_SOMMERFELD:
        return half_sommerfeld_equilibrium(film, load, resolution)
    frame = LoadFrame.of(film, load)
    film, load = frame.film, frame.load
    found = equilibrium_from(film, load, resolution, max_steps, None)
    if not found.outcome.solved and film.film_start is not FilmStart.WIDEST_GAP and any(load):
        found = from_loaded_side(film, load, resolution, max_steps, found)
    return frame.back(found)


def solve_journal_from(
    film: JournalFilm, load: tuple[float, float], start: tuple[float, float], resolution: Resolution
) -> FilmSolution:
    """Find where the film carries a load in N, from the place in m of the journal in a film that hardly differs.

    One search and no other: `solve_journal` finds films far from the start, too.
    """
    frame = LoadFrame.of(film, load)
    return frame.back(equilibrium_from(frame.film, frame.load, resolution, 80, frame.start(start)))
