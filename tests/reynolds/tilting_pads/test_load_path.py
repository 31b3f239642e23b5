"""Pads on flexures whose tilts jump: the load lies between two tilts of a pad, and is carried there."""

import math
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from scaled_pads import LEVER, bearing, directed, pad

from babbitt.core.result import Outcome
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads.dynamics import condensed_at, full_coefficients
from babbitt.reynolds.tilting_pads.pivots import RigidPivot, SpringPivot
from babbitt.reynolds.tilting_pads.rotor import rotor_modes
from babbitt.reynolds.tilting_pads.solution import PadStatus
from babbitt.reynolds.tilting_pads.solve import solve_tilting_pads, tilting_pads_at

GRID = Resolution(4, 48, tolerance=1e-8)


def on_flexures(number, first, extent, fraction, preload, ratio, stiffness, rest, law):
    """Equal pads on flexures, their stiffness at the lever of the pivot, bent by ``rest`` without moment."""
    flexure = {"rotational_stiffness": stiffness * LEVER**2, "rest_tilt": rest / LEVER}
    pads = (pad(first + 360.0 * k / number, extent, fraction, preload, law, **flexure) for k in range(number))
    return bearing(pads, ratio)


JUMPING = {
    "rigid pivots": (
        on_flexures(4, 84.1, 66.0, 0.5, 0.35, 0.92, 0.3163, -0.09, RigidPivot()), directed(2.02, 5.0),
    ),
    "pivots that give way": (
        on_flexures(5, 332.2, 48.0, 0.588, 0.08, 1.11, 0.1188, -0.065, SpringPivot(10.0)), directed(0.499, 57.0),
    ),
}  # fmt: skip


def tilt_stiffness(found):
    """Of film and flexure of every pad."""
    return [
        state.stiffness[1, 1] + own.rotational_stiffness / LEVER**2
        for own, state in zip(found.bearing.pads, found.pads, strict=True)
    ]


@pytest.mark.parametrize("name", JUMPING)
def test_a_load_between_two_tilts_of_a_pad_is_carried(name):
    chosen, load = JUMPING[name]
    found = solve_tilting_pads(chosen, load, GRID)
    assert found.outcome.solved
    assert found.force == pytest.approx(-np.asarray(load), abs=1e-7 * math.hypot(*load))
    for own, state in zip(chosen.pads, found.pads, strict=True):
        if state.status is PadStatus.LOADED:
            moment = own.rotational_stiffness / LEVER * (state.position.tilt - own.rest_tilt)
            assert state.force[1] == pytest.approx(moment, abs=1e-7 * math.hypot(*load))


@pytest.mark.parametrize("name", JUMPING)
def test_its_pad_tips_over_around_a_held_journal_only(name):
    """Every motion of journal and pads without inertia decays; around a journal that is held the tilt runs away to
    another one, with another force."""
    chosen, load = JUMPING[name]
    found = solve_tilting_pads(chosen, load, GRID)
    assert min(tilt_stiffness(found)) < 0.0
    assert all(mode.stable for mode in rotor_modes(full_coefficients(found), 0.0))
    held = tilting_pads_at(chosen, tuple(map(float, found.position)), GRID)
    assert min(tilt_stiffness(held)) > 0.0
    assert np.linalg.norm(held.force - found.force) > 0.01 * math.hypot(*load)


def test_its_static_stiffness_is_that_of_neighbouring_loads():
    chosen, load = JUMPING["rigid pivots"]
    found = solve_tilting_pads(chosen, load, GRID)
    step, moved = 1e-4 * math.hypot(*load), np.zeros((2, 2))
    for i in range(2):
        more, less = (
            solve_tilting_pads(chosen, tuple(np.asarray(load) + sign * step * np.eye(2)[i]), GRID).position
            for sign in (1.0, -1.0)
        )
        moved[:, i] = (more - less) / (2.0 * step)
    stiffness = condensed_at(full_coefficients(found), 0.0).stiffness
    assert np.linalg.inv(moved) == pytest.approx(stiffness, abs=0.005 * np.abs(stiffness).max())


def test_a_path_that_ends_at_an_edge_tells_that_an_edge_touches():
    """A stiff bent flexure presses an edge on the journal before the load is reached."""
    chosen = on_flexures(4, 97.84, 56.0, 0.5, 0.03, 0.36, 19.86, 0.098, RigidPivot())
    assert solve_tilting_pads(chosen, directed(8.25, -153.0), GRID).outcome is Outcome.OVERLOADED


def test_its_kernels_are_compiled_ahead():
    """All that the path calls by itself, in a process that has compiled nothing else."""
    ask = (
        "import compile_kernels; compile_kernels.compile_pads(4); "
        "from babbitt.reynolds.tilting_pads import load_path; "
        "print([len(one.signatures) for one in (load_path.pads_at, load_path.hold_pads, load_path.pivot_curve)])"
    )
    tests = Path(__file__).parents[2]
    said = subprocess.run([sys.executable, "-c", ask], cwd=tests, capture_output=True, text=True, check=True)
    assert "0" not in said.stdout
