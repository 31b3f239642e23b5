"""Designs side by side: changed inputs, matched bearings, differences, outputs of the command."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path

import pytest

import babbitt as bb
from babbitt.case import load_case, parse_case
from babbitt.cli import main
from babbitt.core.language import written_in
from babbitt.core.notices import InputError
from babbitt.report.designs_output import designs_page
from babbitt.report.designs_table import bearing_rows, difference
from babbitt.study.designs import ABSENT, changed_inputs, compare_designs

EXAMPLES = Path(__file__).parents[2] / "examples"
FIRST = (EXAMPLES / "journal.yaml").read_text(encoding="utf-8")
SECOND = FIRST.replace("width: 60 mm", "width: 72 mm").replace("load: 24 kN", "load: 24000 N")
OTHER_OIL = FIRST.replace("ISO VG 46", "ISO VG 32").replace("Textbook bearing", "Thin oil")
MACHINE = """
kind: machine
name: Gear
lubricant: ISO VG 46
supply: {temperature: 50 degC, pressure: 0.2 MPa}
materials: {bearing: C10, journal: C45}
bearings:
  - {kind: journal, name: Pinion, diameter: 100 mm, width: 60 mm, clearance: {kind: relative, mean: 1.2 permille},
     span: 360 deg, load: 10 kN, speed: 3000 rpm}
  - {kind: journal, name: Wheel, diameter: 150 mm, width: 90 mm, clearance: {kind: relative, mean: 1.2 permille},
     span: 360 deg, load: 20 kN, speed: 1000 rpm}
"""


def designs(*texts):
    return compare_designs([parse_case(text) for text in texts], [f"d{number}" for number in range(len(texts))])


def test_inputs_that_say_the_same_are_not_changed():
    said_otherwise = FIRST.replace("120 mm", "0.12 m").replace("2000 rpm", "209.4395102393195 rad/s")
    assert changed_inputs([parse_case(FIRST), parse_case(said_otherwise)]) == ()


def test_every_changed_input_is_listed_and_no_other():
    changed = changed_inputs([parse_case(FIRST), parse_case(SECOND), parse_case(OTHER_OIL)])
    assert {one.path: one.values for one in changed} == {
        "width": ("60 mm", "72 mm", "60 mm"),
        "lubricant.name": ("ISO VG 46", "ISO VG 46", "ISO VG 32"),
    }


def test_what_one_design_lacks_is_said():
    without = FIRST.replace("surfaces: {kind: direct, roughness_bearing: 4 um, roughness_journal: 2 um}\n", "")
    changed = {one.path: one.values for one in changed_inputs([parse_case(FIRST), parse_case(without)])}
    assert changed["surfaces.roughness_bearing"] == ("4 um", ABSENT)


def test_results_are_those_of_each_case_and_differences_follow():
    found = designs(FIRST, SECOND)
    (bearing,) = found.bearings
    alone = [one.results[0] for one in found.machines]
    rows = {row.name: row for row in bearing_rows(bearing)}
    power = [one.friction_power for one in alone]
    assert rows["friction_power"].differences == (f"{100.0 * (power[1] / power[0] - 1.0):+.1f} %",)
    rise = alone[1].outlet_temperature - alone[0].outlet_temperature
    assert rows["outlet_temperature"].differences == (f"{rise:+.1f} K",)
    assert rows["width"].differences == ("+20.0 %",)
    said = {row.meaning: row.cells for row in bearing_rows(bearing)}
    assert said["Verdict"] == tuple(one.verdict.value for one in alone)
    assert [cell.split()[0] for cell in said["Governing check"]] == [one.governing_check.code for one in alone]


@pytest.mark.solves_anew
def test_the_same_design_twice_differs_in_nothing():
    found = designs(FIRST, FIRST)
    assert found.changed == ()
    assert all(set(row.differences) <= {"0 %", "+0.0 K", "+0.0 °", ""} for row in bearing_rows(found.bearings[0]))


def test_single_bearings_are_matched_whatever_they_are_called_and_machines_by_name():
    assert [len(one.results) for one in designs(FIRST, OTHER_OIL).bearings] == [2]
    moved = MACHINE.replace("name: Wheel", "name: Idler")
    found = designs(MACHINE, moved)
    assert [(one.name, [result is not None for result in one.results]) for one in found.bearings] == [
        ("Pinion", [True, True]),
        ("Wheel", [True, False]),
        ("Idler", [False, True]),
    ]


def test_designs_without_a_bearing_in_common_are_refused_in_one_message():
    other = MACHINE.replace("name: Wheel", "name: A").replace("name: Pinion", "name: B")
    with pytest.raises(InputError, match="no bearing, operating point and clearance in common") as refused:
        designs(MACHINE, other)
    assert refused.value.code == "E004"


def test_of_different_kinds_common_results_are_compared():
    pads = load_case(EXAMPLES / "flexure_pivot.yaml")
    found = compare_designs([parse_case(FIRST), pads], ["round", "pads"])
    assert not found.one_kind
    bearing = found.bearings[0]
    assert "minimum_film_thickness" in bearing.quantities
    assert all(name in result.values for result in bearing.results for name in bearing.quantities)
    assert "different kinds" in designs_page(found)


def test_differences_of_nothing_and_of_large_changes():
    assert difference("friction_power", 1.0, 20.0) == "x 20"
    assert difference("friction_power", None, 1.0) == ABSENT
    assert difference("energy_balance_error", 1e-14, 3e-14) == "0 %"
    assert difference("attitude_angle", 0.5, 0.6) == "+5.7 °"
    assert difference("load", 9000.000052, 9000.0000055) == "0 %"
    assert difference("dissipation_error", 2.2e-16, 0.0) == "0 %"
    assert difference("energy_balance_error", -5.1e-10, -7.2e-10) == "0 %"
    assert difference("outlet_temperature", 330.0, 330.0 - 1e-9) == "+0.0 K"
    assert difference("journal_y", -41.92e-6, -82.56e-6) == "-40.6 µm"
    assert difference("stiffness_xy", -1.144e6, 0.034e6) == "+1.178 MN/m"
    assert difference("friction_power", 1000.0, 990.0) == "-1.0 %"
    assert difference("angular_speed", 12345.0 * math.pi / 30.0, 12344.0 * math.pi / 30.0) == "0.0 %"


def test_the_command_writes_all_that_it_shows(tmp_path, monkeypatch, capsys):
    files = [tmp_path / "a.yaml", tmp_path / "b.yaml"]
    for file, text in zip(files, (FIRST, SECOND), strict=True):
        file.write_text(text, encoding="utf-8")
    outputs = {name: tmp_path / f"out.{name}" for name in ("json", "csv")}
    page = tmp_path / "out.html"
    words = ["babbitt", "compare", *map(str, files), "--report", str(page)]
    words += [word for name, path in outputs.items() for word in (f"--{name}", str(path))]
    monkeypatch.setattr("sys.argv", words)
    with pytest.raises(SystemExit) as ended:
        main()
    assert not ended.value.code
    shown = capsys.readouterr().out
    assert "Changed inputs" in shown
    assert "72 mm" in shown
    record = json.loads(outputs["json"].read_text(encoding="utf-8"))
    assert record["changed_inputs"] == [{"path": "width", "values": {"a": "60 mm", "b": "72 mm"}}]
    width = record["bearings"][0]["values"]["width"]
    assert width == {"unit": "m", "a": pytest.approx(0.06), "b": pytest.approx(0.072)}
    rows = {
        row["quantity"]: row for row in csv.DictReader(outputs["csv"].read_text(encoding="utf-8").splitlines())
    }
    assert float(rows["width"]["b against a [%]"]) == pytest.approx(20.0)
    assert rows["verdict"]["a"] == record["bearings"][0]["designs"]["a"]["verdict"]
    assert "Governing check" in page.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("words", "said"), [(["--plots", "x"], "is of one file"), (["--json", "x.json"], "is of several designs")]
)
def test_options_of_the_other_comparison_are_refused(words, said, monkeypatch, capsys):
    files = [str(EXAMPLES / "journal.yaml")] * (2 if "--plots" in words else 1)
    monkeypatch.setattr("sys.argv", ["babbitt", "compare", *files, *words])
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code == 2
    assert said in capsys.readouterr().err


@pytest.mark.parametrize(
    ("language", "said"), [("de", ["Geänderte Eingaben", "b gegen a", "+20,0 %", "Größter"]), ("ru", ["b к a"])]
)
def test_the_page_is_written_in_another_language(language, said, run, tmp_path):
    (tmp_path / "a.yaml").write_text(FIRST, encoding="utf-8")
    (tmp_path / "b.yaml").write_text(SECOND + "\ndocument: {language: de}\n", encoding="utf-8")
    status, out, err = run("compare", "a.yaml", "b.yaml", "--report", "out.html", "--language", language)
    assert (status, err) == (0, "")
    assert "Changed inputs" in out
    page = (tmp_path / "out.html").read_text(encoding="utf-8")
    assert f'<html lang="{language}">' in page
    assert all(one in page for one in said)
    assert not [one for one in ("Changed", "against", "quantity", "Verdict", "+20.0 %") if one in page]


def test_the_page_is_written_in_the_language_of_the_first_case(run, tmp_path):
    (tmp_path / "a.yaml").write_text(FIRST + "\ndocument: {language: de}\n", encoding="utf-8")
    (tmp_path / "b.yaml").write_text(SECOND, encoding="utf-8")
    assert run("compare", "a.yaml", "b.yaml", "--report", "out.html")[0] == 0
    assert '<html lang="de">' in (tmp_path / "out.html").read_text(encoding="utf-8")
    status, _, err = run("compare", "a.yaml", "b.yaml", "--language", "de")
    assert (status, "--report OUT.html" in err) == (2, True)


@pytest.mark.parametrize("language", ["de", "ru"])
def test_films_footsteps_and_fed_machines_lack_no_word(language):
    pairs = [
        [(EXAMPLES / f"{name}.yaml").read_text(encoding="utf-8") for name in names]
        for names in (
            ("turbulent_turbine", "turbulent_turbine_heat"),
            ("pump_footstep", "pump_footstep_metal"),
            ("oil_system", "oil_system"),
        )
    ]
    for pair in pairs:
        found = designs(*pair)
        with written_in(language) as missing:
            page = designs_page(found)
        assert not list(missing)
        assert "has no such" not in page


def test_python_compares_objects(tmp_path):
    first = bb.parse_case(FIRST)
    found = bb.compare(first, first.replace(width=0.072))
    assert found.changed == {"width": ("60 mm", "72 mm")}
    assert found.labels == ("Textbook bearing", "Textbook bearing (2)")
    assert "+20.0 %" in repr(found)
    frame = found.to_dataframe()
    assert frame.set_index("quantity").loc["width", "Textbook bearing (2)"] == pytest.approx(0.072)
    found.report(tmp_path / "out.html", language="ru")
    assert "Изменённые исходные данные" in (tmp_path / "out.html").read_text(encoding="utf-8")
    with pytest.raises(InputError, match="from two cases on"):
        bb.compare(first)
    with pytest.raises(TypeError, match="load_case"):
        bb.compare(first, "b.yaml")


FIT = FIRST.replace("clearance: {kind: relative, mean: 1.12 permille}", "clearance: H7/e7")


@pytest.mark.parametrize("turned", [False, True])
def test_one_clearance_stands_beside_the_mean_of_several(turned):
    several = FIT + "\nclearance_cases: all\n"
    assert several != FIRST + "\nclearance_cases: all\n"
    found = designs(*([FIT, several] if turned else [several, FIT]))
    both = [one for one in found.bearings if None not in one.results]
    assert [one.name for one in both] == ["Textbook bearing (mean clearance)"]
    first, second = both[0].results
    assert first.minimum_film_thickness == pytest.approx(second.minimum_film_thickness, rel=1e-12)


def test_a_bearing_that_is_solved_at_one_clearance_keeps_its_name_beside_one_solved_at_several():
    several = MACHINE.replace(
        "1.2 permille},\n     span: 360 deg, load: 10 kN",
        "1.2 permille, minimum: 1 permille, maximum: 1.4 permille}, clearance_cases: all,\n"
        "     span: 360 deg, load: 10 kN",
    )
    assert several != MACHINE
    names = {one.name for one in designs(several, several).bearings}
    assert names == {"Wheel", *(f"Pinion ({one} clearance)" for one in ("minimum", "mean", "maximum"))}


def test_designs_of_one_bearing_without_a_common_point_are_told_what_to_name():
    slow, full = (f"{FIRST}\noperating_points: [{{name: {one}, speed: 900 rpm}}]\n" for one in ("slow", "full"))
    with pytest.raises(InputError, match="Their bearings match: give their operating points the same names"):
        designs(slow, full)


def test_changed_inputs_are_shown_in_us_units_as_they_were_given(run, tmp_path):
    """Kept in SI, they read 43.3333333333 degC; JSON stays in SI."""
    other = FIRST.replace("load: 24 kN", "load: 3000 lbf").replace("width: 60 mm", "width: 2.5 in")
    (tmp_path / "first.yaml").write_text(FIRST)
    (tmp_path / "other.yaml").write_text(other)
    status, out, _ = run("compare", "first.yaml", "other.yaml", "--units", "us", "--json", "d.json")
    assert status == 0
    cells = [[one.strip() for one in line.split("│")[1:-1]] for line in out.splitlines()]
    assert ["load", "5395.41 lbf", "3000 lbf"] in cells
    assert ["width", "2.3622 in", "2.5 in"] in cells
    recorded = {
        one["path"]: one["values"] for one in json.loads((tmp_path / "d.json").read_text())["changed_inputs"]
    }
    assert recorded["load"] == {"first": "24 kN", "other": "13.3446648458 kN"}


def test_inputs_that_differ_in_late_digits_are_shown_with_them():
    (row,) = changed_inputs([parse_case(FIRST), parse_case(FIRST.replace("load: 24 kN", "load: 24.0000001 kN"))])
    assert row.shown == ("24 kN", "24.0000001 kN")
