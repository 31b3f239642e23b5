"""Films in bores that give way: limits, balances, and what softness does."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.result import Outcome
from babbitt.kinds.journal.film.elastic_film import (
    LESSONS,
    SETTLING,
    ElasticFilm,
    KnownBore,
    bore_grid,
    distortion_by,
    elastic_film,
    elastic_thermal_film,
    thermal_displacement,
)
from babbitt.kinds.journal.film.field import journal_gap, pressure_on
from babbitt.reynolds.deformation.compliance import (
    ColumnLiner,
    Compliance,
    as_field,
    total_displacement,
)
from babbitt.reynolds.deformation.elastic_ring import ElasticRing
from babbitt.reynolds.deformation.half_space import HalfSpace
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.heat.heat_model import BushRing, ConductingWalls, FilmHeat
from babbitt.reynolds.heat.thermal_equilibrium import solve_thermal_journal
from babbitt.reynolds.heat.thermal_growth import RingGrowth
from babbitt.reynolds.model import JournalFilm, Resolution, grooved_bore
from babbitt.reynolds.solution import FilmSolution

GRID = Resolution(4, 48)
FILM = JournalFilm(0.1, 0.05, 75e-6, 0.02, 300.0, grooved_bore((0.0, math.pi), math.radians(20.0)))
BORE = bore_grid(FILM)
LOAD = (0.0, -2e4)
SOFT = ColumnLiner(1e-12)


def at_load(film: JournalFilm) -> FilmSolution:
    return solve_journal(film, LOAD, GRID)


def settled(
    *compliances: Compliance, film: JournalFilm = FILM, closeness: float = 1e-5
) -> ElasticFilm[FilmSolution]:
    found = elastic_film(film, compliances, at_load, closeness)
    assert found.outcome is Outcome.CONVERGED
    return found


RIGID = at_load(replace(FILM, displacement=as_field(np.zeros((4, 2)))))


def test_rigid_bore_changes_nothing() -> None:
    found = settled(ColumnLiner(0.0))
    assert found.films == 1
    assert not found.displacement.any()
    assert found.solution.minimum_film_thickness == pytest.approx(RIGID.minimum_film_thickness, rel=1e-9)
    assert found.solution.stiffness == pytest.approx(RIGID.stiffness, rel=1e-9)


@pytest.mark.parametrize("kind", [ColumnLiner(1e-12), ElasticRing(0.05, 0.065, 2.1e11, 0.3), HalfSpace(5e10, 0.3)])
def test_settled_displacement_is_that_by_its_own_pressure(kind: Compliance) -> None:
    found = settled(kind)
    pressure = pressure_on(found.solution, BORE.theta, BORE.z)
    own = total_displacement([kind], BORE, pressure)
    assert np.abs(own - found.displacement).max() < 1.1e-5 * found.solution.minimum_film_thickness
    assert found.solution.film.displacement == as_field(found.displacement)
    assert found.solution.force == pytest.approx([0.0, 2e4], abs=0.1)
    assert found.solution.mass_balance_error < 1e-8
    assert found.displacement.max() > 3e-6  # soft enough to tell


def test_stiff_bore_follows_the_rigid_film_in_proportion() -> None:
    first = ElasticRing(0.05, 0.065, 2.1e14, 0.3).displacement(BORE, pressure_on(RIGID, BORE.theta, BORE.z))
    largest = np.abs(first).max()
    assert settled(ElasticRing(0.05, 0.065, 2.1e14, 0.3)).displacement == pytest.approx(first, abs=0.01 * largest)
    softer = settled(ElasticRing(0.05, 0.065, 2.1e13, 0.3)).displacement
    assert softer == pytest.approx(10.0 * first, abs=10.0 * 0.02 * largest)
    steel = settled(ElasticRing(0.05, 0.065, 2.1e11, 0.3)).displacement
    assert np.abs(steel).max() < 0.8 * 1000.0 * largest  # what opens the gap takes the pressure away


def test_soft_liner_spreads_the_pressure_and_pinches_the_sides() -> None:
    """The pressure lifts the mid-plane, where the gap opens, and vanishes at the sides, where it closes."""
    found = settled(SOFT).solution
    assert found.maximum_pressure < 0.75 * RIGID.maximum_pressure
    assert found.minimum_film_thickness < RIGID.minimum_film_thickness
    gap = journal_gap(found, BORE.theta, np.array([-0.025, 0.0, 0.025]))
    at = int(gap[:, 1].argmin())
    assert gap[at, 1] > RIGID.minimum_film_thickness
    assert gap[:, 0].min() == pytest.approx(gap[:, 2].min())
    assert gap[:, 0].min() < gap[at, 1] - 3e-6
    calm = settled(ColumnLiner(3e-13)).solution
    assert found.maximum_pressure < calm.maximum_pressure < RIGID.maximum_pressure


def test_displacement_is_even_across_and_the_film_stays_halved() -> None:
    found = settled(SOFT, HalfSpace(1e11, 0.3))
    assert (found.displacement == found.displacement[:, ::-1]).all()
    assert found.solution.axial_positions[0] == 0.0


def test_turning_the_other_way_mirrors_the_displacement() -> None:
    ring = ElasticRing(0.05, 0.065, 2.1e11, 0.3)
    ahead = settled(SOFT, ring)
    back = settled(SOFT, ring, film=replace(FILM, angular_speed=-FILM.angular_speed))
    mirrored = np.roll(back.displacement[::-1], 1 + BORE.rows // 2, axis=0)  # x -> -x: theta -> pi - theta
    assert mirrored == pytest.approx(ahead.displacement, abs=2e-9)
    assert back.solution.position[0] == pytest.approx(-ahead.solution.position[0], rel=1e-4)


def test_displacement_that_was_given_is_added() -> None:
    given = as_field(np.full((8, 3), 5e-6))
    both = settled(SOFT, film=replace(FILM, displacement=given))
    wider = settled(SOFT, film=replace(FILM, displacement=as_field(np.full((240, 17), 5e-6))))
    assert both.solution.minimum_film_thickness == pytest.approx(wider.solution.minimum_film_thickness, rel=1e-6)
    assert both.displacement.max() == pytest.approx(wider.displacement.max(), rel=1e-6)


def test_prescribed_position_gives_way_and_loses_load() -> None:
    x, y = (float(part) for part in RIGID.position)
    found = elastic_film(FILM, [ColumnLiner(3e-13)], lambda film: film_at_position(film, (x, y), resolution=GRID))
    assert found.outcome is Outcome.CONVERGED
    assert 0.5 * RIGID.load < found.solution.load < 0.97 * RIGID.load


def test_start_near_the_answer_saves_films() -> None:
    cold = settled(SOFT)
    warm = elastic_film(FILM, [SOFT], at_load, 1e-5, cold.displacement)
    assert warm.outcome is Outcome.CONVERGED
    assert warm.films < cold.films
    assert warm.solution.minimum_film_thickness == pytest.approx(cold.solution.minimum_film_thickness, rel=1e-4)


def test_films_of_a_known_bore_are_found_in_fewer_and_alike() -> None:
    """Whatever films came between, the same film has the same answer, digit by digit, once enough is known."""
    known, counts = KnownBore(), []

    def found(viscosity: float) -> ElasticFilm[FilmSolution]:
        return elastic_film(replace(FILM, viscosity=viscosity), [SOFT], at_load, 1e-5, known=known)

    for number in range(LESSONS + 2):
        one = found(0.02 - 0.001 * number)
        fresh = settled(SOFT, film=replace(FILM, viscosity=0.02 - 0.001 * number))
        assert one.outcome is Outcome.CONVERGED
        assert one.mismatch <= 1e-5
        assert one.solution.minimum_film_thickness == pytest.approx(
            fresh.solution.minimum_film_thickness, rel=5e-5
        )
        counts.append((one.films, fresh.films))
    assert counts[0][0] == counts[0][1]
    assert sum(one for one, _ in counts[2:]) < 0.7 * sum(fresh for _, fresh in counts[2:])
    first, other, again = found(0.0155), found(0.019), found(0.0155)
    assert other.solution.minimum_film_thickness > first.solution.minimum_film_thickness
    assert np.array_equal(first.displacement, again.displacement)


def test_a_bore_that_was_known_of_a_film_that_cannot_be_here_does_no_harm() -> None:
    """From a displacement that closes the gap there is no film; the search begins anew without it."""
    known = KnownBore(displacement=np.full((BORE.rows, BORE.columns), -1e-4))
    found = elastic_film(FILM, [SOFT], at_load, 1e-5, known=known)
    fresh = settled(SOFT)
    assert found.outcome is Outcome.CONVERGED
    assert np.array_equal(found.displacement, fresh.displacement)


def test_too_soft_a_ring_ends_with_a_status(monkeypatch: pytest.MonkeyPatch) -> None:
    sought = replace(SETTLING, most_evaluations=12)
    monkeypatch.setattr("babbitt.kinds.journal.film.elastic_film.SETTLING", sought)
    found = elastic_film(
        FILM, [ElasticRing(0.05, 0.052, 2.1e11, 0.3)], lambda film: solve_journal(film, LOAD, GRID)
    )
    assert found.outcome is Outcome.NOT_CONVERGED
    assert found.films == 12
    assert found.mismatch > 1e-3


def test_film_that_is_not_found_is_not_called_an_answer() -> None:
    found = elastic_film(FILM, [SOFT], lambda film: replace(at_load(film), outcome=Outcome.OVERLOADED))
    assert found.outcome is Outcome.OVERLOADED
    assert found.films == 1


@pytest.fixture(scope="module")
def heat() -> FilmHeat:
    walls = ConductingWalls(BushRing((0.05, 0.08), (50.0,), 50.0, 303.15))
    return FilmHeat(lambda kelvin: 0.03 * np.exp(-0.03 * (kelvin - 313.15)), 1.75e6, 0.13, 313.15, walls)


def test_warm_bush_is_distorted_by_its_temperature(heat: FilmHeat) -> None:
    grid = Resolution(3, 32, 16, 1e-5)
    assert heat.walls is not None
    growth = RingGrowth(heat.walls.bush, 0, 1.2e-5)
    found = elastic_thermal_film(
        FILM, [ColumnLiner(1e-13)], lambda film: solve_thermal_journal(film, heat, LOAD, grid), growth
    )
    assert found.outcome is Outcome.CONVERGED
    warm = found.solution
    assert warm.heat.balance_error < 1e-7
    liner = ColumnLiner(1e-13).displacement(BORE, pressure_on(warm.film, BORE.theta, BORE.z))
    rest = (found.displacement - liner)[:, 0]
    bent = np.fft.rfft(rest) / BORE.rows
    assert np.abs(bent[:2]).max() < 2e-3 * warm.film.minimum_film_thickness  # neither mean nor shift
    assert 2.0 * np.abs(bent[2]) > 1e-7
    cold = elastic_thermal_film(
        FILM, [ColumnLiner(1e-13)], lambda film: solve_thermal_journal(film, heat, LOAD, grid)
    )
    assert warm.film.minimum_film_thickness != pytest.approx(cold.solution.film.minimum_film_thickness, rel=1e-3)


def test_heat_alone_distorts_a_bore_that_pressure_does_not_move(heat: FilmHeat) -> None:
    grid = Resolution(3, 32, 16, 1e-5)
    assert heat.walls is not None
    growth = RingGrowth(heat.walls.bush, 0, 1.2e-5)
    found, beside = (
        elastic_thermal_film(FILM, parts, lambda film: solve_thermal_journal(film, heat, LOAD, grid), growth, 1e-4)
        for parts in ((), (ColumnLiner(1e-18),))
    )
    assert found.outcome is Outcome.CONVERGED
    own = distortion_by(growth, found.solution)
    assert np.abs(own - found.displacement).max() < 1.1e-4 * found.solution.film.minimum_film_thickness
    assert (thermal_displacement((), growth, found.solution) == own).all()
    assert beside.displacement == pytest.approx(found.displacement, abs=1e-9)
