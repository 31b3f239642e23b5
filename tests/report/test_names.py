"""Lists of bearings: complete on paper, short on the terminal, and never ambiguous."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.report.names import bearing_of, counted_results, listed, shortened, split_clearance

GEAR = [f"Pinion {letter}" for letter in "ABCDEFGHIJK"]
THREE = [f"Fan shaft [full] ({which} clearance)" for which in ("minimum", "mean", "maximum")]


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
    assert listed(["A", "A (mean clearance)"], ["A", "A (mean clearance)", "B", "C", "D"]) == (
        "A; A (mean clearance)"
    )


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
    ],
)
def test_a_clearance_is_taken_off_and_nothing_else(name, stem, clearance):
    assert split_clearance(name) == (stem, clearance)


def test_bearings_are_counted_apart_from_their_cases():
    assert {bearing_of(name) for name in THREE} == {"Fan shaft"}
    assert counted_results(THREE) == "3 cases of 1 bearing"
