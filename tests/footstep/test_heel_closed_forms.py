"""Footstep: closed forms of constant viscosity, limits, and the balance of every state."""

import math
from dataclasses import replace

import numpy as np
import pytest
from heels import GEOMETRY, GROOVE, OIL, footstep
from hypothesis import given, settings
from hypothesis import strategies as st

from babbitt.kinds.footstep.face import Face, number
from babbitt.kinds.footstep.model import (
    BackflowViscosity,
    FaceOutlet,
    FootstepOptions,
    FrictionViscosity,
    LoadReference,
)
from babbitt.kinds.footstep.states import (
    NoSteadyStateError,
    StateName,
    has_steady_state,
    roots_of_balance,
    steady_states,
)
from babbitt.kinds.footstep.superposition import GrooveChannel, GroovedFootstep

CONSTANT = replace(OIL, exponent=0.0)


def conductances(step):
    """G_l, G_k, G_h of constant viscosity."""
    part, groove, mu = step.geometry, GROOVE, step.oil.viscosity
    slit = math.pi * part.radius * step.clearance**3 / (6.0 * mu * part.length)
    length = part.length / math.sin(groove.angle)
    channel = groove.starts * groove.groove_width * groove.depth**3 / (12.0 * mu * length)
    return slit, channel, math.pi / (6.0 * mu * step.kappa)


@pytest.mark.parametrize(("gap", "clearance"), [(20.0, 20.0), (8.0, 12.0), (60.0, 35.0)])
def test_grooved_heel_of_constant_viscosity(gap, clearance):
    step = footstep(gap, clearance, oil=CONSTANT)
    slit, channel, face = conductances(step)
    most = 0.5 * 5 * 1.2e-3 * step.angular_speed * 21.8e-3 * math.cos(math.radians(10.0)) * 0.3e-3
    rise = (most + face * (0.63e6 - 0.101e6)) / (slit + channel + face)
    (state,) = steady_states(step)
    assert state.rim_pressure - 0.101e6 == pytest.approx(rise, rel=1e-9)
    assert state.leakage == pytest.approx(slit * rise, rel=1e-9)
    assert (state.name, state.stable) == (StateName.ONLY, True)


@pytest.mark.parametrize(("gap", "clearance"), [(20.0, 20.0), (8.0, 12.0), (60.0, 35.0)])
def test_smooth_heel_of_constant_viscosity(gap, clearance):
    step = footstep(gap, clearance, oil=CONSTANT, groove=None)
    slit, _, face = conductances(step)
    flow = (0.63e6 - 0.101e6) / (1.0 / slit + 1.0 / face)
    (state,) = steady_states(step)
    assert state.leakage == pytest.approx(flow, rel=1e-9)
    r1, r3, r2 = GEOMETRY.radius, GEOMETRY.recess_radius, GEOMETRY.bore_radius
    c = 6.0 * CONSTANT.viscosity * flow / math.pi
    p3 = 0.63e6 - c * math.log(r3 / r2) / GEOMETRY.recess_depth**3
    ring = 0.5 * r1**2 * math.log(r1 / r3) - 0.25 * (r1**2 - r3**2)
    load = math.pi * (r1**2 - r3**2) * p3 - 2.0 * math.pi * c / step.face_gap**3 * ring
    load += math.pi * (r3**2 - r2**2) * (0.63e6 + p3) / 2.0
    assert state.load == pytest.approx(load, rel=1e-9)


def test_limits():
    area = math.pi * (GEOMETRY.radius**2 - GEOMETRY.bore_radius**2)
    wide = steady_states(footstep(5000.0, groove=None))[0]
    assert wide.rim_pressure == pytest.approx(0.63e6, rel=1e-4)
    assert wide.load == pytest.approx(area * 0.63e6, rel=1e-4)
    tight = steady_states(footstep(20.0, 0.5, groove=None))[0]
    assert tight.rim_pressure == pytest.approx(0.63e6, rel=1e-4)
    channel = GrooveChannel(footstep(oil=CONSTANT))
    dead_end = float(channel.end(number(1e-9 * channel.largest_flow))[0]) - 0.101e6
    assert dead_end == pytest.approx(channel.dead_end_rise, rel=1e-8)


def test_small_exponents_approach_constant_viscosity():
    """By the cold state; the hot one goes to exponentially small flows, outside the search."""
    almost = steady_states(footstep(oil=replace(OIL, exponent=1e-9)))[-1]
    (exact,) = steady_states(footstep(oil=CONSTANT))
    for name in ("rim_pressure", "leakage", "face_flow", "groove_flow", "load", "friction_power"):
        assert getattr(almost, name) == pytest.approx(getattr(exact, name), rel=1e-6)


def test_two_states_and_none():
    assert [state.name for state in steady_states(footstep())] == [StateName.HOT, StateName.COLD]
    with pytest.raises(NoSteadyStateError, match="receives more oil") as caught:
        steady_states(footstep(12.0, 10.0))
    assert caught.value.largest_residual < 0.0
    assert caught.value.rim_pressure == pytest.approx(0.63e6, rel=1e-3)


@pytest.mark.parametrize("clearance", [12.0, 20.0, 35.0])
@pytest.mark.parametrize("gap", [16.0, 40.0])
def test_every_state_is_in_balance(gap, clearance):
    step = footstep(gap, clearance)
    for state in steady_states(step):
        assert state.residual < 1e-10
        assert state.leakage == pytest.approx(state.groove_flow + state.face_flow, rel=1e-9)
        by_face = Face(step).flow(number(state.rim_pressure))
        assert float(by_face) == pytest.approx(state.face_flow, rel=1e-9)


def test_a_finer_search_finds_no_other_states(monkeypatch):
    found = {}
    for samples in (600, 1200):
        monkeypatch.setattr("babbitt.kinds.footstep.states.SAMPLES", samples)
        found[samples] = [
            roots_of_balance(GroovedFootstep(footstep(gap, clearance)))
            for gap, clearance in ((20, 20), (12, 10.6), (40, 15))
        ]
    for coarse, fine in zip(found[600], found[1200], strict=True):
        assert coarse == pytest.approx(fine, rel=1e-9)


heels = st.builds(
    footstep,
    st.floats(4.0, 80.0),
    st.floats(5.0, 60.0),
    angular_speed=st.floats(20.0, 400.0),
    supply_pressure=st.floats(0.2e6, 3e6),
    oil=st.builds(replace, st.just(OIL), exponent=st.floats(0.005, 0.06), viscosity=st.floats(0.005, 0.1)),
)


@settings(max_examples=60)
@given(heels)
def test_the_residual_is_negative_at_both_ends(step):
    """So that the number of steady states is even."""
    model = GroovedFootstep(step)
    ends = np.array([1e-12, 1.0]) * model.channel.largest_flow
    assert (model.residual(ends) < 0.0).all()
    if not has_steady_state(model):
        with pytest.raises(NoSteadyStateError):
            roots_of_balance(model)
    else:
        roots = roots_of_balance(model)
        out_of_sight = float(model.residual(number(1e-6 * model.channel.largest_flow))) > 0.0  # a hot state below
        assert (len(roots) + out_of_sight) % 2 == 0
        names = [state.name for state in steady_states(step)]
        assert names == [StateName.HOT, StateName.COLD][out_of_sight:]


@settings(max_examples=25)
@given(heels, st.floats(0.5, 2.0))
def test_similarity(step, c):
    """All lengths times c at the same speed and pressures: pressures and temperatures stay."""
    part, groove = step.geometry, GROOVE
    larger = replace(
        step,
        geometry=replace(part, **{name: c * value for name, value in vars(part).items()}),
        groove=replace(groove, depth=c * groove.depth, groove_width=c * groove.groove_width,
                       land_width=c * groove.land_width),
        face_gap=c * step.face_gap,
        clearance=c * step.clearance,
    )  # fmt: skip
    try:
        states = steady_states(step)
    except NoSteadyStateError:
        with pytest.raises(NoSteadyStateError):
            steady_states(larger)
        return
    scaled = steady_states(larger)
    assert len(scaled) == len(states)
    for one, other in zip(states, scaled, strict=True):
        assert other.rim_pressure == pytest.approx(one.rim_pressure, rel=1e-6)
        assert other.groove_temperature == pytest.approx(one.groove_temperature, rel=1e-6)
        for name, power in (("leakage", 3), ("load", 2), ("friction_power", 3)):
            assert getattr(other, name) == pytest.approx(getattr(one, name) * c**power, rel=1e-5)
        assert other.stable == one.stable


def test_load_counts_absolute_or_gauge_pressures():
    area = math.pi * (GEOMETRY.radius**2 - GEOMETRY.bore_radius**2)
    gauge = footstep(options=FootstepOptions(load_reference=LoadReference.GAUGE))
    for absolute, above in zip(steady_states(footstep()), steady_states(gauge), strict=True):
        assert absolute.load - above.load == pytest.approx(area * 0.101e6, rel=1e-12)


def test_printed_outlet_temperature_differs_little():
    """At most 0.7 K at h = 5 µm and below 0.2 % of the load, as the specification of the correction says."""
    printed = steady_states(footstep(5.0, options=FootstepOptions(face_outlet=FaceOutlet.PRINTED)))[0]
    ours = steady_states(footstep(5.0))[0]
    assert 0.2 < abs(printed.face_temperature - ours.face_temperature) < 0.7
    assert printed.load == pytest.approx(ours.load, rel=2e-3)


def test_viscosity_of_friction_is_a_choice():
    mixed = steady_states(footstep(options=FootstepOptions(friction_viscosity=FrictionViscosity.MIXED)))[0]
    mean = steady_states(footstep())[0]
    assert mixed.load == mean.load
    hot, land = OIL.at(mean.groove_temperature), OIL.at(mean.rim_temperature)
    face = Face(footstep()).shear_power(
        OIL.at(0.5 * (OIL.temperature + mean.face_temperature)), footstep().angular_speed
    )
    assert (mixed.friction_power - face) / (mean.friction_power - face) == pytest.approx(
        land / (0.5 * (OIL.viscosity + hot)), rel=1e-9
    )


def test_hot_oil_that_flows_back_flows_more_easily():
    choice = FootstepOptions(backflow_viscosity=BackflowViscosity.GROOVE)
    cold = steady_states(footstep(options=choice))[-1]
    usual = steady_states(footstep())[-1]
    assert cold.face_flow < 0.0
    assert cold.face_flow < usual.face_flow
    step = footstep(options=choice)
    ends = Face(step).pressure(
        np.array([GEOMETRY.recess_radius, GEOMETRY.radius]), cold.face_flow, cold.rim_pressure,
        OIL.at(cold.groove_temperature),
    )  # fmt: skip
    assert ends[1] == pytest.approx(cold.rim_pressure, rel=1e-12)
    assert 0.63e6 < ends[0] < cold.rim_pressure
    # Where nothing flows the choice changes nothing, and it does nothing to the state with outward flow.
    assert steady_states(step)[0].load == pytest.approx(steady_states(footstep())[0].load, rel=1e-12)


def test_entry_loss_lowers_the_pressure_of_the_groove():
    flow = number(1e-7)
    free, lossy = GrooveChannel(footstep()), GrooveChannel(footstep(options=FootstepOptions(entry_loss=1.0)))
    loss = float(free.end(flow)[0] - lossy.end(flow)[0])
    assert loss == pytest.approx(0.5 * 880.0 * (1e-7 / (6e-3 * 0.3e-3)) ** 2, rel=1e-4)
    assert steady_states(footstep(options=FootstepOptions(entry_loss=1.0)))[0].load == pytest.approx(
        steady_states(footstep())[0].load, rel=1e-6
    )


def test_speed_reduction_removes_the_states_of_small_clearances():
    with pytest.raises(NoSteadyStateError):
        steady_states(footstep(11.0, 10.0, options=FootstepOptions(speed_reduction=0.25)))
