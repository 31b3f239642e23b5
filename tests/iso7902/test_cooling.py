"""Heat given off by the housing."""

import math

import pytest

from babbitt.design.cooling import (
    STILL_AIR_COEFFICIENT,
    cylindrical_housing_surface,
    heat_transfer_coefficient,
    pedestal_surface,
    surface_in_machine,
)


def test_moving_air_cools_better():
    assert heat_transfer_coefficient(0.0) == heat_transfer_coefficient(1.2) == STILL_AIR_COEFFICIENT
    assert heat_transfer_coefficient(1.21) == pytest.approx(20.2, rel=1e-12)
    assert heat_transfer_coefficient(9.0) == 43.0


def test_cylinder_is_two_rings_and_a_mantle():
    outer, width, bore = 0.4, 0.2, 0.15
    rings = 2.0 * math.pi / 4.0 * (outer**2 - bore**2)
    assert cylindrical_housing_surface(outer, width, bore) == pytest.approx(rings + math.pi * outer * width)


def test_surfaces_grow_with_the_square_of_size():
    for surface in (cylindrical_housing_surface, lambda a, b, _: pedestal_surface(a, b)):
        assert surface(0.6, 0.3, 0.2) == pytest.approx(4.0 * surface(0.3, 0.15, 0.1), rel=1e-12)
    assert surface_in_machine(0.1, 0.2) == pytest.approx(0.3)
    assert surface_in_machine(0.1, 0.2, 20.0) == pytest.approx(0.4)
