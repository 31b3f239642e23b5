"""Where films end: smooth coefficients on discrete lines, and what leaves at the side under squeeze."""

import math
from dataclasses import replace

import numpy as np
import pytest

from babbitt.reynolds.equilibrium.position import film_at_position
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import Cavitation, JournalFilm, Resolution, grooved_bore

CLEARANCE = 80e-6
TWO = grooved_bore((0.0, math.pi), math.radians(20.0))
ABOVE = grooved_bore((0.5 * math.pi,), math.radians(20.0))
CONDITIONS = [Cavitation.MASS_CONSERVING, Cavitation.REYNOLDS]


def bearing(cavitation, lands=TWO, width=0.08, speed=300.0):
    return JournalFilm(0.1, width, CLEARANCE, 0.02, speed, lands, cavitation)


def jumps(values):
    """Half the third difference along a sweep over the largest entry, as ``coefficient_smoothness.py`` has it."""
    return 0.5 * np.abs(np.diff(values, n=3, axis=0)).max(axis=1) / np.abs(values[1:-2]).max(axis=1)


@pytest.mark.parametrize("cavitation", CONDITIONS)
@pytest.mark.parametrize(
    ("lands", "width", "intervals", "numbers"),
    [(TWO, 0.08, 96, (0.25, 0.5)), (TWO, 0.05, 96, (0.09, 0.25)), (ABOVE, 0.08, 96, (0.04, 0.15))],
    ids=["rupture reaches the groove", "narrow", "front that closes"],
)
def test_coefficients_do_not_jump_along_a_load_sweep(cavitation, lands, width, intervals, numbers):
    """Loads as dense as 200 over three decades; nodes change sides all along the way."""
    model = bearing(cavitation, lands, width)
    unit = 0.02 * 300.0 * (0.05 / CLEARANCE) ** 2 * 0.1 * width
    count = round(200 * math.log10(numbers[1] / numbers[0]) / 3.0)
    found = [
        solve_journal(model, (0.0, -number * unit), Resolution(4, intervals))
        for number in np.geomspace(*numbers, count)
    ]
    assert all(film.outcome.solved for film in found)
    for name in ("stiffness", "damping"):
        values = np.array([getattr(film, name).ravel() for film in found])
        assert jumps(values).max() < 3e-3


@pytest.mark.parametrize("cavitation", CONDITIONS)
def test_stiffness_across_a_closing_front(cavitation):
    """Against differences of the force on a finer grid, wide enough to average its own kinks."""
    model, at, step = bearing(cavitation, ABOVE), np.array([0.25, -0.2]) * CLEARANCE, 1e-2 * CLEARANCE
    found = film_at_position(model, tuple(at), resolution=Resolution(6, 192)).stiffness
    for axis, shift in enumerate(np.eye(2) * step):
        ahead, behind = (
            film_at_position(model, tuple(at + sign * shift), resolution=Resolution(6, 384)).force
            for sign in (1.0, -1.0)
        )
        np.testing.assert_allclose(
            -(ahead - behind) / (2.0 * step), found[:, axis], atol=5e-3 * np.abs(found).max()
        )


@pytest.mark.parametrize("velocity", [(0.0, 0.0), (3e-3, -4e-3), (-3e-3, 4e-3)])
@pytest.mark.parametrize("cavitation", CONDITIONS)
def test_side_flow_converges_with_squeeze_and_without(cavitation, velocity):
    model, at = bearing(cavitation, width=0.1), (30e-6, -35e-6)
    coarse, fine, finest = (
        film_at_position(model, at, velocity, Resolution(m, n)) for m, n in ((4, 96), (6, 192), (8, 384))
    )
    sides = [film.side_flow.sum() for film in (coarse, fine, finest)]
    assert sides[0] == pytest.approx(sides[2], rel=3e-3)
    assert sides[1] == pytest.approx(sides[2], rel=8e-4)
    if cavitation is Cavitation.MASS_CONSERVING:
        assert max(film.mass_balance_error for film in (coarse, fine, finest)) < 1e-10


def test_a_full_film_that_is_squeezed_gives_off_what_the_gap_loses():
    velocity = (2e-3, -3e-3)
    model = replace(bearing(Cavitation.REYNOLDS, speed=0.0), cavitation_pressure=-1e12)
    found = film_at_position(model, (20e-6, 10e-6), velocity)
    assert found.outcome.solved
    for land, angles in enumerate(found.angles):
        share = 0.5 * (angles[2:] - angles[:-2])  # of the lines between the groove edges
        closing = velocity[0] * np.cos(angles[1:-1]) + velocity[1] * np.sin(angles[1:-1])
        lost = 0.05 * 0.08 * share @ closing
        given = found.side_flow[land] + found.outflow[land] - found.inflow[land]
        assert given == pytest.approx(lost, rel=1e-3, abs=1e-3 * 0.05 * 0.08 * 4e-3)


def test_pure_squeeze_with_cavitation_draws_no_oil_from_the_air():
    """Where the gap opens, the ruptured film takes nothing in; the closing half gives all it loses."""
    model = bearing(Cavitation.REYNOLDS, speed=0.0)
    sides = [
        film_at_position(model, (30e-6, -35e-6), (3e-3, -4e-3), Resolution(m, n)).side_flow.sum()
        for m, n in ((4, 96), (8, 384))
    ]
    assert sides[0] == pytest.approx(sides[1], rel=1e-3)
