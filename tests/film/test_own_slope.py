"""Stiffness and damping of a film are the slope of its own load."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.film.heat import FilmHeat, HeatGrid
from babbitt.film.model import DRAFT, ENGINEERING, FilmStart, JournalFilm, Land, Pocket, grooved_bore
from babbitt.film.own_slope import CLOSE, confirmed_coefficients
from babbitt.film.solution import FilmSolution
from babbitt.film.solve import film_at_position, solve_journal
from babbitt.film.thermal import solve_thermal_journal
from babbitt.film.thermal_solution import ThermalFilm

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
