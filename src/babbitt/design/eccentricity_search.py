"""The film that carries a load with the least eccentricity, of films that are known by their eccentricity.

A film that heats up can carry less when pressed closer: the load passes a maximum, and no eccentricity bounds it
from above. It is therefore raised step by step to the first film that carries the load.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Protocol, TypeVar

import numpy as np

from babbitt.core.result import Outcome
from babbitt.design.heat_balance import NoFilmError
from babbitt.numerics.roots import find_root

__all__ = ["film_that_carries", "rising_eccentricities"]

LEAST = 1e-6
"""Eccentricity ratio of a film that carries next to nothing."""
LOAD_TOLERANCE = 1e-4
"""Of the load over the one asked for: one that jumps is not met."""


class LoadedFilm(Protocol):
    """A film with its load (N) and eccentricity ratio."""

    @property
    def load(self) -> float: ...
    @property
    def eccentricity_ratio(self) -> float: ...


LoadedFilmT = TypeVar("LoadedFilmT", bound=LoadedFilm)


def rising_eccentricities(greatest: float) -> tuple[float, ...]:
    """Eccentricity ratios of a search, up to the greatest: closer where the load rises steeply."""
    return (*np.arange(0.02, 0.9, 0.04).tolist(), *np.arange(0.9, greatest + 1e-4, 0.01).tolist())


def film_that_carries(
    load: float,
    films: Iterable[LoadedFilmT],
    film_near: Callable[[float, LoadedFilmT], LoadedFilmT],
    tolerance: float = 1e-10,
) -> LoadedFilmT:
    """Film that carries a load.

    Parameters
    ----------
    load : float
        N.
    films : iterable
        With rising eccentricity, as far as there are any.
    film_near : callable
        Film at an eccentricity ratio, begun from one nearby.
    tolerance : float
        Of the eccentricity ratio.

    Raises
    ------
    NoFilmError
        OVERLOADED with the largest load reached; NOT_CONVERGED where the load jumps past the one asked for.
    """
    best, below = 0.0, LEAST
    for film in films:
        best = max(best, film.load)
        if film.load >= load:
            break
        below = film.eccentricity_ratio
    else:
        raise NoFilmError(Outcome.OVERLOADED, best)
    root = find_root(lambda at: film_near(at, film).load - load, below, film.eccentricity_ratio, tolerance)
    found = film_near(root.value, film)
    if not root.converged or abs(found.load / load - 1.0) > LOAD_TOLERANCE:
        raise NoFilmError(Outcome.NOT_CONVERGED)
    return found
