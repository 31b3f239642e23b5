"""Rigid rotors and rotors on an elastic shaft: closed forms, eigenvalues, limits."""

from __future__ import annotations

import math

import numpy as np
import pytest
from film_bearings import answer, film
from hypothesis import assume, given
from hypothesis import strategies as st
from routh_hurwitz import hurwitz_margins, is_stable

from babbitt.bearings.warm_film import operating_film
from babbitt.bearings.whirl import at_speed
from babbitt.film.rotor import RIGID, critical_mass_of_rotor, growth_rates
from babbitt.film.stability import whirl_frequency
from babbitt.film.whirl import crossing

entries = st.integers(-100, 100).map(lambda tenths: 0.1 * tenths)
direct = st.integers(2, 100).map(lambda tenths: 0.1 * tenths)
symmetric_share = st.floats(-0.6, 0.6)


@st.composite
def films(draw):
    """Stiffness and damping of a film: damping takes energy out of every motion, stiffness holds the load."""
    k = np.array([[draw(entries), draw(entries)], [draw(entries), draw(entries)]])
    cx, cy = draw(direct), draw(direct)
    aside = draw(symmetric_share) * math.sqrt(cx * cy)
    assume(np.linalg.det(k) > 0.1)
    return k, np.array([[cx, aside], [aside, cy]])


@st.composite
def whirling_films(draw):
    """Cross-coupling of opposite signs, strong beside the difference of the direct stiffnesses: these can
    whirl.
    """
    one, other = draw(direct), draw(direct)
    middle, apart = draw(direct), draw(st.floats(-0.9, 0.9)) * math.sqrt(one * other)
    k = np.array([[middle + 10.0 + apart, one], [-other, middle + 10.0 - apart]])
    return k, np.diag([draw(direct), draw(direct)])


@given(films(), st.floats(0.05, 50.0))
def test_routh_hurwitz_agrees_with_the_roots_of_the_characteristic_polynomial(coefficients, mass):
    stiffness, damping = coefficients
    a3, a2, a1, a0, _ = hurwitz_margins(mass, stiffness, damping)
    rate = float(np.roots([1.0, a3, a2, a1, a0]).real.max())
    assume(abs(rate) > 1e-6)
    assert is_stable(mass, stiffness, damping) is (rate < 0.0)


@given(films(), st.floats(0.05, 50.0))
def test_the_growth_rate_is_the_largest_root_of_the_characteristic_polynomial(film, mass):
    a3, a2, a1, a0, _ = hurwitz_margins(mass, *film)
    roots = np.roots([1.0, a3, a2, a1, a0])
    assert growth_rates(mass, *film).item() == pytest.approx(roots.real.max(), abs=1e-5 * np.abs(roots).max())


@given(whirling_films(), st.floats(0.5, 1e4))
def test_at_its_critical_mass_a_rotor_neither_grows_nor_dies_away(film, shaft):
    stiffness, damping = film
    for stiff in (RIGID, shaft):
        critical = critical_mass_of_rotor(stiffness, damping, stiff)
        frequency = whirl_frequency(stiffness, damping)
        assert frequency > 0.0
        below, at, above = growth_rates(np.array([0.95, 1.0, 1.05]) * critical, stiffness, damping, stiff)
        assert abs(at) < 1e-7 * frequency
        assert below < 0.0
        assert above > 0.0


def test_a_shaft_that_bends_whirls_earlier_and_a_stiff_one_as_a_rigid_rotor():
    film = [[2e8, 1e8], [-3e8, 4e8]], [[1e6, 0.0], [0.0, 2e6]]
    masses = [critical_mass_of_rotor(*film, shaft) for shaft in (1e7, 1e8, 1e9, 1e10, RIGID)]
    assert np.all(np.diff(masses) > 0.0)
    assert critical_mass_of_rotor(*film, 1e16) == pytest.approx(masses[-1], rel=1e-6)
    rates = [growth_rates(1500.0, *film, shaft).item() for shaft in (1e14, RIGID)]
    assert rates[0] == pytest.approx(rates[1], rel=1e-3)


def test_many_rotors_at_once_are_each_alone_and_one_without_film_has_no_rate():
    k = np.array([[[2e8, 1e8], [-3e8, 4e8]], [[np.nan, 0.0], [0.0, 1.0]], [[1e8, 2e8], [-2e8, 3e8]]])
    c = np.tile([[1e6, 1e5], [1e5, 2e6]], (3, 1, 1))
    for shaft in (RIGID, 3e8):
        rates = growth_rates([500.0, 500.0, 4000.0], k, c, shaft)
        assert np.isnan(rates[1])
        assert rates[2] == pytest.approx(growth_rates(4000.0, k[2], c[2], shaft).item())


def test_the_threshold_of_a_bearing_on_an_elastic_shaft_is_where_its_critical_mass_meets_the_rotor():
    given_ = {
        "load": "6 kN",
        "rotor_mass": "400 kg",
        "effective_temperature": "60 degC",
        "shaft_stiffness": "20 MN/m",
    }
    found = answer(**given_)
    assert found.shaft_stiffness == 2e7
    assert found.critical_mass_elastic < found.critical_mass
    assert found.threshold_speed_elastic < found.threshold_speed
    there = answer(**given_ | {"speed": f"{found.threshold_speed_elastic!r} rad/s"})
    assert there.critical_mass_elastic == pytest.approx(400.0, rel=1e-3)
    codes = [(check.code, check.quantity) for check in found.checks]
    assert ("C115", "critical_mass_elastic") in codes


def test_without_shaft_stiffness_nothing_is_said_of_an_elastic_shaft():
    assert not [name for name in answer(effective_temperature="60 degC").values if "elastic" in name]


def test_at_another_speed_the_load_keeps_the_direction_that_was_found():
    case = film(load=None, eccentricity_ratio=0.5, attitude_angle="20 deg", effective_temperature="60 degC")
    state = operating_film(case).film
    assert at_speed(case, state, abs(case.journal_speed)).position == pytest.approx(
        state.solution.position, rel=1e-5
    )


def test_a_threshold_is_not_told_where_films_are_missing_beside_it():
    def excess(speed):
        return 115.0 - speed

    def with_a_hole(speed):
        return math.nan if 101.0 < speed < 124.0 else excess(speed)

    assert crossing(excess, 100.0) == pytest.approx(115.0, rel=1e-4)
    assert crossing(with_a_hole, 100.0) is None
    assert crossing(lambda speed: math.nan, 100.0) is None
