"""The estimated error of the grid, beside the true one: the film on a grid much finer still."""

from __future__ import annotations

from dataclasses import replace

import film_bearings
import numpy as np
import pytest

from babbitt.core.result import Outcome
from babbitt.kinds.journal.film import grid_error
from babbitt.kinds.journal.film.check import film_check
from babbitt.kinds.journal.film.grid_error import COEFFICIENTS, finer, grid_errors
from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.film.layout import load_vector
from babbitt.kinds.journal.film.load_slope import confirmed_film, confirmed_state
from babbitt.kinds.journal.film.model import Accuracy
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import Cavitation, Resolution

LOBES = {
    "grooves": [{"angle": f"{angle} deg", "extent": "15 deg"} for angle in (90, 210, 330)],
    "bore": {"kind": "lobes", "preload": 0.5},
    "load": "5 kN",
    "speed": "-6000 rpm",
}
POCKETS = {
    "grooves": None,
    "pockets": [{"angle": f"{angle} deg", "extent": "20 deg", "width": "90 mm"} for angle in (0, 180)],
}
BEARINGS = {
    "two": {},
    "heavy": {"load": "120 kN"},
    "light": {"load": "2 kN"},
    "narrow": {"width": "50 mm", "load": "10 kN"},
    "wide": {"width": "240 mm", "load": "40 kN"},
    "lobes": LOBES,
    "pockets": POCKETS,
    "pressure": {"supply": {"temperature": "45 degC", "pressure": "3 MPa"}, "load": "10 kN", "speed": "600 rpm"},
}
BEYOND = Resolution(12, 1536, 48, 1e-10)
BEYOND_SURFACES = Resolution(10, 768, 48, 1e-9)
POSITION_FACTOR, COEFFICIENT_FACTOR = 1.5, 1.75
"""How far an estimate may be off."""
COEFFICIENT_MORE = 2e-3
"""How much an estimate for the coefficients may be larger, where one of two grids is luckier than the other."""


@pytest.mark.parametrize("accuracy", [Accuracy.DRAFT, Accuracy.ENGINEERING])
@pytest.mark.parametrize(
    ("name", "cavitation"),
    [
        *((name, Cavitation.MASS_CONSERVING) for name in BEARINGS),
        *((name, Cavitation.REYNOLDS) for name in BEARINGS if name != "pockets"),
    ],
)
def test_the_estimate_brackets_the_true_error(name, accuracy, cavitation):
    case = film_bearings.film(effective_temperature="60 degC", **BEARINGS[name])
    case = replace(case, accuracy=accuracy, cavitation=cavitation)
    state, _ = confirmed_state(case, operating_film(case).film)
    found = state.solution
    grid = BEYOND_SURFACES if found.film.is_surface else BEYOND
    true = confirmed_film(case, solve_journal(found.film, load_vector(case, state.load), grid), grid)
    assert true.outcome.solved
    errors = {
        "minimum_film_thickness_error": found.minimum_film_thickness / true.minimum_film_thickness - 1.0,
        "position_error": np.linalg.norm(found.position - true.position) / found.film.clearance,
        "stiffness_error": np.linalg.norm(found.stiffness - true.stiffness) / np.linalg.norm(true.stiffness),
        "damping_error": np.linalg.norm(found.damping - true.damping) / np.linalg.norm(true.damping),
    }
    estimated = grid_errors(case, state)
    assert estimated.keys() == errors.keys()
    for quantity, error in errors.items():
        of_coefficients = quantity in COEFFICIENTS
        factor = COEFFICIENT_FACTOR if of_coefficients else POSITION_FACTOR
        more = COEFFICIENT_MORE if of_coefficients else 0.0
        assert abs(error) / factor < estimated[quantity] < abs(error) * factor + more, quantity


def test_a_finer_accuracy_has_a_smaller_estimated_error():
    case = film_bearings.film(effective_temperature="60 degC", error_estimate=True)
    draft, engineering, reference = (film_check(replace(case, accuracy=accuracy)).values for accuracy in Accuracy)
    for name in ("minimum_film_thickness_error", "position_error"):
        assert draft[name] > 2.5 * engineering[name] > 20.0 * reference[name] > 0.0


def test_a_prescribed_position_has_an_error_of_the_load_instead():
    case = film_bearings.film(
        load=None, eccentricity_ratio=0.6, attitude_angle="50 deg", effective_temperature="60 degC",
        error_estimate=True, accuracy="draft",
    )  # fmt: skip
    found = film_check(case)
    assert "position_error" not in found.values
    film = operating_film(case).film.solution
    true = film_at_position(film.film, tuple(film.position), resolution=BEYOND).force
    error = np.linalg.norm(film.force - true) / np.linalg.norm(true)
    assert error / POSITION_FACTOR < found.load_error < error * POSITION_FACTOR


def test_nothing_is_estimated_unless_asked():
    assert not [
        name for name in film_bearings.answer().values if name.endswith("_error") and "balance" not in name
    ]


def test_a_finer_film_that_is_not_found_is_told(monkeypatch):
    unsolved = replace(operating_film(film_bearings.film()).film.solution, outcome=Outcome.NOT_CONVERGED)
    monkeypatch.setattr(grid_error, "_on_grid", lambda *_: unsolved)
    found = film_check(film_bearings.film(error_estimate=True))
    assert found.outcome.solved
    assert "W125" in {notice.code for notice in found.warnings}
    assert "stiffness_error" not in found.values


def test_the_finest_grid_is_compared_with_one_twice_as_fine():
    grid = Accuracy.REFERENCE.resolution
    assert (finer(grid).intervals, finer(grid).axial_unknowns) == (768, 12)


@pytest.mark.parametrize("name", ["two", "wide"])
def test_on_the_finest_grid_a_journal_rests_only_when_its_film_has_receded(name):
    """The ruptured zone of a Reynolds film is found line after line; only at its end does the load count."""
    case = replace(
        film_bearings.film(effective_temperature="60 degC", **BEARINGS[name]), cavitation=Cavitation.REYNOLDS
    )
    state = operating_film(case).film
    found = solve_journal(state.solution.film, load_vector(case, state.load), finer(Accuracy.REFERENCE.resolution))
    assert found.outcome.solved
    there = film_at_position(found.film, tuple(found.position), resolution=finer(Accuracy.REFERENCE.resolution))
    assert np.linalg.norm(there.force - found.force) < 1e-6 * state.load
