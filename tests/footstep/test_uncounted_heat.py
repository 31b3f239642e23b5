"""Friction heat that warms no oil: energy balance of the footstep."""

import pytest
from heels import footstep

from babbitt.footstep.face import Face
from babbitt.footstep.model import Wall
from babbitt.footstep.states import Method, steady_states
from babbitt.footstep.uncounted_heat import uncounted_heat


def test_the_shear_of_a_smooth_heel_warms_nothing():
    """59 W of shear in the clearance would heat the leakage by 696 K; what the face rubs comes on top."""
    step = footstep(groove=None)
    (state,) = steady_states(step)
    heat, rise = uncounted_heat(step, state, Method.SUPERPOSITION)
    inlet, outlet = step.oil.temperature, state.face_temperature
    face = Face(step).shear_power(step.oil.at(0.5 * (inlet + outlet)), step.angular_speed)
    clearance = state.friction_power - face
    assert clearance == pytest.approx(59.0, abs=0.5)
    assert clearance / (1.76e6 * state.leakage) == pytest.approx(696.0, abs=1.0)
    # the face gap warms the oil by its own loss of pressure, the clearance by nothing: that part is missing too
    lost = (state.rim_pressure - step.ambient_pressure) * state.leakage
    assert heat == pytest.approx(state.friction_power + lost, rel=1e-4)
    assert rise == pytest.approx(heat / (1.76e6 * state.leakage), rel=1e-12)


def test_the_groove_counts_its_own_heat():
    step = footstep()
    hot = steady_states(step)[0]
    heat, rise = uncounted_heat(step, hot, Method.SUPERPOSITION)
    carried = 1.76e6 * hot.leakage * (hot.rim_temperature - step.oil.temperature)
    assert 0.0 < heat < hot.friction_power
    pressure = (step.supply_pressure - step.ambient_pressure) * hot.face_flow
    assert heat == pytest.approx(hot.friction_power + pressure - carried, rel=1e-9)
    assert 233.0 < rise < 300.0  # the lands alone: 233 K; the face besides


def test_metal_takes_it():
    wall = Wall(298.15, 10.0)
    for groove in ({}, {"groove": None}):
        (state,) = steady_states(footstep(wall=wall, **groove), Method.NARROW_GROOVE)
        assert uncounted_heat(footstep(wall=wall, **groove), state, Method.NARROW_GROOVE) == (0.0, 0.0)
        (state,) = steady_states(footstep(**groove), Method.NARROW_GROOVE)
        heat, rise = uncounted_heat(footstep(**groove), state, Method.NARROW_GROOVE)
        through = (0.63e6 - 0.101e6) * state.face_flow
        assert heat == pytest.approx(state.friction_power + through, rel=1e-9)
        assert rise > 5.0
