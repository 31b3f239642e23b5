"""Chapters of a report: clearances of one bearing together, everything else apart."""

from __future__ import annotations

from dataclasses import replace

import gear_cases
import pytest

from babbitt.case import parse_case
from babbitt.core.result import Bound, Check
from babbitt.core.result_name import ResultName
from babbitt.core.solution import Solution
from babbitt.kinds.journal.iso7902 import check
from babbitt.kinds.journal.iso7902.model import PrescribedLoad
from babbitt.kinds.journal.iso7902.supply import Arrangement, Holes
from babbitt.kinds.journal.report.views import ISO7902
from babbitt.report.bearing_content import bearing_content, calculation_content
from babbitt.report.chapters import chapters
from babbitt.report.content import content
from babbitt.report.inputs import inputs
from babbitt.solving import solve

EXAMPLE = gear_cases.EXAMPLE


def with_clearance(case, which, relative):
    given = (("Clearance", "fit H7/e7"), ("Clearance case", which))
    bearing = replace(case.bearing, relative_clearance=relative)
    return replace(case, name=ResultName(case.name, clearance=which), bearing=bearing, given=given)


THREE = tuple(
    with_clearance(EXAMPLE, which, relative)
    for which, relative in (("minimum", 0.9e-3), ("mean", 1.12e-3), ("maximum", 1.4e-3))
)


def solved(cases, results):
    return tuple(Solution(case, result) for case, result in zip(cases, results, strict=True))


def of(*cases):
    return chapters(solved(cases, [check(case) for case in cases]))


def test_clearances_of_one_bearing_are_one_chapter_and_the_one_nearest_a_limit_is_shown():
    (chapter,) = of(*THREE)
    assert chapter.name == "Example A"
    assert [member.clearance for member in chapter.members] == ["minimum", "mean", "maximum"]
    assert chapter.shown.result.margin == min(result.margin for result in chapter.results)
    assert chapter.given == (("Clearance", "fit H7/e7"),)


def test_where_the_mean_has_no_operating_point_another_is_shown():
    results = [check(case) for case in THREE]
    results[1] = check(replace(THREE[1], duty=PrescribedLoad(9e7)))
    (chapter,) = chapters(solved(THREE, results))
    assert chapter.shown.clearance in ("minimum", "maximum")


@pytest.mark.parametrize(
    "other",
    [
        replace(THREE[1], duty=PrescribedLoad(30e3)),
        replace(THREE[1], name=ResultName("Example B", clearance="mean")),
        replace(THREE[1], bearing=replace(THREE[1].bearing, width=0.061)),
        replace(THREE[1], name="Example A"),
    ],
)
def test_what_differs_in_more_than_the_clearance_stays_apart(other):
    found = of(THREE[0], other)
    assert [chapter.name for chapter in found] == [THREE[0].name, other.name]


def held(code, quantity, value, limit):
    return Check(code, quantity, value, limit, Bound.AT_MOST, "test")


def test_the_clearance_with_most_misses_is_shown_in_full():
    load, hot = ("C103", "specific_load"), ("C104", "outlet_temperature")
    checks = (
        (held(*load, 5.1e6, 5e6), held(*hot, 363.15 + 1.0, 363.15)),  # two misses, both slight
        (held(*load, 4e6, 5e6), held(*hot, 363.15 - 1.0, 363.15)),
        (held(*load, 4e6, 5e6), held(*hot, 363.15 + 30.0, 363.15)),  # one, grave
    )
    results = [replace(check(case), checks=own) for case, own in zip(THREE, checks, strict=True)]
    (chapter,) = chapters(solved(THREE, results))
    assert chapter.shown.clearance == "minimum"


def test_temperatures_count_by_the_rise_that_they_may_have():
    """80 of 90 degC, supplied at 40, have used 80 % of their rise; a load of 0.85 of its limit is nearer."""
    hot = held("C104", "outlet_temperature", 273.15 + 80.0, 273.15 + 90.0)
    loads = [held("C103", "specific_load", share, 1.0) for share in (0.85, 0.75)]
    for load, nearest in zip(loads, ("mean", "minimum"), strict=True):
        results = [
            replace(check(case), checks=own, values=check(case).values | {"supply_temperature": 313.15})
            for case, own in zip(THREE, ((hot,), (load,), (held("C103", "specific_load", 0.1, 1.0),)), strict=True)
        ]
        (chapter,) = chapters(solved(THREE, results))
        assert chapter.shown.clearance == nearest


def test_each_clearance_has_its_own_supply_temperature():
    results = [
        replace(
            check(case),
            arrays={"groove_angles": ((1.5,),), "groove_fresh_flows": ((flow,),), "groove_temperatures": ((at,),)},
        )
        for case, flow, at in zip(THREE, (1e-5, 2e-5, 3e-5), (313.15, 323.15, 333.15), strict=True)
    ]
    (chapter,) = chapters(solved(THREE, results))
    rows = {row["label"].rpartition(", ")[2]: row["values"] for row in bearing_content(chapter)["results"]}
    assert rows["mixing temperature"] == ["40.0", "50.0", "60.0"]
    assert len(set(rows["fresh oil"])) == 3


def test_round_holes_are_no_slot():
    two = replace(EXAMPLE, bearing=replace(EXAMPLE.bearing, supply_element=Holes(0.005, Arrangement.SIDE, 2.0)))
    slot = replace(
        EXAMPLE, bearing=replace(EXAMPLE.bearing, supply_element=Holes(0.0144, Arrangement.SIDE, 2.741))
    )
    said = [
        {row.label: row.value for group in inputs(case, ISO7902, ()) for row in group.rows}["Supply element"]
        for case in (two, slot)
    ]
    assert said[0].startswith("2 holes ")
    assert said[1].startswith("2.741 holes (a slot")


def test_what_the_bearings_of_a_machine_say_of_themselves_is_told():
    text = """
kind: machine
name: Mill
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.2 MPa}
materials: {bearing: C10, journal: 42CrMo4}
bearings:
  - {kind: journal, name: A, diameter: 120 mm, width: 60 mm, span: 360 deg,
     clearance: {kind: relative, mean: 1.5 permille},
     load: 12 kN, speed: 2000 rpm, notes: Worn in 2020., source: Drawing 7}
"""
    told = content(solve(parse_case(text)))
    rows = {row["label"]: row["value"] for group in told["bearings"][0]["inputs"] for row in group["rows"]}
    assert rows["Notes"] == "Worn in 2020."
    assert rows["Source of the numbers"] == "Drawing 7"


def test_a_journal_that_turns_clockwise_says_so():
    forward, backward = check(EXAMPLE), check(replace(EXAMPLE, journal_speed=-EXAMPLE.journal_speed))
    assert backward.angular_speed == -forward.angular_speed < 0.0
    assert backward.surface_speed == forward.surface_speed
    (chapter,) = of(replace(EXAMPLE, journal_speed=-EXAMPLE.journal_speed))
    shown = [line for part in calculation_content(chapter) for line in part["lines"]]
    assert any("U = " in line["spoken"] for line in shown)
