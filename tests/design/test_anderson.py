"""Anderson's acceleration: linear maps are solved exactly, and every search ends with a status."""

import math

import numpy as np
import pytest

from babbitt.numerics.anderson import AndersonAccelerator, AndersonOptions, FixedPointStatus, fixed_point

ANGLE, WILD = 0.7, 1.3
TURN = WILD * np.array([[math.cos(ANGLE), -math.sin(ANGLE)], [math.sin(ANGLE), math.cos(ANGLE)]])
"""Eigenvalues outside the unit circle: plain iteration runs away."""
FORCED = np.array([1.0, 2.0])
GOAL = np.linalg.solve(np.eye(2) - TURN, FORCED)


def turned(state):
    return TURN @ state + FORCED - state


def small(_, residual):
    return bool(np.abs(residual).max() < 1e-9)


@pytest.mark.parametrize("damping", [0.3, 0.6, 1.0])
def test_a_linear_map_that_plain_iteration_does_not_solve(damping):
    """Of n unknowns n + 1 states know everything; the next is the fixed point."""
    found = fixed_point(turned, small, np.array([3.0, -1.0]), AndersonOptions(10, damping=damping))
    assert found.status is FixedPointStatus.CONVERGED
    assert found.evaluations <= 5
    assert found.state == pytest.approx(GOAL, abs=1e-8)
    plain = fixed_point(turned, small, np.array([3.0, -1.0]), AndersonOptions(10, memory=0))
    assert plain.status is FixedPointStatus.TOO_MANY_EVALUATIONS
    assert np.linalg.norm(plain.state - GOAL) > 1.0


def test_residuals_of_all_sizes_go_on_to_count():
    """Late differences are not lost beside early ones: entries of all sizes converge to round-off."""
    slope = np.diag([-4.0, -1.5, 0.5])
    target = np.array([1.0, -2.0e-6, 3.0e3])
    found = fixed_point(
        lambda state: slope @ (state - target) + target - state,
        lambda _, residual: bool(np.abs(residual).max() < 1e-10),
        np.zeros(3),
        AndersonOptions(20, damping=0.5),
    )
    assert found.converged
    assert found.state == pytest.approx(target, abs=1e-9)


def test_states_that_tell_the_same_twice_are_left_out():
    """Of states that differ by round-off alone the combination of least norm is taken, not any large one."""
    rng = np.random.default_rng(3)
    weights, options = rng.uniform(0.5, 2.0, 40), AndersonOptions(100, damping=0.3)
    accelerator = AndersonAccelerator(options, weights)
    states, residuals = [], []
    for _ in range(4):
        states.append(rng.normal(size=40))
        residuals.append(rng.normal(size=40))
    states.append(states[-1] + 1e-13)
    residuals.append(residuals[-1] * (1.0 + 1e-15))
    for state, residual in zip(states, residuals, strict=True):
        start, move = accelerator.step(state, residual)
    steps, gains = np.diff(states, axis=0)[:3].T, np.diff(residuals, axis=0)[:3].T
    part = np.linalg.lstsq(gains * weights[:, None], residuals[-1] * weights, rcond=None)[0]
    expected = options.damping * residuals[-1] - (steps + options.damping * gains) @ part
    assert start == pytest.approx(states[-1], abs=1e-15)
    assert move == pytest.approx(expected, abs=1e-8)


def test_a_search_gone_astray_goes_back_to_its_best_state():
    accelerator = AndersonAccelerator(AndersonOptions(100, damping=0.3, astray=5.0))
    accelerator.step(np.array([0.0]), np.array([1.0]))
    accelerator.step(np.array([0.3]), np.array([0.5]))
    start, move = accelerator.step(np.array([5.0]), np.array([95.0]))
    assert start == pytest.approx([0.3])
    assert move == pytest.approx([0.15 * 0.5])


def test_a_map_without_value_is_left_half_way_or_ends_the_search():
    """cos x has its fixed point at 0.739; the map is none above 0.8, where the first step leads."""

    def residual(state):
        return np.cos(state) - state if state[0] < 0.8 else None

    lost = fixed_point(residual, small, np.zeros(1), AndersonOptions(30))
    assert (lost.status, lost.evaluations, lost.state[0]) == (FixedPointStatus.LOST, 2, 0.0)
    found = fixed_point(residual, small, np.zeros(1), AndersonOptions(30, most_failures=3))
    assert found.state == pytest.approx([0.7390851332], abs=1e-8)
    never = fixed_point(lambda _: None, small, np.zeros(1), AndersonOptions(30, most_failures=3))
    assert (never.status, never.evaluations) == (FixedPointStatus.LOST, 1)


def test_a_bound_that_leaves_nothing_ends_the_search():
    found = fixed_point(turned, small, np.zeros(2), AndersonOptions(30), lambda *_: None)
    assert found.status is FixedPointStatus.LOST
