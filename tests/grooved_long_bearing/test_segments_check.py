"""The design check by segments: results, warnings, statuses, and input that cannot be used."""

import math
from dataclasses import replace

import pytest

import babbitt
from babbitt.case import CaseError, parse_case
from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.design.conditions import Limits, OilSupply, PrescribedEccentricity, PrescribedLoad
from babbitt.kinds.journal.grooved_long_bearing.check import segments_check
from babbitt.kinds.journal.grooved_long_bearing.model import Groove, GrooveKind, SegmentCase
from babbitt.kinds.journal.grooved_long_bearing.solve import film_at_eccentricity, film_under_load
from babbitt.kinds.journal.one_dimension import LongBearing
from babbitt.properties.lubricants import PowerLaw, ViscosityKind
from babbitt.validation.published.grooved_segments import film, oil

ZERO = 273.15
GOOD = film("through", cells=360)
PLAIN = SegmentCase(
    name="bearing",
    bearing=LongBearing(0.1, 0.07, 1.53e-3),
    duty=PrescribedEccentricity(0.8),
    journal_speed=200.0,
    lubricant=oil(19.5, 2.2),
    oil_supply=OilSupply(40.0 + ZERO, 0.0),
    cells=360,
)
GROOVED = replace(PLAIN, groove=GOOD.groove)

TEXT = """
babbitt: 1
kind: journal
name: Crusher
method: segments
diameter: 100 mm
width: 70 mm
clearance: {kind: relative, mean: 1.53 permille}
lubricant: {kind: power_law, nu50: 22.16 mm2/s, exponent: 2.2}
supply: {temperature: 40 degC}
surface_speed: 10 m/s
accuracy: draft
"""


def codes(result):
    return {notice.code for notice in result.warnings}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"diameter": 0.0}, "diameter must be above 0"),
        ({"width": -1.0}, "width must be above 0, given -1.0"),
        ({"clearance": 0.0}, "clearance must be above 0"),
        ({"surface_speed": 0.0}, "surface_speed must be above 0"),
        ({"supply_temperature": -1.0}, "supply_temperature must be above 0"),
        ({"compliance": -1e-12}, "compliance must not be negative"),
        ({"cells": 100}, "cells must be at least 180, given 100"),
        ({"start": math.pi}, "start must lie from 0 to below 180 deg"),
        (
            {"groove": Groove(2.6, -1e-3, GrooveKind.BLIND)},
            "width of the groove must not be negative",
        ),
        ({"groove": Groove(0.01, 6e-3, GrooveKind.BLIND)}, "does not lie inside the film"),
        ({"groove": Groove(2.6, 0.5, GrooveKind.BLIND)}, "does not lie inside the film"),
        ({"groove": Groove(2.6, 6e-3, GrooveKind.THROUGH, 1.2)}, "mixing_factor must lie from 0 to 1, given 1.2"),
        ({"groove": Groove(2.6, 6e-3, GrooveKind.THROUGH, 1.0, -1.0)}, "pressure of the groove"),
        ({"profile": tuple((0.5 * n, 1e-5 * (n - 2)) for n in range(12))}, "film thickness in the profile"),
        ({"profile": ((0.0, 1e-5), (1.0, 1e-5))}, "at least 8 points, given 2"),
        ({"profile": tuple((0.1 * (n % 5), 1e-5) for n in range(9))}, "must rise"),
    ],
)
def test_unusable_input_names_quantity_and_value(change, words):
    with pytest.raises(InputError, match=words) as caught:
        replace(GOOD, **change)
    assert caught.value.code == "E003"


@pytest.mark.parametrize("eccentricity", [-0.1, 1.0, 1.5])
def test_eccentricity_of_a_rigid_film(eccentricity):
    with pytest.raises(InputError, match="0 to below 1 for a rigid film"):
        film_at_eccentricity(GOOD, eccentricity)


def test_load_above_zero():
    with pytest.raises(InputError, match="load must be above 0"):
        film_under_load(GOOD, 0.0)


@pytest.mark.parametrize(("viscosity", "exponent"), [(0.0, 2.0), (-1.0, 2.0), (0.02, -1.0)])
def test_power_law_of_no_oil(viscosity, exponent):
    with pytest.raises(InputError):
        PowerLaw(viscosity, exponent, ViscosityKind.DYNAMIC)


def test_power_law_ends_at_zero_celsius():
    assert (
        segments_check(replace(PLAIN, oil_supply=OilSupply(ZERO - 10.0, 0.0))).outcome is Outcome.NO_LUBRICANT_DATA
    )


def test_operating_point_of_a_grooved_film():
    result = segments_check(replace(GROOVED, duty=PrescribedLoad(6.5e6 * 0.007)))
    assert result.outcome.solved
    told = next(notice for notice in result.warnings if notice.code == "W153")
    assert told.values["outlet_temperature"] - 273.15 == pytest.approx(108.0, abs=0.5)
    assert told.values["without"] - 273.15 == pytest.approx(69.0, abs=0.5)
    assert result.outlet_temperature > result.ungrooved_outlet_at_load + 30.0
    assert result.groove_side_flow == pytest.approx(result.segment_1_flow - result.segment_2_flow)
    assert result.groove_load_ratio < 1.0
    assert result.heat_to_oil == pytest.approx(result.friction_power, rel=1e-9)


def test_warm_oil_that_leaves_in_the_groove_is_told_with_its_heat():
    behind = replace(GROOVED, groove=Groove(math.radians(300.0), 6e-3, GrooveKind.THROUGH))
    result = segments_check(behind)
    assert result.segment_2_power == 0.0
    assert result.outlet_temperature == result.supply_temperature
    assert result.groove_warm_flow == pytest.approx(result.segment_1_flow)
    assert result.groove_heat == pytest.approx(result.heat_to_oil)
    for factor in (0.3, 0.8):
        result = segments_check(replace(GROOVED, groove=replace(GROOVED.groove, mixing_factor=factor)))
        fresh = max(factor, 1.0 - result.segment_1_flow / result.segment_2_flow)
        going_on = (1.0 - fresh) * result.segment_2_flow
        assert result.groove_warm_flow == pytest.approx(result.segment_1_flow - going_on, rel=1e-9)
        assert result.groove_heat == pytest.approx(
            result.segment_1_heat * result.groove_warm_flow / result.segment_1_flow
        )
    blind = replace(GROOVED, groove=replace(GROOVED.groove, kind=GrooveKind.BLIND))
    assert "groove_heat" not in segments_check(blind).values


def test_gain_of_a_blind_groove_is_called_apparent():
    blind = replace(GROOVED, groove=replace(GROOVED.groove, kind=GrooveKind.BLIND))
    result = segments_check(blind)
    assert "W156" in codes(result)
    assert result.cut_specific_load > result.specific_load > result.ungrooved_specific_load


def test_blind_groove_without_enough_oil():
    far = replace(GROOVED, groove=Groove(math.radians(300.0), 6e-3, GrooveKind.BLIND))
    result = segments_check(far)
    assert "W154" in codes(result)
    assert result.groove_pressure == 0.0


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"duty": PrescribedEccentricity(0.97)}, "W107"),
        ({"duty": PrescribedEccentricity(0.97)}, "W116"),
        ({"bearing": LongBearing(0.1, 0.07, 0.011)}, "W151"),
        (
            {"duty": PrescribedEccentricity(0.98), "bearing": replace(PLAIN.bearing, roughness=(6.3e-7, 3.2e-7))},
            "W155",
        ),
    ],
)  # fmt: skip
def test_doubts(change, code):
    assert code in codes(segments_check(replace(PLAIN, **change)))
    assert code not in codes(segments_check(replace(PLAIN, duty=PrescribedEccentricity(0.3))))


@pytest.mark.parametrize(("factor", "told"), [(2.9, True), (3.1, False)])
def test_touch_is_judged_by_the_rms_roughness(factor, told):
    """Heights of a normal distribution have Rq = sqrt(pi/2) Ra; surfaces begin to touch below 3 sigma."""
    least = segments_check(replace(PLAIN, duty=PrescribedEccentricity(0.9))).minimum_film_thickness
    mean = least / (factor * math.sqrt(math.pi / 2.0) * math.sqrt(2.0))
    rough = replace(
        PLAIN, duty=PrescribedEccentricity(0.9), bearing=replace(PLAIN.bearing, roughness=(mean, mean))
    )
    assert ("W155" in codes(segments_check(rough))) is told


def test_too_large_a_load_tells_the_best_it_reached():
    result = segments_check(replace(PLAIN, duty=PrescribedLoad(1e6)))
    assert result.outcome is Outcome.OVERLOADED
    assert "best specific load reached was" in result.message
    assert "MPa" in result.message


def test_ungrooved_result_says_nothing_of_a_groove():
    result = segments_check(PLAIN)
    assert not [name for name in result.values if "groove" in name or "segment_" in name]


# -- case files ------------------------------------------------------------------------------------------------


def test_case_file():
    more = """
specific_load: 4 MPa
segments:
  groove: {kind: through, angle: 150 deg, width: 6 mm, mixing_factor: 0.5, pressure: 0.1 MPa}
  compliance: 0.5 um/MPa
  roughness: {bearing: 0.63 um, journal: 0.32 um}
"""

    (design,) = parse_case(TEXT + more).problems()
    assert design.groove.mixing_factor == 0.5
    assert design.groove.pressure == pytest.approx(1e5)
    assert design.compliance == pytest.approx(0.5e-12)
    assert design.bearing.roughness == pytest.approx((0.63e-6, 0.32e-6))
    assert design.film.cells == 720


def test_case_file_with_a_profile_needs_no_load():
    points = ", ".join(
        f"{{angle: {angle} deg, film_thickness: {76.5 * (1 + 0.8 * math.cos(math.radians(angle))):.6f} um}}"
        for angle in range(0, 360, 3)
    )
    result = babbitt.solve(parse_case(TEXT + f"segments: {{profile: [{points}]}}")).results[0]
    assert result.outcome.solved
    rigid = babbitt.solve(parse_case(TEXT + "eccentricity_ratio: 0.8")).results[0]
    assert result.load == pytest.approx(rigid.load, rel=2e-3)
    assert result.eccentricity_ratio == pytest.approx(0.8, abs=1e-4)
    with pytest.raises(CaseError, match="load follows from the film thickness"):
        parse_case(TEXT + f"load: 5 kN\nsegments: {{profile: [{points}]}}")


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ("segments: {groove: {kind: open, angle: 150 deg, width: 6 mm}}", "open"),
        ("segments: {groove: {kind: through, width: 6 mm}}", "the place of the groove in the bush"),
        ("segments: {groove: {kind: through, angle: 359 deg, width: 6 mm}}", "does not lie inside the film"),
        ("segments: {groove: {kind: through, angle: 150 deg, width: 400 mm}}", "does not lie inside the film"),
        ("segments: {groove: {kind: through, angle: 150 deg, width: 6 mm, mixing_factor: 1.5}}", "too large"),
        (
            "segments: {groove: {kind: blind, angle: 150 deg, width: 6 mm, pressure: 1 MPa}}",
            "follows from the oil",
        ),
        ("segments: {profile: [{angle: 0 deg, film_thickness: 0 um}]}", "too small"),
        ("heat_exchange: {nusselt: 4}", "does not read it"),
    ],
)
def test_case_file_that_asks_for_what_is_not(more, words):
    with pytest.raises(CaseError, match=words):
        parse_case(TEXT + "specific_load: 4 MPa\n" + more)


def test_exponent_of_no_oil():
    with pytest.raises(CaseError, match="exponent 6"):
        parse_case(TEXT.replace("exponent: 2.2", "exponent: 6") + "specific_load: 4 MPa")


def test_groove_in_the_file_may_be_none():
    result = babbitt.solve(parse_case(TEXT + "specific_load: 4 MPa\nsegments: {groove: {kind: none}}")).results[0]
    assert result.settings["groove"] == "none"


def test_a_groove_behind_the_loaded_film_is_told_and_limits_hold_for_the_loaded_one():
    late = replace(GROOVED, groove=replace(GOOD.groove, angle=math.radians(230.0)))
    result = segments_check(late)
    assert result.outlet_temperature == pytest.approx(result.supply_temperature)
    assert "W157" in codes(result)
    assert "W157" not in codes(segments_check(GROOVED))
    (limit,) = (check for check in result.checks if check.code == "C104")
    assert limit.quantity == "maximum_temperature"
    assert limit.value == result.segment_1_outlet_temperature > result.supply_temperature + 20.0
    # as hot as the ungrooved film, which ends before the groove begins
    assert limit.value == pytest.approx(segments_check(PLAIN).outlet_temperature, abs=0.5)


def test_reversed_rotation_mirrors_the_segments():
    there, back = (segments_check(replace(GROOVED, journal_speed=speed)) for speed in (200.0, -200.0))
    assert (there.angular_speed, back.angular_speed) == (200.0, -200.0)
    assert math.cos(back.narrowest_gap_angle) == pytest.approx(-math.cos(there.narrowest_gap_angle))
    assert math.sin(back.narrowest_gap_angle) == pytest.approx(math.sin(there.narrowest_gap_angle))
    assert back.outlet_temperature == there.outlet_temperature


@pytest.mark.parametrize("duty", [PrescribedLoad(28e3), PrescribedEccentricity(0.5)])
def test_oil_colder_than_its_law_is_not_called_overloaded(duty):
    result = segments_check(replace(PLAIN, duty=duty, oil_supply=OilSupply(ZERO - 10.0, 0.0)))
    assert result.outcome is Outcome.NO_LUBRICANT_DATA
    assert "supplied at -10.0 °C" in result.message


def test_one_doubt_about_temperatures_is_enough():
    hot = segments_check(replace(PLAIN, duty=PrescribedEccentricity(0.97)))
    assert [notice.code for notice in hot.warnings].count("W107") == 1


@pytest.mark.parametrize(
    ("nu50", "exponent", "holds"), [(10.0, 1.8, False), (22.2, 2.2, True), (100.0, 2.8, False)]
)
def test_statements_on_grooves_hold_for_turbine_oils_not_for_all(nu50, exponent, holds):
    """Through groove 15 K colder and blind one within 6 K: thin oils gain less, thick ones differ by more."""
    own = oil(0.88 * nu50, exponent)
    outlet = {
        kind: film_at_eccentricity(film(kind, 135, lubricant=own, cells=720), 0.8).outlet_temperature
        for kind in ("none", "through", "blind")
    }
    gain, apart = outlet["none"] - outlet["through"], abs(outlet["none"] - outlet["blind"])
    assert (gain >= 15.0 and apart <= 6.0) is holds
    assert gain > 8.0 > 0.8 * apart


def judged(result):
    return {check.code: check.ok for check in result.checks}, {one.code: one.message for one in result.not_checked}


def test_segments_without_sides_are_never_judged_thick_enough():
    """A film found from its load is thinner in a bearing with sides, and so is a wall's that yields."""
    loaded = segments_check(replace(PLAIN, duty=PrescribedLoad(5e3)))
    soft = segments_check(replace(PLAIN, duty=PrescribedEccentricity(0.5), compliance=1e-13))
    given = segments_check(replace(PLAIN, duty=PrescribedEccentricity(0.5)))
    for result in (loaded, soft, given):
        assert result.minimum_film_thickness > result.empirical_film_limit
    for result in (loaded, soft):
        made, unmade = judged(result)
        assert "C101" not in made
        assert "B/D = 0.700" in unmade["C101"]
    assert judged(given)[0]["C101"] is True


def test_segments_too_thin_even_without_sides_fail():
    result = segments_check(replace(PLAIN, duty=PrescribedLoad(5e3), limits=Limits(minimum_film_thickness=1e-4)))
    assert judged(result)[0]["C101"] is False


def test_segments_of_a_narrow_bearing_are_doubted():
    wide = replace(PLAIN, bearing=LongBearing(0.1, 0.25, 1.53e-3))
    said = {one.code: one.message for one in segments_check(PLAIN).warnings}
    assert (
        said["W158"]
        == "B/D = 0.700 < 2: the load shown is larger than that of the bearing at the same temperatures"
    )
    assert (
        "thicker"
        in {one.code: one.message for one in segments_check(replace(PLAIN, duty=PrescribedLoad(5e3))).warnings}[
            "W158"
        ]
    )
    assert "W158" not in codes(segments_check(wide))
