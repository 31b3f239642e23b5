"""Coefficients of a film on one fixed grid beside central differences of its forces."""

import math

import numpy as np

from babbitt.reynolds.scales import Scales
from babbitt.reynolds.surface.surface_equilibrium import Effort, SurfaceState
from babbitt.reynolds.surface.unwrapped_mesh import build_ring


def coefficients_and_differences(film, at, axial_unknowns=4, per_turn=192, step=1e-6):
    """Stiffness and damping, each exact and by differences, dimensionless; the wet set settles at every place."""
    ring = build_ring(film, Scales.of(film, film.angular_speed).pressure, per_turn, axial_unknowns, None)
    sample = SurfaceState.of(ring, Effort(math.inf))

    def force_at(place, rate):
        for _ in range(100):
            if sample.evaluate(np.asarray(place, float), np.asarray(rate, float)) == 0:
                return sample.force.copy()
        raise AssertionError("the wet set does not settle")

    stiffness, damping = np.zeros((2, 2)), np.zeros((2, 2))
    still = np.zeros(2)
    for axis, unit in enumerate(np.eye(2)):
        stiffness[:, axis] = (force_at(at - step * unit, still) - force_at(at + step * unit, still)) / (2 * step)
        damping[:, axis] = (force_at(at, -step * unit) - force_at(at, step * unit)) / (2 * step)
    for _ in range(2):  # the adjoints weigh pressures by the viscosity found the time before
        force_at(at, still)
    return (sample.stiffness.copy(), stiffness), (sample.damping.copy(), damping)


def assert_consistent(film, at, bound=1e-6):
    for exact, by_difference in coefficients_and_differences(film, np.asarray(at, float)):
        np.testing.assert_allclose(exact, by_difference, rtol=0.0, atol=bound * np.abs(exact).max())
