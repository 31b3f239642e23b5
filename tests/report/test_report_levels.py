"""How much a report says: each level all that the one before says, and the case file at the last."""

import datetime

import pytest
from typer.testing import CliRunner

import babbitt
from babbitt.case import parse_case
from babbitt.cli.program import app
from babbitt.core.notices import InputError
from babbitt.core.report_level import Level
from babbitt.report.content import content
from babbitt.report.document import typeset, write_report
from babbitt.report.title_block import title_content
from babbitt.solving import solve


@pytest.fixture(scope="module")
def machine():
    return solve(parse_case(babbitt.template("journal")))


def test_each_level_says_what_the_one_before_says(machine):
    summary, standard, full = (content(machine, level) for level in Level)
    for fewer, more in ((summary, standard), (standard, full)):
        assert fewer["rows"] == more["rows"]
        assert fewer["bearings"][0]["results"] == more["bearings"][0]["results"]
        assert fewer["bearings"][0]["checks"] == more["bearings"][0]["checks"]
    assert standard["findings"] == full["findings"]
    assert [one for one in summary["findings"] if one not in full["findings"]] == []
    inputs, sections, figures = ([len(one["bearings"][0][key]) > 0 for one in (summary, standard, full)]
                                 for key in ("inputs", "sections", "figures"))  # fmt: skip
    assert (inputs, sections, figures) == ([False, True, True], [False, False, True], [False, True, True])
    assert [bool(one["case_text"]) for one in (summary, standard, full)] == [False, False, True]


@pytest.mark.parametrize("kind", ["journal", "thrust", "machine"])
def test_a_summary_is_one_page(kind):
    """Kinds without a table of bearings show results and checks; typst makes one picture of one page."""
    pytest.importorskip("typst")
    machine = solve(parse_case(babbitt.template(kind)))
    data = content(machine, Level.SUMMARY) | {"title": title_content(None, datetime.date(2026, 11, 27))}
    assert typeset(data, "report.typ", "png")[:4] == b"\x89PNG"


def test_a_summary_counts_missed_recommendations_and_names_where_assumptions_stand():
    machine = solve(parse_case(babbitt.template("machine")))
    said = " ".join(content(machine, Level.SUMMARY)["conclusion"]["left_to_standard"])
    missed = {
        check.code for result in machine.results for check in result.checks if check.advisory and not check.ok
    }
    assert missed
    assert all(code in said for code in missed)
    assert "`standard`" in said
    assert content(machine, Level.STANDARD)["conclusion"]["left_to_standard"] == []


def test_the_legend_of_a_table_knows_the_columns_of_its_symbols():
    """Of columns that the paper has no room for nothing is said below the table."""
    said = content(solve(parse_case(babbitt.template("machine"))))
    for one in said["conclusion"]["legend"]:
        assert one["columns"]
        assert all(one["symbol"] in said["columns"][place]["heading"] for place in one["columns"])


def test_the_command_line_takes_a_level(tmp_path):
    pytest.importorskip("typst")
    (tmp_path / "case.yaml").write_text(babbitt.template("journal"))
    said = {}
    for level in ("summary", "full"):
        target = tmp_path / f"{level}.html"
        given = ["solve", str(tmp_path / "case.yaml"), "--report", str(target), "--report-level", level]
        assert CliRunner().invoke(app, given).exit_code == 0
        said[level] = target.read_text()
    assert "Case file as read" in said["full"]
    assert "Case file as read" not in said["summary"]


def test_an_unknown_level_is_refused(machine, tmp_path):
    with pytest.raises(InputError, match="summary"):
        write_report(machine, tmp_path / "report.html", "sumary")
    assert not (tmp_path / "report.html").exists()
