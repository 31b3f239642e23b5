"""Lists of bearings: complete on paper, short on the terminal, and never ambiguous."""

from __future__ import annotations

import copy
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.case import parse_case
from babbitt.core.result_name import ResultName
from babbitt.report.chapters import chapters
from babbitt.report.names import bearing_of, counted_results, listed, shortened, split_clearance
from babbitt.report.totals import totals
from babbitt.solving import solve

MEAN = ResultName("A", clearance="mean")
GEAR = [f"Pinion {letter}" for letter in "ABCDEFGHIJK"]
THREE = [ResultName("Fan shaft", "full", which) for which in ("minimum", "mean", "maximum")]


@given(st.lists(st.sampled_from(GEAR), min_size=1, unique=True))
def test_a_full_list_leaves_nobody_out(names):
    said = listed(names, GEAR)
    if said.startswith("all"):
        left_out = [name for name in GEAR if name not in names]
        assert all(name in said for name in left_out)
        assert not any(name in said for name in names)
    else:
        assert said.split("; ") == names


def test_names_with_commas_stay_apart():
    assert listed(["Pinion, left", "Pinion, right"], ["Pinion, left", "Pinion, right", "Wheel"]) == (
        "Pinion, left; Pinion, right"
    )


def test_clearances_of_one_bearing_share_its_name():
    assert listed(THREE[:2], THREE) == "Fan shaft [full] (minimum, mean clearance)"
    assert listed(["A", MEAN], ["A", MEAN, "B", "C", "D"]) == ("A; A (mean clearance)")


def test_a_short_list_counts_what_it_does_not_name():
    assert shortened(GEAR[:5], GEAR) == "Pinion A; Pinion B and 3 more"
    assert shortened(GEAR[:2], GEAR) == "Pinion A; Pinion B"
    assert shortened(GEAR, GEAR) == "all 11 bearings"


@pytest.mark.parametrize(
    ("name", "stem", "clearance"),
    [
        (THREE[0], "Fan shaft [full]", "minimum"),
        ("Second-stage pinion (a)", "Second-stage pinion (a)", ""),
        ("(mean clearance)", "(mean clearance)", ""),
        (ResultName("Gear (hot state)", clearance="mean"), "Gear (hot state)", "mean"),
        (ResultName("Gear (hot state)", state="cold state"), "Gear (hot state)", "cold state"),
    ],
)
def test_a_clearance_is_taken_off_and_nothing_else(name, stem, clearance):
    assert split_clearance(name) == (stem, clearance)


def test_bearings_are_counted_apart_from_their_cases():
    assert {bearing_of(name) for name in THREE} == {"Fan shaft"}
    assert counted_results(THREE) == "3 cases of 1 bearing"


def test_a_name_survives_copies():
    name = ResultName("Pump [A]", "full [b]", "minimum")
    for same in (copy.deepcopy(name), copy.copy(name), pickle.loads(pickle.dumps(name))):
        assert same == name == "Pump [A] [full [b]] (minimum clearance)"
        assert (same.bearing, same.point, same.clearance, same.state) == ("Pump [A]", "full [b]", "minimum", "")


BEARING = """
    diameter: 80 mm
    width: 40 mm
    clearance: {kind: relative, mean: 1.5 permille}
    span: 180 deg
    load: 6 kN
    speed: 2000 rpm
"""


def machine_of(*names: str) -> str:
    bearings = "".join(f"  - kind: journal\n    name: {name}{BEARING}" for name in names)
    return (
        "kind: machine\nname: Pair\nlubricant: ISO VG 46\nmaterials: {bearing: C10, journal: C45}\n"
        f"supply: {{temperature: 50 degC, pressure: 0.2 MPa}}\nbearings:\n{bearings}"
    )


@pytest.mark.parametrize("names", [("Pump [A]", "Pump [B]"), ("Gear (hot state)", "Gear (cold state)")])
def test_brackets_in_names_of_bearings_tell_nothing(names):
    """Two bearings stay two, whatever their names look like: both are counted and summed."""
    machine = solve(parse_case(machine_of(*names)))
    results = machine.results
    plain = solve(parse_case(machine_of("One", "Other"))).results
    found, expected = totals(results), totals(plain)
    assert found is not None
    assert found.bearings == 2
    assert found.values == expected.values
    assert counted_results([result.name for result in results]) == "2 bearings"
    assert [result.name for result in results] == list(names)
    assert len(chapters(machine.solutions)) == 2
