"""The command line holds its contract: exit statuses, standard output, nothing written on bad input."""

import csv
import json
import math
import re
import sys
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from babbitt.case import kinds, parse_case, template
from babbitt.cli import program
from babbitt.core.notices import explanations
from babbitt.export import mirrored, read_ansys, read_csv, read_json, read_ross, read_xltrc2
from babbitt.solving import solve

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
BAD = Path(__file__).parent / "case" / "bad"


def journal_with_load(load: str) -> str:
    """The journal template with another load."""
    found, count = re.subn(r"(?m)^load: \S+ \S+", f"load: {load}", template("journal"))
    assert count == 1
    return found


@pytest.mark.parametrize("kind", kinds())
def test_a_new_case_runs_as_it_stands(run, kind, tmp_path):
    status, out, _ = run("new", kind, "-o", "case.yaml")
    assert (status, out) == (0, "")
    status, out, err = run("solve", "case.yaml")
    assert status == 0, err
    assert out.strip()
    status, out, _ = run("check", "case.yaml")
    assert status == 0
    assert "usable" in out


def test_new_overwrites_nothing(run, tmp_path):
    (tmp_path / "case.yaml").write_text("mine")
    status, _, err = run("new", "journal", "-o", "case.yaml")
    assert status == 2
    assert "exists already" in err
    assert (tmp_path / "case.yaml").read_text() == "mine"


def test_json_on_standard_output_is_alone_there(run, tmp_path):
    (tmp_path / "case.yaml").write_text(template("journal"))
    status, out, _ = run("solve", "case.yaml", "--json", "-")
    assert status == 0
    record = json.loads(out)
    assert set(record) >= {"babbitt", "case", "bearings"}
    bearing = record["bearings"][0]
    assert set(bearing) >= {"name", "kind", "method", "results", "checks", "warnings"}
    assert 300.0 < bearing["results"]["outlet_temperature"] < 400.0  # kelvin


def test_no_solution_ends_with_three_and_says_what_to_try(run, tmp_path):
    (tmp_path / "case.yaml").write_text(journal_with_load("900 MN"))
    status, out, _ = run("solve", "case.yaml")
    assert status == 3
    assert "no film can carry this load" in out
    assert "less than the load of 900000 kN" in " ".join(out.split())
    assert "Try: a wider or larger bearing" in " ".join(out.split())
    assert run("compare", "case.yaml")[0] == 3


def test_strict_ends_with_one_when_a_limit_is_violated(run, tmp_path):
    (tmp_path / "case.yaml").write_text(journal_with_load("60 kN"))
    assert run("solve", "case.yaml")[0] == 0
    assert run("solve", "case.yaml", "--strict")[0] == 1


@pytest.mark.parametrize("path", sorted(BAD.glob("*.yaml")), ids=lambda path: path.stem)
def test_bad_input_ends_with_two_and_writes_nothing(run, path, tmp_path):
    status, out, err = run("solve", path, "--json", "out.json", "--report", "out.html", "--plots", "plots")
    assert status == 2
    assert out == ""
    assert err.strip()
    assert "Traceback" not in err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("solve", "nowhere.yaml"), "nowhere.yaml"),
        (("solve", "case.yaml", "--report", "out.docx"), ".pdf or .html"),
        (("solve", "case.yaml", "--json", "no/such/folder.json"), "does not exist"),
        (("solve", "case.yaml", "--json", "case.yaml/out.json"), "case.yaml is a file, no folder"),
        (("solve", "case.yaml", "case.yaml", "--json", "-"), "folder"),
        (("new", "gearbox"), "journal"),
        (("explain", "W1011"), "W101"),
        (("list", "oils"), "lubricants"),
        (("solve", "case.yaml", "--json", "case.yaml"), "a case file"),
        (("solve", "case.yaml", "--json", "x.pdf", "--report", "x.pdf"), "another output"),
        (("solve", "case.yaml", "--json", "ok.json", "--report", "/proc/x.pdf"), "/proc/x.pdf"),
        (("solve", "case.yaml", "--plots", "case.yaml"), "a case file"),
        (("validate", "butenschon"), "butenschoen"),
    ],
)
def test_mistakes_on_the_command_line(run, tmp_path, arguments, words):
    (tmp_path / "case.yaml").write_text(template("journal"))
    status, out, err = run(*arguments)
    assert status == 2
    assert out == ""
    assert words in err
    assert "Traceback" not in err
    assert [path.name for path in tmp_path.iterdir()] == ["case.yaml"]


@pytest.mark.parametrize("what", ["lubricants", "materials", "kinds", "cases"])
def test_lists_show_what_is_included(run, what):
    status, out, _ = run("list", what)
    assert status == 0
    expected = {"lubricants": "ISO VG 46", "materials": "B83", "kinds": "machine", "cases": "reverse_gear"}
    assert expected[what] in out


def test_compare_says_where_a_kind_has_no_figure(run, tmp_path):
    pytest.importorskip("matplotlib")
    (tmp_path / "pad.yaml").write_text(template("hydrostatic_pad"))
    status, _, err = run("compare", "pad.yaml", "--plots", "figures")
    assert status == 0
    assert "--plots: 0 of 1 comparisons have a figure; the others have tables alone (kind hydrostatic" in err
    assert not (tmp_path / "figures").exists()


def test_compare_puts_the_variants_side_by_side(run, tmp_path):
    full = template("journal")
    (tmp_path / "full.yaml").write_text(full)
    (tmp_path / "half.yaml").write_text(full.replace("span: 360 deg", "span: 180 deg"))
    status, out, _ = run("compare", "full.yaml")
    assert status == 0
    assert "ISO 7902" in out
    assert "film, Reynolds" in out
    assert "closed forms" in out
    status, out, _ = run("compare", "half.yaml")
    assert status == 0
    assert "film on the arc" in out


def test_cite_names_the_standard_and_the_lubricant(run, tmp_path):
    (tmp_path / "case.yaml").write_text(template("journal"))
    status, out, _ = run("cite", "case.yaml")
    assert status == 0
    assert "ISO 7902-1:2020" in out
    assert "ASTM D341" in out


@pytest.mark.parametrize(
    ("oil", "by_index"),
    [
        ("ISO VG 46", True),
        ("{kind: viscosity_index, nu40: 46 mm2/s, viscosity_index: 95}", True),
        ("IPM-10", False),
        ("{kind: two_points, nu40: 46 mm2/s, nu100: 6.8 mm2/s}", False),
    ],
)
def test_cite_names_the_viscosity_index_where_a_viscosity_follows_from_it(run, tmp_path, oil, by_index):
    text = template("journal")
    assert "\nlubricant: ISO VG 46" in text
    (tmp_path / "case.yaml").write_text(text.replace("\nlubricant: ISO VG 46", f"\nlubricant: {oil}"))
    status, out, _ = run("cite", "case.yaml")
    assert status == 0
    assert ("ISO 2909" in out) is by_index


def test_cite_names_every_law_that_the_film_takes(run, tmp_path):
    film = GROOVED.replace("effective_temperature: 60 degC\n", "") + "thermal: adiabatic\nturbulence: ng_pan\n"
    (tmp_path / "film.yaml").write_text(film)
    status, out, _ = run("cite", "film.yaml")
    assert status == 0
    assert all(author in out for author in ("Ng, Pan", "Dowson", "Reynolds", "Lund"))
    assert out.count("Reynolds: On the theory") == 1


def test_explain_and_version(run):
    assert "Reynolds" in run("explain", "w101")[1]
    both = run("explain", "w101", "C104")[1]
    assert both == f"{run('explain', 'W101')[1]}\n{run('explain', 'C104')[1]}"
    assert run("--version")[1].startswith("babbitt ")


def test_the_reverse_gear_has_eleven_bearings(run):
    status, out, _ = run("solve", EXAMPLES / "marine_reverse_gear.yaml", "--json", "-")
    assert status == 0
    assert len(json.loads(out)["bearings"]) == 11


def test_names_are_never_markup(run, tmp_path):
    text = template("journal").replace("name: Example bearing", "name: 'B [/b] x [rated]'")
    (tmp_path / "case.yaml").write_text(text)
    for command in ("solve", "compare"):
        status, out, _ = run(command, "case.yaml")
        assert status == 0
        assert "B [/b] x [rated]" in out


def test_two_cases_of_one_name_do_not_overwrite_each_other(run, tmp_path):
    for folder in ("a", "b", "out"):
        (tmp_path / folder).mkdir()
    for folder in ("a", "b"):
        (tmp_path / folder / "x.yaml").write_text(template("journal"))
    status, out, err = run("solve", "a/x.yaml", "b/x.yaml", "--json", "out")
    assert (status, out) == (2, "")
    assert "another output" in err
    assert list((tmp_path / "out").iterdir()) == []


def test_check_tells_the_good_files_and_the_bad(run, tmp_path):
    (tmp_path / "good.yaml").write_text(template("journal"))
    (tmp_path / "bad.yaml").write_text("kind: journal\n")
    status, out, err = run("check", "bad.yaml", "good.yaml")
    assert status == 2
    assert "good.yaml: usable" in out
    assert "bad.yaml" in err


def test_several_files_need_a_folder_and_fill_it(run, tmp_path):
    (tmp_path / "one.yaml").write_text(template("journal"))
    (tmp_path / "two.yaml").write_text(template("overhung_coupling"))
    (tmp_path / "out").mkdir()
    status, _, err = run("solve", "one.yaml", "two.yaml", "--json", "out")
    assert status == 0, err
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["one.json", "two.json"]


def film_journal(**fields) -> str:
    """A grooved bearing for the film method; a field that is None is left out."""
    lines = {
        "kind": "journal",
        "name": "Pump",
        "method": "film",
        "diameter": "200 mm",
        "width": "120 mm",
        "clearance": "{kind: relative, mean: 1.5 permille}",
        "grooves": "[{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]",
        "materials": "{bearing: C10, journal: C45}",
        "lubricant": "ISO VG 46",
        "supply": "{temperature: 45 degC, pressure: 0.15 MPa}",
        "load": "30 kN",
        "speed": "3000 rpm",
    } | fields
    return "".join(f"{name}: {value}\n" for name, value in lines.items() if value is not None)


@pytest.mark.parametrize(
    ("format_name", "suffix", "read"),
    [
        ("ross2", ".json", partial(read_ross, version=2)),
        ("ross3", ".toml", partial(read_ross, version=3)),
        ("xltrc2", ".csv", read_xltrc2),
        ("ansys", ".txt", read_ansys),
        ("csv", ".csv", lambda path: read_csv(path)[0]),
        ("json", ".json", lambda path: read_json(path)[0]),
    ],
)
def test_export_writes_every_format_and_declares_the_frame(run, tmp_path, format_name, suffix, read):
    (tmp_path / "case.yaml").write_text(film_journal())
    out_file = tmp_path / f"table{suffix}"
    arguments = ("export", "case.yaml", "--format", format_name, "--speeds", "1000 rpm:3000 rpm:5", "-o", out_file)
    status, out, err = run(*arguments)
    assert (status, out) == (0, ""), err
    assert "5 speeds; rotation counter-clockwise, x axis at 0 deg, load at -90 deg" in err
    table = read(out_file)
    assert table.frame.rotation.value == "counter-clockwise"
    film = solve(parse_case(film_journal()))["Pump"]
    assert table.speeds[-1] == pytest.approx(3000.0 * math.pi / 30.0, rel=1e-6)
    assert table.stiffness[-1] == pytest.approx(np.array(film.stiffness), rel=1e-6)
    assert table.damping[-1] == pytest.approx(np.array(film.damping), rel=1e-6)


@pytest.mark.parametrize("kind", ["frozen", "following"])
def test_export_says_for_which_temperatures_its_coefficients_hold(run, tmp_path, kind):
    text = film_journal(thermal="full", temperature_coefficients=kind)
    (tmp_path / "case.yaml").write_text(text)
    status, _, err = run("export", "case.yaml", "--format", "csv", "--speeds", "3000 rpm", "-o", "table.csv")
    assert status == 0, err
    assert ("for whirl and vibration export" in err) is (kind == "following")
    (table,) = read_csv(tmp_path / "table.csv")
    assert f"temperatures: {table.temperatures}" in err
    assert kind in table.temperatures
    assert table.stiffness[0] == pytest.approx(np.array(solve(parse_case(text))["Pump"].stiffness), rel=1e-9)


def test_export_without_a_following_stiffness_writes_nothing(run, tmp_path, monkeypatch):
    monkeypatch.setattr("babbitt.kinds.journal.film.thermal_results.following_stiffness", lambda *_: None)
    (tmp_path / "case.yaml").write_text(film_journal(thermal="full", temperature_coefficients="following"))
    status, _, err = run("export", "case.yaml", "--format", "csv", "--speeds", "3000 rpm", "-o", "table.csv")
    assert status == 3
    assert "no stiffness with following temperatures at 3000 rpm" in err
    assert not (tmp_path / "table.csv").exists()


def test_export_of_a_clockwise_bearing_needs_a_decision(run, tmp_path):
    (tmp_path / "case.yaml").write_text(film_journal(speed="-3000 rpm"))
    common = ("export", "case.yaml", "--speeds", "2000 rpm")
    status, out, err = run(*common, "--format", "ansys", "-o", "table.txt")
    assert (status, out) == (2, "")
    assert "--other-end" in err
    assert not (tmp_path / "table.txt").exists()
    assert run(*common, "--format", "ansys", "-o", "table.txt", "--other-end")[0] == 0
    assert run(*common, "--format", "csv", "-o", "table.csv")[0] == 0
    (clockwise,) = read_csv(tmp_path / "table.csv")
    seen = read_ansys(tmp_path / "table.txt")
    assert clockwise.frame.rotation.value == "clockwise"
    assert seen.frame.rotation.value == "counter-clockwise"
    assert seen.stiffness[0] == pytest.approx(mirrored(clockwise).stiffness[0], rel=1e-6)


def test_export_without_equilibrium_ends_with_three_and_writes_nothing(run, tmp_path):
    (tmp_path / "case.yaml").write_text(film_journal(load="300 MN", effective_temperature="60 degC"))
    status, out, err = run(
        "export", "case.yaml", "--format", "csv", "--speeds", "0.1 rpm, 1 rpm", "-o", "table.csv"
    )
    assert (status, out) == (3, "")
    assert "at 0.1 rpm" in err
    assert "nothing was written" in err
    assert not (tmp_path / "table.csv").exists()


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"--format": "ross"}, "ross2, ross3"),
        ({"--format": "ross3", "-o": "table.csv"}, ".json or .toml"),
        ({"--format": "ross3", "-o": "table.json"}, "at least 5 speeds, and 1 is given; write more"),
        ({"--speeds": "fast"}, "--speeds 'fast'"),
        ({"--bearing": "Pmup"}, "there are: Pump"),
        ({"-o": "nowhere/table.csv"}, "does not exist"),
        ({"-o": "case.csv", "case": "case.csv"}, "case file"),
        ({"case": "standard.yaml"}, "method: film"),
        ({"case": "two.yaml"}, "several operating points; choose with --bearing: Pump [a], Pump [b]"),
        ({"case": "senses.yaml"}, "several operating points; choose with --bearing: Pump [a], Pump [b]"),
        ({"case": "clearances.yaml"}, "several clearances; choose with --bearing"),
    ],
)
def test_mistakes_of_export(run, tmp_path, changed, words):
    points = "[{name: a, load: 20 kN}, {name: b, load: 10 kN}]"
    wide = "{kind: relative, mean: 1.5 permille, minimum: 1.4 permille, maximum: 1.6 permille}"
    senses = "[{name: a, speed: 900 rpm}, {name: b, speed: -900 rpm}]"
    for name, text in (
        ("case.yaml", film_journal()),
        ("case.csv", film_journal()),
        ("standard.yaml", template("journal")),
        ("two.yaml", film_journal(load=None, operating_points=points)),
        ("senses.yaml", film_journal(speed=None, operating_points=senses)),
        ("clearances.yaml", film_journal(clearance=wide, clearance_cases="all")),
    ):
        (tmp_path / name).write_text(text)
    given = {"case": "case.yaml", "--format": "csv", "--speeds": "1000 rpm", "-o": "table.csv"} | changed
    status, out, err = run("export", given.pop("case"), *(word for pair in given.items() for word in pair))
    assert (status, out) == (2, "")
    assert words in err
    assert not (tmp_path / "table.csv").exists()


def test_operating_points_that_differ_in_speed_alone_are_one_bearing(run, tmp_path):
    points = "[{name: a, speed: 900 rpm}, {name: b, speed: 1800 rpm}]"
    fields = {"effective_temperature": "60 degC", "load": "30 kN"}
    (tmp_path / "case.yaml").write_text(film_journal(speed=None, operating_points=points, **fields))
    (tmp_path / "plain.yaml").write_text(film_journal(speed="900 rpm", **fields))
    for case, chosen in (("plain", ()), ("case", ()), ("case", ("--bearing", "Pump"))):
        common = (f"{case}.yaml", "--format", "json", "--speeds", "1200 rpm", "-o", f"{case}.json")
        status, _, err = run("export", *common, *chosen)
        assert status == 0, err
    assert (tmp_path / "case.json").read_text() == (tmp_path / "plain.json").read_text()
    status, _, err = run(
        "export", "case.yaml", "--format", "csv", "--speeds", "1200 rpm", "-o", "b.csv", "--bearing", "Pump [b]"
    )
    assert status == 0, err


def test_export_says_which_warnings_question_a_speed(run, tmp_path):
    fields = {"effective_temperature": "60 degC"}
    (tmp_path / "case.yaml").write_text(film_journal(**fields))
    status, _, err = run(
        "export", "case.yaml", "--format", "csv", "--speeds", "3000 rpm, 25000 rpm", "-o", "table.csv"
    )
    assert status == 0, err
    (table,) = read_csv(tmp_path / "table.csv")
    assert table.warnings[0] == solve(parse_case(film_journal(**fields)))["Pump"].questioning_codes
    assert "W101" not in table.warnings[0]
    assert "W101" in table.warnings[1]  # not laminar
    assert f"25000 rpm: {' '.join(table.warnings[1])}" in err
    assert "(no verdict)" in err


def test_the_help_of_export_names_the_endings_of_every_format(run):
    from babbitt.export import FORMATS

    status, out, _ = run("export", "--help")
    words = " ".join(out.replace("│", " ").split())
    assert status == 0
    for one in FORMATS.values():
        assert f"{one.name} ({' or '.join(one.suffixes)})" in words
    assert "of tilting pads" in words


def test_links_and_devices_stay_what_they_are(run, tmp_path):
    (tmp_path / "case.yaml").write_text(template("journal"))
    assert run("solve", "case.yaml", "--json", "target.json")[0] == 0
    before = (tmp_path / "target.json").stat().st_ino
    (tmp_path / "link.json").symlink_to(tmp_path / "target.json")
    assert run("solve", "case.yaml", "--json", "link.json")[0] == 0
    assert (tmp_path / "link.json").is_symlink()
    assert json.loads((tmp_path / "target.json").read_text())["bearings"]
    assert (tmp_path / "target.json").stat().st_ino != before  # replaced as a whole
    (tmp_path / "pipe").symlink_to("/dev/null")
    assert run("solve", "case.yaml", "--json", "pipe")[0] == 0
    assert Path("/dev/null").is_char_device()


def test_check_tells_digits_that_may_be_grouped(run, tmp_path):
    text = re.sub(r"(?m)^speed: \S+ \S+", "speed: 2.000 rpm", template("journal"))
    (tmp_path / "case.yaml").write_text(text)
    status, out, _ = run("check", "case.yaml")
    assert status == 0
    assert "W181" in out


def test_brackets_in_the_name_of_an_operating_point_make_no_bearing(run, tmp_path):
    points = "operating_points: [{name: 'p [1]'}, {name: q, speed: 1500 rpm}]\n"
    (tmp_path / "case.yaml").write_text(template("journal") + points)
    status, out, _ = run("solve", "case.yaml")
    assert status == 0
    assert "Total of" not in out


GROOVED = """\
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
load: 30 kN
speed: 3000 rpm
"""

TWO_FILMS = """\
kind: machine
name: Pair
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.15 MPa}
materials: {bearing: C10, journal: C45}
bearings:
  - &one
    kind: journal
    name: drive / free end
    method: film
    diameter: 200 mm
    width: 120 mm
    clearance: {kind: relative, mean: 1.5 permille}
    grooves: [{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]
    load: 30 kN
    speed: 3000 rpm
  - {<<: *one, name: overloaded, load: 90 MN}
  - {<<: *one, name: gear end, load: 20 kN}
"""


def test_a_sweep_prints_one_line_a_value_and_writes_csv_and_plot(run, tmp_path):
    (tmp_path / "film.yaml").write_text(GROOVED)
    outputs = ("--csv", "load.csv", "--plot", "load.svg")
    status, out, err = run("sweep", "film.yaml", "load", "10 kN:50 kN:3", *outputs)
    assert status == 0, err
    lines = out.splitlines()
    assert "load" in lines[1]
    assert lines[2].split()[0] == "kN"
    assert [line.split()[0] for line in lines[4:7]] == ["10", "30", "50"]
    rows = list(csv.DictReader((tmp_path / "load.csv").read_text().splitlines()))
    assert [float(row["load [kN]"]) for row in rows] == [10.0, 30.0, 50.0]
    assert {row["status"] for row in rows} == {"converged"}
    alone = solve(parse_case(GROOVED)).results[0]
    assert float(rows[1]["minimum_film_thickness_m"]) == pytest.approx(alone.minimum_film_thickness, rel=1e-9)
    assert float(rows[1]["stiffness_xx_N_per_m"]) == pytest.approx(alone.stiffness_xx, rel=1e-9)
    assert (tmp_path / "load.svg").read_text().lstrip().startswith("<?xml")


def test_a_sweep_leaves_cells_empty_where_there_is_no_film(run, tmp_path):
    (tmp_path / "film.yaml").write_text(GROOVED)
    status, out, _ = run("sweep", "film.yaml", "load", "30 kN, 90 MN", "--csv", "load.csv")
    assert status == 3
    assert "load 90 MN, Grooved: no film can carry this load" in " ".join(out.split())
    _, row = csv.DictReader((tmp_path / "load.csv").read_text().splitlines())
    for code in row["codes"].split():
        assert f"{code} {explanations()[code].title}" in " ".join(out.split())
    assert row["status"] in ("overloaded", "not_converged")
    assert row["minimum_film_thickness_m"] == ""


def test_a_sweep_and_a_size_of_a_machine_name_its_bearings(run, tmp_path):
    gear = EXAMPLES / "marine_reverse_gear.yaml"
    status, out, _ = run("sweep", gear, "supply.temperature", "45 degC, 50 degC")
    assert status == 0
    assert out.count("Output wheel") == 2
    status, out, _ = run("sweep", gear, "load", "300 kN, 350 kN", "--bearing", "Output wheel")
    assert status == 0
    assert "First-stage" not in out
    status, out, _ = run("size", gear, "load", "--bearing", "Output wheel", "--points", 5, "--json", "a.json")
    assert status == 0
    assert "bearings.Output wheel.load within all limits" in out
    assert json.loads((tmp_path / "a.json").read_text())["field"] == "bearings.Output wheel.load"


def test_a_sweep_of_two_fields_by_two_processes_with_columns_of_choice(run, tmp_path):
    (tmp_path / "case.yaml").write_text(template("journal"))
    fields = ("load", "4 kN:16 kN:3:log", "lubricant", "ISO VG 32, ISO VG 68")
    options = ("--columns", "friction_power, total_flow", "--engineering", "--plot", "a.png")
    status, out, err = run("sweep", "case.yaml", *fields, *options, "--csv", "a.csv")
    assert (status, err) == (0, "")
    assert run("sweep", "case.yaml", *fields, *options, "--csv", "b.csv", "--workers", "2")[:2] == (status, out)
    assert (tmp_path / "a.csv").read_text() == (tmp_path / "b.csv").read_text()
    rows = list(csv.DictReader((tmp_path / "a.csv").read_text().splitlines()))
    assert [float(row["load [kN]"]) for row in rows] == pytest.approx([4.0, 4.0, 8.0, 8.0, 16.0, 16.0])
    assert [row["lubricant"] for row in rows] == ["ISO VG 32", "ISO VG 68"] * 3
    for thin, thick in zip(rows[::2], rows[1::2], strict=True):
        assert float(thin["friction_power [kW]"]) < float(thick["friction_power [kW]"])
    heavy = template("journal").replace("load: 12 kN", "load: 16 kN").replace("ISO VG 46", "ISO VG 68")
    result = solve(parse_case(heavy)).results[0]
    assert float(rows[-1]["friction_power [kW]"]) == pytest.approx(1e-3 * result.friction_power, rel=1e-9)
    assert float(rows[-1]["margin"]) == pytest.approx(result.margin, rel=1e-9)
    assert (rows[-1]["governing_check"], rows[-1]["verdict"]) == (result.governing_check.code, result.verdict.key)
    assert "h_min" not in out
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


def test_values_of_a_sweep_may_be_negative(run, tmp_path):
    (tmp_path / "film.yaml").write_text(GROOVED)
    status, out, err = run("sweep", "film.yaml", "load_angle", "-120 deg:-60 deg:3")
    assert status == 0, err
    assert [line.split()[0] for line in out.splitlines()[4:7]] == ["-120", "-90", "-60"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("load", "1 kN:2 rpm:3"), "kind of '1 kN'"),
        (("laod", "1 kN, 2 kN"), "did you mean 'load'"),
        (("load", "2 m, 3 m"), "a length"),
        (("lubricant.x", "1, 2"), "not a mapping"),
        (("load", "1 kN", "--bearing", "Nobody"), "there are: Grooved"),
        (("load", "1 kN", "--plot", "out.docx"), ".png, .svg or .pdf"),
        (("load", "1 kN", "--csv", "film.yaml"), "a case file"),
        (("load", "1 kN", "--csv", "x.svg", "--plot", "x.svg"), "another output"),
        (("load", "1 kN", "--csv", "none/x.csv"), "does not exist"),
        (("load", "1 kN", "speed"), "'speed' has none"),
        (("--field", "load", "--from", "1 kN"), "no option --field"),
        (("load", "1 kN", "load", "2 kN"), "named twice"),
        (("load", "1 kN:9 kN:30", "speed", "1 rpm:9 rpm:30"), "900 rows"),
        (("load", "-1 kN:9 kN:3:log"), "equal ratios"),
        (("load", "1 kN", "--columns", "friction_powr"), "did you mean 'friction_power'"),
    ],
)
def test_mistakes_in_a_sweep_are_told_and_nothing_is_written(run, tmp_path, arguments, words):
    (tmp_path / "film.yaml").write_text(GROOVED)
    status, out, err = run("sweep", "film.yaml", *arguments)
    assert status == 2
    assert out == ""
    assert words in err
    assert [path.name for path in tmp_path.iterdir()] == ["film.yaml"]


def test_fields_of_one_film_stand_at_the_root_of_the_file(run, tmp_path):
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("h5netcdf")
    (tmp_path / "film.yaml").write_text(GROOVED)
    assert run("solve", "film.yaml", "--fields", "film.nc")[0] == 0
    with xarray.open_dataset(tmp_path / "film.nc") as found:
        assert found.attrs["title"] == "Grooved"
        assert found.pressure.attrs["units"] == "Pa"
        assert float(found.pressure.max()) == pytest.approx(float(found.maximum_pressure), rel=0.01)


def test_fields_of_several_films_stand_in_groups_and_unsolved_ones_are_told(run, tmp_path):
    xarray = pytest.importorskip("xarray")
    h5netcdf = pytest.importorskip("h5netcdf")
    (tmp_path / "pair.yaml").write_text(TWO_FILMS)
    status, _, err = run("solve", "pair.yaml", "--fields", "pair.nc")
    assert status == 3
    assert "overloaded: no operating point, so no fields are saved" in err
    with h5netcdf.File(tmp_path / "pair.nc", "r") as file:
        assert set(file.groups) == {"drive - free end", "gear end"}
        assert file.attrs["title"] == "Pair"
    with xarray.open_dataset(tmp_path / "pair.nc", group="gear end") as found:
        assert float(found["load"]) == pytest.approx(20e3)


def test_several_files_give_one_file_of_fields_each(run, tmp_path):
    pytest.importorskip("h5netcdf")
    for name in ("a", "b"):
        (tmp_path / f"{name}.yaml").write_text(GROOVED)
    (tmp_path / "out").mkdir()
    assert run("solve", "a.yaml", "b.yaml", "--fields", "out")[0] == 0
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["a.nc", "b.nc"]


def test_a_film_without_operating_point_leaves_no_fields(run, tmp_path):
    pytest.importorskip("h5netcdf")
    (tmp_path / "film.yaml").write_text(GROOVED.replace("30 kN", "90 MN"))
    status, _, err = run("solve", "film.yaml", "--fields", "film.nc")
    assert status == 3
    assert "no fields are saved" in err
    assert not (tmp_path / "film.nc").exists()


@pytest.mark.parametrize(
    ("package", "option", "name"), [("typst", "--report", "out.pdf"), ("matplotlib", "--plots", "out")]
)
def test_a_missing_extra_is_told_before_anything_is_solved(run, tmp_path, monkeypatch, package, option, name):
    (tmp_path / "case.yaml").write_text(template("journal"))
    monkeypatch.setitem(sys.modules, package, None)
    status, out, err = run("solve", "case.yaml", "--json", "out.json", option, name)
    assert (status, out) == (2, "")
    assert f"pip install {package}" in err
    assert not (tmp_path / "out.json").exists()


def test_fields_need_a_film_a_suffix_and_their_extra(run, tmp_path, monkeypatch):
    (tmp_path / "film.yaml").write_text(GROOVED)
    (tmp_path / "journal.yaml").write_text(template("journal"))
    for arguments, words in (
        (("journal.yaml", "--fields", "out.nc"), "method: film"),
        (("film.yaml", "--fields", "out.csv"), ".nc"),
        (("film.yaml", "journal.yaml", "--fields", "out.nc"), "name a folder"),
    ):
        status, out, err = run("solve", *arguments)
        assert (status, out) == (2, "")
        assert words in err
    monkeypatch.setitem(sys.modules, "xarray", None)
    status, out, err = run("solve", "film.yaml", "--fields", "out.nc")
    assert (status, out) == (2, "")
    assert "pip install '.[files]' in a clone of Babbitt, or pip install xarray" in err
    assert not list(tmp_path.glob("out*"))


def test_help_lists_commands_in_the_order_of_a_job(run):
    _, shown, _ = run("--help")
    places = [
        shown.index(f" {name} ") for name in ("new", "check", "solve", "compare", "study", "export", "upgrade")
    ]
    assert places == sorted(places)


def test_commands_without_a_place_of_their_own_follow_in_the_order_they_have(monkeypatch):
    others = [f"other{number}" for number in range(20)]
    names = [*others, *program.FIRST]
    monkeypatch.setattr(program, "get_command", lambda _: SimpleNamespace(commands=dict.fromkeys(names)))
    assert list(program._command.__wrapped__().commands) == [*program.FIRST, *others]


def test_no_help_loses_words_to_markup():
    """Brackets of a unit are no markup: `diameter [mm]` read `diameter`."""
    from rich.text import Text
    from typer.main import get_command

    from babbitt.cli.program import app

    for command in get_command(app).commands.values():
        for said in (command.help, *(getattr(one, "help", None) for one in command.params)):
            assert Text.from_markup(said or "").plain == (said or "").replace("\\[", "[")
