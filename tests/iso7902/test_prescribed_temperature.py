"""The design check at a temperature that is given instead of found."""

from dataclasses import replace

import pytest
from design_cases import CASE_A, CASE_C

from babbitt.core.result import Outcome
from babbitt.design.conditions import HousingCooling
from babbitt.kinds.journal.iso7902.model import PrescribedLoad
from babbitt.kinds.journal.iso7902.procedure import check, check_at_temperature
from babbitt.kinds.journal.iso7902.supply import Arrangement, Holes

WELL_FED = replace(CASE_A, bearing=replace(CASE_A.bearing, supply_element=Holes(0.04, Arrangement.BOTH_SIDES)))

BALANCE = {"outlet_temperature", "heat_to_oil", "heat_to_surroundings", "energy_balance_error"}
"""What only a heat balance tells."""


@pytest.mark.parametrize("case", [WELL_FED, CASE_C], ids=["A", "C"])
def test_at_the_temperature_of_equilibrium_the_film_is_the_same(case):
    found = check(case)
    given = check_at_temperature(case, found.values["effective_temperature"])
    left_out = {name for name in found.values if name in BALANCE or name.startswith("starved_")}
    assert set(found.values) - set(given.values) == left_out
    for name, value in given.values.items():
        if name not in ("iterations", "wall_time"):
            assert found.values[name] == pytest.approx(value, rel=1e-12), name
    assert given.outcome is Outcome.CONVERGED
    assert given.values["iterations"] == 1.0


def test_a_prescribed_temperature_tells_no_heat_and_keeps_no_limit_of_temperature():
    found = check(WELL_FED)
    given = check_at_temperature(WELL_FED, found.values["effective_temperature"])
    left_out = {one.code for one in found.checks} - {one.code for one in given.checks}
    assert "C104" in left_out
    assert left_out <= {"C104", "C108", "C109"}
    reasons = {one.code: one.message for one in given.not_checked}
    assert all("prescribed" in reasons[code] for code in left_out)
    assert given.checks == tuple(one for one in found.checks if one.code not in left_out)


def test_a_film_prescribed_hotter_than_the_limit_misses_it():
    hot = check_at_temperature(CASE_A, 273.15 + 130.0)
    missed = next(one for one in hot.checks if one.code == "C104")
    assert (missed.quantity, missed.value, missed.ok) == ("effective_temperature", 403.15, False)
    assert "C104" not in {one.code for one in hot.not_checked}


def test_a_film_of_a_cool_housing_prescribed_too_hot_does_not_ask_for_pressure_feed():
    """That a housing cannot cool its bearing follows from the heat balance alone."""
    cooled = replace(CASE_A, oil_supply=None, cooling=HousingCooling(293.15, 20.0, 0.3))
    hot = check_at_temperature(cooled, 273.15 + 130.0)
    assert hot.values["bearing_temperature"] == 403.15
    assert any(one.code == "C104" and not one.ok for one in hot.checks)
    assert "W110" not in {one.code for one in hot.warnings}


@pytest.mark.parametrize(("kelvin", "told"), [(-10.0, True), (0.0, False), (10.0, False)])
def test_a_film_prescribed_colder_than_its_oil_is_told(kelvin, told):
    entering = CASE_A.oil_supply.temperature
    warnings = {one.code: one.message for one in check_at_temperature(CASE_A, entering + kelvin).warnings}
    assert ("W149" in warnings) is told
    assert "W118" not in warnings  # no oil that leaves is known
    if told:
        given, supplied = (f"{one - 273.15:.1f} °C" for one in (entering + kelvin, entering))
        assert given in warnings["W149"]
        assert supplied in warnings["W149"]


def test_a_film_prescribed_colder_than_its_oil_keeps_no_limit_of_its_thickness():
    colder = check_at_temperature(CASE_A, CASE_A.oil_supply.temperature - 5.0)
    warmer = check_at_temperature(CASE_A, CASE_A.oil_supply.temperature + 5.0)
    assert {one.code: one.ok for one in warmer.checks}["C101"]
    assert "C101" not in {one.code for one in colder.checks}
    assert "cooler than its fresh oil" in {one.code: one.message for one in colder.not_checked}["C101"]


def test_that_the_balance_is_left_open_is_told():
    equilibrium = check(CASE_A).values["effective_temperature"]
    colder = check_at_temperature(CASE_A, equilibrium - 5.0)
    warmer = check_at_temperature(CASE_A, equilibrium + 5.0)
    assert any("57.1 °C" in text and "not closed" in text for text in colder.assumptions)
    assert colder.values["minimum_film_thickness"] > warmer.values["minimum_film_thickness"]


def test_what_cannot_run_ends_with_a_status():
    overloaded = check_at_temperature(replace(CASE_A, duty=PrescribedLoad(36e6)), 330.0)
    assert overloaded.outcome is Outcome.OVERLOADED
    assert "56.9 °C" in overloaded.message
    tight = replace(CASE_A.bearing, relative_clearance=1e-4, expansion_bearing=1e-6, expansion_journal=30e-6)
    assert check_at_temperature(replace(CASE_A, bearing=tight), 330.0).outcome is Outcome.NO_CLEARANCE
