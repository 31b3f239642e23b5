"""What the pages say of the reverse gear, in numbers."""

from dataclasses import replace

import numpy as np
import pytest

from babbitt.kinds.journal.iso7902.characteristics import curves
from babbitt.kinds.journal.iso7902.characteristics.friction import of_full_bearing
from babbitt.kinds.journal.iso7902.model import Friction
from babbitt.kinds.journal.iso7902.procedure import check, check_at_temperature
from babbitt.properties.lubricants import lubricant
from babbitt.validation import validation_case
from babbitt.validation.published.reverse_gear import outlet_temperature
from babbitt.validation.published.reverse_gear import solved as gear_solved
from babbitt.validation.published.reverse_gear_inputs import design_case, inferred, published
from babbitt.validation.published.reverse_gear_spans import BEARING, solved

TABLE_2 = published()["table_2"]["rows"]
TABLES_4_AND_5 = published()["tables_4_and_5"]["rows"]
SPANS = [row["span_deg"] for row in TABLE_2]


def column(name):
    values = [row[name] for row in TABLE_2]
    if name == "friction_power_kW":
        values[SPANS.index(180)] = 31.66
    return np.array(values)


def film_at_printed_temperature(row, friction):
    case = design_case(BEARING, span=row["span_deg"], friction=friction, friction_factor=1.0)
    return check_at_temperature(case, (50.0 + row["outlet_temperature_C"]) / 2.0 + 273.15)


@pytest.mark.parametrize(
    ("quantity", "sign"),
    [
        ("eccentricity_ratio", 1),
        ("outlet_temperature", 1),
        ("supply_flow", 1),
        ("minimum_film_thickness", -1),
        ("side_flow", -1),
        ("friction_power", -1),
    ],
)
def test_trends_over_the_span(quantity, sign):
    values = [solved(span).values[quantity] for span in SPANS]
    assert (sign * np.diff(values) > 0).all()


def test_two_printed_rows_do_not_close_the_heat_balance_like_the_others():
    flow = (column("side_flow_m3_h") + column("supply_flow_m3_h")) / 3600.0
    heat_capacity = column("friction_power_kW") / flow / (column("outlet_temperature_C") - 50.0) / 1e3
    by_span = dict(zip(SPANS, heat_capacity, strict=True))
    assert by_span[360] == pytest.approx(1.92, abs=0.005)
    assert by_span[180] == pytest.approx(1.95, abs=0.006)
    assert all(1.79 < by_span[span] < 1.83 for span in (150, 120, 90))


def test_printed_power_over_the_friction_curve_of_the_full_bearing():
    for row, power in zip(TABLE_2, column("friction_power_kW"), strict=True):
        number = of_full_bearing(row["eccentricity_ratio"], curves(360, 0.604))
        film = film_at_printed_temperature(row, Friction.CURVE360)
        ours = number * film.operating_relative_clearance * film.load * film.surface_speed
        assert 1.23 < 1e3 * power / ours < 1.285


@pytest.mark.parametrize(("friction", "first", "last"), [(Friction.FULL, 1.30, 0.89), (Friction.ARC, 1.30, 2.25)])
def test_no_other_friction_model_gives_the_printed_power(friction, first, last):
    power = column("friction_power_kW")
    factors = [
        1e3 * printed / film_at_printed_temperature(row, friction).friction_power
        for row, printed in zip(TABLE_2, power, strict=True)
    ]
    assert factors[0] == pytest.approx(first, abs=0.01)
    assert (max(factors) if last > first else min(factors)) == pytest.approx(last, abs=0.01)


def test_default_friction_moves_power_and_temperature_and_hardly_the_film():
    ours = [solved(span, Friction.FULL, 1.0) for span in SPANS]
    power = np.array([r.friction_power / 1e3 for r in ours]) / column("friction_power_kW") - 1.0
    assert power[0] == pytest.approx(-0.20, abs=0.01)
    assert power[-1] == pytest.approx(0.09, abs=0.01)
    temperature = np.array([r.outlet_temperature - 273.15 for r in ours]) - column("outlet_temperature_C")
    assert temperature.min() == pytest.approx(-3.6, abs=0.1)
    assert temperature.max() == pytest.approx(2.0, abs=0.1)
    eccentricity = np.array([r.eccentricity_ratio for r in ours]) - column("eccentricity_ratio")
    assert np.abs(eccentricity).max() < 0.015


def test_the_oil_of_the_text_does_not_belong_to_the_tables():
    oil = lubricant("TP-46")
    assert oil.kinematic_viscosity(313.15) == pytest.approx(63.5e-6)
    oil = replace(oil, fixed_volumetric_heat_capacity=1.8e6)
    ours = [check(replace(design_case(BEARING, span=span), lubricant=oil)) for span in SPANS]
    too_hot = np.array([r.outlet_temperature - 273.15 for r in ours]) - column("outlet_temperature_C")
    assert too_hot.min() > 4.5
    assert too_hot.max() < 7.0
    supply = np.array([r.supply_flow * 3600.0 for r in ours]) / column("supply_flow_m3_h") - 1.0
    assert -0.165 < supply.min() < supply.max() < -0.115


@pytest.mark.parametrize("eccentricity", [0.50, 0.52, 0.54, 0.57])
def test_linear_interpolation_in_a_table_with_few_columns_cuts_the_side_flow_short(eccentricity):
    rows, columns = np.array([0.4, 0.6, 0.8]), (0.5, 1.0)
    between_rows = [np.interp(eccentricity, rows, curves(180, x).side_flow_number(rows)) for x in columns]
    bilinear = np.interp(0.604, columns, between_rows)
    assert -0.06 < bilinear / curves(180, 0.604).side_flow_number(eccentricity) - 1.0 < -0.035


def test_remarks_of_the_study_against_its_own_numbers():
    actual = np.array([row["mean_clearance_permille"] for row in TABLES_4_AND_5])
    recommended = np.array([row["recommended_clearance_permille"] for row in TABLES_4_AND_5])
    short = recommended > actual
    deficit = (recommended - actual)[short]
    assert [round(100 * x) for x in (min(deficit / recommended[short]), max(deficit / recommended[short]))] == [
        24,
        39,
    ]
    assert [round(100 * x) for x in (min(deficit / actual[short]), max(deficit / actual[short]))] == [31, 64]
    by_name = {row["name"]: row["outlet_temperature_C"] for row in TABLES_4_AND_5}
    assert by_name["Second-stage pinion (a)"] - by_name["Second-stage pinion (b)"] == 12
    speeds = {bearing["name"]: bearing["surface_speed_m_s"] for bearing in inferred()["bearings"]}
    products = [row["specific_load_MPa"] * speeds[row["name"]] for row in TABLES_4_AND_5]
    assert [round(p) for p in sorted(products) if p > 50.0] == [56, 56, 56, 58]


def test_outlet_temperatures_with_the_lower_friction_factor():
    misses = {row["name"]: outlet_temperature(row["name"]) - row["outlet_temperature_C"] for row in TABLES_4_AND_5}
    hot = misses.pop("Second-stage pinion (a)")  # its pockets deliver 4 % more than in print
    assert -2.4 < hot < -2.2
    assert min(misses.values()) > -1.5
    assert max(misses.values()) < 0.6


def test_the_misprint_is_shown_and_not_judged_and_every_bearing_is_judged():
    spans = validation_case("reverse_gear_spans").rows
    misprint = next(row for row in spans if row.published == 61.66)
    assert not misprint.judged
    assert "31.66" in misprint.suspect
    corrected = next(row for row in spans if row.published == 31.66)
    assert corrected.judged
    gear = validation_case("reverse_gear").rows
    assert {row.quantity for row in gear if not row.judged} == {"T_ex"}
    assert len({row.place for row in gear if row.judged}) == 11


def test_the_output_wheel_carries_the_load_of_its_shaft_and_gives_its_whole_row():
    """Table 3, mesh force downward, is the load; what follows was once said to have no consistent dimensions."""
    wheel = gear_solved("Output wheel")
    assert wheel.load == pytest.approx(452.02e3, abs=10.0)
    assert wheel.specific_load == pytest.approx(2.10e6, abs=0.005e6)
    assert wheel.eccentricity_ratio == pytest.approx(0.772, abs=5e-4)
    assert wheel.minimum_film_thickness == pytest.approx(47.6e-6, abs=0.1e-6)
    assert wheel.side_flow * 6e4 == pytest.approx(12.5, abs=0.05)
    assert wheel.film_reynolds_number == pytest.approx(52.8, abs=0.1)
    assert wheel.stability_relative_clearance == pytest.approx(0.64e-3, abs=0.005e-3)


def test_pockets_wider_than_the_range_of_their_correction_deliver_what_is_printed():
    """Holding the logarithm at 0.7 as well made these flows 8 % low; the print gives 4.0, 3.4 and 7.9 L/min."""
    for name, found in (
        ("Second-stage pinion (a)", 4.16),
        ("Second-stage pinion (b)", 3.54),
        ("Output wheel", 8.64),
    ):
        assert gear_solved(name).supply_flow * 6e4 == pytest.approx(found, abs=0.02)


def test_shafts_of_the_second_stage_turn_together():
    """The wheel of the first stage and the pinion of the second share a shaft; their speeds were not fitted so."""
    wheel, pinion = design_case("First-stage wheel"), design_case("Second-stage pinion (a)")
    assert wheel.journal_speed == pytest.approx(pinion.journal_speed, rel=2e-3)


def test_inferred_inputs_are_declared_in_every_case():
    for bearing in inferred()["bearings"]:
        assert any("inferred and not published" in text for text in design_case(bearing["name"]).assumptions)
