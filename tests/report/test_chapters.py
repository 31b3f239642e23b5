"""Chapters of a report: clearances of one bearing together, everything else apart."""

from __future__ import annotations

from dataclasses import replace

import gear_cases
import pytest

from babbitt.report.chapters import chapters
from babbitt.result_names import ResultName
from babbitt.standards.iso7902 import check
from babbitt.standards.iso7902.model import GivenLoad

EXAMPLE = gear_cases.EXAMPLE


def with_clearance(case, which, relative):
    given = (("Clearance", "fit H7/e7"), ("Clearance case", which))
    bearing = replace(case.bearing, relative_clearance=relative)
    return replace(case, name=ResultName(case.name, clearance=which), bearing=bearing, given=given)


THREE = tuple(
    with_clearance(EXAMPLE, which, relative)
    for which, relative in (("minimum", 0.9e-3), ("mean", 1.12e-3), ("maximum", 1.4e-3))
)


def of(*cases):
    return chapters(cases, tuple(check(case) for case in cases))


def test_clearances_of_one_bearing_are_one_chapter_and_the_one_nearest_a_limit_is_shown():
    (chapter,) = of(*THREE)
    assert chapter.name == "Example A"
    assert [member.clearance for member in chapter.members] == ["minimum", "mean", "maximum"]
    assert chapter.shown.result.margin == min(result.margin for result in chapter.results)
    assert chapter.shown_case.given == (("Clearance", "fit H7/e7"),)


def test_where_the_mean_has_no_operating_point_another_is_shown():
    results = [check(case) for case in THREE]
    results[1] = check(replace(THREE[1], duty=GivenLoad(9e7)))
    (chapter,) = chapters(THREE, results)
    assert chapter.shown.clearance in ("minimum", "maximum")


@pytest.mark.parametrize(
    "other",
    [
        replace(THREE[1], duty=GivenLoad(30e3)),
        replace(THREE[1], name=ResultName("Example B", clearance="mean")),
        replace(THREE[1], bearing=replace(THREE[1].bearing, width=0.061)),
        replace(THREE[1], name="Example A"),
    ],
)
def test_what_differs_in_more_than_the_clearance_stays_apart(other):
    found = of(THREE[0], other)
    assert [chapter.name for chapter in found] == [THREE[0].name, other.name]


def test_results_without_cases_stay_apart():
    results = tuple(check(case) for case in THREE)
    assert [chapter.name for chapter in chapters((), results)] == [case.name for case in THREE]
