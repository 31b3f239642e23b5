"""Roots between two bounds, and where the search must give up."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.numerics.roots import bracketed_root, find_root

FUNCTIONS = (
    (lambda x: x**3 - 2.0 * x - 5.0, 2.0, 3.0),
    (lambda x: math.exp(-x) - x, -1.0, 4.0),
    (lambda x: math.atan(x - 0.3), -50.0, 80.0),
    (lambda x: 1.0 if x > 0.7 else -1.0, 0.0, 1.0),
    (lambda x: (x - 1.0) ** 3, 0.0, 3.0),
)


@pytest.mark.parametrize(("function", "low", "high"), FUNCTIONS)
def test_the_function_changes_its_sign_at_the_root(function, low, high):
    calls = []

    def counted(x):
        calls.append(x)
        return function(x)

    root = find_root(counted, low, high, 1e-12)
    assert root.converged
    assert function(root.value - 1e-5) < 0.0 < function(root.value + 1e-5) or (
        function(root.value - 1e-5) > 0.0 > function(root.value + 1e-5)
    )
    assert all(low <= x <= high for x in calls)


@given(st.floats(-10.0, 10.0), st.floats(0.1, 10.0), st.floats(0.1, 10.0))
def test_finds_any_root_of_a_cubic(root, below, above):
    found = bracketed_root(lambda x: (x - root) * (1.0 + (x - root) ** 2), root - below, root + above)
    assert found == pytest.approx(root, abs=1e-12)


@pytest.mark.parametrize("side", [-1.0, 1.0])
@pytest.mark.parametrize(("function", "low", "high"), FUNCTIONS)
def test_a_place_beyond_a_bound_changes_no_root(function, low, high, side):
    place = (low if side < 0.0 else high) + 0.3 * side * (high - low)
    found = find_root(function, low, high, 1e-12, beyond=(place, function(place)))
    assert found.converged
    flat = function is FUNCTIONS[-1][0]  # its value is round-off about the triple root
    assert found.value == pytest.approx(find_root(function, low, high, 1e-12).value, abs=2e-5 if flat else 2e-12)


@pytest.mark.parametrize("side", [-1.0, 1.0])
@pytest.mark.parametrize("curvature", [-0.1, 0.0, 0.1])
def test_a_place_beyond_a_bound_spares_halving(curvature, side):
    """The first step goes near the root of a function that bends little, where it otherwise halves."""

    def bent(x):
        return x + curvature * x * x

    low, high = -0.9, 1.2
    place = (low if side < 0.0 else high) + 0.3 * side
    first = []
    for beyond in (None, (place, bent(place))):
        looked = []
        find_root(lambda x, looked=looked: looked.append(x) or bent(x), low, high, 1e-12, beyond=beyond)
        first.append(abs(looked[2]))  # behind both bounds
    assert first[0] == pytest.approx(0.15)
    assert first[1] < 0.06


def test_a_root_at_a_bound_and_none():
    assert bracketed_root(lambda x: x, 0.0, 1.0) == 0.0
    with pytest.raises(ValueError, match="different signs"):
        bracketed_root(lambda x: 1.0 + x * x, 0.0, 1.0)


def test_steps_are_bounded():
    assert not find_root(lambda x: math.tanh(1e6 * (x - 0.123456)), 0.0, 1.0, most_steps=3).converged


def test_no_number_at_a_bound_is_refused():
    for function in (lambda x: math.nan if x == 0.0 else x, lambda x: math.nan if x == 2.0 else x - 1.0):
        for search in (find_root, bracketed_root):
            with pytest.raises(ValueError, match="must be a number"):
                search(function, 0.0, 2.0)


def test_no_number_between_the_bounds_is_no_root():
    def hollow(x):
        return x - 0.3 if x in (0.0, 1.0) else math.nan

    assert not find_root(hollow, 0.0, 1.0).converged
    with pytest.raises(ValueError, match="without a root"):
        bracketed_root(hollow, 0.0, 1.0)
