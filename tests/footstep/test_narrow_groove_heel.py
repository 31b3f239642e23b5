"""Narrow-groove theory of the heel: limits, positive heat, eccentric heels; films that heat the metal."""

import math
from dataclasses import replace

import numpy as np
import pytest
from heels import GROOVE, OIL, footstep
from hypothesis import given
from hypothesis import strategies as st

from babbitt.core.notices import InputError
from babbitt.kinds.footstep.model import BackflowViscosity, FaceOutlet, FootstepOptions, FrictionViscosity, Wall
from babbitt.kinds.footstep.narrow_groove import NarrowGrooveAnnulus
from babbitt.kinds.footstep.states import Method, StateName, steady_states
from babbitt.kinds.footstep.thermal_films import ThermalFilms


def test_without_depth_the_groove_is_a_plain_clearance():
    shallow = NarrowGrooveAnnulus(footstep(groove=replace(GROOVE, depth=1e-12)))
    plain = NarrowGrooveAnnulus(footstep(groove=None))
    slit = math.pi * 21.8e-3 * (20e-6) ** 3 / (6.0 * 35e-3)
    assert shallow.conductance == pytest.approx(slit, rel=1e-6)
    assert plain.conductance == pytest.approx(slit, rel=1e-12)
    assert plain.dragged_flow == 0.0
    assert abs(shallow.dragged_flow) < 1e-12 * NarrowGrooveAnnulus(footstep()).dragged_flow * 1e3
    couette = plain.speed**2 / 20e-6 * 2.0 * math.pi * 21.8e-3 * 35e-3
    assert float(plain.wall_power(np.asarray(0.0))) == pytest.approx(couette, rel=1e-12)


@given(
    st.floats(0.01, 0.99),
    st.floats(1.0, 89.0),
    st.floats(1e-6, 1e-3),
    st.floats(-3e-6, 3e-6),
    st.floats(5.0, 60.0),
)
def test_viscous_heat_is_positive(share, angle, depth, flow, clearance):
    """The wall gives more than the flow takes to higher pressure, whatever the groove."""
    groove = replace(
        GROOVE, angle=math.radians(angle), depth=depth, groove_width=4e-3 * share, land_width=4e-3 * (1.0 - share)
    )
    step = footstep(20.0, clearance, groove=groove, options=FootstepOptions(any_pitch=True))
    assert float(NarrowGrooveAnnulus(step).heat(np.asarray(flow))) > 0.0


def test_eccentric_heel_without_groove_has_the_leak_factor():
    centred, aside = (NarrowGrooveAnnulus(footstep(groove=None, eccentricity_ratio=e)) for e in (0.0, 0.6))
    assert aside.conductance / centred.conductance == pytest.approx(1.0 + 1.5 * 0.36, rel=1e-12)
    power = float(aside.wall_power(np.asarray(0.0)) / centred.wall_power(np.asarray(0.0)))
    assert power == pytest.approx(1.0 / math.sqrt(1.0 - 0.36), rel=1e-9)  # mean of 1/(1 - eps cos)


def test_tilted_heels_agree_with_the_leak_factor():
    from babbitt.kinds.footstep.eccentric import leak_factor

    step = footstep(groove=None, eccentricity_ratio=0.1, tilt=3e-4)
    centred = NarrowGrooveAnnulus(footstep(groove=None))
    ratio = NarrowGrooveAnnulus(step).conductance / centred.conductance
    assert ratio == pytest.approx(leak_factor(*step.end_eccentricities), rel=1e-6)


def test_a_perfect_metal_keeps_the_films_cold():
    cold = footstep(wall=Wall(298.15, 1e9))
    none = footstep()
    for one, other in zip(
        steady_states(cold, Method.NARROW_GROOVE), steady_states(none, Method.NARROW_GROOVE), strict=True
    ):
        assert one.load == pytest.approx(other.load, rel=1e-6)
        assert one.rim_temperature == pytest.approx(298.15, abs=1e-4)


@pytest.mark.parametrize("grooved", [False, True])
def test_heat_is_in_balance(grooved):
    """What the wall gives and the pressure loses is what metal and oil carry away, film by film."""
    step = footstep(wall=Wall(310.0, 6.0), **({} if grooved else {"groove": None}))
    (state,) = steady_states(step, Method.NARROW_GROOVE)
    annulus = NarrowGrooveAnnulus(step)
    flow = -state.leakage
    heat = step.oil.at(state.rim_temperature) * float(annulus.heat(np.asarray(flow)))
    carried = 3.0 * (state.rim_temperature - 310.0)
    carried += OIL.heat_capacity * abs(flow) * (state.rim_temperature - OIL.temperature)
    assert heat == pytest.approx(carried, rel=1e-9)
    whole = state.friction_power - flow * (state.rim_pressure - 0.101e6)
    face = state.friction_power - step.oil.at(state.rim_temperature) * float(annulus.wall_power(np.asarray(flow)))
    assert whole == pytest.approx(heat + face, rel=1e-9)


def test_states_of_films_are_odd_and_named():
    """Where the leakage alone carries the heat several states may appear, an odd number."""
    for conductance in (0.0, 0.01, 0.1, 1.0, 10.0):
        for clearance in (5.0, 10.0, 20.0):
            states = steady_states(footstep(20.0, clearance, wall=Wall(298.15, conductance)), Method.NARROW_GROOVE)
            assert len(states) % 2 == 1
            stable = [state.stable for state in states]
            if len(states) == 1:
                assert states[0].name is StateName.ONLY
            assert stable[0]
            temperatures = [state.rim_temperature for state in states]
            assert temperatures == sorted(temperatures, reverse=True)


def test_constant_viscosity_is_the_linear_network():
    step = footstep(oil=replace(OIL, exponent=0.0), wall=Wall(298.15, 10.0))
    (state,) = steady_states(step, Method.NARROW_GROOVE)
    annulus, mu = NarrowGrooveAnnulus(step), OIL.viscosity
    face, leak = math.pi / (6.0 * mu * step.kappa), annulus.conductance / mu
    rise = (annulus.dragged_flow + face * (0.63e6 - 0.101e6)) / (face + leak)
    assert state.rim_pressure - 0.101e6 == pytest.approx(rise, rel=1e-9)
    assert ThermalFilms(step).residual(np.asarray(-state.leakage)) == pytest.approx(0.0, abs=1e-3)


OF_THE_STUDY = {
    "friction_viscosity": FrictionViscosity.MIXED,
    "face_outlet": FaceOutlet.PRINTED,
    "backflow_viscosity": BackflowViscosity.GROOVE,
    "entry_loss": 1.0,
    "speed_reduction": 0.25,
}


@pytest.mark.parametrize("name", OF_THE_STUDY)
def test_options_of_the_study_are_refused_in_python_too(name):
    step = footstep(options=FootstepOptions(**{name: OF_THE_STUDY[name]}))
    with pytest.raises(InputError, match=name):
        steady_states(step, Method.NARROW_GROOVE)
    assert steady_states(step)
