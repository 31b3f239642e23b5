"""Splines and piecewise cubics against scipy and against their own inverse."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.interpolate import CubicSpline, RectBivariateSpline

from babbitt.numerics.piecewise_cubic import PiecewiseCubic
from babbitt.numerics.spline import spline_coefficients
from babbitt.numerics.tensor_spline import TensorSpline

NODES = np.array([-3.0, -2.1, -1.9, -0.4, 0.0, 0.7, 2.0, 2.2, 3.5])
OTHER_NODES = np.array([0.0, 0.3, 1.0, 1.1, 2.0, 2.6])


def test_spline_is_scipys_not_a_knot_spline():
    values = np.sin(NODES) + NODES**2
    expected = CubicSpline(NODES, values).c[::-1]
    assert_allclose(spline_coefficients(NODES) @ values, expected, rtol=1e-11, atol=1e-11)


def test_tensor_spline_is_scipys_bicubic_spline():
    first, second = np.meshgrid(NODES, OTHER_NODES, indexing="ij")
    values = np.stack([np.exp(0.3 * first) * np.cos(second), first * second**2])
    spline = TensorSpline(NODES, OTHER_NODES, values)
    places = np.random.default_rng(7).uniform([-3.0, 0.0], [3.5, 2.6], (50, 2)).T
    for index in range(2):
        expected = RectBivariateSpline(NODES, OTHER_NODES, values[index]).ev(*places)
        assert_allclose(spline.at_many(index, *places), expected, rtol=1e-11, atol=1e-12)
        on_cuts = [spline.cut(float(y))[index].at(float(x)) for x, y in places.T]
        assert_allclose(on_cuts, expected, rtol=1e-11, atol=1e-12)


@pytest.mark.parametrize("nodes", [[0.0, 1.0, 2.0], [0.0, 1.0, 1.0, 2.0], [0.0, 2.0, 1.0, 3.0]])
def test_nodes_must_be_four_and_increasing(nodes):
    with pytest.raises(ValueError, match="strictly increasing"):
        spline_coefficients(np.array(nodes))


@pytest.mark.parametrize("function", [np.sinh, lambda t: t**3 + 1e-3 * t, lambda t: np.arctan(4 * t)])
def test_inverse_of_a_steep_or_flat_cubic_is_found(function):
    # flat or steep within an interval: Newton alone would leave the bracket
    nodes = np.linspace(-2.0, 2.0, 16)
    cubic = PiecewiseCubic(nodes, spline_coefficients(nodes) @ function(nodes))
    places = np.linspace(-2.0, 2.0, 401)
    levels = cubic.at_many(places)
    assert (np.diff(levels) > 0).all()
    assert_allclose(cubic.at_many(cubic.places_of(levels)), levels, rtol=1e-12, atol=1e-13)
    assert_allclose([cubic.at(cubic.place_of(float(level))) for level in levels], levels, rtol=1e-12, atol=1e-13)
