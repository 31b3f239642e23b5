"""The input lines of a session in Python, each held against the same case written as YAML."""

from __future__ import annotations

import copy
import sys

import numpy as np
import pytest

import babbitt as bb
from babbitt import case as case_language
from babbitt.case import case_hash
from babbitt.solving import solve

LEMON = """
babbitt: 1
kind: journal
name: Journal bearing
diameter: 200 mm
width: 120 mm
clearance: {kind: relative, mean: 1.5 permille}
bore: {kind: lobes, preload: 0.5}
grooves:
  - {angle: 0 deg, extent: 20 deg}
  - {angle: 180 deg, extent: 20 deg}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.15 MPa}
materials: {bearing: C10, journal: C45}
method: film
thermal: global
accuracy: draft
load: 10 kN
speed: 3000 rpm
"""


@pytest.fixture(scope="module")
def lemon():
    return bb.JournalBearing(
        diameter="200 mm",
        width=0.12,
        clearance=bb.relative_clearance(1.5e-3),
        bore=bb.Lobes(preload=0.5),
        grooves=bb.grooves(["0 deg", "180 deg"], extent="20 deg"),
        lubricant="ISO VG 46",
        supply=bb.Supply(temperature="45 degC", pressure="0.15 MPa"),
        materials=bb.Materials(bearing="C10", journal="C45"),
        method=bb.Film(thermal="global", accuracy="draft"),
    )


@pytest.fixture(scope="module")
def point(lemon):
    return lemon.replace(load="10 kN", speed="3000 rpm")


def of_yaml(**changes: str):
    text = LEMON
    for before, after in changes.values():
        assert before in text
        text = text.replace(before, after)
    return case_language.parse_case(text)


def test_what_is_missing_is_told_and_asked_for_when_it_is_needed(lemon):
    assert lemon.missing == ("load", "speed")
    for asks in (lemon.solve, lemon.to_yaml, lemon.check, lambda: lemon.sweep({"width": [0.1, 0.12]})):
        with pytest.raises(bb.CaseError, match="none of load") as caught:
            asks()
        assert len(caught.value.problems) == 2


def test_the_point_is_the_case_of_the_file(point):
    assert point.missing == ()
    assert point == of_yaml()
    assert case_hash(point) == case_hash(of_yaml())


def test_the_text_of_the_point_is_read_back_to_the_same_hash(point):
    assert case_hash(case_language.parse_case(point.to_yaml())) == case_hash(of_yaml())
    assert "diameter: 200 mm" in point.to_yaml()
    assert "width: 120 mm" in point.to_yaml()


def test_a_path_changes_a_field_within_a_part(point):
    warmer = point.replace({"supply.temperature": "50 degC"})
    assert warmer == of_yaml(supply=("45 degC", "50 degC"))
    assert warmer.supply.pressure == 0.15e6
    assert point.supply.temperature == 318.15


def test_copy_replace_is_replace(point):
    assert point.__replace__(load="12 kN") == point.replace(load="12 kN")
    if sys.version_info >= (3, 13):
        assert copy.replace(point, load="12 kN") == point.replace(load="12 kN")


def test_the_result_is_that_of_the_file_to_the_last_bit(point):
    in_python, from_yaml = point.solve(), solve(of_yaml()).solutions[0].result
    for name in ("minimum_film_thickness", "effective_temperature", "friction_power"):
        assert getattr(in_python, name) == getattr(from_yaml, name)


def test_solve_with_changes_is_replace_and_solve(point):
    changed = point.solve(load="12 kN").minimum_film_thickness
    from_yaml = solve(of_yaml(load=("load: 10 kN", "load: 12 kN"))).results[0].minimum_film_thickness
    assert changed == from_yaml
    assert changed < point.solve().minimum_film_thickness


@pytest.mark.solves_anew
def test_arrays_are_solved_one_by_one(point):
    speeds = np.linspace(100.0, 500.0, 3)
    table = point.solve(speed=speeds)
    assert table.shape == (3,)
    np.testing.assert_array_equal(table.parameters["speed"], speeds)
    alone = [point.solve(speed=float(speed)).minimum_film_thickness for speed in speeds]
    assert [one.minimum_film_thickness for one in table.results] == alone


def test_arrays_are_broadcast_against_each_other(point):
    table = point.solve(speed=np.array([[100.0], [200.0]]), load=["5 kN", "10 kN"])
    assert table.shape == (2, 2)
    np.testing.assert_array_equal(table.parameters["load"], [[5e3, 10e3], [5e3, 10e3]])
    alone = point.solve(speed=200.0, load=5e3).minimum_film_thickness
    assert table.results[2].minimum_film_thickness == alone
    with pytest.raises(bb.CaseError, match="do not fit each other"):
        point.solve(speed=np.ones(3), load=np.ones(2))


def test_a_sweep_is_the_product(point):
    grid = point.sweep({"load": np.array([5e3, 10e3]), "bore.preload": [0.3, 0.5]})
    assert grid.shape == (2, 2)
    np.testing.assert_array_equal(grid.parameters["bore.preload"], [[0.3, 0.5], [0.3, 0.5]])
    assert grid.results[-1].minimum_film_thickness == point.solve().minimum_film_thickness
    lower = point.replace({"bore.preload": 0.3, "load": 5e3}).solve().minimum_film_thickness
    assert grid.results[0].minimum_film_thickness == lower


@pytest.mark.slow
def test_processes_give_the_same_bits(point):
    over = {"load": ["5 kN", "10 kN"]}
    alone, together = point.sweep(over), point.sweep(over, workers=2)
    found = [[one.minimum_film_thickness for one in grid.results] for grid in (alone, together)]
    assert found[0] == found[1]


def test_every_method_that_knows_the_bearing_is_compared(point):
    (both,) = point.compare()
    assert "ISO 7902 is left out" in both.left_out
    result = point.solve().minimum_film_thickness
    assert both.asked.result.minimum_film_thickness == result


def test_one_line_to_a_number():
    oil = bb.lubricant("ISO VG 46")
    assert oil.viscosity("60 degC") == oil.dynamic_viscosity(333.15)
    assert "ISO VG 46" in bb.lubricants()
    assert "C45" in bb.materials()
    assert "lund_thomsen_1978" in bb.published_cases()
    assert bb.explain("w101").title
    with pytest.raises(bb.InputError, match="did you mean"):
        bb.explain("W1010")


def test_a_published_case_runs_by_its_name():
    compared = bb.validate("raimondi_boyd_1958")
    assert compared
    assert all(one.ok for one in compared if one.judged)


def test_a_case_is_solved_to_its_bearings(point):
    machine = bb.solve(point)
    assert [one.name for one in machine] == ["Journal bearing"]
    assert machine["Journal bearing"] == point.solve()
    assert machine.solved
    with pytest.raises(bb.CaseError, match="load"):
        bb.solve(point.replace(load=None))
    with pytest.raises(TypeError, match="load_case"):
        bb.solve("journal.yaml")
