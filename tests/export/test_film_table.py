"""Solved films become a table: sorted by speed, in one frame, unsolved ones refused."""

import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.export import Rotation, coefficient_table, in_load_frame, mirrored
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.model import JournalFilm, grooved_bore

FILM = JournalFilm(0.1, 0.06, 80e-6, 0.02, 200.0, grooved_bore((0.0, math.pi), 0.3))
LOAD = (1500.0, -6000.0)


@pytest.fixture(scope="module")
def solutions():
    return [solve_journal(replace(FILM, angular_speed=speed), LOAD) for speed in (300.0, 100.0, 200.0)]


def test_rows_are_sorted_by_speed_and_carry_their_equilibrium(solutions):
    table = coefficient_table("Pump", solutions)
    assert_allclose(table.speeds, [100.0, 200.0, 300.0], rtol=0.0)
    assert_allclose(table.stiffness[0], solutions[1].stiffness, rtol=0.0)
    assert_allclose(table.damping[2], solutions[0].damping, rtol=0.0)
    assert_allclose(table.static["load"], math.hypot(*LOAD), rtol=2e-6)
    assert np.all(np.diff(table.static["eccentricity_ratio"]) < 0.0)  # the faster, the nearer to the middle
    assert table.frame.rotation is Rotation.COUNTER_CLOCKWISE
    assert_allclose(table.frame.load_angle, math.atan2(LOAD[1], LOAD[0]), atol=2e-5)
    assert table.method == "Babbitt film, mass conserving cavitation"


def test_the_mirror_of_the_film_is_the_mirror_of_the_table(solutions):
    """The bearing of opposite hand, solved anew, against the table seen from the other end."""
    lands = tuple(
        replace(land, start_angle=math.pi - land.end_angle, end_angle=math.pi - land.start_angle)
        for land in FILM.lands
    )
    opposite = [
        solve_journal(replace(FILM, angular_speed=-speed, lands=lands), (-LOAD[0], LOAD[1]))
        for speed in (100.0, 200.0, 300.0)
    ]
    ours, theirs = coefficient_table("Pump", opposite), mirrored(coefficient_table("Pump", solutions))
    assert ours.frame.rotation is theirs.frame.rotation is Rotation.CLOCKWISE
    assert_allclose(ours.frame.load_angle, theirs.frame.load_angle, atol=1e-9)
    assert_allclose(ours.stiffness, theirs.stiffness, rtol=1e-5)
    assert_allclose(ours.damping, theirs.damping, rtol=1e-5)
    # in the frame of the load both are one bearing
    assert_allclose(in_load_frame(ours).stiffness, in_load_frame(theirs).stiffness, rtol=1e-5)


def test_what_cannot_be_one_table_is_refused(solutions):
    with pytest.raises(InputError, match="no solved film"):
        coefficient_table("Pump", [])
    lost = replace(solutions[0], outcome=Outcome.NOT_CONVERGED)
    with pytest.raises(InputError, match="no equilibrium at 2865 rpm"):
        coefficient_table("Pump", [lost, solutions[1]])
    for other in (replace(solutions[0], force=-solutions[0].force), solve_journal(
        replace(FILM, angular_speed=-300.0), LOAD
    )):  # fmt: skip
        with pytest.raises(InputError, match="differ"):
            coefficient_table("Pump", [other, solutions[1]])
