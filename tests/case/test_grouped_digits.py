"""Quantities with three digits after the point may be grouped thousands, and are told; all others stay quiet."""

import pytest

from babbitt.case import case_from_dict
from babbitt.solving import solve

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


def warnings(**changes) -> list[str]:
    (case,) = case_from_dict(JOURNAL | changes).problems()
    assert {notice.code for notice in case.warnings} <= {"W181"}
    return [notice.message for notice in case.warnings]


@pytest.mark.parametrize(
    ("load", "thousands", "plain"),
    [
        ("12.000 kN", "12000 kN", "12 kN"),
        ("120.500 kN", "120500 kN", "120.5 kN"),
        ("1.250kN", "1250kN", "1.25kN"),
        ("12.345 N", "12345 N", "12.345 N"),
    ],
)
def test_three_digits_after_the_point(load, thousands, plain):
    assert warnings(load=load) == [
        f"load: '{load}' was read with a decimal point; write '{thousands}' if thousands were meant, or '{plain}'"
    ]


@pytest.mark.parametrize(
    "load",
    ["12 kN", "12.5 kN", "12.50 kN", "12000 N", "12.0000 kN", "1234.500 N", "1.250e4 N", "6.125 kN", "3.999 kN"],
)
def test_loads_that_stay_quiet(load):
    assert warnings(load=load) == []


def test_what_a_thousand_times_would_be_refused_stays_quiet():
    """A bore of 80.025 mm is one of a drawing; nobody means 80 m."""
    assert warnings(diameter="80.025 mm", width="40.125 mm", span="180.000 deg") == []
    assert warnings(clearance={"kind": "diametral", "mean": "0.120 mm"}) == []


def test_the_digits_of_a_point_are_its_own():
    points = [{"name": "base"}, {"name": "light", "load": "1.500 kN"}]
    cases = case_from_dict(JOURNAL | {"operating_points": points}).problems()
    told = [[notice.message.split(":")[0] for notice in case.warnings] for case in cases]
    assert told == [[], ["operating_points.1.load"]]


def test_what_a_machine_shares_is_told_at_each_bearing():
    shared = {name: JOURNAL[name] for name in ("lubricant", "materials")}
    own = {name: value for name, value in JOURNAL.items() if name not in (*shared, "supply")}
    machine = {
        "kind": "machine",
        "name": "Two",
        **shared,
        "supply": {"temperature": "50 degC", "pressure": "1.500 bar"},
        "bearings": [own, own | {"name": "Other", "load": "5.500 kN"}],
    }
    told = [[one.message.split(":")[0] for one in case.warnings] for case in case_from_dict(machine).problems()]
    assert told == [[], ["load"]]  # 1500 bar is no supply pressure
    machine["supply"]["circulation_time"] = "2.500 min"
    told = [[one.message.split(":")[0] for one in case.warnings] for case in case_from_dict(machine).problems()]
    assert told == [["supply.circulation_time"], ["supply.circulation_time", "load"]]


def test_the_doubt_reaches_the_result():
    result = solve(case_from_dict(JOURNAL | {"load": "6.000 kN"})).results[0]
    assert result.outcome.solved
    assert "W181" in [notice.code for notice in result.warnings]


def test_how_digits_are_written_makes_no_other_case():
    grouped, plain = (case_from_dict(JOURNAL | {"load": load}) for load in ("6.000 kN", "6 kN"))
    assert grouped == plain
    assert hash(grouped) == hash(plain)
