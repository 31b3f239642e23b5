"""Asperities that share the load with the film: closed forms, balance of forces, friction over the speed."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from film_bearings import answer, case, film
from scipy.integrate import quad

from babbitt.case import CaseError
from babbitt.core.result import Outcome, Verdict
from babbitt.design.asperity_contact import AsperityContact, composite_modulus, composite_roughness
from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.film.mixed_friction import Asperities, mixed_point, stribeck_curve
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.model import DRAFT, ENGINEERING, REFERENCE, JournalFilm, Land

CONTACT = AsperityContact(roughness=1e-6, modulus=50e9)
WHOLE = (Land(0.0, 2.0 * math.pi),)
ROUND = JournalFilm(0.2, 0.12, 150e-6, 0.03, 300.0, WHOLE)

LIGHT = {
    "load": "2 kN",
    "speed": "300 rpm",
    "supply": {"temperature": "45 degC", "pressure": "0 kPa"},
    "surfaces": {"kind": "direct", "roughness_bearing": "4 um", "roughness_journal": "3 um"},
    "materials": {"bearing": "C10", "journal": "C45", "bearing_metal": "SnSb8Cu4"},
    "mixed_friction": {"boundary_friction": 0.12},
}


@cache
def curve():
    problem = film(**LIGHT)
    state = operating_film(problem).film
    return stribeck_curve(state.solution, problem.asperities, problem.accuracy.resolution)


@pytest.mark.parametrize("ratio", [0.0, 0.5, 1.0, 1.5, 2.0])
def test_fit_of_the_gaussian_integral(ratio):
    def density(height):
        return (height - ratio) ** 2.5 * math.exp(-0.5 * height**2) / math.sqrt(2.0 * math.pi)

    exact = quad(density, ratio, 12.0)[0]
    found = CONTACT.pressure(ratio * CONTACT.roughness) / CONTACT.scale
    assert found == pytest.approx(exact, rel=0.12)  # the fit; beyond, it takes too little


def test_no_contact_from_four_sigma_on():
    assert not CONTACT.pressure([4e-6, 5e-6, 1.0]).any()
    assert not CONTACT.stiffness([4e-6, 5e-6, 1.0]).any()
    assert CONTACT.pressure(3.99e-6) > 0.0


def test_scale_of_the_contact():
    by_hand = 16.0 * 2.0**0.5 * math.pi / 15.0 * 0.04**2 * 0.001**0.5 * 50e9
    assert CONTACT.scale == pytest.approx(by_hand, rel=1e-14)
    stiffer = AsperityContact(1e-6, 100e9)
    assert stiffer.pressure(1e-6) == pytest.approx(2.0 * CONTACT.pressure(1e-6), rel=1e-14)


def test_stiffness_is_the_slope_of_the_pressure():
    gaps, step = np.linspace(0.0, 3.9e-6, 14), 1e-11
    slope = (CONTACT.pressure(gaps - step) - CONTACT.pressure(gaps + step)) / (2.0 * step)
    np.testing.assert_allclose(CONTACT.stiffness(gaps), slope, rtol=1e-6)


def test_modulus_and_roughness_of_two_surfaces():
    assert composite_modulus((200e9, 0.3), (1e30, 0.3)) == pytest.approx(200e9 / 0.91, rel=1e-12)
    assert composite_roughness(4e-6, 0.0) == pytest.approx(0.8e-6, rel=1e-14)
    assert composite_roughness(4e-6, 3e-6) == pytest.approx(1e-6, rel=1e-14)


def test_uniform_gap_presses_all_around_and_moves_nothing():
    thin = JournalFilm(0.2, 0.12, 2e-6, 0.03, 300.0, WHOLE)
    found = Asperities(thin, CONTACT).at(np.zeros(2))
    pressure = float(CONTACT.pressure(2e-6))
    assert found.normal_load == pytest.approx(pressure * math.pi * 0.2 * 0.12, rel=1e-12)
    assert np.abs(found.force).max() < 1e-12 * found.normal_load
    half = 0.5 * float(CONTACT.stiffness(2e-6)) * math.pi * 0.2 * 0.12
    np.testing.assert_allclose(found.stiffness, [[half, 0.0], [0.0, half]], rtol=1e-12, atol=1e-9 * half)


def test_force_of_asperities_falls_by_their_stiffness():
    asperities, place, step = Asperities(ROUND, CONTACT), np.array([60e-6, -135.6e-6]), 1e-11
    found = asperities.at(place)
    assert found.least_gap < 3e-6
    for axis, move in enumerate(np.eye(2) * step):
        change = (asperities.at(place - move).force - asperities.at(place + move).force) / (2.0 * step)
        np.testing.assert_allclose(found.stiffness[:, axis], change, rtol=1e-5)


def test_grooves_have_no_asperities():
    grooved = film(**LIGHT)
    solution = operating_film(grooved).film.solution
    gap = Asperities(solution.film, CONTACT).gap(np.zeros(2))
    dry = np.isinf(gap).mean()
    assert dry == pytest.approx(40.0 / 360.0, abs=0.002)


def test_film_and_asperities_carry_the_load_together():
    found = curve()
    load = np.array([0.0, -2000.0])
    assert len(found.points) > 30
    for point in found.points:
        assert point.outcome is Outcome.CONVERGED
        at_place = film_at_position(point.film.film, tuple(point.film.position))
        residual = at_place.force + point.asperities.force + load
        assert math.hypot(*residual) < 2e-6 * 2000.0


def test_curve_has_its_least_between_boundary_and_hydrodynamic_friction():
    found = curve()
    speeds = [point.speed for point in found.points]
    friction = [point.friction_coefficient for point in found.points]
    share = [point.share for point in found.points]
    place = friction.index(min(friction))
    assert speeds == sorted(speeds)
    assert 0 < place < len(friction) - 1
    assert all(slow > fast for slow, fast in pairwise(friction[: place + 1]))
    assert all(slow < fast for slow, fast in pairwise(friction[place:]))
    assert share == sorted(share, reverse=True)
    assert found.points[-1].share < 1e-9
    assert found.points[-1].friction_coefficient == pytest.approx(found.points[-1].film_friction, rel=1e-9)


def test_boundary_friction_at_vanishing_speed():
    slowest = curve().points[0]
    assert slowest.share > 0.97
    arc = slowest.asperities.normal_load / math.hypot(*slowest.asperities.force)
    assert 1.0 <= arc < 1.01  # pressure is spread over an arc: its sum is a little more than its resultant
    expected = 0.12 * arc * slowest.share
    assert slowest.friction_coefficient == pytest.approx(expected, rel=1e-3)
    assert slowest.friction_coefficient == pytest.approx(0.12, rel=0.04)


def share_at_transition(resolution):
    """Share of the load on asperities at the speed of transition of the engineering grid, on another grid."""
    found = curve()
    near = min(found.points, key=lambda point: abs(point.speed - found.transition_speed)).film
    turning = replace(near.film, angular_speed=found.transition_speed)
    asperities = Asperities(turning, film(**LIGHT).asperities)
    point = mixed_point(turning, (0.0, -2000.0), asperities, near.position, resolution)
    assert point.outcome is Outcome.CONVERGED
    return point.share


def test_transition_is_where_asperities_carry_a_hundredth():
    assert share_at_transition(ENGINEERING) == pytest.approx(0.01, rel=1e-3)


@pytest.mark.parametrize(("grid", "error"), [(DRAFT, 0.05), (REFERENCE, 0.02)])
def test_transition_does_not_depend_on_the_grid(grid, error):
    # the share falls with about the fifth power of the speed: a fiftieth of it is 0.4 % of the speed
    assert share_at_transition(grid) == pytest.approx(0.01, rel=error)


def test_rougher_surfaces_touch_at_higher_speed():
    speeds = [
        answer(**LIGHT | {"mixed_friction": {"composite_roughness": size}}).asperity_transition_speed
        for size in ("0.5 um", "2 um")
    ]
    assert speeds[1] > 4.0 * speeds[0]  # the film thickens with the speed to a power below 1


def test_hydrodynamic_results_stay_and_the_curve_is_reported():
    result = answer(**LIGHT)
    alone = answer(**LIGHT | {"mixed_friction": None})
    assert result.friction_coefficient == alone.friction_coefficient
    assert result.mixed_friction_coefficient == pytest.approx(alone.friction_coefficient, rel=1e-5)
    assert result.composite_roughness == pytest.approx(1e-6)
    assert result.contact_modulus == pytest.approx(composite_modulus((210e9, 0.3), (50e9, 0.35)))
    rows = np.array(result.arrays["stribeck"])
    assert rows[:, 1].min() == pytest.approx(result.least_friction_coefficient)
    assert any("assumption" in said and "family" in said for said in result.assumptions)
    assert "stribeck" not in alone.arrays


def test_mixed_friction_at_the_operating_point_questions_the_result():
    slow = 0.5 * curve().transition_speed
    result = answer(**LIGHT | {"speed": f"{slow} rad/s"})
    assert result.asperity_load_share > 0.01
    assert "W137" in result.questioning_codes
    assert result.verdict is not Verdict.PASS
    assert result.mixed_friction_coefficient > result.friction_coefficient


@pytest.mark.parametrize(
    ("changed", "field", "words"),
    [
        ({"surfaces": None}, "mixed_friction.composite_roughness", "is missing"),
        ({"materials": {"bearing": "C10", "journal": {"thermal_expansion": "11e-6 1/K"}}},
         "mixed_friction.contact_modulus", "is missing"),
        ({"thermal": "adiabatic"}, "mixed_friction", "one viscosity"),
        ({"bearing_speed": "10 rpm", "grooves": None, "film_start": "widest_gap", "cavitation": "reynolds",
          "span": 360}, "mixed_friction", "at rest"),
        ({"method": "iso7902", "grooves": None, "span": 360}, "mixed_friction", "hydrodynamic friction only"),
        ({"supply": {"temperature": "45 degC", "flow": "5 L/min"}}, "supply.flow", "given pressure"),
    ],
)  # fmt: skip
def test_what_the_mixed_branch_does_not_know_is_refused(changed, field, words):
    with pytest.raises(CaseError) as refused:
        case(**LIGHT | changed)
    assert any(field in str(issue) and words in str(issue) for issue in [refused.value]), str(refused.value)
