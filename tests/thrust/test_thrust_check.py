"""Thrust bearings from case to result: heat balance, warnings, either sense, given film, unsolved cases."""

import math
import re

import numpy as np
import pytest

from babbitt import parse_case
from babbitt.case import template
from babbitt.core.notices import InputError, Subject
from babbitt.core.result import Outcome, Verdict
from babbitt.design.pad_heat import HeatBalance
from babbitt.kinds.thrust.design import Oil, PrescribedThrust, operating_state
from babbitt.kinds.thrust.heat import temperatures_of
from babbitt.kinds.thrust.report.sentences import answers
from babbitt.solving import solve
from babbitt.study.comparison import compare_methods

GIVEN = "{kind: viscosity, viscosity: 45 mPa s}"
BALANCE = "{kind: heat_balance, lubricant: ISO VG 100, supply_temperature: 45 degC"


def text(oil=GIVEN, **changes):
    lines = {
        "babbitt": "1",
        "kind": "thrust",
        "name": "Block",
        "thrust": "500 kN",
        "speed": "125 rpm",
        "oil": oil,
        "ring_stiffness": "20 GN/m",
        "tilt": "{offset: 30 um}",
        "pads": "{number: 8, inner_radius: 190 mm, "
        "outer_radius: 375 mm, extent: 36 deg, pivot: {kind: point, radius: 290 mm, fraction: 0.6}}",
    } | changes
    return "\n".join(f"{key}: {value}" for key, value in lines.items() if value is not None)


FOUR = {
    "thrust": "250 kN",
    "pads": "{number: 4, inner_radius: 190 mm, "
    "outer_radius: 375 mm, extent: 36 deg, pivot: {kind: point, radius: 290 mm, fraction: 0.6}}",
}
"""Half the bearing: pads with temperatures of their own take their time."""


def result(**changes):
    return solve(parse_case(text(**changes))).results[0]


def test_the_case_gives_the_reference_share():
    found = result()
    assert found.outcome.solved
    loads = [load / 1e3 for load in found.arrays["pad_load"][0]]
    assert loads == pytest.approx([122.84, 93.08, 51.13, 31.27, 26.20, 31.27, 51.13, 93.08], rel=5e-3)
    assert found.load == pytest.approx(500e3)
    assert found.axial_stiffness == pytest.approx(sum(found.arrays["pad_stiffness"][0]))
    assert len(found.arrays["full_stiffness"]) == 3


def test_what_found_no_film_keeps_its_warnings():
    """A stiffness that may have been read 1000 times too low is doubted where there is no film, too."""
    lost = result(oil=f"{BALANCE}}}", thrust="90 MN", tilt=None, ring_stiffness="20.000 GN/m")
    assert not lost.outcome.solved
    assert "W181" in {notice.code for notice in lost.warnings}


@pytest.mark.parametrize("carry_over", [0.0, 0.5, 0.85])
def test_the_heat_balance_closes(carry_over):
    """P = rho c Q_fresh (T_drain - T_s), and mixing at the leading edges: Q_in T_in = lambda Q_t T_t + Q_fresh
    T_s.
    """
    found = result(oil=f"{BALANCE}, carry_over: {carry_over}}}", tilt=None)
    assert abs(found.energy_balance_error) < 1e-9
    case = parse_case(text(oil=f"{BALANCE}, carry_over: {carry_over}}}", tilt=None))
    design = case.thrust_design()
    state = operating_state(design)
    temperatures = state.temperatures
    trailing = sum(pad.trailing_flow for pad in state.share.states)
    leading = sum(pad.leading_flow for pad in state.share.states)
    mixed = carry_over * trailing * temperatures.trailing + temperatures.fresh_flow * temperatures.supply
    assert leading * temperatures.inlet == pytest.approx(mixed, rel=1e-9)
    oil = design.oil.lubricant
    assert state.films.viscosity == pytest.approx(oil.dynamic_viscosity(temperatures.effective), rel=1e-9)
    heat = oil.volumetric_heat_capacity(temperatures.effective)
    carried = heat * temperatures.fresh_flow * (temperatures.drain - temperatures.supply)
    assert carried == pytest.approx(found.friction_power, rel=1e-6)


def test_more_hot_oil_carried_over_makes_warmer_thinner_films():
    found = [result(oil=f"{BALANCE}, carry_over: {share}}}") for share in (0.0, 0.4, 0.8)]
    films = [one.minimum_film_thickness for one in found]
    assert films == sorted(films, reverse=True)
    assert found[0].pad_inlet_temperature == pytest.approx(318.15)
    assert found[0].effective_temperature < found[1].effective_temperature < found[2].effective_temperature


def test_a_given_film_finds_its_thrust():
    found = result(thrust=None, film="50 um", tilt=None, ring_stiffness=None)
    assert found.pivot_film_thickness == pytest.approx(50e-6, rel=1e-9)
    again = result(thrust=f"{found.load} N", tilt=None, ring_stiffness=None)
    assert again.pivot_film_thickness == pytest.approx(50e-6, rel=1e-9)


def test_a_crowned_pad_runs_both_ways_alike():
    pads = (
        "{number: 8, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, crown: 20 um, "
        "pivot: {kind: point, radius: 287 mm, fraction: 0.5}}"
    )
    ahead, astern = (result(pads=pads, speed=speed, thrust="100 kN") for speed in ("125 rpm", "-125 rpm"))
    assert astern.minimum_film_thickness == pytest.approx(ahead.minimum_film_thickness, rel=1e-6)


def test_taper_land_pads_run_one_way():
    pads = (
        "{number: 8, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, pivot: {kind: fixed}, "
        "face: {kind: taper, depth: 40 um, fraction: 0.7}}"
    )
    assert result(pads=pads, thrust="200 kN").outcome.solved
    with pytest.raises(InputError, match="carries nothing"):
        result(pads=pads, thrust="200 kN", speed="-125 rpm")


def test_turbulence_is_told_or_computed():
    fast = {
        "speed": "6000 rpm",
        "oil": "{kind: viscosity, viscosity: 5 mPa s}",
        "thrust": "300 kN",
        "tilt": None,
        "ring_stiffness": None,
    }
    laminar, turbulent = result(**fast), result(**fast, turbulence="ng_pan")
    assert "W204" in [notice.code for notice in laminar.warnings]
    assert "W204" not in [notice.code for notice in turbulent.warnings]
    assert turbulent.minimum_film_thickness > laminar.minimum_film_thickness
    assert turbulent.friction_power > laminar.friction_power


@pytest.mark.parametrize(("tilt", "doubted"), [("30 um", False), ("200 um", True)])
def test_a_tilt_as_large_as_the_film_is_doubted(tilt, doubted):
    found = result(tilt=f"{{offset: {tilt}}}", ring_stiffness=None)
    assert ("W201" in [notice.code for notice in found.warnings]) is doubted


def test_a_thin_film_breaks_its_limit():
    assert result(thrust="20 MN").verdict is Verdict.FAIL
    assert all(check.ok for check in result(film_limit="1 um").limits)


def test_friction_that_outruns_the_oil_is_no_solution():
    found = result(oil=f"{BALANCE}, carry_over: 0.99}}", thrust="300 MN", speed="30000 rpm")
    assert not found.outcome.solved
    assert found.message


def test_runout_raises_the_load_of_a_slowly_turning_collar():
    found = result(runout="5 um")
    assert found.quasi_static_load_ratio > found.pad_load_ratio


def test_pad_heights_reach_the_pads():
    found = result(
        tilt=None,
        pads="{number: 2, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, "
        "heights: [5 um, -5 um], pivot: {kind: line, radius: 290 mm, fraction: 0.6}}",
        thrust="120 kN",
    )
    first, second = found.arrays["pad_load"][0]
    assert first > 1.2 * second
    assert found.settings["pivot"] == "line"


def test_the_template_has_its_heat_balance():
    level = re.sub("(?m)^tilt:.*$", "", template("thrust"))
    design = parse_case(level).thrust_design()
    assert isinstance(design.oil, Oil)
    assert isinstance(design.duty, PrescribedThrust)
    state = operating_state(design)
    balance = design.oil.balance
    assert isinstance(balance, HeatBalance)
    again = temperatures_of(balance, state.share.states, state.temperatures.effective)
    assert again.effective == pytest.approx(state.temperatures.effective, abs=1e-5)
    assert math.isclose(again.fresh_flow, state.temperatures.fresh_flow, rel_tol=1e-9)


def test_a_load_that_no_film_carries_is_told():
    found = result(thrust="500 MN")
    codes = {notice.code: notice.message for notice in found.warnings}
    assert {"W142", "W207"} <= set(codes)
    assert "pad 1 would run on" in codes["W207"]
    assert not found.within_limits


@pytest.mark.parametrize("radial", ["mean", "resolved"])
def test_an_adiabatic_case_tells_temperatures_and_sums_its_flows(radial):
    found = result(oil=f"{BALANCE}}}", thermal="adiabatic", radial_temperature=radial, **FOUR)
    assert found.outcome.solved
    assert found.energy_balance_error < 1e-8
    assert found.supply_temperature < found.pad_inlet_temperature < found.trailing_temperature
    assert found.trailing_temperature < found.maximum_temperature
    flows = {name: sum(found.arrays[f"pad_{name}_flow"][0]) for name in ("leading", "trailing", "inner", "outer")}
    assert flows["leading"] == pytest.approx(flows["trailing"] + flows["inner"] + flows["outer"], rel=1e-9)
    assert found.side_flow == pytest.approx(flows["inner"] + flows["outer"])
    fresh = flows["leading"] - 0.75 * flows["trailing"]
    assert found.total_flow == pytest.approx(fresh, rel=1e-9)


def test_the_three_thermal_models_are_named_in_the_case():
    one, other = result(oil=f"{BALANCE}}}"), result(oil=f"{BALANCE}}}", thermal="global")
    assert one.minimum_film_thickness == other.minimum_film_thickness
    assert result(thermal="isothermal").minimum_film_thickness == result().minimum_film_thickness


def test_taper_pads_have_temperatures_of_their_own():
    pads = (
        "{number: 8, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, pivot: {kind: fixed}, "
        "face: {kind: taper, depth: 40 um, fraction: 0.7}}"
    )
    own = result(oil=f"{BALANCE}}}", thermal="adiabatic", pads=pads, tilt=None)
    one = result(oil=f"{BALANCE}}}", thermal="global", pads=pads, tilt=None)
    assert own.energy_balance_error < 1e-8
    assert own.pivot_film_thickness == pytest.approx(one.pivot_film_thickness, rel=0.3)


@pytest.mark.parametrize("tilt", [None, "{offset: 30 um}"])
def test_a_step_carries_no_more_than_its_bound(tilt):
    """In front of a step of depth d the pressure is at most that of a film of that depth: no film carries more."""
    pads = (
        "{number: 8, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, pivot: {kind: fixed}, "
        "face: {kind: step, depth: 100 um, fraction: 0.6}}"
    )
    assert result(pads=pads, tilt=tilt, thrust="300 kN").outcome.solved
    found = result(pads=pads, tilt=tilt, thrust="1 MN")
    assert found.outcome is Outcome.OVERLOADED
    assert not found.values
    assert "of 1000 kN" in found.message
    assert "deep step" in found.message


WARM = {"oil": f"{BALANCE}}}"}
METAL = "{bearing_metal: B83}"


def of_temperature(found):
    return {check.code: check for check in found.checks if check.code in ("C104", "C108", "C109")}


@pytest.mark.parametrize(
    ("changed", "hottest"),
    [
        (WARM, "hottest_trailing_temperature"),
        (WARM | {"tilt": None}, "trailing_temperature"),
        (WARM | FOUR | {"thermal": "adiabatic"}, "maximum_temperature"),
    ],
)
def test_the_hottest_oil_known_is_held_against_the_metal(changed, hottest):
    """Without a metal tin Babbitt, 115 °C, and this is said; of all temperatures none known is hotter."""
    found = result(**changed)
    checks = of_temperature(found)
    assert set(checks) == {"C104", "C108"}
    assert checks["C108"].quantity == hottest
    assert checks["C108"].value == found.values[hottest]
    assert checks["C108"].value == max(v for name, v in found.values.items() if name.endswith("_temperature"))
    assert checks["C108"].limit == pytest.approx(115.0 + 273.15)
    assert checks["C104"].limit == pytest.approx(100.0 + 273.15)
    assert "assumption: B83" in checks["C108"].source
    assert "no bearing metal is given" in " ".join(found.assumptions)
    assert found.not_checked == ()
    assert {one.code for one in found.checks if one.advisory} == {"C103", "C105", "C106", "C107"}
    assert found.lacking == (Subject.SPECIFIC_LOAD,)  # a recommendation decides nothing
    assert found.verdict is Verdict.NO_VERDICT
    assert "W128" not in {one.code for one in found.warnings}


def test_no_temperature_is_passed_over_in_silence():
    notice, *others = result().not_checked
    assert notice.code == "C104"
    assert [one.code for one in others] == ["C108"]
    assert "no heat balance" in notice.message
    assert [one.code for one in result(materials=METAL).not_checked] == ["C104", "C108"]


def test_a_prescribed_temperature_can_miss_a_limit_and_never_keep_it():
    """The films make heat that nobody has balanced: how hot they become is not known."""
    oil = "{{kind: temperature, lubricant: ISO VG 100, temperature: {} degC}}"
    cool, hot = (result(oil=oil.format(given)) for given in (53, 118))
    assert of_temperature(cool) == {}
    assert "C104" in {one.code for one in cool.not_checked}
    assert cool.verdict is Verdict.NO_VERDICT
    assert {code: check.ok for code, check in of_temperature(hot).items()} == {"C104": False, "C108": False}
    assert hot.verdict is Verdict.FAIL


def test_a_metal_and_a_limit_of_the_case_take_the_place_of_the_assumed():
    hottest = result(**WARM).hottest_trailing_temperature - 273.15
    limited = result(**WARM, temperature_limit=f"{hottest - 1.0} degC")
    assert set(of_temperature(limited)) == {"C104"}
    assert not limited.within_limits
    assert of_temperature(limited)["C104"].quantity == "hottest_trailing_temperature"
    assert result(**WARM, temperature_limit=f"{hottest + 1.0} degC", materials=METAL).within_limits
    named = result(**WARM, materials=METAL)
    assert set(of_temperature(named)) == {"C104", "C108", "C109"}
    assert "reverse-gear study" in of_temperature(named)["C108"].source
    assert of_temperature(named)["C109"].advisory
    soft = result(**WARM, materials="{bearing_metal: SnSb8Cu4}")
    assert "tin-based" in of_temperature(soft)["C108"].source


def test_babbitt_that_softens_is_beyond_its_limit():
    """Oil fed at 90 °C, all hot oil but a tenth carried over, a pad of 900 kN: beyond 115 °C."""
    found = result(oil=BALANCE.replace("45 degC", "90 degC") + ", carry_over: 0.9}", thrust="900 kN", tilt=None)
    assert found.trailing_temperature > 115.0 + 273.15
    assert not of_temperature(found)["C108"].ok
    assert not found.within_limits


def test_oil_hotter_at_the_trailing_edges_than_its_data_is_told():
    found = result(oil=BALANCE.replace("45 degC", "95 degC") + "}", thrust="900 kN", tilt=None)
    hottest = found.trailing_temperature - 273.15
    assert f"{hottest:.1f} °C" in {one.code: one.message for one in found.warnings}["W128"]


LINE_PIVOTS = (
    "{number: 8, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, "
    "pivot: {kind: line, radius: 290 mm, fraction: 0.6}}"
)


@pytest.mark.parametrize("thermal", ["global", "adiabatic"])
def test_the_heat_of_pads_that_lean_ever_more_is_balanced_until_one_touches(thermal):
    """Oil that would be too thin for a film bounds the search for its temperature, and does not end it."""
    tilts = {"global": (30, 40, 50, 80), "adiabatic": (40, 50, 55, 80)}[thermal]
    *borne, touching = (
        result(pads=LINE_PIVOTS, tilt=f"{{offset: {tilt} um}}", thermal=thermal, **WARM) for tilt in tilts
    )
    thinnest = [found.minimum_film_thickness for found in borne]
    assert thinnest == sorted(thinnest, reverse=True)
    assert 0.0 < thinnest[-1] < 3e-6
    assert max(found.energy_balance_error for found in borne) < 1e-6
    assert touching.outcome is Outcome.OVERLOADED
    assert "pad 1 leans with the housing and touches" in touching.message
    assert "a straighter housing" in touching.message


@pytest.mark.parametrize("runout", ["5 um", "[5 um]", "{amplitude: 5 um}", "[{amplitude: 5 um, lobes: 1}]"])
def test_runout_is_one_thing_however_it_is_written(runout):
    given, plain = parse_case(text(runout=runout)), parse_case(text(runout="5 um"))
    assert given == plain
    line = template("thrust_line").split("runout:")
    after = line[1].split("\n\n", 1)[1]
    of_line = parse_case(f"{line[0]}runout: {runout}\n\n{after}")
    assert of_line.line_design().runouts == given.thrust_design().runouts


def test_runout_of_a_wrong_kind_is_told_what_would_do():
    unknown = "[{amplitude: 5 um, lobe: 2}]"
    for wrong, words in (("true", "a length such as"), ("5 kg", "is a mass"), (unknown, "lobes")):
        with pytest.raises(InputError, match=f"runout.*{words}"):
            parse_case(text(runout=wrong))


def test_the_limit_of_the_film_holds_while_the_runout_passes():
    still, turning = result(tilt=None), result(tilt=None, runout="20 um")
    (limit,) = [one for one in turning.checks if one.code == "C202"]
    assert turning.values["minimum_film_thickness"] == still.values["minimum_film_thickness"]
    thin = turning.values["quasi_static_minimum_film_thickness"]
    assert limit.quantity == "quasi_static_minimum_film_thickness"
    assert limit.value == thin < still.values["minimum_film_thickness"]
    # the pad that carries most holds its load by the film of a pad under this load alone
    ratio = turning.values["quasi_static_load_ratio"]
    alike = result(tilt=None, thrust=f"{500.0 * ratio:.6f} kN").values["minimum_film_thickness"]
    assert thin == pytest.approx(alike, rel=5e-3)


def test_two_lobes_load_pads_by_their_height_only():
    """Of waves the share knows the height: with as many lobes as pads all pads stand alike."""
    ratio = result(tilt=None, runout="[{amplitude: 5 um, lobes: 8}]").values["quasi_static_load_ratio"]
    assert ratio == pytest.approx(1.0, abs=1e-9)
    assert result(tilt=None, runout="[{amplitude: 5 um, lobes: 2}]").values["quasi_static_load_ratio"] > 1.1


@pytest.mark.parametrize("kind", ["thrust", "thrust_line"])
def test_there_is_nothing_to_compare_and_the_message_says_what_to_do(kind):
    with pytest.raises(InputError, match=r"nothing to compare.*babbitt sweep") as told:
        compare_methods(parse_case(template(kind)))
    assert told.value.code == "E004"


def test_taper_pads_under_a_tilt_tell_the_films_of_leaning_faces():
    pads = (
        "{number: 8, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, pivot: {kind: fixed}, "
        "face: {kind: taper, depth: 40 um, fraction: 0.7}}"
    )
    found, level = result(pads=pads), result(pads=pads, tilt=None)
    assert found.outcome.solved
    assert np.ptp(found.arrays["pad_slope_radial"][0]) == pytest.approx(2.0 * 30e-6 / 0.375)
    assert not np.any(level.arrays["pad_slope_radial"][0])
    assert found.values["minimum_film_thickness"] < level.values["minimum_film_thickness"]
    assert level.values["collar_moment"] == pytest.approx(0.0, abs=1e-3)
    stuck = result(pads=pads, tilt="{offset: 200 um}", ring_stiffness=None)
    assert stuck.outcome is Outcome.OVERLOADED
    assert "leans with the housing" in stuck.message


def test_runout_that_leaves_no_film_is_told_beside_the_film_at_rest():
    pads = (
        "{number: 8, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, "
        "pivot: {kind: line, radius: 290 mm, fraction: 0.6}}"
    )
    given = {"pads": pads, "thrust": "400 kN", "ring_stiffness": "1e6 GN/m", "tilt": None}
    found, still = result(**given, runout="100 um"), result(**given)
    assert found.outcome.solved
    assert found.values["minimum_film_thickness"] == still.values["minimum_film_thickness"]
    assert "quasi_static_load_ratio" not in found.values
    [notice] = [one for one in found.warnings if one.code == "W209"]
    assert "quasi_static_load_ratio" in notice.message
    assert found.verdict is Verdict.NO_VERDICT  # no film is counted on
    assert "C202" in {one.code for one in found.not_checked}
    slight = result(**given, runout="1 um")
    assert slight.values["quasi_static_load_ratio"] > 1.0
    assert "W209" not in {one.code for one in slight.warnings}


def test_leaning_pads_at_a_given_film_speak_of_the_film():
    pads = (
        "{number: 8, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, pivot: {kind: fixed}, "
        "face: {kind: taper, depth: 40 um, fraction: 0.7}}"
    )
    found = result(pads=pads, thrust=None, film="50 um", tilt="{offset: 60 um}", ring_stiffness=None)
    assert found.outcome is Outcome.OUTSIDE_CLEARANCE
    assert "mean film of 50.0 µm; less tilt" in found.message


def test_the_pressure_on_the_pad_that_carries_most_is_held_against_the_metal():
    """W_max over the area of a pad, C103 by experience and C105 of B83; advice where no metal is named."""
    named = result(materials=METAL, thrust="900 kN")
    pad = 0.5 * math.radians(36.0) * (0.375**2 - 0.190**2)
    checks = {check.code: check for check in named.checks}
    for code, limit in (("C103", 5e6), ("C105", 15e6)):
        assert checks[code].quantity == "largest_specific_load"
        assert checks[code].value == pytest.approx(named.largest_pad_load / pad)
        assert checks[code].limit == limit
        assert not checks[code].advisory
    assert not checks["C103"].ok
    assert not named.within_limits
    advised = {check.code: check for check in result(thrust="900 kN").checks}
    assert advised["C103"].advisory
    assert advised["C105"].advisory
    assert advised["C103"].source.startswith("assumption: B83; assumption: experience values")
    assert advised["C103"].source.endswith("of journal bearings")
    slow = result(materials=METAL, speed="20 rpm", film_limit="1 um")
    assert {check.code: check.limit for check in slow.checks}["C103"] == 15e6


def test_what_the_runout_does_is_said_and_doubted():
    still, turning = result(tilt=None), result(tilt=None, runout="20 um")
    said = answers(turning)[0]
    assert "While the collar turns slowly" not in answers(still)[0]
    ratio, film = turning.quasi_static_load_ratio, 1e6 * turning.quasi_static_minimum_film_thickness
    assert f"a pad carries up to {ratio:.2f} times the mean, on {film:.1f} µm at the thinnest" in said
    assert "the limit of 10.0 µm" in said
    assert not [one for one in turning.warnings if one.code == "W201"]
    tilted = result(tilt="{offset: 30 um}", runout="35 um", ring_stiffness=None)
    [warning] = [one.message for one in tilted.warnings if one.code == "W201"]
    assert "tilt, heights and a runout of 35.0 µm bring a pad up to 58.2 µm nearer" in warning
    even = still.pivot_film_thickness * 1e6
    assert f"the film of {even:.1f} µm that an even share has" in warning


@pytest.mark.thorough
@pytest.mark.parametrize("oil", ["{kind: viscosity, viscosity: 50 mPa s}", f"{BALANCE}}}"])
def test_concave_pads_tell_their_crown_and_the_largest_load_they_carry(oil):
    """The same end at any thrust beyond; at a little less than the load that is told they have a film."""
    said = {overloaded_concave(f"{thrust} kN", oil) for thrust in (400, 500, 2000)}
    [most] = {words.split("at most ")[1].split(" kN")[0] for words in said}
    assert all("concave (crown -5.0 µm)" in words for words in said)
    assert not any("-0" in words for words in said)
    assert solve(parse_case(concave(f"{0.99 * float(most)} kN", oil))).results[0].outcome.solved
    assert "the pads carry at most" in overloaded_concave(f"{1.03 * float(most)} kN", oil)


def test_a_concave_pad_that_a_tilt_overloads_is_told_alike():
    tilted = concave("340 kN", "{kind: viscosity, viscosity: 50 mPa s}") + "\ntilt: {offset: 30 um}\n"
    found = solve(parse_case(tilted)).results[0]
    assert found.outcome is Outcome.OVERLOADED
    assert "a pad carries at most 43.33 kN: the pads are concave (crown -5.0 µm)" in found.message


def concave(thrust, oil):
    return (
        f"babbitt: 1\nkind: thrust\nname: concave\nthrust: {thrust}\nspeed: 120 rpm\noil: {oil}\n"
        "pads: {number: 8, inner_radius: 220 mm, outer_radius: 420 mm, extent: 35 deg, crown: -5 um, "
        "pivot: {kind: point, radius: 325 mm, fraction: 0.6}}\n"
    )


def overloaded_concave(thrust, oil):
    found = solve(parse_case(concave(thrust, oil))).results[0]
    assert found.outcome is Outcome.OVERLOADED
    return found.message


def test_backward_runs_at_a_negative_speed():
    """A crowned pad on a middle pivot runs both ways; the surface speed has no sense."""
    pads = (
        "{number: 8, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, crown: 20 um, "
        "pivot: {kind: point, radius: 287 mm, fraction: 0.5}}"
    )
    ahead, astern = (result(pads=pads, speed=speed, thrust="100 kN") for speed in ("125 rpm", "-125 rpm"))
    assert astern.angular_speed == -ahead.angular_speed < 0.0
    assert astern.surface_speed == ahead.surface_speed > 0.0


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"runout": "5"}, "runout: 5 has no unit; allowed: 0 um to 5 mm; write '5 um'"),
        ({"ring_stiffness": "20"}, "allowed: 1 kN/m to 1e18 N/m; write '20 GN/m'"),
        ({"tilt": "{offset: 30}"}, "write '30 um'"),
        (
            {
                "pads": "{number: eight, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, "
                "pivot: {kind: fixed}}"
            },
            "pads.number: 'eight' is not a quantity; allowed: a whole number from 2 to 100",
        ),
        (
            {
                "pads": "{number: 8, inner_radius: 190 mm, outer_radius: 375 mm, extent: 36 deg, "
                "pivot: {kind: point, radius: 192 mm, fraction: 0.6}}"
            },
            "pads.pivot.radius: with the pivot at 192 mm no tilt balances these plane pads",
        ),
    ],
)
def test_messages_say_what_a_drawing_would_have(changed, said):
    with pytest.raises(InputError) as told:
        result(**changed)
    assert said in str(told.value)
