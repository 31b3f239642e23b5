"""Heat balance of hydrostatic bearings: the oil as warm as its film, or a status."""

import math

import pytest

from babbitt.case import parse_case
from babbitt.core.result import Outcome
from babbitt.kinds.hydrostatic.heat_balance import heated
from babbitt.properties.lubricants import lubricant
from babbitt.report.content import content
from babbitt.solving import solve

SPINDLE = """
kind: hydrostatic_journal
name: Spindle
method: quick
diameter: 100 mm
width: 100 mm
radial_clearance: 25 um
recesses: {{number: 4, extent: 60 deg, first: -90 deg}}
recess_length: 70 mm
recess_oil: {{depth: 1 mm}}
restrictor: {{kind: capillary, diameter: 0.8 mm, length: 100 mm}}
supply: {{pressure: 5 MPa}}
oil: {{lubricant: {oil}, supply_temperature: 40 degC}}
load: 5 kN
load_angle: -90 deg
speed: {speed} rpm
"""


def solved(speed, oil="ISO VG 46"):
    (result,) = solve(parse_case(SPINDLE.format(speed=speed, oil=oil))).results
    return result


@pytest.mark.parametrize("speed", [0, 1500, 5000, 15000, 30000])
@pytest.mark.parametrize("oil", ["ISO VG 10", "ISO VG 46", "ISO VG 460"])
def test_oil_is_as_warm_as_its_heat_makes_it(speed, oil):
    """The temperature solves the heat balance, or ends in a status: the thickest oil reached 552 and 2081 degC."""
    result = solved(speed, oil)
    if result.outcome is not Outcome.CONVERGED:
        assert result.outcome in (Outcome.STARVED_RECESS, Outcome.THERMAL_RUNAWAY)
        return
    assert abs(result.energy_balance_error) < 1e-4
    design = parse_case(SPINDLE.format(speed=speed, oil=oil)).design()
    at_temperature = design.oil.at(result.effective_temperature)
    assert result.effective_viscosity == pytest.approx(at_temperature.viscosity, rel=1e-9)
    # the flow is as large as the capillaries let through, and carries friction and both pressure drops away
    state = heated(design)
    oil_there, network = state.case.oil, state.found.network
    carried = oil_there.density * oil_there.heat_capacity * float(network.flows.sum())
    heat = 5e6 * float(network.flows.sum()) + result.friction_power
    assert result.outlet_temperature == pytest.approx(result.effective_temperature, abs=2e-6)
    assert carried * (result.effective_temperature - 313.15) == pytest.approx(heat, rel=1e-4)


def test_runaway_ends_in_a_status():
    """The oil was held at 300 degC, and the film, 427 K warmer than its supply, was called converged."""
    result = solved(60000)
    assert result.outcome is Outcome.THERMAL_RUNAWAY
    assert "300.0 °C" in result.message
    assert "temperature_rise" not in result.values


@pytest.mark.parametrize("given", ["supply_temperature: -30 degC", "supply_temperature: 200 degC",
                                   "supply_temperature: 40 degC, film_temperature: 200 degC"])  # fmt: skip
def test_oil_outside_its_data_has_no_verdict(given):
    text = SPINDLE.format(speed=100, oil="ISO VG 46").replace("supply_temperature: 40 degC", given)
    (result,) = solve(parse_case(text)).results
    assert "W326" in {notice.code for notice in result.warnings}
    assert not result.within_limits
    (usual,) = solve(parse_case(SPINDLE.format(speed=100, oil="ISO VG 46"))).results
    assert "W326" not in {notice.code for notice in usual.warnings}


def test_given_viscosity_has_no_heat_balance():
    text = SPINDLE.format(speed=1500, oil="ISO VG 46")
    plain = text.replace(
        "{lubricant: ISO VG 46, supply_temperature: 40 degC}",
        "{viscosity: 20 mPa s, density: 870 kg/m3, heat_capacity: 2000 J/(kg K)}",
    )
    (result,) = solve(parse_case(plain)).results
    assert result.outcome.solved
    assert "energy_balance_error" not in result.values
    assert heated(parse_case(plain).design()).temperature is None
    assert math.isfinite(result.temperature_rise)


def test_a_given_film_temperature_is_told_with_its_oil():
    """Its viscosity is that of the oil at it; report and result named neither oil nor temperature."""
    text = SPINDLE.format(speed=1500, oil="ISO VG 46")
    text = text.replace("supply_temperature: 40 degC", "supply_temperature: 43 degC, film_temperature: 47 degC")
    solutions = solve(parse_case(text))
    (result,) = solutions.results
    expected = lubricant("ISO VG 46").dynamic_viscosity(320.15)
    assert result.effective_viscosity == pytest.approx(float(expected), rel=1e-12)
    assert result.effective_temperature == pytest.approx(320.15, abs=1e-9)
    assert result.settings["lubricant"] == "ISO VG 46"
    assert "energy_balance_error" not in result.values  # nothing was balanced
    (chapter,) = content(solutions)["bearings"]
    said = {row["label"]: row["value"] for group in chapter["inputs"] for row in group["rows"]}
    assert said["Lubricant"] == "ISO VG 46"
    assert said["Temperature of the film, given"] == "47"
