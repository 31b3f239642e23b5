"""Cooling, half tolerance and root finder by closed forms, through whole cases."""

import math
from dataclasses import replace

import pytest

from babbitt.case import case_from_dict
from babbitt.design.cooling import heat_transfer_coefficient, pedestal_surface
from babbitt.kinds.journal.iso7902 import check
from babbitt.numerics.roots import find_root
from babbitt.solving import solve

RING = {
    "kind": "journal",
    "name": "Ring-oiled",
    "diameter": "100 mm",
    "width": "80 mm",
    "clearance": {"kind": "relative", "mean": "1.5 permille"},
    "span": "180 deg",
    "materials": {"bearing": "C10", "journal": "C45"},
    "lubricant": "ISO VG 46",
    "load": "4 kN",
    "speed": "400 rpm",
}
D, B, AMBIENT = 0.1, 0.08, 293.15


@pytest.mark.parametrize(
    ("housing", "area"),
    [
        # two faces less the shaft's hole, and the mantle
        ({"kind": "cylinder", "diameter": "300 mm", "width": "150 mm"},
         2.0 * math.pi / 4.0 * (0.3**2 - D**2) + math.pi * 0.3 * 0.15),
        ({"kind": "pedestal", "height": "500 mm", "width": "200 mm"}, math.pi * 0.5 * (0.2 + 0.5 / 2.0)),
        ({"kind": "in_machine"}, 15.0 * B * D),
        ({"kind": "in_machine", "factor": 20}, 20.0 * B * D),
    ],
)  # fmt: skip
@pytest.mark.parametrize(("air", "coefficient"), [(None, 15.0), ("1.2 m/s", 15.0), ("4 m/s", 7.0 + 12.0 * 2.0)])
def test_heat_to_the_air_is_coefficient_times_area_times_difference(housing, area, air, coefficient):
    """In still air 15 W/(m2 K); the heat of friction leaves through the housing alone."""
    cooling = {"ambient_temperature": "20 degC", "housing": housing} | ({"air_speed": air} if air else {})
    (result,) = solve(case_from_dict(RING | {"cooling": cooling})).results
    assert result.outcome.solved
    difference = result.values["effective_temperature"] - AMBIENT
    assert result.values["heat_to_surroundings"] == pytest.approx(coefficient * area * difference, rel=1e-9)
    assert result.values["heat_to_surroundings"] == pytest.approx(result.values["friction_power"], rel=1e-6)


def test_moving_air_begins_above_its_bound():
    assert heat_transfer_coefficient(1.2) == 15.0
    assert heat_transfer_coefficient(1.2000001) == pytest.approx(7.0 + 12.0 * math.sqrt(1.2), rel=1e-6)


def test_a_pedestal_is_half_its_height_and_its_width_around():
    assert pedestal_surface(0.4, 0.1) == pytest.approx(math.pi * 0.4 * 0.3, rel=1e-15)


def test_the_mean_clearance_is_that_computed_with():
    """The mean that a drawing gives need not lie in the middle of its limits."""
    clearance = {"kind": "relative", "mean": "1.2 permille", "minimum": "1 permille", "maximum": "2 permille"}
    supply = {"temperature": "40 degC", "pressure": "0.1 MPa"}
    (case,) = case_from_dict(RING | {"clearance": clearance, "supply": supply}).problems()
    assert case.bearing.relative_clearance == pytest.approx(1.2e-3)
    assert case.bearing.mean_relative_clearance == pytest.approx(1.2e-3, rel=1e-12)
    judged = next(check for check in check(case).checks if check.code == "C114")
    assert judged.value == pytest.approx(1.2e-3, rel=1e-12)
    every = case_from_dict(RING | {"clearance": clearance, "supply": supply, "clearance_cases": "all"}).problems()
    assert [one.bearing.mean_relative_clearance for one in every] == pytest.approx([1.2e-3] * 3)
    unnamed = replace(case.bearing, mean_clearance=None)  # a design without a mean of its own
    assert unnamed.mean_relative_clearance == pytest.approx(1.5e-3, rel=1e-12)
    (plain,) = case_from_dict(RING | {"supply": supply}).problems()
    assert plain.bearing.mean_relative_clearance == plain.bearing.relative_clearance


def counted(function):
    calls = []

    def of(x):
        calls.append(x)
        return function(x)

    return of, calls


def test_a_step_is_halved_down_to_round_off():
    """Equal values on both sides leave interpolation nothing to go by: from 1 to 4 round-offs in 52 halvings."""
    step, calls = counted(lambda x: -1.0 if x < 0.3 else 1.0)
    root = find_root(step, 0.0, 1.0)
    assert root.converged
    assert abs(root.value - 0.3) <= 4.0 * 2.2e-16
    assert len(calls) <= 2 + 60


def test_a_root_at_zero_ends_where_numbers_end():
    """Relative round-off of zero is zero: the least normal number ends the search."""
    root = find_root(lambda x: 1.0 if x > 0.0 else -1.0, -1.0, 3.0)
    assert root.converged
    assert abs(root.value) <= 1e-300


@pytest.mark.parametrize(("low", "high"), [(0.0, 1.0), (-1.0, 0.0)])
def test_a_root_at_either_bound_needs_no_step(low, high):
    line, calls = counted(lambda x: x)
    root = find_root(line, low, high)
    assert (root.value, root.converged, len(calls)) == (0.0, True, 2)


def test_the_tolerance_is_kept_and_not_overdone():
    for absolute in (1e-2, 1e-5, 1e-9):
        curve, calls = counted(lambda x: math.exp(x) - 2.0)
        root = find_root(curve, 0.0, 5.0, absolute=absolute)
        assert abs(root.value - math.log(2.0)) <= absolute
        fine = len(calls)
    coarse, calls = counted(lambda x: math.exp(x) - 2.0)
    find_root(coarse, 0.0, 5.0, relative=0.1)
    assert len(calls) < fine


def test_a_search_cut_short_gives_the_better_end_and_says_so():
    root = find_root(lambda x: x - 0.9, 0.0, 100.0, most_steps=0)
    assert (root.value, root.converged) == (0.0, False)


@pytest.mark.parametrize("bad", [0.0, 1.0])
def test_no_number_at_either_bound_is_refused(bad):
    with pytest.raises(ValueError, match="must be a number"):
        find_root(lambda x: math.nan if x == bad else x - 0.5, 0.0, 1.0)
