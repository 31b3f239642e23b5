"""Limits of thrust pads that are kept by less than their films can tell, and those of the metal."""

import math

import pytest

from babbitt.case import case_from_dict
from babbitt.core.result import Bound, Check, Verdict
from babbitt.design.uncertainty import shear_heat
from babbitt.kinds.thrust.design import Oil
from babbitt.kinds.thrust.margins import (
    HOTTER,
    HOTTER_THAN_MEANS,
    MOST_THINNER,
    THINNER_THAN_MEANS,
    hotter_by_shear,
    warnings_about_margins,
)
from babbitt.properties.lubricants import lubricant
from babbitt.solving import solve

PADS = {
    "kind": "thrust",
    "name": "Fast pads",
    "pads": {
        "number": 8, "inner_diameter": "100 mm", "outer_diameter": "200 mm", "extent": "36 deg",
        "pivot": {"kind": "point", "radius": "76 mm", "fraction": 0.6},
    },
    "load": "70 kN", "speed": "9000 rpm", "lubricant": "ISO VG 46",
    "supply": {"temperature": "45 degC"}, "oil": {"kind": "heat_balance", "carry_over": 0.75},
    "materials": {"bearing_metal": "SnSb8Cu4"},
}  # fmt: skip


def solved(**fields):
    return solve(case_from_dict(PADS | fields)).results[0]


def said(result):
    return [one for one in result.warnings if one.code == "W215"]


@pytest.mark.parametrize(("load", "speed"), [("70 kN", "9000 rpm"), ("45 kN", "10000 rpm")])
def test_fast_pads_of_one_temperature_do_not_pass_where_adiabatic_ones_fail(load, speed):
    """28 and 38 K lie between the trailing edge of one temperature and the hottest oil of the adiabatic film."""
    quick, better = (solved(load=load, speed=speed, thermal=one) for one in ("global", "adiabatic"))
    assert [one.ok for one in better.checks if one.code == "C108"] == [False]
    assert quick.verdict is Verdict.REMARKS
    assert "(C108)" in said(quick)[0].message
    quick_pads = quick.values
    hotter = HOTTER * quick_pads["surface_speed"] * math.sqrt(quick_pads["effective_viscosity"])
    assert better.values["maximum_temperature"] < quick_pads["trailing_temperature"] + hotter


THICK = {"lubricant": "ISO VG 150", "speed": "9000 rpm", "load": "30 kN"}


def test_resolved_films_of_thick_oil_stay_within_what_quick_ones_are_asked_for():
    """Fast pads in thick oil: 9.7 K U sqrt(η) above one temperature, 2.8 K or 23 K above means over the radius."""
    quick, means = solved(thermal="global", **THICK), solved(thermal="adiabatic", **THICK)
    resolved = solved(thermal="adiabatic", radial_temperature="resolved", **THICK)
    assert resolved.outcome.solved
    hottest = resolved.values["maximum_temperature"]
    assert means.values["maximum_temperature"] < hottest
    for one, name, factor in (
        (quick, "trailing_temperature", HOTTER),
        (means, "maximum_temperature", HOTTER_THAN_MEANS),
    ):
        assert hottest < one.values[name] + hotter_by_shear(
            shear_heat(one.values["surface_speed"], one.values["effective_viscosity"]), factor
        )
    for one, thinner in ((quick, MOST_THINNER), (means, THINNER_THAN_MEANS)):
        assert one.values["minimum_film_thickness"] < (1.0 + thinner) * resolved.values["minimum_film_thickness"]


def test_slow_pads_of_one_temperature_pass_as_before():
    slow = solved(load="10 kN", speed="300 rpm")
    assert slow.verdict is Verdict.PASS
    assert not said(slow)


@pytest.mark.parametrize(
    ("thermal", "margin", "questioned"),
    [
        ("resolved", 9.9, True),
        ("resolved", 10.1, False),
        ("adiabatic", 37.5, True),
        ("adiabatic", 37.7, False),
        ("global", 64.9, True),
        ("global", 65.1, False),
    ],
)
def test_a_fifth_of_the_rise_is_asked_of_resolved_pads_and_what_is_hotter_of_the_others(
    thermal, margin, questioned
):
    """A rise of 50 K asks for 10 K, means for 23 + 0.2 (50 + 23) = 37.6 K, one temperature at 50 m/s and 10 mPa s
    for 48.5 + 0.2 (34 + 48.5) = 65 K."""
    own = thermal != "global"
    hottest = "maximum_temperature" if own else "trailing_temperature"
    values = {hottest: 360.0 if own else 344.0, "surface_speed": 50.0, "effective_viscosity": 0.01}
    oil = Oil(
        lubricant("ISO VG 46"), supply_temperature=310.0, own_temperatures=own, resolved=thermal == "resolved"
    )
    check = Check("C108", hottest, values[hottest], values[hottest] + margin, Bound.AT_MOST, "")
    assert bool(list(warnings_about_margins(oil, [check], values))) is questioned


def test_speed_and_load_times_speed_are_held_against_the_metal():
    """B83 allows 50 m/s and 75 MPa m/s; the collar runs with 70.7 m/s at the mean radius of 75 mm."""
    found = solved(load="40 kN", materials={"bearing_metal": "B83"})
    by_code = {check.code: check for check in found.checks}
    speed = 9000.0 * math.pi / 30.0 * 75e-3
    assert by_code["C106"].value == pytest.approx(speed, rel=1e-9)
    assert by_code["C107"].value == pytest.approx(speed * found.values["largest_specific_load"], rel=1e-9)
    assert (by_code["C106"].limit, by_code["C107"].limit) == (50.0, 75e6)
    assert (by_code["C106"].ok, by_code["C107"].ok, by_code["C105"].ok) == (False, False, True)
    assert found.verdict is Verdict.FAIL
    assert {"C105", "C106", "C107"} <= {one.code for one in solved().not_checked}
