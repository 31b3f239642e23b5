"""Bearings solved side by side are those solved one by one, however unlike their neighbours are."""

from __future__ import annotations

import math

import numpy as np
import pytest

from babbitt.reynolds._lanes import LANES
from babbitt.reynolds.equilibrium.solve import solve_journal
from babbitt.reynolds.lands.batch import BatchSolution, solve_batch
from babbitt.reynolds.model import DRAFT, Cavitation, JournalFilm, Resolution, grooved_bore

LANDS = grooved_bore((0.0, math.pi / 2.0, math.pi), math.radians(15.0))
COUNT = 3 * LANES + 1  # the last pools are not full
LOAD = 10.0 ** np.linspace(1.0, 5.5, COUNT)  # from a centred journal to several steps of the load
WIDTH = np.linspace(0.15, 0.05, COUNT)
DOWN = LOAD[:, None] * np.array([0.0, -1.0])
BOTH = (Cavitation.REYNOLDS, Cavitation.MASS_CONSERVING)


def solved(rows: slice | list[int], cavitation: Cavitation, grid: Resolution = DRAFT) -> BatchSolution:
    """Some of the bearings, side by side."""
    return solve_batch(0.2, WIDTH[rows], 150e-6, 0.02, 200.0, DOWN[rows], LANDS, cavitation, grid)


@pytest.mark.parametrize("cavitation", BOTH)
@pytest.mark.parametrize("grid", [DRAFT, Resolution(6, 64)])
def test_lanes_are_single_films(cavitation: Cavitation, grid: Resolution) -> None:
    batch = solved(slice(None), cavitation, grid)
    assert batch.solved.all()
    assert batch.eccentricity_ratio[0] < 0.01
    assert batch.eccentricity_ratio[-1] > 0.95
    for row in range(COUNT):
        film = JournalFilm(0.2, WIDTH[row], 150e-6, 0.02, 200.0, LANDS, cavitation)
        one = solve_journal(film, (0.0, -LOAD[row]), grid)
        assert batch.position[row] == pytest.approx(one.position, rel=1e-9, abs=1e-15)
        assert batch.iterations[row] == one.iterations
        for ours, theirs in ((batch.stiffness[row], one.stiffness), (batch.damping[row], one.damping)):
            assert ours == pytest.approx(theirs, rel=1e-9, abs=1e-9 * np.abs(theirs).max())
        assert batch.side_flow[row] == pytest.approx(one.side_flow.sum(), rel=1e-9)


def test_a_first_line_without_pressure_in_any_lane_is_that_of_a_single_film() -> None:
    lands = grooved_bore((0.0, math.pi), math.radians(20.0))
    load = np.outer(np.linspace(3900.0, 7000.0, LANES), (0.0, -1.0))
    batch = solve_batch(0.06, 0.042, 64.92e-6, 0.01507, 42.2, load, lands, Cavitation.MASS_CONSERVING, DRAFT)
    assert batch.eccentricity_ratio.min() > 0.93
    for row in range(LANES):
        film = JournalFilm(0.06, 0.042, 64.92e-6, 0.01507, 42.2, lands, Cavitation.MASS_CONSERVING)
        one = solve_journal(film, tuple(load[row]), DRAFT)
        assert batch.iterations[row] == one.iterations
        assert batch.position[row] == pytest.approx(one.position, rel=1e-10)


@pytest.mark.parametrize("cavitation", BOTH)
def test_neighbours_tell_in_the_last_digits_only(cavitation: Cavitation) -> None:
    batch, turned = solved(slice(None), cavitation), solved(slice(None, None, -1), cavitation)
    assert turned.position[::-1] == pytest.approx(batch.position, rel=1e-10, abs=1e-17)
    assert (turned.iterations[::-1] == batch.iterations).all()


@pytest.mark.parametrize("cavitation", BOTH)
def test_an_overloaded_neighbour_spoils_nothing(cavitation: Cavitation) -> None:
    load = DOWN.copy()
    load[[1, 6]] *= 1e7
    batch = solve_batch(0.2, WIDTH, 150e-6, 0.02, 200.0, load, LANDS, cavitation, DRAFT)
    assert np.flatnonzero(~batch.solved).tolist() == [1, 6]
    kept = [row for row in range(COUNT) if row not in (1, 6)]
    assert batch.position[kept] == pytest.approx(solved(kept, cavitation).position, rel=1e-10, abs=1e-17)
