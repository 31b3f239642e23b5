"""The example that ships and the validation case describe the same eleven bearings."""

import math
from pathlib import Path

import pytest

from babbitt.case import load_case
from babbitt.design.conditions import surface_speed
from babbitt.solving import solve
from babbitt.validation.reference_data import reference_data

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "marine_reverse_gear.yaml"
DATA = reference_data("reverse_gear")["inferred"]


BEARINGS = list(zip(load_case(EXAMPLE).problems(), DATA["bearings"], strict=True))


@pytest.mark.parametrize(("case", "inferred"), BEARINGS)
def test_bearing_by_bearing(case, inferred):
    bearing = case.bearing
    assert bearing.diameter == pytest.approx(inferred["diameter_mm"] * 1e-3)
    assert bearing.width_ratio == pytest.approx(inferred["width_ratio"])
    assert bearing.relative_clearance == pytest.approx(inferred["relative_clearance_permille"] * 1e-3)
    assert bearing.span == inferred["span_deg"]
    assert surface_speed(case) == pytest.approx(inferred["surface_speed_m_s"])
    common = DATA["common"]
    expansion = (bearing.expansion_bearing - bearing.expansion_journal) * 1e6
    assert expansion == pytest.approx(common["expansion_bearing_less_journal_1e6_per_K"])
    assert case.oil_supply.temperature - 273.15 == pytest.approx(common["inlet_temperature_C"])
    assert case.oil_supply.pressure == pytest.approx(common["element_pressure_MPa"] * 1e6)
    assert case.lubricant.name == common["lubricant"]
    assert (case.friction.value, case.friction_factor) == (
        common["friction"],
        common["friction_factor_of_tables_4_and_5"],
    )
    share = inferred.get("pocket_width_ratio", common["groove_width_ratio"])
    assert math.isclose(bearing.supply_element.relative_width(bearing.width), share, rel_tol=1e-9)


def test_the_output_wheel_has_the_load_of_the_example_of_its_shaft():
    share = solve(load_case(EXAMPLE.with_name("output_wheel_load_share.yaml"))).results[0]
    for name in ("marine_reverse_gear.yaml", "reverse_gear_film.yaml"):
        wheel = next(case for case in load_case(EXAMPLE.with_name(name)).problems() if case.name == "Output wheel")
        assert wheel.duty.load == pytest.approx(share.reaction_2, abs=10.0)
