"""What a search for a fixed point learns shortens the next one, and never decides where it ends."""

import numpy as np
import pytest

from babbitt.numerics.anderson import AndersonOptions, fixed_point
from babbitt.numerics.secants import RecycledSecants

OPTIONS = AndersonOptions(60, damping=0.6, astray=5.0)
SIZE = 12
SLOPE = np.random.default_rng(5).normal(size=(SIZE, SIZE))
"""Eigenvalues up to about 4 in size: plain iteration runs away."""


def close(_, residual):
    return bool(np.abs(residual).max() < 1e-9)


def searched(secants, slope=SLOPE, bend=0.0, forced=1.0):
    """Fixed point of x -> A x + b + bend x^2 / 2, and how many states it took."""
    given = forced * np.cos(np.arange(SIZE))
    return fixed_point(
        lambda state: slope @ state + given + 0.5 * bend * state**2 - state, close, np.zeros(SIZE), OPTIONS,
        secants=secants,
    )  # fmt: skip


def test_a_linear_map_is_solved_by_one_state_more_than_it_has_unknowns():
    secants = RecycledSecants(OPTIONS.damping, OPTIONS.astray)
    found = searched(secants)
    assert found.converged
    assert found.evaluations <= SIZE + 2
    assert found.state == pytest.approx(np.linalg.solve(np.eye(SIZE) - SLOPE, np.cos(np.arange(SIZE))), abs=1e-8)
    again = searched(secants, forced=-3.0)
    assert again.converged
    assert again.evaluations <= 3
    assert again.state == pytest.approx(-3.0 * found.state, abs=1e-8)


def test_a_map_that_differs_a_little_takes_few_states():
    secants = RecycledSecants(OPTIONS.damping, OPTIONS.astray)
    searched(secants)
    other = 1.002 * SLOPE
    fresh = searched(RecycledSecants(OPTIONS.damping, OPTIONS.astray), other, bend=0.01)
    known = searched(secants, other, bend=0.01)
    assert known.converged
    assert known.evaluations <= 0.6 * fresh.evaluations
    assert known.state == pytest.approx(fresh.state, abs=1e-7)


def test_a_map_that_is_another_one_is_solved_nevertheless():
    """Secants of its opposite mislead; they are forgotten."""
    secants = RecycledSecants(OPTIONS.damping, OPTIONS.astray)
    searched(secants)
    found = searched(secants, -0.5 * SLOPE)
    assert found.converged
    assert found.state == pytest.approx(
        np.linalg.solve(np.eye(SIZE) + 0.5 * SLOPE, np.cos(np.arange(SIZE))), abs=1e-8
    )


def test_what_is_undone_is_as_if_it_had_not_been():
    secants = RecycledSecants(OPTIONS.damping, OPTIONS.astray)
    searched(secants)
    secants.undo()
    assert searched(secants).evaluations == searched(RecycledSecants(OPTIONS.damping, OPTIONS.astray)).evaluations
    first = searched(secants, bend=0.02)
    secants.undo()
    searched(secants, 1.1 * SLOPE)
    secants.undo()
    again = searched(secants, bend=0.02)
    assert again.evaluations == first.evaluations
    assert np.array_equal(again.state, first.state)
