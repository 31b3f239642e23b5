"""Films of one temperature whose gap tilt narrows at the edge: how much thinner they may be than they say."""

from dataclasses import replace

import pytest

from babbitt import parse_case
from babbitt.core.result import Bound, Check, Verdict
from babbitt.design.conditions import PrescribedLoad
from babbitt.kinds.journal.case.build import calculations
from babbitt.kinds.journal.film.fuller_film import THINNER_OIL, film_over_viscosity, fuller_film
from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.one_temperature import THINNER
from babbitt.reynolds.model import Cavitation
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
TILTED_BESIDE_A_HOLE = """
kind: journal
name: A
method: film
limiting_speeds: false
diameter: 169.185 mm
width: 45.6156 mm
clearance: {kind: relative, mean: 3.72476 permille}
span: 360 deg
supply_element: {kind: hole, diameter: 8.15544 mm, place: side, number: 1}
lubricant: ISO VG 220
supply: {temperature: 48.2796 degC, pressure: 0.763098 bar}
materials: {bearing_metal: B88, bearing: {thermal_expansion: 1.8e-05 1/K}, journal: C45}
specific_load: 2.01963 MPa
surface_speed: 8.90477 m/s
misalignment: {x: -0.258793 mrad, y: 0.369677 mrad}
"""
LEVEL = TILTED.replace("misalignment: {x: 0.58 mrad, y: 0 mrad}\n", "")


def film(text):
    case = calculations(parse_case(text))[0].problem
    return case, operating_film(case).film


def said_of_films(result):
    """What W191 says of the film thickness."""
    found = [part for one in result.warnings if one.code == "W191" for part in one.values["kept"]]
    return [one for one in found if one.values["check"] == "C101"]


def test_the_edge_of_a_tilted_journal_loses_more_than_the_viscosity():
    """The loss at the edge stays: of 20.9 µm the film with temperatures of its own has 9.7; aligned 0.8 times."""
    case, state = film(TILTED)
    thickness = film_over_viscosity(case, state)
    whole = state.solution.minimum_film_thickness
    assert thickness(1.0) == pytest.approx(whole, rel=1e-6)
    assert thickness(0.55) < 0.55 * whole
    assert fuller_film(*film(LEVEL)) is None


def test_a_tilted_film_must_keep_its_limit_with_temperatures_of_its_own():
    """20.9 µm keep 10 µm by more than a level film is asked for; with temperatures of its own it has 9.7."""
    limited = TILTED + "limits: {minimum_film_thickness: 10 um}\n"
    tilted, full = (solve(parse_case(text))["A"] for text in (limited, limited + "thermal: full\n"))
    check = next(one for one in tilted.checks if one.code == "C101")
    assert check.margin > THINNER
    (kept,) = said_of_films(tilted)
    assert kept.variant == "thermal_film"
    assert kept.values["thin"] == pytest.approx(full.minimum_film_thickness, rel=1e-9)
    assert full.minimum_film_thickness < 10e-6
    assert tilted.verdict is Verdict.REMARKS
    assert not said_of_films(solve(parse_case(LEVEL))["A"])
    slight = TILTED.replace("0.58 mrad", "0.3 mrad")
    assert not said_of_films(solve(parse_case(slight))["A"])


def test_a_tilted_film_that_invents_oil_or_carries_nothing_has_an_end():
    """The film with its own temperatures conserves its oil; without load it holds the journal nowhere."""
    case, state = film(TILTED)
    inventing = fuller_film(replace(case, cavitation=Cavitation.REYNOLDS), state)
    check = Check("C101", "minimum_film_thickness", 20e-6, 10e-6, Bound.AT_LEAST, "")
    assert inventing(check, 1.0).variant == "thermal_film"
    assert fuller_film(replace(case, duty=PrescribedLoad(0.0)), state) is None


def test_the_bush_of_a_tilted_film_must_keep_the_limit_of_its_metal():
    hottest = solve(parse_case(TILTED + "thermal: full\n"))["A"].maximum_bush_temperature
    about = fuller_film(*film(TILTED))
    kept, missed = (
        Check("C108", "outlet_temperature", 330.0, hottest + more, Bound.AT_MOST, "") for more in (0.1, -0.1)
    )
    assert about(kept, 1.0) is None
    told = about(missed, 1.0)
    assert (told.variant, told.values["hottest"]) == ("thermal_bush", pytest.approx(hottest, rel=1e-9))


def test_a_tilted_film_of_given_temperature_must_keep_its_limit_with_thinner_oil():
    """No film with temperatures of its own is known of it."""
    case, _ = film(TILTED)
    slight = TILTED.replace("0.58 mrad", "0.2 mrad")
    given = slight + "effective_temperature: 60 degC\nlimits: {minimum_film_thickness: 20 um}\n"
    asked, state = film(given)
    assert case.fuller is not None
    assert asked.fuller is None
    (kept,) = said_of_films(solve(parse_case(given))["A"])
    thin = film_over_viscosity(asked, state)(THINNER_OIL)
    assert (kept.variant, kept.values["thin"]) == ("narrowed_gap", pytest.approx(thin, rel=1e-6))


def test_a_tilted_film_that_heat_takes_half_of_is_questioned():
    """Thick oil, one small hole at the side: 17.9 µm of one temperature keep 9.0 by 99 %; the full film: 8.8."""
    found, full = (solve(parse_case(TILTED_BESIDE_A_HOLE + more))["A"] for more in ("", "thermal: full\n"))
    assert found.minimum_film_thickness > 1.9 * next(one.limit for one in found.checks if one.code == "C101")
    assert full.verdict is Verdict.FAIL
    (kept,) = said_of_films(found)
    assert kept.values["thin"] == pytest.approx(full.minimum_film_thickness, rel=1e-9)


def test_the_orbit_of_a_tilted_journal_is_asked_for_with_thinner_oil(request):
    """30.3 µm at its thinnest keep 14 µm by 117 %; with 0.35 of the viscosity it comes to 8.3 µm."""
    fan = (request.config.rootpath / "examples" / "unbalanced_fan.yaml").read_text(encoding="utf-8")
    level = fan.replace("load: 20 kN", "load: 30 kN") + "accuracy: draft\nlimiting_speeds: false\n"
    assert not said_of_films(solve(parse_case(level)).results[0])
    result = solve(parse_case(level + "misalignment: {x: 0.6 mrad}\n")).results[0]
    on_orbit = next(one for one in result.checks if one.quantity == "orbit_minimum_film_thickness")
    (said,) = said_of_films(result)
    assert (said.variant, said.values["margin"]) == ("narrowed_gap", pytest.approx(on_orbit.margin))
    assert said.values["thin"] < on_orbit.limit < 0.5 * on_orbit.value


BESIDE_A_HOLE = """
kind: journal
name: A
method: film
accuracy: draft
limiting_speeds: false
diameter: 120 mm
width: 89.71 mm
clearance: {kind: relative, mean: 2.908 permille}
lubricant: ISO VG 100
supply: {temperature: 52.9 degC, pressure: 0.13 MPa}
holes: [{angle: 0 deg, diameter: 8.97 mm}]
materials: {bearing_metal: B83, bearing: C10, journal: 42CrMo4}
specific_load: 0.29 MPa
surface_speed: 13 m/s
"""


def test_a_rotor_must_be_stable_with_temperatures_of_its_film():
    """A hole beside the load: critical masses of 23.1 t with one temperature, of 13.9 t with those of its own."""
    one, full = (solve(parse_case(BESIDE_A_HOLE + more))["A"].critical_mass for more in ("", "thermal: full\n"))
    assert full < 0.65 * one

    def said(mass):
        found = solve(parse_case(BESIDE_A_HOLE + f"rotor_mass: {mass} kg\n"))["A"]
        return [part for notice in found.warnings if notice.code == "W191" for part in notice.values["kept"]]

    assert not said(0.99 * full)
    (told,) = said(1.01 * full)
    assert told.variant == "thermal_critical_mass"
    assert told.values["mass"] == pytest.approx(full, rel=1e-9)
    assert told.values["margin"] == pytest.approx(one / (1.01 * full) - 1.0, rel=1e-9)
