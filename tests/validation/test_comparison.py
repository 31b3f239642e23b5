"""One published value beside ours: tolerance, verdict, text."""

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.validation import AtLeast, AtMost, Comparison, SetBy, Verdict, Within, by_quantity, summary

ROW = Comparison("So", "ε = 0.5", 2.0, 2.01, Within(relative=0.01), "", "table 1", 3)


@given(
    published=st.floats(-1e6, 1e6).filter(lambda x: abs(x) > 1e-3),
    relative=st.floats(1e-6, 1.0),
    share=st.floats(0.0, 10.0),
)
def test_share_is_the_deviation_in_units_of_the_tolerance(published, relative, share):
    computed = published + share * relative * abs(published)
    assert Within(relative=relative).share(published, computed) == pytest.approx(share, abs=1e-6)


def test_the_wider_of_both_tolerances_counts():
    fine_print = Within(relative=0.004, absolute=0.5e-4)
    assert fine_print.share(0.0025, 0.0025 + 0.5e-4) == pytest.approx(1.0)
    assert fine_print.share(100.0, 100.4) == pytest.approx(1.0)
    assert fine_print.describe() == "± 0.4 % or 0.00005"


def test_bounds_are_one_sided():
    most, least = AtMost(SetBy.SOURCE), AtLeast(SetBy.SOURCE)
    assert most.share(1300.0, 1162.0) < 1.0 < most.share(1300.0, 1301.0)
    assert least.share(8.0, 11.7) < 1.0 < least.share(8.0, 7.9)
    assert least.share(8.0, 0.0) == math.inf
    assert least.share(8.0, -11.7) == math.inf  # of the wrong sign, it passed
    assert most.share(1300.0, -5.0) == math.inf
    assert most.share(1300.0, 0.0) == 0.0


@pytest.mark.parametrize("bound", [AtMost, AtLeast])
def test_a_bound_names_who_set_it(bound):
    with pytest.raises(TypeError):
        bound()
    for who in SetBy:
        row = Comparison("root mean square", "", 1.5, 1.5, bound(who), "%")
        assert row.ok
        assert row.cells()[5].endswith(f"({who})")


def test_verdicts():
    assert ROW.verdict is Verdict.AGREES
    assert ROW.share == pytest.approx(0.5)
    wrong = replace(ROW, published=2.2)
    assert wrong.verdict is Verdict.DIFFERS
    assert not wrong.ok
    doubted = replace(wrong, suspect="misprint")
    assert doubted.verdict is Verdict.SUSPECT
    assert doubted.ok
    assert not doubted.judged
    shown = replace(wrong, information="inputs unknown")
    assert shown.verdict is Verdict.SHOWN
    assert shown.ok
    remarked = replace(wrong, remark="odd")
    assert remarked.judged
    assert not remarked.ok


def test_a_value_that_is_not_a_number_never_agrees():
    lost = replace(ROW, computed=math.nan)
    assert lost.verdict is Verdict.DIFFERS
    of_both = summary((lost, ROW))
    assert of_both.worst is lost
    assert of_both.largest_share == math.inf
    assert not of_both.agrees


def test_without_a_tolerance_there_must_be_a_reason():
    with pytest.raises(ValueError, match="why it is not judged"):
        replace(ROW, tolerance=None)
    assert replace(ROW, tolerance=None, information="for comparison").cells()[5] == "–"


@pytest.mark.parametrize(
    ("row", "cells"),
    [
        (ROW, ("So, ε = 0.5", "", "2.000", "2.0100", "+0.50 %", "± 1 %", "agrees")),
        (
            Comparison("T_ex", "180°", 76.5, 78.28, Within(absolute=2.0), "°C", "", 1),
            ("T_ex, 180°", "°C", "76.5", "78.28", "+1.78", "± 2", "agrees"),
        ),
        (
            Comparison("So", "limit", 1.0, 1.00004, Within(relative=1e-4)),
            ("So, limit", "", "1", "1.00004", "+0.004 %", "± 0.01 %", "agrees"),
        ),
        (
            Comparison("δ", "", 0.0, 3e-14, Within(absolute=1e-7), "%"),
            ("δ", "%", "0", "3e-14", "+3e-14", "± 1e-07", "agrees"),
        ),
    ],
)
def test_cells(row, cells):
    assert row.cells() == cells


def test_summary_counts_and_names_the_worst():
    rows = (
        ROW,
        replace(ROW, place="worse", computed=2.016),
        replace(ROW, quantity="β", computed=2.001),
        replace(ROW, computed=9.0, suspect="misprint"),
        replace(ROW, computed=9.0, information="for comparison"),
    )
    whole = summary(rows)
    assert (whole.values, whole.judged, whole.suspect, whole.shown, whole.differing) == (5, 3, 1, 1, 0)
    assert whole.largest_share == pytest.approx(0.8)
    assert whole.sentence == (
        "5 values, 3 judged (1 set aside, 1 shown without judgement); largest deviation 0.80 of its tolerance "
        "(So, worse); all agree."
    )
    assert {name: each.judged for name, each in by_quantity(rows).items()} == {"So": 2, "β": 1}
    assert "1 differ" in summary((*rows, replace(ROW, computed=3.0))).sentence


def test_a_case_in_which_nothing_is_judged_does_not_agree():
    assert not summary((replace(ROW, suspect="misprint"),)).agrees
    assert not summary(()).agrees
