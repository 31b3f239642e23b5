"""One quantity is written in one way, alone or among many."""

from __future__ import annotations

import math

import gear_cases
import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.quantities import QUANTITIES
from babbitt.kinds.journal.iso7902 import check
from babbitt.report.machine_table import columns_of
from babbitt.report.verdict import written

GEAR = tuple(check(case) for case in gear_cases.gear())


def decimals(text: str) -> int:
    return len(text.partition(".")[2])


@pytest.mark.parametrize(
    ("name", "values", "shown"),
    [
        ("outlet_temperature", (371.75, 372.15, 410.15), ["98.6", "99.0", "137.0"]),
        ("specific_load", (1.25e6, 1.2e6, 15e6), ["1.25", "1.20", "15.00"]),
        ("side_flow", (26.72 / 6e4, 0.1187 / 6e4, 0.0), ["26.7", "0.119", "0"]),
        ("eccentricity_ratio", (0.51117, 0.99996), ["0.511", "1.000"]),
    ],
)
def test_decimals_do_not_depend_on_the_size(name, values, shown):
    assert [QUANTITIES[name].format(value) for value in values] == shown


@given(st.sampled_from(sorted(QUANTITIES)), st.floats(min_value=1.0, max_value=9e6))
def test_from_one_on_the_decimals_are_those_of_the_unit(name, shown):
    quantity = QUANTITIES[name]
    si = (shown - quantity.display.offset) / quantity.display.scale
    text = quantity.format(si)
    if quantity.shown(si) >= 1.0:
        assert decimals(text) == quantity.display.decimals
    assert float(text) == pytest.approx(shown, abs=0.51 * 10.0**-quantity.display.decimals)


@given(st.sampled_from(["friction_power", "side_flow", "friction_coefficient"]), st.floats(1e-6, 0.999))
def test_small_numbers_keep_three_digits(name, shown):
    text = QUANTITIES[name].format(shown / QUANTITIES[name].display.scale)
    assert float(text) == pytest.approx(shown, rel=6e-3)


def test_a_number_reads_the_same_alone_and_in_a_table():
    for name in ("specific_load", "eccentricity_ratio", "friction_power"):
        (column,) = [c for c in columns_of(GEAR) if c.heading == QUANTITIES[name].symbol]
        for result, cell in zip(GEAR, column.cells(GEAR), strict=True):
            assert column.cells([result]) == [cell]
            assert written(name, result.values[name]).split()[0] == cell


def test_what_is_no_number_is_a_dash():
    assert written("side_flow", math.nan) == "–"
