"""What the tabs show: fields of the film, oils, metals, two designs, published cases, the case as Python."""

import json
import math
import re

import numpy as np
import pytest
from page_cases import FILM, JOURNAL, TEMPLATES, changed

from babbitt import parse_case, solve
from babbitt.app.answer import answer, json_of, read
from babbitt.app.catalogue import ADDITIVE, field_for, metals, oils, on_chart, viscosity_chart
from babbitt.app.designs import side_by_side
from babbitt.app.document import CaseDocument
from babbitt.app.figures import all_figures
from babbitt.app.maps import chart_of, maps_of
from babbitt.app.published import published, scoreboard
from babbitt.app.python_text import python_of
from babbitt.app.units import shown_in, spoken
from babbitt.solving import solve as solve_case


@pytest.fixture(scope="module")
def film_maps():
    return {one.name: one for one in maps_of(FILM)}


def executed(text):
    """The case of the Python of a case."""
    names = {}
    exec(python_of(text).replace("print(case.solve())", ""), names)
    return names["case"]


@pytest.mark.parametrize("kind", TEMPLATES)
def test_python_makes_the_same_case(kind):
    assert executed(TEMPLATES[kind]) == parse_case(TEMPLATES[kind])


def test_python_gives_the_same_results_and_leaves_the_study_out():
    text = changed(JOURNAL, study={"kind": "corners"}, name="Quote ' and \" and \\ <b>")
    case = executed(text)
    assert case.name == "Quote ' and \" and \\ <b>"
    (first,), (other,) = solve(case).results, solve(parse_case(text)).results
    assert {**first.values, "wall_time": 0.0} == {**other.values, "wall_time": 0.0}
    assert "study" not in python_of(text)


def test_the_field_on_the_page_carries_the_load(film_maps):
    """Pressure over the bore, summed up from what the chart shows, is the load of the case."""
    found = film_maps
    (sheet,) = found["pressure"].sheets
    (solution,) = solve_case(read(FILM)).solutions
    radius = 0.5 * solution.result.values["diameter"]
    pressure = 1e6 * np.array(sheet.values)
    angles = np.radians(sheet.angles)
    along = np.trapezoid(pressure, 1e-3 * np.array(sheet.widths), axis=0)
    x, y = (radius * np.trapezoid(along * part(angles), angles) for part in (np.cos, np.sin))
    assert math.hypot(x, y) == pytest.approx(12e3, rel=0.01)
    assert found["pressure"].unit == "MPa"
    assert pressure.max() == pytest.approx(solution.result.values["maximum_pressure"], rel=0.01)
    gaps = [value for row in found["film_thickness"].sheets[0].values for value in row if value is not None]
    assert min(gaps) == pytest.approx(1e6 * solution.result.values["minimum_film_thickness"], rel=0.01)


def test_charts_are_flat_or_surfaces(film_maps):
    assert chart_of(film_maps["pressure"], True)["data"][0]["type"] == "surface"
    flat = chart_of(film_maps["pressure"], False)["data"][0]
    assert flat["type"] == "heatmap"
    assert (len(flat["z"]), len(flat["z"][0])) == (len(flat["y"]), len(flat["x"]))


def test_pads_have_a_sheet_each():
    found = {one.name: one for one in maps_of(TEMPLATES["tilting_pad_journal"])}
    pads = len(CaseDocument(TEMPLATES["tilting_pad_journal"]).given["pads"].get("angles", [])) or 4
    assert len(found["pressure"].sheets) == pads
    line = chart_of(found["film_thickness"], True)["data"]
    assert [one["type"] for one in line] == ["scatter"] * pads


def test_a_method_without_fields_has_no_maps():
    assert maps_of(JOURNAL) == ()


def test_oils_are_straight_on_the_axes_of_the_chart():
    """ASTM D341: lg lg (ν + 0.7) falls linearly with lg T for every ISO grade."""
    for line in viscosity_chart(["ISO VG 32", "ISO VG 460"])["data"]:
        slopes = np.diff(line["y"]) / np.diff(line["x"])
        assert slopes == pytest.approx(slopes[0], rel=1e-6)
        assert slopes[0] < 0.0
    x, y = on_chart(40.0, 46.0)
    assert 10.0**x == pytest.approx(313.15)
    assert 10.0 ** (10.0**y) - ADDITIVE == pytest.approx(46.0)


def test_water_leaves_the_chart_where_its_axes_end():
    (line,) = viscosity_chart(["water"])["data"]
    assert all(map(math.isfinite, line["y"]))


def test_oils_and_metals_fit_into_a_case():
    document = CaseDocument(JOURNAL)
    oil, metal = field_for(document.items, ("lubricant", "oil")), field_for(document.items, ("bearing_metal",))
    assert (oil, metal) == (("lubricant",), ("materials", "bearing_metal"))
    for path, table in ((oil, oils()), (metal, metals())):
        assert len(table.rows) > 5
        document.change(path, table.rows[-1][0])
        read(document.text)
    assert field_for(CaseDocument(TEMPLATES["overhung_coupling"]).items, ("lubricant", "oil")) is None


def test_two_designs_are_those_of_the_command():
    faults, (inputs, results) = side_by_side(JOURNAL, changed(JOURNAL, load="15 kN"))
    assert faults == ()
    assert inputs.rows == (("load", "12 kN", "15 kN"),)
    load = next(row for row in results.rows if row[0].startswith("Load,"))
    assert load[-1] == "+25.0 %"
    assert all(len(row) == len(results.heads) for row in results.rows)


def test_designs_that_cannot_be_compared_say_why():
    faults, tables = side_by_side(JOURNAL, "kind: journal\nload: 1 kg\n")
    assert faults
    assert tables == ()


def test_figures_need_a_case_that_can_be_solved(tmp_path):
    faults, drawn = all_figures("kind: journal\nload: 1 kg\n", str(tmp_path / "progress"))
    assert any("is a mass" in fault.message for fault in faults)
    assert drawn == ()


def test_published_cases_run_here(tmp_path):
    names = [row[0] for row in published().rows]
    assert "butenschoen_1976" in names
    file = str(tmp_path / "progress")
    (board,) = scoreboard(("butenschoen_1976", "closed_forms_din31652"), file)
    assert all("all agree" in row[2] for row in board.rows)
    (values,) = scoreboard(("butenschoen_1976",), file)
    assert {row[-1] for row in values.rows} <= {"agrees", "set aside", "not judged"}


@pytest.mark.parametrize(
    ("number", "unit", "units", "shown"),
    [
        ("120", "mm", ("mm", "in"), ("4.72441", "in")),
        ("50", "degC", ("degC", "degF"), ("122", "degF")),
        ("0.2", "MPa", ("MPa", "psi"), ("29.0075", "psi")),
        ("25.4", "um", ("um", "mil"), ("1", "mil")),
        ("3000", "rpm", ("rpm", "rad/s"), ("3000", "rpm")),
        ("", "mm", ("mm", "in"), ("", "in")),
    ],
)
def test_inch_units(number, unit, units, shown):
    assert shown_in("us", number, unit, units) == shown
    assert shown_in("si", number, unit, units) == (number, unit)


def test_a_text_is_read_once():
    document = CaseDocument(JOURNAL)
    assert document.given is document.given
    assert document.items is document.items
    before = document.items
    document.change(("load",), "13 kN")
    assert document.given["load"] == "13 kN"
    assert document.items is not before
    document.undo()
    assert document.items == before
    assert CaseDocument("- a list").items == ()
    assert CaseDocument("kind: [unhashable]").items == ()


SI_UNITS = re.compile(r"\d (mm|µm|N|kN|MPa|kPa|Pa|°C|K|L/min|kW|W|m/s|kg|mPa s|MN/m|kN s/m)(?![\w/²³])")


@pytest.mark.parametrize("kind", TEMPLATES)
def test_an_answer_in_us_units_says_nothing_in_others(kind):
    for one in spoken("us", answer, TEMPLATES[kind]).bearings:
        said = [f"{card.value} {card.limit} {card.margin}" for card in one.cards]
        said += [finding.message for finding in one.findings] + [one.governing]
        said += [f"{value} {unit}" for _, _, value, unit in one.rows]
        assert [text for text in said if SI_UNITS.search(text)] == []


def test_a_field_of_a_film_is_the_same_in_us_units(film_maps):
    """One of 25.4 um is one of a mil; one MPa are 145.0377 psi."""
    film = {one.name: one for one in spoken("us", maps_of, FILM)}
    mil, psi = film["film_thickness"], film["pressure"]
    assert (mil.unit, psi.unit, mil.width_unit) == ("mil", "psi", "in")
    for name, factor in (("film_thickness", 25.4), ("pressure", 1.0 / 145.0377)):
        for ours, theirs in zip(film[name].sheets, film_maps[name].sheets, strict=True):
            assert factor * np.array(ours.values, float) == pytest.approx(
                np.array(theirs.values, float), rel=1e-4, nan_ok=True
            )
            assert 25.4 * np.array(ours.widths) == pytest.approx(np.array(theirs.widths))


@pytest.mark.solves_anew
def test_numbers_for_other_programs_stay_in_si():
    ours, theirs = (json.loads(text)["bearings"] for text in (spoken("us", json_of, JOURNAL), json_of(JOURNAL)))
    for one, other in zip(ours, theirs, strict=True):
        assert {**one["results"], "wall_time": 0.0} == {**other["results"], "wall_time": 0.0}
