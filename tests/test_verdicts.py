"""The five verdicts: from the outcome, the checks made and not made, and what warnings do to the result."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from babbitt import parse_case
from babbitt.cli import main
from babbitt.core.notices import Effect, Notice, Subject, explanations
from babbitt.core.notices.words import words
from babbitt.core.result import Bound, Check, Outcome, Result, Verdict
from babbitt.solving import solve

FILM = Check("C101", "minimum_film_thickness", 30e-6, 10e-6, Bound.AT_LEAST, "test")
WARM = Check("C104", "outlet_temperature", 353.15, 373.15, Bound.AT_MOST, "test")
LOAD = Check("C103", "specific_load", 1e6, 5e6, Bound.AT_MOST, "test")
GOOD = Result("A", "journal", "iso7902", Outcome.CONVERGED, {}, (FILM, WARM, LOAD))

CASE = """
kind: journal
name: A
diameter: 120 mm
width: 60 mm
clearance: {kind: relative, mean: 1.5 permille}
span: 150 deg
supply_element: {kind: pocket, width: 42 mm, place: both_sides}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.2 MPa}
load: 12 kN
speed: 2000 rpm
"""
BARE = CASE + "materials: {bearing: C10, journal: C45}\n"
NAMED = CASE + "materials: {bearing_metal: SnSb8Cu4, bearing: C10, journal: C45}\n"


def notice_with(effect: Effect) -> Notice:
    """A warning of that effect which needs no values."""
    plain = (key for key, text in words().messages.items() if key[0].startswith("W") and "{" not in text)
    return next(Notice(*key) for key in plain if explanations()[key[0]].effect is effect)


@pytest.mark.parametrize(
    ("effect", "verdict"),
    [
        (Effect.INFORMATION, Verdict.PASS),
        (Effect.QUESTIONS_RESULT, Verdict.REMARKS),
        (Effect.NO_VERDICT, Verdict.NO_VERDICT),
    ],
)
def test_a_warning_acts_by_its_effect(effect: Effect, verdict: Verdict) -> None:
    assert GOOD.verdict is Verdict.PASS
    warned = replace(GOOD, warnings=(notice_with(effect),))
    assert warned.verdict is verdict
    assert warned.within_limits == (verdict in (Verdict.PASS, Verdict.REMARKS))


def test_a_missed_limit_outweighs_a_model_that_ends_and_a_recommendation_weighs_nothing() -> None:
    thin = replace(FILM, value=5e-6)
    outside = notice_with(Effect.NO_VERDICT)
    assert replace(GOOD, checks=(thin, WARM, LOAD), warnings=(outside,)).verdict is Verdict.FAIL
    screened = replace(thin, code="C112", advisory=True)
    assert replace(GOOD, checks=(*GOOD.checks, screened)).verdict is Verdict.PASS


def test_what_is_not_solved_has_no_solution_whatever_it_was_held_against() -> None:
    lost = replace(GOOD, outcome=Outcome.OVERLOADED)
    assert lost.verdict is Verdict.NO_SOLUTION
    assert not lost.within_limits
    assert lost.governing_check is None


@pytest.mark.parametrize(
    ("subject", "codes"),
    [
        (Subject.FILM_THICKNESS, ("C101", "C102")),
        (Subject.TEMPERATURE, ("C104", "C108")),
        (Subject.SPECIFIC_LOAD, ("C103", "C105")),
    ],
)
def test_each_subject_needs_one_check(subject: Subject, codes: tuple[str, str]) -> None:
    made = tuple(check for check in GOOD.checks if check.code not in codes)
    missing = tuple(Notice(code, "prescribed_temperature") for code in codes)
    lacking = replace(GOOD, checks=made, not_checked=missing)
    assert lacking.verdict is Verdict.NO_VERDICT
    assert lacking.lacking == (subject,)
    assert replace(GOOD, not_checked=missing[1:]).verdict is Verdict.PASS  # the other one was made
    recommended = tuple(replace(check, advisory=True) for check in GOOD.checks if check.code in codes)
    assert replace(lacking, checks=(*made, *recommended)).verdict is Verdict.NO_VERDICT  # that is no check
    assert replace(GOOD, checks=(*made, *recommended)).lacking == (subject,)


def test_the_governing_check_has_the_least_margin_and_temperatures_count_in_celsius() -> None:
    assert WARM.margin == pytest.approx(0.2)  # 80 of 100 °C; of 373 K it would be 5 %
    near = replace(LOAD, value=4.5e6)
    found = replace(GOOD, checks=(FILM, WARM, near))
    assert found.governing_check is near
    assert found.margin == pytest.approx(0.1)


def test_a_bearing_without_a_metal_is_not_passed(tmp_path, capsys) -> None:
    bare, file = solve(parse_case(BARE))["A"], tmp_path / "bare.yaml"
    assert bare.verdict is Verdict.NO_VERDICT
    assert bare.lacking == (Subject.SPECIFIC_LOAD,)
    named = solve(parse_case(NAMED))["A"]
    assert named.verdict is Verdict.PASS
    limited = solve(parse_case(BARE + "limits: {specific_load: 3 MPa}\n"))["A"]
    assert limited.verdict is Verdict.PASS
    assert limited.governing_check.code in {"C101", "C103", "C104"}
    file.write_text(BARE, encoding="utf-8")
    assert status_of(["solve", str(file)]) == 0
    assert "no verdict" in capsys.readouterr().out
    assert status_of(["solve", str(file), "--strict"]) == 1


def test_a_prescribed_temperature_gives_no_verdict_but_can_fail() -> None:
    case = NAMED + "effective_temperature: 60 degC\n"
    found = solve(parse_case(case))["A"]
    assert found.verdict is Verdict.NO_VERDICT
    assert found.lacking == (Subject.TEMPERATURE,)
    thick = solve(parse_case(case + "limits: {minimum_film_thickness: 200 um}\n"))["A"]
    assert thick.verdict is Verdict.FAIL


def test_nothing_held_against_a_limit_is_no_pass() -> None:
    assert replace(GOOD, kind="jacking_pocket", checks=()).verdict is Verdict.NO_VERDICT
    advised = replace(FILM, advisory=True)
    assert replace(GOOD, kind="jacking_pocket", checks=(advised,)).verdict is Verdict.NO_VERDICT


def test_json_tells_verdict_governing_check_and_margin(tmp_path) -> None:
    file, record = tmp_path / "a.yaml", tmp_path / "a.json"
    file.write_text(NAMED, encoding="utf-8")
    assert status_of(["solve", str(file), "--json", str(record), "--strict"]) == 0
    (bearing,) = json.loads(record.read_text(encoding="utf-8"))["bearings"]
    assert bearing["verdict"] == "pass"
    assert bearing["within_limits"] is True
    least = min((one for one in bearing["checks"] if not one["advisory"]), key=lambda one: one["margin"])
    assert bearing["governing_check"] == least["code"]
    assert bearing["margin"] == least["margin"]


def test_one_rule_screens_for_whirl_and_it_changes_nothing() -> None:
    light = solve(parse_case(NAMED.replace("12 kN", "1 kN").replace("0.2 MPa", "0.05 MPa")))["A"]
    screened = [check for check in light.checks if check.code == "C112"]
    assert [check.ok for check in screened] == [False]
    assert screened[0].advisory
    assert light.verdict is Verdict.PASS
    assert {"W108", "C113"}.isdisjoint(explanations())


def status_of(arguments: list[str]) -> int:
    import sys

    told, sys.argv = sys.argv, ["babbitt", *arguments]
    try:
        main()
    except SystemExit as ending:
        return int(ending.code or 0)
    finally:
        sys.argv = told
    return 0
