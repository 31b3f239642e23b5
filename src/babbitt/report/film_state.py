"""The film behind a result."""

from __future__ import annotations

from babbitt.bearings.model import FilmCase
from babbitt.bearings.thermal_film import thermal_operating_film
from babbitt.bearings.warm_film import FilmState, film_at_temperature
from babbitt.results import Result

SLOW = 4500
"""Grid points of a film beyond which sweeps take seconds."""


def state_of(case: FilmCase, result: Result) -> FilmState:
    """The film of a solved result, from its effective temperature, or with its own temperatures found again."""
    if case.heat is not None:
        found = thermal_operating_film(case).film
        if found is None:
            raise ValueError("a film that was solved before")
        return found
    return film_at_temperature(result.values["effective_temperature"], case)


def is_slow(state: FilmState) -> bool:
    """Whether sweeps of this film take seconds."""
    return bool(state.solution.pressure.size > SLOW)
