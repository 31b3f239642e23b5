"""Friction heat that warms no oil: energy balance of the footstep."""

import math
from dataclasses import replace

import pytest
from heels import footstep

from babbitt.kinds.footstep.check import heel_results
from babbitt.kinds.footstep.face import Face
from babbitt.kinds.footstep.heat_residual import heat_residual, leaving_flow, needed_flow
from babbitt.kinds.footstep.model import Wall
from babbitt.kinds.footstep.model_case import FootstepProblem
from babbitt.kinds.footstep.states import Method, steady_states


def test_the_shear_of_a_smooth_heel_warms_nothing():
    """59 W of shear in the clearance would heat the leakage by 696 K; what the face rubs comes on top."""
    step = footstep(groove=None)
    (state,) = steady_states(step)
    heat, rise = heat_residual(step, state, Method.SUPERPOSITION)
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
    heat, rise = heat_residual(step, hot, Method.SUPERPOSITION)
    carried = 1.76e6 * hot.leakage * (hot.rim_temperature - step.oil.temperature)
    assert 0.0 < heat < hot.friction_power
    pressure = (step.supply_pressure - step.ambient_pressure) * hot.face_flow
    assert heat == pytest.approx(hot.friction_power + pressure - carried, rel=1e-9)
    assert 233.0 < rise < 300.0  # the lands alone: 233 K; the face besides


def test_metal_takes_it():
    wall = Wall(298.15, 10.0)
    for groove in ({}, {"groove": None}):
        (state,) = steady_states(footstep(wall=wall, **groove), Method.NARROW_GROOVE)
        heat, rise = heat_residual(footstep(wall=wall, **groove), state, Method.NARROW_GROOVE)
        # The second film takes its oil at the temperature of the inlet: what the first gave it is lost.
        first = state.face_temperature if state.leakage > 0.0 else state.rim_temperature
        assert heat == pytest.approx(1.76e6 * abs(state.leakage) * (first - 298.15), rel=1e-6)
        assert 0.0 < rise < 0.1
        (state,) = steady_states(footstep(**groove), Method.NARROW_GROOVE)
        heat, rise = heat_residual(footstep(**groove), state, Method.NARROW_GROOVE)
        through = (0.63e6 - 0.101e6) * state.face_flow
        assert heat == pytest.approx(state.friction_power + through, rel=1e-9)
        assert rise > 5.0


def test_no_oil_that_leaves_takes_no_heat():
    """The rise is infinite, and is told as one that oil cannot have."""
    step = footstep(groove=None)
    (state,) = steady_states(step, Method.NARROW_GROOVE)
    still = replace(state, leakage=0.0)
    heat, rise = heat_residual(step, still, Method.NARROW_GROOVE)
    assert heat > 0.0
    assert rise == math.inf


@pytest.mark.parametrize(("clearance", "advised"), [(10.0, True), (60.0, False)])
def test_a_rise_that_oil_cannot_have_is_advice(clearance, advised):
    """Flow falls with the cube of the clearance, and friction rises: 100 K lie between. C131 tells either side."""
    (result,) = heel_results(FootstepProblem("Heel", footstep(groove=None, clearance=clearance)))
    (told,) = (notice.message for notice in result.warnings if notice.code == "W171")
    (check,) = (check for check in result.checks if check.code == "C131")
    assert check.advisory
    assert check.ok is not advised
    assert ("W176" in {notice.code for notice in result.warnings}) is advised  # then there is no verdict
    assert check.value == pytest.approx(result.heel_leakage, rel=1e-12)  # all that leaves a smooth heel
    assert "warmed by" in told


@pytest.mark.parametrize("method", Method)
@pytest.mark.parametrize("clearance", [8.0, 10.0, 20.0, 40.0, 60.0])
def test_the_needed_oil_warms_by_the_rise_it_is_told_for(method, clearance):
    """Beside the metal, which takes its conductance times that rise: the check and the rise are one statement."""
    step = footstep(groove=None, clearance=clearance)
    for asked in (step, replace(step, wall=Wall(298.15, 0.05))) if method is Method.NARROW_GROOVE else (step,):
        (state,) = steady_states(asked, method)
        heat, rise = heat_residual(asked, state, method)
        needed = needed_flow(asked, state, method, 100.0)
        metal = 0.0 if asked.wall is None else 0.05
        if needed > 0.0:
            assert heat / (1.76e6 * needed + metal) == pytest.approx(100.0, rel=1e-12)
        assert (leaving_flow(state, method) >= needed) is (rise <= 100.0)


@pytest.mark.parametrize(
    "cooler",
    [
        {"face_gap": 12.0}, {"clearance": 20.0}, {"angular_speed": 120.0},
        {"oil": replace(footstep().oil, viscosity=0.018)}, {"groove": replace(footstep().groove, depth=0.33e-3)},
    ],
)  # fmt: skip
def test_what_the_advice_about_hot_grooves_says_makes_them_cooler(cooler):
    """W161."""
    hot = {"face_gap": 10.0, "clearance": 22.0}
    (result, *_) = heel_results(FootstepProblem("Heel", footstep(**hot)))
    assert "W161" in {notice.code for notice in result.warnings}
    changed = steady_states(footstep(**(hot | cooler)))[0]
    assert changed.maximum_temperature < result.maximum_temperature
    wider = steady_states(footstep(**(hot | {"clearance": 24.0})))[0]
    assert wider.maximum_temperature > result.maximum_temperature


@pytest.mark.parametrize("method", Method)
def test_the_check_of_the_oil_holds_the_quantity_that_it_names(method):
    """The cold state feeds the bore: what leaves is the leakage and what goes back, and has a name of its own."""
    for result in heel_results(FootstepProblem("Heel", footstep(), method)):
        (check,) = (check for check in result.checks if check.code == "C131")
        assert check.value == result.values[check.quantity]
        for notice in result.warnings:
            if notice.code == "W176" and notice.variant == "left_out":
                assert notice.values["leaving"] == check.value
        if method is Method.SUPERPOSITION and result.face_flow < 0.0:
            assert check.value == pytest.approx(result.heel_leakage - result.face_flow, rel=1e-12)
