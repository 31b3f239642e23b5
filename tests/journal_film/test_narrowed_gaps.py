"""Films of one temperature whose gap tilt narrows at the edge: how much thinner they may be than they say."""

import pytest

from babbitt import parse_case
from babbitt.core.result import Verdict
from babbitt.kinds.journal.case.build import calculations
from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.film.thinner_oil import film_over_viscosity
from babbitt.kinds.journal.one_temperature import THINNER, THINNER_OIL
from babbitt.solving import solve

TILTED = """
kind: journal
name: A
method: film
accuracy: draft
diameter: 300 mm
width: 240 mm
clearance: {kind: relative, mean: 1.5 permille}
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.2 MPa}
pockets: [{angle: 0 deg, extent: 25 deg, width: 190 mm}, {angle: 180 deg, extent: 25 deg, width: 190 mm}]
materials: {bearing_metal: B83, bearing: C10, journal: 42CrMo4}
surfaces: {kind: direct, roughness_bearing: 2 um, roughness_journal: 1 um}
load: 200 kN
speed: 1500 rpm
misalignment: {x: 0.58 mrad, y: 0 mrad}
"""
LEVEL = TILTED.replace("misalignment: {x: 0.58 mrad, y: 0 mrad}\n", "")


def film(text):
    case = calculations(parse_case(text))[0].problem
    return case, operating_film(case).film


def said(result, code):
    return [one.message for one in result.warnings if one.code == code]


def test_the_edge_of_a_tilted_journal_loses_more_than_the_viscosity():
    """The loss at the edge stays: of 20.9 µm the film with temperatures of its own has 9.7; aligned 0.8 times."""
    case, state = film(TILTED)
    thickness = film_over_viscosity(case, state)
    whole = state.solution.minimum_film_thickness
    assert thickness(1.0) == pytest.approx(whole, rel=1e-6)
    assert thickness(0.55) < 0.55 * whole
    level, aligned = film(LEVEL)
    assert film_over_viscosity(level, aligned) is None


def test_the_viscosity_asked_of_tilted_journals_is_the_margin_asked_of_others():
    case, state = film(LEVEL)
    thinner = LEVEL + f"effective_temperature: {state.temperature:.4f} K\n"
    oil = case.lubricant.viscosity
    factor = oil(state.temperature + 16.0) / oil(state.temperature)
    assert factor == pytest.approx(THINNER_OIL, abs=0.02)
    there = film(thinner.replace(f"{state.temperature:.4f}", f"{state.temperature + 16.0:.4f}"))[1]
    share = there.solution.minimum_film_thickness / state.solution.minimum_film_thickness
    assert share * (1.0 + THINNER) == pytest.approx(1.0, abs=0.06)


def test_a_tilted_film_must_keep_its_limit_with_thinner_oil():
    """20.9 µm keep 10 µm by more than a level film is asked for; with temperatures of its own it has 9.7."""
    tilted = solve(parse_case(TILTED + "limits: {minimum_film_thickness: 10 um}\n"))["A"]
    check = next(one for one in tilted.checks if one.code == "C101")
    assert check.margin > THINNER
    (message,) = said(tilted, "W191")
    assert "(C101), with 50.8 % of the viscosity" in message
    assert tilted.verdict is Verdict.REMARKS
    assert not said(solve(parse_case(LEVEL))["A"], "W191")
    slight = TILTED.replace("0.58 mrad", "0.3 mrad")
    assert not said(solve(parse_case(slight))["A"], "W191")
