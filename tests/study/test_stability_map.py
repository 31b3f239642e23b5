"""The map of stability: Hurwitz at every point, its boundary where the threshold search finds it."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import film_bearings
import numpy as np
import pytest
from routh_hurwitz import is_stable

from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.film.whirl import rotor_threshold
from babbitt.kinds.journal.study.stability_map import StabilityMap, stability_map
from babbitt.reynolds.stability.rotor import growth_rates, stable_masses_of_rotor
from babbitt.reynolds.stability.whirl_limits import STANDARD_GRAVITY

LOBES = [{"angle": f"{angle} deg", "extent": "15 deg"} for angle in (90, 210, 330)]
BEARINGS = {
    "two": {"load": "10 kN"},
    "dry": {"load": "10 kN", "grooves": [groove | {"pressure": "0 Pa"} for groove in film_bearings.GROOVES]},
    "elastic": {"load": "10 kN", "rotor_mass": "2 t", "shaft_stiffness": "200 MN/m"},
    "lobes": {"grooves": LOBES, "bore": {"kind": "lobes", "preload": 0.5}, "load": "5 kN", "speed": "-6000 rpm"},
}


@cache
def bearing(name):
    case = film_bearings.film(effective_temperature="60 degC", **BEARINGS[name])
    return case, operating_film(case).film


@cache
def mapped(name):
    return stability_map(*bearing(name))


@pytest.mark.parametrize("name", ["two", "dry", "lobes"])
def test_every_point_is_judged_as_routh_and_hurwitz_do(name):
    found = mapped(name)
    masses = np.repeat(found.masses, found.speeds.size)
    judged = [
        is_stable(mass, stiffness, damping)
        for mass, stiffness, damping in zip(masses, found.points.stiffness, found.points.damping, strict=True)
    ]
    assert found.points.solved.all()
    assert found.stable.ravel().tolist() == judged
    assert 0.05 < found.stable.mean() < 0.95


@pytest.mark.parametrize("name", BEARINGS)
def test_a_rotor_is_stable_where_it_is_lighter_than_the_critical_mass(name):
    found = mapped(name)
    clear = np.abs(np.log(np.clip(found.reserve, 1e-6, 1e6))) > 1e-3
    assert (found.stable == (found.reserve > 1.0))[clear].all()


@pytest.mark.parametrize("name", BEARINGS)
def test_the_boundary_is_where_the_search_finds_the_threshold(name):
    case, state = bearing(name)
    found = mapped(name)
    shaft = {} if case.shaft_stiffness is None else {"shaft_stiffness": case.shaft_stiffness}
    for place in found.loads.size * np.array([1, 3, 5]) // 6:
        at = replace(state, load=float(found.loads[place]))
        wanted = rotor_threshold(case, at, float(found.masses[place]), **shaft)
        assert found.thresholds()[place] == pytest.approx(
            wanted.speed, rel=0.008
        )  # a straight line between speeds 1.28 apart


def test_without_a_mass_the_load_is_the_weight():
    found = mapped("two")
    assert found.masses == pytest.approx(found.loads / STANDARD_GRAVITY)
    assert mapped("elastic").masses == pytest.approx(2000.0)


def test_a_rotor_that_always_whirls_and_one_that_never_does_have_no_threshold():
    case, state = bearing("two")
    for mass, stable in ((1e9, False), (1e-3, True)):
        found = stability_map(replace(case, rotor_mass=mass), state, [5e3, 1e4], [200.0, 300.0, 400.0])
        assert found.growth.shape == (2, 3)
        assert (found.stable == stable).all()
        assert np.isnan(found.thresholds()).all()


def test_where_there_is_no_film_nothing_is_stable():
    case, state = bearing("two")
    found = stability_map(case, state, [1e4, 1e12], [200.0, 300.0])
    assert np.isnan(found.growth[1]).all()
    assert not found.stable[1].any()


def test_a_softer_shaft_whirls_earlier_at_every_load():
    case, state = bearing("elastic")
    stiff = stability_map(replace(case, shaft_stiffness=None), state)
    both = np.isfinite(stiff.thresholds()) & np.isfinite(mapped("elastic").thresholds())
    assert both.sum() > 5
    assert (mapped("elastic").thresholds()[both] < stiff.thresholds()[both]).all()


def test_a_film_that_no_small_mass_survives_is_not_stable_under_a_shaft_without_journal_mass():
    """Neither K nor C is definite: the six eigenvalues of a journal without mass miss the motion that grows."""
    film, mass, shaft, nothing = (
        ([[-0.9, -0.4], [0.1, 1.5]], [[-0.2, 0.5], [1.4, 0.5]]),
        10.0,
        0.5,
        np.zeros((2, 2)),
    )
    growth, bounds = growth_rates(mass, *film, shaft), stable_masses_of_rotor(*film, shaft)
    inertia = np.diag([mass, mass, 1e-9, 1e-9])  # of rotor and journal
    k = np.block([[shaft * np.eye(2), -shaft * np.eye(2)], [-shaft * np.eye(2), shaft * np.eye(2) + film[0]]])
    c = np.block([[nothing, nothing], [nothing, np.array(film[1])]])
    step = np.block([[np.zeros((4, 4)), np.eye(4)], [-np.linalg.solve(inertia, k), -np.linalg.solve(inertia, c)]])
    assert np.linalg.eigvals(step).real.max() > 0.0
    one = np.ones(1)
    masses = (np.array([[bound]]) for bound in (bounds.least, bounds.greatest))
    seen = StabilityMap(one, one, mass * one, shaft, growth.reshape(1, 1), *masses, None)
    assert not seen.stable.any()
