"""What films say about supplies that give little oil, and the limits of what gets hot then."""

import pytest

from babbitt import parse_case
from babbitt.case import CaseError
from babbitt.design.checks import hottest_place
from babbitt.solving import solve

HOLE = """
kind: journal
name: A
method: {kind: film, thermal: THERMAL, accuracy: draft}
diameter: 120 mm
width: 100 mm
clearance: {kind: relative, mean: 1.4 permille}
span: 360 deg
supply_element: {kind: hole, diameter: 4 mm, place: side}
load: 8 kN
speed: 1500 rpm
materials: {bearing_metal: B83, bearing: C10, journal: 42CrMo4}
lubricant: ISO VG 46
supply: {temperature: 50 degC, pressure: 0.2 MPa}
"""


def solved(text):
    (found,) = solve(parse_case(text)).results
    return found


@pytest.mark.parametrize("thermal", ["global", "adiabatic", "full"])
def test_a_hole_without_pressure_is_told(thermal):
    """It passed cleanly: nothing but the journal draws the oil."""
    text = HOLE.replace("THERMAL", thermal).replace("8 kN", "3 kN").replace("1500", "500")
    pressed, drawn = solved(text), solved(text.replace("0.2 MPa", "0 MPa"))
    assert drawn.total_flow < pressed.total_flow
    assert "W124" not in {one.code for one in pressed.warnings}
    assert [one.variant for one in drawn.warnings if one.code == "W124"] == ["no_pressure_left"]


def test_oil_that_leaves_hotter_than_insulated_walls_is_held_to_the_limit_of_the_metal():
    """The wall has 77 degC, the oil at the sides 83; a bush that conducts is its own measure."""
    result = solved(HOLE.replace("THERMAL", "adiabatic"))
    assert result.outlet_temperature > result.maximum_wall_temperature + 3.0
    (metal,) = [one for one in result.checks if one.code == "C108"]
    assert (metal.quantity, metal.value) == ("outlet_temperature", result.outlet_temperature)
    conducting = {"maximum_bush_temperature": 350.0, "outlet_temperature": 360.0}
    assert hottest_place(conducting) == "maximum_bush_temperature"


def test_two_pockets_alike_are_told_once():
    wide = HOLE.replace("THERMAL", "global").replace("360", "180")
    wide = wide.replace("{kind: hole, diameter: 4 mm, place: side}", "{kind: pocket, width: 99 mm, place: SIDES}")
    wide = wide.replace("SIDES", "both_sides")
    codes = [one.code for one in solved(wide).warnings]
    assert codes.count("W121") == 1


@pytest.mark.parametrize("thermal", ["adiabatic", "full"])
def test_a_refused_factor_on_friction_points_to_the_comparison(thermal):
    with pytest.raises(CaseError, match="1, or thermal: global, of which `babbitt compare` solves this film"):
        parse_case(HOLE.replace("THERMAL", thermal) + "friction: {factor: 1.25}\n")
