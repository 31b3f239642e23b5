"""Doubts about films that are solved and should not be believed."""

import math

import pytest
from design_cases import CASE_A
from film_bearings import GROOVES, answer, solved

from babbitt.design.warnings import warnings_about_heat_balance, warnings_about_running
from babbitt.kinds.journal.iso7902.procedure import check

QUICK = {"accuracy": "draft", "effective_temperature": "60 degC"}


def said(result):
    return {notice.code: notice.message for notice in result.warnings}


def test_a_pressure_that_no_bearing_metal_bears_is_doubted_and_fails():
    calm, absurd = answer(**QUICK), answer(**QUICK, load="8 MN")
    assert calm.maximum_pressure < 100e6 < absurd.maximum_pressure
    assert "W142" not in said(calm)
    assert "> 100.0 MPa" in said(absurd)["W142"]
    verdicts = [{check.code: check.ok for check in result.checks}["C116"] for result in (calm, absurd)]
    assert verdicts == [True, False]
    metal = {"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "C45"}
    judged = answer(**QUICK, load="8 MN", materials=metal)
    assert "C116" not in {check.code for check in judged.checks}  # the metal has limits of its own
    assert "SnSb8Cu4" in {one.code: one.message for one in judged.not_checked}["C116"]
    assert "C116" not in {one.code for one in calm.not_checked}
    assert "W142" in said(judged)


@pytest.mark.parametrize(("angle", "told"), [(-90.0, False), (8.0, True), (12.0, False), (-172.0, True)])
def test_a_load_into_a_groove_is_told(angle, told):
    result = answer(**QUICK, load="5 kN", load_angle=f"{angle} deg")
    assert ("W143" in said(result)) is told


@pytest.mark.parametrize(("angle", "told"), [(-90.0, True), (-72.0, False)])
def test_a_load_into_a_pocket_is_told(angle, told):
    pocket = {"angle": "-85 deg", "extent": "20 deg", "width": "40 mm"}
    warnings = said(answer(**QUICK, pockets=[pocket], load="5 kN", load_angle=f"{angle} deg"))
    assert ("W143" in warnings) is told
    if told:
        assert warnings["W143"].endswith("the pocket or hole, 40.00 mm wide, reaches from -95.0° to -75.0°")


@pytest.mark.parametrize(("width", "doubted"), [("119.9 mm", True), ("110 mm", False)])
def test_a_pocket_that_leaves_hardly_a_land_leaks_what_nobody_knows(width, doubted):
    """Pockets of 99.9 % of the width let 372 L/min pass and kept a limit that those of 98 % missed."""
    pocket = {"angle": "180 deg", "extent": "20 deg", "width": width}
    warnings = said(answer(**QUICK, grooves=None, pockets=[pocket], load="5 kN"))
    assert ("a land of" in warnings.get("W121", "")) is doubted


def test_a_supply_flow_from_the_side_is_not_called_a_flow_from_the_grooves():
    pressed = answer(
        **QUICK, grooves=GROOVES, supply={"temperature": "45 degC", "pressure": "0.1 MPa"},
        side_pressures=["0.5 MPa", "0 MPa"],
    )  # fmt: skip
    assert pressed.supply_flow < 0.0
    assert "less leave by the sides, as oil flows from a side into them" in said(pressed)["W121"]
    assert "supply flow of" in said(answer(**QUICK))["W121"]


@pytest.mark.parametrize(
    ("given", "missed", "cold"), [("20 degC", False, True), ("60 degC", False, False), ("120 degC", True, False)]
)
def test_a_prescribed_temperature_tells_no_heat(given, missed, cold):
    """The oil of a film at 120 °C, fed at 45 °C, does not leave at 195 °C: its friction would never warm it so."""
    result = answer(accuracy="draft", effective_temperature=given, load="5 kN")
    assert result.friction_power > 0.0
    assert not {"outlet_temperature", "heat_to_oil", "heat_to_surroundings", "energy_balance_error"} & set(
        result.values
    )
    limits = [check for check in result.checks if check.code == "C104"]
    unmade = {notice.code: notice.message for notice in result.not_checked}
    if missed:
        assert [(one.quantity, one.ok) for one in limits] == [("effective_temperature", False)]
    else:
        assert limits == []
        assert "no heat balance" in unmade["C104"]
    assert ("W149" in said(result)) is cold
    if cold:
        assert "20.0 °C < supply temperature of 45.0 °C" in said(result)["W149"]


def test_a_given_film_colder_than_oil_that_is_too_hot_misses_the_limit_by_the_supply():
    hot = answer(
        accuracy="draft",
        effective_temperature="60 degC",
        supply={"temperature": "110 degC", "pressure": "0.1 MPa"},
    )
    (check,) = (one for one in hot.checks if one.code == "C104")
    assert (check.quantity, check.ok) == ("supply_temperature", False)


@pytest.mark.parametrize(("error", "code"), [(-2e-3, "W325"), (math.nan, "W325"), (-1e-5, "W146"), (1e-9, None)])
def test_heat_that_is_not_accounted_for_is_told(error, code):
    """A turbulent film whose friction jumps from one temperature to the next balances to a thousandth at best."""
    told = [notice.code for notice in warnings_about_heat_balance(error)]
    assert told == ([] if code is None else [code])
    values = {**check(CASE_A).values, "energy_balance_error": error}
    running = {notice.code for notice in warnings_about_running(CASE_A, values, ())}
    assert running & {"W146", "W325"} == set(told)


def test_a_film_that_bears_every_rotor_says_why_it_has_no_critical_mass():
    pockets = [{"angle": f"{angle} deg", "extent": "20 deg", "width": "40 mm"} for angle in (0, 180)]
    steady = answer(
        grooves=None,
        pockets=pockets,
        load_angle="-60 deg",
        diameter="120 mm",
        width="80 mm",
        clearance={"kind": "relative", "mean": "1.3 permille"},
        supply={"temperature": "45 degC", "pressure": "0.2 MPa"},
        load="12 kN",
        speed="2000 rpm",
    )
    assert ("critical_mass" in steady.values) != ("critical_mass" in steady.missing)
    assert any(one.code == "C115" for one in (*steady.checks, *steady.not_checked))
    assert steady.stable_at_any_mass == 1.0
    assert "any mass" in steady.missing["critical_mass"]


def test_a_film_without_oil_is_told_to_be_fed():
    (dry,) = solved(
        grooves=None,
        span="360 deg",
        supply_element={"kind": "groove_360", "width": "8 mm"},
        supply={"temperature": "45 degC", "pressure": "0 MPa"},
    ).results
    assert not dry.outcome.solved
    assert "no pressure presses oil into the film. Try: a supply pressure" in dry.message


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({}, False),
        ({"side_pressures": ["0.5 MPa", "0 MPa"]}, True),
        ({"cavitation_pressure": "-0.5 bar"}, True),
    ],
)
def test_oil_that_the_sides_draw_in_is_told(given, told):
    """A side under pressure lets oil in, and so does a rupture that lies below the pressure around the bearing."""
    result = answer(**QUICK, **given)
    assert ("W141" in said(result)) is told
    if told:
        assert result.side_inflow > 0.02 * result.side_flow
        (drawn,) = [one.values for one in result.warnings if one.code == "W141"]
        assert drawn == {"side_inflow": result.side_inflow}
    else:
        assert result.side_inflow < 1e-9 * result.side_flow
