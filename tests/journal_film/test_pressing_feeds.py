"""Films of one temperature whose feeds press the journal into the loaded film."""

import math

import pytest

from babbitt import parse_case
from babbitt.core.result import Verdict
from babbitt.kinds.journal.feed_pressure import pressed_area
from babbitt.kinds.journal.iso7902.supply import Arrangement, HalfCircumferentialGroove, Pockets
from babbitt.solving import solve

PRESSED = """
kind: journal
name: A
method: film
accuracy: draft
diameter: 120 mm
width: 80 mm
clearance: {kind: relative, mean: 1.3 permille}
span: 360 deg
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: PRESSURE}
supply_element: {kind: pocket, width: 50 mm, place: opposite}
materials: {bearing_metal: B83, bearing: C10, journal: 42CrMo4}
surfaces: {kind: direct, roughness_bearing: 2 um, roughness_journal: 1 um}
load: 15 kN
speed: 2500 rpm
"""


def said(text):
    result = solve(parse_case(text))["A"]
    return result, [one.message for one in result.warnings if one.code == "W192"]


def test_a_pocket_that_presses_with_more_than_the_load_is_questioned():
    """17.6 µm passed cleanly under 20 MPa (limit 9); with its own temperatures the film has 5.7 µm."""
    found, (message,) = said(PRESSED.replace("PRESSURE", "20 MPa"))
    force = 20e6 * 0.05 * 0.12 * math.sin(math.radians(10.0))
    assert f"with {force / 15e3:.3f}" in message
    assert "warms the oil of Q_p by 12" in message
    assert found.verdict is Verdict.REMARKS


@pytest.mark.parametrize(("pressure", "questioned"), [("1 MPa", False), ("1.5 MPa", True)])
def test_what_is_questioned_is_a_tenth_of_the_load(pressure, questioned):
    """The pocket of 10.4 cm² presses with 1.04 kN and 1.56 kN, and the load is 15 kN."""
    messages = said(PRESSED.replace("PRESSURE", pressure))[1]
    assert bool(messages) is questioned
    assert not any("warms" in one for one in messages)


def test_pockets_at_both_sides_press_on_each_other_and_a_prescribed_temperature_is_no_balance():
    sides = PRESSED.replace("opposite", "both_sides")
    assert not said(sides.replace("PRESSURE", "1.5 MPa"))[1]
    (message,) = said(sides.replace("PRESSURE", "2 MPa"))[1]  # 2 MPa over ρ c are 1.2 K
    assert "warms the oil of Q_p by 1.2 K" in message
    assert "press the journal" not in message
    assert not said(PRESSED.replace("PRESSURE", "5 MPa") + "effective_temperature: 50 degC\n")[1]


def test_one_area_of_pockets_and_half_grooves():
    assert pressed_area(0.1, 0.02, 2.0 * math.pi) == pytest.approx(0.0, abs=1e-12)
    half = HalfCircumferentialGroove(0.02).pressed_area(0.1)
    assert half == pytest.approx(Pockets(0.02, Arrangement.OPPOSITE, extent=math.pi).pressed_area(0.1))
    assert half == pytest.approx(2e-3)


@pytest.mark.parametrize(("direction", "returned"), [("-90 deg", False), ("-60 deg", False), ("-25 deg", True)])
def test_oil_that_the_loaded_film_presses_back_into_a_pocket_is_questioned(direction, returned):
    """A pocket at the narrowest gap: 6.9 µm of 4 passed cleanly; with its own temperatures the film has 3.6 µm."""
    pockets = (
        "pockets: [{angle: 0 deg, extent: 30 deg, width: 42 mm}, {angle: 180 deg, extent: 30 deg, width: 42 mm}]"
    )
    text = PRESSED.replace(
        "span: 360 deg\n", f"load_angle: {direction}\nlimits: {{minimum_film_thickness: 4 um}}\n"
    )
    text = text.replace("supply_element: {kind: pocket, width: 50 mm, place: opposite}", pockets)
    text = text.replace("PRESSURE", "0.2 MPa").replace("width: 80 mm", "width: 60 mm").replace("15 kN", "12 kN")
    found = solve(parse_case(text))["A"]
    assert ("W148" in {one.code for one in found.warnings}) is returned
    assert found.verdict is (Verdict.REMARKS if returned else Verdict.PASS)


def test_much_oil_pressed_through_the_unloaded_gap_hides_none_that_is_pressed_back():
    """At 0.6 MPa 4.1 % of all that leaves: 7.5 µm of 4 passed cleanly; with its own temperatures it has 1.9."""
    pockets = (
        "pockets: [{angle: 0 deg, extent: 30 deg, width: 54 mm}, {angle: 180 deg, extent: 30 deg, width: 54 mm}]"
    )
    text = PRESSED.replace("span: 360 deg\n", "load_angle: -30 deg\nlimits: {minimum_film_thickness: 4 um}\n")
    text = text.replace("supply_element: {kind: pocket, width: 50 mm, place: opposite}", pockets)
    text = text.replace("PRESSURE", "0.6 MPa").replace("width: 80 mm", "width: 60 mm").replace("15 kN", "12 kN")
    for method in ("film", "{kind: film, thermal: full, accuracy: draft}"):
        own = text.replace("accuracy: draft\n", "") if "thermal" in method else text
        found = solve(parse_case(own.replace("method: film", f"method: {method}")))["A"]
        assert "W148" in {one.code for one in found.warnings}
        assert found.verdict is not Verdict.PASS
