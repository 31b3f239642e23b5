"""Pads on flexures: they balance everywhere, as far as a film lies between them and the journal."""

import math

import numpy as np
import pytest
from scaled_pads import FOUR_LOAD, LEVER, four_pads, one_pad

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads.solution import PadStatus
from babbitt.reynolds.tilting_pads.solve import fold_of, solve_tilting_pads, tilting_pads_at

GRID = Resolution(4, 48)
STIFFNESS = (1e-6, 1e-4, 1e-2, 0.1, 1.0, 10.0, 1e3, 1e6)
ECCENTRICITY = (-1.5, -0.6, -0.2, -0.05, -1e-3, 1e-3, 0.05, 0.2, 0.5, 0.55)


@pytest.mark.parametrize("preload", [0.0, 0.4])
@pytest.mark.parametrize("fraction", [0.4, 0.5, 0.55])
def test_a_pad_on_a_flexure_balances_everywhere(fraction, preload):
    for stiffness in STIFFNESS:
        chosen = one_pad(0.7, 70.0, fraction, preload, rotational_stiffness=stiffness * LEVER**2)
        for xi in ECCENTRICITY:
            found = tilting_pads_at(chosen, (xi, 0.0), GRID)
            assert found.outcome.solved, (stiffness, xi)
            state = found.pads[0]
            if state.status is PadStatus.LOADED:
                spring = stiffness * LEVER * state.position.tilt
                assert spring == pytest.approx(state.force[1], abs=1e-6 * state.load + 1e-11 * stiffness)


def test_a_soft_flexure_is_as_none_and_a_stiff_one_as_a_fixed_pad():
    free, soft, stiff = (
        tilting_pads_at(one_pad(0.7, 70.0, 0.55, 0.4, **more), (0.1, 0.0), GRID).pads[0]
        for more in ({}, {"rotational_stiffness": 1e-7}, {"rotational_stiffness": 1e9})
    )
    assert soft.load == pytest.approx(free.load, rel=1e-6)
    assert stiff.tangential == pytest.approx(0.0, abs=1e-8)


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_flexure_that_presses_an_edge_on_the_journal_leaves_no_film(side):
    pressed = one_pad(0.7, 70.0, rotational_stiffness=1e4 * LEVER**2, rest_tilt=5.0 * side / LEVER)
    assert tilting_pads_at(pressed, (0.0, 0.0), GRID).outcome is Outcome.OUTSIDE_CLEARANCE


def test_a_profile_that_is_a_tilt_is_taken_back_by_the_pad():
    """w = -g sin(phi) adds to eta; below the edge of its circle the pad is no wider, which a bore of circle is."""
    start, end = -0.55 * math.radians(70.0), 0.45 * math.radians(70.0)
    g = 0.3
    profile = tuple(-g * np.sin(np.linspace(start, end, 2001)))
    for xi in (-0.1, 0.2):
        plain = tilting_pads_at(one_pad(0.7, 70.0, 0.55), (xi, 0.0), GRID).pads[0]
        bent = tilting_pads_at(one_pad(0.7, 70.0, 0.55, profile=profile), (xi, 0.0), GRID).pads[0]
        assert bent.status is PadStatus.LOADED
        assert bent.tangential == pytest.approx(plain.tangential - g, abs=1e-6)
        assert bent.load == pytest.approx(plain.load, rel=1e-5)


def test_a_bearing_on_flexures_that_are_soft_is_one_of_free_pads():
    free, soft = (
        solve_tilting_pads(four_pads(**more), FOUR_LOAD, GRID) for more in ({}, {"rotational_stiffness": 1e-7})
    )
    assert soft.outcome.solved
    assert soft.position == pytest.approx(free.position, abs=1e-5)


def test_a_pad_on_a_flexure_has_no_fold():
    with pytest.raises(InputError, match="flexure"):
        fold_of(one_pad(rotational_stiffness=1.0), 0)
