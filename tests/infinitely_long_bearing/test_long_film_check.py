"""The design check of the long film: statuses, warnings, and input that cannot be used."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest

import babbitt
from babbitt.case import CaseError, parse_case
from babbitt.core.notices import InputError, explanations
from babbitt.core.result import Outcome
from babbitt.design.conditions import OilSupply, PrescribedEccentricity, PrescribedLoad
from babbitt.kinds.journal.infinitely_long_bearing.check import long_film_check
from babbitt.kinds.journal.infinitely_long_bearing.model import (
    BushRing,
    Discretisation,
    HeatExchange,
    LongFilm,
    LongFilmCase,
    NusseltLaw,
)
from babbitt.kinds.journal.infinitely_long_bearing.pressure import Gap, divergence_form
from babbitt.kinds.journal.infinitely_long_bearing.solve import film_at_eccentricity, film_under_load
from babbitt.kinds.journal.iso7902.characteristics import curves
from babbitt.kinds.journal.one_dimension import LongBearing
from babbitt.properties.lubricants import Walther
from babbitt.validation.published.long_film_bearing import film, oil

ZERO = 273.15
GOOD = film(Discretisation.CONSISTENT, 3000, cells=90)

CASE = LongFilmCase(
    name="bearing",
    bearing=LongBearing(0.08, 0.105, 1.408e-3),
    duty=PrescribedEccentricity(0.6),
    journal_speed=3000 * math.pi / 30,
    lubricant=oil(),
    oil_supply=OilSupply(70.0 + ZERO, 0.0),
)

TEXT = """
babbitt: 1
kind: journal
name: Gear box
method: long_film
diameter: 80 mm
width: 105 mm
clearance: {kind: relative, mean: 1.408 permille}
lubricant: ISO VG 32
supply: {temperature: 60 degC}
load: 15 kN
speed: 3000 rpm
"""


def codes(result):
    return {notice.code for notice in result.warnings}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"diameter": 0.0}, "diameter must be above 0, given 0.0"),
        ({"width": -0.1}, "width must be above 0, given -0.1"),
        ({"clearance": -1e-6}, "clearance must be above 0"),
        ({"clearance": 0.001}, "clearance over radius is 0.025"),
        ({"angular_speed": 0.0}, "angular_speed must be above 0"),
        ({"inlet_temperature": math.nan}, "inlet_temperature must be above 0, given nan"),
        ({"cells": 23}, "cells must be at least 24, given 23"),
        ({"exchange": HeatExchange(bush=BushRing(0.08, 45.0))}, "outer_diameter of the bush, 0.08 m"),
        ({"exchange": HeatExchange(bush=BushRing(0.1, -1.0))}, "conductivity of the bush"),
        (
            {"exchange": HeatExchange(bush=BushRing(0.1, 45.0, -5.0), ambient_temperature=300.0)},
            "ambient_coefficient of the bush must not be negative, given -5.0",
        ),
        ({"exchange": HeatExchange(shaft_conductance=-1.0)}, "shaft_conductance must not be negative, given -1.0"),
        ({"exchange": HeatExchange(shaft_conductance=1.0)}, "ambient_temperature is missing"),
    ],
)
def test_unusable_input_names_quantity_and_value(change, words):
    with pytest.raises(InputError, match=words) as caught:
        replace(GOOD, **change)
    assert caught.value.code == "E003"


@pytest.mark.parametrize("eccentricity", [0.0, 1.0, -0.2, math.nan])
def test_eccentricity_between_its_bounds(eccentricity):
    with pytest.raises(InputError, match="eccentricity_ratio must lie between 0 and 1"):
        film_at_eccentricity(GOOD, eccentricity)


@pytest.mark.parametrize("load", [0.0, -1.0, math.nan, math.inf])
def test_load_above_zero(load):
    with pytest.raises(InputError, match="load must be above 0"):
        film_under_load(GOOD, load)


def test_nusselt_law_that_cools_backwards():
    with pytest.raises(InputError, match="coefficient -1"):
        NusseltLaw(-1.0)


def test_viscosity_that_rises():
    with pytest.raises(InputError, match="exchanged"):
        Walther.through((50.0 + ZERO, 3e-6), (100.0 + ZERO, 10e-6), additive=0.6)


def test_operating_point():
    result = long_film_check(CASE)
    assert result.outcome.solved
    assert result.method == "long_film"
    assert result.eccentricity_ratio == 0.6
    assert result.heat_to_oil == pytest.approx(result.friction_power, rel=1e-8)
    assert abs(result.energy_balance_error) < 1e-8
    assert result.rupture_temperature < result.maximum_temperature + 1e-9
    assert len(result.arrays["film_temperature"][0]) == len(result.arrays["film_angle"][0]) == 181
    assert result.mean_temperature_load_ratio < 1.0
    assert not codes(result) & {"W150", "W151", "W152", "W107"}


def test_reversal_mirrors():
    forward, backward = long_film_check(CASE), long_film_check(replace(CASE, journal_speed=-CASE.journal_speed))
    directed = ("wall_time", "angular_speed", "narrowest_gap_angle")
    same = {name: value for name, value in forward.values.items() if name not in directed}
    assert same == {name: value for name, value in backward.values.items() if name not in directed}


@pytest.mark.parametrize("mode", [Discretisation.PUBLISHED_MEAN, Discretisation.PUBLISHED_LITERAL])
def test_published_modes_say_that_they_lose_flow(mode):
    result = long_film_check(replace(CASE, duty=PrescribedEccentricity(0.8), discretisation=mode))
    told = next(notice for notice in result.warnings if notice.code == "W150")
    assert mode.value in told.message
    assert result.flow_inconsistency > 1.0


def test_local_flow_that_turns_back_is_no_operating_point():
    cold = replace(
        CASE,
        duty=PrescribedEccentricity(0.95),
        journal_speed=5.0,
        discretisation=Discretisation.PUBLISHED_LITERAL,
        oil_supply=OilSupply(20.0 + ZERO, 0.0),
    )
    result = long_film_check(cold)
    if not result.outcome.solved:
        assert result.message


def test_journal_that_nothing_touches_has_no_temperature():
    result = long_film_check(replace(CASE, exchange=HeatExchange(NusseltLaw(0.0))))
    assert "journal_temperature" not in result.values
    assert "journal_temperature" in long_film_check(CASE).values


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"cells": 60}, "W152"),
        ({"bearing": LongBearing(0.08, 0.105, 6e-3)}, "W151"),
        ({"oil_supply": OilSupply(149.0 + ZERO, 0.0)}, "W107"),
        ({"journal_speed": 30000 * math.pi / 30, "oil_supply": OilSupply(110.0 + ZERO, 0.0),
          "bearing": LongBearing(0.08, 0.105, 4e-3)}, "W101"),
        ({"duty": PrescribedEccentricity(0.97)}, "W116"),
    ],
)  # fmt: skip
def test_doubts(change, code):
    assert code in codes(long_film_check(replace(CASE, **change)))


def test_too_large_a_load_tells_how_far_it_came():
    result = long_film_check(replace(CASE, duty=PrescribedLoad(1e6)))
    assert result.outcome is Outcome.OVERLOADED
    assert not result.values.keys() - {"wall_time"}
    assert "largest load reached" in result.message
    assert "1000 kN" in result.message


# -- case files ------------------------------------------------------------------------------------------------


def test_case_file():
    more = """
heat_exchange:
  nusselt: 3.77
  bush: {outer_diameter: 100 mm, conductivity: 45 W/(m K)}
  ambient: {temperature: 20 degC, coefficient: 200 W/(m2 K)}
  shaft_conductance: 0.2 W/K
  exchange_zone: all_around
accuracy: reference
"""
    (design,) = parse_case(TEXT + more).problems()
    assert design.exchange.nusselt == NusseltLaw(3.77, 0.0)
    assert design.exchange.bush == BushRing(pytest.approx(0.1), 45.0, 200.0)
    assert design.film.zone.value == "all_around"
    assert design.cells == 360
    result = babbitt.solve(parse_case(TEXT + more)).results[0]
    assert result.load == pytest.approx(15e3, rel=1e-5)
    split = result.heat_to_oil + result.heat_to_surroundings + result.heat_to_shaft
    assert split == pytest.approx(result.friction_power, rel=1e-8)
    assert result.settings["nusselt"] == "3.77 (Pe h/D)^0"


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ("segments: {groove: {kind: none}}", "does not read it"),
        ("effective_temperature: 60 degC", "finds its temperatures itself"),
        ("bearing_speed: 10 rpm", "no turning bearing"),
        ("misalignment: {x: 0.01 mrad, y: 0}", "misaligned"),
        ("grooves: [{angle: 90 deg, extent: 20 deg}]", "knows no grooves"),
        ("friction: {factor: 1.2}", "no factor on friction"),
        ("heat_exchange: {shaft_conductance: 1 W/K}", "not given"),
        (
            "heat_exchange: {bush: {outer_diameter: 70 mm, conductivity: 45 W/(m K)}}",
            "not larger than the bearing",
        ),
        ("heat_exchange: {ambient: {temperature: 20 degC, coefficient: 5 W/(m2 K)}}", "no bush is given"),
        ("heat_exchange: {bush: {outer_diameter: 100 mm, conductivity: -4 W/(m K)}}", "too small"),
    ],
)
def test_case_file_that_asks_for_what_the_method_has_not(more, words):
    with pytest.raises(CaseError, match=words):
        parse_case(TEXT + more)


def test_supply_is_asked_for():
    with pytest.raises(CaseError, match="supply"):
        parse_case(TEXT.replace("supply: {temperature: 60 degC}\n", ""))


def test_a_film_is_not_made_of_nothing():
    with pytest.raises(InputError, match="long film"):
        LongFilm(0.08, 0.1, 0.0, 100.0, oil(), 330.0)


def test_reversed_rotation_mirrors_the_film_about_the_load():
    there, back = (long_film_check(replace(CASE, journal_speed=sense * CASE.journal_speed)) for sense in (1, -1))
    assert there.angular_speed == -back.angular_speed > 0.0
    assert back.attitude_angle == pytest.approx(there.attitude_angle, rel=1e-12)
    # the load points down: the mirror is the vertical, the narrowest gap lies on the side that the journal leaves
    assert there.narrowest_gap_angle == pytest.approx(-math.pi / 2.0 + there.attitude_angle)
    assert math.cos(back.narrowest_gap_angle) == pytest.approx(-math.cos(there.narrowest_gap_angle))
    assert math.sin(back.narrowest_gap_angle) == pytest.approx(math.sin(there.narrowest_gap_angle))
    here, mirrored = (one.arrays["film_direction"][0] for one in (there, back))
    assert [math.cos(one) for one in mirrored] == pytest.approx([-math.cos(one) for one in here], abs=1e-9)
    assert [math.sin(one) for one in mirrored] == pytest.approx([math.sin(one) for one in here], abs=1e-9)
    assert back.arrays["film_temperature"] == there.arrays["film_temperature"]
    # pressure integrated over the directions in the frame is the load, pointing down, either way round
    for result in (there, back):
        angle, pressure = (result.arrays[name][0][:-1] for name in ("film_direction", "film_pressure"))
        step = 2.0 * math.pi / len(angle)
        area = 0.5 * CASE.bearing.diameter * CASE.bearing.width * step
        fx, fy = (
            sum(p * turn(a) for p, a in zip(pressure, angle, strict=True)) * area for turn in (math.cos, math.sin)
        )
        assert (fx, fy) == pytest.approx((0.0, -result.load), abs=1e-6 * result.load)


def solved(text):
    (result,) = babbitt.solve(parse_case(text)).results
    assert result.outcome is Outcome.CONVERGED, result.message
    return result


NARROW = TEXT.replace("width: 105 mm", "width: 8 mm").replace("load: 15 kN", "load: 0.5 kN")


def judged(result):
    return {check.code: check.ok for check in result.checks}, {one.code: one.message for one in result.not_checked}


def test_a_film_without_sides_is_never_judged_thick_enough():
    """It carries more than a bearing with sides: at B/D 0.1 and the same load the latter is many times thinner."""
    result = solved(NARROW)
    fed = "method: film\nspan: 360 deg\nsupply_element: {kind: hole, diameter: 3 mm, place: opposite}"
    more = "effective_temperature: 60 degC\nmaterials: {bearing: C45, journal: C45}"
    text = NARROW.replace("method: long_film", f"{fed}\n{more}")
    finite = solved(text.replace("temperature: 60 degC}", "temperature: 60 degC, pressure: 0.1 MPa}"))
    assert result.minimum_film_thickness > 5.0 * finite.minimum_film_thickness
    assert result.minimum_film_thickness > result.empirical_film_limit > finite.minimum_film_thickness
    made, unmade = judged(result)
    assert "C101" not in made
    assert "B/D = 0.100" in unmade["C101"]
    assert f"{result.minimum_film_thickness * 1e6:.1f} µm" in unmade["C101"]
    assert judged(finite)[0]["C101"] is False


def test_a_film_too_thin_even_without_sides_fails():
    made, unmade = judged(solved(TEXT + "limits: {minimum_film_thickness: 100 um}"))
    assert made["C101"] is False
    assert "C101" not in unmade


def test_a_given_gap_is_judged():
    made, unmade = judged(solved(TEXT.replace("load: 15 kN", "eccentricity_ratio: 0.5")))
    assert made["C101"] is True
    assert "C101" not in unmade


def test_the_surfaces_are_no_more_kept_apart_for_sure():
    surfaces = "surfaces: {kind: direct, roughness_bearing: 2 um, roughness_journal: 1 um}"
    made, unmade = judged(solved(TEXT + surfaces))
    assert "C102" not in made
    assert "infinitely wide" in unmade["C102"]


@pytest.mark.parametrize(
    ("width", "duty", "words"),
    [
        (0.008, PrescribedLoad(500.0), "B/D = 0.100 < 2: the film shown is thicker"),
        (0.105, PrescribedEccentricity(0.5), "B/D = 1.312 < 2: the load shown is larger"),
        (0.17, PrescribedLoad(15e3), None),
    ],
)
def test_a_narrow_bearing_is_doubted(width, duty, words):
    found = long_film_check(replace(CASE, bearing=LongBearing(0.08, width, 1.408e-3), duty=duty))
    warnings = {one.code: one.message for one in found.warnings}
    assert ("W158" in warnings) is (words is not None)
    if words:
        assert words in warnings["W158"]


def test_shares_of_the_load_of_a_wide_film_that_the_doubt_tells():
    """Full bearings of one viscosity at an eccentricity of 0.8 against the film of infinite width."""
    told = explanations()["W158"].meaning
    gap = Gap.of(0.8, 720)
    wide = math.hypot(*divergence_form(gap, np.ones(721)).load(gap.step)) / 2.0
    for ratio in (1.5, 1.0, 0.5, 0.125):
        share = float(curves(360, ratio).sommerfeld_number(0.8)) / wide
        assert f"{share:.0%}".replace("%", f" % at {'B/D ' if ratio == 1.5 else ''}{ratio:g}") in told.replace(
            "% of its load at", "% at"
        )


def test_the_bound_of_the_width_is_that_of_the_method():
    wide = TEXT.replace("method: long_film", "method: METHOD")
    assert wide != TEXT
    wide = re.sub(r"(?m)^width: .*$", "width_ratio: 2.5", wide)
    result = babbitt.solve(parse_case(wide.replace("METHOD", "long_film"))).results[0]
    assert result.width_ratio == 2.5
    assert "W158" not in {notice.code for notice in result.warnings}
    bare = "\n".join(line for line in wide.splitlines() if not line.startswith("heat_exchange"))
    with pytest.raises(CaseError, match=r"no characteristics for a bearing of B/D 2\.5"):
        parse_case(bare.replace("METHOD", "iso7902"))
    with pytest.raises(CaseError, match=r"0\.1 to 10"):
        parse_case(wide.replace("METHOD", "long_film").replace("width_ratio: 2.5", "width_ratio: 25"))
