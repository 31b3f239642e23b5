"""Which steady states of a footstep last: rule against transient, draining grooves, films of two temperatures."""

import math
from dataclasses import replace

import numpy as np
import pytest
from heel_transient import HeelInTime
from heels import GROOVE, OIL, footstep

from babbitt.kinds.footstep.draining import cold_groove_drains
from babbitt.kinds.footstep.face import number
from babbitt.kinds.footstep.model import FootstepOptions, Wall
from babbitt.kinds.footstep.stability import RimDisturbance, stability_of_films
from babbitt.kinds.footstep.states import (
    Method,
    NoSteadyStateError,
    StateName,
    draining_states,
    roots_of_balance,
    steady_states,
)
from babbitt.kinds.footstep.superposition import GroovedFootstep
from babbitt.kinds.footstep.thermal_films import ThermalFilms

PLACES = ((20.0, 20.0), (40.0, 15.0), (20.0, 10.6))
"""Face gap and clearance, um, of the march in time."""


@pytest.mark.parametrize("place", PLACES)
def test_the_hot_state_is_left_and_the_cold_one_returns(place):
    """Kicked by 2 % in temperature, marched for a minute: heat carried along the groove, pressures in balance."""
    step = footstep(*place)
    hot, cold = steady_states(step)
    (draining,) = draining_states(step)
    assert (hot.stable, cold.stable, draining.stable) == (False, True, True)
    for kick in (-0.02, 0.02):
        heel = HeelInTime.at(step, cold, kick)
        heel.march(30.0)
        assert heel.flow == pytest.approx(cold.groove_flow, rel=1e-6)
    cooler = HeelInTime.at(step, hot, -0.02)
    cooler.march(60.0)
    assert cooler.flow == pytest.approx(cold.groove_flow, rel=1e-6)
    warmer = HeelInTime.at(step, hot, 0.02)
    assert warmer.march(60.0, until=lambda heel: heel.flow < 0.0) < 10.0
    warmer.march(60.0)
    assert warmer.flow == pytest.approx(draining.groove_flow, rel=1e-3)
    assert warmer.rim_pressure == pytest.approx(draining.rim_pressure, rel=1e-4)


def test_the_growth_rate_is_that_of_the_transient():
    step = footstep()
    model, hot = GroovedFootstep(step), steady_states(step)[0]
    rate = RimDisturbance(model, model.balance(number(hot.groove_flow))).growth_rate()
    heel = HeelInTime.at(step, hot, -1e-7, nodes=600)  # what grows is carried a fortieth of the groove meanwhile
    heel.largest_step = 4e-3
    heel.march(2.0)  # what decays has gone
    first = heel.flow / hot.groove_flow - 1.0
    heel.march(1.0)
    grown = math.log((heel.flow / hot.groove_flow - 1.0) / first)
    assert grown == pytest.approx(rate, rel=0.01)


@pytest.mark.parametrize("options", [{}, {"entry_loss": 1.0}])
@pytest.mark.parametrize("place", PLACES)
def test_slow_disturbances_see_the_slope_of_the_balance(place, options):
    """F(0) is dR/dQ_k; the slow root is zero exactly where it is."""
    model = GroovedFootstep(footstep(*place, options=FootstepOptions(**options)))
    for flow in (*roots_of_balance(model), *(0.3 * model.channel.largest_flow * np.array([0.01, 0.1, 1.0]))):
        settled = RimDisturbance(model, model.balance(number(flow))).balance(np.array([0j]))[0]
        more, less = (float(model.residual(number(flow * (1.0 + sign * 1e-6)))) for sign in (1.0, -1.0))
        assert settled.real == pytest.approx((more - less) / (2e-6 * flow), rel=1e-5)
        assert settled.imag == 0.0


def test_frozen_temperatures_always_bring_the_rim_back():
    """Pressures settle: with temperatures as they are more groove flow leaves less for the clearance."""
    model = GroovedFootstep(footstep())
    for flow in model.channel.largest_flow * np.geomspace(1e-5, 0.99, 20):
        assert RimDisturbance(model, model.balance(number(flow))).balance(np.array([np.inf + 0j]))[0].real < -1.0


def test_viscosity_that_does_not_change_feeds_nothing_back():
    for speed in (400.0, 1450.0):
        (state,) = steady_states(footstep(oil=replace(OIL, exponent=0.0), angular_speed=speed * math.pi / 30.0))
        assert state.stable
        assert state.loop_gain == 0.0


def test_a_weak_groove_of_cold_oil_is_the_closed_form():
    """p1 - p_a = (Q_k,max + G_h (p2 - p_a))/(G_l + G_k + G_h), with a groove flow of either sign."""
    found = []
    for rpm in (200.0, 400.0, 500.0, 700.0, 1450.0):
        step = footstep(oil=replace(OIL, exponent=0.0), angular_speed=rpm * math.pi / 30.0)
        (state,) = steady_states(step)
        channel, mu, part = GroovedFootstep(step).channel, OIL.viscosity, step.geometry
        leak = math.pi * part.radius * step.clearance**3 / (6.0 * mu * part.length)
        groove = channel.width * GROOVE.depth**3 / (12.0 * mu * channel.length)
        face = math.pi / (6.0 * mu * step.kappa)
        rise = (channel.largest_flow + face * 0.529e6) / (leak + groove + face)
        assert state.rim_pressure - 0.101e6 == pytest.approx(rise, rel=1e-9)
        assert (state.groove_flow < 0.0) == cold_groove_drains(step) == (state.name is StateName.DRAINING)
        assert state.groove_flow + state.face_flow == pytest.approx(state.leakage, rel=1e-9)
        found.append(state.name)
    assert found.count(StateName.DRAINING) == 3


def test_a_weak_groove_hardly_heats():
    """A small exponent joins the constant viscosity, draining too."""
    slow = {"angular_speed": 400.0 * math.pi / 30.0}
    (cold,) = steady_states(footstep(oil=replace(OIL, exponent=0.0), **slow))
    (almost,) = steady_states(footstep(oil=replace(OIL, exponent=1e-9), **slow))
    assert almost.rim_pressure == pytest.approx(cold.rim_pressure, rel=1e-6)
    assert almost.groove_temperature == pytest.approx(cold.groove_temperature, rel=1e-6)


def test_heat_of_a_draining_groove_is_what_it_dissipates():
    """rho_c |q| dtheta/ds = mu M3/(12 h_k³), integrated from the rim by small steps."""
    step = footstep(angular_speed=400.0 * math.pi / 30.0)
    (state,) = steady_states(step)
    channel = GroovedFootstep(step).channel
    q = state.groove_flow / channel.width
    n = 6.0 * (channel.speed * channel.depth - 2.0 * q)
    m3 = n * n + 12.0 * (channel.depth * channel.speed) ** 2
    warm, pressure, steps = state.rim_temperature, state.rim_pressure, 20000
    for _ in range(steps):
        length = channel.length / steps
        pressure -= OIL.at(warm) * n / channel.depth**3 * length
        warm += OIL.at(warm) * m3 / (12.0 * channel.depth**3) * length / (OIL.heat_capacity * abs(q))
    assert warm == pytest.approx(state.groove_temperature, abs=1e-3)
    assert pressure == pytest.approx(step.ambient_pressure, rel=1e-3)


def test_single_states_of_films_are_stable():
    """Random footsteps with metal: where there is one state there is nowhere to run to."""
    rng = np.random.default_rng(7)
    alone, flags = 0, []
    for _ in range(60):
        step = footstep(
            10.0 ** rng.uniform(0.7, 1.8), 10.0 ** rng.uniform(0.7, 1.7),
            wall=Wall(298.15, 10.0 ** rng.uniform(-2.0, 1.5)),
            groove=None if rng.random() < 0.2 else GROOVE,
            angular_speed=math.pi / 30.0 * 10.0 ** rng.uniform(2.3, 3.6),
            supply_pressure=10.0 ** rng.uniform(5.5, 6.8),
        )  # fmt: skip
        states = steady_states(step, Method.NARROW_GROOVE)
        flags += [state.stable for state in states]
        if len(states) == 1:
            alone += 1
            assert states[0].stable
        else:  # stable and not stable in turn
            assert [state.stable for state in states][:2] == [True, False]
    assert alone > 40


def test_films_return_where_their_rule_says_so():
    """Two temperatures marched in time with the oil of the films as store, against the flag."""
    checked = []
    for conductance, clearance, gap in ((10.0, 20.0, 20.0), (0.02, 12.0, 20.0), (0.005, 20.0, 20.0)):
        step = footstep(gap, clearance, wall=Wall(298.15, conductance))
        model = ThermalFilms(step)
        for state in steady_states(step, Method.NARROW_GROOVE):
            flow = -state.leakage
            drain, heating = model.film_slopes(flow, np.array([state.rim_temperature, state.face_temperature]))
            matrix = np.diag(heating[:, 1]) - np.outer(heating[:, 0], drain[1:] / drain[0])
            # One store for both films is enough for the sign of the determinant.
            assert (np.linalg.det(matrix) > 0.0) == (state.loop_gain < 1.0)
            assert stability_of_films(model, flow).stable == state.stable
            less, more = (float(model.residual(number(flow + sign * 1e-12))) for sign in (-1.0, 1.0))
            assert (more < less) == (state.loop_gain < 1.0)  # R falls with the flow
            checked.append(state.stable)
    assert len(checked) >= 3


def test_no_state_where_heat_robs_the_groove():
    step = footstep(12.0, 10.0)
    assert not cold_groove_drains(step)
    with pytest.raises(NoSteadyStateError):
        steady_states(step)
    (draining,) = draining_states(step)
    assert draining.rim_pressure == pytest.approx(0.45087e6, rel=1e-4)
    assert draining.groove_temperature > 360.0
    assert draining.stable


def test_one_reduced_speed_in_every_friction_term():
    """The friction of a smooth heel goes with the square of the reduced speed, all of it."""
    plain = footstep(groove=None)
    reduced = footstep(groove=None, options=FootstepOptions(speed_reduction=0.25))
    slower = footstep(groove=None, angular_speed=plain.angular_speed / 1.25)
    (one,), (two,), (three,) = (steady_states(step) for step in (plain, reduced, slower))
    assert two.friction_power == pytest.approx(one.friction_power / 1.25**2, rel=1e-12)
    assert two.friction_power == pytest.approx(three.friction_power, rel=1e-12)
