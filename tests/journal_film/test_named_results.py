"""Results with names: inflow, what sides draw in, friction without streamers, stability at any mass."""

import math

import numpy as np
import pytest
from film_bearings import answer

from babbitt.case import parse_case
from babbitt.core.notices import Effect
from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.model import JournalFilm, Resolution, grooved_bore
from babbitt.solving import solve

CASE = """
kind: journal
name: bearing
method: film
diameter: 100 mm
width: 70 mm
span: 360 deg
clearance: {{kind: relative, mean: 1.5 permille}}
lubricant: {{kind: constant, dynamic_viscosity: 20 mPa s, density: 870 kg/m3}}
supply: {{temperature: 40 degC, pressure: 50 kPa}}
materials: {{bearing: C10, journal: C10}}
load: {load} kN
speed: 1500 rpm
accuracy: draft
{more}
"""


def solved(load=10, more=""):
    (result,) = solve(parse_case(CASE.format(load=load, more=more))).results
    assert result.outcome.solved, result.message
    return result


@pytest.fixture(scope="module")
def one_temperature():
    return solved()


def test_streamers_are_sheared_by_their_liquid_fraction():
    """What the friction torque has besides the full film is the Couette shear of the oil behind the rupture."""
    lands = grooved_bore((0.5 * math.pi,), 0.0)
    film = JournalFilm(
        diameter=0.1, width=0.07, clearance=75e-6, viscosity=0.02, angular_speed=157.08, lands=lands
    )
    found = film_at_position(film, (20e-6, -45e-6), resolution=Resolution(axial_unknowns=6, intervals=240))
    angles, void = found.angles[0], found.void[0]
    x, y = found.position
    gap = film.clearance - x * np.cos(angles) - y * np.sin(angles)
    shear = film.viscosity * film.angular_speed * (0.5 * film.diameter) ** 3 / gap[:, None] * (1.0 - void)
    around = np.trapezoid(np.where(void > 0.0, shear, 0.0), np.abs(angles - angles[0]), axis=0)
    expected = 2.0 * np.trapezoid(around, found.axial_positions)
    assert found.streamer_torque == pytest.approx(expected, rel=0.04)
    assert 0.0 < found.streamer_torque < found.friction_torque


def test_flows_over_the_boundaries_of_the_film_balance(one_temperature):
    result = one_temperature
    assert result.inlet_flow > result.total_flow > 0.0  # some of what enters comes around again
    assert result.side_inflow == pytest.approx(0.0, abs=1e-12)
    assert result.friction_torque_without_streamers < result.friction_torque


def test_every_engine_says_the_same(one_temperature):
    """The engine for uneven films and that with its own temperatures, with an oil of one viscosity."""
    uneven = solved(more="misalignment: {x: 0.000001 rad}")
    heated = solved(more="thermal: adiabatic")
    for other in (uneven, heated):
        share = other.friction_torque_without_streamers / other.friction_torque
        own = one_temperature.friction_torque_without_streamers / one_temperature.friction_torque
        assert share == pytest.approx(own, abs=0.02)
        assert other.inlet_flow == pytest.approx(one_temperature.inlet_flow, rel=0.03)


def test_sides_under_pressure_draw_oil_in():
    result = solved(more="side_pressures: [20 kPa, 20 kPa]")
    assert result.side_inflow > 0.0


def test_a_film_without_rupture_has_no_streamers():
    result = solved(load=0.5, more="cavitation_pressure: -1 MPa")
    assert result.friction_torque_without_streamers == pytest.approx(result.friction_torque, rel=1e-12)


def test_stable_at_any_mass_where_there_is_no_critical_mass(one_temperature):
    assert one_temperature.stable_at_any_mass == 0.0
    assert one_temperature.critical_mass > 0.0
    heavy = solved(load=200)
    assert heavy.stable_at_any_mass == 1.0
    assert heavy.whirl_frequency_ratio == 0.0
    assert "critical_mass" not in heavy.values


def test_coefficients_of_tilt_beside_closed_pockets_are_missing_with_a_reason():
    pockets = [{"angle": "0 deg", "extent": "20 deg"}, {"angle": "180 deg", "extent": "20 deg"},
               {"angle": "270 deg", "extent": "20 deg", "width": "40 mm", "flow": "0 L/min"}]  # fmt: skip
    found = answer(
        grooves=pockets[:2], pockets=pockets[2:], tilt_coefficients=True, effective_temperature="60 degC"
    )
    assert "tilt_stiffness_xx" not in found.values
    for name in ("tilt_stiffness", "tilt_damping", "film_moment_x", "film_moment_y"):
        assert "closed pockets" in found.missing[name]
    (told,) = (one for one in found.warnings if one.code == "W197")
    assert told.effect is Effect.INFORMATION
