"""The thinnest film of a pad: over all of its edges and its face, at rest and in motion."""

import math
from dataclasses import replace

import numpy as np
import pytest
from trawler_pads import PAD, SPEED, VISCOSITY

from babbitt.kinds.shaft_line.forced import forced
from babbitt.kinds.shaft_line.line import Rod, ShaftLine
from babbitt.kinds.shaft_line.losses import film_check, gap_motions
from babbitt.kinds.shaft_line.pads import FilmPads
from babbitt.kinds.thrust.bearing import ThrustBearing
from babbitt.kinds.thrust.face import TaperedFace
from babbitt.kinds.thrust.gap import minimum_gap
from babbitt.kinds.thrust.load_curve import carrying
from babbitt.kinds.thrust.pad import ThrustPad
from babbitt.kinds.thrust.runout import RunoutHarmonic
from babbitt.kinds.thrust.sharing import share_of


def plane_over(pad, motions, arcs=601, radii=7):
    """Gaps of a plane over a fine grid of the pad, shape (motions, arcs, radii)."""
    angle = np.linspace(-pad.pivot_angle, pad.extent - pad.pivot_angle, arcs)[:, None]
    radius = np.linspace(pad.inner_radius, pad.outer_radius, radii)[None, :]
    x, y = radius * np.cos(angle) - pad.pivot_radius, radius * np.sin(angle)
    h, a, b = (part[:, None, None] for part in np.asarray(motions).T)
    return h + a * x + b * y


@pytest.mark.parametrize(
    ("extent", "fraction", "radius", "thrust", "corners", "thinnest"),
    [(75.0, 0.52, 0.303, 560e3, 12.66e-6, 9.80e-6), (80.0, 0.53, 0.313, 500e3, 10.56e-6, 1.78e-6)],
)
def test_wide_pads_are_thinnest_on_their_outer_arc(extent, fraction, radius, thrust, corners, thinnest):
    """With the pivot far out the film falls outward, and the arc reaches farther than its corners."""
    pad = ThrustPad(0.19, 0.375, math.radians(extent), radius, fraction)
    state = share_of(carrying(pad, VISCOSITY, SPEED), ThrustBearing(pad, 4), thrust).states[0]
    assert float((pad.corners() @ state.motion).min()) == pytest.approx(corners, abs=1e-8)
    assert state.minimum_film_thickness == pytest.approx(thinnest, abs=1e-8)
    own = plane_over(pad, [state.motion]).min()
    assert state.minimum_film_thickness == pytest.approx(own, abs=1e-10)
    assert state.minimum_film_thickness <= own * (1.0 + 1e-12)


@pytest.mark.parametrize("extent", [20.0, 80.0, 170.0])
def test_the_least_gap_of_any_plane(extent):
    """The closed form against a fine grid, for slopes in every direction."""
    pad = replace(PAD, extent=math.radians(extent))
    turned = np.linspace(0.0, 2.0 * np.pi, 61)
    motions = np.column_stack([np.full(61, 50e-6), 1e-4 * np.cos(turned), 1e-4 * np.sin(turned)])
    found, sampled = minimum_gap(pad, motions), plane_over(pad, motions).min(axis=(1, 2))
    assert np.all(found <= sampled + 1e-15)
    assert found == pytest.approx(sampled, abs=1e-9)


def test_the_least_gap_over_a_taper_and_a_crown():
    """At the sunk places of the face it is not thinnest; the plane alone is."""
    motion = np.array([[50e-6, 1e-5, -1e-4]])
    tapered = replace(PAD, face=TaperedFace(40e-6, 0.7))
    land = plane_over(PAD, motion, 2001)[0]
    along = np.linspace(0.0, 1.0, 2001)[:, None]
    assert float(minimum_gap(tapered, motion)[0]) == pytest.approx(
        float((land + 40e-6 * np.maximum(0.0, 1.0 - along / 0.7)).min()), rel=1e-4
    )
    crowned = replace(PAD, crown=20e-6)
    bulge = 20e-6 * ((2.0 * along - 1.0) ** 2 + np.linspace(-1.0, 1.0, 7)[None, :] ** 2)
    assert float(minimum_gap(crowned, motion)[0]) == pytest.approx(float((land + bulge).min()), rel=2e-3)


def test_films_in_motion_are_thinnest_anywhere_on_the_pad():
    """The bound and the history of a wide pad against sums over a fine grid of its face."""
    pad = ThrustPad(0.19, 0.375, math.radians(75.0), 0.303, 0.52)
    share = share_of(carrying(pad, VISCOSITY, SPEED), ThrustBearing(pad, 4, 2e10, 40.0), 300e3)
    line = ShaftLine(14e3, 8e4, (Rod(30.0, 0.1, 206e9, 7850.0),), 8e3)
    answer = forced(line, FilmPads(share), SPEED, (), (RunoutHarmonic(1.0, 2e-6),))
    check = film_check(share, answer)
    moving = gap_motions(share, answer.parts[0])
    for place, state in enumerate(share.states):
        amplitude = np.abs(plane_over(pad, [moving[place]])[0])
        still = plane_over(pad, [state.motion])[0]
        assert check.thinnest_bound[place] == pytest.approx(float((still - amplitude).min()), abs=2e-9)
        swing = np.exp(1j * answer.angles[::60])
        films = plane_over(pad, state.motion + (moving[place][None, :] * swing[:, None]).real)
        assert check.histories[place, ::60] == pytest.approx(films.min(axis=(1, 2)), abs=2e-9)
        at_corners = float((pad.corners() @ state.motion - np.abs(pad.corners() @ moving[place])).min())
        assert check.thinnest_bound[place] < at_corners - 0.5e-6
