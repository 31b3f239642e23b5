"""Films of pads with their own temperatures, through the kind."""

import math

import numpy as np
import pytest
from pad_journals import (
    CONDUCTING,
    FILLON_OIL,
    HEATED,
    OIL,
    STEEL,
    pad_case,
    result_of,
    solution_of,
    unloaded_pads,
)

from babbitt.case import case_from_dict
from babbitt.core.result import Outcome
from babbitt.kinds.tilting_pad_journal import thermal_film
from babbitt.kinds.tilting_pad_journal.check import heat_checks
from babbitt.solving import solve
from babbitt.validation.published.fillon_1992 import JOURNAL, hottest

FILLON = {"lubricant": FILLON_OIL, "accuracy": "engineering"}
CLEARANCE = {"pads.preload": None, "pads.assembled_clearance": {"kind": "radial", "mean": "78.4 um"}}
# highest temperature of a bore in degC, smallest gap in um at 4000 rpm, of a prototype with other discretisation
PROTOTYPE = {"A": (74.84, 29.32), "B": (70.67, 30.70), "C": (68.5, None), "D": (68.33, 31.01), "E": (71.53, 27.98)}
# the same temperatures from 1000 rpm on
SPEEDS = {"A": (64.5, 67.1, 70.8), "B": (49.3, 57.5, 64.6), "E": (48.9, 57.1, 64.7)}


def codes(result):
    """Codes of the warnings of a result."""
    return {one.code for one in result.warnings}


def hottest_bore(solution):
    """degC."""
    return max(pad.bore.max() for pad in solution.state.films.thermal.temperatures) - 273.15


@pytest.mark.parametrize("model", PROTOTYPE)
def test_temperatures_and_gaps_of_an_independent_calculation(model):
    found = solution_of(CLEARANCE, **FILLON, **HEATED[model])
    temperature, gap = PROTOTYPE[model]
    assert hottest_bore(found) == pytest.approx(temperature, abs=0.3)
    if gap is not None:
        assert found.result.minimum_film_thickness * 1e6 == pytest.approx(gap, rel=0.01)


@pytest.mark.parametrize("model", SPEEDS)
def test_temperatures_over_speed(model):
    for rpm, expected in zip((1000, 2000, 3000), SPEEDS[model], strict=True):
        found = solution_of(CLEARANCE, **FILLON, **HEATED[model], speed=f"{rpm} rpm")
        assert hottest_bore(found) == pytest.approx(expected, abs=0.3)


@pytest.mark.parametrize("model", HEATED)
def test_heat_goes_where_the_result_says(model):
    result = result_of(**HEATED[model])
    v, rows = result.values, result.arrays
    assert v["film_dissipation"] == pytest.approx(v["friction_power"], rel=0.01)
    assert v["heat_to_oil"] + v["heat_to_pads"] == pytest.approx(v["film_dissipation"], rel=1e-3)
    assert abs(v["energy_balance_error"]) < 1e-3
    drained = v["volumetric_heat_capacity"] * v["total_flow"] * (v["outlet_temperature"] - v["supply_temperature"])
    assert drained == pytest.approx(v["heat_to_oil"], rel=1e-9)
    assert sum(rows.get("pad_heat", ((0.0,),))[0]) == pytest.approx(v["heat_to_pads"], abs=1e-9)
    assert max(rows["pad_maximum_temperature"][0]) == v["maximum_temperature"]
    assert max(rows["pad_probe_temperature"][0]) == v["probe_temperature"] < v["maximum_temperature"]
    check = {one.code: one for one in result.checks}
    assert check["C108"].quantity == "maximum_temperature"
    assert check["C403"].ok
    assert ("journal_temperature" in v) == (model != "A")


def test_pads_get_fresh_oil_where_nothing_is_carried_over():
    """S1 at its ends: without carry-over every groove is as warm as the supply, and more of it is hotter."""
    fresh, half, whole = (result_of(**HEATED["A"], carry_over=share) for share in (0.0, 0.5, 1.0))
    supply = fresh.values["supply_temperature"]
    assert fresh.arrays["pad_mixed_temperature"][0] == pytest.approx([supply] * 4, abs=1e-6)
    hot = [one.values["maximum_temperature"] for one in (fresh, half, whole)]
    assert hot[2] > hot[1] + 2.0 > hot[0] + 4.0


TURNED = 1e-6


@pytest.mark.parametrize("model", ["A", "E"])
def test_turning_everything_turns_the_answer(model):
    base = result_of(**HEATED[model], load_angle="-80 deg")
    other = result_of({"pads.first_pivot": "82 deg"}, **HEATED[model], load_angle="-43 deg")
    turn = math.radians(37.0)
    c, s = math.cos(turn), math.sin(turn)
    matrix = np.array([[c, -s], [s, c]])
    expected = matrix @ np.array(base.stiffness) @ matrix.T
    assert np.array(other.stiffness) == pytest.approx(expected, rel=TURNED, abs=TURNED * np.abs(expected).max())
    for name in ("pad_load", "pad_probe_temperature", "pad_mixed_temperature", "pad_minimum_film_thickness"):
        assert other.arrays[name][0] == pytest.approx(base.arrays[name][0], rel=TURNED)


@pytest.mark.parametrize("model", ["A", "E"])
def test_a_mirrored_bearing_that_turns_the_other_way(model):
    base = result_of({"pads.pivot": {"kind": "rigid", "fraction": 0.55}}, **HEATED[model], load_angle="-80 deg")
    other = result_of({"pads.pivot": {"kind": "rigid", "fraction": 0.55}}, **HEATED[model], load_angle="-100 deg",
                      speed="-4000 rpm")  # fmt: skip
    for name in ("maximum_temperature", "minimum_film_thickness", "friction_power", "total_flow", "journal_y",
                 "eccentricity_ratio", "attitude_angle", "outlet_temperature"):  # fmt: skip
        assert other.values[name] == pytest.approx(base.values[name], rel=TURNED)
    mirror = (1, 0, 3, 2)
    for name in ("pad_load", "pad_probe_temperature", "pad_mixed_temperature", "pad_minimum_film_thickness"):
        assert other.arrays[name][0] == pytest.approx([base.arrays[name][0][pad] for pad in mirror], rel=TURNED)


def test_a_load_and_the_place_that_it_finds_agree():
    loaded = result_of(**HEATED["B"], load_angle="-70 deg").values
    place = {"x": f"{loaded['journal_x']} m", "y": f"{loaded['journal_y']} m"}
    placed = result_of({"load": None}, position=place, **HEATED["B"]).values
    assert placed["load"] == pytest.approx(10e3, rel=1e-3)
    assert placed["maximum_temperature"] == pytest.approx(loaded["maximum_temperature"], abs=0.05)


def test_growth_narrows_the_clearance_by_what_pads_and_journal_grow():
    """S3 with the temperatures of the result; the bearing in operation has these clearances."""
    given = dict(HEATED["E"], walls=CONDUCTING | {"housing": {"temperature": "50 degC"}})
    found = solution_of(**given)
    rows, v = found.result.arrays, found.result.values
    radius, outside = 0.05, 0.05 + 148e-6 + 0.02
    journal, housing = radius * (v["journal_temperature"] - 313.15), outside * (323.15 - 313.15)
    for growth, mean, running in zip(rows["pad_growth"][0], rows["pad_mean_temperature"][0],
                                     found.state.films.solution.bearing.pads, strict=True):  # fmt: skip
        by_mean = 12e-6 * (0.02 * (mean - 313.15) + journal - housing)
        assert growth == pytest.approx(by_mean, abs=1e-6)  # the pivot is some kelvins off the mean of its pad
        assert running.assembled_clearance == pytest.approx(148e-6 * 0.53 - growth, rel=1e-12)
    assert v["growth_share"] == 1.0
    assert v["running_clearance"] == pytest.approx(148e-6 * 0.53 - max(rows["pad_growth"][0]), rel=1e-9)
    assert (1.0 - rows["pad_eccentricity_ratio"][0][2]) * (148e-6 - rows["pad_growth"][0][2]) == pytest.approx(
        rows["pad_film_thickness"][0][2], rel=1e-9
    )


def test_pads_fed_nothing_but_what_they_carry_over_have_no_equilibrium():
    """A flooded bearing of which no pad lets oil go at its sides: nothing carries its heat off."""
    small = {
        "diameter": "24.146135079775845 mm", "load": "46.183697495452506 N", "speed": "1435.867033481937 rad/s",
        "lubricant": "ISO VG 32", "supply": {"temperature": "314.3325495373182 K"}, "feed": "flooded",
        "pads": {
            "number": 4, "first_pivot": "-45 deg", "extent": "1.3701696870757274 rad",
            "width": "11.206832950698449 mm", "thickness": "4.477 mm",
            "clearance": {"kind": "radial", "mean": "19.412187854708754 um"},
            "preload": 0.06274425782455707,
            "pivot": {"kind": "spring", "fraction": 0.57, "stiffness": "11561066.02699918 N/m"},
        },
        "thermal": "global",
    }  # fmt: skip
    found = result_of(**small)
    assert found.outcome is Outcome.THERMAL_RUNAWAY
    assert found.failure.code == "S002"


def test_a_cold_housing_closes_the_clearance_and_the_share_with_a_film_is_told():
    narrow = {"pads.clearance": {"kind": "radial", "mean": "100 um"}, "pads.preload": 0.5}
    cold = dict(HEATED["E"], walls=CONDUCTING | {"housing": {"temperature": "-20 degC"}})
    result = result_of(narrow, **cold)
    assert result.outcome is Outcome.NO_CLEARANCE
    share = result.values["growth_share"]
    assert 0.0 <= share < 1.0
    assert "W406" in codes(result)
    assert (result.failure.code, result.failure.values) == ("S003", {"growth_share": share})
    assert "a film was found with up to " in result.message
    (placed,) = solve(case_from_dict(pad_case(narrow, **cold))).solutions
    ended = thermal_film.thermal_films(placed.problem).film.solution
    assert result.values["eccentricity_ratio"] == pytest.approx(math.hypot(*ended.position) / 50e-6, rel=1e-12)
    warm = dict(HEATED["E"], walls=CONDUCTING | {"housing": {"temperature": "70 degC"}})
    assert result_of(narrow, **warm).outcome.solved


def test_pads_that_take_less_than_is_carried_over_are_told_of():
    """At light load the pads take nearly what leaves the one before; all of it carried over is capped."""
    capped = result_of(**HEATED["E"])
    warnings = [one for one in capped.warnings if one.code == "W404"]
    assert warnings
    most = min(one.values["most"] for one in warnings)
    assert 0.5 < most <= 1.0
    free = result_of(**HEATED["E"], carry_over=0.97 * most)
    rows = capped.arrays
    for pad in (one.values["pad"] for one in warnings):
        assert rows["pad_trailing_flow"][0][pad - 2] > 0.98 * rows["pad_leading_flow"][0][pad - 1]
    assert "W404" not in codes(free)


def test_unloaded_pads_are_told_of_with_their_temperatures():
    result = result_of({"pads.preload": 0.0}, **HEATED["B"])
    assert result.values["loaded_pads"] == 2.0
    assert set(unloaded_pads(result)) == {1, 2}
    rows = result.arrays
    assert rows["pad_load"][0][:2] == (0.0, 0.0)
    assert min(rows["pad_maximum_temperature"][0]) > result.values["supply_temperature"]


def test_the_preload_that_would_load_a_pad_is_one_of_the_case():
    """Growth takes as much from machined as from assembled clearance: m c_p stays, and so does m_min c_p."""
    grown = dict(HEATED["E"], deformation=["growth"], materials={"pads": {"thermal_expansion": "12e-6 1/K"}})
    found = solution_of({"pads.preload": 0.1}, **grown)
    place, told = found.state.films.solution.position, unloaded_pads(found.result)
    assert list(told) == [1, 2]
    assert min(found.result.arrays["pad_growth"][0]) > 5e-6
    for one, angle in zip(told.values(), (45.0, 135.0), strict=True):
        turn = math.radians(angle)
        needed = -(place[0] * math.cos(turn) + place[1] * math.sin(turn)) / 148e-6
        assert one.values["needed"] == pytest.approx(needed, rel=1e-9)
        assert one.values["preload"] == pytest.approx(0.1, rel=1e-9)


RUN_AWAY = {
    "fast": ({}, {"lubricant": OIL | {"dynamic_viscosity": "60 mPa s"}, "speed": "38000 rpm"}),
    "no fresh oil": ({"load": None, "pads.preload": 0.0}, {"position": {"x": "0 um", "y": "0 um"}}),
}


@pytest.mark.parametrize(("changes", "fields"), RUN_AWAY.values(), ids=RUN_AWAY)
def test_films_that_run_away_tell_how_hot_they_are(changes, fields):
    result = result_of(changes, **HEATED["A"], **fields)
    assert result.outcome is Outcome.THERMAL_RUNAWAY
    assert "hotter than 300.0 °C" in result.message
    assert "supply pressure" not in result.message  # which brings no oil to pads


def test_films_hotter_than_the_data_tell_how_far_these_reach(monkeypatch):
    monkeypatch.setattr(thermal_film, "highest_usable", lambda _: 333.15)
    result = result_of(**HEATED["B"])
    assert result.outcome is Outcome.NO_LUBRICANT_DATA
    assert "were followed to 60.0 °C" in result.message


def test_heat_that_is_missed_is_told():
    found = solution_of(**HEATED["C"])
    for error, kept in ((9e-4, True), (-1.1e-3, False)):
        values = found.result.values | {"energy_balance_error": error}
        check = {one.code: one for one in heat_checks(found.problem, values)}
        assert check["C403"].ok is kept


def test_probes_have_an_alarm_and_a_trip():
    hot = result_of(**HEATED["B"]).values["probe_temperature"] - 273.15
    limits = {"probe_alarm": f"{hot - 1.0} degC", "probe_trip": f"{hot + 5.0} degC"}
    check = {one.code: one for one in result_of(**HEATED["B"], limits=limits).checks}
    assert not check["C404"].ok
    assert check["C405"].ok
    assert check["C405"].value == check["C404"].value == pytest.approx(hot + 273.15)


OFFSET = {"pads.pivot": {"kind": "rigid", "fraction": 0.55}, "pads.preload": 0.1}


def test_folds_are_those_of_the_bearing_that_runs():
    """w = g (1 - cos phi) widens c_p and e by g: a fold at e/c_p = f moves to (f (c_p + g) - g)/c_p."""
    found = solution_of(OFFSET, **HEATED["E"])
    (round_fold, *_) = (one.fold for one in solution_of(OFFSET, thermal="isothermal").state.margins)
    heated = found.state.films.thermal.temperatures
    for one, heat, pad in zip(found.state.margins, heated, found.state.films.solution.bearing.pads, strict=True):
        ends = np.array([-0.55, 0.45]) * math.radians(75.0)
        widening = float(np.mean(heat.deflection[[0, -1]] / (1.0 - np.cos(ends))))
        clearance = 148e-6 - heat.growth
        assert pad.clearance == pytest.approx(clearance, rel=1e-12)
        expected = (round_fold * (clearance + widening) - widening) / clearance
        assert one.fold == pytest.approx(expected, rel=0.01)
    assert min(one.fold for one in found.state.margins) < round_fold - 0.05


def test_folds_of_films_that_hardly_warm_are_those_of_one_temperature():
    """Offset pads of films that hardly warm unload where those of one temperature do."""
    slow = {"speed": "50 rpm", "load": "300 N"}
    resolved = solution_of(OFFSET, **slow, **HEATED["A"]).state.margins
    plain = solution_of(OFFSET, **slow, thermal="isothermal").state.margins
    for one, other in zip(resolved, plain, strict=True):
        assert one.fold == pytest.approx(other.fold, rel=0.02)
        assert one.margin == pytest.approx(other.margin, abs=0.02)


def test_a_slow_bearing_is_as_cold_as_its_oil():
    resolved = result_of(speed="2 rpm", load="20 N", **HEATED["C"]).values
    plain = result_of(speed="2 rpm", load="20 N", thermal="isothermal").values
    assert resolved["maximum_temperature"] - resolved["supply_temperature"] < 0.2
    assert abs(resolved["energy_balance_error"]) < 1e-3  # pads lose more heat per kelvin than oil carries off
    for name in ("eccentricity_ratio", "friction_power", "stiffness_yy", "damping_yy", "side_flow"):
        assert resolved[name] == pytest.approx(plain[name], rel=0.02)


def test_walls_and_housing_take_the_names_of_the_catalogue():
    named = solution_of(**dict(HEATED["E"], materials={"pads": "C45", "journal": "42CrMo4", "housing": "C45"}))
    heat = named.problem.heat
    assert heat.growth.pad_expansion == heat.bending.thermal_expansion == heat.growth.housing_expansion
    assert heat.bending.elastic_modulus == pytest.approx(210e9, rel=0.03)
    assert named.result.outcome.solved


def test_what_is_not_given_is_assumed_and_printed():
    said = " ".join(result_of(**dict(HEATED["E"], walls={"pads": {}})).assumptions)
    for words in ("100 W/(m2 K) on the backs", "100 W/(m2 K) on the edges", "behind the pads is as warm",
                  "as steel, 50 W/(m K)", "housing is as warm as the fresh oil", "journal expands as steel",
                  "housing expands as steel", "Carry-over 1 of flooded"):  # fmt: skip
        assert words in said
    given = dict(
        HEATED["E"], carry_over=1.0,
        materials={"pads": STEEL, "journal": {"thermal_expansion": "11e-6 1/K"}, "housing": "C45"},
        walls={"pads": {"conductivity": "45 W/(m K)", "heat_transfer_coefficient": "90 W/(m2 K)",
                        "edge_coefficient": "90 W/(m2 K)", "temperature": "42 degC"},
               "housing": {"temperature": "42 degC"}},
    )  # fmt: skip
    silent = " ".join(result_of(**given).assumptions)
    for words in ("100 W/(m2 K)", "as warm as the fresh oil", "as steel", "Carry-over 1"):
        assert words not in silent


def test_every_accuracy_and_point_is_solved():
    points = [{"name": "slow", "speed": "1000 rpm"}, {"name": "hot", "supply_temperature": "50 degC"}]
    case = pad_case(**HEATED["E"], operating_points=points)
    slow, hot = (one.result for one in solve(case_from_dict(case)).solutions)
    assert slow.outcome.solved
    assert hot.values["maximum_temperature"] > slow.values["maximum_temperature"] + 10.0
    draft = result_of(**HEATED["E"]).values["maximum_temperature"]
    fine = result_of(**HEATED["E"], accuracy="reference").values["maximum_temperature"]
    assert draft == pytest.approx(fine, abs=0.3)


def test_oil_whose_heat_does_not_change_is_solved_for_once(monkeypatch):
    """The oil of 1992 has one heat capacity and conductivity, one of the catalogue others when warm."""
    rounds = []
    found_at = thermal_film.found_at
    monkeypatch.setattr(thermal_film, "found_at", lambda case, at: rounds.append(at) or found_at(case, at))
    hottest.__wrapped__(JOURNAL, 3000.0)
    assert len(rounds) == 1
    rounds.clear()
    result_of(**HEATED["B"])
    assert len(rounds) > 1
