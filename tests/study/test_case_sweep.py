"""A case file with one field varied: each answer is that of the file which says so."""

from __future__ import annotations

import io
from pathlib import Path

import pytest
from rich.console import Console

from babbitt.case import CaseError, parse_case, template
from babbitt.case.case_hash import case_hash
from babbitt.case.variation import case_variation
from babbitt.core.files.spreadsheet import rows_text
from babbitt.core.notices import InputError
from babbitt.core.result import Result, Verdict
from babbitt.report.sweep_table import codes_of, print_sweep, sweep_rows
from babbitt.solving import solve
from babbitt.study.case_sweep import sweep_case
from babbitt.study.sweep_values import values_of

EXAMPLES = Path(__file__).parents[2] / "examples"

FILM = """\
kind: journal
name: Grooved
method: film
diameter: 200 mm
width: 120 mm
clearance: {kind: relative, mean: 1.5 permille}
materials: {bearing: C10, journal: C45}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.15 MPa}
grooves: [{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]
effective_temperature: 60 degC
load: 30 kN
speed: 3000 rpm
"""


@pytest.fixture
def film(tmp_path):
    (tmp_path / "film.yaml").write_text(FILM)
    return tmp_path / "film.yaml"


@pytest.mark.parametrize(
    ("path", "values", "was", "becomes"),
    [
        ("load", "20 kN, 60 kN", "load: 30 kN", "load: 60 kN"),
        ("clearance.mean", "1 permille, 2 permille", "mean: 1.5 permille", "mean: 2 permille"),
        ("grooves.1.extent", "10 deg, 30 deg", "180 deg, extent: 20 deg", "180 deg, extent: 30 deg"),
        ("rotor_mass", "2 t, 4 t", "load: 30 kN", "load: 30 kN\nrotor_mass: 4 t"),
        ("specific_load", "1 MPa, 2 MPa", "load: 30 kN", "specific_load: 2 MPa"),
        ("surface_speed", "10 m/s, 20 m/s", "speed: 3000 rpm", "surface_speed: 20 m/s"),
    ],
)
def test_each_answer_is_that_of_the_file_with_the_value_in_it(film, path, values, was, becomes):
    found = sweep_case([(case_variation(film, path), values_of(values))])
    assert FILM.count(was) == 1
    by_hand = solve(parse_case(FILM.replace(was, becomes)))
    assert case_hash(found.case(1)) == by_hand.case_hash
    wanted = by_hand.results[0]
    answer = found.answers[1][0]
    assert answer.minimum_film_thickness == pytest.approx(wanted.minimum_film_thickness, rel=1e-12)
    assert answer.rotor_mass == wanted.rotor_mass


def test_what_the_file_has_is_known_in_the_unit_of_the_values(film):
    assert sweep_case([(case_variation(film, "load"), values_of("10000 N, 50 kN"))]).fields[
        0
    ].present == pytest.approx(30000.0)
    assert sweep_case([(case_variation(film, "rotor_mass"), values_of("2 t"))]).fields[0].present is None


def test_a_value_that_leaves_no_film_is_a_status_and_stops_nothing(film):
    found = sweep_case([(case_variation(film, "load"), values_of("90 MN, 30 kN"))])
    assert [result.outcome.solved for _, result in found.rows()] == [False, True]
    assert not found.solved


def test_the_checks_that_were_not_made_stand_below_the_verdicts(film, capsys):
    """Passing rows keep only the limits for which the case has data."""
    found = sweep_case([(case_variation(film, "load"), values_of("20 kN, 30 kN"))])
    missing = {notice.code for _, result in found.rows() for notice in result.not_checked}
    print_sweep(found)
    told = [line for line in capsys.readouterr().out.splitlines() if line.startswith("Not checked: ")]
    assert missing
    assert {code for code in missing if any(code in line for line in told)} == missing


def test_a_shared_field_of_a_machine_changes_every_bearing_and_a_bearing_can_stand_alone():
    gear = EXAMPLES / "marine_reverse_gear.yaml"
    shared = sweep_case([(case_variation(gear, "supply.temperature"), values_of("45 degC, 50 degC"))])
    assert len(shared.names) == 11
    assert len(list(shared.rows())) == 22
    one = sweep_case(
        [(case_variation(gear, "clearance.mean", "Output wheel"), values_of("0.8 permille, 1 permille"))]
    )
    assert one.names == ("Output wheel",)
    assert one.fields[0].path == "clearance.mean"
    assert one.answers[0][0].relative_clearance == pytest.approx(0.8e-3)


def test_operating_points_are_reached_by_their_number(tmp_path):
    points = "operating_points:\n  - {name: slow, speed: 500 rpm}\n  - {name: fast, speed: 2000 rpm}\n"
    (tmp_path / "points.yaml").write_text(template("journal") + points)
    found = sweep_case(
        [(case_variation(tmp_path / "points.yaml", "operating_points.0.speed"), values_of("600 rpm"))]
    )
    assert [result.angular_speed for _, result in found.rows()] == pytest.approx([62.83, 209.44], rel=1e-3)


@pytest.mark.parametrize(
    ("path", "words"),
    [
        ("lubricant.viscosity", "not a mapping"),
        ("grooves.7.extent", "no 'grooves.7' to look into; the list has 0 to 1"),
        ("grooves.first.extent", "no 'grooves.first'"),
        ("load..x", "names no field"),
        ("", "names no field"),
    ],
)
def test_a_path_that_leads_nowhere_is_told(film, path, words):
    with pytest.raises(InputError, match=words) as told:
        sweep_case([(case_variation(film, path), values_of("1, 2"))])
    assert told.value.code == "E005"


def test_a_list_without_that_place_is_told(film):
    with pytest.raises(InputError, match=r"no 'grooves\.7'; the list has 0 to 1"):
        sweep_case([(case_variation(film, "grooves.7"), values_of("1, 2"))])


def test_unknown_fields_bad_values_and_unknown_bearings_are_told(film):
    with pytest.raises(CaseError, match="did you mean 'load'"):
        sweep_case([(case_variation(film, "laod"), values_of("1 kN, 2 kN"))])
    with pytest.raises(CaseError, match="load: '2 m' is a length"):
        sweep_case([(case_variation(film, "load"), values_of("2 m, 3 m"))])
    with pytest.raises(InputError, match="no bearing 'Nobody'; there are: Grooved"):
        case_variation(film, "load", "Nobody")
    with pytest.raises(CaseError, match="no such file"):
        case_variation(film.parent / "none.yaml", "load")


def test_a_value_that_is_refused_stops_nothing(film, capsys):
    """Its row tells so in table and CSV, its reason below; the others are as without it."""
    found = sweep_case([(case_variation(film, "load"), values_of("1 kN, 3 m, 2 kN"))])
    alone = sweep_case([(case_variation(film, "load"), values_of("1 kN, 2 kN"))])
    assert [place for place, _ in found.rows()] == [0, 2]
    assert [one.values["minimum_film_thickness"] for _, one in found.rows()] == [
        one.values["minimum_film_thickness"] for _, one in alone.rows()
    ]
    assert not found.solved
    assert list(found.refused) == [1]
    print_sweep(found)
    shown = " ".join(capsys.readouterr().out.split())
    assert "refused" in shown
    assert "'3 m' is a length" in shown
    lines = rows_text(sweep_rows(found)).splitlines()
    assert [line.split(",")[2] for line in lines[1:]] == ["converged", "refused", "converged"]
    assert {line.count(",") for line in lines} == {lines[0].count(",")}


def test_the_table_of_a_sweep_names_the_codes_of_its_verdicts(film, monkeypatch, capsys):
    """Missed limits, and the warnings that question a result; a result that passes has none."""
    monkeypatch.setenv("COLUMNS", "200")
    path = film.with_name("metal.yaml")
    metal = (
        "journal: C45, bearing_metal: SnSb12Cu6Pb}\nsurfaces: {kind: direct, roughness_bearing: 4 um, "
        "roughness_journal: 2 um}"
    )
    path.write_text(FILM.replace("journal: C45}", metal).replace("effective_temperature: 60 degC\n", ""))
    found = sweep_case([(case_variation(path, "load"), values_of("5 kN, 30 kN, 300 kN, 90 MN"))])
    print_sweep(found)
    shown = capsys.readouterr().out
    heading, *rows = sweep_rows(found)
    assert heading[-1] == "codes"
    verdicts = [result.verdict for _, result in found.rows()]
    assert {Verdict.FAIL, Verdict.NO_SOLUTION} < set(verdicts)
    for (_, result), row in zip(found.rows(), rows, strict=True):
        codes = codes_of(result)
        assert bool(codes) is (result.verdict is not Verdict.PASS)
        assert row[-1] == (" ".join(codes) or None)
        assert all(code in shown for code in codes)


def test_a_sweep_keeps_results_and_no_films(tmp_path):
    (tmp_path / "case.yaml").write_text(template("journal"), encoding="utf-8")
    found = sweep_case([(case_variation(tmp_path / "case.yaml", "load"), values_of("8 kN, 9 kN"))])
    assert len(found.answers) == 2
    assert all(isinstance(result, Result) for results in found.answers.values() for result in results)


def test_columns_are_left_out_only_where_the_table_would_be_too_wide(film):
    found = sweep_case([(case_variation(film, "load"), values_of("20 kN, 30 kN"))])

    def printed(width):
        paper = io.StringIO()
        print_sweep(found, Console(file=paper, width=width, highlight=False))
        return paper.getvalue()

    widest = max(len(line.rstrip()) for line in printed(1000).splitlines()[1:5])
    assert "Left out" not in printed(widest)
    assert "Left out" in printed(widest - 4)


def test_units_stand_as_engineers_write_them(film):
    pytest.importorskip("matplotlib")
    from babbitt.report.sweep_plot import sweep_figure

    found = sweep_case([(case_variation(film, "effective_temperature"), values_of("50 degC, 60 degC"))])
    assert sweep_figure(found).axes[2].get_xlabel() == "effective_temperature in °C"
    paper = io.StringIO()
    print_sweep(found, Console(file=paper, width=200, highlight=False))
    assert "degC" not in paper.getvalue()
