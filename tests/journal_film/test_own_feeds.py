"""Films whose grooves, pockets and holes all have a pressure or flow of their own."""

import pytest
from film_bearings import answer

VENTED = {
    "grooves": [{"angle": "90 deg", "extent": "20 deg", "pressure": "0 Pa"}],
    "effective_temperature": "60 degC",
    "accuracy": "draft",
}
OF_THE_SUPPLY = {"supply_pressure", "element_pressure", "tube_loss", "hole_loss"}


def unused(result):
    return [one.message for one in result.warnings if one.code == "W183"]


def test_a_supply_pressure_that_acts_on_nothing_is_listed_and_stands_in_no_result():
    low, high = (
        answer(**VENTED, supply={"temperature": "45 degC", "pressure": pressure})
        for pressure in ("0.1 MPa", "0.5 MPa")
    )
    timed = {"wall_time"}
    assert {n: v for n, v in low.values.items() if n not in timed} == pytest.approx(
        {n: v for n, v in high.values.items() if n not in timed}, rel=1e-12
    )
    for found in (low, high):
        assert unused(found) == [
            "supply.pressure: every groove, pocket and hole has a pressure or flow of its own"
        ]
        assert not OF_THE_SUPPLY & found.values.keys()


def test_a_supply_pressure_that_one_groove_takes_is_read():
    grooves = [*VENTED["grooves"], {"angle": "270 deg", "extent": "10 deg"}]
    found = answer(**VENTED | {"grooves": grooves, "load_angle": "0 deg"})
    assert not unused(found)
    assert found.supply_pressure == found.element_pressure == 0.15e6
