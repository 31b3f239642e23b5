"""What films of one temperature miss once they have temperatures of their own, or thinner oil."""

from dataclasses import replace

import pytest

from babbitt import parse_case
from babbitt.core.notices import Notice
from babbitt.core.result import Outcome, Verdict
from babbitt.design.conditions import PrescribedLoad
from babbitt.kinds.journal.case.build import calculations
from babbitt.kinds.journal.film.check import film_by_its_model
from babbitt.kinds.journal.film.fuller_film import (
    THINNER_OIL,
    film_over_viscosity,
    misses_a_limit,
    thinner_film,
    warnings_of_fuller_film,
)
from babbitt.kinds.journal.film.isothermal import operating_film
from babbitt.kinds.journal.one_temperature import THINNER
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


def told(result):
    """What W191 says."""
    found = [one for one in result.warnings if one.code == "W191"]
    return [part for one in found for name in ("told", "kept") for part in one.values.get(name, ())]


def said_of_films(result):
    """What W191 says of the film thickness."""
    return [one for one in told(result) if one.values.get("check") == "C101"]


def test_the_edge_of_a_tilted_journal_loses_more_than_the_viscosity():
    """The loss at the edge stays: of 20.9 µm the film with temperatures of its own has 9.7; aligned 0.8 times."""
    case, state = film(TILTED)
    thickness = film_over_viscosity(case, state)
    whole = state.solution.minimum_film_thickness
    assert thickness(1.0) == pytest.approx(whole, rel=1e-6)
    assert thickness(0.55) < 0.55 * whole
    assert thinner_film(*film(LEVEL)) is None


@pytest.mark.parametrize("cavitation", ["mass_conserving", "reynolds"])
def test_a_film_must_keep_its_limits_with_temperatures_of_its_own(cavitation):
    """20.9 µm keep 10 µm; with temperatures of its own, and its oil conserved, it has 9.7."""
    limited = TILTED + "limits: {minimum_film_thickness: 10 um}\n"
    tilted, full = (
        solve(parse_case(limited + more))["A"] for more in (f"cavitation: {cavitation}\n", "thermal: full\n")
    )
    assert next(one for one in tilted.checks if one.code == "C101").margin > THINNER
    (said,) = told(tilted)
    assert said.variant == "missed_film"
    assert said.values["value"] == pytest.approx(full.minimum_film_thickness, rel=1e-9)
    assert full.minimum_film_thickness < said.values["limit"] == pytest.approx(10e-6)
    assert tilted.verdict is Verdict.REMARKS


@pytest.mark.parametrize("text", [LEVEL, TILTED.replace("0.58 mrad", "0.3 mrad")])
def test_what_is_kept_with_temperatures_of_its_own_is_not_questioned(text):
    assert not told(solve(parse_case(text))["A"])


def test_no_film_is_asked_that_misses_a_limit_or_carries_nothing():
    asked = []
    case = calculations(parse_case(TILTED))[0].problem
    missed = solve(parse_case(TILTED + "limits: {minimum_film_thickness: 25 um}\n"))["A"]
    kept = solve(parse_case(TILTED))["A"]
    light = replace(case, duty=PrescribedLoad(0.0))
    for other, result in ((case, missed), (light, kept), (replace(case, fuller=None), kept)):
        assert not tuple(warnings_of_fuller_film(result, other.with_own_temperatures(), asked.append))
    assert not asked


def hottest_of_level():
    """Hottest bush of the level film with temperatures of its own, in °C."""
    return solve(parse_case(LEVEL + "thermal: full\n"))["A"].maximum_bush_temperature - 273.15


def level_within(celsius):
    """What W191 says of the level film whose temperatures have a limit."""
    return told(solve(parse_case(LEVEL + f"limits: {{temperature: {celsius} degC}}\n"))["A"])


def test_the_bush_must_keep_its_limit_with_temperatures_of_its_own():
    hottest = hottest_of_level()
    assert not level_within(hottest + 20.0)
    (said,) = level_within(hottest - 0.1)
    assert (said.variant, said.values["value"]) == ("missed_bush", pytest.approx(hottest + 273.15, rel=1e-9))


def test_a_film_that_closes_with_temperatures_of_its_own_is_told():
    def overloaded(case):
        found = film_by_its_model(case).result
        return replace(found, outcome=Outcome.OVERLOADED)

    case = calculations(parse_case(TILTED))[0].problem
    (said,) = warnings_of_fuller_film(solve(parse_case(TILTED))["A"], case.with_own_temperatures(), overloaded)
    assert [one.variant for one in said.values["told"]] == ["no_thermal_film"]


def test_a_film_that_is_questioned_with_temperatures_of_its_own_alone_is_told():
    """Its hottest bush keeps the limit by less than it is known to (W172)."""
    (said,) = level_within(hottest_of_level() + 1.0)
    assert said.values["codes"] == ("W172",)


@pytest.mark.parametrize(("code", "counts"), [("W219", True), ("W129", True), ("W172", False)])
def test_a_limit_that_the_film_keeps_as_the_case_sets_it_alone_is_missed(code, counts):
    """What passes by the standard alone is not told what else questions its film alone."""
    result, case = solve(parse_case(LEVEL))["A"], calculations(parse_case(LEVEL))[0].problem
    hot = Notice("W219", "missed_bush", {"value": 400.0, "limit": 388.15, "check": "C108"})
    beyond = Notice("W129", "surfaces", {"minimum_film_thickness": 1e-6, "roughness": 2e-6})
    near = Notice("W172", "kept", {"kept": (), "uncertain": 6.0})
    said = {"W129": beyond, "W219": Notice("W219", "kept", {"told": (hot,)}), "W172": near}[code]

    def questioned(case):
        found = film_by_its_model(case).result
        return replace(found, warnings=(*found.warnings, said))

    told = tuple(warnings_of_fuller_film(result, case.with_own_temperatures(), questioned))
    assert misses_a_limit(replace(result, warnings=told)) is counts


def test_a_tilted_film_of_given_temperature_must_keep_its_limit_with_thinner_oil():
    """No film with temperatures of its own is known of it."""
    case, _ = film(TILTED)
    slight = TILTED.replace("0.58 mrad", "0.2 mrad")
    given = slight + "effective_temperature: 60 degC\nlimits: {minimum_film_thickness: 18 um}\n"
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
    (said,) = said_of_films(found)
    assert said.values["value"] == pytest.approx(full.minimum_film_thickness, rel=1e-9)


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
        return told(solve(parse_case(BESIDE_A_HOLE + f"rotor_mass: {mass} kg\n"))["A"])

    assert not said(0.99 * full)
    (missed,) = said(1.01 * full)
    assert missed.variant == "missed_mass"
    assert missed.values["value"] == pytest.approx(full, rel=1e-9)
