"""What the assumptions of heat move, in results, tables and reports."""

from __future__ import annotations

import io
import math
import re

import numpy as np
import pytest
from pad_journals import HEATED, pad_case, result_of
from rich.console import Console

from babbitt.case import CaseError, case_from_dict
from babbitt.case.loading import case_from_dict as read
from babbitt.core.quantities import displayed_in
from babbitt.core.result import Outcome, Verdict
from babbitt.kinds.tilting_pad_journal.report.tables import sensitivity_tables, tables
from babbitt.report.table import render
from babbitt.report.us_words import in_us_units

GROWING = dict(HEATED["E"], feed="leading_edge_groove")
HOTTEST = "sensitivity_of_maximum_temperature"


@pytest.fixture(scope="module")
def result():
    return result_of(assumption_sensitivity=True, **GROWING)


def test_low_base_and_high_are_those_of_the_changed_bearing(result):
    """Each end solved as a case of its own."""
    walls = GROWING["walls"]
    ends = {
        (0, 0): {"carry_over": 0.5},
        (0, 2): {"carry_over": 0.9},
        (1, 0): {"walls": {"pads": walls["pads"] | {"heat_transfer_coefficient": f"{100 / 3!r} W/(m2 K)"}}},
        (2, 2): {"walls": walls | {"housing": {"temperature": "50 degC"}}},
    }
    for (row, column), changes in ends.items():
        other = result_of(**GROWING | changes)
        for name in ("maximum_temperature", "minimum_film_thickness", "friction_power", "stiffness_yy"):
            found = result.arrays[f"sensitivity_of_{name}"][row][column]
            assert found == pytest.approx(other.values[name], rel=1e-9), (name, changes)
    for name in ("maximum_temperature", "damping_yy", "effective_temperature"):
        assert {row[1] for row in result.arrays[f"sensitivity_of_{name}"]} == {result.values[name]}


def test_more_heat_carried_or_kept_is_hotter_and_a_warm_housing_has_more_room(result):
    carried, backs, housing = np.array(result.arrays[HOTTEST])
    assert carried[0] < carried[1] < carried[2]
    assert backs[0] > backs[1] > backs[2]
    assert housing[0] > housing[1] > housing[2]
    cold, own, warm = result.arrays["sensitivity_of_stiffness_yy"][2]
    assert cold > own > warm  # growth that finds no room stiffens
    assert result.arrays["assumed_carry_over"] == ((pytest.approx(0.5), 0.7, pytest.approx(0.9)),)
    assert result.arrays["assumed_back_coefficient"][0] == pytest.approx((100 / 3, 100.0, 300.0))
    assert result.arrays["assumed_housing_temperature"][0] == pytest.approx((303.15, 313.15, 323.15))


def test_the_numbers_of_the_bearing_do_not_change(result):
    plain = result_of(**GROWING)
    assert {n: v for n, v in plain.values.items() if n != "wall_time"} == {
        n: v for n, v in result.values.items() if n != "wall_time"
    }
    assert HOTTEST not in plain.arrays


def test_more_than_all_is_not_carried_over():
    found = result_of(assumption_sensitivity=True, **HEATED["B"])
    (low, base, high), = found.arrays["assumed_carry_over"]  # fmt: skip
    assert (low, base) == (pytest.approx(0.8), 1.0)
    assert math.isnan(high)
    assert math.isnan(found.arrays[HOTTEST][0][2])
    assert "assumed_back_coefficient" not in found.arrays


def test_films_of_one_temperature_have_no_highest():
    found = result_of(assumption_sensitivity=True, thermal="global", feed="spray_bar")
    assert HOTTEST not in found.arrays
    low, base, high = found.arrays["sensitivity_of_effective_temperature"][0]
    assert low < base < high


def test_an_end_that_starves_has_no_numbers():
    """A colder film is thicker and loses more oil by its sides: with less carried over the supply falls short."""
    side = result_of(**HEATED["B"]).values["side_flow"]
    found = result_of({"supply.flow": f"{1.001 * side!r} m3/s"}, assumption_sensitivity=True, **HEATED["B"])
    assert math.isnan(found.arrays[HOTTEST][0][0])
    assert math.isfinite(found.arrays[HOTTEST][0][1])
    (table,) = sensitivity_tables(found)
    assert [row[0] for row in table["rows"]] == ["as calculated", "Carry-over: 0.8 in place of 1"]
    assert set(table["rows"][1][1:]) == {"–"}


def test_tables_of_report_and_terminal_have_the_numbers(result):
    (table,) = sensitivity_tables(result)
    assert [one["title"] for one in tables(result)].count(table["title"]) == 1
    assert len(table["rows"]) == 7
    base = [f"{result.values['maximum_temperature'] - 273.15:.1f}", f"{result.values['stiffness_yy'] / 1e6:.4g}"]
    assert [table["rows"][0][place] for place in (1, 5)] == base
    page = io.StringIO()
    Console(file=page, width=160).print(render("Pads", [result], 160))
    assert "What assumptions move: Pads" in page.getvalue()
    for row in table["rows"]:
        assert row[0] in page.getvalue()
        assert row[1] in page.getvalue()


def test_what_is_varied_stands_in_the_units_that_are_spoken(result):
    with displayed_in("us"):
        (table,) = sensitivity_tables(result)
    rows = [row[0] for row in table["rows"]]
    assert "Heat transfer on the backs: 5.87 in place of 17.6 Btu/(h ft² °F)" in rows
    assert "Housing: 86 in place of 104 °F" in rows
    assert in_us_units(rows) == rows


def test_sources_of_limits_stand_in_the_units_that_are_spoken():
    lined = result_of(materials={"bearing_metal": "SnSb12Cu6Pb"}, **HEATED["B"])
    with displayed_in("us"):
        page = io.StringIO()
        Console(file=page, width=400).print(render("Pads", [lined], 400))
    assert "(others: 266 °F: Kingsbury" in page.getvalue()
    assert not re.search(r"\d °C", page.getvalue())


def test_nothing_is_assumed_of_films_at_a_given_temperature():
    with pytest.raises(CaseError, match="assumption_sensitivity: of films at a given temperature nothing"):
        read(pad_case(thermal="isothermal", assumption_sensitivity=True))
    assert case_from_dict(pad_case(thermal="global", assumption_sensitivity=True)).assumption_sensitivity


def test_what_the_case_gives_is_varied_too_and_not_called_assumed():
    given = dict(GROWING, carry_over=0.7)
    found = result_of(assumption_sensitivity=True, **given)
    assert found.arrays["assumed_carry_over"] == pytest.approx(np.array([[0.5, 0.7, 0.9]]))
    (table,) = sensitivity_tables(found)
    assert "Carry-over: 0.5 in place of 0.7" in {row[0] for row in table["rows"]}
    assert table["columns"][0]["text"] == "Varied"


def test_an_assumed_housing_says_that_it_follows_the_oil(result):
    assert sum("follows it where the supply temperature is varied" in said for said in result.assumptions) == 1
    warmer = result_of({"supply.temperature": "45 degC"}, assumption_sensitivity=True, **GROWING)
    assert warmer.arrays["assumed_housing_temperature"][0][1] == pytest.approx(318.15)


JUDGED = GROWING | {
    "materials": GROWING["materials"] | {"bearing_metal": "SnSb12Cu6Pb"},
    "surfaces": {"kind": "direct", "roughness_bearing": "2 um", "roughness_journal": "1 um"},
}
TIGHT = {"pads.clearance.mean": "110 um"}


def said(result, code="W419"):
    """Messages of a warning."""
    return [one.message for one in result.warnings if one.code == code]


def test_an_assumption_without_film_questions_the_verdict():
    """As growth closes the clearance of the bearing solved alone, at the other end."""
    plain = result_of(TIGHT, speed="5000 rpm", **JUDGED)
    found = result_of(TIGHT, speed="5000 rpm", assumption_sensitivity=True, **JUDGED)
    assert (plain.verdict, found.verdict) == (Verdict.PASS, Verdict.REMARKS)
    (message,) = said(found)
    assert "Carry-over: 0.900 in place of 0.700 leaves no solution: the clearance closes" in message
    assert "Housing: 30.0 °C in place of 40.0 °C leaves no solution" in message
    hot = result_of(TIGHT, speed="5000 rpm", carry_over=0.9, **JUDGED)
    assert hot.outcome is Outcome.NO_CLEARANCE
    page = io.StringIO()
    Console(file=page, width=160).print(render("Pads", [found], 160))
    assert "a dash where it has no film, or its pads starve" in " ".join(page.getvalue().split())
    page = io.StringIO()
    with displayed_in("us"):
        Console(file=page, width=160).print(render("Pads", [found], 160))
    assert "Housing: 86.0 °F in place of 104.0 °F leaves no solution" in " ".join(page.getvalue().split())
    assert "°C" not in page.getvalue()


def test_an_assumption_that_misses_a_limit_questions_the_verdict(result):
    """The alarm lies between the probe as calculated and with more oil carried over."""
    base = result.values["probe_temperature"]
    hotter = result_of(**GROWING | {"carry_over": 0.9}).values["probe_temperature"]
    alarm = 0.5 * (base + hotter)
    limits = {"probe_alarm": f"{alarm - 273.15!r} degC"}
    found = result_of(assumption_sensitivity=True, limits=limits, **GROWING)
    (message,) = said(found)
    numbers = f"C404 is missed, {hotter - 273.15:.1f} °C > {alarm - 273.15:.1f} °C"
    assert f"Carry-over: 0.900 in place of 0.700: {numbers}" in message
    assert "Carry-over: 0.500" not in message
    assert not said(result)


def test_an_end_that_draws_more_than_is_given_has_no_numbers_and_leaves_no_verdict(result):
    """Less hot oil carried over is more fresh oil drawn in: more than the supply gives, which W405 says alone."""
    drawn = [result_of(**GROWING | {"carry_over": over}).values["total_flow"] for over in (0.7, 0.5)]
    found = result_of({"supply.flow": f"{0.5 * sum(drawn)!r} m3/s"}, assumption_sensitivity=True, **GROWING)
    assert not said(found, "W405")
    assert math.isnan(found.arrays[HOTTEST][0][0])
    assert math.isfinite(found.arrays[HOTTEST][0][2])
    (message,) = said(found)
    assert message == "Carry-over: 0.500 in place of 0.700 leaves no verdict (W405)"
