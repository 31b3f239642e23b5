"""What the hottest place of bush or film is held against: the metal, its family, or the general limit."""

from __future__ import annotations

import pytest

from babbitt.case import CaseError, parse_case
from babbitt.core.result import Check, Result, Verdict
from babbitt.properties.materials import (
    AlloyFamily,
    bearing_metal,
    bearing_metals,
    metal_temperature_limit,
    pressure_fed_temperature_limit,
)
from babbitt.solving import solve

CASE = """
kind: journal
name: Hot
method: film
thermal: full
accuracy: draft
diameter: 100 mm
width: 80 mm
clearance: {kind: relative, mean: 1.3 permille}
pockets: [{angle: 0 deg, extent: 20 deg, width: 64 mm}, {angle: 180 deg, extent: 20 deg, width: 64 mm}]
lubricant: ISO VG 32
supply: {temperature: 50 degC, pressure: 0.15 MPa, circulation_time: 10 min}
materials: {bearing: C10, journal: C45}
walls:
  bush: {outer_diameter: 150 mm, conductivity: 46 W/(m K)}
  housing: {outer_diameter: 220 mm, heat_transfer_coefficient: 30 W/(m2 K), ambient_temperature: 20 degC}
  journal: {shaft_conductance: 5 W/K, ambient_temperature: 30 degC}
load: 40 kN
speed: 10000 rpm
"""

BY_THE_STANDARD = """
kind: journal
name: Hot
diameter: 120 mm
width: 60 mm
clearance: {kind: relative, mean: 1.4 permille}
span: 360 deg
supply_element: {kind: groove_180, width: 5 mm}
lubricant: ISO VG 32
supply: {temperature: 50 degC, pressure: 0.2 MPa}
materials: {bearing: C10, journal: C45}
load: 20 kN
speed: 3000 rpm
"""


def solved(metal: str, case: str = CASE) -> Result:
    given = f"{{bearing_metal: {metal}, bearing: C10" if metal else "{bearing: C10"
    return solve(parse_case(case.replace("{bearing: C10", given)))["Hot"]


def limits(result: Result) -> dict[str, Check]:
    return {check.code: check for check in result.checks}


@pytest.fixture(scope="module")
def tin() -> Result:
    return solved("SnSb8Cu4")


def test_a_metal_without_own_limit_is_held_against_its_family(tin: Result) -> None:
    """The outlet keeps its limit and the bush is hotter than tin alloys bear: no pass."""
    found = limits(tin)
    assert bearing_metal("SnSb8Cu4").limiting_temperature is None
    assert found["C104"].quantity == "outlet_temperature"
    assert found["C104"].ok
    assert found["C108"].quantity == "maximum_bush_temperature"
    assert found["C108"].limit == pytest.approx(388.15)
    assert "tin-based" in found["C108"].source
    assert not found["C108"].ok
    assert found["C103"].ok  # 40 kN on 80 cm² are 5 MPa, the limit, to round-off
    assert tin.verdict is Verdict.FAIL


def test_a_metal_of_ones_own_has_the_limits_of_the_case(tin: Result) -> None:
    own = limits(solved("{name: Mine, specific_load: 20 MPa, temperature: 160 degC}"))
    assert own["C108"].limit == pytest.approx(433.15)
    assert own["C105"].limit == 20e6
    assert own["C108"].value == pytest.approx(limits(tin)["C108"].value, rel=1e-12)
    assert "C103" not in own  # of no family
    of_family = limits(solved("{name: Mine, family: lead-based}"))
    assert of_family["C108"].limit == pytest.approx(373.15)
    assert of_family["C103"].limit == 5e6


def test_without_a_metal_the_general_limit_holds_and_is_named_an_assumption() -> None:
    found = limits(solved(""))["C108"]
    assert found.limit == pytest.approx(363.15)
    assert "assumption" in found.source


def test_a_limit_of_the_case_takes_the_place_of_the_general_one_and_leaves_that_of_the_metal(tin: Result) -> None:
    given = CASE + "limits: {temperature: 140 degC}\n"
    found = limits(solve(parse_case(given))["Hot"])
    assert "C108" not in found
    assert found["C104"].quantity == "maximum_bush_temperature"
    assert found["C104"].limit == pytest.approx(413.15)
    of_tin = limits(
        solve(parse_case(given.replace("{bearing: C10", "{bearing_metal: SnSb8Cu4, bearing: C10")))["Hot"]
    )
    assert of_tin["C108"].limit == limits(tin)["C108"].limit
    assert not of_tin["C108"].ok


def test_outlet_temperatures_are_not_held_against_the_general_limit_of_bushes() -> None:
    """C104 holds the outlet; a metal of which nothing is known adds nothing to that."""
    for metal in ("", "{name: Mine, specific_load: 20 MPa}"):
        found = limits(solved(metal, BY_THE_STANDARD))
        assert found["C104"].quantity == "starved_outlet_temperature"  # the groove gives less than the film wants
        assert "C108" not in found


def test_every_metal_included_has_a_limiting_temperature() -> None:
    for metal in bearing_metals():
        limit = metal_temperature_limit(metal)
        assert "assumption, as" not in limit.source, metal.name
        if metal.limiting_temperature is not None:
            assert limit == metal.limiting_temperature


def test_no_family_is_granted_more_than_the_hottest_oil_of_any_bearing() -> None:
    """Makers grant tin bronze 260 degC, at which no mineral oil lubricates."""
    hottest_oil = pressure_fed_temperature_limit(600.0).exceptional
    for metal in bearing_metals():
        if metal.limiting_temperature is None:
            assert metal_temperature_limit(metal).value <= hottest_oil, metal.name


@pytest.mark.parametrize("name", ["B83", "B88", "SnSb8Cu4", "SnSb12Cu6Pb"])
def test_tin_alloys_are_tin_based(name: str) -> None:
    assert bearing_metal(name).family is AlloyFamily.TIN
    assert bearing_metal("PbSb15Sn10").family is AlloyFamily.LEAD


def test_an_unknown_name_without_limits_is_refused() -> None:
    with pytest.raises(CaseError, match=r"bearing_metal.*nearest: SnSb8Cu4"):
        parse_case(CASE.replace("{bearing: C10", "{bearing_metal: SnSb8Cu5, bearing: C10"))
