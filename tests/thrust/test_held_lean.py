"""Faces that cannot follow a tilt of the housing."""

import math
from dataclasses import replace

import numpy as np
import pytest
from trawler_pads import PAD, SPEED, THRUST, VISCOSITY, bearing

from babbitt.thrust.bearing import HousingTilt
from babbitt.thrust.carrying import carrying
from babbitt.thrust.face import TaperedFace
from babbitt.thrust.lean import held_leans, leaning_films
from babbitt.thrust.pad import Pivot
from babbitt.thrust.sharing import share_of

FIXED = replace(PAD, pivot=Pivot.FIXED, face=TaperedFace(60e-6, 0.7))


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_the_lean_of_a_fixed_pad_is_the_plane_of_the_housing(sense):
    """Height and slopes at the pivot give -(e_o/r_o) r cos(theta - theta_t) all over every pad."""
    tilted = replace(bearing(tilt=30e-6, direction=0.7), pad=FIXED, sense=sense)
    x, y = np.array([-0.1, 0.0, 0.08]), np.array([0.05, 0.0, -0.09])
    for angle, away, lean in zip(tilted.angles, tilted.departures(), held_leans(tilted), strict=True):
        place = (FIXED.pivot_radius + x + 1j * sense * y) * np.exp(1j * angle)
        plane = -30e-6 / FIXED.outer_radius * (place * np.exp(-0.7j)).real
        assert away + lean[0] * x + lean[1] * y == pytest.approx(plane, abs=1e-15)


def test_free_tilts_follow_and_a_line_pivot_holds_the_radius():
    assert not held_leans(bearing(tilt=30e-6)).any()
    line = held_leans(replace(bearing(tilt=30e-6), pad=replace(PAD, pivot=Pivot.LINE)))
    assert not line[:, 1].any()
    assert line[0, 0] == pytest.approx(-30e-6 / 0.375)


def test_the_outer_edge_of_the_closest_pad_comes_closer_by_its_lever():
    """Pad 1 stands closest and leans along its radius only: the land of its taper falls by (X/r_o) e_o."""
    tilted = replace(bearing(math.inf, 20e-6), pad=FIXED)
    films = carrying(FIXED, VISCOSITY, SPEED)
    share = share_of(films, tilted, THRUST)
    highest = FIXED.outer_radius - FIXED.pivot_radius  # X on the radius through the pivot, on the outer edge
    fall = share.states[0].minimum_film_thickness - leaning_films(share)[0]
    assert 0.5 * highest < fall * 0.375 / 20e-6 <= highest
    level = share_of(films, replace(tilted, tilt=HousingTilt()), THRUST)
    assert leaning_films(level)[0] == level.states[0].minimum_film_thickness
