"""What a machine needs: sums where they mean something, and none where they do not."""

from __future__ import annotations

from dataclasses import replace

import gear_cases
import pytest

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result_name import ResultName
from babbitt.kinds.journal.iso7902 import check
from babbitt.kinds.journal.iso7902.model import PrescribedLoad
from babbitt.report.machine_table import columns_of, counted_parts
from babbitt.report.totals import totals

CASES = gear_cases.varied_cases()
TWO = (check(CASES["full"]), check(CASES["surfaces"]))


def test_the_sums_are_those_of_the_bearings():
    """Of the films that the limits are held against: both get less oil than they want."""
    found = totals(TWO)
    power, flow = (sum(one.values[f"starved_{name}"] for one in TWO) for name in ("friction_power", "total_flow"))
    assert power < sum(one.friction_power for one in TWO)
    assert found.values["friction_power"] == pytest.approx(power, rel=1e-12)
    assert found.values["total_flow"] == pytest.approx(flow, rel=1e-12)
    assert found.values["pump_flow"] == pytest.approx(sum(one.total_flow for one in TWO), rel=1e-12)
    assert found.values["pump_flow"] > flow  # what would end the lack
    assert found.values["heat_to_oil"] == pytest.approx(found.values["friction_power"], rel=1e-7)
    assert "heat_to_surroundings" not in found.values


def test_oil_that_stays_in_its_housing_does_not_size_the_pump():
    cooled = check(CASES["self-cooled"])
    assert cooled.outcome.solved
    assert cooled.side_flow > 0.0
    found = totals((*TWO, replace(cooled, name="self-cooled")))
    assert found.values["total_flow"] == pytest.approx(totals(TWO).values["total_flow"], rel=1e-12)
    assert found.values["heat_to_surroundings"] == pytest.approx(cooled.friction_power, rel=1e-6)
    carried = found.values["heat_to_oil"] + found.values["heat_to_surroundings"]
    assert carried == pytest.approx(found.values["friction_power"], rel=1e-7)


@pytest.mark.parametrize("of", [("half load",), ("", "maximum"), ("half load", "mean")])
def test_a_bearing_that_appears_twice_has_no_sum(of):
    again = replace(TWO[0], name=ResultName(TWO[0].name, *of))
    assert totals((*TWO, again)) is None


def test_no_sum_of_one_bearing_or_with_one_missing():
    overloaded = check(replace(CASES["full"], name="too much", duty=PrescribedLoad(9e7)))
    assert not overloaded.outcome.solved
    assert totals(TWO[:1]) is None
    assert totals((*TWO, overloaded)) is None


def fed(name, **flows):
    """A bearing that is fed with oil."""
    values = {"minimum_film_thickness": 2e-5, "supply_temperature": 318.0, "friction_power": 1e3} | flows
    return replace(TWO[0], name=ResultName(name), values=values, checks=())


def test_the_pump_delivers_what_returns_unused_too_and_not_what_the_sides_draw_in():
    results = (
        fed("a", total_flow=3e-5, side_inflow=0.0, surplus_flow=2e-5),
        fed("b", total_flow=4e-5, side_inflow=1e-5),
    )
    found = totals(results)
    assert found.values["total_flow"] == pytest.approx(7e-5, rel=1e-12)
    assert found.values["pump_flow"] == pytest.approx(8e-5, rel=1e-12)
    assert "oil flow Q = 4.2 L/min, required pump flow Q_pump = 4.8 L/min" in found.sentence
    meant = {one.symbol: one.meant for one in found.sums}
    assert meant["Q"] == "what passes the films that the limits are held against"
    assert meant["Q_pump"] == "what all films want, whatever the supply delivers"
    assert meant["P_f"] == ""
    (surplus,) = (column for column in columns_of(results) if column.heading == "Q_over")
    assert surplus.cells(results) == ["1.2", "–"]


def test_the_flow_of_the_pump_is_called_what_the_films_want_and_roundoff_of_a_pressure_nothing():
    """It stood as the flow of a pump that delivers less; a tube without loss read 1.09e-14 kPa."""
    assert QUANTITIES["pump_flow"].meaning == "Oil flow that all bearings of a machine want of its pump"
    assert QUANTITIES["element_pressure"].format(1.09e-11) == "0"


def test_one_flow_is_shown_where_the_pump_delivers_what_leaves_the_films():
    found = totals((fed("a", total_flow=3e-5, side_inflow=0.0), fed("b", total_flow=4e-5, side_inflow=0.0)))
    assert found.values["pump_flow"] == found.values["total_flow"]
    assert "of the pump" not in found.sentence


def test_the_shaft_is_counted_beside_its_bearings_and_not_as_one():
    shaft = replace(TWO[0], kind="shaft", method="beam", name=ResultName("Pinion shaft"))
    assert counted_parts([shaft, *TWO]) == "2 bearings and Pinion shaft"
    assert counted_parts(TWO) == "2 bearings"
    assert counted_parts([shaft]) == "1 bearing"
