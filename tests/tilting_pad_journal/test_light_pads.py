"""Offset pads that would have to carry less than they can, but little of the load."""

import math
from functools import cache

import numpy as np
import pytest
from pad_journals import OIL, pad_case, result_of, solution_of, unloaded_pads

from babbitt.case import case_from_dict
from babbitt.core.result import Outcome
from babbitt.kinds.tilting_pad_journal.margins import PadMargin
from babbitt.kinds.tilting_pad_journal.warnings import about_nearly_unloaded
from babbitt.solving import solve

TURBINE = {
    "diameter": "280 mm",
    "pads": {
        "number": 5, "first_pivot": "-54 deg", "extent": "56 deg", "width": "168 mm", "thickness": "45 mm",
        "assembled_clearance": {"kind": "radial", "mean": "210 um"}, "preload": 0.25,
        "pivot": {"kind": "rocker", "fraction": 0.55}, "mass": "9.4 kg", "inertia": "0.027 kg m2",
    },
    "load": "60 kN", "load_angle": "-90 deg", "supply": {"temperature": "50 degC"}, "feed": "spray_bar",
    "thermal": "global", "accuracy": "engineering",
}  # fmt: skip
"""Load between the lower pads; the upper one unloads near 3500 rpm."""


def light_notices(result):
    """What is said of pads that are left without load."""
    return [one for one in result.warnings if one.code == "W417"]


def test_a_pad_without_equilibrium_under_little_load_is_left_without():
    """The other pads alone balance the load; neighbours in speed have nearly the same stiffness."""
    slower, found, faster = (result_of(**TURBINE, speed=f"{speed} rpm") for speed in (3400, 3500, 3600))
    assert found.outcome is Outcome.CONVERGED
    (notice,) = light_notices(found)
    assert not light_notices(slower) + light_notices(faster)
    assert 0.0 < notice.values["need"] < notice.values["least"] <= 0.02 * found.values["load"]
    (loads,), (angles,) = found.arrays["pad_load"], found.arrays["pad_pivot_angle"]
    assert loads[notice.values["pad"] - 1] == 0.0
    force = np.array([[math.cos(angle), math.sin(angle)] for angle in angles]).T @ loads
    assert force == pytest.approx([0.0, -60e3], abs=60.0)
    for one in (slower, faster):
        assert found.values["stiffness_yy"] == pytest.approx(one.values["stiffness_yy"], rel=0.05)
    assert notice.values["stiffness"] < 0.05
    assert notice.values["film"] < 0.01


COMPRESSOR = {
    "diameter": "101.6 mm",
    "pads": {
        "number": 5, "first_pivot": "-54 deg", "extent": "60 deg", "width": "44.45 mm", "thickness": "19.05 mm",
        "assembled_clearance": {"kind": "radial", "mean": "85.725 um"},
        "clearance": {"kind": "radial", "mean": "114.3 um"}, "preload": None,
    },
    "load": "4225.8 N", "supply": {"temperature": "120 degF"}, "groove_pressure": "18 psi",
    "thermal": "full", "deformation": ["growth", "bending"], "reference_temperature": "70 degF",
    "walls": {"pads": {}}, "materials": {"pads": "C45", "journal": "42CrMo4", "housing": "C45"},
    "accuracy": "engineering",
}  # fmt: skip
"""Load between the lower pads; the upper one unloads near 11 400 rpm, at 3.5 % of the load."""


@cache
def compressor(speed):
    """The solution at a speed in rpm."""
    return solution_of(**COMPRESSOR, speed=f"{speed} rpm")


def test_a_pad_of_heated_films_without_equilibrium_about_its_fold_is_left_without_load():
    """At the temperatures of the state without it, it would have to carry less than it can."""
    found = compressor(11600).result
    assert found.outcome is Outcome.CONVERGED
    (notice,) = light_notices(found)
    assert 0.0 < notice.values["need"] < notice.values["least"] <= 0.05 * found.values["load"]
    (loads,), (angles,) = found.arrays["pad_load"], found.arrays["pad_pivot_angle"]
    assert loads[notice.values["pad"] - 1] == 0.0
    force = np.array([[math.cos(angle), math.sin(angle)] for angle in angles]).T @ loads
    assert force[1] == pytest.approx(-4225.8, rel=0.03)  # the oil in the grooves bears a little of it
    assert abs(found.values["energy_balance_error"]) < 1e-3


def test_a_pad_that_stays_unloaded_at_its_final_temperatures_is_in_equilibrium():
    """Films that still heat up load the pad at 11 400 rpm; those that have settled do not."""
    found = compressor(11400).result
    assert found.outcome is Outcome.CONVERGED
    assert not light_notices(found)
    assert set(unloaded_pads(found)) == {3}
    assert found.arrays["pad_load"][0][2] == 0.0


def test_a_pad_that_comes_back_with_more_than_its_share_has_no_solution():
    """What it would carry at the temperatures of the state without it grows with the speed."""
    loads = []
    for speed in (11600, 11700, 11800):
        (notice,) = light_notices(compressor(speed).result)
        loads.append(notice.values["need"])
    assert loads == sorted(loads)
    assert "least" not in notice.values  # it carries at these temperatures
    assert loads[-1] <= 0.05 * 4225.8
    beyond = compressor(11900).result
    assert beyond.outcome is Outcome.PAD_AT_LIMIT
    assert beyond.failure.code == "S401"


def test_heated_pads_tell_what_they_carry_without_being_held_unloaded():
    """The pad that is left out of a journal at 11 600 rpm carries its film's load as soon as it comes back."""
    state = compressor(11600).state.films.solution
    (light,) = state.light
    assert state.pads[light.number].load == 0.0
    assert light.need < light.least < light.returning <= 0.05 * 4225.8


def results_of(changes, **fields):
    """Results at every clearance."""
    return solve(case_from_dict(pad_case(changes, **fields))).results


def messages(result, code):
    """Values of the notices of a code, by pad."""
    return {one.values["pad"]: one for one in result.warnings if one.code == code}


def test_a_preload_below_zero_is_told_at_every_clearance_that_has_one():
    limits = {"kind": "radial", "mean": "78 um", "minimum": "70 um", "maximum": "90 um"}
    changes = {"pads.preload": None, "pads.clearance": {"kind": "radial", "mean": "80 um"},
               "pads.assembled_clearance": limits}  # fmt: skip
    results = results_of(changes, clearance_cases="all")
    told = [messages(one, "W410") for one in results]
    assert [len(one) for one in told] == [0, 0, 4]
    assert told[2][1].values["preload"] == pytest.approx(1.0 - 90.0 / 80.0)


def test_pads_that_carry_little_are_told_with_their_share():
    """The upper pads carry the less, the slower the journal turns; a pad with a share of the load is no remark."""
    slow, fast = (result_of(speed=f"{speed} rpm") for speed in (500, 4000))
    told = messages(slow, "W402")
    assert set(told) == {1, 2}
    for number, one in told.items():
        assert one.values["share"] == pytest.approx(slow.arrays["pad_load"][0][number - 1] / 10e3)
        assert one.values["share"] < 0.02
        assert one.values["margin"] == pytest.approx(slow.arrays["pad_eccentricity_ratio"][0][number - 1])
    assert not messages(fast, "W402")


def test_an_unloaded_offset_pad_carries_above_the_preload_that_is_told():
    offset = {"kind": "rigid", "fraction": 0.52}
    plain = {"pads.preload": 0.1, "pads.pivot": offset}
    bare = result_of(plain, thermal="isothermal", lubricant=OIL, supply=None, effective_temperature="40 degC")
    told = unloaded_pads(bare)
    assert set(told) == {1, 2}
    needed = told[1].values["needed"]
    assert needed > 0.1
    each = [{"preload": needed + 0.01}, {"preload": told[2].values["needed"] + 0.01}, {}, {}]
    held = result_of(plain | {"pads.each": each}, thermal="isothermal", lubricant=OIL, supply=None,
                     effective_temperature="40 degC")  # fmt: skip
    assert not messages(held, "W401")


def test_smaller_steps_settle_a_pad_that_bounces_into_its_limit():
    """At 12 000 rpm large steps lead from one state to the other; the pad has a place between its neighbours."""
    slower, found, faster = (compressor(speed).result for speed in (11600, 12000, 12200))
    assert found.outcome is Outcome.CONVERGED
    assert not light_notices(found) + light_notices(faster)
    loads, more = found.arrays["pad_load"][0], faster.arrays["pad_load"][0]
    assert 0.0 < loads[2] < more[2]
    assert slower.arrays["pad_load"][0][2] < loads[2]
    assert found.values["stiffness_yy"] == pytest.approx(faster.values["stiffness_yy"], rel=0.05)


@pytest.mark.parametrize(
    ("margin", "fold", "variant"),
    [(0.05, 0.1, "near"), (0.3, -0.1, "light"), (math.inf, -math.inf, "kept"), (math.nan, math.nan, "unknown")],
)
def test_what_is_said_of_a_pad_that_carries_little(margin, fold, variant):
    """Only a pad near its fold is shown that fold; one whose fold was not found is not said to stay loaded."""
    (notice,) = about_nearly_unloaded(PadMargin(1, margin, fold, loaded=True), 0.01)
    assert (notice.code, notice.variant) == ("W402", variant)
    assert ("fold" in notice.values) == (variant == "near")
