"""The search for the film that carries a load, with films whose load is a formula."""

from dataclasses import dataclass

import pytest

from babbitt.core.result import Outcome
from babbitt.design.eccentricity_search import film_that_carries, rising_eccentricities
from babbitt.design.heat_balance import NoFilmError

EVERY = rising_eccentricities(0.99)


@dataclass(frozen=True)
class Film:
    eccentricity_ratio: float
    load: float


def films(law):
    return (Film(at, law(at)) for at in EVERY), lambda at, _: Film(at, law(at))


def test_eccentricities_rise_to_the_greatest():
    assert list(EVERY) == sorted(EVERY)
    assert EVERY[-1] == pytest.approx(0.99)


@pytest.mark.parametrize("load", [1e-3, 0.3, 0.9])
def test_of_two_films_that_carry_a_load_the_wider_one_is_found(load):
    """Load 4 e (1 - e): the same at e and at 1 - e."""
    found = film_that_carries(load, *films(lambda e: 4.0 * e * (1.0 - e)))
    assert found.load == pytest.approx(load, rel=1e-6)
    assert found.eccentricity_ratio < 0.5


def test_a_load_beyond_all_films_tells_the_largest():
    with pytest.raises(NoFilmError) as told:
        film_that_carries(2.0, *films(lambda e: 4.0 * e * (1.0 - e)))
    assert told.value.outcome is Outcome.OVERLOADED
    assert told.value.capacity == pytest.approx(1.0, abs=1e-3)


def test_a_load_that_jumps_past_the_one_asked_for_is_not_met():
    with pytest.raises(NoFilmError) as told:
        film_that_carries(0.6, *films(lambda e: e if e < 0.55 else e + 0.2))
    assert told.value.outcome is Outcome.NOT_CONVERGED
