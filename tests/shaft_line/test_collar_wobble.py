"""A collar whose face leans: what pads feel that cannot follow, and the moment on the collar."""

from dataclasses import replace

import numpy as np
import pytest
from trawler_line import duty, line
from trawler_pads import INERTIA, PAD, SPEED, THRUST, VISCOSITY

from babbitt.kinds.shaft_line.excitation import RunoutHarmonic
from babbitt.kinds.shaft_line.forced import forced
from babbitt.kinds.shaft_line.losses import gap_motions, moment_amplitude
from babbitt.kinds.shaft_line.model import state_of
from babbitt.kinds.shaft_line.pads import FilmPads
from babbitt.kinds.thrust.equilibrium import sector_of
from babbitt.kinds.thrust.face import TaperedFace
from babbitt.kinds.thrust.load_curve import carrying
from babbitt.kinds.thrust.pad import Pivot
from babbitt.kinds.thrust.pad_attitude import attitude_on_runout
from babbitt.kinds.thrust.sharing import share_of
from babbitt.kinds.thrust.state import TiltInertia
from babbitt.reynolds.sector.sector import PlaneMotion, sector_film

FILMS = carrying(PAD, VISCOSITY, SPEED)
LINE_PAD = replace(PAD, pivot=Pivot.LINE)
TAPER = replace(PAD, pivot=Pivot.FIXED, face=TaperedFace(60e-6, 0.7))


def on(pad, inertia=INERTIA):
    films = carrying(pad, VISCOSITY, SPEED)
    return state_of(replace(duty(), bearing=replace(duty().bearing, pad=pad, inertia=inertia)), films)


def pressed(pad, amplitude):
    """Load gained per height of a leaning face, N/m: high spot under the pad, and a quarter of a turn later."""
    to_film, sector = TAPER.from_pivot(), sector_of(TAPER, VISCOSITY, SPEED)
    at = np.array([pad.height, pad.slope_x, pad.slope_y])
    slopes = []
    for shape in ((1.0, 1.0 / 0.29, 0.0), (0.0, 0.0, 1.0 / 0.29)):
        near, far = (
            sector_film(
                sector,
                PlaneMotion(*(to_film @ (at - side * amplitude * np.array(shape)))),
                intervals=TAPER.intervals,
            ).load
            for side in (1.0, -1.0)
        )
        slopes.append((near - far) / (2.0 * amplitude))
    return complex(slopes[0], -slopes[1])


def test_a_face_that_leans_presses_a_fixed_pad_as_its_film_displaced():
    """What the line feels of a pad at rest is the film of the same mesh displaced as a plane that wobbles.

    To 1e-6 where the film is whole. Where it ruptures askew to its lines, coefficients count it to its end between
    two lines and not to the last wet one, so that they do not jump from node to node
    (`babbitt.reynolds.lands._endings`); the load displaced does jump, by 4e-4 of the worst pad here, on 240 and
    480 intervals by 1e-4 and 1.6e-4.
    """
    state = on(TAPER)
    felt = state.pads.film(1e-6) * (1.0 + state.pads.wobble(1e-6))
    ruptured = []
    for pad, answer in zip(state.share.states, felt, strict=True):
        inner = pad.film.pressure[1:-1, 1:-1]
        ruptured.append(bool((inner <= 0.0).any()))
        assert abs(answer - pressed(pad, 1e-8)) < (5e-4 if ruptured[-1] else 1e-6) * abs(answer)
    assert ruptured == [False, True, True, True, False, False, False, False]


def test_a_free_pad_follows_a_face_that_leans_and_a_heavy_one_does_not():
    assert np.abs(on(PAD).pads.wobble(SPEED)).max() < 1e-5
    heavy, held = on(PAD, TiltInertia(1e16, 1e16)), on(replace(PAD, pivot=Pivot.LINE), TiltInertia(0.0, 1e16))
    for state in (heavy, held):
        stiffness = state.share.states[0].stiffness
        felt = (state.pads.film(1e-2 * SPEED) * (1.0 + state.pads.wobble(1e-2 * SPEED)))[0].real
        free_of_damping = stiffness[0] @ (1.0, 1.0 / 0.29, 0.0)
        assert felt == pytest.approx(free_of_damping, rel=0.02)


def test_a_line_pivot_feels_the_lean_along_the_radius():
    state = on(LINE_PAD)
    assert 0.01 < np.abs(state.pads.wobble(SPEED)).max() < 0.1
    assert state.film.thinnest_bound.min() < on(PAD).film.thinnest_bound.min()


def test_tilt_turns_the_collar_and_an_even_bearing_does_not():
    base = state_of(duty(), FILMS)
    level = state_of(base.duty.with_tilt(0.0), FILMS)
    assert level.share.collar_moment < 1e-6 * level.share.thrust
    assert level.moment_amplitude == pytest.approx(0.29 * 4.0 * abs(level.forced.parts[1].response.forces[0]))
    moment = np.hypot(
        *(0.29 * (base.share.loads * wave(base.duty.bearing.angles)).sum() for wave in (np.cos, np.sin))
    )
    assert base.share.collar_moment == pytest.approx(moment)
    assert base.share.collar_moment > 1e4


def turned_slowly(pad, runout):
    """Static moments of the pads with the high spot at two places, less that without runout."""
    of = replace(duty(tilt=0.0).bearing, pad=pad)
    films = carrying(pad, VISCOSITY, SPEED)
    still = share_of(films, of, THRUST)
    return still, [
        share_of(films, of, THRUST, attitude_on_runout(of, (RunoutHarmonic(1.0, runout),), turned)).moment
        - still.moment
        for turned in (0.0, 1.1)
    ]


@pytest.mark.parametrize("pad", [TAPER, LINE_PAD, PAD], ids=["taper", "line", "point"])
def test_slow_runout_turns_the_collar_as_the_static_share_does(pad):
    """The dynamic moment at vanishing speed is that of pads that stand on the turned collar, slopes included."""
    small = 1e-7
    still, moments = turned_slowly(pad, small)
    slow = forced(line(), FilmPads(still), 1e-4, (), (RunoutHarmonic(1.0, small),))
    amplitude = moment_amplitude(still, slow.parts[0])
    assert [abs(moment) for moment in moments] == pytest.approx([amplitude] * 2, rel=2e-3)
    assert np.angle(moments[1] / moments[0]) == pytest.approx(1.1, abs=2e-3)


@pytest.mark.parametrize("pad", [TAPER, LINE_PAD], ids=["taper", "line"])
def test_forces_of_the_moving_gaps_are_those_of_the_line(pad):
    """-(K + j nu C) g of height and slopes gives the forces that the line was solved for, under a tilt."""
    state = on(pad)
    for part in state.forced.parts:
        nu = part.response.frequency
        films = np.array([one.stiffness + 1j * nu * one.damping for one in state.share.states])
        forces = -np.einsum("zj,zj->z", films[:, 0, :], gap_motions(state.share, part))
        assert forces == pytest.approx(part.response.forces, rel=1e-9)
