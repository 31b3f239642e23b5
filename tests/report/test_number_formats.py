"""One quantity is written in one way, alone or among many."""

from __future__ import annotations

import math

import gear_cases
import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.check_text import margin, value_and_limit, written
from babbitt.core.limited_flow import quantity_held
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Bound, Check
from babbitt.kinds.journal.iso7902 import check
from babbitt.report.machine_table import columns_of

GEAR = tuple(check(case) for case in gear_cases.gear())


def decimals(text: str) -> int:
    return len(text.partition(".")[2])


@pytest.mark.parametrize(
    ("name", "values", "shown"),
    [
        ("outlet_temperature", (371.75, 372.15, 410.15), ["98.6", "99.0", "137.0"]),
        ("specific_load", (1.25e6, 1.2e6, 15e6, 150e6), ["1.25", "1.20", "15.00", "150.0"]),
        ("diameter", (0.52755,), ["527.55"]),
        ("side_flow", (26.72 / 6e4, 0.1187 / 6e4, 0.0), ["26.7", "0.119", "0"]),
        ("eccentricity_ratio", (0.51117, 0.99996), ["0.511", "1.000"]),
    ],
)
def test_decimals_do_not_depend_on_the_size(name, values, shown):
    assert [QUANTITIES[name].format(value) for value in values] == shown


@given(st.sampled_from(sorted(QUANTITIES)), st.floats(min_value=1.0, max_value=9e6))
def test_from_one_on_numbers_have_the_decimals_of_the_unit_and_four_digits_at_most(name, shown):
    quantity = QUANTITIES[name]
    si = (shown - quantity.display.offset) / quantity.display.scale
    text = quantity.format(si)
    assert decimals(text) <= quantity.display.decimals
    if quantity.shown(si) >= 1.0 and not quantity.display.offset:
        whole = len(text.partition(".")[0])
        assert decimals(text) >= min(quantity.display.decimals, quantity.display.digits - whole)
        assert decimals(text) == 0 or len(text) - 1 <= max(quantity.display.digits + 1, whole)
    assert float(text) == pytest.approx(shown, abs=0.51 * 10.0 ** -decimals(text))


@given(st.sampled_from(["friction_power", "critical_mass", "stiffness", "damping"]), st.floats(1e3, 1e12))
def test_the_unit_suits_the_size_and_changes_no_value(name, si):
    quantity = QUANTITIES[name].suited(si)
    assert quantity.shown(si) / quantity.display.scale == pytest.approx(si, rel=1e-12)
    usual = QUANTITIES[name].shown(si)
    if not 0.1 <= usual < 1e4:
        assert quantity.shown(si) >= 1.0
    else:
        assert quantity == QUANTITIES[name]


def test_a_limit_barely_missed_is_told_with_the_digits_that_tell_so():
    missed = Check("C117", "supply_capacity", 1.3001 / 6e4, 1.3049 / 6e4, Bound.AT_LEAST, "a test")
    assert value_and_limit(missed) == ("1.3001 L/min", "1.3049 L/min")


def test_margins_beyond_measure_are_told_as_such():
    kept = Check("C101", "minimum_film_thickness", 80e-6, 10e-6, Bound.AT_LEAST, "a test")
    assert margin(kept) == "over +500%"


@given(st.sampled_from(["friction_power", "side_flow", "friction_coefficient"]), st.floats(1e-6, 0.999))
def test_small_numbers_keep_three_digits(name, shown):
    text = QUANTITIES[name].format(shown / QUANTITIES[name].display.scale)
    assert float(text) == pytest.approx(shown, rel=6e-3)


def test_a_number_reads_the_same_alone_and_in_a_table():
    for name in ("specific_load", "eccentricity_ratio", "friction_power"):
        (column,) = [c for c in columns_of(GEAR) if c.heading == QUANTITIES[name].symbol]
        for result, cell in zip(GEAR, column.cells(GEAR), strict=True):
            assert column.cells([result]) == [cell]
            held = quantity_held(result, name)
            assert written(name, result.values[held]).split()[0] == cell.removesuffix("*")
            assert cell.endswith("*") == (held != name)


def test_what_is_no_number_is_a_dash():
    assert written("side_flow", math.nan) == "–"
