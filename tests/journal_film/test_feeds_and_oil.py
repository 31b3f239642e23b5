"""What feeds do to friction, and oil that comes from nowhere."""

import math

import film_bearings
import pytest

from babbitt import parse_case
from babbitt.solving import solve

BASE = """
kind: journal
method: film
name: feeds
diameter: 100 mm
width: 60 mm
clearance: {kind: relative, mean: 1.5 permille}
materials: {bearing: {thermal_expansion: 11e-6 1/K}, journal: {thermal_expansion: 11e-6 1/K}}
lubricant: ISO VG 46
supply: {temperature: 50 degC, pressure: 0.02 MPa}
effective_temperature: 55 degC
speed: 1500 rpm
"""


def solved(extra: str):
    return solve(parse_case(BASE + extra)).results[0]


def test_oil_in_a_pocket_is_not_sheared():
    # pockets almost as wide as the bearing rub as little as grooves as wide as the bearing
    places = ("0 deg", "180 deg")
    grooves = "".join(f"  - {{angle: {at}, extent: 40 deg}}\n" for at in places)
    pockets = "".join(f"  - {{angle: {at}, extent: 40 deg, width: 59.9 mm}}\n" for at in places)
    grooved = solved("load: 600 N\ngrooves:\n" + grooves).values
    pocketed = solved("load: 600 N\npockets:\n" + pockets).values
    assert pocketed["friction_torque"] == pytest.approx(grooved["friction_torque"], rel=0.01)


def test_a_circumferential_groove_rubs_no_more_than_its_two_lands():
    whole = solved("load: 600 N\npockets:\n  - {angle: 90 deg, extent: 360 deg, width: 30 mm}\n").values
    eta, omega, eps = whole["effective_viscosity"], whole["angular_speed"], whole["eccentricity_ratio"]
    clearance = whole["operating_relative_clearance"] * 0.05
    shear = 2.0 * math.pi * eta * omega * 0.05**3 * 0.030 / clearance / math.sqrt(1.0 - eps**2)
    pressure = 0.5 * eps * clearance * 600.0 * math.sin(whole["attitude_angle"])
    # the film of both lands all around at this position is the most there can be; half of it stays unbroken
    assert 0.5 * shear < whole["friction_torque"] <= shear + pressure


def test_a_film_that_reforms_without_oil_is_doubted():
    extra = "load: 12 kN\ncavitation: {}\nholes:\n  - {{angle: 90 deg, diameter: 8 mm}}\n"
    reynolds, conserving = solved(extra.format("reynolds")), solved(extra.format("mass_conserving"))
    assert reynolds.values["mass_balance_error"] > 0.05
    assert "W122" in {notice.code for notice in reynolds.warnings}
    assert conserving.values["mass_balance_error"] < 1e-9
    assert "W122" not in {notice.code for notice in conserving.warnings}


def test_a_load_points_beside_no_groove_that_surrounds_the_journal():
    pockets = "load: 600 N\npockets:\n  - {angle: 90 deg, extent: 30 deg, width: 10 mm}\n"
    around = solved(pockets.replace("30 deg", "360 deg"))
    below = solved(pockets + "  - {angle: -90 deg, extent: 30 deg, width: 10 mm}\n")
    assert around.outcome.solved
    assert "W143" not in [warning.code for warning in around.warnings]
    assert "W143" in [warning.code for warning in below.warnings]


def test_oil_of_a_pocket_with_its_own_pressure_passes_no_tube_of_the_system():
    fed = "{temperature: 50 degC, pressure: 0.1 MPa, tubes: [{diameter: 6 mm, length: 2 m}]}"
    base = BASE.replace("{temperature: 50 degC, pressure: 0.02 MPa}", fed)
    both = "pockets:\n  - {angle: 90 deg, extent: 40 deg, width: 40 mm}\n"
    both += "  - {angle: -90 deg, extent: 30 deg, width: 40 mm, pressure: 3 MPa}\n"
    found = solve(parse_case(base + "load: 5 kN\n" + both)).results[0].values
    # the narrow tube would lose more than 0.1 MPa to the whole flow; the upper pocket draws next to nothing
    assert found["total_flow"] > 2.0 / 6e4
    assert found["tube_loss"] < 2e4
    assert found["element_pressure"] == pytest.approx(1e5 - found["tube_loss"])


ALL_AROUND = {
    "diameter": "100 mm", "width": "60 mm", "clearance": {"kind": "relative", "mean": "1.2 permille"},
    "span": "360 deg", "grooves": None, "supply_element": {"kind": "groove_360", "width": "6 mm"},
    "effective_temperature": "60 degC", "load": "10 kN",
}  # fmt: skip


def fed_through(diameter):
    """A groove around the bore behind a tube; None: no tube."""
    tubes = {} if diameter is None else {"tubes": [{"diameter": diameter, "length": "2 m"}]}
    return film_bearings.answer(**ALL_AROUND, supply={"temperature": "50 degC", "pressure": "0.1 MPa"} | tubes)


def test_a_groove_around_the_bore_behind_a_narrow_tube_gets_what_the_tube_passes():
    """Without pressure it sends no oil off, so that the pressure behind the tube rises until some does."""
    wide, middle, narrow = (fed_through(diameter) for diameter in (None, "6 mm", "2 mm"))
    assert narrow.supply_flow < middle.supply_flow < wide.supply_flow
    assert narrow.minimum_film_thickness < middle.minimum_film_thickness < wide.minimum_film_thickness
    for one in (middle, narrow):
        assert one.element_pressure + one.tube_loss == pytest.approx(0.1e6, rel=1e-6)
        assert one.element_pressure > 0.0
    viscous = 128.0 * 2.0 * narrow.supply_flow / (math.pi * 2e-3**4)  # over the viscosity: Hagen and Poiseuille
    assert 0.01 < narrow.tube_loss / viscous < 0.1  # Pa s of ISO VG 46 at 50 °C, with the ends of the tube


@pytest.mark.parametrize("thermal", ["adiabatic", "full"])
def test_films_with_temperatures_of_their_own_know_a_groove_around_the_bore_behind_a_tube(thermal):
    """Without pressure the groove divides no lands: a film of other nodes, from which none goes on."""
    warm = ALL_AROUND | {"effective_temperature": None, "thermal": thermal, "accuracy": "draft"}
    tube = {"tubes": [{"diameter": "6 mm", "length": "2 m"}]}
    bare, fed = (
        film_bearings.answer(**warm, supply={"temperature": "50 degC", "pressure": "0.1 MPa"} | extra)
        for extra in ({}, tube)
    )
    assert fed.element_pressure + fed.tube_loss == pytest.approx(0.1e6, rel=1e-5)
    assert 0.0 < fed.total_flow < bare.total_flow
    assert fed.outlet_temperature > bare.outlet_temperature
    assert abs(fed.energy_balance_error) < 1e-6


@pytest.mark.parametrize(
    ("supply", "words"),
    [
        ({"pressure": "0 MPa"}, "Try: a supply pressure"),
        ({"flow": "0.3 L/min"}, "Give the supply a pressure in place of the flow"),
    ],
)
def test_a_groove_around_the_bore_without_pressure_says_what_is_missing(supply, words):
    (result,) = film_bearings.solved(**ALL_AROUND, supply={"temperature": "50 degC"} | supply).results
    assert result.verdict.value == "no solution"
    assert words in result.message
