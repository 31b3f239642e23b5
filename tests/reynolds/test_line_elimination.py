"""The elimination from line to line, closed to a ring or open, against the same matrix solved densely."""

import math
from dataclasses import replace

import numpy as np
import pytest
from numba import njit

from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm, Land, Pocket, grooved_bore
from babbitt.reynolds.scales import Scales
from babbitt.reynolds.surface._surface import couple_lines, fill_lines, solve_surface
from babbitt.reynolds.surface.surface_equilibrium import Effort, SurfaceState
from babbitt.reynolds.surface.unwrapped_mesh import build_ring

RING = JournalFilm(
    0.1, 0.07, 80e-6, 0.02, 300.0, (Land(0.0, 2.0 * math.pi),), film_start=FilmStart.PERIODIC,
    pockets=(Pocket(2.0, 0.5, 0.03, pressure=1e5), Pocket(5.0, 0.4, 0.05, pressure=2e5)),
    misalignment=(1e-4, -2e-4),
)  # fmt: skip
LANDS = replace(RING, lands=grooved_bore((0.0, 2.5), 0.4, 1e5), film_start=FilmStart.GROOVE, pockets=())
SEVEN = replace(LANDS, misalignment=(0.0, 0.0))
FIVE = replace(SEVEN, lands=grooved_bore((0.0, 2.5), 0.4))
AT = np.array([0.3, -0.5])
CLOSE = 1e-9
"""Of the largest entry: two ways of elimination in double precision."""


@njit
def fill(surface, film, work):
    couple_lines(surface, film, work)
    fill_lines(surface, film, work)


@njit
def solve(surface, film, work):
    solve_surface(surface, film, work)


def settled(film):
    """A film whose wet set has found its place at a position."""
    ring = build_ring(film, Scales.of(film, film.angular_speed).pressure, 48, 4, None)
    sample = SurfaceState.of(ring, Effort(math.inf))
    assert any(sample.evaluate(AT) == 0 for _ in range(60))
    return sample


def dense(work):
    """Matrix of all nodes: blocks of the lines, each coupled with the line before it by two diagonals."""
    lines, nodes = work.wet.shape
    matrix = np.zeros((lines, nodes, lines, nodes))
    every = np.arange(nodes)
    for line in range(lines):
        matrix[line, :, line, :] += work.inverse[line]
        matrix[line, every, line - 1, every] += work.lower[line]
        matrix[line - 1, every, line, every] += work.upper[line]
    return matrix.reshape(lines * nodes, lines * nodes)


@pytest.mark.parametrize("cavitation", [Cavitation.REYNOLDS, Cavitation.MASS_CONSERVING])
@pytest.mark.parametrize("film", [RING, LANDS, SEVEN, FIVE], ids=["ring", "lands", "seven nodes", "five nodes"])
def test_pressure_and_adjoints_are_those_of_the_dense_matrix(film, cavitation):
    sample = settled(replace(film, cavitation=cavitation))
    surface, work = sample.ring.surface, sample.work
    assert surface.cyclic == (film is RING)
    assert film not in (SEVEN, FIVE) or surface.nodes == (7 if film == SEVEN else 5)  # which are unrolled
    assert 0 < work.wet.sum() < work.wet.size  # part of it is ruptured
    fill(surface, sample.film, work)
    matrix, right = dense(work), work.swept.reshape(len(work.swept), -1).copy()
    solve(surface, sample.film, work)
    found = work.solution.reshape(len(right), -1)
    for system, sources, answers in ((matrix, right[:1], found[:1]), (matrix.T, right[1:], found[1:])):
        expected = np.linalg.solve(system, sources.T).T
        assert np.abs(expected).max(axis=1).min() > 0.0
        assert np.abs(answers - expected).max() < CLOSE * np.abs(expected).max()
