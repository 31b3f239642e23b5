"""Plain films of a given temperature solved as arrays: row by row what is solved for one bearing."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose
from studied_cases import block

from babbitt.case.loading import case_from_dict
from babbitt.kinds.journal.study import many_rows
from babbitt.study import grids, plan
from babbitt.study.rows import solved_one_by_one, solved_rows

FILM = {
    "kind": "journal",
    "name": "Two lands",
    "diameter": "200 mm",
    "width": "120 mm",
    "clearance": {"kind": "relative", "mean": "1.5 permille"},
    "grooves": [{"angle": "0 deg", "extent": "20 deg"}, {"angle": "180 deg", "extent": "20 deg"}],
    "lubricant": "ISO VG 32",
    "effective_temperature": "55 degC",
    "load": "20 kN",
    "speed": "1500 rpm",
    "method": {"kind": "film", "accuracy": "draft"},
}
HEATED = {"materials": {"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "42CrMo4"}}
DUTY = {"load": {"uniform": ["5 kN", "120 kN"]}, "speed": {"uniform": ["300 rpm", "4000 rpm"]}}
SIZES = {
    "width": {"uniform": ["80 mm", "190 mm"]},
    "clearance.mean": {"uniform": ["0.8 permille", "2.5 permille"]},
    "effective_temperature": {"uniform": ["40 degC", "80 degC"]},
}
KEPT = [
    "minimum_film_thickness", "eccentricity_ratio", "maximum_pressure", "friction_power", "friction_coefficient",
    "total_flow", "inlet_flow", "specific_load", "film_reynolds_number", "critical_mass", "whirl_frequency_ratio",
    *(f"{matrix}_{axes}" for matrix in ("stiffness", "damping") for axes in ("xx", "xy", "yx", "yy")),
]  # fmt: skip

EQUAL = 1e-9
"""Relative difference of what is found by either way (docs/studies.md)."""


@pytest.fixture(autouse=True)
def unmeasured(monkeypatch):
    """No plan here needs to know how long a row takes."""
    monkeypatch.setattr(plan, "timed", lambda *_: 1e-3)


def rows_of(changes, vary, samples, outputs=KEPT):
    made = plan.plan(
        case_from_dict({**FILM, **changes}), block(kind="tolerance", vary=vary, samples=samples, outputs=outputs)
    )
    values, groups = grids.joint_sample(made.task.inputs, made.block)
    return made.task, {"row": np.arange(samples), "group": groups, **values}


def assert_equal(many, one):
    assert list(many) == list(one)
    for name, expected in one.items():
        if expected.dtype == object:
            assert many[name].tolist() == expected.tolist(), name
        else:  # of matrices the entries that vanish count beside the others
            size = EQUAL * np.nanmax(np.abs(expected), initial=0.0) if name in KEPT else EQUAL
            assert_allclose(many[name], expected, rtol=EQUAL, atol=size, err_msg=name)


def test_three_hundred_films_are_those_of_one_bearing(one_by_one):
    task, rows = rows_of({}, DUTY | SIZES, 300)
    many = solved_rows(task, rows)
    one = solved_one_by_one(task, rows)
    assert_equal(many, one)
    assert len(one_by_one) <= 15  # what one search does not find, and where the journal would not stay
    assert {"fail", "no_verdict"} <= set(many["verdict"])


@pytest.mark.parametrize(
    "changes",
    [
        {"load_angle": "-60 deg", "cavitation": "reynolds", "rotor_mass": "2 t"},
        {
            "grooves": [{"angle": "90 deg", "extent": "30 deg", "pressure": "0 Pa"}],
            "supply": {"temperature": "45 degC", "pressure": "0.2 MPa"},
            **HEATED,
            "limits": {"minimum_film_thickness": "20 um", "specific_load": "3 MPa"},
        },
        {
            "clearance": {
                "kind": "relative",
                "mean": "1.5 permille",
                "minimum": "1.46 permille",
                "maximum": "1.54 permille",
            },
            "clearance_cases": "mean",
            "rotor_mass": "2 t",
        },
    ],
)
def test_directions_conditions_and_limits_are_those_of_one_bearing(one_by_one, changes):
    task, rows = rows_of(changes, DUTY, 24)
    assert_equal(solved_rows(task, rows), solved_one_by_one(task, rows))
    assert len(one_by_one) <= 4


def test_films_of_one_sommerfeld_number_are_alike():
    task, rows = rows_of({}, DUTY, 32)
    twice = {**rows, "load": 2.0 * rows["load"], "speed": 2.0 * rows["speed"]}
    slow, fast = (many_rows.solve_many(task, one) for one in (rows, twice))
    for name, factor in (("eccentricity_ratio", 1.0), ("maximum_pressure", 2.0), ("friction_power", 4.0)):
        assert_allclose(fast[name], factor * slow[name], rtol=1e-8)


UNKNOWN = {
    "pressure": ({"supply": {"temperature": "45 degC", "pressure": "0.1 MPa"}}, KEPT),
    "surfaces": (
        {"surfaces": {"kind": "direct", "roughness_bearing": "2 um", "roughness_journal": "1 um"}}, KEPT
    ),
    "tilt": ({"misalignment": {"x": "0.1 mrad", "y": "0 mrad"}}, KEPT),
    "clockwise": ({"speed": "-1500 rpm"}, KEPT),
    "all equilibria": ({"equilibria": "all"}, KEPT),
    "threshold": ({}, ["threshold_speed"]),
    "heat": (
        {"effective_temperature": None, "supply": {"temperature": "45 degC", "pressure": "0.1 MPa"}, **HEATED},
        KEPT,
    ),
}  # fmt: skip


@pytest.mark.parametrize("what", UNKNOWN)
def test_what_the_arrays_do_not_know_is_left_to_single_films(what):
    changes, outputs = UNKNOWN[what]
    given = {key: value for key, value in {**FILM, **changes}.items() if value is not None}
    case = case_from_dict(given)
    vary = {"width": SIZES["width"]}
    made = plan.plan(case, block(kind="tolerance", vary=vary, samples=16, outputs=outputs))
    values, groups = grids.joint_sample(made.task.inputs, made.block)
    assert many_rows.solve_many(made.task, {"row": np.arange(16), "group": groups, **values}) is None
