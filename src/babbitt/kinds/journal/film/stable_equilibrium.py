"""Equilibrium of the journal under a load: that found first, unless the journal leaves it by itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from babbitt.reynolds.model import JournalFilm, Resolution
    from babbitt.reynolds.solution import FilmSolution

__all__ = ["converged_film", "held_place", "is_saddle", "place_of", "pushes_off"]

Place = tuple[float, float]
"""Of the journal centre, in clearances."""


def converged_film(
    film: JournalFilm, load: tuple[float, float], grid: Resolution, near: Place | None
) -> FilmSolution:
    """Film that carries a load, at a place where the journal stays if one is known.

    Parameters
    ----------
    film : JournalFilm
    load : tuple of float
        Force on the journal, N.
    grid : Resolution
    near : tuple of float or None
        A place where the journal stayed in a film like this one, in clearances.

    Returns
    -------
    FilmSolution
        The equilibrium found first. Where that is a saddle, which the smallest push makes the journal leave, the
        one nearest to `near`, if the journal stays there.
    """
    from babbitt.reynolds.equilibrium.solve import solve_journal

    found = solve_journal(film, load, grid)
    if near is None or not is_saddle(found):
        return found
    from babbitt.kinds.journal.film.equilibria import EquilibriumPoint
    from babbitt.reynolds.equilibrium.nearby import equilibrium_near

    other = equilibrium_near(film, load, (near[0] * film.clearance, near[1] * film.clearance), grid)
    return other if other is not None and EquilibriumPoint(other).holds else found


def held_place(found: FilmSolution, load: tuple[float, float], grid: Resolution) -> Place | None:
    """Place where a massless journal stays, in clearances: of several the one with the thinnest film; or None."""
    from babbitt.kinds.journal.film.equilibria import find_equilibria

    clearance = found.film.clearance
    held = [place.film for place in find_equilibria(found.film, load, grid, (found,)).places if place.holds]
    if not held:
        return None
    # rounded, so that of two mirror images always the one found first is taken
    thinnest = min(held, key=lambda one: round(one.minimum_film_thickness / clearance, 6))
    return place_of(thinnest)


def place_of(found: FilmSolution) -> Place:
    """Place of the journal centre, in clearances."""
    x, y = found.position / found.film.clearance
    return float(x), float(y)


def is_saddle(found: FilmSolution) -> bool:
    """Whether the journal always leaves an equilibrium position: det K < 0. Without stiffness nothing is known."""
    return found.outcome.solved and pushes_off(found.stiffness)


def pushes_off(stiffness: NDArray[np.float64]) -> bool:
    """Whether a stiffness makes a journal leave its place by itself: det K < 0."""
    (xx, xy), (yx, yy) = stiffness.tolist()
    return bool(xx * yy - xy * yx < 0.0)
