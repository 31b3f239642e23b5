"""A comparison does not hide what a result is warned of."""

import io
from dataclasses import replace

from rich.console import Console

from babbitt.cases import parse_case
from babbitt.report import comparison_table
from babbitt.report.comparison_table import objected, print_comparison
from babbitt.studies.comparison import compare_methods

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
