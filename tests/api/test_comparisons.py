"""A bearing by every method: short on a screen, and results as `solve` gives them."""

import pickle

import pytest

import babbitt as bb
from babbitt.api.comparisons import Comparison
from babbitt.api.results import BearingResult
from babbitt.report.comparison_table import print_comparison


@pytest.fixture(scope="module")
def pad():
    return bb.parse_case(bb.template("hydrostatic_pad"))


@pytest.fixture(scope="module")
def compared(pad):
    return pad.compare()


def test_each_variant_is_a_result_of_the_front_door(pad, compared):
    (one,) = compared
    assert isinstance(one, Comparison)
    assert len(one) == len(one.variants) > 1
    assert all(type(variant.result) is BearingResult for variant in one)
    assert one.asked.result == pad.solve() == one[one.asked.label]
    assert one.labels == tuple(variant.label for variant in one)
    with pytest.raises(KeyError, match=f"did you mean '{one.labels[0]}'"):
        one[one.labels[0] + "s"]


def test_it_is_a_short_table_as_on_the_command_line(compared, capsys):
    (one,) = compared
    text = str(one)
    assert str(compared) == repr(compared) == text
    assert len(text.splitlines()) < 25
    assert max(map(len, text.splitlines())) <= 140
    print_comparison([one.engine])
    full = capsys.readouterr().out
    cells = {cell for line in full.splitlines() for cell in line.split("│")}
    rows = [line for line in text.splitlines() if line.startswith("│")]
    assert len(rows) > 3
    assert all(row.split("│")[-2].strip() in {cell.strip() for cell in cells} for row in rows)
    assert all(variant.result.verdict.value in rows[-1] + rows[-2] for variant in one)
    assert "<script>" not in one._repr_html_()


def test_several_bearings_take_a_line_each(compared):
    several = type(compared)([*compared] * 30)
    assert len(repr(several).splitlines()) < 25
    assert compared[0].name in repr(several)


def test_a_frame_has_a_row_for_each_variant(compared):
    pytest.importorskip("pandas")
    (one,) = compared
    rows = compared.to_dataframe()
    assert rows["variant"].tolist() == list(one.labels)
    assert rows["bearing"].unique().tolist() == [one.name]
    assert rows["gap"].tolist() == [variant.result.gap for variant in one]
    assert one.to_dataframe().equals(rows)


def test_a_comparison_survives_pickling(compared):
    again = pickle.loads(pickle.dumps(compared))
    assert repr(again) == repr(compared)
    assert again[0].asked.result == compared[0].asked.result
