"""A comparison does not hide what a result is warned of."""

import io
from dataclasses import replace
from pathlib import Path

import pytest
from rich.console import Console

from babbitt.case import load_case, parse_case
from babbitt.core.result import Bound, Check, Verdict
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.report import comparison_table
from babbitt.report.comparison_page import write_comparison_page
from babbitt.report.comparison_plots import write_comparison_plots
from babbitt.report.comparison_table import objected, print_comparison
from babbitt.study.comparison import compare_methods

EXAMPLES = Path(__file__).parents[2] / "examples"
OVERLOADED = """
kind: journal
name: Loaded
method: film
diameter: 120 mm
width: 90 mm
clearance: {kind: relative, mean: 1.5 permille}
grooves: [{angle: 90 deg, extent: 20 deg}]
materials: {bearing: C10, journal: C45}
lubricant: ISO VG 46
supply: {temperature: 50 degC, pressure: 0.1 MPa}
surfaces: {kind: direct, roughness_bearing: 4 um, roughness_journal: 2 um}
load: 400 kN
speed: 300 rpm
"""


def test_warnings_and_missed_limits_stand_below_the_columns(monkeypatch):
    (found,) = compare_methods(parse_case(OVERLOADED))
    (film,) = [one.result for one in found.variants if one.label == "film, one temperature"]
    assert film.warnings
    assert not film.within_limits
    paper = io.StringIO()
    monkeypatch.setattr(comparison_table, "console", lambda: Console(file=paper, width=400))
    print_comparison([found])
    said = "  film, one temperature: misses"
    (line,) = [line for line in paper.getvalue().splitlines() if line.startswith(said)]
    for one in (*film.warnings, *(check for check in film.checks if not check.ok and not check.advisory)):
        assert one.code in line
    assert objected(replace(film, warnings=(), checks=())) == ""


@pytest.mark.parametrize(("name", "around"), [("long_film", False), ("grooved", True)])
def test_temperatures_around_the_bore_are_drawn_where_a_film_of_finite_width_has_them(name, around, tmp_path):
    found = compare_methods(load_case(EXAMPLES / f"{name}.yaml"))
    (plot,) = write_comparison_plots(found, tmp_path)
    write_comparison_page(found, tmp_path / "page.html")
    assert any(isinstance(one.solution.problem, FilmCase) for one in found[0].methods) is around
    assert ("counter-clockwise" in plot.read_text(encoding="utf-8")) is around
    assert plot.stat().st_size > 5000


def test_methods_stand_from_the_one_that_sees_least_with_the_one_asked_for_marked(monkeypatch):
    (found,) = compare_methods(load_case(EXAMPLES / "input_pinion_heat.yaml"))
    labels = [one.label for one in found.methods]
    assert labels[0] == "ISO 7902"
    assert labels[-2:] == ["adiabatic film", "full thermal film"]
    assert found.asked.label == "full thermal film"
    rows = {row.meaning: row.cells for row in comparison_table.compared_rows(found.compared, found.methods)}
    # with the oil that its half groove delivers
    assert rows["Margin of the temperature to its limit"][0] == "+16.9 K"
    assert rows["Oil temperature at the outlet, T_ex"][2] == "–"  # the temperature is prescribed
    born, oil, bush, journal = (
        found.asked.result.values[name]
        for name in ("film_dissipation", "heat_to_oil", "heat_film_to_bush", "heat_film_to_journal")
    )
    assert born == pytest.approx(oil + bush + journal, rel=1e-8)


def test_the_margin_of_the_temperature_is_that_which_governs():
    """Of oil, metal and probes alike; a rise is no temperature."""
    (found,) = compare_methods(parse_case(OVERLOADED))
    result = found.asked.result
    margins = {
        "outlet_temperature": Check("C104", "outlet_temperature", 343.15, 373.15, Bound.AT_MOST, "hand"),
        "metal": Check("C108", "effective_temperature", 389.15, 393.15, Bound.AT_MOST, "hand"),
        "probe": Check("C404", "probe_temperature", 381.15, 383.15, Bound.AT_MOST, "hand"),
        "advice": Check("C404", "probe_temperature", 383.15, 383.15, Bound.AT_MOST, "hand", advisory=True),
        "rise": Check("C104", "temperature_rise", 1.0, 1.0, Bound.AT_MOST, "hand"),
    }
    seen = {}
    for left_out in ("", "probe", "metal"):
        checks = tuple(check for name, check in margins.items() if name != left_out)
        solution = replace(found.asked.solution, result=replace(result, checks=checks))
        rows = comparison_table.compared_rows((), [replace(found.asked, solution=solution)])
        seen[left_out] = {row.meaning: row.cells for row in rows}["Margin of the temperature to its limit"]
    assert seen == {"": ("+2.0 K",), "probe": ("+4.0 K",), "metal": ("+2.0 K",)}


def test_methods_that_disagree_are_named():
    (found,) = compare_methods(parse_case(OVERLOADED))
    (bad,) = [one for one in found.variants if one.label == "film, one temperature"]
    assert bad.result.verdict is Verdict.FAIL
    kept = tuple(check for check in bad.result.checks if check.ok)
    mild = replace(bad.result, warnings=(), checks=kept, not_checked=())
    good = replace(bad, label="mild", solution=replace(bad.solution, result=mild))
    said = "The methods disagree: limits kept by mild are missed by film, one temperature."
    assert comparison_table.contradiction([good, bad]) == said
    assert comparison_table.contradiction([good]) == comparison_table.contradiction([bad]) == ""
