"""The title block of a report: from the case or the command line to the page, and nothing of it in the numbers."""

import datetime

import pytest
from typer.testing import CliRunner

import babbitt
from babbitt.case import CaseError, Reach, load_case, parse_case
from babbitt.case.case_hash import case_hash
from babbitt.cli.program import app
from babbitt.core.notices import InputError
from babbitt.report.document import report
from babbitt.report.title_block import title_block_of_options, title_content
from babbitt.solving import solve

CASE = babbitt.template("journal")
BLOCK = """
document:
  project: "Fan <script>alert(1)</script>"
  number: B-0017
  author: A. Smith
  date: 2026-11-20
  revisions:
    - {revision: A, date: 2026-10-01, change: first issue}
    - {revision: B, change: load 12 kN}
"""
SVG = b'<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><rect width="9" height="9"/></svg>'


def refused(text: str) -> str:
    with pytest.raises(CaseError) as found:
        parse_case(CASE + text)
    return found.value.message


def test_nothing_of_the_title_block_enters_the_calculation():
    plain, titled = parse_case(CASE), parse_case(CASE + BLOCK)
    assert case_hash(plain) == case_hash(titled)
    first, second = (solve(one).results[0] for one in (plain, titled))
    assert first.minimum_film_thickness == second.minimum_film_thickness
    assert first.checks == second.checks


def test_the_page_says_who_signs_and_what_was_changed():
    pytest.importorskip("typst")
    page = report(solve(parse_case(CASE + BLOCK)), "html").decode()
    for said in ("B-0017", "2026-11-20", "first issue", "load 12 kN", "Prepared: A. Smith", "Approved: name"):
        assert said in page
    assert "<script>alert" not in page
    assert "&lt;script" in page


def test_without_a_date_it_is_that_of_the_run():
    today = datetime.date(2026, 11, 27)
    assert title_content(None, today)["rows"] == [{"label": "Date of calculation", "value": "2026-11-27"}]
    of_case = title_content(parse_case(CASE + BLOCK).title_block, today)
    assert {"label": "Date of calculation", "value": "2026-11-20"} in of_case["rows"]
    assert {"label": "Revision", "value": "B"} in of_case["rows"]  # the last of the history


def test_wrong_fields_are_told_at_their_place():
    assert "document.date" in refused("\ndocument: {date: 27.11.2026}\n")
    assert "2026-11-27" in refused("\ndocument: {date: 27.11.2026}\n")
    assert "document.nunber" in refused("\ndocument: {nunber: 12}\n")
    text = "\ndocument: {revision: C, revisions: [{revision: A, change: first issue}]}\n"
    assert "document.revision" in refused(text)


def test_a_history_with_one_index_twice_or_dates_that_fall_is_refused():
    twice = "\ndocument: {revisions: [{revision: A, change: first}, {revision: A, change: again}]}\n"
    assert "document.revisions[1].revision" in refused(twice)
    assert "each index once" in refused(twice)
    falling = (
        "\ndocument: {revisions: [{revision: A, date: 2026-10-01, change: first}, {revision: B, change: no date}, "
        "{revision: C, date: 2026-09-30, change: load}]}\n"
    )
    assert "document.revisions[2].date" in refused(falling)
    assert "2026-10-01" in refused(falling)


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("logo.svg", b"no picture", "neither PNG nor SVG"),
        ("logo.png", b"\x89PNG\r\n\x1a\n" + bytes(600_000), "500"),
        ("missing.svg", None, "missing.svg"),
        ("../logo.svg", SVG, "outside the folder"),
    ],
)
def test_a_logo_is_a_small_picture_beside_the_case(tmp_path, name, content, said):
    folder = tmp_path / "case"
    folder.mkdir()
    if content is not None:
        (folder / name).write_bytes(content)
    (folder / "case.yaml").write_text(CASE + f"\ndocument: {{logo: {name}}}\n")
    with pytest.raises(CaseError) as found:
        load_case(folder / "case.yaml")
    assert said in found.value.message
    assert "document.logo" in found.value.message


def test_a_logo_stands_on_the_page(tmp_path):
    pytest.importorskip("typst")
    (tmp_path / "logo.svg").write_bytes(SVG)
    (tmp_path / "case.yaml").write_text(CASE + "\ndocument: {logo: logo.svg}\n")
    case = load_case(tmp_path / "case.yaml")
    assert case.title_block.picture_format == "svg"
    assert b'alt="logo"' in report(solve(case), "html")
    with pytest.raises(CaseError, match="no files"):
        load_case(tmp_path / "case.yaml", Reach.NOWHERE)


def test_the_command_line_completes_the_block_of_the_case(tmp_path):
    pytest.importorskip("typst")
    (tmp_path / "case.yaml").write_text(CASE + BLOCK)
    target = tmp_path / "report.html"
    given = ["solve", str(tmp_path / "case.yaml"), "--document", "checker=B. Jones"]
    assert CliRunner().invoke(app, [*given, "--report", str(target)]).exit_code == 0
    page = target.read_text()
    assert "Checked: B. Jones" in page
    assert "Prepared: A. Smith" in page
    assert CliRunner().invoke(app, given).exit_code != 0  # of a report, and there is none
    with pytest.raises(InputError, match="add --report"):
        CliRunner().invoke(app, [*given[:2], "--language", "de"], catch_exceptions=False)


@pytest.mark.parametrize("option", ["revision", "nunber=3", "date=tomorrow", "logo=logo.svg"])
def test_options_that_are_no_fields_are_refused(option):
    with pytest.raises(CaseError):
        title_block_of_options(None, [option])


def test_a_result_in_python_keeps_the_block_of_its_case(tmp_path):
    pytest.importorskip("typst")
    (tmp_path / "case.yaml").write_text(CASE + BLOCK)
    babbitt.load_case(tmp_path / "case.yaml").solve().write_report(tmp_path / "report.html")
    assert "B-0017" in (tmp_path / "report.html").read_text()
