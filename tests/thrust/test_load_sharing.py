"""Static share of the pads: sums, symmetries, limits, and what tilt and a soft ring do."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from trawler_pads import PAD, SPEED, THRUST, VISCOSITY, bearing

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.bearing import ThrustBearing
from babbitt.kinds.thrust.failures import PadsTouchError
from babbitt.kinds.thrust.load_curve import carrying
from babbitt.kinds.thrust.pad_attitude import attitude_on_runout
from babbitt.kinds.thrust.runout import RunoutHarmonic
from babbitt.kinds.thrust.sharing import share_at_film, share_of

FILMS = carrying(PAD, VISCOSITY, SPEED)


def test_the_reference_share():
    """Stage 2 of the base case; 0.5 % for the mesh of the prototype."""
    share = share_of(FILMS, bearing(), THRUST)
    assert share.loads / 1e3 == pytest.approx([122.84, 93.08, 51.13, 31.27, 26.20, 31.27, 51.13, 93.08], rel=5e-3)
    assert share.heights[:5] * 1e6 == pytest.approx([35.67, 40.98, 55.28, 70.69, 77.24], rel=5e-3)


@settings(max_examples=25)
@given(tilt=st.floats(0.0, 2e-4), ring=st.floats(7.0, 12.0), thrust=st.floats(1e4, 2e6))
def test_the_pads_carry_the_thrust_and_the_closest_carries_most(tilt, ring, thrust):
    share = share_of(FILMS, bearing(10.0**ring, tilt), thrust)
    assert share.loads.sum() == pytest.approx(thrust, rel=1e-9)
    assert share.loads[0] == share.loads.max()
    assert share.loads == pytest.approx(FILMS.constant / share.heights**2, rel=1e-9)
    balance = share.heights - share.loads / 10.0**ring - bearing(10.0**ring, tilt).departures()
    assert balance == pytest.approx(np.full(8, share.approach), abs=1e-9 * share.heights.max())


@settings(max_examples=10)
@given(pads=st.integers(0, 7), tilt=st.floats(0.0, 1e-4))
def test_turning_the_tilt_by_a_pitch_permutes_the_loads(pads, tilt):
    still = share_of(FILMS, bearing(tilt=tilt), THRUST).loads
    turned = share_of(FILMS, bearing(tilt=tilt, direction=2.0 * math.pi * pads / 8), THRUST).loads
    assert turned == pytest.approx(np.roll(still, pads), rel=1e-9)


def test_a_ring_that_hardly_gives_way_is_rigid():
    rigid = share_of(FILMS, bearing(math.inf), THRUST).loads
    stiff = share_of(FILMS, bearing(1e15), THRUST).loads
    assert stiff == pytest.approx(rigid, rel=1e-5)


def test_a_soft_ring_evens_out_what_a_rigid_one_does_not():
    largest = [share_of(FILMS, bearing(ring), THRUST).largest_over_mean for ring in (math.inf, 2e10, 1e9, 1e8)]
    assert largest == sorted(largest, reverse=True)
    assert largest[0] == pytest.approx(2.16, abs=0.01)
    assert largest[-1] == pytest.approx(1.04, abs=0.01)


def test_a_pad_that_stands_proud_carries_more():
    share = share_of(FILMS, bearing(tilt=0.0, height_errors=(5e-6, *[0.0] * 7)), THRUST)
    assert share.loads[0] > 1.1 * share.loads[1]
    assert share.loads[1:] == pytest.approx(np.full(7, share.loads[1]), rel=1e-9)


def test_runout_at_rest_wanders_with_the_collar():
    of = bearing(tilt=0.0)
    first, second = (
        share_of(FILMS, of, THRUST, attitude_on_runout(of, (RunoutHarmonic(1.0, 5e-6),), angle)).loads
        for angle in (0.0, math.pi / 4)
    )
    assert int(first.argmax()) == 0
    assert second == pytest.approx(np.roll(first, 1), rel=1e-9)


def test_tables_of_a_faced_pad_share_like_films():
    from babbitt.kinds.thrust.face import TaperedFace
    from babbitt.kinds.thrust.pad import Pivot, ThrustPad

    pad = ThrustPad(0.19, 0.375, math.radians(36.0), 0.29, 0.5, Pivot.FIXED, TaperedFace(40e-6, 0.7))
    films = carrying(pad, VISCOSITY, SPEED)
    share = share_of(films, ThrustBearing(pad, 8, 2e10), THRUST)
    assert share.loads.sum() == pytest.approx(THRUST, rel=1e-5)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"number": 1}, "pads"),
        ({"number": 10}, "overlap"),
        ({"ring_stiffness": 0.0}, "ring"),
        ({"pad_mass": -1.0}, "mass"),
        ({"height_errors": (1e-6,)}, "heights"),
    ],
)
def test_bearings_that_cannot_be_are_refused(change, says):
    with pytest.raises(InputError, match=says):
        ThrustBearing(**({"pad": PAD, "number": 8} | change))


def test_no_thrust_is_refused():
    with pytest.raises(InputError, match="thrust"):
        share_of(FILMS, bearing(), 0.0)


@pytest.mark.parametrize("ring", [math.inf, 1e12, 1e10, 1e9])
@pytest.mark.parametrize("proud", [(), (9e-6, *[0.0] * 7)])
def test_the_mean_film_is_the_one_given_and_its_thrust_the_same_share(ring, proud):
    """Whatever the ring gives way: films of mean 50 um and nothing else, and the way back."""
    uneven = bearing(ring, 40e-6, 0.5, height_errors=proud)
    share = share_at_film(FILMS, uneven, 50e-6)
    assert share.heights.mean() == pytest.approx(50e-6, rel=1e-9)
    back = share_of(FILMS, uneven, share.thrust)
    assert back.heights == pytest.approx(share.heights, rel=1e-7)
    assert back.approach == pytest.approx(share.approach, rel=1e-6)


def test_a_softer_ring_needs_less_thrust_for_the_mean_film():
    """An uneven share carries more at the same mean, since W ~ 1/h^2 is convex; a soft ring evens it out."""
    thrusts = [share_at_film(FILMS, bearing(ring, 40e-6), 50e-6).thrust for ring in (math.inf, 1e11, 1e10, 1e9)]
    assert thrusts == sorted(thrusts, reverse=True)
    assert thrusts[-1] > 8 * float(FILMS.load(np.array(50e-6)))


def test_a_mean_film_that_the_tilt_uses_up_is_none():
    with pytest.raises(PadsTouchError, match=r"pad 1 .* nearer"):
        share_at_film(FILMS, bearing(math.inf, 80e-6), 50e-6)
