"""The half-Sommerfeld condition against Ocvirk's short bearing, in closed form and as printed by Friswell."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.lands.batch import solve_batch
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Resolution, grooved_bore

# Friswell et al. (2010), Dynamics of Rotating Machines: D = 0.1 m, L = 0.03 m, c = 0.1 mm, 0.1 Pa s, 525 N
FRISWELL = [(1500.0, 0.266298), (2000.0, 0.212571)]
SHRINK = 20.0  # their theory knows no length; ours must be short to agree, at the same Sommerfeld number
FINE = Resolution(4, 192)


def short_bearing(rpm=1500.0):
    return JournalFilm(
        0.1, 0.03 / SHRINK, 1e-4, 0.1, rpm * math.pi / 30.0, (Land(0.0, 2.0 * math.pi),),
        Cavitation.HALF_SOMMERFELD, FilmStart.PERIODIC,
    )  # fmt: skip


@pytest.mark.parametrize(("rpm", "eps"), FRISWELL)
def test_friswell_short_bearing(rpm, eps):
    found = solve_journal(short_bearing(rpm), (0.0, -525.0 / SHRINK**3), FINE)
    assert found.outcome.solved
    assert found.eccentricity_ratio == pytest.approx(eps, rel=1e-3)
    attitude = math.atan(math.pi * math.sqrt(1.0 - eps**2) / (4.0 * eps))
    assert found.attitude_angle == pytest.approx(attitude, abs=1e-3)
    np.testing.assert_allclose(found.force, [0.0, 525.0 / SHRINK**3], atol=1e-5)


@pytest.mark.parametrize("eps", [0.2, 0.6, 0.9])
def test_ocvirk_forces(eps):
    film = short_bearing()
    found = film_at_position(film, (0.0, -eps * film.clearance), resolution=FINE)
    unit = film.viscosity * film.angular_speed * 0.5 * film.diameter * film.width**3 / film.clearance**2
    radial = unit * eps**2 / (1.0 - eps**2) ** 2
    tangential = unit * math.pi * eps / (4.0 * (1.0 - eps**2) ** 1.5)
    assert found.force[1] == pytest.approx(radial, rel=5e-3)
    assert abs(found.force[0]) == pytest.approx(tangential, rel=5e-3)
    assert found.pressure.min() == 0.0


def test_reversal_mirrors_the_short_bearing():
    film = short_bearing()
    load = (0.0, -525.0 / SHRINK**3)
    forward = solve_journal(film, load, FINE)
    backward = solve_journal(replace(film, angular_speed=-film.angular_speed), load, FINE)
    np.testing.assert_allclose(backward.position, forward.position * [-1.0, 1.0], atol=1e-6 * film.clearance)


def test_no_coefficients_and_no_flows():
    found = solve_journal(short_bearing(), (0.0, -525.0 / SHRINK**3))
    assert np.isnan(found.stiffness).all()
    assert np.isnan(found.damping).all()
    assert np.isnan(found.side_flow).all()


def test_too_heavy_a_load_is_called_so():
    assert solve_journal(short_bearing(), (0.0, -1e9)).outcome is Outcome.OVERLOADED


def test_refused_where_it_has_no_meaning():
    with pytest.raises(InputError, match="plain closed ring"):
        replace(short_bearing(), lands=grooved_bore((0.0, math.pi), 0.3), film_start=FilmStart.GROOVE)
    with pytest.raises(InputError, match="half-Sommerfeld"):
        solve_batch(
            0.1, 0.05, 1e-4, 0.02, 100.0, (0.0, -100.0), grooved_bore((0.0,), 0.3), Cavitation.HALF_SOMMERFELD
        )


@pytest.mark.parametrize(
    "land",
    [
        Land(2.0, 7.5, start_pressure=1e6, end_pressure=1e6),
        Land(2.0, 7.5, start_fill=0.5),
    ],
)
def test_a_batch_refuses_grooves_that_it_does_not_count(land):
    with pytest.raises(InputError, match="one by one"):
        solve_batch(0.1, 0.06, 6e-5, 0.02, 314.0, (0.0, -3e3), (land,))
