"""The command study: one file, one command, and what it leaves behind."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
import yaml
from studied_cases import JOURNAL

import babbitt

STUDIES = {
    "sweep": {
        "kind": "sweep",
        "vary": {"load": {"range": ["10 kN", "30 kN", 3]}, "lubricant": ["ISO VG 32", "ISO VG 46"]},
    },
    "corners": {"kind": "corners", "vary": {"supply.temperature": ["45 degC", "58 degC", "65 degC"]}},
    "tolerance": {
        "kind": "tolerance",
        "samples": 20,
        "vary": {"clearance": {"fit": "H7/e8"}, "load": {"uniform": ["20 kN", "60 kN"]}},
    },
    "map": {
        "kind": "map",
        "vary": {"speed": {"range": ["500 rpm", "3000 rpm", 4]}, "load": {"range": ["10 kN", "60 kN", 4]}},
    },
    "sensitivity": {
        "kind": "sensitivity",
        "samples": 4,
        "outputs": ["friction_power"],
        "vary": {
            "supply.temperature": {"normal": ["58 degC", "2 K"]},
            "load": {"triangular": ["10 kN", "24 kN", "30 kN"]},
        },
    },
    "spectrum": {
        "kind": "spectrum",
        "load_cases": [
            {"name": "idle", "share": "30 %", "set": {"speed": "800 rpm", "load": "6 kN"}},
            {"name": "full", "share": "70 %", "set": {"speed": "2000 rpm", "load": "24 kN"}},
        ],
    },
    "size": {"kind": "size", "vary": {"load": {"log_range": ["1 kN", "100 kN", 5]}}, "preferred": True},
    "optimise": {
        "kind": "optimise",
        "vary": {
            "clearance.mean": {"uniform": ["0.8 permille", "2 permille"]},
            "lubricant": ["ISO VG 32", "ISO VG 46"],
        },
        "minimise": ["friction_power", "total_flow"],
        "population": 6,
        "generations": 2,
    },
}
TITLES = {
    "sweep": "Results",
    "corners": "Corners",
    "tolerance": "Yield",
    "map": "Map of",
    "sensitivity": "Sobol indices",
    "spectrum": "Over the spectrum",
    "size": "load within all limits",
    "optimise": "Pareto set",
}


def written(path, study):
    band = {"clearance": {"kind": "fit", "bore": "H7", "journal": "e8"}} if study["kind"] == "corners" else {}
    path.write_text(yaml.safe_dump({**JOURNAL, **band, "study": study}, sort_keys=False))
    return path


@pytest.mark.parametrize("kind", STUDIES)
def test_each_kind_is_one_command_with_table_workbook_report_and_figures(run, tmp_path, kind):
    openpyxl = pytest.importorskip("openpyxl")
    file = written(tmp_path / "case.yaml", STUDIES[kind])
    options = ["--out", "a.study", "--workers", 1, "--xlsx", "a.xlsx", "--report", "a.html", "--plots", "figures"]
    status, out, err = run("study", file, *options)
    assert (status, err) == (0, "")
    assert TITLES[kind] in out
    book = openpyxl.load_workbook(io.BytesIO((tmp_path / "a.xlsx").read_bytes()))
    assert book.sheetnames[:3] == ["Summary", "Inputs", "Results"]
    results = book["Results"]
    heads = {cell.value: cell.column_letter for cell in results[1]}
    stored = babbitt.open_study(tmp_path / "a.study")
    assert results.max_row == 2 + len(stored.table)  # names, units
    assert {"verdict", "governing_check", "codes"} <= set(heads)
    assert results.freeze_panes == "B3"
    margins = results[heads["margin"]][2:]
    assert {cell.number_format for cell in margins if cell.value is not None} == {"0.0%"}
    assert results[heads["kelvin_C104"]][1].value == "K"
    own = [name for name in book.sheetnames[3:] if TITLES[kind] in name or name in TITLES[kind]]
    assert own or kind == "sweep"  # whose table is that of the results
    for sheet in book:  # every column holds its words, in the width that they need or the largest one
        for column in sheet.columns:
            letters = max((len(one.value) for one in column[:2] if isinstance(one.value, str)), default=0)
            if len(sheet[1]) > 1 or sheet.freeze_panes:
                assert sheet.column_dimensions[column[0].column_letter].width > min(letters, 60)
    page = (tmp_path / "a.html").read_text()
    assert TITLES[kind] in page
    assert page.count("<img") == len(list((tmp_path / "figures").glob("*.svg"))) > 0
    again, shown, _ = run("study", "show", "a.study")
    assert (again, shown) == (0, out)


def test_the_case_beside_a_study_is_solved_as_before(run, tmp_path):
    plain = tmp_path / "plain.yaml"
    plain.write_text(yaml.safe_dump(JOURNAL))
    file = written(tmp_path / "case.yaml", STUDIES["tolerance"])
    assert run("solve", file)[1] == run("solve", plain)[1]
    assert run("check", file)[0] == 0


def test_a_study_in_a_file_of_its_own(run, tmp_path):
    (tmp_path / "case.yaml").write_text(yaml.safe_dump(JOURNAL))
    (tmp_path / "study.yaml").write_text(
        yaml.safe_dump({"case": "case.yaml", "study": STUDIES["spectrum"]}, sort_keys=False)
    )
    file = written(tmp_path / "both.yaml", STUDIES["spectrum"])
    assert run("study", "study.yaml", "--workers", 1)[:2] == run("study", file, "--workers", 1)[:2]


def test_a_best_design_is_a_case_that_runs(run, tmp_path):
    file = written(tmp_path / "case.yaml", STUDIES["optimise"])
    assert run("study", file, "--out", "a.study", "--workers", 1)[0] == 0
    designs = sorted((tmp_path / "a.study" / "designs").glob("*.yaml"))
    study = babbitt.open_study(tmp_path / "a.study")
    assert len(designs) == len(study.answer.rows) > 0
    for row, powers in zip(study.answer.rows, study.answer.values, strict=True):
        result = babbitt.load_case(tmp_path / "a.study" / "designs" / f"design-row-{row}.yaml").solve()
        held = [result.values.get(f"starved_{name}", result.values[name]) for name in study.answer.objectives]
        assert held == pytest.approx(powers, rel=1e-9)


BAD = {
    "unknown path": {"kind": "tolerance", "vary": {"laod": {"uniform": ["1 kN", "2 kN"]}}},
    "not numeric": {"kind": "tolerance", "vary": {"lubricant": {"uniform": [1, 2]}}},
    "empty range": {"kind": "sweep", "vary": {"load": {"range": ["5 kN", "5 kN", 3]}}},
    "beyond its bounds": {"kind": "tolerance", "vary": {"load": {"normal": ["5 kN", "5 kN"]}}},
    "too many samples": {"kind": "tolerance", "samples": 10**12, "vary": {"load": {"uniform": ["1 kN", "2 kN"]}}},
    "contradictory limits": {"kind": "tolerance", "vary": {"load": {"uniform": ["5 kN", "2 kN"]}}},
    "choice in Sobol": {"kind": "sensitivity", "vary": {"lubricant": ["ISO VG 32", "ISO VG 46"]}},
    "unknown output": {"kind": "tolerance", "vary": {"load": {"uniform": ["1 kN", "2 kN"]}}, "outputs": ["power"]},
    "grid of a law": {"kind": "sweep", "vary": {"load": {"uniform": ["1 kN", "2 kN"]}}},
}


@pytest.mark.parametrize("what", BAD)
def test_bad_input_is_one_clear_line_and_nothing_is_written(run, tmp_path, what):
    file = written(tmp_path / "case.yaml", BAD[what])
    status, out, err = run("study", file, "--out", "a.study", "--xlsx", "a.xlsx", "--report", "a.html")
    assert (status, out) == (2, "")
    line, code = err.strip().splitlines()
    assert "study" in line
    assert code.startswith("(E00")
    assert [path.name for path in tmp_path.iterdir()] == ["case.yaml"]


OUTPUTS = {
    "ending of a workbook": ["--xlsx", "a.csv"],
    "ending of a report": ["--report", "a.txt"],
    "an input": ["--report", "case.yaml"],
    "one for two": ["--report", "a.html", "--xlsx", "a.html"],
    "no folder": ["--xlsx", "missing/a.xlsx"],
    "no dask": ["--scheduler", "nonsense"],
}


@pytest.mark.parametrize("what", OUTPUTS)
def test_outputs_are_refused_before_any_work(run, tmp_path, what):
    file = written(tmp_path / "case.yaml", STUDIES["spectrum"])
    status, out, err = run("study", file, *OUTPUTS[what])
    assert (status, out) == (2, "")
    assert "E007" in err
    assert [path.name for path in tmp_path.iterdir()] == ["case.yaml"]


def test_a_map_needs_no_study_in_the_file(run, tmp_path):
    (tmp_path / "case.yaml").write_text(yaml.safe_dump(JOURNAL))
    status, out, err = run("study", "case.yaml", "--kind", "map", "--points", 3, "--workers", 1)
    assert (status, err) == (0, "")
    assert "Map of Textbook bearing: load up, speed in rpm across" in " ".join(out.split())
    assert "C112 Whirl screening" in out
    for options, words in ((["--kind", "tolerance"], "allowed: map"), (["--points", 3], "--kind map")):
        status, _, err = run("study", "case.yaml", *options)
        assert status == 2
        assert words in err


def test_a_file_without_a_study_says_so(run, tmp_path):
    (tmp_path / "case.yaml").write_text(yaml.safe_dump(JOURNAL))
    status, _, err = run("study", "case.yaml")
    assert status == 2
    assert "holds no study" in err
    assert run("study", "show", "missing.study")[0] == 2
    assert run("study", "case.yaml", "case.yaml")[0] == 2


def test_a_case_outside_the_folder_wants_leave(run, tmp_path):
    (tmp_path / "case.yaml").write_text(yaml.safe_dump(JOURNAL))
    (tmp_path / "below").mkdir()
    file = tmp_path / "below" / "study.yaml"
    file.write_text(yaml.safe_dump({"case": "../case.yaml", "study": STUDIES["spectrum"]}))
    status, _, err = run("study", file, "--workers", 1)
    assert status == 2
    assert "--allow-outside" in err
    assert run("study", file, "--workers", 1, "--allow-outside")[0] == 0


def test_python_asks_as_the_command_does(run, tmp_path):
    written(tmp_path / "case.yaml", STUDIES["tolerance"])
    bearing = babbitt.load_case(tmp_path / "case.yaml")
    assert run("study", "case.yaml", "--workers", 1, "--out", "a.study")[0] == 0
    stored, found = babbitt.open_study(tmp_path / "a.study"), bearing.study()
    assert found.summary() == stored.summary()
    again = bearing.study("tolerance", STUDIES["tolerance"]["vary"], samples=20)
    assert again.table.equals(found.table)
    assert found.table.attrs["units"]["clearance"] == "m"
    row = found.case(5)
    assert row.solve().result.margin == pytest.approx(found.table["margin"][5], rel=1e-12)


def test_numbers_of_python_are_si_and_arrays_will_do(tmp_path):
    xarray = pytest.importorskip("xarray")
    bearing = babbitt.JournalBearing(**{name: value for name, value in JOURNAL.items() if name != "kind"})
    over = {"load": np.array([10e3, 20e3]), "supply.temperature": [323.15, "60 degC"]}
    grid = bearing.study("sweep", over, outputs=["friction_power"]).to_xarray()
    assert isinstance(grid, xarray.Dataset)
    assert grid["friction_power"].shape == (2, 2)
    expected = bearing.solve({"load": 20e3, "supply.temperature": 333.15}).friction_power
    assert float(grid["friction_power"].sel(load=20e3)[1]) == pytest.approx(expected, rel=1e-12)
    with pytest.raises(babbitt.InputError, match="is no grid"):
        bearing.study("tolerance", {"load": {"normal": [20e3, 1e3]}}, samples=2).to_xarray()


def test_other_programs_read_the_chunks(run, tmp_path):
    polars, duckdb = pytest.importorskip("polars"), pytest.importorskip("duckdb")
    file = written(tmp_path / "case.yaml", STUDIES["sweep"])
    assert run("study", file, "--out", "a.study", "--workers", 1)[0] == 0
    ours = babbitt.open_study(Path("a.study")).table
    theirs = polars.read_parquet("a.study/chunks/*.parquet")
    assert theirs["margin"].to_list() == ours["margin"].to_list()
    ((rows,),) = duckdb.sql("select count(*) from 'a.study/chunks/*.parquet' where verdict = 'pass'").fetchall()
    assert rows == (ours["verdict"] == "pass").sum()


def test_a_table_of_values_is_replaced_by_the_next_run_alone(run, tmp_path):
    run("new", "journal", "-o", "pump.yaml")
    (tmp_path / "rows.csv").write_text("load [kN]\n20\n30\n")
    table = ("solve", "pump.yaml", "--table", "rows.csv", "--csv")
    sweep = ("sweep", "pump.yaml", "load", "20 kN, 30 kN", "speed", "1500 rpm, 1600 rpm", "--csv")
    for command, name in ((table, "table.csv"), (sweep, "sweep.csv")):
        assert [run(*command, name)[0] for _ in range(2)] == [0, 0]
        own = (tmp_path / name).read_text()
        (tmp_path / name).write_text(own.replace("bearing", "my bearing", 1))
        status, _, err = run(*command, name)
        assert status == 2
        assert "no output of Babbitt" in err


def test_the_report_of_a_study_of_its_own_has_the_study(run, tmp_path):
    """As one beside its case does; a study that stands in the text is not written twice."""
    (tmp_path / "case.yaml").write_text(yaml.safe_dump(JOURNAL))
    study = yaml.safe_dump({"case": "case.yaml", "study": STUDIES["tolerance"]}, sort_keys=False)
    (tmp_path / "study.yaml").write_text(study)
    assert run("study", "study.yaml", "--workers", 1, "--report", "own.html")[0] == 0
    page = (tmp_path / "own.html").read_text()
    assert "The study that was computed" in page
    assert "kind: tolerance" in page
    assert "Textbook bearing" in page
    assert run("study", written(tmp_path / "both.yaml", STUDIES["tolerance"]), "--report", "both.html")[0] == 0
    assert "The study that was computed" not in (tmp_path / "both.html").read_text()


def test_a_quantity_is_swept_in_all_places_at_once(run, tmp_path):
    """`*.speed` takes the speed of every bearing by one share of what stands there."""
    shared = ("lubricant", "supply", "materials")
    alone = {name: value for name, value in JOURNAL.items() if name not in ("name", *shared)}
    bearings = [alone | {"name": "fast", "speed": "2000 rpm"}, alone | {"name": "slow", "speed": "1000 rpm"}]
    machine = (
        {"kind": "machine", "name": "Two"} | {name: JOURNAL[name] for name in shared} | {"bearings": bearings}
    )
    (tmp_path / "two.yaml").write_text(yaml.safe_dump(machine, sort_keys=False))
    status, _, err = run("sweep", "two.yaml", "*.speed", "0.5:1:2", "--csv", "o.csv")
    assert (status, err) == (0, "")
    heading, *lines = (line.split(",") for line in (tmp_path / "o.csv").read_text().splitlines())
    place = {name: at for at, name in enumerate(heading)}
    found = {
        (line[place["bearing"]], float(line[0])): float(line[place["surface_speed_m_per_s"]]) for line in lines
    }
    assert found["fast", 0.5] == pytest.approx(0.5 * found["fast", 1.0])
    assert found["fast", 0.5] == pytest.approx(found["slow", 1.0])
    assert run("sweep", "two.yaml", "*.speed", "50 %, 100 %", "--bearing", "slow", "--csv", "p.csv")[0] == 0
    assert len((tmp_path / "p.csv").read_text().splitlines()) == 3
    assert run("sweep", "two.yaml", "*.power", "0.5, 1")[2].startswith(
        "study.vary.*.power: the case gives no power"
    )


def test_the_report_is_in_the_language_asked_for_or_that_of_the_case(run, tmp_path):
    pytest.importorskip("typst")
    case = {**JOURNAL, "document": {"language": "ru"}, "study": STUDIES["sweep"]}
    (tmp_path / "case.yaml").write_text(yaml.safe_dump(case), encoding="utf-8")
    stored, report = tmp_path / "a.study", tmp_path / "a.html"
    code, printed, _ = run("study", tmp_path / "case.yaml", "--workers", 1, "--out", stored, "--report", report)
    assert code == 0
    assert "Что изменяется" in report.read_text(encoding="utf-8")
    assert "What varies" in printed
    for language, said in ((), "Что изменяется"), (("--language", "de"), "Was variiert wird"):
        assert run("study", "show", stored, "--report", report, *language)[0] == 0
        assert said in report.read_text(encoding="utf-8")
    code, _, refusal = run("study", tmp_path / "case.yaml", "--language", "de")
    assert code == 2
    assert "--language is of report and plots" in refusal
