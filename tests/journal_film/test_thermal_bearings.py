"""Bearings whose film has its own temperatures, from the case to the answer."""

import io
import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from rich.console import Console

from babbitt.case import parse_case
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Outcome
from babbitt.core.solution import Solution
from babbitt.kinds.journal.compare.temperature_cost import cost_of_one_temperature
from babbitt.kinds.journal.film import thermal_film as thermal_film_module
from babbitt.kinds.journal.film import thermal_results as thermal_answer
from babbitt.kinds.journal.film.check import film_check
from babbitt.kinds.journal.film.field import field_of
from babbitt.kinds.journal.film.heat_model import HeatModel, TemperatureCoefficients
from babbitt.kinds.journal.film.temperature_field import (
    bush_temperature,
    centre_line,
    temperature_over,
    temperature_through,
)
from babbitt.kinds.journal.film.thermal_film import following_stiffness, thermal_operating_film
from babbitt.properties.fits import operating_relative_clearance
from babbitt.report.bearing_table import bearing_table
from babbitt.report.coefficient_temperatures import temperature_remark
from babbitt.reynolds.stability.routh import critical_mass
from babbitt.study.comparison import compare_methods

TEXT = """
kind: journal
name: Two grooves
method: film
thermal: full
diameter: 120 mm
width: 60 mm
clearance: {kind: relative, mean: 1.5e-3}
grooves: [{angle: 0 deg, extent: 20 deg}, {angle: 180 deg, extent: 20 deg}]
lubricant: ISO VG 46
supply: {temperature: 45 degC, pressure: 0.1 MPa}
materials: {bearing: EN-GJL-250, journal: C45}
walls:
  bush: {outer_diameter: 150 mm, conductivity: 46 W/(m K)}
  housing: {outer_diameter: 220 mm, heat_transfer_coefficient: 30 W/(m2 K), ambient_temperature: 20 degC}
  journal: {shaft_conductance: 5 W/K, ambient_temperature: 30 degC}
load: 12 kN
speed: 3000 rpm
"""


def design(text=TEXT):
    (found,) = parse_case(text).problems()
    return found


@pytest.fixture(scope="module")
def full():
    case = design()
    return case, film_check(case), thermal_operating_film(case).film


def test_heat_and_oil_are_accounted_for(full):
    _, result, _ = full
    assert result.outcome.solved
    assert result.energy_balance_error < 1e-8
    assert result.mass_balance_error < 1e-10
    taken = result.heat_to_oil + result.heat_film_to_bush + result.heat_film_to_journal
    assert taken == pytest.approx(result.film_dissipation, rel=1e-8)
    assert result.heat_film_to_journal == pytest.approx(5.0 * (result.journal_temperature - 303.15), rel=1e-5)


def test_arrays_are_attributes_and_verdicts_are_plain(full):
    _, result, _ = full
    assert result.groove_fresh_flows == result.arrays["groove_fresh_flows"]
    assert all(type(check.ok) is bool for check in result.checks)
    assert all(type(value) is float for value in result.values.values())
    with pytest.raises(AttributeError, match=r"'no_such' is not among the results: .*groove_fresh_flows"):
        _ = result.no_such


def test_the_hottest_place_is_told(full):
    _, result, state = full
    assert result.supply_temperature < result.outlet_temperature < result.maximum_temperature
    assert result.maximum_bush_temperature <= result.maximum_temperature + 0.5
    towards_exit = result.hot_spot_angle + math.pi / 2.0  # from the load in the sense of rotation
    assert 0.0 < towards_exit < math.pi / 2.0
    mixed = result.arrays["groove_temperatures"][0]
    assert len(mixed) == 2
    assert min(mixed) > result.supply_temperature
    assert max(mixed) == pytest.approx(result.groove_temperature)
    limits = {check.code: check for check in result.checks}
    assert limits["C104"].quantity == "outlet_temperature"
    assert state.thermal.maximum_temperature == pytest.approx(result.maximum_temperature)


def test_clearance_grows_with_bush_and_journal_each_by_its_own_temperature(full):
    case, result, state = full
    bearing = case.bearing
    grown = operating_relative_clearance(
        bearing.relative_clearance, bearing.expansion_bearing, bearing.expansion_journal,
        result.mean_bush_temperature, result.journal_temperature,
    )  # fmt: skip
    assert result.operating_relative_clearance == pytest.approx(grown, rel=2e-5)
    assert state.solution.film.clearance == pytest.approx(0.5 * grown * bearing.diameter, rel=2e-5)


def test_effective_temperature_is_that_of_the_effective_viscosity(full):
    case, result, _ = full
    viscosity = case.lubricant.dynamic_viscosity(result.effective_temperature)
    assert viscosity == pytest.approx(result.effective_viscosity, rel=1e-6)


def test_limits_of_the_metal_hold_for_the_hottest_place_of_the_bush():
    result = film_check(design(TEXT.replace("{bearing: EN", "{bearing_metal: B83, bearing: EN")))
    checked = {check.code: check.quantity for check in result.checks}
    assert checked["C108"] == "maximum_bush_temperature"


def test_reversed_rotation_mirrors_the_bearing(full):
    _, result, _ = full
    mirrored = film_check(design(TEXT.replace("3000 rpm", "-3000 rpm")))
    assert mirrored.maximum_temperature == pytest.approx(result.maximum_temperature, abs=2e-2)  # settled to 5e-2 K
    here, there = result.arrays["groove_temperatures"][0], mirrored.arrays["groove_temperatures"][0]
    assert there == pytest.approx(here[::-1], abs=2e-2)


def test_a_given_eccentricity_finds_its_load_again(full):
    _, result, _ = full
    at = TEXT.replace("load: 12 kN", f"eccentricity_ratio: {result.eccentricity_ratio}")
    found = film_check(design(at))
    assert found.load == pytest.approx(12e3, rel=2e-3)
    assert found.attitude_angle == pytest.approx(result.attitude_angle, abs=5e-3)


def test_temperatures_that_follow_soften_or_stiffen_but_keep_the_sign(full):
    case, result, _ = full
    following = replace(case, heat=replace(case.heat, coefficients=TemperatureCoefficients.FOLLOWING))
    found = film_check(following)
    assert "W147" not in {one.code for one in found.warnings}
    frozen, moving = np.array(result.stiffness), np.array(found.stiffness)
    assert not np.allclose(moving, frozen, rtol=1e-3)
    assert np.abs(moving - frozen).max() < 0.5 * np.abs(frozen).max()
    assert found.stiffness_yy == pytest.approx(moving[1, 1])
    assert any("(following)" in said for said in found.assumptions)
    assert (found.settings["stiffness_temperatures"], found.settings["damping_temperatures"]) == (
        "following",
        "frozen",
    )
    assert result.settings["stiffness_temperatures"] == "frozen"
    assert np.array(found.damping) == pytest.approx(np.array(result.damping), rel=1e-12)
    assert any("(frozen)" in said for said in result.assumptions)
    assert found.frozen_stiffness == result.stiffness
    assert "frozen_stiffness" not in result.arrays
    for kind, one in (("following", found), ("frozen", result)):
        console = Console(width=140, file=io.StringIO())
        console.print(bearing_table(one))
        shown = console.file.getvalue()
        assert f"force in x over move in x, temperatures {kind}" in shown
        assert "force in y over speed in x, temperatures frozen" in shown
        assert "rigid rotor whirls, temperatures frozen" in shown
        assert temperature_remark("stiffness_xx", one) == f", temperatures {kind}"
    assert temperature_remark("load", found) == ""


def test_whirl_leaves_the_temperatures_no_time(full):
    case, result, _ = full
    found = film_check(replace(case, heat=replace(case.heat, coefficients=TemperatureCoefficients.FOLLOWING)))
    for name in ("critical_mass", "whirl_frequency_ratio", "threshold_speed"):
        assert found.values[name] == pytest.approx(result.values[name], rel=1e-12)
    quick, slow = np.array(found.frozen_stiffness), np.array(found.stiffness)
    damping = np.array(found.damping)
    assert found.critical_mass == pytest.approx(critical_mass(quick, damping), rel=1e-12)
    assert abs(critical_mass(slow, damping) / found.critical_mass - 1.0) > 0.02  # so that it matters
    limit, other = ({one.code: one for one in them.checks}["C115"] for them in (found, result))
    assert limit.value == pytest.approx(other.value, rel=1e-12)
    assert found.settings["stability_temperatures"] == "frozen"


def test_a_following_stiffness_that_was_not_found_is_not_named(full, monkeypatch):
    case, result, _ = full
    monkeypatch.setattr(thermal_answer, "following_stiffness", lambda *_: None)
    found = film_check(replace(case, heat=replace(case.heat, coefficients=TemperatureCoefficients.FOLLOWING)))
    assert "W147" in {one.code for one in found.warnings}
    assert found.settings["stiffness_temperatures"] == "frozen"
    assert found.stiffness == result.stiffness


def test_stiffness_while_temperatures_follow_does_not_depend_on_the_push(full, monkeypatch):
    case, _, state = full
    usual = following_stiffness(case, state)
    monkeypatch.setattr(thermal_film_module, "PUSH", 0.5 * thermal_film_module.PUSH)
    assert following_stiffness(case, state) == pytest.approx(usual, abs=0.01 * np.abs(usual).max())


def test_what_is_not_given_is_assumed_and_told():
    walls = TEXT[TEXT.index("walls:") : TEXT.index("load:")]
    result = film_check(design(TEXT.replace(walls, "")))
    said = " ".join(result.assumptions)
    told = ("Outside diameter of the bush 150 mm", "still air", "Perfect thermal contact", "along the shaft")
    for words in told:
        assert words in said
    assert "Outside diameter" not in " ".join(film_check(design()).assumptions)


def test_a_film_hotter_than_oil_can_be_is_a_runaway():
    thin = TEXT.replace("speed: 3000 rpm", "speed: 60 rpm").replace("12 kN", "80 kN").replace("full", "adiabatic")
    thin = thin.replace(thin[thin.index("walls:") : thin.index("load:")], "")
    found = film_check(design(thin))
    assert found.outcome is Outcome.THERMAL_RUNAWAY
    assert "under 80.00 kN would be hotter than 300.0 °C somewhere" in found.message
    assert "The largest load with a film was about" in found.message
    assert "Try: `thermal: full`" in found.message
    # the values are those of that last film: nearly as hot as oil can be, under less than the load
    assert found.load < 80e3
    assert found.maximum_temperature < 573.15
    again = film_check(design(thin.replace("80 kN", f"{found.load} N")))
    assert again.outcome.solved
    assert again.maximum_temperature == pytest.approx(found.maximum_temperature, abs=25.0)  # its clearance grows


@pytest.mark.parametrize(("load", "speed"), [("5000 kN", "1000 rpm"), ("120 kN", "8 rpm")])
def test_a_load_above_capacity_tells_the_largest_load_with_a_film(load, speed):
    bare = TEXT.replace(TEXT[TEXT.index("walls:") : TEXT.index("load:")], "")
    found = film_check(design(bare.replace("12 kN", load).replace("3000 rpm", speed)))
    assert found.outcome is Outcome.OVERLOADED
    assert "its thinnest place closes" in found.message
    assert "less load" in found.message
    assert 0.2 * float(load.split()[0]) < found.load / 1e3 < float(load.split()[0])
    assert found.checks == ()


def test_nothing_is_printed_of_the_round_off_of_a_balance():
    for name in ("heat_film_to_journal", "heat_to_oil", "friction_power"):
        assert QUANTITIES[name].format(-3e-7) == "0"
        assert QUANTITIES[name].format(0.02) != "0"


def test_the_temperature_of_the_bush_meets_the_film_and_falls_outwards(full):
    case, _, state = full
    bush = case.heat.walls.bush
    theta = np.linspace(0.0, 2.0 * math.pi, 721)[:-1]
    radii = np.array([bush.radii[0], *bush.radii[1:]])
    found = bush_temperature(bush, state.thermal, theta, radii)
    assert found[:, 0].mean() == pytest.approx(state.thermal.mean_bush_temperature, abs=0.05)
    assert np.ptp(found[:, -1]) < np.ptp(found[:, 0])
    # what leaves the outside by convection is what the film gives to the bush
    outside = 2.0 * math.pi * bush.radii[-1] * case.bearing.width * bush.heat_transfer_coefficient
    lost = outside * (found[:, -1].mean() - bush.ambient_temperature)
    assert lost == pytest.approx(state.thermal.heat.bush, rel=1e-3)


def test_fields_carry_the_temperature(full):
    case, result, state = full
    field = field_of(state.thermal.film, case.load_angle - math.pi)
    over = temperature_over(state.thermal, field)
    assert over.shape == field.pressure.shape
    assert over.max() < result.maximum_temperature
    line = centre_line(state.thermal, field)
    assert line.highest.max() == pytest.approx(result.maximum_temperature, abs=1e-6)
    xarray = pytest.importorskip("xarray")
    from babbitt.report.fields import fields

    data = fields(Solution(case, result, state))
    assert isinstance(data, xarray.Dataset)
    assert data["temperature"].dims == ("theta", "z")
    assert float(data["temperature_through"].max()) == pytest.approx(result.maximum_temperature, abs=1e-6)


def test_insulated_walls_are_as_warm_as_the_oil_that_touches_them():
    text = re.sub(r"walls:.*?(?=load:)", "", TEXT.replace("thermal: full", "thermal: adiabatic"), flags=re.DOTALL)
    thermal = thermal_operating_film(design(text)).film.thermal
    through = temperature_through(thermal, np.linspace(0.0, 2.0 * math.pi, 91))
    assert through[:, 0] == pytest.approx(through[:, 1])
    assert through[:, -1] == pytest.approx(through[:, -2])
    assert np.ptp(through[:, -1]) > 1.0  # the journal has no temperature of its own


def test_comparison_tells_what_one_temperature_costs():
    (found,) = compare_methods(parse_case(TEXT))
    results = {one.label: one.result for one in found.variants}
    assert found.variants[0].label == "full thermal film"
    assert (
        results["film at 45 °C"].minimum_film_thickness > results["film, one temperature"].minimum_film_thickness
    )
    (said,) = cost_of_one_temperature(found)
    assert said.startswith("Against the film of one temperature the full thermal film is")
    thin, plain = (results[one].minimum_film_thickness for one in ("full thermal film", "film, one temperature"))
    assert f"{abs(thin / plain - 1.0):.0%} thinner" in said


def test_a_poor_contact_of_the_bush_warms_it():
    found = [
        film_check(design(TEXT.replace("housing: {", f"housing: {{contact_coefficient: {one} W/(m2 K), ")))
        for one in (1e7, 2000, 50)
    ]
    perfect, loose, hardly = (one.mean_bush_temperature for one in found)
    assert perfect == pytest.approx(film_check(design()).mean_bush_temperature, abs=0.02)
    assert perfect < loose < hardly
    taken = [one.heat_film_to_bush for one in found]
    assert taken[0] > taken[1] > taken[2] > 0.0


def test_a_prescribed_journal_temperature_takes_the_heat_that_it_must():
    given = TEXT.replace("{shaft_conductance: 5 W/K, ambient_temperature: 30 degC}", "{temperature: 50 degC}")
    found = film_check(design(given))
    assert found.journal_temperature == pytest.approx(323.15)
    assert found.heat_film_to_journal > film_check(design()).heat_film_to_journal
    walls = found.heat_film_to_bush + found.heat_film_to_journal
    assert found.film_dissipation == pytest.approx(found.heat_to_oil + walls, rel=1e-8)


def test_adiabatic_walls_take_nothing():
    adiabatic = film_check(replace(design(), heat=HeatModel()))
    assert not [name for name in adiabatic.values if "bush" in name]
    assert adiabatic.mean_wall_temperature < adiabatic.maximum_wall_temperature <= adiabatic.maximum_temperature
    assert adiabatic.heat_to_oil == pytest.approx(adiabatic.film_dissipation, rel=1e-8)


TURBINE = (Path(__file__).parents[2] / "examples" / "turbulent_turbine_heat.yaml").read_text(encoding="utf-8")


@pytest.mark.parametrize("walls", ["adiabatic", "full"])
@pytest.mark.parametrize("law", ["ng_pan", "constantinescu"])
def test_turbulence_makes_more_heat_and_a_thicker_film(walls, law):
    text = TURBINE if walls == "full" else "\n".join(
        line for line in TURBINE.replace("thermal: full", "thermal: adiabatic").splitlines()
        if not line.lstrip().startswith(("walls:", "bush:", "housing:"))
    )  # fmt: skip
    laminar = film_check(design(text.replace("turbulence: ng_pan", "turbulence: laminar")))
    turbulent = film_check(design(text.replace("turbulence: ng_pan", f"turbulence: {law}")))
    assert "W101" in {one.code for one in laminar.warnings}
    assert "W101" not in {one.code for one in turbulent.warnings}
    assert turbulent.outcome.solved
    assert turbulent.energy_balance_error < 1e-8
    assert turbulent.mass_balance_error < 1e-8
    assert turbulent.friction_power > 1.4 * laminar.friction_power
    assert turbulent.outlet_temperature > laminar.outlet_temperature + 3.0
    oil = design(text).lubricant
    assert turbulent.effective_viscosity == pytest.approx(oil.dynamic_viscosity(turbulent.effective_temperature))
    assert turbulent.supply_temperature < turbulent.effective_temperature < turbulent.maximum_temperature
    assert turbulent.minimum_film_thickness > 1.1 * laminar.minimum_film_thickness
    assert 0.5 < turbulent.turbulent_share < 0.9
    assert any(law.split("_")[0] in said.lower() for said in turbulent.assumptions)


def test_a_slow_film_is_laminar_whatever_is_asked(full):
    _, laminar, _ = full
    asked = film_check(design(TEXT + "turbulence: ng_pan\n"))
    assert asked.turbulent_share == 0.0
    # the clearance of a turbulent film settles from film to film, that of a laminar one beside it, to 1e-5 of it
    assert asked.minimum_film_thickness == pytest.approx(laminar.minimum_film_thickness, rel=4e-5)
    assert asked.maximum_temperature == pytest.approx(laminar.maximum_temperature, abs=1e-2)


def test_every_supply_is_told_in_the_table(full):
    _, result, _ = full
    fresh, back, mixed = (
        result.arrays[f"groove_{one}"][0] for one in ("fresh_flows", "returned_flows", "temperatures")
    )
    assert sum(fresh) - sum(back) == pytest.approx(result.total_flow, rel=1e-9)
    carried = result.volumetric_heat_capacity * result.total_flow
    carried *= result.outlet_temperature - result.supply_temperature
    assert carried + result.values.get("heat_returned", 0.0) == pytest.approx(result.heat_to_oil, rel=1e-8)
    console = Console(width=140, file=io.StringIO())
    console.print(bearing_table(result))
    said = console.file.getvalue()
    lines = [line.split() for line in said.splitlines() if len(line.split()) == 5 and line.split()[0] in "12"]
    assert [line[1] for line in lines] == ["0", "180.0"]
    assert [float(line[4]) for line in lines] == pytest.approx([one - 273.15 for one in mixed], abs=0.051)
    assert [float(line[2]) for line in lines] == pytest.approx([6e4 * one for one in fresh], abs=0.051)


def test_oil_that_goes_back_is_told_with_its_own_heat():
    text = TEXT.replace("load: 12 kN", "load: 12 kN\ncarry_over: 60 %")
    result = film_check(design(text))
    (told,) = [one.values for one in result.warnings if one.code == "W148"]
    assert told["flow"] == pytest.approx(sum(result.groove_returned_flows[0]), rel=1e-9)
    assert told["share"] == pytest.approx(result.heat_returned / result.heat_to_oil, rel=1e-9)
    capacity = result.volumetric_heat_capacity * result.returned_flow
    assert told["mean"] == pytest.approx(result.supply_temperature + result.heat_returned / capacity, abs=0.01)


def test_carry_over_lies_between_fresh_oil_and_all_the_hot_oil(full):
    _, all_of_it, _ = full
    shares = {share: film_check(design(f"{TEXT}carry_over: {share}\n")) for share in (0.0, 0.5, 1.0)}
    assert shares[1.0].maximum_temperature == pytest.approx(all_of_it.maximum_temperature, abs=1e-9)
    fresh = shares[0.0].arrays["groove_temperatures"][0]
    assert fresh == pytest.approx([318.15, 318.15], abs=1e-9)  # every film starts with the oil of the supply
    rising = [result.maximum_temperature for result in shares.values()]
    assert rising[0] < rising[1] - 1.0 < rising[2] - 2.0
    thinning = [result.minimum_film_thickness for result in shares.values()]
    assert thinning == sorted(thinning, reverse=True)
    assert all(result.energy_balance_error < 1e-8 for result in shares.values())
    assert any("50% of it goes on" in said for said in shares[0.5].assumptions)
