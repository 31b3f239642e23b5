"""Values of a sweep: lists, ranges, units, words, and what is refused."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.notices import InputError
from babbitt.study.sweep_values import MOST_VALUES, values_of


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6), st.integers(2, MOST_VALUES))
def test_a_range_begins_and_ends_where_it_says_in_equal_steps(first, last, count):
    found = values_of(f"{first!r} kN : {last!r} kN : {count}")
    assert found.numbers is not None
    assert len(found.numbers) == len(found.texts) == count
    assert found.numbers[0] == first
    assert found.numbers[-1] == pytest.approx(last, rel=1e-9, abs=1e-9 * abs(first))
    steps = [b - a for a, b in zip(found.numbers, found.numbers[1:], strict=False)]
    assert steps == pytest.approx([(last - first) / (count - 1)] * len(steps), rel=1e-6, abs=1e-8)
    assert all(text.endswith(" kN") for text in found.texts)


def test_values_are_told_in_the_unit_of_the_first():
    assert values_of("500 N, 1 kN, 0.002 MN").numbers == pytest.approx((500.0, 1000.0, 2000.0))
    assert values_of("0.5 m:600 mm:3").texts == ("0.5 m", "0.55 m", "0.6 m")
    assert values_of("20 degC:40 degC:3").numbers == (20.0, 30.0, 40.0)
    assert values_of("293.15 K, 30 degC").numbers == pytest.approx((293.15, 303.15))
    assert values_of("0.001:0.002:2").unit == ""


def test_a_number_without_unit_is_no_quantity_where_a_file_refuses_it():
    assert values_of("1000 rpm, 2000").numbers is None  # 2000 rad/s it was
    assert values_of("0, 1000 rpm").numbers is None
    assert values_of("1 kN, 0").numbers == (1.0, 0.0)
    assert values_of("1 kN:0:2").texts == ("1 kN", "0 kN")
    assert values_of("860 kg/m3:900:3").numbers == (860.0, 880.0, 900.0)


def test_words_have_no_numbers():
    found = values_of("draft, reference")
    assert (found.texts, found.numbers) == (("draft", "reference"), None)
    assert values_of("30 kN, heavy").numbers is None
    assert values_of("H7/e8, H7/d8").texts == ("H7/e8", "H7/d8")


def test_what_stands_in_a_file_is_read_in_the_same_unit():
    found = values_of("1 kN:2 kN:2")
    assert found.number_of("1500 N") == pytest.approx(1.5)
    assert found.number_of(1500.0) is None  # refused in a file, too
    assert values_of("860 kg/m3:0.9 g/cm3:3").number_of(880.0) == 880.0  # all write a density in one unit
    assert found.number_of("3 m") is None
    assert found.number_of(None) is None
    assert values_of("draft").number_of("draft") is None


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "empty"),
        ("1 kN,,2 kN", "empty"),
        ("1 kN:2 kN:1", f"2 to {MOST_VALUES}"),
        ("1 kN:2 kN:many", "number of values"),
        ("1 kN:2 kN:100000", f"2 to {MOST_VALUES}"),
        ("1 kN:2 rpm:3", "kind of '1 kN'"),
        ("1000 rpm:2000:3", "'2000' has no unit; write '2000 rpm'"),
        ("20 degC:0:3", "'0' has no unit; write '0 degC'"),
        ("low:high:3", "no number"),
        (",".join(["1"] * (MOST_VALUES + 1)), "at most"),
    ],
)
def test_what_cannot_be_read_is_told(text, words):
    with pytest.raises(InputError, match=words) as told:
        values_of(text)
    assert told.value.code == "E003"
    assert "1 kN:10 kN:10" in told.value.message
