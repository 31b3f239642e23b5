"""Friction numbers against quadrature, published check values and each other."""

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad

from babbitt.kinds.journal.iso7902.characteristics import curves, friction

SPANS = (360, 180, 150, 120, 90)
# B/D = 0.604; film all around, film on the arc; independent computation to five digits
CHECK_VALUES = {
    0.1: [(61.022, 61.022), (61.967, 31.352), (66.903, 28.332), (80.211, 27.312), (115.061, 29.554)],
    0.3: [(18.211, 18.211), (18.549, 10.136), (19.666, 9.191), (22.873, 8.804), (31.709, 9.425)],
    0.5: [(8.696, 8.696), (8.818, 5.458), (9.196, 4.959), (10.207, 4.641), (13.182, 4.759)],
    0.7: [(4.138, 4.138), (4.163, 3.012), (4.269, 2.777), (4.553, 2.565), (5.356, 2.467)],
    0.9: [(1.378, 1.378), (1.375, 1.190), (1.384, 1.140), (1.413, 1.079), (1.500, 1.011)],
}


@pytest.mark.parametrize("eccentricity_ratio", CHECK_VALUES)
@pytest.mark.parametrize("span", SPANS)
def test_check_values(span, eccentricity_ratio):
    shape = curves(span, 0.604)
    load, attitude = shape.sommerfeld_number(eccentricity_ratio), shape.attitude_angle(eccentricity_ratio)
    around, on_arc = CHECK_VALUES[eccentricity_ratio][SPANS.index(span)]
    assert friction.film_around(load, eccentricity_ratio, attitude) == pytest.approx(around, rel=5e-4)
    arc = friction.film_on_arc(load, eccentricity_ratio, attitude, math.radians(span))
    assert arc == pytest.approx(on_arc, rel=5e-4)
    full = friction.of_full_bearing(eccentricity_ratio, curves(360, 0.604))
    assert full == pytest.approx(CHECK_VALUES[eccentricity_ratio][0][0], rel=5e-4)


@pytest.mark.parametrize("eccentricity_ratio", [0.0, 0.3, 0.9, 0.99])
@pytest.mark.parametrize(("span", "attitude"), [(1.2, 0.4), (math.pi, 1.1), (5.0, 0.3), (2 * math.pi, 0.7)])
def test_shear_of_the_arc_is_the_integral_over_the_gap(span, attitude, eccentricity_ratio):
    load = 2.5
    start, end = max(math.pi - attitude - span / 2, 0.0), min(math.pi - attitude + span / 2, 2 * math.pi)
    if span == 2 * math.pi:
        start, end = 0.0, span
    integral, _ = quad(lambda phi: 1 / (1 + eccentricity_ratio * math.cos(phi)), start, end, points=[math.pi])
    expected = integral / (2 * load) + eccentricity_ratio / 2 * math.sin(attitude)
    assert friction.film_on_arc(load, eccentricity_ratio, attitude, span) == pytest.approx(expected, rel=1e-10)


def test_petroff_is_the_limit_of_no_eccentricity():
    # concentric: torque of a film sheared all around, f/psi = pi/So
    assert friction.film_around(0.04, 0.0, 1.5) == pytest.approx(math.pi / 0.04)


def test_arrays_and_numbers_agree():
    shape, full = curves(120, 0.8), curves(360, 0.8)
    eps = np.array([0.05, 0.5, 0.98])
    load, attitude = shape.sommerfeld_number(eps), shape.attitude_angle(eps)
    span = math.radians(120)
    for index, (s, e, b) in enumerate(zip(load.tolist(), eps.tolist(), attitude.tolist(), strict=True)):
        assert_allclose(
            friction.film_around(load, eps, attitude)[index], friction.film_around(s, e, b), rtol=1e-13
        )
        on_arc = friction.film_on_arc(load, eps, attitude, span)[index]
        assert_allclose(on_arc, friction.film_on_arc(s, e, b, span), rtol=1e-13)
        assert_allclose(friction.of_full_bearing(eps, full)[index], friction.of_full_bearing(e, full), rtol=1e-13)


def test_curves_of_an_arc_are_not_taken_for_the_full_bearing():
    with pytest.raises(ValueError, match="180 deg"):
        friction.of_full_bearing(0.5, curves(180, 0.5))
