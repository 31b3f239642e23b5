"""Pads each at the temperature of its own heat balance: idle pads give the loaded one no cold oil."""

from dataclasses import replace

import numpy as np
import pytest
from trawler_pads import PAD, SPEED, bearing

from babbitt.kinds.thrust.bearing import HousingTilt, ThrustBearing
from babbitt.kinds.thrust.check import thrust_check
from babbitt.kinds.thrust.design import (
    Oil,
    PrescribedFilm,
    PrescribedThrust,
    ThrustDesign,
    bearing_state,
    operating_state,
    share_on,
)
from babbitt.kinds.thrust.face import TaperedFace
from babbitt.kinds.thrust.failures import ThermalRunawayError
from babbitt.kinds.thrust.pad import Pivot
from babbitt.kinds.thrust.pad_attitude import attitude_at_rest, attitude_on_runout
from babbitt.kinds.thrust.runout import RunoutHarmonic
from babbitt.properties.lubricants import lubricant

VG_100 = lubricant("ISO VG 100")
SUPPLY, CARRIED = 318.15, 0.75
OIL = Oil(VG_100, None, SUPPLY, CARRIED)
TAPER = replace(PAD, pivot=Pivot.FIXED, pivot_fraction=0.5, pivot_radius=0.2825, face=TaperedFace(40e-6, 0.7))


def design(tilt=0.0, pad=PAD, thrust=500e3, oil=OIL, **other):
    of = replace(bearing(tilt=tilt), pad=pad, **other)
    return ThrustDesign("Block", of, PrescribedThrust(thrust), SPEED, oil)


HALF = {"number": 4, "thrust": 250e3}
"""Half the bearing takes half the time."""


@pytest.mark.parametrize("pad", [PAD, TAPER, replace(PAD, crown=20e-6)], ids=["plane", "taper", "crown"])
def test_every_pad_has_its_own_balance_fed_by_the_pad_before(pad):
    """P = rho c dT (Q_t + Q_s/2), Q_in T_in = kept T_t of the pad before + fresh T_s, mu = mu(T_in + dT/2)."""
    state = bearing_state(design(30e-6, pad))
    capacity = state.films.capacity
    pads = state.share.states
    for place, one in enumerate(pads):
        before, found = pads[place - 1], one.balance
        taken_up = capacity * found.rise * (one.trailing_flow + 0.5 * one.side_flow)
        assert taken_up == pytest.approx(one.friction_power, rel=1e-6)
        entering = one.trailing_flow + one.side_flow
        kept = min(CARRIED * before.trailing_flow, entering)
        mixed = SUPPLY + kept * (before.balance.trailing - SUPPLY) / entering
        assert found.inlet == pytest.approx(mixed, abs=2e-4)
        assert one.viscosity == pytest.approx(VG_100.dynamic_viscosity(found.effective), rel=1e-9)
    assert state.share.loads.sum() == pytest.approx(500e3, rel=1e-6)
    stands = state.share.heights - state.share.loads / 2e10 - state.share.bearing.departures()
    assert stands == pytest.approx(np.full(8, state.share.approach), abs=1e-6 * state.share.heights.max())
    assert abs(state.temperatures.error) < 1e-6


@pytest.mark.parametrize("tilt", [300e-6, 1e-3, 10e-3])
def test_a_pad_that_carries_all_is_not_cooled_by_idle_ones(tilt):
    """Far from even sharing the tight pad is that of a bearing of it alone, between mixtures that bound its inlet.

    Its film lies between that of a pad fed with fresh oil and that of a pad fed by its like.
    """
    state = bearing_state(design(tilt))
    worst = state.share.states[int(state.share.loads.argmax())]
    alone = [
        operating_state(
            replace(design(), bearing=ThrustBearing(PAD, 2), duty=PrescribedThrust(2.0 * worst.load), oil=oil)
        ).share.states[0]
        for oil in (replace(OIL, carry_over=0.0), OIL)
    ]
    assert alone[1].height < worst.height <= alone[0].height * (1.0 + 1e-6)
    assert worst.balance.trailing > 423.15  # what one temperature for all put at 50 degC and called cold
    assert worst.minimum_film_thickness < 5.2e-6


def test_one_pad_that_stands_proud_has_no_help_of_the_others():
    proud = bearing_state(design(height_errors=(2e-3, *([0.0] * 7))))
    films = [bearing_state(design(tilt)).share.states[0].minimum_film_thickness for tilt in (0.0, 30e-6, 100e-6)]
    assert films == sorted(films, reverse=True)
    assert proud.share.states[0].minimum_film_thickness < films[-1]
    assert proud.share.loads[0] > 0.99 * 500e3


def test_a_tilt_that_vanishes_leaves_the_answer_of_pads_that_share_evenly():
    even, nearly = bearing_state(design()), bearing_state(design(1e-10))
    assert even.temperatures.inlet == even.share.states[0].balance.inlet
    assert nearly.share.heights == pytest.approx(even.share.heights, rel=2e-5)
    assert nearly.temperatures.effective == pytest.approx(even.temperatures.effective, abs=1e-3)
    assert nearly.temperatures.drain == pytest.approx(even.temperatures.drain, abs=1e-3)


def test_both_senses_of_rotation_are_mirror_images():
    """Pad 2 follows the hot pad 1 one way, pad 8 the other."""
    forward = bearing_state(design(60e-6)).share.states
    assert forward[1].balance.inlet > forward[7].balance.inlet
    turned = design(60e-6)
    backward = bearing_state(replace(turned, bearing=replace(turned.bearing, sense=-1.0))).share.states
    for here, there in zip(forward, (backward[0], *backward[:0:-1]), strict=True):
        assert here.balance.inlet == pytest.approx(there.balance.inlet, abs=1e-3)
        assert here.height == pytest.approx(there.height, rel=1e-6)


def test_a_film_given_and_its_thrust_are_one_answer():
    """But for the heat capacity: at the temperature of the mean film here, at that of the mean load there."""
    given = bearing_state(replace(design(60e-6), duty=PrescribedFilm(50e-6)))
    assert given.share.heights.mean() == pytest.approx(50e-6, rel=1e-6)
    again = bearing_state(design(60e-6, thrust=given.share.thrust))
    assert again.share.heights == pytest.approx(given.share.heights, rel=2e-2)


def test_a_turbulent_film_has_the_temperature_of_its_pad():
    from babbitt.reynolds.oil.turbulence import NG_PAN, FilmTurbulence

    turbulent = replace(PAD, turbulence=FilmTurbulence(NG_PAN, 860.0, 500.0, 1000.0))
    found = bearing_state(design(60e-6, turbulent))
    laminar = bearing_state(design(60e-6))
    assert found.share.heights == pytest.approx(laminar.share.heights, rel=5e-3)  # the films are laminar, Re = 20


def test_friction_that_outruns_the_oil_of_the_tight_pad_is_no_solution():
    with pytest.raises(ThermalRunawayError):
        bearing_state(design(300e-6, thrust=5e6))
    assert operating_state(design(0.0, thrust=5e6)).temperatures.effective < 573.15


def test_the_housing_may_come_closest_anywhere():
    turned = design()
    at_pad_three = replace(turned.bearing, tilt=HousingTilt(60e-6, np.pi / 2.0))
    one, other = bearing_state(replace(turned, bearing=at_pad_three)), bearing_state(design(60e-6))
    assert np.roll(other.share.heights, 2) == pytest.approx(one.share.heights, rel=1e-6)


@pytest.mark.parametrize("own", [False, True], ids=["global", "adiabatic"])
def test_a_collar_that_leans_loads_pads_as_a_housing_that_leans(own):
    """The runout A at r_p is the plane of a housing tilted by A r_o/r_p: pads take in the same hot oil."""
    runout = 20e-6
    tilted, level = (
        design(tilt, oil=replace(OIL, own_temperatures=own), **HALF)
        for tilt in (runout * PAD.outer_radius / PAD.pivot_radius, 0.0)
    )
    leaning, straight = bearing_state(tilted).share, bearing_state(level)
    standing = attitude_on_runout(level.bearing, (RunoutHarmonic(1.0, runout),), 0.0)
    turned = share_on(straight.films, straight.share, standing)
    assert turned.largest_over_mean == pytest.approx(leaning.largest_over_mean, rel=3e-5 if own else 1e-6)
    assert turned.heights == pytest.approx(leaning.heights, rel=3e-5 if own else 1e-6)


def test_a_runout_that_vanishes_leaves_the_answer_at_rest():
    still = thrust_check(replace(design(30e-6), runouts=(RunoutHarmonic(1.0, 1e-15),))).values
    assert still["quasi_static_load_ratio"] == pytest.approx(still["pad_load_ratio"], rel=1e-6)
    assert still["quasi_static_minimum_film_thickness"] == pytest.approx(still["minimum_film_thickness"], rel=1e-6)


@pytest.mark.parametrize("own", [False, True], ids=["global", "adiabatic"])
def test_the_share_at_rest_is_found_again_from_near_and_far(own):
    tilted = design(30e-6, oil=replace(OIL, own_temperatures=own), **HALF)
    at_rest, standing = bearing_state(tilted), attitude_at_rest(tilted.bearing)
    again = share_on(at_rest.films, at_rest.share, standing)
    assert again.largest_over_mean == pytest.approx(at_rest.share.largest_over_mean, rel=3e-5 if own else 1e-6)
    level = bearing_state(design(0.0, oil=tilted.oil, **HALF)).share
    share = share_on(at_rest.films, replace(level, bearing=tilted.bearing), standing)
    assert share.heights == pytest.approx(at_rest.share.heights, rel=3e-5 if own else 1e-6)


def test_positions_within_a_pitch_stand_for_all_where_the_bearing_is_even():
    """Turned by a pitch, pads only have other names."""
    even = bearing_state(design())
    shares = [
        share_on(
            even.films, even.share, attitude_on_runout(even.share.bearing, (RunoutHarmonic(1.0, 10e-6),), turned)
        )
        for turned in (0.3, 0.3 + np.pi / 4.0)
    ]
    assert np.roll(shares[0].heights, 1) == pytest.approx(shares[1].heights, rel=1e-8)
