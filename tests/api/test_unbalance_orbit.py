"""The example of a time integration with the force of the film, against the linear response."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def example():
    spec = importlib.util.spec_from_file_location("unbalance_orbit", ROOT / "examples" / "unbalance_orbit.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def result(example):
    return example.bearing().solve()


def difference(example, result, unbalance, start):
    linear = example.linear_amplitude(result.stiffness, result.damping, unbalance)
    found = example.amplitude_of(*example.orbit(result.film, unbalance, start * linear))
    return np.abs(found - linear) / np.abs(linear)


def test_the_orbit_of_a_small_unbalance_is_the_linear_response(example, result):
    """In amplitude and phase, be it begun on the orbit or at rest."""
    assert difference(example, result, 0.005, 1.0).max() < 0.01
    assert difference(example, result, 0.005, 0.0).max() < 0.01


def test_a_large_orbit_leaves_it(example, result):
    assert difference(example, result, 0.05, 1.0).max() > 0.03


def test_the_weight_is_carried_where_the_journal_rests(example, result):
    force = result.film.force(*result.film.position)
    assert force == pytest.approx([0.0, example.MASS * example.GRAVITY], abs=1e-3 * example.MASS * example.GRAVITY)
