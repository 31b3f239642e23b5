"""Inputs that a single answer passes over: a heavy rotor, limits of the clearance, a metal of two families."""

import pytest

from babbitt import parse_case
from babbitt.core.notices import Effect
from babbitt.core.result import Verdict
from babbitt.kinds.journal.compare.comparison import compare
from babbitt.solving import solve

BEARING = """
kind: journal
name: A
diameter: 120 mm
width: 80 mm
clearance: {kind: relative, mean: 1.3 permille}
span: 360 deg
supply_element: {kind: pocket, width: 56 mm, place: both_sides}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.2 MPa}
materials: {bearing_metal: B83, bearing: C10, journal: 42CrMo4}
surfaces: {kind: direct, roughness_bearing: 2 um, roughness_journal: 1 um}
load: 24 kN
speed: 1200 rpm
"""


def answer(old="", new="", more=""):
    return solve(parse_case(BEARING.replace(old, new) + more))["A"]


def notices(result, code):
    return [one for one in result.warnings if one.code == code]


def missed_at(result):
    """Limits of the clearance that the result of a mean names: clearance, and codes of what stands against it."""
    for notice in notices(result, "W174"):
        for one in notice.values["missed"]:
            told = [
                clause.values.get("check") or ", ".join(clause.values["remarks"]) for clause in one.values["told"]
            ]
            yield one.values["at"].values["clearance"], tuple(dict.fromkeys(told))


def strictest_missed(result):
    """Codes of missed limits, of each quantity the strictest."""
    missed = sorted((one for one in result.limits if not one.ok), key=lambda one: -one.margin)
    return {one.quantity: one.code for one in missed}.values()


@pytest.mark.parametrize(("mass", "questioned"), [("2400 kg", False), ("2800 kg", True), ("600 t", True)])
def test_a_rotor_heavier_than_the_load_is_not_screened(mass, questioned):
    """600 t on a bearing of 24 kN passed cleanly; the film fails C115."""
    found = answer("1.3 permille", "1.5 permille", f"rotor_mass: {mass}\n")
    assert bool(notices(found, "W194")) is questioned
    assert found.verdict is (Verdict.REMARKS if questioned else Verdict.PASS)


@pytest.mark.parametrize(("limits", "code", "effect"), [
    ("minimum: 1.2 permille, maximum: 1.4 permille", "W174", Effect.QUESTIONS_RESULT),
    ("minimum: 0.1 permille, maximum: 1.4 permille", "W174", Effect.QUESTIONS_RESULT),
    ("minimum: 1.2 permille, maximum: 13 permille", "W174", Effect.QUESTIONS_RESULT),
])  # fmt: skip
def test_limits_of_the_clearance_that_nothing_solves_are_named(limits, code, effect):
    found = answer("mean: 1.3 permille", f"mean: 1.3 permille, {limits}")
    (notice,) = [*notices(found, "W174"), *notices(found, "W183")]
    assert (notice.code, notice.effect) == (code, effect)
    assert found.verdict is (Verdict.PASS if effect is Effect.INFORMATION else Verdict.REMARKS)


def test_near_limits_are_an_information_where_the_mean_is_asked_for():
    limits = "mean: 1.3 permille, minimum: 1.26 permille, maximum: 1.34 permille"
    found = answer("mean: 1.3 permille", limits, "clearance_cases: mean\nmethod: long_film\n")
    (of_limits,) = (one for one in notices(found, "W183") if one.variant == "limits_of_clearance")
    assert of_limits.effect is Effect.INFORMATION
    assert not notices(found, "W174")


@pytest.mark.parametrize(("method", "least", "most"), [("iso7902", 1.2, 1.4), ("film", 1.26, 1.34)])
def test_limits_that_the_method_solves_are_not_called_unused(method, least, most):
    limits = f"mean: 1.3 permille, minimum: {least} permille, maximum: {most} permille"
    found = answer("mean: 1.3 permille", limits, f"clearance_cases: mean\nmethod: {method}\n")
    assert not notices(found, "W183")
    assert not notices(found, "W174")
    assert found.verdict is Verdict.PASS


def test_limits_that_are_solved_or_not_asked_for_are_not_questioned():
    text = BEARING.replace(
        "mean: 1.3 permille", "mean: 1.3 permille, minimum: 0.8 permille, maximum: 2.7 permille"
    )
    found = solve(parse_case(text + "clearance_cases: all\n")).results
    assert len(found) == 3
    assert not any(notices(one, code) for one in found for code in ("W174", "W183"))
    fit = answer("{kind: relative, mean: 1.3 permille}", "{kind: fit, bore: H7, journal: d8}")
    assert notices(fit, "W174")
    fit = answer(
        "{kind: relative, mean: 1.3 permille}", "{kind: fit, bore: H7, journal: d8}", "clearance_cases: mean\n"
    )
    assert not notices(fit, "W174")
    assert not notices(fit, "W183")


@pytest.mark.parametrize(
    ("journal", "speed", "failing"),
    [("f7", "1200 rpm", 1), ("e7", "1200 rpm", 0), ("e7", "2000 rpm", 1), ("d8", "2600 rpm", 0)],
)
def test_the_mean_passes_without_a_word_only_where_the_limits_of_the_clearance_pass(journal, speed, failing):
    """`clearance_cases: all` is the answer that a clean pass at the mean must not contradict."""
    fit = BEARING.replace("{kind: relative, mean: 1.3 permille}", f"{{kind: fit, bore: H7, journal: {journal}}}")
    text = fit.replace("1200 rpm", speed)
    every = solve(parse_case(text + "clearance_cases: all\n")).results
    (mean,) = solve(parse_case(text + "clearance_cases: mean\n")).results
    missed = [
        (
            one.values["relative_clearance"],
            tuple(strictest_missed(one)) or one.questioning_codes,
        )
        for one in every
        if one.verdict is not Verdict.PASS
    ]
    assert [one.verdict for one in every].count(Verdict.FAIL) == failing
    assert list(missed_at(mean)) == missed
    assert mean.values["outlet_temperature"] == every[1].values["outlet_temperature"]
    assert mean.verdict is (Verdict.REMARKS if missed else Verdict.PASS)


WARM_FIT = """
kind: journal
name: A
diameter: 125 mm
width: 50 mm
clearance: H7/f7
span: 360 deg
supply_element: {kind: slot, length: 30 mm, width: 12.5 mm, place: side}
lubricant: ISO VG 32
supply: {temperature: 40 degC, pressure: 0.3 MPa}
materials: {bearing_metal: SnSb8Cu4, bearing: EN-GJL-250, journal: C45}
specific_load: 2.6 MPa
surface_speed: 15 m/s
"""
WIDE_FIT = """
kind: journal
name: A
diameter: 100 mm
width: 69 mm
clearance: {kind: relative, mean: 2.35 permille, minimum: 1.88 permille, maximum: 2.82 permille}
span: 360 deg
supply_element: {kind: slot, length: 36 mm, width: 10 mm, place: side}
lubricant: ISO VG 46
supply: {temperature: 44 degC, pressure: 0.34 MPa}
materials:
  bearing_metal: CuPb10Sn10
  bearing: {thermal_expansion: 19.6e-6 1/K}
  journal: {thermal_expansion: 15.2e-6 1/K}
specific_load: 3.95 MPa
surface_speed: 4.29 m/s
"""


@pytest.mark.parametrize(("text", "verdict"), [(WARM_FIT, Verdict.FAIL), (WIDE_FIT, Verdict.REMARKS)])
def test_a_mean_that_its_own_film_confirms_is_held_at_the_limits_of_the_clearance_too(text, verdict):
    """They passed cleanly; of the second the film alone at the largest clearance misses a limit."""
    every = solve(parse_case(text + "clearance_cases: all\n")).results
    (mean,) = solve(parse_case(text + "clearance_cases: mean\n")).results
    (calculation,) = parse_case(text + "clearance_cases: mean\n").calculations()
    assert "W191" in calculation.only(()).solve()[0].result.questioning_codes
    assert max((one.verdict for one in every), key=list(Verdict).index) is verdict
    (worst,) = (one for one in every if one.verdict is verdict)
    assert [one[0] for one in missed_at(mean)] == [worst.values["relative_clearance"]]
    assert mean.verdict is Verdict.REMARKS


WHIRLING = """
kind: journal
name: A
diameter: 100 mm
width: 60 mm
clearance: {kind: relative, mean: 1.6 permille, minimum: 1.5311 permille, maximum: 1.672 permille}
span: 360 deg
supply_element: {kind: pocket, width: 40 mm, place: both_sides}
lubricant: ISO VG 32
supply: {temperature: 45 degC, pressure: 0.2 MPa}
materials: {bearing_metal: SnSb8Cu4, bearing: EN-GJL-250, journal: C45}
load: 4 kN
speed: 6000 rpm
rotor_mass: 565 kg
method: {kind: film, thermal: full}
"""
HELD = """
kind: journal
name: A
diameter: 100 mm
width: 60 mm
clearance: H7/e8
span: 360 deg
supply_element: {kind: pocket, width: 40 mm, place: both_sides}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.2 MPa}
materials: {bearing_metal: SnSb8Cu4, bearing: EN-GJL-250, journal: C45}
limits: {minimum_film_thickness: 12 um}
speed: 1500 rpm
eccentricity_ratio: 0.7
"""


@pytest.mark.parametrize(("text", "code"), [(WHIRLING, "C115"), (HELD, "C101")])
def test_near_limits_of_a_film_and_those_at_a_given_eccentricity_are_solved_too(text, code):
    """Both passed cleanly; of the first the rotor whirls at the largest clearance, 1.045 times the mean."""
    every = solve(parse_case(text + "clearance_cases: all\n")).results
    (mean,) = solve(parse_case(text + "clearance_cases: mean\n")).results
    (worst,) = (one for one in every if one.verdict is Verdict.FAIL)
    assert list(missed_at(mean)) == [(worst.values["relative_clearance"], (code,))]
    assert mean.verdict is Verdict.REMARKS


@pytest.mark.parametrize(("text", "more"), [
    (WHIRLING, "limits: {minimum_film_thickness: 47.5 um}\n"), (WARM_FIT, "friction: {factor: 0.99}\n"),
])  # fmt: skip
def test_what_questions_the_mean_hides_no_limit_of_the_clearance_that_fails(text, more):
    """Little margin, or a factor of friction, hid them: only a clean pass was solved at its limits."""
    every = solve(parse_case(text + more + "clearance_cases: all\n")).results
    (mean,) = solve(parse_case(text + more + "clearance_cases: mean\n")).results
    failing = [one.values["relative_clearance"] for one in every if one.verdict is Verdict.FAIL]
    assert failing
    assert len(mean.questioning_codes) > 1
    assert [one[0] for one in missed_at(mean)] == failing


def test_rows_of_a_study_are_held_at_the_limits_of_a_mean_clearance_too():
    """The rows of films passed cleanly where the bearing alone is questioned."""
    case = parse_case(WHIRLING + "clearance_cases: mean\n")
    whole, row = (solve(case, only=only).results[0] for only in (None, ()))
    assert (row.verdict, row.questioning_codes) == (whole.verdict, whole.questioning_codes)


def test_a_film_at_a_given_position_is_solved_at_near_limits_of_its_clearance_too():
    """It passed cleanly, without a word on the limits; the least clearance has 20.4 of 21 um at that position."""
    sizes = "{kind: deviations, bore: [0 um, 7 um], journal: [-167 um, -160 um]}"
    text = HELD.replace("H7/e8", sizes).replace("eccentricity_ratio: 0.7", "position: {x: 30 um, y: -53 um}")
    text = text.replace("12 um", "21 um") + "method: film\n"
    every = solve(parse_case(text + "clearance_cases: all\n")).results
    (mean,) = solve(parse_case(text + "clearance_cases: mean\n")).results
    failing = [one for one in every if one.verdict is Verdict.FAIL]
    assert [one[0] for one in missed_at(mean)] == [one.values["relative_clearance"] for one in failing] != []


def test_films_in_a_comparison_are_of_the_mean_clearance_alone():
    """Beside ISO 7902 they passed cleanly where `method: film` is questioned."""
    case = parse_case(WARM_FIT + "clearance_cases: mean\n")
    (found,) = compare(case)
    films = [one.solution.result for one in found.methods if one.solution.result.method == "film"]
    assert films
    assert all(notices(one, "W174") for one in films)


@pytest.mark.parametrize(("family", "questioned"), [("copper-lead", True), ("tin-based", False)])
def test_a_metal_of_the_catalogue_has_its_own_family(family, questioned):
    found = answer("bearing_metal: B83", f"bearing_metal: {{name: SnSb8Cu4, family: {family}}}")
    assert bool(notices(found, "W175")) is questioned
    if questioned:
        assert (
            notices(found, "W175")[0].message
            == f"SnSb8Cu4 is tin-based in the catalogue, and the case says {family}"
        )
