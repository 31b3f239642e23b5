"""The search for the coolest equilibrium, with films whose heat is a formula."""

import math
from dataclasses import dataclass, replace
from types import SimpleNamespace

import pytest

from babbitt.core.result import Outcome
from babbitt.design.conditions import HousingCooling
from babbitt.design.heat_balance import (
    BOLD,
    COARSE_SEARCH,
    FINE_SEARCH,
    NoFilmError,
    coolest_equilibrium,
    find_equilibrium,
)

COOLED = SimpleNamespace(oil_supply=None, cooling=HousingCooling(300.0, 1.0, 1.0))
"""Carries away 1 W for each kelvin above 300 K."""


@dataclass(frozen=True)
class Film:
    temperature: float
    friction_power: float
    volumetric_heat_capacity: float = 1.0
    total_flow: float = 0.0


def counted(heat, last=math.inf):
    """A film whose friction is `heat(temperature)`, up to a last temperature; and how often it was asked."""
    asked = []

    def film_at(temperature):
        asked.append(temperature)
        if temperature > last:
            raise NoFilmError(Outcome.OVERLOADED)
        return Film(temperature, heat(temperature))

    return film_at, asked


@pytest.mark.parametrize("policy", [FINE_SEARCH, COARSE_SEARCH])
@pytest.mark.parametrize("root", [300.4, 303.0, 341.7, 500.0])
def test_a_falling_friction_has_one_equilibrium(policy, root):
    film_at, asked = counted(lambda t: (root - 300.0) * math.exp((root - t) / 20.0))
    found = find_equilibrium(COOLED, film_at, policy)
    assert found.outcome is Outcome.CONVERGED
    assert found.last_temperature == pytest.approx(root, abs=1e-7)
    if policy is COARSE_SEARCH:
        assert len(asked) < 40


def test_the_sparing_search_finds_the_coolest_of_three_where_they_lie_kelvins_apart():
    # surplus positive, then negative between 330 and 338, positive to 346, negative from there
    def heat(t):
        return (t - 300.0) + 0.01 * (330.0 - t) * (338.0 - t) * (346.0 - t)

    found = find_equilibrium(COOLED, counted(heat)[0], COARSE_SEARCH)
    assert found.last_temperature == pytest.approx(330.0, abs=1e-6)


def test_the_sparing_search_sees_a_dip_between_its_steps():
    def heat(t):
        return (t - 300.0) + 0.05 * ((t - 345.0) ** 2 - 4.0)  # negative between 343 and 347 only

    found = find_equilibrium(COOLED, counted(heat)[0], COARSE_SEARCH)
    assert found.outcome is Outcome.CONVERGED
    assert found.last_temperature == pytest.approx(343.0, abs=1e-6)


@pytest.mark.parametrize("fold", [0.0, 10.0])
def test_a_film_that_gives_way_is_asked_few_times_beyond(fold):
    """Neither a steady surplus closes the balance nor one that ends as the root of the distance to a fold."""
    film_at, asked = counted(lambda t: 1000.0 + t + fold * math.sqrt(max(377.7 - t, 0.0)), last=377.7)
    found = find_equilibrium(COOLED, film_at, COARSE_SEARCH)
    assert found.outcome is Outcome.OVERLOADED
    assert found.film is not None
    assert 377.7 - COARSE_SEARCH.fine_step <= found.last_temperature <= 377.7
    assert sum(t > 377.7 for t in asked) <= 4
    assert len(asked) < 20


@pytest.mark.parametrize("depth", [0.05, 0.5, 5.0])
def test_a_balance_that_closes_in_the_fold_at_the_end_is_found(depth):
    last = 341.7
    film_at, _ = counted(lambda t: (t - 300.0) - depth + 10.0 * math.sqrt(max(last - t, 0.0)), last)
    found = find_equilibrium(COOLED, film_at, replace(COARSE_SEARCH, edge=1e-6))
    assert found.outcome is Outcome.CONVERGED
    assert found.last_temperature == pytest.approx(last - (depth / 10.0) ** 2, abs=1e-6)


def test_an_equilibrium_just_before_the_film_gives_way_is_found():
    film_at, _ = counted(lambda t: 60.0 * math.exp((360.0 - t) / 3.0), last=361.0)
    found = find_equilibrium(COOLED, film_at, COARSE_SEARCH)
    assert found.outcome is Outcome.CONVERGED
    assert found.last_temperature == pytest.approx(360.0, abs=1e-7)


def test_a_budget_that_runs_out_is_an_outcome():
    scarce = replace(COARSE_SEARCH, most_evaluations=5)
    film_at, asked = counted(lambda t: 1000.0 + t)
    found = find_equilibrium(COOLED, film_at, scarce)
    assert found.outcome is Outcome.NOT_CONVERGED
    assert found.film is not None
    assert len(asked) == found.evaluations == 5
    full = find_equilibrium(COOLED, counted(lambda t: 1000.0 + t)[0], COARSE_SEARCH)
    assert full.outcome is Outcome.THERMAL_RUNAWAY


@pytest.mark.parametrize("policy", [BOLD, COARSE_SEARCH, FINE_SEARCH])
def test_the_coolest_equilibrium_is_found_where_a_film_heats_up_again_before_it_gives_way(policy):
    """Surplus negative from 340 to 420 K alone, film up to 430 K: a long step leads beyond all of it."""
    film_at, _ = counted(lambda t: (t - 300.0) + (t - 340.0) * (t - 420.0) / 50.0, last=430.0)
    found = find_equilibrium(COOLED, film_at, policy)
    assert found.outcome is Outcome.CONVERGED
    assert found.last_temperature == pytest.approx(340.0, abs=1e-6)


def test_any_surplus_is_balanced_up_to_its_own_ceiling():
    """A film is what `film_at` gives: here its viscosity over that at 300 K, which heats it by 80 K times that."""

    def film_at(temperature):
        return math.exp((300.0 - temperature) / 30.0)

    def surplus(temperature, viscosity):
        return 80.0 * viscosity - (temperature - 300.0)

    found = coolest_equilibrium(film_at, surplus, 300.0, BOLD)
    assert found.outcome is Outcome.CONVERGED
    assert 80.0 * found.film == pytest.approx(found.last_temperature - 300.0, abs=1e-6)
    hotter = coolest_equilibrium(film_at, surplus, 300.0, BOLD, ceiling=320.0)
    assert (hotter.outcome, hotter.last_temperature) == (Outcome.THERMAL_RUNAWAY, 320.0)


def test_the_reason_why_a_film_gave_way_is_kept():
    def film_at(temperature):
        if temperature > 350.0:
            raise NoFilmError(Outcome.OVERLOADED, capacity=7.0)
        return Film(temperature, 1000.0)

    found = find_equilibrium(COOLED, film_at)
    assert found.outcome is Outcome.OVERLOADED
    assert found.failure is not None
    assert found.failure.capacity == 7.0


def test_a_film_that_is_not_found_a_second_time_is_an_outcome():
    """Films of a bore that gives way begin with what films before have told: one may be lost near its limit."""
    asked = set()

    def film_at(temperature):
        if temperature > 350.0 or (temperature in asked and temperature > 340.0):
            raise NoFilmError(Outcome.NOT_CONVERGED)
        asked.add(temperature)
        return Film(temperature, 50.05)

    found = find_equilibrium(COOLED, film_at, COARSE_SEARCH)
    assert (found.outcome, found.film) == (Outcome.NOT_CONVERGED, None)
    assert 349.0 < found.last_temperature <= 350.0


def test_a_gap_between_films_is_an_outcome():
    """Three films enclose a least surplus, and there is none where it would be."""

    def film_at(temperature):
        if 343.0 < temperature < 347.0:
            raise NoFilmError(Outcome.OVERLOADED)
        return Film(temperature, (temperature - 300.0) + 0.05 * ((temperature - 345.0) ** 2 + 4.0))

    found = find_equilibrium(COOLED, film_at, COARSE_SEARCH)
    assert found.outcome is Outcome.OVERLOADED
