"""The estimated error of the grid, beside the true one: the film on a grid much finer still."""

from __future__ import annotations

from dataclasses import replace

import film_bearings
import numpy as np
import pytest

from babbitt.bearings import grid_error
from babbitt.bearings.check import film_check
from babbitt.bearings.grid_error import finer, grid_errors
from babbitt.bearings.layout import load_vector
from babbitt.bearings.model import Accuracy
from babbitt.bearings.warm_film import operating_film
from babbitt.film.model import Cavitation, Resolution
from babbitt.film.solve import film_at_position, solve_journal
from babbitt.results import Outcome

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
}
BEYOND = Resolution(12, 1536, 48, 1e-10)
BEYOND_POCKETS = Resolution(10, 384, 48, 1e-9)
FACTOR, LIGHT_FACTOR = 2.0, 3.0


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
    state = operating_film(case).film
    found = state.solution
    grid = BEYOND_POCKETS if found.film.is_surface else BEYOND
    true = solve_journal(found.film, load_vector(case, state.load), grid)
    assert true.outcome.solved
    errors = {
        "minimum_film_thickness_error": found.minimum_film_thickness / true.minimum_film_thickness - 1.0,
        "position_error": np.linalg.norm(found.position - true.position) / found.film.clearance,
        "stiffness_error": np.linalg.norm(found.stiffness - true.stiffness) / np.linalg.norm(true.stiffness),
        "damping_error": np.linalg.norm(found.damping - true.damping) / np.linalg.norm(true.damping),
    }
    estimated = grid_errors(case, state)
    assert estimated.keys() == errors.keys()
    factor = LIGHT_FACTOR if name == "light" else FACTOR
    for quantity, error in errors.items():
        assert abs(error) / factor < estimated[quantity] < abs(error) * factor, quantity


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
    assert error / FACTOR < found.load_error < error * FACTOR


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
