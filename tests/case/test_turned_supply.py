"""Operating points whose loads differ in direction, with a supply element that is counted from the load."""

import pytest

from babbitt import parse_case
from babbitt.core.notices import Effect
from babbitt.kinds.journal.case.build import design_cases_of

BEARING = """
kind: journal
name: A
method: METHOD
diameter: 160 mm
width: 110 mm
clearance: {kind: relative, mean: 1.4 permille}
span: 180 deg
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.2 MPa}
materials: {bearing_metal: B83, bearing: C10, journal: C45}
supply_element: ELEMENT
load: 50 kN
speed: 2500 rpm
operating_points: [{name: down}, {name: up, POINT}]
"""
POCKET = "{kind: pocket, width: 76 mm, place: PLACE}"
UP = "load_angle: 90 deg"


def questioned(method, element, point, span=180):
    text = (
        BEARING.replace("180 deg", f"{span} deg")
        .replace("METHOD", method)
        .replace("ELEMENT", element)
        .replace("POINT", point)
    )
    case = parse_case(text)
    cases = design_cases_of(case, case)
    found = [[one for one in each.warnings if one.code == "W199"] for each in cases]
    assert [len(each) for each in found] in ([0, 0], [1, 1])  # which of both has the true place is not known
    assert all(one.effect is Effect.QUESTIONS_RESULT for each in found for one in each)
    return found[0][0].message if found[0] else ""


@pytest.mark.parametrize("method", ["film", "iso7902"])
def test_a_half_groove_does_not_follow_the_load(method):
    """Passed cleanly at both points with 35 µm; the film of the groove that stays has 142.7 degC at the second."""
    message = questioned(method, "{kind: groove_180, width: 12 mm}", UP)
    assert (
        "at 90° in the bore with the load of 'down' at -90.0°, and at 270° with that of 'up' at 90.0°" in message
    )


@pytest.mark.parametrize(("place", "angle", "turned"), [
    ("opposite", "-90 deg", False), ("opposite", "-80 deg", True), ("side", "90 deg", True),
    ("both_sides", "-80 deg", True), ("both_sides", "270 deg", False),
])  # fmt: skip
def test_pockets_are_asked_where_they_stand(place, angle, turned):
    element = POCKET.replace("PLACE", place)
    for method in ("film", "iso7902"):
        assert bool(questioned(method, element, f"load_angle: {angle}")) is turned


def test_symmetric_places_stay_where_the_load_turns_by_half_a_turn():
    """At an angle of 90 deg to the load each pocket stands where the other stood."""
    element = POCKET.replace("PLACE", "both_sides")
    assert not questioned("film", element, UP, 360)
    assert not questioned("film", "{kind: groove_360, width: 12 mm}", UP)


def test_a_pocket_before_the_load_moves_with_the_sense_of_rotation():
    assert questioned("film", POCKET.replace("PLACE", "side"), "speed: -2500 rpm")
    assert not questioned("film", POCKET.replace("PLACE", "opposite"), "speed: -2500 rpm")


def test_feeds_at_their_angles_stay():
    text = BEARING.replace("METHOD", "film").replace(
        "supply_element: ELEMENT", "grooves: [{angle: 0 deg, extent: 20 deg}]"
    )
    case = parse_case(text.replace("POINT", UP))
    assert not [one for each in design_cases_of(case, case) for one in each.warnings if one.code == "W199"]
