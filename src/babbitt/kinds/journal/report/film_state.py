"""The film behind a result."""

from __future__ import annotations

from dataclasses import replace

from babbitt.core.result import Result
from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.thermal_film import film_equilibrium

SLOW = 4500
"""Grid points of a film beyond which sweeps take seconds."""


def state_of(case: FilmCase, result: Result) -> FilmState:
    """The film of a solved result, from its effective temperature, or with its own temperatures found again."""
    if case.heat is None:
        case = replace(case, effective_temperature=result.values["effective_temperature"])
    found = film_equilibrium(case).film
    if found is None:
        raise ValueError(f"{result.name} has no film")
    return found


def is_slow(state: FilmState) -> bool:
    """Whether sweeps of this film take seconds."""
    return bool(state.solution.pressure.size > SLOW)
