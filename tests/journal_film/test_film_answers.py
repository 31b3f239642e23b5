"""What the film method hands to the table, to JSON, to the report and to the comparison."""

import json
import math

import numpy as np
import pytest
from film_bearings import case, film, solved

import babbitt
from babbitt.case import parse_case
from babbitt.kinds.journal.film.check import film_check
from babbitt.kinds.journal.film.field import field_of
from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.infinitely_long_bearing.pressure import Gap, divergence_form
from babbitt.report.content import content
from babbitt.report.export import to_json, write_json
from babbitt.report.table import render
from babbitt.study.comparison import compare_methods


@pytest.fixture(scope="module")
def machine():
    return solved()


def test_json_has_matrices_in_the_order_of_the_contract(machine):
    (bearing,) = json.loads(write_json(machine))["bearings"]
    results = bearing["results"]
    assert bearing["method"] == "film"
    assert results["stiffness"] == [
        [results["stiffness_xx"], results["stiffness_xy"]],
        [results["stiffness_yx"], results["stiffness_yy"]],
    ]
    assert results["damping"][0][1] == results["damping_xy"]
    for name in ("critical_mass", "whirl_frequency_ratio", "mass_balance_error", "wall_time", "total_flow"):
        assert name in results
    assert bearing["settings"]["cavitation"] == "mass_conserving"


def test_a_film_that_cannot_whirl_has_no_critical_mass():
    found = solved(load="600 kN", effective_temperature="60 degC")
    (bearing,) = to_json(found)["bearings"]
    assert bearing["results"]["whirl_frequency_ratio"] == 0.0
    assert "critical_mass" not in bearing["results"]


def test_the_report_shows_a_film_without_formulas_of_the_standard(machine):
    (bearing,) = content(machine)["bearings"]
    assert bearing["method"] == "Film in two dimensions"
    assert bearing["sections"] == []
    shown = {row["label"]: row["value"] for group in bearing["inputs"] for row in group["rows"]}
    assert shown["Form of the bore"] == "round"
    assert shown["Sense of rotation (x right, y up)"] == "counter-clockwise"
    assert "Angular span" not in shown
    assert {"Critical mass", "Film stiffness", "Threshold speed of whirl"} <= {
        row["label"] for row in bearing["results"]
    }
    assert "C115" in {check["code"] for check in bearing["checks"]}


def test_the_table_lists_the_coefficients(machine, capsys):
    from babbitt.report.table import console

    console(140).print(render("Bearing", machine.results, 140))
    out = capsys.readouterr().out
    assert "k_yx" in out
    assert "c_xx" in out
    assert "film" in out


def test_comparison_puts_the_named_method_first():
    given = {"grooves": None, "span": "180 deg", "supply_element": {"kind": "groove_180", "width": "10 mm"}}
    (by_film,), (by_standard,) = (compare_methods(case(**given, method=method)) for method in ("film", "iso7902"))
    labels = [variant.label for variant in by_film.variants]
    assert labels[0] == "film, one temperature"
    assert labels.index("ISO 7902") < labels.index("film, Reynolds")  # methods first, then what varies one choice
    assert {"adiabatic film", "full thermal film"} < set(labels)
    assert by_standard.variants[0].label == "ISO 7902"
    assert sorted(labels) == sorted(variant.label for variant in by_standard.variants)


def test_comparison_leaves_the_standard_out_where_it_does_not_know_the_bearing():
    lemon = compare_methods(case(bore={"kind": "lobes", "preload": 0.5}))[0]
    assert "ISO 7902" not in {variant.label for variant in lemon.variants}
    grooved = compare_methods(case())[0]
    assert "ISO 7902" not in {variant.label for variant in grooved.variants}  # grooves alone tell no span
    assert "round bores only, not lobes" in lemon.left_out
    assert "give span" in grooved.left_out
    assert not compare_methods(case(grooves=None, span="180 deg", accuracy="draft"))[0].left_out


@pytest.mark.parametrize(
    "given",
    [
        {},
        {"misalignment": {"x": "0 mrad", "y": "0.4 mrad"}},
        {"misalignment": {"x": "0 mrad", "y": "0.4 mrad"},
         "pockets": [{"angle": "90 deg", "extent": "30 deg", "width": "60 mm"}]},
    ],
)  # fmt: skip
def test_the_highest_pressure_is_that_of_the_field(given):
    bearing = film(**given)
    solution = operating_film(bearing).film.solution
    told = film_check(bearing).maximum_pressure
    assert told == pytest.approx(field_of(solution).pressure.max(), rel=5e-3)
    assert told >= field_of(solution).pressure.max() * (1.0 - 1e-12)
    if not given:
        assert told == solution.maximum_pressure


def test_methods_that_do_not_apply_are_told_with_the_reason():
    turbulent = {"turbulence": "ng_pan", "tilt_coefficients": True, "accuracy": "draft", "span": "150 deg"}
    (found,) = compare_methods(case(**turbulent))
    told = dict(line.split(" left out: ") for line in found.left_out.splitlines())
    assert told == {
        "adiabatic film and full thermal film are": "coefficients of tilt are those of a film of one "
        "temperature; take tilt_coefficients out of the case to see it",
        "long film is": "it knows laminar films only",
        "ISO 7902 is": "it knows laminar films only",
    }
    labels = {variant.label for variant in found.variants}
    assert labels.isdisjoint({"adiabatic film", "full thermal film", "long film", "ISO 7902"})


def test_a_wide_film_tends_to_the_infinitely_long_one():
    """What the ends cost falls as D/B: two widths lead to Sommerfeld's number of the infinitely long film."""
    case = """
kind: journal
name: Wide
method: film
film_start: widest_gap
cavitation: reynolds
diameter: 100 mm
width_ratio: RATIO
clearance: {kind: relative, mean: 1 permille}
materials: {bearing: C10, journal: C45}
lubricant: ISO VG 46
effective_temperature: 50 degC
supply: {temperature: 50 degC, pressure: 0 kPa}
eccentricity_ratio: 0.6
speed: 1000 rpm
"""
    five, ten = (
        babbitt.solve(parse_case(case.replace("RATIO", ratio))).results[0].sommerfeld_number
        for ratio in ("5", "10")
    )
    gap = Gap.of(0.6, 2000, 0.0)
    along, across = divergence_form(gap, np.ones(2001)).load(gap.step)
    assert 2.0 * ten - five == pytest.approx(0.5 * math.hypot(along, across), rel=0.005)
