"""Bearings in the rows of a table: equal to each solved by itself, and numbers that are never misread."""

from __future__ import annotations

import io
import math

import numpy as np
import pytest
import yaml
from studied_cases import JOURNAL

import babbitt
from babbitt.case import parse_case
from babbitt.core.notices import InputError
from babbitt.core.result import Verdict
from babbitt.solving import solve
from babbitt.study.table_cells import read_table, table_of_columns, table_of_content
from babbitt.study.table_rows import rows_of_table

TABLE = """name;diameter [mm];width [mm];load [kN];speed [rpm];lubricant
Gear;120;60;24;2000;ISO VG 46
Fan;100,5;50,25;12,5;1500;ISO VG 32
Pump;140;60;18;;
"""


@pytest.fixture
def case(tmp_path):
    file = tmp_path / "case.yaml"
    file.write_text(yaml.safe_dump(JOURNAL, sort_keys=False))
    return file


def in_file(path, text):
    path.write_text(text)
    return path


def numbers(text):
    table = table_of_content("t.csv", ".csv", text.encode())
    return table.with_points(range(len(table.headings)))


def test_each_row_is_the_bearing_solved_by_itself(case, tmp_path):
    bearing = babbitt.load_case(case)
    found = bearing.solve_table(in_file(tmp_path / "t.csv", TABLE)).table
    rows = [
        {"diameter": "120 mm", "width": "60 mm", "load": "24 kN", "speed": "2000 rpm", "lubricant": "ISO VG 46"},
        {"diameter": "100.5 mm", "width": "50.25 mm", "load": "12.5 kN", "speed": "1500 rpm",
         "lubricant": "ISO VG 32"},
        {"diameter": "140 mm", "width": "60 mm", "load": "18 kN"},  # empty cells: what the case says
    ]  # fmt: skip
    alone = [bearing.solve(**row) for row in rows]
    by_margins = [solve(parse_case(bearing.replace(**row).to_yaml()), only=()).results[0] for row in rows]
    assert list(found["bearing"]) == ["Gear", "Fan", "Pump"]
    for place, one in enumerate(alone):
        assert found["minimum_film_thickness"][place] == one.minimum_film_thickness
        assert found["friction_power"][place] == one.friction_power
        assert found["margin"][place] == one.result.margin
        assert found["governing_check"][place] == one.governing_check.code
        assert found["verdict"][place] == by_margins[place].verdict.key  # of many rows no film is solved
        assert one.verdict in (by_margins[place].verdict, Verdict.PASS)


def test_a_bad_row_is_reported_and_stops_nothing(run, case, tmp_path):
    rows = "name,diameter [mm],load [kN]\nGood,120,24\nBad,12O,24\nThin,0.0001,24\nHeavy,120,90000\n"
    table = in_file(tmp_path / "t.csv", rows)
    status, out, _ = run("solve", case, "--table", table, "--workers", 1)
    assert status == 3
    good, bad, thin, heavy = (
        next(line for line in out.splitlines() if name in line) for name in ("Good", "Bad", "Thin", "Heavy")
    )
    assert "pass" in good
    assert "refused" in bad
    assert "refused" in thin
    assert "no solution" in heavy
    assert "12O mm" in out
    assert "or less load" in " ".join(out.split())


def test_outputs_in_engineers_units(run, case, tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    table = in_file(tmp_path / "t.csv", TABLE)
    status, _, err = run("solve", case, "--table", table, "--csv", "o.csv", "--xlsx", "o.xlsx", "--workers", 1)
    assert (status, err) == (0, "")
    heading, gear, *_ = (tmp_path / "o.csv").read_text().splitlines()
    read = dict(zip(heading.split(","), gear.split(","), strict=True))
    assert float(read["diameter [mm]"]) == 120.0
    assert read["verdict"] in ("pass", "pass with remarks")
    assert read["governing_check"].startswith("C")
    film = babbitt.load_case(case).solve(diameter="120 mm", width="60 mm", load="24 kN").minimum_film_thickness
    assert float(read["minimum_film_thickness [µm]"]) == pytest.approx(1e6 * film, rel=1e-11)
    book = openpyxl.load_workbook(io.BytesIO((tmp_path / "o.xlsx").read_bytes()))
    assert book.sheetnames == ["Summary", "Inputs", "Results"]


def test_a_workbook_gives_the_same_as_text(case, tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    for row in (["diameter [mm]", "load [kN]"], [120, 24], [100.5, "12,5"]):
        book.active.append(row)
    book.save(tmp_path / "t.xlsx")
    bearing = babbitt.load_case(case)
    of_book = bearing.solve_table(tmp_path / "t.xlsx").table
    of_program = bearing.solve_table({"diameter": [0.12, 0.1005], "load [kN]": [24.0, 12.5]}).table
    assert (of_book["diameter"] == of_program["diameter"]).all()
    assert (of_book["friction_power"] == of_program["friction_power"]).all()


def test_a_workbook_with_a_date_is_refused(tmp_path):
    openpyxl = pytest.importorskip("openpyxl")
    import datetime

    book = openpyxl.Workbook()
    book.active.append(["load [kN]"])
    book.active.append([datetime.date(2020, 5, 1)])
    book.save(tmp_path / "t.xlsx")
    with pytest.raises(InputError, match="A2 is a date"):
        read_table(tmp_path / "t.xlsx")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("load [kN];x\n12,5;1\n1,234;2\n", "1.234"),  # 12,5 tells what the comma is
        ("load [kN];x\n0,125;1\n", "0.125"),
        ("load [kN],x\n1.234,1\n", "1.234"),
        ("load [kN]\tx\n1234\t1\n", "1234"),
        ('sep=;\nload [kN];x\n1,5;"a;b"\n', "1.5"),
        ("load [kN],x\n1.5e-3,1\n", "1.5e-3"),
    ],
)
def test_decimals_are_read(text, expected):
    assert numbers(text)[0][-1] == expected


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("load [kN];x\n1,234;1\n", "may be 1.2340 or 1234"),
        ("load [kN];x\n12.000;1\n", "may be 12.0000 or 12000"),
        ("load [kN];x\n1,5;1.5\n", "with a comma"),
        ("load [kN];x\n1.234,5;1\n", "a comma and a point"),
        ("load [kN];x\n1,234,567;1\n", "separators of thousands"),
        ("load [kN],x\n12,5,1\n", "semicolons"),
        ('load [kN],x\n"12,5",1\n', "semicolons"),
        ("load [kN],\n1,2\n", "cells under"),
        ("\n\n", "is empty"),
        ("load [kN]\n", "no rows"),
    ],
)
def test_what_may_be_misread_is_refused_with_a_hint(text, hint):
    with pytest.raises(InputError, match=hint):
        numbers(text)


@pytest.mark.parametrize(
    ("heading", "says"),
    [
        ("diamter [mm]", "did you mean 'diameter'"),
        ("diameter [kN]", "force"),
        ("lubricant [mm]", "takes no quantity"),
        ("diameter [mm],diameter [m]", "two columns"),
    ],
)
def test_a_heading_that_means_nothing_is_refused(case, heading, says):
    cells = {name: [1.0] for name in heading.split(",")}
    with pytest.raises(InputError, match=says):
        babbitt.load_case(case).solve_table(cells)


def test_a_number_without_unit_is_refused_in_its_row(case, tmp_path):
    found = babbitt.load_case(case).solve_table(in_file(tmp_path / "t.csv", "diameter\n120\n120 mm\n")).table
    assert list(found["status"]) == ["refused", "converged"]
    assert "has no unit" in found["message"][0]


def test_columns_of_different_lengths_are_refused():
    with pytest.raises(InputError, match="'a' 1, 'b' 2"):
        table_of_columns({"a": [1.0], "b": [1.0, 2.0]})


def test_a_study_names_its_table_and_gives_back_its_cases(run, case, tmp_path):
    pytest.importorskip("pyarrow")
    in_file(tmp_path / "t.csv", TABLE)
    file = tmp_path / "study.yaml"
    file.write_text("case: case.yaml\nstudy: {kind: table, rows: t.csv, outputs: [friction_power]}\n")
    assert run("check", file)[1].strip().endswith("study of kind table, 3 rows")
    status, _, err = run("study", file, "--out", "a.study", "--workers", 1)
    assert (status, err) == (0, "")
    (tmp_path / "t.csv").unlink()
    study = babbitt.open_study(tmp_path / "a.study")
    again = study.case(1).solve()
    assert again.friction_power == study.table["friction_power"][1]
    assert again.name == "Fan"


def test_options_of_a_table_need_one(run, case):
    assert run("solve", case, "--csv", "o.csv")[0] == 2
    assert run("solve", case, case, "--table", "t.csv")[0] == 2
    assert run("solve", case, "--table", "t.csv", "--json", "o.json")[0] == 2


def test_the_example_has_forty_bearings_that_are_solved():
    bearing = babbitt.load_case("examples/studies/bearing.yaml")
    found = bearing.solve_table("examples/studies/forty_bearings.csv", outputs=["friction_power"]).table
    assert len(found) == 40
    assert (found["status"] == "converged").all()
    assert np.isfinite(found["margin"]).all()
    assert not math.isclose(found["friction_power"].min(), found["friction_power"].max())


def test_one_bad_cell_leaves_the_numbers_of_its_column(run, case, tmp_path):
    """The row alone is refused, by its number in the sheet; the column stays one of numbers with its unit."""
    rows = "name,diameter [mm],# checked by\nGood,120,Ann\n\nBad,12O,Ben\nThin,100,\n"
    table = in_file(tmp_path / "t.csv", rows)
    _, out, _ = run("solve", case, "--table", table, "--csv", "o.csv", "--workers", 1)
    heading, *lines = (line.split(",") for line in (tmp_path / "o.csv").read_text().splitlines())
    place = heading.index("diameter [mm]")
    assert [line[place] for line in lines] == ["120.0", "", "100.0"]
    assert [line[0] for line in lines] == ["2.0", "4.0", "5.0"]  # as the sheet counts: headings, and an empty line
    assert [line[heading.index("status")] for line in lines] == ["converged", "refused", "converged"]
    assert "12O mm" in lines[1][-1]
    assert "Ann" not in out
    refused = next(line for line in out.splitlines() if "refused" in line and "12O" in line)
    assert refused.split()[:3] == ["Bad", "4", "refused"]
    assert "headings counted" in out
    bearing = babbitt.load_case(case)
    found = bearing.solve_table({"diameter [mm]": ["x", 120.0]}).table
    assert list(found["row"]) == [0, 1]


def test_a_heading_with_its_unit_in_parentheses_says_what_to_write(case):
    with pytest.raises(InputError, match=r"square brackets, 'diameter \[mm\]'"):
        rows_of_table(babbitt.load_case(case).complete(), table_of_columns({"diameter (mm)": [120.0]}))


def test_a_table_of_remarks_alone_is_refused(case):
    with pytest.raises(InputError, match="no column names a field"):
        table_of_columns({"# remark": ["a"]})


def test_a_table_in_us_units(run, case, tmp_path):
    table = in_file(tmp_path / "t.csv", "name,diameter [in],load [lbf]\nGear,4.75,5000\n")
    status, out, _ = run("solve", case, "--table", table, "--csv", "o.csv", "--units", "us", "--workers", 1)
    assert status == 0
    read = dict(zip(*(line.split(",") for line in (tmp_path / "o.csv").read_text().splitlines()), strict=True))
    assert float(read["diameter [in]"]) == pytest.approx(4.75)
    assert float(read["load [lbf]"]) == pytest.approx(5000.0)
    alone = babbitt.load_case(case).solve(diameter="4.75 in", load="5000 lbf")
    held = alone.result.values.get("starved_minimum_film_thickness", alone.minimum_film_thickness)
    assert float(read["minimum_film_thickness [mil]"]) == pytest.approx(alone.minimum_film_thickness / 25.4e-6)
    assert f"{held / 25.4e-6:.3f}" in out
    gap = min(one.gap for one in alone.result.limits if one.code == "C104")
    assert float(read["kelvin_C104 [°F]"]) == pytest.approx(1.8 * gap)


def test_a_column_without_unit_is_refused_once_with_its_remedy(run, case, tmp_path):
    for cells in ("12\n14", "12\nabc\n0"):
        table = in_file(tmp_path / "t.csv", f"load\n{cells}\n")
        status, out, err = run("solve", case, "--table", table)
        assert (status, out) == (2, "")
        assert "t.csv: column 'load' has no unit; write 'load [kN]', or a unit behind each number" in err
    mixed = in_file(tmp_path / "t.csv", "load\n12 kN\n14\n")
    assert list(babbitt.load_case(case).solve_table(mixed).table["status"]) == ["converged", "refused"]


def test_reasons_of_rows_name_the_table_and_end_with_a_word(case, tmp_path):
    cells = [f"{'long ' * 80}", "ISO VG 32"]
    table = in_file(
        tmp_path / "t.csv", "width [mm],lubricant\n-50,ISO VG 46\n" + f"60,{cells[0]}\n60,{cells[1]}\n"
    )
    thin, strange, good = babbitt.load_case(case).solve_table(table).table["message"]
    assert thin.startswith("t.csv: width: '-50 mm' is too small")
    assert strange.startswith("t.csv: lubricant: ")
    assert strange.endswith((" ...", "]"))
    assert len(strange) <= 300
    assert good == ""
