"""Physics of the kind: balances, symmetry of frames, limits, warnings, dynamics."""

import math

import numpy as np
import pytest
from pad_journals import OIL, pad_case, result_of, solution_of, unloaded_pads

from babbitt.case import case_from_dict
from babbitt.core.result import Outcome, Verdict
from babbitt.solving import solve

ISOTHERMAL = {"thermal": "isothermal", "lubricant": OIL}
SKEW = {
    "pads.number": None,
    "pads.first_pivot": None,
    "pads.pivot_angles": ["40 deg", "130 deg", "223 deg", "318 deg"],
    "pads.pivot": {"kind": "spring", "stiffness": "900 MN/m", "fraction": 0.55},
    "pads.each": [{"preload": 0.4}, {"clearance": {"kind": "radial", "mean": "160 um"}}, {"extent": "70 deg"},
                  {"pivot": {"kind": "rigid", "fraction": 0.5}}],
    "pads.mass": "2 kg",
    "pads.inertia": "0.002 kg m2",
    "pads.mass_offset": "3 mm",
}  # fmt: skip
"""Pads of which no two are alike."""


def turned(changes, degrees, order):
    """The same bearing turned by an angle, its pads counted from another one."""
    angles = [float(one.split()[0]) + degrees for one in changes["pads.pivot_angles"]]
    angles = [angles[place] - (0.0 if place < order else 360.0) for place in rolled(range(4), order)]
    angles = [one + (360.0 if angles[0] < -360.0 else 0.0) for one in angles]
    each = [changes["pads.each"][place] for place in rolled(range(4), order)]
    return changes | {"pads.pivot_angles": [f"{one} deg" for one in angles], "pads.each": each}


def rolled(items, order):
    """Items from one of them on."""
    items = list(items)
    return items[order:] + items[:order]


def rotation(degrees):
    """Matrix of a turn."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array([[c, -s], [s, c]])


ACCURATE = 1e-9


@pytest.mark.parametrize(("degrees", "order"), [(37.0, 0), (0.0, 2), (37.0, 1), (-112.0, 3)])
def test_turning_everything_turns_the_answer(degrees, order):
    """A11: pads counted from another one, and all angles turned."""
    base = result_of(SKEW, **ISOTHERMAL, load_angle="-80 deg")
    other = result_of(turned(SKEW, degrees, order), **ISOTHERMAL, load_angle=f"{degrees - 80.0} deg")
    turn = rotation(degrees)
    at = [base.values["journal_x"], base.values["journal_y"]]
    moved = [other.values["journal_x"], other.values["journal_y"]]
    assert moved == pytest.approx(turn @ at, rel=ACCURATE, abs=ACCURATE * np.hypot(*at))
    for name in ("stiffness", "damping", "static_stiffness", "virtual_mass"):
        expected = turn @ np.array(base.arrays[name]) @ turn.T
        size = np.abs(expected).max()
        assert np.array(other.arrays[name]) == pytest.approx(expected, rel=1e-8, abs=1e-8 * size)
    for name in ("pad_load", "pad_minimum_film_thickness", "pad_friction_power", "pad_tilt"):
        assert other.arrays[name][0] == pytest.approx(rolled(base.arrays[name][0], order), rel=1e-8)


def test_a_mirrored_bearing_that_turns_the_other_way():
    """A11: x becomes -x, the sense of rotation changes; tilts and cross terms change their sign."""
    base = result_of(SKEW, **ISOTHERMAL, load_angle="-80 deg", rotor_mass="900 kg")
    angles = [180.0 - float(one.split()[0]) for one in reversed(SKEW["pads.pivot_angles"])]
    mirrored = SKEW | {"pads.pivot_angles": [f"{one} deg" for one in angles],
                       "pads.each": SKEW["pads.each"][::-1]}  # fmt: skip
    other = result_of(mirrored, **ISOTHERMAL, load_angle="-100 deg", speed="-4000 rpm", rotor_mass="900 kg")
    for name in ("eccentricity_ratio", "attitude_angle", "minimum_film_thickness", "friction_power", "total_flow",
                 "log_decrement", "journal_y"):  # fmt: skip
        assert other.values[name] == pytest.approx(base.values[name], rel=1e-8)
    assert other.values["journal_x"] == pytest.approx(-base.values["journal_x"], rel=1e-8)
    flip = np.diag([-1.0, 1.0])
    for name in ("stiffness", "damping"):
        expected = flip @ np.array(base.arrays[name]) @ flip
        assert np.array(other.arrays[name]) == pytest.approx(expected, rel=1e-8, abs=1e-8 * np.abs(expected).max())
    assert other.arrays["pad_tilt"][0] == pytest.approx(
        [-one for one in base.arrays["pad_tilt"][0][::-1]], rel=1e-8
    )


def test_pads_that_are_alike_carry_no_cross_coupling():
    result = result_of({"pads.first_pivot": "-90 deg", "pads.pivot": {"kind": "rigid"}}, load_angle="-71 deg")
    k = np.array(result.stiffness)
    assert abs(k[0, 1]) < 1e-9 * k[1, 1]
    assert abs(k[1, 0]) < 1e-9 * k[1, 1]


def test_the_static_stiffness_is_the_slope_of_the_load():
    def force(y):
        found = solution_of({"load": None}, position={"x": "3 um", "y": f"{y} um"}, **ISOTHERMAL)
        return found.state.films.solution.force

    step = 0.05
    slope = (force(-40.0 - step) - force(-40.0 + step)) / (2e-6 * step)
    k = np.array(result_of({"load": None}, position={"x": "3 um", "y": "-40 um"}, **ISOTHERMAL).static_stiffness)
    assert slope[1] == pytest.approx(
        k[1, 1], rel=2e-3
    )  # coefficients are freed from the steps of the grid, loads are not


def test_a_load_and_the_place_that_it_finds_agree():
    loaded = result_of(**ISOTHERMAL, load_angle="-70 deg").values
    place = {"x": f"{loaded['journal_x']} m", "y": f"{loaded['journal_y']} m"}
    placed = result_of({"load": None}, position=place, **ISOTHERMAL).values
    assert placed["load"] == pytest.approx(10e3, rel=1e-6)
    assert math.degrees(placed["load_angle"]) == pytest.approx(-70.0, abs=1e-4)
    for name in ("friction_power", "minimum_film_thickness", "stiffness_xx", "damping_yy"):
        assert placed[name] == pytest.approx(loaded[name], rel=1e-5)


@pytest.mark.parametrize("carry_over", [0.0, 0.6, 1.0])
def test_the_heat_balance_closes(carry_over):
    result = result_of(carry_over=carry_over)
    v = result.values
    assert abs(v["energy_balance_error"]) < 1e-9
    heat = v["volumetric_heat_capacity"] * v["total_flow"] * (v["outlet_temperature"] - v["supply_temperature"])
    assert heat == pytest.approx(v["friction_power"], rel=1e-9)
    passing = sum(result.arrays["pad_trailing_flow"][0])
    entering = sum(result.arrays["pad_leading_flow"][0])
    mixed = carry_over * passing * v["trailing_temperature"]
    mixed += (entering - carry_over * passing) * v["supply_temperature"]
    assert mixed / entering == pytest.approx(v["pad_inlet_temperature"], rel=1e-9)
    mean = 0.5 * (v["pad_inlet_temperature"] + v["trailing_temperature"])
    assert v["effective_temperature"] == pytest.approx(mean, abs=1e-6)


def test_more_carried_over_is_hotter():
    hot = [result_of(carry_over=share).values["effective_temperature"] for share in (0.0, 0.5, 1.0)]
    assert hot == sorted(hot)
    assert hot[2] > hot[0] + 5.0


def test_a_given_flow_cools_the_drain_alone():
    free, fed = result_of(), result_of({"supply.flow": "30 L/min"})
    assert fed.values["effective_temperature"] == pytest.approx(free.values["effective_temperature"])
    assert fed.values["outlet_temperature"] < free.values["outlet_temperature"] - 10.0
    assert fed.values["surplus_flow"] == pytest.approx(5e-4 - fed.values["total_flow"])
    drained = 5e-4 * fed.values["volumetric_heat_capacity"] * (fed.values["outlet_temperature"] - 313.15)
    assert drained == pytest.approx(fed.values["friction_power"], rel=1e-9)


def test_two_of_three_clearances_give_the_third():
    assembled = {"kind": "radial", "mean": "78.44 um"}
    ways = [
        {},
        {"pads.preload": None, "pads.assembled_clearance": assembled},
        {"pads.clearance": None, "pads.assembled_clearance": assembled},
        {"pads.clearance": {"kind": "diametral", "mean": "296 um"}},
        {"pads.clearance": {"kind": "relative", "mean": "2.96 permille"}},
    ]
    found = [result_of(one, **ISOTHERMAL) for one in ways]
    for one in found:
        assert one.values["preload"] == pytest.approx(0.47)
        assert one.values["assembled_clearance"] == pytest.approx(78.44e-6)
        assert one.values["largest_pad_clearance"] == pytest.approx(148e-6)
        assert one.values["minimum_film_thickness"] == pytest.approx(found[0].values["minimum_film_thickness"])


def test_clearance_cases_take_the_limits():
    limits = {"kind": "radial", "mean": "148 um", "minimum": "140 um", "maximum": "160 um"}
    case = case_from_dict(pad_case({"pads.clearance": limits}, clearance_cases="all"))
    results = solve(case).results
    names = [f"Pads ({which} clearance)" for which in ("minimum", "mean", "maximum")]
    assert [one.name for one in results] == names
    assert [one.values["largest_pad_clearance"] for one in results] == pytest.approx([140e-6, 148e-6, 160e-6])
    assert [one.values["preload"] for one in results] == pytest.approx([0.47] * 3)
    held = [any("the preload is that of the mean" in said for said in one.assumptions) for one in results]
    assert held == [True, False, True]


@pytest.mark.parametrize(
    ("clearance", "asked", "code"),
    [
        ({"kind": "radial", "mean": "148 um", "minimum": "140 um", "maximum": "160 um"}, True, "W174"),
        ({"kind": "radial", "mean": "148 um", "minimum": "145 um", "maximum": "151 um"}, True, "W183"),
        ({"kind": "radial", "mean": "148 um", "minimum": "145 um", "maximum": "151 um"}, False, "W174"),
        ({"kind": "deviations", "bore": ["0 um", "40 um"], "journal": ["-290 um", "-260 um"]}, True, "W174"),
        ({"kind": "radial", "mean": "148 um"}, True, None),
    ],
)
def test_limits_of_clearances_that_are_not_solved_are_named(clearance, asked, code):
    """Those of sizes were not, and the mean that a case asks for was never questioned."""
    given = pad_case({"pads.clearance": clearance}, **({"clearance_cases": "mean"} if asked else {}))
    (found,) = case_from_dict(given).calculations()
    told = {one.code: one.values["fields"] for one in found.problem.warnings if one.code in ("W174", "W183")}
    named = [one for one, fields in told.items() if any(field.startswith("pads.clearance") for field in fields)]
    assert named == ([code] if code else [])


def test_operating_points_change_what_they_give():
    points = [
        {"name": "half", "load": "5 kN"},
        {"name": "slow", "speed": "2000 rpm"},
        {"name": "aside", "load_angle": "0 deg"},
        {"name": "warm", "supply_temperature": "50 degC"},
    ]
    half, slow, aside, warm = solve(case_from_dict(pad_case(operating_points=points))).results
    base = result_of()
    assert half.values["load"] == pytest.approx(5e3)
    assert slow.values["angular_speed"] == pytest.approx(0.5 * base.values["angular_speed"])
    assert aside.values["friction_power"] == pytest.approx(base.values["friction_power"], rel=1e-6)
    assert aside.values["journal_x"] > 50e-6
    assert warm.values["effective_temperature"] > base.values["effective_temperature"] + 3.0


def codes(result):
    return [one.code for one in result.warnings]


def test_an_unloaded_pad_is_told_with_the_preload_that_loads_it():
    result = result_of({"pads.preload": 0.0, "load": "10 kN"}, **ISOTHERMAL)
    assert result.arrays["pad_status"][0] == (0.0, 0.0, 1.0, 1.0)
    assert math.isnan(result.arrays["pad_tilt"][0][0])
    assert result.arrays["pad_load"][0][0] == 0.0
    told = unloaded_pads(result)
    assert set(told) == {1, 2}
    needed = told[1].values["needed"]
    at = result.values["journal_y"] * math.sin(math.radians(45.0))
    assert needed == pytest.approx(-at / 148e-6, abs=1e-3)
    margin = next(one for one in result.checks if one.code == "C402")
    assert not margin.ok
    assert margin.advisory
    assert margin.value == pytest.approx(at / 148e-6, abs=1e-6)


def test_all_unloaded_pads_are_named_with_the_preload_that_loads_every_one():
    """The upper pad of five between pads needs the most: its bore is the farthest from the journal."""
    five = {"pads.number": 5, "pads.first_pivot": "-54 deg", "pads.extent": "56 deg", "pads.preload": 0.05}
    result = result_of(five | {"load": "20 kN"}, **ISOTHERMAL)
    told = unloaded_pads(result)
    needed = {pad: one.values["needed"] for pad, one in told.items()}
    assert list(needed) == [2, 3, 4]
    assert needed[3] > 1.2 * needed[2]
    message = next(one.message for one in result.warnings if one.code == "W401")
    assert all(f"pad {pad} would carry above a preload of {one:.3f}" in message for pad, one in needed.items())
    assert message.endswith(f"all of them would above {needed[3]:.3f}")
    loaded = result_of(five | {"load": "20 kN", "pads.preload": needed[3] + 0.02}, **ISOTHERMAL)
    assert "W401" not in codes(loaded)


def test_that_preload_loads_it():
    free = result_of({"pads.preload": 0.0}, **ISOTHERMAL)
    needed = -free.values["journal_y"] * math.sin(math.radians(45.0)) / 148e-6
    upper = {"preload": needed + 0.02}
    held = result_of({"pads.preload": 0.0, "pads.each": [upper, upper, {}, {}]}, **ISOTHERMAL)
    assert held.arrays["pad_status"][0] == (1.0, 1.0, 1.0, 1.0)
    assert "W402" in codes(held)
    assert "W401" not in codes(held)


def test_a_pad_at_its_limit_is_no_solution():
    """Among loads there is one at which an offset pad would have to carry less than it can."""
    loads = np.linspace(1.0, 6.0, 26)
    offset = {"pads.preload": 0.0, "pads.pivot": {"kind": "rigid", "fraction": 0.52}}
    found = [result_of(offset, **ISOTHERMAL, load=f"{load} kN", load_angle="-40 deg") for load in loads]
    at_limit = [one for one in found if one.outcome is Outcome.PAD_AT_LIMIT]
    assert at_limit
    assert {one.verdict for one in at_limit} == {Verdict.NO_SOLUTION}
    assert {one.failure.code for one in at_limit} == {"S401"}
    assert all(0.0 < one.failure.values["need"] < one.failure.values["least"] for one in at_limit)
    assert all("would have to carry" in one.message for one in at_limit)
    assert all(one.outcome.solved for one in found if one not in at_limit)


def test_turbulence_and_starvation_have_no_verdict():
    thin = OIL | {"dynamic_viscosity": "1 mPa s"}
    fast = result_of(lubricant=thin, thermal="isothermal", speed="20000 rpm", load="3 kN")
    assert "W407" in codes(fast)
    assert fast.verdict is Verdict.NO_VERDICT
    free = result_of(carry_over=0.5)
    flow = 0.9 * free.values["total_flow"]
    starved = result_of({"supply.flow": f"{flow * 6e4} L/min"}, carry_over=0.5)
    assert "W405" in codes(starved)
    assert "W405" not in codes(free)


def test_a_wide_line_contact_is_told():
    line = {"kind": "line", "pivot_radius": "20 mm", "housing_radius": "20.05 mm", "depth": "20 mm",
            "housing_depth": "20 mm"}  # fmt: skip
    assert "W408" in codes(result_of({"pads.pivot": line}))
    assert "W408" not in codes(
        result_of({"pads.pivot": line | {"housing_radius": "40 mm", "pivot_radius": "30 mm"}})
    )


def test_unusual_pads_are_told():
    assert "W409" in codes(result_of({"pads.pivot": {"kind": "rigid", "fraction": 0.45}}))
    assert "W410" in codes(result_of({"pads.preload": -0.1}, **ISOTHERMAL))
    two = {"pads.number": 2, "pads.first_pivot": "-135 deg", "pads.extent": "120 deg"}
    told = codes(result_of(two | {"pads.pivot_angles": ["-135 deg", "-45 deg"], "pads.number": None,
                                  "pads.first_pivot": None, "pads.extent": "80 deg"}, **ISOTHERMAL))  # fmt: skip
    assert "W410" in told


def test_against_the_sense_of_the_bearing_offset_pads_run_backward():
    offset = {"pads.pivot": {"kind": "rigid", "fraction": 0.55}}
    points = [{"name": "astern", "speed": "-4000 rpm"}]
    (astern,) = solve(case_from_dict(pad_case(offset, operating_points=points))).results
    assert "W409" in codes(astern)
    before = result_of({"pads.pivot": {"kind": "rigid", "fraction": 0.45}}, speed="-4000 rpm")
    assert astern.values["minimum_film_thickness"] == pytest.approx(before.values["minimum_film_thickness"])
    ahead = result_of(offset)
    assert "W409" not in codes(ahead)
    assert astern.values["minimum_film_thickness"] < ahead.values["minimum_film_thickness"]


def test_soft_pivots_cost_stiffness_and_damping():
    rigid = result_of(**ISOTHERMAL)
    hard = result_of({"pads.pivot": {"kind": "spring", "stiffness": "1e15 N/m"}}, **ISOTHERMAL)
    soft = result_of({"pads.pivot": {"kind": "spring", "stiffness": "200 MN/m"}}, **ISOTHERMAL)
    assert hard.values["stiffness_yy"] == pytest.approx(rigid.values["stiffness_yy"], rel=1e-4)
    assert soft.values["stiffness_yy"] < 0.6 * rigid.values["stiffness_yy"]
    assert soft.values["damping_yy"] < 0.4 * rigid.values["damping_yy"]


PIVOTS = {
    "spring": {"kind": "spring", "stiffness": "500 MN/m", "housing_stiffness": "1 GN/m"},
    "point": {"kind": "point", "pivot_radius": "100 mm", "housing_radius": "102 mm"},
    "button": {"kind": "point", "pivot_radius": "100 mm"},
    "line": {"kind": "line", "pivot_radius": "70 mm", "housing_radius": "75 mm", "depth": "20 mm",
             "housing_depth": "20 mm"},
    "rocker": {"kind": "rocker"},
    "table": {"kind": "table", "points": [{"load": "5 kN", "displacement": "8 um"},
                                          {"load": "9 kN", "displacement": "12 um"}]},
    "flexure": {"kind": "flexure", "rotational_stiffness": "40 kN m/rad", "stiffness": "500 MN/m"},
}  # fmt: skip


@pytest.mark.parametrize("kind", PIVOTS)
def test_every_pivot_carries_its_load(kind):
    result = result_of({"pads.pivot": PIVOTS[kind]}, **ISOTHERMAL)
    assert result.outcome is Outcome.CONVERGED
    angles = np.array(result.arrays["pad_pivot_angle"][0])
    loads = np.array(result.arrays["pad_load"][0])
    if kind != "flexure":  # whose tilting moment adds a force along the journal
        assert -loads @ np.sin(angles) == pytest.approx(10e3, rel=1e-6)
    assert result.arrays["pivot_displacement"][0][2] > 1e-6


def test_a_stiff_flexure_holds_its_pads():
    """A flexure of great stiffness is a bearing of fixed pads, whose cross terms differ."""
    stiff = {"kind": "flexure", "rotational_stiffness": "10000000 kN m/rad"}
    result = result_of({"pads.pivot": stiff}, **ISOTHERMAL)
    k = np.array(result.stiffness)
    assert abs(k[0, 1] - k[1, 0]) > 0.5 * k[1, 1]
    free = np.array(result_of(**ISOTHERMAL).stiffness)
    assert abs(free[0, 1]) < 1e-9 * free[1, 1]


def test_a_rigid_rotor_and_one_on_a_very_stiff_shaft_agree():
    fields = {"pads.first_pivot": "-90 deg"}
    rigid = result_of(fields, rotor_mass="2 t", **ISOTHERMAL).values
    stiff = result_of(fields, rotor_mass="2 t", shaft_stiffness="1000 GN/m", **ISOTHERMAL).values
    soft = result_of(fields, rotor_mass="2 t", shaft_stiffness="50 MN/m", **ISOTHERMAL).values
    assert stiff["log_decrement"] == pytest.approx(rigid["log_decrement"], rel=1e-2)
    assert soft["log_decrement"] < 0.8 * rigid["log_decrement"]


def test_the_decrement_is_not_performed_without_a_rotor():
    result = result_of(**ISOTHERMAL)
    assert "C401" in {one.code for one in result.not_checked}
    assert "log_decrement" not in result.values
    limited = result_of(rotor_mass="2 t", limits={"log_decrement": 5.0})
    check = next(one for one in limited.checks if one.code == "C401")
    assert check.limit == 5.0
    assert not check.ok


def test_inertia_of_the_pads_makes_them_flutter():
    """A pad too heavy for its film: the threshold of the engine, 5 to 10 in its scale, at the kind."""
    light = result_of({"pads.inertia": "0.001 kg m2"}, rotor_mass="200 kg", **ISOTHERMAL)
    heavy = result_of({"pads.inertia": "20 kg m2"}, rotor_mass="200 kg", **ISOTHERMAL)
    assert light.values["log_decrement"] > 0.0 > heavy.values["log_decrement"]
    assert heavy.verdict is Verdict.FAIL


def test_a_wide_band_does_not_fit():
    result = result_of({"pads.inertia": "0.05 kg m2"}, whirl_ratios=[0.1, 1.0, 2.0, 4.0], **ISOTHERMAL)
    assert result.values["fit_error"] > 0.05
    assert "W403" in codes(result)
    few = result_of(whirl_ratios=[0.5, 1.0], **ISOTHERMAL)
    assert "fit_error" not in few.values
    assert "fit_error" in few.missing


def test_the_matrices_of_journal_and_pads_condense_to_the_synchronous_ones():
    result = result_of(SKEW, **ISOTHERMAL, load_angle="-80 deg")
    names = result.settings["motions"].split(", ")
    assert names[:2] == ["x", "y"]
    assert "pad 1 tilt" in names
    assert "pad 1 pivot" in names
    k, c, m = (np.array(result.arrays[f"system_{name}"]) for name in ("stiffness", "damping", "mass"))
    w = abs(result.values["angular_speed"])
    z = k + 1j * w * c - w**2 * m
    condensed = z[:2, :2] - z[:2, 2:] @ np.linalg.solve(z[2:, 2:], z[2:, :2])
    assert condensed.real == pytest.approx(np.array(result.stiffness), rel=1e-9)
    assert condensed.imag / w == pytest.approx(np.array(result.damping), rel=1e-9)


def test_the_motions_of_the_rotor_decide_and_those_of_the_pads_stand_beside_them():
    """Elastic pivots under massive pads ring at kilohertz; that is no log decrement of the rotor."""
    stiff = {
        "pads.pivot": {"kind": "spring", "stiffness": "2 GN/m"},
        "pads.mass": "2 kg",
        "pads.first_pivot": "-90 deg",
    }
    found = solution_of(stiff, rotor_mass="2 t", shaft_stiffness="200 MN/m", **ISOTHERMAL)
    v = found.result.values
    assert v["log_decrement"] == min(v["log_decrement_forward"], v["log_decrement_backward"])
    assert v["pad_log_decrement"] < v["log_decrement"]
    shares = [mode.share for mode in found.state.dynamics.motions.of_the_rotor]
    assert min(shares) > 0.2
    assert max(v["whirl_frequency_forward"], v["whirl_frequency_backward"]) < v["angular_speed"]
