"""Moments and coefficients of tilt: derivatives of misaligned films, symmetry, both senses."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Pocket, Resolution, grooved_bore
from babbitt.reynolds.surface.tilt_coefficients import tilt_coefficients

WIDTH, CLEARANCE = 0.08, 1e-4
AT = np.array([3e-5, -5e-5])
GRID = Resolution(5, 96)
ARM = np.array([1.0, 1.0, 0.5 * WIDTH, 0.5 * WIDTH])
FED = {"film_start": FilmStart.PERIODIC, "pockets": (Pocket(1.7, 0.5, 0.05, 0.003, 1e5),)}


def bearing(lands=None, **more):
    lands = lands or grooved_bore((0.0, math.pi), 0.3, 1e5)
    return JournalFilm(0.1, WIDTH, CLEARANCE, 0.02, 200.0, lands, **more)


RING = bearing((Land(0.0, 2.0 * math.pi),), **FED)


def at(film, motion=(0.0, 0.0, 0.0, 0.0), resolution=GRID):
    lean = (film.misalignment[0] + motion[2], film.misalignment[1] + motion[3])
    found = film_at_position(replace(film, misalignment=lean), tuple(AT + motion[:2]), resolution=resolution)
    return tilt_coefficients(found, resolution)


def differences(film, step):
    columns = []
    for motion in np.diag(np.array([step, step, step / WIDTH, step / WIDTH])):
        size = motion.sum()
        columns.append(-(at(film, motion).forces - at(film, -motion).forces) / (2.0 * size))
    return np.array(columns).T


@pytest.mark.parametrize(
    ("film", "step", "bound"),
    [
        (replace(RING, misalignment=(2e-4, -1e-4), cavitation_pressure=-1e9), 1e-7, 2e-4),
        (replace(RING, misalignment=(2e-4, -1e-4)), 5e-7, 1e-2),
        (bearing(misalignment=(2e-4, -1e-4)), 5e-7, 1e-2),
        (bearing(misalignment=(2e-4, -1e-4), cavitation=Cavitation.REYNOLDS), 5e-7, 1e-2),
        (replace(bearing(misalignment=(-2e-4, -1e-4)), angular_speed=-200.0), 5e-7, 1e-2),
    ],
)
def test_stiffness_is_the_derivative_of_forces_and_moments(film, step, bound):
    found, reference = at(film), differences(film, step)
    scaled = found.stiffness / np.outer(ARM, ARM)
    np.testing.assert_allclose(scaled, reference / np.outer(ARM, ARM), atol=bound * abs(scaled).max())


@pytest.mark.parametrize("film", [RING, bearing(misalignment=(1e-4, 2e-4))])
def test_the_corner_of_the_translations_is_that_of_the_film(film):
    solution = solve_journal(film, (0.0, -4000.0), GRID)
    found = tilt_coefficients(solution, GRID)
    assert found.outcome is Outcome.CONVERGED
    np.testing.assert_allclose(found.forces[:2], solution.force, rtol=2e-3, atol=5.0)
    np.testing.assert_allclose(
        found.stiffness[:2, :2], solution.stiffness, atol=0.01 * abs(solution.stiffness).max()
    )
    np.testing.assert_allclose(found.damping[:2, :2], solution.damping, atol=0.01 * abs(solution.damping).max())


def test_alike_halves_give_no_moment_and_do_not_couple_tilt_with_shift():
    solution = solve_journal(bearing(), (0.0, -4000.0), GRID)
    found = tilt_coefficients(solution, GRID)
    assert abs(found.moment).max() < 1e-9 * 4000.0 * WIDTH
    for matrix in (found.stiffness, found.damping):
        scaled = matrix / np.outer(ARM, ARM)
        assert abs(scaled[:2, 2:]).max() < 1e-9 * abs(scaled).max()
        assert abs(scaled[2:, :2]).max() < 1e-9 * abs(scaled).max()
        assert scaled[2:, 2:].diagonal().min() > 0.0 or matrix is found.stiffness
    # leaning against the load gives a moment that rights the journal, and most where the film is thinnest
    assert found.stiffness[3, 3] > found.stiffness[2, 2] > 0.0


def test_damping_of_a_full_film_is_symmetric():
    film = replace(RING, misalignment=(2e-4, -1e-4), cavitation_pressure=-1e9)
    damping = at(film).damping / np.outer(ARM, ARM)
    np.testing.assert_allclose(damping, damping.T, atol=1e-9 * abs(damping).max())
    assert np.linalg.eigvalsh(0.5 * (damping + damping.T)).min() > 0.0


def test_films_without_a_place_to_begin_have_no_coefficients_of_tilt():
    widest = bearing((Land(0.0, 2.0 * math.pi),), film_start=FilmStart.WIDEST_GAP)
    with pytest.raises(InputError, match="groove, pocket or hole"):
        tilt_coefficients(solve_journal(widest, (0.0, -4000.0)))
    lost = replace(solve_journal(bearing(), (0.0, -4000.0)), outcome=Outcome.NOT_CONVERGED)
    with pytest.raises(InputError, match="not solved"):
        tilt_coefficients(lost)
