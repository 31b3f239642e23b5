"""Random films: load, oil, torque, heat and liquid fractions in order, and the same film at the position found.

The same by the thousand in `benchmarks/robustness/films.py`.
"""

import dataclasses

import films
import numpy as np
import pytest
from films import (
    film_faults,
    film_robustness,
    option_film,
    option_film_faults,
    option_films_faults,
    thermal_film_faults,
)

from babbitt.core.result import Outcome
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.heat import thermal_equilibrium as thermal
from babbitt.reynolds.heat.heat_model import FilmHeat
from babbitt.reynolds.model import Cavitation, JournalFilm, Land, Resolution, grooved_bore

NUMBER = 200
"""Films of one temperature, with options, and with temperatures of their own; those of the latter two in parts."""


def test_random_films_answer_for_their_balances():
    assert list(film_faults(6, NUMBER)) == []


@pytest.mark.parametrize("seed", [8, 9])
def test_random_films_with_every_option_answer_for_their_balances(seed):
    assert list(option_films_faults(seed, NUMBER // 2)) == []


@pytest.mark.parametrize("index", [98, 720, 932, 933])
def test_films_that_were_at_fault_answer_for_their_balances(index):
    """Starved under next to no load, a void of 1.05, nodes that flicker by a thousandth of the load."""
    assert list(option_film_faults(20261126, index)) == []


@pytest.mark.parametrize("wrong", [0.97, 1.03])
def test_another_force_at_the_position_is_a_fault(monkeypatch, wrong):
    def other(film, position, **grid):
        found = film_at_position(film, position, **grid)
        return dataclasses.replace(found, force=wrong * found.force)

    assert list(option_film_faults(7, 2)) == []
    monkeypatch.setattr(films, "film_at_position", other)
    (fault,) = option_film_faults(7, 2)
    assert "at its position another force" in fault


@pytest.mark.parametrize("unknowns", [4, 8])
def test_streamers_in_a_cavity_below_ambient_lack_no_more_than_all_oil(unknowns):
    """Single nodes of streamers beside oil that the sides draw in: 1.197 and 1.126 before they were bounded.

    What they overshoot is nothing to the film: its friction is that of a grid of eight times the nodes.
    """
    _, _, film, load = option_film(502, 336)
    found = solve_journal(film, load, Resolution(unknowns, 96))
    assert found.outcome is Outcome.CONVERGED
    assert 0.9 < found.void.max() <= 1.0
    fine = solve_journal(film, load, Resolution(8, 384))
    assert found.friction_torque == pytest.approx(fine.friction_torque, rel=0.005)
    assert found.minimum_film_thickness == pytest.approx(fine.minimum_film_thickness, rel=0.005)


@pytest.mark.parametrize("grid", [Resolution(4, 48), Resolution(4, 96)])
def test_a_film_whose_nodes_flicker_carries_its_load(grid):
    """On these lines no state of two nodes satisfies all rows, and the force is another by 1e-3 to 4e-3."""
    _, _, film, load = option_film(20261126, 932)
    found, fine = solve_journal(film, load, grid), solve_journal(film, load, Resolution(4, 384))
    assert found.outcome is Outcome.CONVERGED
    np.testing.assert_allclose(found.force, np.negative(load), atol=1e-4 * np.hypot(*load))
    assert found.minimum_film_thickness == pytest.approx(fine.minimum_film_thickness, rel=0.03)


@pytest.mark.parametrize(("seed", "index"), [(1, 17), (2, 575)])
def test_liquid_fractions_lie_between_none_and_all(seed, index):
    """Single nodes: streamers in cavities below ambient pressure, and in a bore that is uneven."""
    _, _, film, load = option_film(seed, index)
    found = solve_journal(film, load)
    assert found.outcome is Outcome.CONVERGED
    assert found.void.min() == 0.0
    assert 0.0 < found.void.max() <= 1.0


def test_a_search_that_meets_a_film_without_stiffness_ends_with_an_outcome():
    """At 47 nm, two halves apart, no number is left for the stiffness: such a film has not converged."""
    halves = (Land(0.15, 2.9916, 2.2138e-4, (7.1376e-5, 0.0)), Land(3.2916, 6.1332, 2.2138e-4, (-7.1376e-5, 0.0)))
    film = JournalFilm(
        0.264729, 0.309019, 1.70296e-4, 0.0409706, -9.18296, halves, Cavitation.REYNOLDS, cavitation_pressure=-5e4
    )
    assert solve_journal(film, (-273666.0, -672416.0)).outcome is Outcome.OVERLOADED


@pytest.mark.parametrize(("seed", "index"), [(6, 866), (6, 2247), (6, 2793), (71601, 644), (71603, 964)])
def test_films_whose_wet_set_flickers_are_found_at_their_position(seed, index):
    rng, kinds = np.random.default_rng(seed), list(film_robustness.KINDS)
    for before in range(index + 1):
        film, load = film_robustness.random_case(rng, kinds[before % len(kinds)])
    rest = solve_journal(film, load)
    found = film_at_position(film, tuple(rest.position))
    assert found.outcome is Outcome.CONVERGED
    np.testing.assert_allclose(found.force, rest.force, atol=0.01 * np.hypot(*load))


@pytest.mark.parametrize("seed", [11, 12, 13, 14])
def test_random_thermal_films_answer_for_their_balances(seed):
    assert list(thermal_film_faults(seed, NUMBER // 4)) == []


def thermal_faults_with(monkeypatch, name, wrong):
    """Of one film; `wrong` makes another function of what the benchmark calls `name`."""
    monkeypatch.setattr(films, name, wrong(getattr(films, name)))
    return list(thermal_film_faults(11, 1))


@pytest.mark.parametrize("other", [{"load": 0.999}, {"angle": 0.001}, {"angle": np.pi}])
def test_a_thermal_film_under_another_load_is_a_fault(monkeypatch, other):
    """Smaller, turned, or against its own: the film found carries the load that it says."""

    def wrong(solve):
        def of(case):
            duty = dataclasses.replace(case.duty, load=other.get("load", 1.0) * case.duty.load)
            turned = case.load_angle + other.get("angle", 0.0)
            return solve(dataclasses.replace(case, duty=duty, load_angle=turned))

        return of

    (fault,) = thermal_faults_with(monkeypatch, "thermal_operating_film", wrong)
    assert "load missed" in fault


@pytest.mark.parametrize("part", ["bearing_torque", "friction_torque"])
def test_another_torque_of_a_thermal_film_is_a_fault(monkeypatch, part):
    def wrong(solve):
        def of(case):
            found = solve(case)
            thermal = found.film.thermal
            other = dataclasses.replace(thermal.film, **{part: 1.001 * getattr(thermal.film, part)})
            thermal = dataclasses.replace(thermal, film=other)
            return dataclasses.replace(found, film=dataclasses.replace(found.film, thermal=thermal))

        return of

    (fault,) = thermal_faults_with(monkeypatch, "thermal_operating_film", wrong)
    assert "torque open" in fault


@pytest.mark.parametrize("share", [0.9, 1.1])
def test_another_force_of_a_thermal_film_at_its_position_is_a_fault(monkeypatch, share):
    def wrong(solve):
        def of(*given):
            found = solve(*given)
            return dataclasses.replace(found, film=dataclasses.replace(found.film, force=share * found.film.force))

        return of

    monkeypatch.setattr(films, "THERMAL_SHIFTED", 0.0)
    (fault,) = thermal_faults_with(monkeypatch, "thermal_film_at", wrong)
    assert "another force" in fault


def test_a_thermal_film_that_misses_its_load_has_not_converged(monkeypatch):
    film = JournalFilm(0.1, 0.06, 75e-6, 0.03, 200.0, grooved_bore((0.0, 3.14), 0.3))
    heat = FilmHeat(lambda temperature: 0.03 * 1.03 ** (323.15 - temperature), 1.72e6, 0.13, 323.15)
    loose = dataclasses.replace(thermal.THERMAL_ENGINEERING, tolerance=0.02)
    found = thermal.solve_thermal_journal(film, heat, (0.0, -6e3), loose)
    assert found.film.outcome is Outcome.CONVERGED
    assert found.film.force == pytest.approx([0.0, 6e3], abs=1e-4)
    monkeypatch.setattr(thermal, "POLISH", 0)
    found = thermal.solve_thermal_journal(film, heat, (0.0, -6e3), loose)
    assert found.film.outcome is Outcome.NOT_CONVERGED
