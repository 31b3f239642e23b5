"""Numbers without unit that look as if another unit was meant are told; all others stay quiet."""

import json
import math

import pytest

from babbitt.cases import case_from_dict, design_cases, parse_case
from babbitt.standards.iso7902 import check

JOURNAL = {
    "kind": "journal",
    "name": "Test",
    "diameter": "80 mm",
    "width": "40 mm",
    "clearance": {"kind": "relative", "mean": "1.5 permille"},
    "span": "180 deg",
    "materials": {"bearing": "C10", "journal": "C45"},
    "lubricant": "ISO VG 46",
    "supply": {"temperature": "50 degC", "pressure": "0.2 MPa"},
    "load": "6 kN",
    "speed": "2000 rpm",
}


def doubts(**changes) -> list[str]:
    (case,) = design_cases(case_from_dict(JOURNAL | changes))
    assert {notice.code for notice in case.doubts} <= {"W117"}
    return [notice.message for notice in case.doubts]


@pytest.mark.parametrize("speed", [3000, 3000.0, "3000", "3e3"])
def test_a_whole_speed_without_unit(speed):
    assert doubts(speed=speed) == [
        "speed: 3000 without unit was read as 3000 rad/s = 28648 rpm; write '3000 rpm' if that was meant"
    ]


def test_the_sign_of_a_speed_and_the_speed_of_the_bearing():
    (message,) = doubts(speed=-1500)
    assert "-1500 rad/s = -14324 rpm; write '-1500 rpm'" in message
    (message,) = doubts(bearing_speed=150)
    assert message.startswith("bearing_speed: 150 without unit")


@pytest.mark.parametrize("speed", ["3000 rad/s", "3000 rpm", 314.15926535, "314.159", 99, 10.0])
def test_speeds_that_stay_quiet(speed):
    assert doubts(speed=speed) == []


@pytest.mark.parametrize("load", [6, 6.5, "40", 46.5, 999])
def test_a_small_load_without_unit(load):
    assert doubts(diameter="20 mm", width="2 mm", load=load) == [
        f"load: {load} without unit was read as {load} N; write '{load} kN' if that was meant"
    ]


@pytest.mark.parametrize("load", ["40 N", "0.04 kN", 1000, 6000, 812.345678, "812.34"])
def test_loads_that_stay_quiet(load):
    assert doubts(load=load, width="8 mm") == []


def test_json_of_a_program_stays_quiet():
    case = case_from_dict(JOURNAL)
    again = parse_case(json.dumps(case.model_dump(mode="json", exclude_defaults=True) | {"span": math.pi}))
    assert again == case
    assert [design.doubts for design in design_cases(again)] == [()]


def test_the_number_in_doubt_is_that_of_the_point():
    points = [{"name": "base"}, {"name": "fast", "speed": 300}, {"name": "light", "load": 50}]
    cases = design_cases(case_from_dict(JOURNAL | {"speed": 200, "operating_points": points}))
    told = [[notice.message.split(" without")[0] for notice in case.doubts] for case in cases]
    assert told == [["speed: 200"], ["speed: 300"], ["speed: 200", "load: 50"]]


def test_the_doubt_reaches_the_result():
    (case,) = design_cases(case_from_dict(JOURNAL | {"speed": 300}))
    result = check(case)
    assert result.outcome.solved
    assert "W117" in [notice.code for notice in result.warnings]


def test_a_unit_makes_no_other_case():
    bare, with_unit = (case_from_dict(JOURNAL | {"speed": speed}) for speed in (300, "300 rad/s"))
    assert bare == with_unit
    assert hash(bare) == hash(with_unit)
