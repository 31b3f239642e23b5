"""Viscosity that grows with pressure: laws, transform, limits, closed forms, derivatives."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from ring_differences import assert_consistent

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Resolution, grooved_bore
from babbitt.reynolds.oil.piezoviscosity import Barus, Roelands, pressure_of, pressure_table, reduced_pressure

CLEARANCE, VISCOSITY, SPEED = 5e-5, 0.05, 200.0
TWO = grooved_bore((0.0, math.pi), 0.3)
FINE = Resolution(5, 96, 24, 1e-12)
LAWS = [Barus(2e-8), Roelands(2e-8, VISCOSITY)]


def bearing(lands=TWO, **more):
    return JournalFilm(0.1, 0.08, CLEARANCE, VISCOSITY, SPEED, lands, **more)


@given(st.floats(1e-9, 5e-8), st.floats(0.0, 4.0))
@settings(max_examples=50)
def test_table_of_barus_is_its_closed_form(coefficient, exponent):
    table, pressure = pressure_table(Barus(coefficient)), exponent / coefficient
    closed = -math.expm1(-exponent) / coefficient
    assert float(reduced_pressure(table, np.array(pressure))) == pytest.approx(closed, rel=1e-8)
    assert float(pressure_of(table, np.array(closed))) == pytest.approx(pressure, rel=1e-6, abs=1e-9 / coefficient)


@pytest.mark.parametrize("law", LAWS)
def test_transform_is_the_integral_of_one_over_the_ratio(law):
    from scipy.integrate import quad

    wanted, _ = quad(lambda p: 1.0 / float(law.ratio(np.array(p))), 0.0, 1e8, epsabs=0.0, epsrel=1e-12)
    assert float(reduced_pressure(pressure_table(law), np.array(1e8))) == pytest.approx(wanted, rel=1e-8)


@pytest.mark.parametrize("viscosity", [0.005, 0.05, 0.5])
def test_slope_of_roelands_is_the_coefficient(viscosity):
    law, small = Roelands(2.2e-8, viscosity), 1e3
    assert math.log(float(law.ratio(np.array(small)))) / small == pytest.approx(2.2e-8, rel=1e-4)
    # the exponent of the law: alpha p_0 = Z (ln mu_0 + 9.67)
    exponent = 2.2e-8 * 1.96e8 / (math.log(viscosity) + 9.67)
    closed = (math.log(viscosity) + 9.67) * ((1.0 + 5e8 / 1.96e8) ** exponent - 1.0)
    assert math.log(float(law.ratio(np.array(5e8)))) == pytest.approx(closed, rel=1e-12)


@pytest.mark.parametrize("viscosity", [6.31e-5, 1e-6])
def test_isotherms_of_roelands_meet(viscosity):
    with pytest.raises(InputError, match="isotherms"):
        Roelands(2e-8, viscosity)


def test_long_film_of_barus_has_sommerfelds_reduced_pressure():
    """p = -ln(1 - alpha r) / alpha with r the pressure of the film of constant viscosity, point by point."""
    ring = (Land(0.0, 2.0 * math.pi),)
    film = JournalFilm(0.1, 100.0, CLEARANCE, VISCOSITY, SPEED, ring, Cavitation.REYNOLDS,
                       film_start=FilmStart.PERIODIC)  # fmt: skip
    at = (0.0, -0.7 * CLEARANCE)
    plain = film_at_position(film, at, resolution=FINE).pressure
    coefficient = 0.8 / plain.max()
    thick = film_at_position(replace(film, pressure_viscosity=Barus(coefficient)), at, resolution=FINE).pressure
    np.testing.assert_allclose(thick, -np.log1p(-coefficient * plain) / coefficient, rtol=1e-6, atol=1.0)
    assert thick.max() == pytest.approx(2.0118 * plain.max(), rel=1e-3)


def test_small_coefficient_is_constant_viscosity():
    load = (0.0, -8000.0)
    plain = solve_journal(bearing(axial_viscosity=(1.0, 1.0)), load, FINE)
    errors = []
    for coefficient in (1e-9, 1e-10):
        found = solve_journal(bearing(pressure_viscosity=Barus(coefficient)), load, FINE)
        errors.append(np.abs(found.position - plain.position).max() / CLEARANCE)
    assert errors[1] == pytest.approx(0.1 * errors[0], rel=0.05)
    assert errors[0] < 1e-3


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("breaks_at", [-2e8, 0.0])
def test_coefficients_are_derivatives_of_piezoviscous_forces(law, breaks_at):
    film = bearing(pressure_viscosity=law, cavitation_pressure=breaks_at)
    assert_consistent(film, (0.15, -0.7))


@pytest.mark.parametrize("law", LAWS)
def test_pressure_thickens_the_oil_where_it_counts(law):
    at = (0.15 * CLEARANCE, -0.7 * CLEARANCE)
    plain, found = (film_at_position(bearing(pressure_viscosity=one), at) for one in (None, law))
    assert found.load > 1.2 * plain.load


@pytest.mark.parametrize("law", LAWS)
def test_reversal_mirrors_a_piezoviscous_film(law):
    forward = solve_journal(bearing(pressure_viscosity=law), (300.0, -20000.0))
    backward = solve_journal(replace(forward.film, angular_speed=-SPEED), (-300.0, -20000.0))
    assert forward.outcome.solved
    np.testing.assert_allclose(backward.position, forward.position * [-1.0, 1.0], rtol=1e-6)
    assert backward.maximum_pressure == pytest.approx(forward.maximum_pressure, rel=1e-6)


def test_pressure_beyond_the_law_is_told():
    """Where the reduced pressure would exceed 1 / alpha no pressure answers; the journal cannot stand there."""
    film = bearing()
    plain = film_at_position(replace(film, axial_viscosity=(1.0, 1.0)), (0.0, -0.8 * CLEARANCE))
    lost = film_at_position(
        replace(film, pressure_viscosity=Barus(1.2 / plain.maximum_pressure)), (0.0, -0.8 * CLEARANCE)
    )
    assert plain.outcome is Outcome.CONVERGED
    assert lost.outcome is Outcome.OVERLOADED


def test_load_with_piezoviscosity_is_carried_on_a_thicker_film():
    load = (0.0, -40000.0)
    plain = solve_journal(bearing(axial_viscosity=(1.0, 1.0)), load)
    for law in LAWS:
        found = solve_journal(bearing(pressure_viscosity=law), load)
        assert found.outcome.solved
        assert found.minimum_film_thickness > plain.minimum_film_thickness


def test_coefficient_must_be_positive():
    with pytest.raises(InputError, match="positive"):
        Barus(0.0)
