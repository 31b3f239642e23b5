"""Formulas with branches over many values at once, and roots in all lanes together."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose

from babbitt.numerics.lane_roots import find_roots
from babbitt.numerics.lanes import Lanes, assembled, chooser, in_branches, lanes_of
from babbitt.numerics.roots import find_root
from babbitt.study.laws import Uniform


def folded(value):
    if value < 0.0:
        return -value
    if value > 2.0:
        raise ValueError("too large")
    return value * value


def test_each_lane_takes_its_own_branch():
    values = np.array([-3.0, 0.5, 1.5, -0.25, 7.0])
    found = np.full(5, np.nan)
    runs = []
    for index, answer in in_branches(lambda lanes: folded(lanes_of(values[lanes])), np.arange(5)):
        runs.append(index.size)
        if answer is not None:
            found[index] = answer
    assert sum(runs) == 5
    assert len(runs) == 3  # one a branch
    assert_allclose(found, [3.0, 0.25, 2.25, 0.25, np.nan])


def test_one_lane_that_breaks_off_leaves_the_others():
    def strict(lanes):
        if 5 in lanes:
            raise ArithmeticError
        return lanes

    known = [index for index, answer in in_branches(strict, np.arange(8)) if answer is not None]
    assert sorted(np.concatenate(known).tolist()) == [0, 1, 2, 3, 4, 6, 7]


def test_lanes_are_chosen_and_put_together_within_dataclasses():
    law = Uniform(lanes_of(np.array([1.0, 2.0, 3.0])), 9.0)
    ends = chooser((law, "word"))(np.array([2, 0]))
    assert ends[0].least.tolist() == [3.0, 1.0]
    assert (ends[0].most, ends[1]) == (9.0, "word")
    parts = [(np.array([2, 0]), Uniform(lanes_of(np.array([3.0, 1.0])), 9.0)), (np.array([1]), Uniform(2.0, 8.0))]
    whole = assembled(parts)
    assert whole.least.tolist() == [1.0, 2.0, 3.0]
    assert whole.most.tolist() == [9.0, 8.0, 9.0]
    with pytest.raises(ValueError, match="more than numbers"):
        assembled([(np.array([0]), Uniform(1.0, 2.0)), (np.array([1]), Uniform(1.0, 2.0, "another"))])


def test_lanes_show_no_number_of_a_single_one():
    lanes = lanes_of(np.array([1.0, 2.0]))
    assert f"{lanes:.3g}" == "many values"
    assert isinstance(round(lanes, 3), Lanes)


def test_roots_are_those_of_single_searches():
    levels = np.linspace(0.1, 5.0, 40)
    low, high = np.zeros(40), np.full(40, 3.0)

    def cubic(lanes, places):
        return places**3 + places - levels[lanes]

    lanes = np.arange(40)
    found = find_roots(cubic, low, high, cubic(lanes, low), cubic(lanes, high), 1e-12)
    assert_allclose(found**3 + found, levels, rtol=1e-12)
    single = [
        find_root(lambda x, level=level: x**3 + x - level, 0.0, 3.0, 1e-12).value for level in levels.tolist()
    ]
    assert_allclose(found, single, rtol=0.0, atol=1e-12)


def test_a_lane_without_numbers_has_no_root():
    def function(lanes, places):
        return np.where(lanes == 1, math.nan, places - 0.3)

    low, high = np.zeros(3), np.ones(3)
    found = find_roots(function, low, high, np.full(3, -0.3), np.full(3, 0.7), 1e-12)
    assert np.isnan(found).tolist() == [False, True, False]
