"""Words in tables are never formulas, and numbers are never words."""

import csv
import io

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.files.spreadsheet import Sheet, Shown, plain_word, read_rows, rows_text, workbook, written_word

DANGEROUS = ["=1+1", "+1", "-2+3", "@SUM(A1)", "\t=1", "\r=1"]


@pytest.mark.parametrize("word", DANGEROUS)
def test_a_word_that_begins_like_a_formula_gets_an_apostrophe(word):
    (row,) = csv.reader(io.StringIO(rows_text([[word, -2.5]]), newline=""))
    assert row[0][0] in "' "
    assert row[1] == "-2.5"


@given(st.text())
def test_every_word_comes_back(word):
    assert plain_word(written_word(word)) == word
    assert written_word(word)[:1] not in ("=", "+", "-", "@", "\t", "\r")


@pytest.mark.parametrize("word", [*DANGEROUS[:4], "Pinion"])
def test_rows_come_back(word):
    assert read_rows(rows_text([[word, 1.25, None, -3.0]])) == [[word, "1.25", "", "-3.0"]]


def test_a_workbook_has_words_as_words_and_numbers_as_numbers(tmp_path):
    from openpyxl import load_workbook

    rows = [["load [kN]", "bearing"], [-1.5, "=HYPERLINK(1)"], [2.0, "bell\x07"], [3.0, None]]
    sheet = load_workbook(io.BytesIO(workbook({"Sweep": rows}, "x")))["Sweep"]
    cells = [[(cell.value, cell.data_type) for cell in row] for row in sheet.iter_rows()]
    assert cells[1] == [(-1.5, "n"), ("=HYPERLINK(1)", "s")]
    assert cells[2] == [(2.0, "n"), ("bell", "s")]
    assert cells[3][1][0] is None


def test_a_sheet_keeps_its_headings_in_sight_and_shows_its_numbers_as_told():
    from openpyxl import load_workbook

    long = "w" * 200
    rows = [
        ["name", "share", "remark"],
        ["mm", None, None],
        ["a", 0.5, long],
        [Shown(2.5, '0.0"*"'), -0.25, None],
        [long],
    ]
    book = workbook({"One": Sheet(rows, 2, 1, {1: "0.0%"}), "Words": Sheet([["Case", "x"]], 0)}, "x")
    sheets = load_workbook(io.BytesIO(book))
    one = sheets["One"]
    assert one.freeze_panes == "B3"
    assert sheets["Words"].freeze_panes is None
    assert (one["A1"].font.bold, one["A2"].font.italic, one["A3"].font.bold) == (True, True, False)
    assert [one[at].number_format for at in ("A4", "B3", "B4")] == ['0.0"*"', "0.0%", "0.0%"]
    assert one["A4"].value == 2.5
    widths = {letter: one.column_dimensions[letter].width for letter in "ABC"}
    assert widths["A"] < 15.0 < 60.0 < widths["C"] < 70.0  # a note below runs on, a long cell is wrapped
    assert one["C3"].alignment.wrap_text
