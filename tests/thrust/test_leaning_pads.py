"""Faces that cannot follow a tilt of the housing: the plane of the housing, balances, mirrors, small slopes."""

import math
from dataclasses import replace

import numpy as np
import pytest
from trawler_pads import PAD, SPEED, THRUST, VISCOSITY, bearing

from babbitt.core.result import Outcome
from babbitt.kinds.thrust.bearing import HousingTilt
from babbitt.kinds.thrust.equilibrium import sector_of
from babbitt.kinds.thrust.face import SteppedFace, TaperedFace
from babbitt.kinds.thrust.failures import (
    PadsTouchError,
    TiltedPadError,
    TiltedPadsTouchAtFilmError,
    TiltedPadsTouchError,
)
from babbitt.kinds.thrust.load_curve import carrying
from babbitt.kinds.thrust.pad import Pivot
from babbitt.kinds.thrust.pad_attitude import attitude_at_rest, attitude_on_runout
from babbitt.kinds.thrust.runout import RunoutHarmonic
from babbitt.kinds.thrust.sharing import share_at_film, share_of
from babbitt.kinds.thrust.tilt import states_at
from babbitt.reynolds.sector.sector import PlaneMotion, sector_film

TAPER = replace(PAD, pivot=Pivot.FIXED, face=TaperedFace(40e-6, 0.7))
STEP = replace(PAD, pivot=Pivot.FIXED, face=SteppedFace(40e-6, 0.6))
LINE = replace(PAD, pivot=Pivot.LINE)
FILMS = {pad: carrying(pad, VISCOSITY, SPEED) for pad in (TAPER, STEP, LINE, PAD)}
HELD = pytest.mark.parametrize("pad", [TAPER, STEP, LINE], ids=["taper", "step", "line"])


def tilted(pad, tilt=30e-6, direction=0.7, ring=2e10, **other):
    return replace(bearing(ring, tilt, direction, **other), pad=pad)


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_the_gap_of_a_fixed_pad_gets_the_plane_of_the_housing(sense):
    """Departure and lean give -(e_o/r_o) r cos(theta - theta_t) all over every pad."""
    of = tilted(TAPER, sense=sense)
    stands = attitude_at_rest(of)
    x, y = np.array([-0.1, 0.0, 0.08]), np.array([0.05, 0.0, -0.09])
    for angle, away, lean in zip(of.angles, stands.departures, stands.leans, strict=True):
        place = (TAPER.pivot_radius + x + 1j * sense * y) * np.exp(1j * angle)
        plane = -30e-6 / TAPER.outer_radius * (place * np.exp(-0.7j)).real
        assert away + lean[0] * x + lean[1] * y == pytest.approx(plane, abs=1e-15)


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_collar_with_one_high_spot_is_a_tilt_that_turns(sense):
    """The runout A at r_p is the plane of a housing tilted by A r_o/r_p towards the high spot."""
    level = tilted(TAPER, 0.0, sense=sense)
    turned = attitude_on_runout(level, (RunoutHarmonic(1.0, 5e-6),), 0.9)
    same = attitude_at_rest(
        tilted(TAPER, 5e-6 * TAPER.outer_radius / TAPER.pivot_radius, sense * 0.9, sense=sense)
    )
    assert turned.departures == pytest.approx(same.departures, abs=1e-18)
    assert turned.leans == pytest.approx(same.leans, abs=1e-18)


def test_free_tilts_follow_and_a_line_pivot_holds_the_radius():
    assert not attitude_at_rest(bearing(tilt=30e-6)).is_tilted
    leans = attitude_at_rest(tilted(LINE, direction=0.0)).leans
    assert not leans[:, 1].any()
    assert leans[0, 0] == pytest.approx(-30e-6 / 0.375)


@HELD
@pytest.mark.parametrize("ring", [math.inf, 2e10])
def test_thrust_heights_slopes_and_free_moments_are_balanced(pad, ring):
    of = tilted(pad, ring=ring)
    share, stands = share_of(FILMS[pad], of, THRUST), attitude_at_rest(of)
    assert share.loads.sum() == pytest.approx(THRUST, rel=1e-6)
    positions = share.heights - share.loads / ring - stands.departures
    assert positions == pytest.approx(np.full(8, share.approach), abs=1e-6 * share.heights.max())
    for place, state in enumerate(share.states):
        slopes = (state.slope_x, state.slope_y)
        for tilt in (1, 2):
            if tilt in pad.free_tilts:
                assert abs(state.moments[tilt - 1]) < 1e-9 * state.load * 0.185
            else:
                assert slopes[tilt - 1] == stands.leans[place, tilt - 1]


@HELD
def test_every_film_is_that_of_the_leaning_gap(pad):
    """Solved anew in the frame of the ring, not of the pivot: level land, tilt of the housing, free tilt."""
    of = tilted(pad, ring=math.inf)
    share = share_of(FILMS[pad], of, THRUST)
    for place in (0, 3):
        state, turn = share.states[place], of.angles[place] - pad.pivot_angle - 0.7
        steep = -30e-6 / pad.outer_radius
        plane = np.array([share.approach, steep * math.cos(turn), -steep * math.sin(turn)])
        if pad.pivot is Pivot.LINE:  # what the pad has followed on top of the slope along the motion it was given
            follows = state.slope_y - 30e-6 / pad.outer_radius * math.sin(of.angles[place] - 0.7)
            plane += pad.from_pivot() @ np.array([0.0, 0.0, follows])
        film = sector_film(
            sector_of(pad, VISCOSITY, SPEED),
            PlaneMotion(*(float(part) for part in plane)),
            intervals=pad.intervals,
        )
        assert film.load == pytest.approx(state.load, rel=1e-7)


@HELD
def test_the_moment_is_that_of_all_pressures_about_the_shaft(pad):
    """Sum of p (r exp(j theta)) dA over the ring, from the forces of films about the axis, not pivots."""
    of = tilted(pad)
    share = share_of(FILMS[pad], of, THRUST)
    total = 0j
    for angle, state in zip(of.angles, share.states, strict=True):
        about_axis = (
            state.film.forces[1] + 1j * state.film.forces[2]
        )  # of p r exp(j theta), theta from leading edge
        total += about_axis * np.exp(1j * (angle - pad.pivot_angle))
    assert share.moment == pytest.approx(total, rel=1e-9)
    assert share.collar_moment == pytest.approx(abs(total))
    if pad.pivot is Pivot.FIXED:
        at_pivots = abs((share.loads * np.exp(1j * of.angles)).sum()) * pad.pivot_radius
        assert abs(share.collar_moment / at_pivots - 1.0) > 0.01


@HELD
def test_stiffness_against_tilt_is_that_of_the_pad_coefficients(pad):
    """Linear in a small tilt on a rigid ring: dM = -sum of lever times K (e, lean), free tilts at rest."""
    films, small = FILMS[pad], 1e-8
    share = share_of(films, tilted(pad, small, 0.0, math.inf), THRUST)
    level = share_of(films, tilted(pad, 0.0, 0.0, math.inf), THRUST)
    stands, state = attitude_at_rest(tilted(pad, 1.0, 0.0, math.inf)), level.states[0]
    total = 0j
    for angle, away, lean in zip(share.bearing.angles, stands.departures, stands.leans, strict=True):
        given = np.array([away, *lean])
        free = list(pad.free_tilts)
        if free:
            given[free] = -np.linalg.solve(state.stiffness[np.ix_(free, free)], state.stiffness[free] @ given)
        force = -state.stiffness @ given
        total += (force[0] * pad.pivot_radius + force[1] + 1j * force[2]) * np.exp(1j * angle)
    assert (share.moment - level.moment) / small == pytest.approx(total, rel=2e-4)
    assert total.real > 0.0  # pads that are pressed closer push back


@HELD
def test_level_pads_are_as_before(pad):
    films, level = FILMS[pad], tilted(pad, 0.0, height_errors=(3e-6, *[0.0] * 7))
    assert not attitude_at_rest(level).is_tilted
    state = share_of(films, level, THRUST).states[0]
    assert state.load == pytest.approx(films.state(state.height).load, rel=1e-12)
    hardly = share_of(films, replace(level, tilt=HousingTilt(1e-13)), THRUST)
    assert hardly.loads == pytest.approx(share_of(films, level, THRUST).loads, rel=1e-5)


def test_point_pivots_are_moved_in_height_only():
    share = share_of(FILMS[PAD], tilted(PAD), THRUST)
    assert [state.slope_y / state.height for state in share.states] == pytest.approx(
        [FILMS[PAD].reference.slope_y / FILMS[PAD].reference.height] * 8
    )


@HELD
def test_a_mirrored_tilt_under_a_reversed_runner_gives_mirrored_pads(pad):
    one = share_of(FILMS[pad], tilted(pad, direction=0.7), THRUST)
    other = share_of(FILMS[pad], tilted(pad, direction=-0.7, sense=-1.0), THRUST)
    mirrored = [-place % 8 for place in range(8)]
    assert other.loads[mirrored] == pytest.approx(one.loads, rel=1e-9)
    mine, theirs = (np.array([state.moments for state in share.states]) for share in (one, other))
    assert theirs[mirrored] == pytest.approx(mine, rel=1e-6, abs=1e-5)
    assert other.moment == pytest.approx(one.moment.conjugate(), rel=1e-9)


@HELD
def test_turning_the_tilt_by_a_pitch_turns_pads_and_moment(pad):
    still = share_of(FILMS[pad], tilted(pad), THRUST)
    turned = share_of(FILMS[pad], tilted(pad, direction=0.7 + 3 * math.pi / 4), THRUST)
    assert turned.loads == pytest.approx(np.roll(still.loads, 3), rel=1e-9)
    assert turned.moment == pytest.approx(still.moment * np.exp(0.75j * math.pi), rel=1e-9)


@HELD
def test_stiffness_is_that_of_the_leaning_film(pad):
    """dW/dh at a lean that stays, against films solved above and below."""
    share = share_of(FILMS[pad], tilted(pad), THRUST)
    lean = attitude_at_rest(share.bearing).lean(0)
    from babbitt.kinds.thrust.state import condensed

    state = share.states[0]
    step = 1e-5 * state.height
    above, below = (FILMS[pad].state(state.height + side * step, lean).load for side in (1.0, -1.0))
    assert condensed(state, 0.0).real == pytest.approx((below - above) / (2.0 * step), rel=1e-4)


def test_the_closest_pad_leans_its_outer_edge_into_the_film():
    """Pad 1 leans along its radius only: the edge of its land falls by X/r_o of the tilt below its pivot."""
    share = share_of(FILMS[TAPER], tilted(TAPER, 20e-6, 0.0), THRUST)
    state = share.states[0]
    outermost = PAD.outer_radius * math.cos((0.7 - PAD.pivot_fraction) * PAD.extent) - PAD.pivot_radius
    assert state.height - state.minimum_film_thickness == pytest.approx(20e-6 / 0.375 * outermost, rel=1e-3)


@pytest.mark.parametrize("ring", [math.inf, 2e10])
def test_the_mean_film_is_the_one_given_and_its_thrust_the_same_share(ring):
    of = tilted(TAPER, ring=ring)
    share = share_at_film(FILMS[TAPER], of, 40e-6)
    assert share.heights.mean() == pytest.approx(40e-6, rel=1e-9)
    back = share_of(FILMS[TAPER], of, share.thrust)
    assert back.heights == pytest.approx(share.heights, rel=1e-7)


def test_faces_that_touch_before_the_thrust_is_carried_have_no_film():
    with pytest.raises(TiltedPadsTouchError, match="pad 1 leans"):
        share_of(FILMS[TAPER], tilted(TAPER, 400e-6, 0.0, math.inf), 20e6)
    with pytest.raises(PadsTouchError):
        share_at_film(FILMS[TAPER], tilted(TAPER, 80e-6, 0.0, math.inf), 50e-6)
    with pytest.raises(TiltedPadsTouchAtFilmError, match=r"mean film of 50\.0 µm; less tilt.*thicker") as told:
        # pivots clear, outer edges do not
        share_at_film(FILMS[TAPER], tilted(TAPER, 60e-6, 0.0, math.inf), 50e-6)
    assert told.value.outcome is Outcome.OUTSIDE_CLEARANCE
    assert "thrust" not in str(told.value)


def balances(of, place, height):
    """Moments about the radius through the pivot over every slope at which the pad clears, over load and width."""
    lean, sector = attitude_at_rest(of).leans[place, 0], sector_of(LINE, VISCOSITY, SPEED)
    corners = LINE.corners()
    moments = []
    for slope in -np.geomspace(2e-6, 5e-4, 60)[::-1]:
        motion = np.array([height, lean, slope])
        if (corners @ motion).min() > 2e-7:
            film = sector_film(sector, PlaneMotion(*(LINE.from_pivot() @ motion)), intervals=LINE.intervals)
            if film.load > 0.0:  # a gap that diverges carries nothing
                moments.append(float((LINE.from_pivot().T @ film.forces)[2] / film.load / 0.185))
    return np.array(moments)


@pytest.mark.parametrize(("ring", "borne", "unborne"), [(math.inf, 100, 110), (2e10, 100, 110), (1e9, 150, 165)])
def test_line_pivots_settle_until_a_corner_touches(ring, borne, unborne):
    """More tilt thins the film steadily to a micrometre or two; beyond, the corner touches before it balances."""
    thinnest = []
    for tilt in (0.6 * borne, 0.8 * borne, borne):
        share = share_of(FILMS[LINE], tilted(LINE, 1e-6 * tilt, ring=ring), THRUST)
        assert share.loads.sum() == pytest.approx(THRUST, rel=1e-5)
        assert max(abs(state.moments[1]) / state.load for state in share.states) < 1e-9 * 0.185
        thinnest.append(min(state.minimum_film_thickness for state in share.states))
    assert thinnest == sorted(thinnest, reverse=True)
    assert 0.0 < thinnest[-1] < 2e-6
    with pytest.raises(TiltedPadsTouchError) as told:
        share_of(FILMS[LINE], tilted(LINE, 1e-6 * unborne, ring=ring), THRUST)
    assert told.value.pad == 2


def test_a_leaning_line_pivot_falls_over_below_a_film():
    """On a soft ring far pads lean their inner edges in; below a film no slope balances, above one does."""
    of = tilted(LINE, 110e-6, ring=1e9)
    with pytest.raises(TiltedPadError, match=r"pad 6 leans.* the pad falls over.* straighter housing") as told:
        share_of(FILMS[LINE], of, 1e6)
    film = told.value.thinnest
    assert balances(of, 5, 0.98 * film).min() > 0.0
    assert balances(of, 5, 1.02 * film).min() < 0.0


@pytest.mark.thorough
def test_however_far_the_housing_tilts_the_end_is_told():
    """No tilt ends in a search without result: a film, a corner that touches, or a pad that falls over."""
    for tilt in (200e-6, 400e-6, 1e-3):
        for ring in (math.inf, 1e9):
            with pytest.raises(TiltedPadsTouchError, match="touches the collar while the pads carry"):
                share_of(FILMS[LINE], tilted(LINE, tilt, ring=ring), THRUST)


@pytest.mark.parametrize(("direction", "solved"), [(0.0, 5), (math.pi / 8, 4)])
def test_pads_that_lean_alike_share_a_film(direction, solved):
    """About a tilt towards a pad, or between two: line pivots that face each other across it lean alike."""
    of, asked = tilted(LINE, 20e-6, direction), []

    class Counted:
        pad = LINE

        def state(self, *given):
            asked.append(given)
            return FILMS[LINE].state(*given)

    stands = attitude_at_rest(of)
    states = states_at(Counted(), 60e-6 + stands.departures, stands)
    assert len(states) == 8
    assert len(asked) == solved


def test_line_pivots_across_the_tilt_are_level():
    """The radius at a right angle to the tilt stays level, to the last digit."""
    leans = attitude_at_rest(tilted(LINE, direction=0.0)).leans
    assert not leans[[2, 6]].any()
    assert np.abs(leans[[0, 1, 3, 4, 5, 7], 0]).min() > 1e-5
