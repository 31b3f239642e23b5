"""Physics of the film method through the public door."""

import math
import subprocess
import sys

import numpy as np
import pytest
from film_bearings import GROOVES, answer, case, solved

from babbitt.core.result import Outcome, Verdict
from babbitt.kinds.journal.film.bore import Arc, LobedBore, MeasuredBore, TaperedBore, WornBore
from babbitt.solving import solve

PLAIN = {
    "grooves": None,
    "span": "360 deg",
    "film_start": "widest_gap",
    "cavitation": "reynolds",
    "accuracy": "reference",
}


def turned(feeds, by):
    return [feed | {"angle": f"{float(feed['angle'].split()[0]) + by} deg"} for feed in feeds]


def rotated(matrix, by):
    c, s = math.cos(by), math.sin(by)
    turn = np.array([[c, -s], [s, c]])
    return turn @ np.array(matrix) @ turn.T


POCKETS = [
    {"angle": "15 deg", "extent": "20 deg", "width": "80 mm"},
    {"angle": "160 deg", "extent": "25 deg", "width": "60 mm"},
]

FEEDS = {
    "grooves": {"grooves": GROOVES},
    "pockets": {"grooves": None, "pockets": POCKETS},
    "lobes": {"grooves": GROOVES, "bore": {"kind": "lobes", "preload": 0.4, "offset": 0.7}},
}


@pytest.mark.parametrize("width_ratio", [0.5, 1.0])
@pytest.mark.parametrize("load", ["8 kN", "60 kN"])
def test_a_plain_bearing_agrees_with_the_standard(load, width_ratio):
    # ISO 7902 characteristics of the full bearing are solutions of the same problem by another scheme
    given = PLAIN | {"load": load, "width": None, "width_ratio": width_ratio, "effective_temperature": "60 degC"}
    film, standard = answer(**given), answer(**given | {"method": "iso7902"})
    assert film.sommerfeld_number == pytest.approx(standard.sommerfeld_number, rel=1e-8)  # both from load and oil
    assert film.attitude_angle == pytest.approx(standard.attitude_angle, abs=math.radians(0.05))
    assert film.side_flow == pytest.approx(standard.side_flow, rel=1e-3)
    assert film.maximum_pressure == pytest.approx(standard.maximum_pressure, rel=2e-3)
    # and the load at one position
    at = {"load": None, "eccentricity_ratio": standard.eccentricity_ratio}
    there = answer(**given | at)
    assert there.sommerfeld_number == pytest.approx(standard.sommerfeld_number, rel=1e-3)
    assert there.attitude_angle == pytest.approx(standard.attitude_angle, abs=math.radians(0.05))


def test_the_half_arc_agrees_with_the_standard_where_the_other_half_carries_nothing():
    # the loaded arc of the standard begins and ends at ambient pressure; a wide groove lies behind it
    given = {
        "grooves": [{"angle": "90 deg", "extent": "180 deg", "pressure": "0 Pa"}],
        "span": "180 deg", "cavitation": "reynolds", "accuracy": "reference", "effective_temperature": "60 degC",
        "load": None, "eccentricity_ratio": 0.7,
    }  # fmt: skip
    film, standard = answer(**given), answer(**given | {"method": "iso7902"})
    assert film.sommerfeld_number == pytest.approx(standard.sommerfeld_number, rel=1e-3)
    assert film.attitude_angle == pytest.approx(standard.attitude_angle, abs=math.radians(0.05))


@pytest.mark.parametrize("feed", FEEDS.values(), ids=FEEDS)
def test_turning_everything_turns_the_answer(feed):
    by = 37.0
    turned_feed = feed | {name: turned(feed[name], by) for name in ("grooves", "pockets") if feed.get(name)}
    here, there = answer(**feed), answer(**turned_feed, load_angle=f"{-90 + by} deg")
    for name in ("eccentricity_ratio", "attitude_angle", "friction_power", "total_flow", "effective_temperature"):
        assert there.values[name] == pytest.approx(here.values[name], rel=2e-6), name
    np.testing.assert_allclose(
        there.stiffness, rotated(here.stiffness, math.radians(by)), rtol=1e-4, atol=1e-4 * here.stiffness_yy
    )
    assert there.critical_mass == pytest.approx(here.critical_mass, rel=1e-3)


@pytest.mark.parametrize("feed", FEEDS.values(), ids=FEEDS)
def test_the_mirror_image_turns_the_other_way(feed):
    def mirrored(feeds):
        return [feed | {"angle": f"{180.0 - float(feed['angle'].split()[0])} deg"} for feed in feeds]

    other = feed | {name: mirrored(feed[name]) for name in ("grooves", "pockets") if feed.get(name)}
    here, there = answer(**feed), answer(**other, speed="-3000 rpm")
    for name in ("eccentricity_ratio", "attitude_angle", "friction_power", "total_flow", "minimum_film_thickness"):
        assert there.values[name] == pytest.approx(here.values[name], rel=1e-8), name
    sign = np.array([[1.0, -1.0], [-1.0, 1.0]])
    np.testing.assert_allclose(there.stiffness, sign * here.stiffness, rtol=1e-6)
    np.testing.assert_allclose(there.damping, sign * here.damping, rtol=1e-6)


@pytest.mark.parametrize("feed", FEEDS.values(), ids=FEEDS)
def test_oil_and_heat_are_conserved(feed):
    result = answer(**feed)
    assert result.mass_balance_error < 1e-10
    assert abs(result.energy_balance_error) < 1e-8
    assert result.heat_to_oil == pytest.approx(result.friction_power, rel=1e-8)
    assert result.side_flow + result.supply_flow == pytest.approx(result.total_flow, rel=1e-12)
    assert result.outlet_temperature - result.effective_temperature == pytest.approx(
        result.effective_temperature - result.supply_temperature
    )


def test_oil_and_housing_share_the_heat():
    result = answer(
        cooling={"ambient_temperature": "20 degC", "heat_transfer_coefficient": 20.0, "surface": "1 m2"}
    )
    assert result.heat_to_surroundings == pytest.approx(20.0 * (result.effective_temperature - 293.15))
    assert abs(result.energy_balance_error) < 1e-8
    assert result.effective_temperature < answer().effective_temperature


def test_losses_on_the_way_cost_pressure():
    free = answer()
    tube = {"diameter": "20 mm", "length": "3 m"}
    fed = answer(supply={"temperature": "45 degC", "pressure": "0.15 MPa", "tubes": [tube]})
    assert fed.element_pressure + fed.tube_loss == pytest.approx(fed.supply_pressure, rel=1e-6)
    assert fed.total_flow < free.total_flow
    assert fed.effective_temperature > free.effective_temperature
    narrow = {"diameter": "8 mm", "length": "5 m"}
    starved = answer(supply={"temperature": "45 degC", "pressure": "0.15 MPa", "tubes": [narrow]})
    assert "W111" in {notice.code for notice in starved.warnings}
    assert starved.total_flow < fed.total_flow
    assert starved.supply_limit == pytest.approx(starved.given_flow)
    assert starved.total_flow <= starved.supply_limit * 1.01
    assert starved.effective_temperature > fed.effective_temperature
    assert starved.tube_loss == pytest.approx(0.15e6)
    warm = answer(
        supply={"temperature": "45 degC", "pressure": "0.15 MPa", "tubes": [narrow]}, thermal="adiabatic"
    )
    assert {"W111", "W186"} <= {notice.code for notice in warm.warnings}
    assert warm.verdict in (Verdict.FAIL, Verdict.NO_VERDICT)


def test_the_prescribed_position_gives_back_the_load():
    found = answer(effective_temperature="60 degC")
    ratio, attitude = found.eccentricity_ratio, found.attitude_angle
    given = {"effective_temperature": "60 degC", "load": None, "eccentricity_ratio": ratio}
    assert answer(**given).load == pytest.approx(30e3, rel=2e-3)
    again = answer(**given, attitude_angle=f"{attitude} rad")
    assert again.load == pytest.approx(30e3, rel=2e-3)
    assert again.attitude_angle == pytest.approx(attitude, abs=2e-3)


def test_stiffness_is_the_change_of_the_force():
    # the load at two positions beside each other, along the line of centres
    given = {"effective_temperature": "60 degC", "load": None, "cavitation": "reynolds", "accuracy": "reference"}
    step = 1e-4
    low, high = (answer(**given, eccentricity_ratio=0.5 + d, attitude_angle="50 deg") for d in (-step, step))
    middle = answer(**given, eccentricity_ratio=0.5, attitude_angle="50 deg")

    def force(result):
        # the film pushes against the load, which lies the attitude angle before the line of centres (at -40 deg)
        angle = math.radians(-40.0) - result.attitude_angle + math.pi
        return result.load * np.array([math.cos(angle), math.sin(angle)])

    clearance = 0.5 * middle.operating_relative_clearance * middle.diameter
    way = np.array([math.cos(math.radians(-40.0)), math.sin(math.radians(-40.0))])
    expected = -(force(high) - force(low)) / (2.0 * step * clearance)
    np.testing.assert_allclose(
        np.array(middle.stiffness) @ way, expected, rtol=1e-2, atol=1e-2 * abs(expected).max()
    )


def test_preload_stiffens_and_steadies_an_unloaded_bearing():
    light = {"load": "2 kN", "effective_temperature": "60 degC"}
    round_bore, lemon = answer(**light), answer(**light, bore={"kind": "lobes", "preload": 0.6})
    assert lemon.stiffness_yy > 3.0 * round_bore.stiffness_yy
    assert lemon.values.get("critical_mass", math.inf) > 1.5 * round_bore.critical_mass
    assert lemon.lobe_clearance == pytest.approx(0.5 * lemon.operating_relative_clearance * 0.2 / 0.4)


@pytest.mark.parametrize(
    "bore",
    [
        {"kind": "lobes", "preload": 0.0},
        {"kind": "measured", "departures": ["0 um"] * 12},
        {"kind": "taper_land", "depth": "0.1 um", "share": 0.02},
        {"kind": "wear", "depth": "0.1 um", "angle": "90 deg"},
    ],
    ids=lambda bore: bore["kind"],
)
def test_forms_without_depth_are_round(bore):
    assert answer(bore=bore).eccentricity_ratio == pytest.approx(answer().eccentricity_ratio, rel=2e-3)


def test_wear_lowers_the_journal_and_a_taper_feeds_it():
    given = {"effective_temperature": "60 degC"}
    plain = answer(**given)
    worn = answer(**given, bore={"kind": "wear", "depth": "40 um", "angle": "-70 deg"})
    assert worn.eccentricity_ratio > plain.eccentricity_ratio
    light = answer(**given, load="2 kN")
    tapered = answer(**given, load="2 kN", bore={"kind": "taper_land", "depth": "100 um", "share": 0.5})
    assert tapered.stiffness_yy > 1.2 * light.stiffness_yy


def test_lobes_have_the_assembled_clearance_at_their_narrowest_place():
    arc = Arc(0.2, 2.6, 1e-4, (0.0, 0.0), 1.0)
    land = LobedBore(0.5, 0.75).shaped(arc)
    angles = np.linspace(0.2, 2.6, 2401)
    gap = land.clearance + land.centre[0] * np.cos(angles) + land.centre[1] * np.sin(angles)
    assert gap.min() == pytest.approx(1e-4)
    assert angles[gap.argmin()] == pytest.approx(0.2 + 0.75 * 2.4, abs=1e-3)


def test_profiles_follow_their_description():
    arc = Arc(-2.5, -0.5, 1e-4, (0.0, 0.0), -1.0)
    taper = TaperedBore(2e-5, 0.5).shaped(arc).profile  # clockwise: the oil enters at the greater angle
    assert (taper[0], taper[-1]) == (0.0, 2e-5)
    worn = WornBore(3e-5, -1.5).shaped(arc).profile
    assert max(worn) == pytest.approx(3e-5)
    assert worn[0] == pytest.approx(max(0.0, 3e-5 - 1e-4 * (1.0 - math.cos(1.0))))
    measured = MeasuredBore(tuple(1e-6 * math.cos(2.0 * math.pi * k / 360) for k in range(360)))
    assert measured.at(7.1) == pytest.approx(1e-6 * math.cos(7.1), abs=1e-9)
    assert measured.at(-0.001) == pytest.approx(1e-6, abs=1e-9)


NARROW = {
    "pockets": {"pockets": POCKETS},
    "holes": {"holes": [{"angle": "90 deg", "diameter": "12 mm"}, {"angle": "20 deg", "diameter": "8 mm"}]},
    "circumferential groove": {"pockets": [{"angle": "90 deg", "extent": "360 deg", "width": "20 mm"}]},
    "by rule": {"span": "180 deg", "supply_element": {"kind": "pocket", "place": "both_sides", "width": "60 mm"}},
}
"""Bores with a tilted journal that are fed by what is narrower than the bearing."""


def test_the_lands_beside_a_groove_around_the_bore_carry_the_load():
    """As ISO 7902 has it: F/((B - b_G) D); a groove that ends somewhere parts nothing."""
    metal = {"bearing_metal": "SnSb8Cu4", "bearing": "C10", "journal": "C45"}
    given = {"grooves": None, "effective_temperature": "60 degC", "accuracy": "draft", "materials": metal}
    parted = answer(**given | NARROW["circumferential groove"])
    whole = answer(**given | {"pockets": [{"angle": "90 deg", "extent": "60 deg", "width": "20 mm"}]})
    lands = parted.load / (parted.diameter * (parted.width - 0.02))
    assert parted.specific_load == pytest.approx(lands, rel=1e-12)
    assert whole.specific_load == pytest.approx(whole.load / (whole.diameter * whole.width), rel=1e-12)
    (held,) = (check for check in parted.checks if check.code == "C103")
    assert held.value == parted.specific_load


@pytest.mark.parametrize("feed", NARROW)
def test_misalignment_thins_the_film_at_the_edges(feed):
    given = {"grooves": None, "effective_temperature": "60 degC"} | NARROW[feed]
    straight = answer(**given)
    askew = answer(**given, misalignment={"x": 0.0, "y": "0.4 mrad"})
    assert askew.minimum_film_thickness < straight.minimum_film_thickness - 0.2 * 0.4e-3 * 0.06
    other = answer(**given, misalignment={"x": 0.0, "y": "-0.4 mrad"})
    assert other.eccentricity_ratio == pytest.approx(
        askew.eccentricity_ratio, rel=1e-6
    )  # mirrored in the mid-plane
    assert askew.mass_balance_error < 1e-10


@pytest.mark.parametrize("feed", NARROW)
def test_a_vanishing_tilt_is_none(feed):
    # the aligned bearing is solved on half the width, the tilted one on all of it: two grids, one answer
    given = {"grooves": None, "effective_temperature": "60 degC"} | NARROW[feed]
    straight, askew = answer(**given), answer(**given, misalignment={"x": "0.1 nrad", "y": "0.1 nrad"})
    assert askew.mass_balance_error < 1e-10
    assert askew.minimum_film_thickness == pytest.approx(straight.minimum_film_thickness, rel=1e-3)
    for name in ("total_flow", "friction_power", "stiffness_yy", "damping_yy"):
        assert askew.values[name] == pytest.approx(straight.values[name], rel=3e-3), name


def test_a_threshold_is_where_the_critical_mass_meets_the_rotor():
    light = {"load": "6 kN", "rotor_mass": "400 kg", "effective_temperature": "60 degC"}
    found = answer(**light)
    there = answer(**light | {"speed": f"{found.threshold_speed} rad/s"})
    assert there.critical_mass == pytest.approx(400.0, rel=1e-3)
    (check,) = (check for check in found.checks if check.code == "C115")
    assert not check.advisory
    assert check.ok is (found.critical_mass >= 400.0)
    assert ("W120" in {notice.code for notice in found.warnings}) is not check.ok


def test_the_transition_is_where_the_film_is_as_thin_as_the_surfaces_need():
    found = answer(limits={"transition_film_thickness": "15 um"}, effective_temperature="60 degC")
    there = answer(speed=f"{found.transition_speed} rad/s", effective_temperature="60 degC")
    assert there.minimum_film_thickness == pytest.approx(15e-6, rel=1e-4)


def test_every_failure_is_a_status():
    (far,) = solved(load="90 MN", effective_temperature="120 degC").results
    assert far.outcome in (Outcome.OVERLOADED, Outcome.NOT_CONVERGED, Outcome.CONVERGED)
    (closed,) = solved(
        clearance={"kind": "relative", "mean": "0.1 permille"},
        materials={"bearing": {"thermal_expansion": 5e-6}, "journal": {"thermal_expansion": 25e-6}},
    ).results
    assert not closed.outcome.solved
    assert closed.message


def test_results_know_their_matrices():
    result = answer()
    assert result.stiffness[0][1] == result.stiffness_xy
    assert result.damping[1][0] == result.damping_yx
    with pytest.raises(AttributeError, match="stiffness"):
        _ = result.stifness


def test_operating_points_and_clearances_unfold():
    points = [{"name": "a", "load": "10 kN"}, {"name": "b", "load": "30 kN"}]
    limits = {"kind": "relative", "mean": "1.5 permille", "minimum": "1.3 permille", "maximum": "1.7 permille"}
    found = solve(case(load=None, operating_points=points, clearance=limits, clearance_cases="all"))
    assert len(found.results) == 6
    assert (
        found["Bearing [a] (maximum clearance)"].eccentricity_ratio
        < found["Bearing [b] (maximum clearance)"].eccentricity_ratio
    )


def test_numba_comes_with_the_first_film_only():
    code = (
        "import sys, babbitt; case = babbitt.parse_case(babbitt.template('journal')); babbitt.solve(case); "
        "assert 'numba' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("limit", [5.0, 45.0, 120.0, 400.0])
def test_a_film_is_held_against_its_transition_limit_whether_or_not_a_speed_of_transition_exists(limit):
    found = answer(effective_temperature="60 degC", limits={"transition_film_thickness": f"{limit} um"})
    (check,) = (check for check in found.checks if check.code == "C111")
    assert check.ok is (found.minimum_film_thickness >= 1e-6 * limit)
    assert "C111" not in {notice.code for notice in found.not_checked}
