"""Published cases of the film engine: they can fail, and they say what they claim."""

import copy
import math
from importlib import import_module

import numpy as np
import pytest

from babbitt.validation import summary
from babbitt.validation.published import friswell_2010, someya_1989_table1, someya_1989_table3
from babbitt.validation.published.someya_common import compliance_over_slope, printed_consistency, table
from babbitt.validation.reference_data import reference_data


def scale(rows, row, column, factor):
    rows[row][column] *= factor


@pytest.mark.parametrize(
    ("module", "data", "change"),
    [
        ("film_butenschoen_squeeze", "butenschoen_1976_squeeze", lambda d: scale(d["rows"], 14, 1, 1.011)),
        ("film_raimondi_boyd", "raimondi_boyd_1958", lambda d: scale(d["width_ratio_1"], 3, 4, 1.006)),
        ("lund_thomsen_1978", "lund_thomsen_1978", lambda d: scale(d["two_grooves"], 4, 3, 1.035)),
        ("fowell_2007", "sliders", lambda d: d["fowell_2007"].update(q_over_U_m=5.236e-7)),
        ("parabolic_slider", "sliders", lambda d: d["parabolic"].update(x_reformation_over_L=0.994)),
        ("trawler_stages", "trawler_line", lambda d: d["published"].update({"1c": 32.0})),
        ("trawler_stages", "trawler_line", lambda d: scale(d["rings"], 3, 4, 1.04)),
        ("thrust_pad_forms", "trawler_line", lambda d: d["pad"].update(maximum_pressure_MPa=4.55)),
        ("thrust_hydro_generator", "thrust_hydro_generator", lambda d: d.update(maximum_temperature_degC=73.5)),
        ("friswell_2010", "friswell_2010", lambda d: scale(d["stiffness"], 1, 0, 1.0002)),
    ],
)
def test_a_wrong_number_in_the_data_makes_its_case_fail(module, data, change, monkeypatch):
    case = import_module(f"babbitt.validation.published.{module}")
    assert summary(case.run()).agrees
    spoilt = copy.deepcopy(reference_data(data))
    change(spoilt)
    monkeypatch.setattr(case, "reference_data", lambda name: spoilt)
    assert not summary(case.run.__wrapped__()).agrees


def test_closed_form_of_the_short_bearing_inverts():
    for eccentricity in (0.05, 0.3, 0.7, 0.95):
        number = friswell_2010.modified_sommerfeld_number(eccentricity)
        assert friswell_2010.eccentricity_ratio(number) == pytest.approx(eccentricity, rel=1e-10)


@pytest.mark.parametrize("eccentricity", [0.2, 0.6])
def test_closed_form_of_the_short_bearing_is_the_slope_of_its_locus(eccentricity):
    """K dr = dF along the locus; the load points down and turns with nothing."""

    def state(e):
        number = friswell_2010.modified_sommerfeld_number(e)
        angle = math.atan(math.pi * math.sqrt(1.0 - e * e) / (4.0 * e))
        return -math.log(number), e * np.array([math.sin(angle), -math.cos(angle)])

    (behind, start), (ahead, end) = state(eccentricity - 1e-5), state(eccentricity + 1e-5)
    stiffness, _ = friswell_2010.closed_form(eccentricity)
    np.testing.assert_allclose(stiffness @ (end - start) / (ahead - behind), [0.0, -1.0], atol=1e-6)


def test_the_first_table_of_someya_turns_its_grooves():
    """What the page claims: Kxx = Kxy cot phi in every row as far as three figures say."""
    for row in table("table_1"):
        angle = math.radians(row["attitude_angle_degrees"])
        assert row["Kxx"] / row["Kxy"] * math.tan(angle) == pytest.approx(1.0, abs=0.01)
        ours = someya_1989_table1.computed(row["bearing_number_S"])
        turned = ours["Kxx turned"] / ours["Kxy turned"] * math.tan(math.radians(ours["φ"]))
        assert turned == pytest.approx(1.0, rel=1e-9)


def test_the_third_table_of_someya_contradicts_itself():
    found = printed_consistency(table("table_3"), 0.5)
    assert max(abs(ratio - 1.0) for _, ratio, _ in found) == pytest.approx(0.17, abs=0.01)
    assert max(abs(angle) for _, _, angle in found) == pytest.approx(13.6, abs=0.2)


def test_the_spline_behind_the_contradiction_is_good_enough():
    """The same check with the engine's own row for row: what the spline itself misses is far less."""
    rows = []
    for row in table("table_3"):
        ours = someya_1989_table3.computed(row["bearing_number_S"])
        names = {"ε": "eccentricity_ratio", "φ": "attitude_angle_degrees"}
        rows.append({"bearing_number_S": row["bearing_number_S"]} | {names.get(k, k): v for k, v in ours.items()})
    for _, ratio, angle in printed_consistency(rows, 0.5):
        assert ratio == pytest.approx(1.0, abs=0.015)
        assert abs(angle) < 1.0


def test_compliance_over_slope_of_a_plain_spring():
    ratio, angle = compliance_over_slope(np.diag([2.0, 5.0]), np.array([0.5, 0.0]))
    assert ratio == pytest.approx(1.0)
    assert angle == pytest.approx(0.0)
