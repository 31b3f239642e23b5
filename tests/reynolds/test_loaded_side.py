"""An overload is told only when no film on the loaded side carries the load; a bound on work is named as such."""

import math

import numpy as np
import pytest

from babbitt.core.result import Outcome
from babbitt.kinds.journal.film.equilibria import find_equilibria
from babbitt.reynolds.equilibrium.cavitating_film import equilibrium_from
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import DRAFT, ENGINEERING, REFERENCE, JournalFilm, grooved_bore
from babbitt.reynolds.surface import surface_equilibrium as general


def groove_beside_the_load() -> tuple[JournalFilm, tuple[float, float]]:
    """A load of 375 N that points 0.7 degrees past the edge of a groove under pressure."""
    lands = grooved_bore((math.radians(168.5),), math.radians(13.0), 45e3)
    film = JournalFilm(0.1, 0.068, 1e-4, 0.020, 100.0, lands)
    angle = math.radians(175.7)
    return film, (375.0 * math.cos(angle), 375.0 * math.sin(angle))


def test_a_film_that_carries_the_load_close_to_contact_is_found() -> None:
    """The force along the load first falls with eccentricity and reaches 375 N at a fiftieth of the clearance."""
    film, load = groove_beside_the_load()
    stronger = film_at_position(film, (-98.5e-6, 4.8e-6))
    assert math.hypot(*stronger.force) > 1.4 * 375.0  # a film that carries more proves that there is no overload
    found = solve_journal(film, load)
    assert found.outcome is Outcome.CONVERGED
    assert np.hypot(*(found.force + load)) < 1e-6 * 375.0
    assert found.minimum_film_thickness > stronger.minimum_film_thickness


def test_every_equilibrium_holds_that_on_the_loaded_side() -> None:
    film, load = groove_beside_the_load()
    places = find_equilibria(film, load, DRAFT)
    assert places.complete
    assert len(places.places) == 1


def test_a_load_beyond_any_film_is_an_overload() -> None:
    film, load = groove_beside_the_load()
    wedge = film.viscosity * film.angular_speed * (0.5 * film.diameter / film.clearance) ** 2
    beyond = 1e5 * wedge * film.diameter * film.width / 375.0
    found = solve_journal(film, (beyond * load[0], beyond * load[1]), DRAFT)
    assert found.outcome is Outcome.OVERLOADED


def crowned() -> tuple[JournalFilm, tuple[float, float]]:
    """A crowned journal with a thick film, 17 nodes across the width at reference accuracy."""
    lands = grooved_bore((0.0, math.pi), math.radians(20.0))
    film = JournalFilm(0.1, 0.06, 1e-4, 0.03, 200.0, lands, crowning=(1e-5, 0.0, 2e-5))
    return film, (120.0, -900.0)


@pytest.mark.parametrize("load_share", [0.02, 1.0])
def test_reference_accuracy_has_the_work_that_its_grid_takes(load_share: float) -> None:
    """On a grid 23 times as dear, the same film is found, at the place to which the usual grid converges."""
    film, load = crowned()
    load = (load_share * load[0], load_share * load[1])
    usual, fine = solve_journal(film, load, ENGINEERING), solve_journal(film, load, REFERENCE)
    assert fine.outcome is Outcome.CONVERGED
    assert math.dist(usual.position, fine.position) < 2e-3 * film.clearance


def test_a_search_that_ran_out_of_work_says_nothing_of_the_load(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(general, "SMALLEST_BOUND", 1.0)
    monkeypatch.setattr(general, "FINE_SOLUTIONS", 1)
    film, load = crowned()
    found = equilibrium_from(film, load, DRAFT, 80, None)
    assert found.outcome is Outcome.WORK_BOUND
    assert found.outcome.code == "S009"
