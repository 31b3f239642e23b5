"""Many films at once are those solved one by one; a locus passes through the operating point."""

from __future__ import annotations

import math
from functools import cache

import film_bearings
import numpy as np
import pytest

from babbitt.kinds.journal.film.isothermal import is_expensive, operating_film
from babbitt.kinds.journal.study.film_points import film_points
from babbitt.kinds.journal.study.locus import locus_over_load, locus_over_speed

POCKETS = [{"angle": f"{angle} deg", "extent": "20 deg", "width": "90 mm"} for angle in (0, 180)]
LOBES = [{"angle": f"{angle} deg", "extent": "15 deg"} for angle in (90, 210, 330)]
BEARINGS = {
    "two": {},
    "clockwise": {"speed": "-3000 rpm", "load_angle": "-60 deg"},
    "lobes": {"grooves": LOBES, "bore": {"kind": "lobes", "preload": 0.5}, "load": "5 kN"},
    "pockets": {"grooves": None, "pockets": POCKETS},
}


@cache
def bearing(name):
    case = film_bearings.film(effective_temperature="60 degC", **BEARINGS[name])
    return case, operating_film(case).film


@pytest.mark.parametrize("name", BEARINGS)
def test_the_locus_passes_through_the_operating_point(name):
    case, state = bearing(name)
    tolerance = 5e-3 if is_expensive(state) else 1e-5  # that of a draft grid
    for found, over in ((locus_over_load(case, state), "loads"), (locus_over_speed(case, state), "speeds")):
        middle = found.loads.size // 2
        assert found.loads[middle] == pytest.approx(state.load)
        assert found.speeds[middle] == pytest.approx(abs(case.journal_speed))
        assert np.all(np.diff(getattr(found, over)) > 0.0)
        assert found.position[middle] == pytest.approx(state.solution.position, rel=2.0 * tolerance)
        assert found.stiffness[middle] == pytest.approx(state.solution.stiffness, rel=10.0 * tolerance)
        assert found.attitude_angle[middle] == pytest.approx(state.solution.attitude_angle, rel=tolerance)
        assert found.sommerfeld_number[middle] == pytest.approx(state.solution.sommerfeld_number)


def test_load_presses_the_journal_down_and_speed_lifts_it():
    case, state = bearing("two")
    assert np.all(np.diff(locus_over_load(case, state).minimum_film_thickness) < 0.0)
    assert np.all(np.diff(locus_over_speed(case, state).minimum_film_thickness) > 0.0)


def test_without_supply_pressure_the_place_depends_on_the_sommerfeld_number_alone():
    dry = [groove | {"pressure": "0 Pa"} for groove in film_bearings.GROOVES]
    case = film_bearings.film(effective_temperature="60 degC", grooves=dry)
    state = operating_film(case).film
    speeds = abs(case.journal_speed) * np.array([0.5, 1.0, 2.0])
    by_speed = locus_over_speed(case, state, speeds)
    by_load = locus_over_load(case, state, state.load * np.array([2.0, 1.0, 0.5]))
    assert by_speed.sommerfeld_number == pytest.approx(by_load.sommerfeld_number)
    assert by_speed.position == pytest.approx(by_load.position, rel=1e-5)
    assert by_speed.eccentricity_ratio == pytest.approx(by_load.eccentricity_ratio, rel=1e-5)


def test_films_solved_at_once_are_those_solved_one_by_one():
    dry = [groove | {"pressure": "0 Pa"} for groove in film_bearings.GROOVES]
    case = film_bearings.film(effective_temperature="60 degC", grooves=dry)
    state = operating_film(case).film
    mirrored_case = film_bearings.film(
        effective_temperature="60 degC", speed="-3000 rpm", grooves=dry
    )  # clockwise: one by one
    mirror = operating_film(mirrored_case).film
    loads, speeds = np.array([5e3, 3e4, 1e5]), np.array([200.0, 300.0, 400.0])
    at_once, singly = film_points(case, state, loads, speeds), film_points(mirrored_case, mirror, loads, speeds)
    assert singly.position * [-1.0, 1.0] == pytest.approx(at_once.position, rel=1e-6)
    signs = np.array([[1.0, -1.0], [-1.0, 1.0]])
    assert singly.stiffness * signs == pytest.approx(at_once.stiffness, rel=1e-5)
    assert singly.attitude_angle == pytest.approx(at_once.attitude_angle, rel=1e-6)
    assert singly.critical_mass() == pytest.approx(at_once.critical_mass(), rel=1e-4)


def test_points_without_a_film_hold_no_numbers_and_are_left_out_of_a_locus():
    case, state = bearing("two")
    found = film_points(case, state, [3e4, 1e12], 300.0)
    assert found.solved.tolist() == [True, False]
    assert np.isnan(found.position[1]).all()
    assert np.isnan(found.critical_mass()[1])
    assert locus_over_load(case, state, [3e4, 1e12]).loads.tolist() == [3e4]


def test_a_prescribed_position_keeps_the_direction_of_the_load_found():
    case = film_bearings.film(
        load=None, eccentricity_ratio=0.5, attitude_angle="20 deg", effective_temperature="60 degC"
    )
    state = operating_film(case).film
    found = film_points(case, state, state.load, abs(case.journal_speed))
    assert found.eccentricity_ratio.item() == pytest.approx(0.5, rel=1e-4)
    assert abs(found.load_angle - case.load_angle) > math.radians(5.0)


def test_the_work_can_be_watched():
    case, state = bearing("lobes")
    seen = []

    def watch(points):
        for point in points:
            seen.append(point)
            yield point

    film_points(case, state, state.load, [100.0, 200.0, 300.0], watch)
    assert seen == [0, 1, 2]
