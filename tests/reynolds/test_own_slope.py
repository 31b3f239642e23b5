"""Stiffness and damping of a film are the slope of its own load."""

import math
from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from babbitt.kinds.journal.film.elastic_film import displacement_under, elastic_film
from babbitt.reynolds.deformation.compliance import ColumnLiner
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.heat.heat_model import FilmHeat, HeatGrid
from babbitt.reynolds.heat.thermal_equilibrium import solve_thermal_journal
from babbitt.reynolds.heat.thermal_solution import ThermalFilm
from babbitt.reynolds.model import (
    DRAFT,
    ENGINEERING,
    Cavitation,
    FilmStart,
    JournalFilm,
    Land,
    Pocket,
    Resolution,
    grooved_bore,
)
from babbitt.reynolds.solution import FilmSolution
from babbitt.reynolds.stability.load_slope import CLOSE, confirmed_coefficients

RING = (Land(0.3, 0.3 + 2.0 * math.pi),)


def ring_fed(load: float, *pockets: Pocket, speed: float = 200.0) -> FilmSolution:
    film = JournalFilm(0.1, 0.08, 1e-4, 0.02, speed, RING, film_start=FilmStart.PERIODIC, pockets=pockets)
    return solve_journal(film, (0.3 * load, -load), ENGINEERING)


def slope_of(found: FilmSolution) -> np.ndarray:
    """Central differences over 2 % of the smallest gap and half of it, without their error of second order."""
    return (4.0 * differences(found, 0.01) - differences(found, 0.02)) / 3.0


def differences(found: FilmSolution, share: float) -> np.ndarray:
    """Central differences of the load, on grids drawn for every place by itself."""
    step, (x, y) = share * found.minimum_film_thickness, found.position
    columns = []
    for dx, dy in ((step, 0.0), (0.0, step)):
        fore, back = (film_at_position(found.film, (x + s * dx, y + s * dy)).force for s in (1.0, -1.0))
        columns.append((back - fore) / (2.0 * step))
    return np.array(columns).T


def off(one: np.ndarray, other: np.ndarray) -> float:
    return float(np.linalg.norm(one - other) / np.linalg.norm(other))


FILMS = {
    "one pocket": (1500.0, Pocket(1.4, 0.38, 0.028, pressure=1.5e5)),
    "two pockets": (300.0, Pocket(0.5, 0.43, 0.022, pressure=1e5), Pocket(3.5, 0.33, 0.016, 0.01, pressure=1e5)),
    "hole before the thin film": (4000.0, Pocket.hole(-2.4, 0.008, 0.1, pressure=2e5)),
}


@pytest.mark.parametrize("name", FILMS)
@pytest.mark.parametrize("speed", [200.0, -200.0])
def test_coefficients_are_the_slope_of_the_load(name: str, speed: float) -> None:
    found = ring_fed(*FILMS[name], speed=speed)
    better, check = confirmed_coefficients(found, ENGINEERING)
    assert check is not None
    assert check.confirmed or check.settled
    assert off(better.stiffness, slope_of(found)) < 2.0 * CLOSE  # on other grids


def warm_film(pocket: Pocket) -> ThermalFilm:
    film = JournalFilm(0.1, 0.08, 1e-4, 0.02, 200.0, RING, film_start=FilmStart.PERIODIC, pockets=(pocket,))
    heat = FilmHeat(
        lambda t: 0.02 * np.exp(-0.03 * (np.asarray(t) - 318.15)), 1.7e6, 0.13, 318.15, None, HeatGrid()
    )
    return solve_thermal_journal(film, heat, (500.0, -1500.0), DRAFT)


def test_coefficients_of_a_warm_film_are_the_slope_at_its_temperatures() -> None:
    """The force of the nodes with their viscosities, differences over steps of other lengths."""
    found = warm_film(FILMS["one pocket"][1])
    assert found.film.outcome.solved
    assert found.nodes is not None
    better, check = confirmed_coefficients(found.film, DRAFT, found.nodes)
    assert check is not None
    assert check.confirmed or check.settled
    ring, unit = found.nodes.ring, found.nodes.scales.force / found.nodes.scales.length

    def slope(share: float) -> np.ndarray:
        columns = []
        for move in share * ring.gap * np.eye(2):
            force = []
            for sign in (1.0, -1.0):
                while ring.sample.evaluate(ring.position + sign * move):
                    pass
                force.append(ring.sample.force.copy())
            columns.append((force[1] - force[0]) / (2.0 * share * ring.gap))
        return np.array(columns).T * unit

    angle = found.nodes.frame.angle
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    own = turn @ ((4.0 * slope(0.008) - slope(0.016)) / 3.0) @ turn.T
    assert off(better.stiffness, own) < 1.2 * CLOSE


def test_what_is_confirmed_stays() -> None:
    lands = grooved_bore((0.0, math.pi), 0.3, 5e4)
    found = solve_journal(JournalFilm(0.1, 0.08, 1e-4, 0.02, 200.0, lands), (0.0, -3000.0), ENGINEERING)
    better, check = confirmed_coefficients(found, ENGINEERING)
    assert check is not None
    assert check.confirmed
    assert better.stiffness is found.stiffness


def test_films_of_modes_and_closed_pockets_are_not_asked() -> None:
    plain = solve_journal(JournalFilm(0.1, 0.08, 1e-4, 0.02, 200.0, grooved_bore((0.0,), 0.3)), (0.0, -3000.0))
    assert confirmed_coefficients(plain, ENGINEERING)[1] is None
    fed = ring_fed(*FILMS["two pockets"])
    pockets = (fed.film.pockets[0], replace(fed.film.pockets[1], closed=True))
    closed = film_at_position(replace(fed.film, pockets=pockets), tuple(fed.position))
    assert confirmed_coefficients(closed, ENGINEERING)[1] is None


LINER = (ColumnLiner(4e-12),)
CLOSE_GRID = Resolution(4, 48, tolerance=1e-10)
FULL = JournalFilm(
    0.1, 0.05, 1e-4, 0.02, 300.0, (Land(0.0, 2.0 * math.pi),), Cavitation.REYNOLDS,
    film_start=FilmStart.PERIODIC, cavitation_pressure=-1e9,
)  # fmt: skip
"""A ring that never ruptures: around its middle all is linear and alike in every direction."""


def with_liner(
    film: JournalFilm, position: tuple[float, float] = (0.0, 0.0), liner: tuple[ColumnLiner, ...] = LINER
) -> tuple[FilmSolution, FilmSolution]:
    """The film on a soft liner at a position, and the same with coefficients that count the liner."""
    found = elastic_film(film, liner, lambda one: film_at_position(one, position, resolution=CLOSE_GRID), 1e-6)
    solution = found.solution
    counted, check = confirmed_coefficients(solution, CLOSE_GRID, None, partial(displacement_under, liner))
    assert check is not None
    assert check.settled
    return solution, counted


def test_a_whirl_around_the_middle_is_a_steady_film_at_another_speed() -> None:
    """Seen from axes that turn with a whirl at W, journal and bore surface turn back at W and the displaced bore
    stands still: the film is the steady one at w - 2 W. With K = [[k, q], [-q, k]] that makes
    C = [[2 dq/dw, -2 dk/dw], [2 dk/dw, 2 dq/dw]] to first order in W; a rigid bore has k = 0."""
    step = 3.0
    low, here, high = (
        with_liner(replace(FULL, angular_speed=300.0 + more), liner=(ColumnLiner(5e-11),))[1]
        for more in (-step, 0.0, step)
    )
    rate = (high.stiffness - low.stiffness) / (2.0 * step)
    expected = 2.0 * np.array([[rate[0, 1], -rate[0, 0]], [rate[0, 0], rate[0, 1]]])
    assert here.stiffness[0, 0] > 0.3 * abs(here.stiffness[0, 1])  # soft enough to tell
    np.testing.assert_allclose(here.damping, expected, atol=2e-3 * np.abs(expected).max())
    (k, q), _ = here.stiffness
    np.testing.assert_allclose(here.stiffness, [[k, q], [-q, k]], atol=1e-3 * abs(q))


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_stiffness_in_a_bore_that_gives_way_is_the_slope_of_films_settled_anew(sense: float) -> None:
    lands = grooved_bore((0.0, math.pi), math.radians(20.0))
    film = JournalFilm(0.1, 0.05, 75e-6, 0.02, 300.0 * sense, lands)
    place = np.array([-2e-5 * sense, -4.5e-5])
    frozen, counted = with_liner(film, tuple(place))
    step = 0.02 * frozen.minimum_film_thickness
    slope = np.zeros((2, 2))
    for axis in range(2):
        move = np.zeros(2)
        move[axis] = step
        fore, back = (with_liner(film, tuple(place + sign * move))[0].force for sign in (1.0, -1.0))
        slope[:, axis] = (back - fore) / (2.0 * step)
    # the lines of the grid follow the journal there, and stay here
    np.testing.assert_allclose(counted.stiffness, slope, atol=0.02 * np.abs(slope).max())
    assert np.abs(frozen.stiffness - slope).max() > 0.2 * np.abs(slope).max()


def test_a_film_on_a_liner_has_an_image() -> None:
    lands = grooved_bore((0.0, math.pi), math.radians(20.0))
    film = JournalFilm(0.1, 0.05, 75e-6, 0.02, 300.0, lands)
    one = with_liner(film, (2e-5, -4.5e-5))[1]
    other = with_liner(replace(film, angular_speed=-300.0), (-2e-5, -4.5e-5))[1]
    flip = np.diag([-1.0, 1.0])
    for mine, image in ((one.stiffness, other.stiffness), (one.damping, other.damping)):
        np.testing.assert_allclose(flip @ image @ flip, mine, atol=1e-6 * np.abs(mine).max())
