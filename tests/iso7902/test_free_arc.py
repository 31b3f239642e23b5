"""Pockets and grooves that leave less arc about the load than the span says."""

import pytest

from babbitt import parse_case
from babbitt.case import CaseError
from babbitt.core.result import Verdict
from babbitt.kinds.journal.iso7902.characteristics import curves
from babbitt.solving import solve

CASE = """
kind: journal
name: A
diameter: 100 mm
width: 80 mm
clearance: {kind: relative, mean: 1.3 permille}
span: SPAN deg
supply_element: {kind: pocket, width: 56 mm, ELEMENT}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.3 MPa}
materials: {bearing_metal: CuSn8P, bearing: C10, journal: C45}
load: 20 kN
speed: 1500 rpm
"""


def solved(element, span=360, more=""):
    return solve(parse_case(CASE.replace("SPAN", str(span)).replace("ELEMENT", element) + more))["A"]


def said(result, code):
    return [one.message for one in result.warnings if one.code == code]


def test_a_span_wider_than_pockets_leave_is_questioned_with_the_film_of_the_arc():
    found = solved("place: both_sides, extent: 60 deg")
    (message,) = said(found, "W189")
    clearance = found.operating_relative_clearance * 0.05
    thin = clearance * (1.0 - curves(120, 0.8).eccentricity_ratio(found.sommerfeld_number))
    assert f"on 120.0°: h_min {thin * 1e6:.1f} µm" in message
    assert found.verdict is not Verdict.PASS
    assert not said(solved("place: both_sides, extent: 60 deg", 120), "W189")


@pytest.mark.parametrize(
    ("element", "arc"),
    [
        ("place: both_sides, extent: 120 deg", 60), ("place: both_sides, extent: 150 deg", 30),
        ("place: side, extent: 170 deg", 10),
    ],
)  # fmt: skip
def test_pockets_that_leave_less_than_any_tabulated_arc_are_never_passed(element, arc):
    """The film of one temperature has 2.6 µm between pockets of 180 deg where 23.2 µm were passed."""
    found = solved(element)
    (message,) = said(found, "W105")
    assert f"an arc of {arc}.0°" in message
    assert not found.within_limits


def test_pockets_that_meet_under_the_load_are_refused():
    with pytest.raises(CaseError, match="leave no arc to carry it"):
        solved("place: both_sides, extent: 180 deg")
    solved("place: side, extent: 180 deg")


@pytest.mark.parametrize(
    "element", ["place: both_sides", "place: side, extent: 30 deg", "place: opposite, extent: 90 deg"]
)
def test_short_pockets_of_a_full_bearing_are_not_doubted(element):
    """Between 160 deg and 360 deg the film differs by less than 5 %."""
    assert not {"W105", "W189"} & {one.code for one in solved(element).warnings}


def test_pockets_of_unknown_extent_begin_where_the_arc_ends():
    assert not said(solved("place: both_sides", 90), "W189")
    assert said(solved("place: both_sides, extent: 90 deg", 150), "W189")


POCKETS = (
    "pockets: [{angle: 0 deg, extent: 20 deg, width: 50 mm}, {angle: 180 deg, extent: 20 deg, width: 50 mm}]\n"
)


@pytest.mark.parametrize(
    ("load_angle", "sense", "doubted", "arc"),
    [
        (-90, 1, False, None), (-30, 1, True, 40), (-40, 1, True, 60), (-140, 1, True, 60), (-30, -1, True, 40),
        (-75, 1, False, None),
    ],
)  # fmt: skip
def test_a_load_beside_a_pocket_of_the_case_is_questioned(load_angle, sense, doubted, arc):
    """The case holds the true places of its pockets; with the load 20 deg from one of them it passed cleanly."""
    more = f"{POCKETS}load_angle: {load_angle} deg\n"
    text = CASE.replace("SPAN", "150").replace("ELEMENT", "place: both_sides") + more
    found = solve(parse_case(text.replace("1500 rpm", f"{sense * 1500} rpm")))["A"]
    messages = said(found, "W189")
    assert bool(messages) is doubted
    if doubted:
        assert f"an arc of {arc}.0°" in messages[0]
        assert found.verdict is not Verdict.PASS


def test_a_groove_behind_the_load_ends_the_film_up_to_60_degrees():
    """The rule of uneven pockets: the pressure has ended there."""

    def doubts(behind):
        angle = -90.0 + behind
        return said(solved("place: opposite", 150, f"grooves: [{{angle: {angle} deg, extent: 0 deg}}]\n"), "W189")

    assert doubts(40.0)
    assert not doubts(61.0)
    assert doubts(-60.0)
