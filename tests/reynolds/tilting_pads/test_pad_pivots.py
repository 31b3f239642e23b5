"""Pivots: contacts of Hertz by their closed forms, slopes, tables, refusals."""

import math

import numpy as np
import pytest

from babbitt.core.notices import InputError
from babbitt.reynolds.tilting_pads.pivots import (
    LineContact,
    PointContact,
    RigidPivot,
    RockerContact,
    SpringPivot,
    TablePivot,
    displacement_of,
    stiffness_of,
)

POINT = PointContact(0.100, 0.102)
LINE = LineContact(0.0700, 0.0705, 0.07, 0.02, 0.02)
ROCKER = RockerContact(0.263144)
EVERY = [SpringPivot(17.51e9), POINT, LINE, ROCKER, TablePivot((1e3, 1e4, 1e5), (1e-6, 5e-6, 2e-5))]


def test_a_ball_in_a_hollow_sphere():
    assert POINT.effective_radius == pytest.approx(5.1)
    assert displacement_of(POINT, 5000.0) == pytest.approx(5.9165e-6, rel=1e-5)
    assert stiffness_of(POINT, 5000.0) == pytest.approx(1.267639e9, rel=1e-6)


def test_approach_of_spheres_is_that_of_the_contact_circle():
    a = math.cbrt(0.75 * 5000.0 * POINT.effective_radius / POINT.effective_modulus)  # Johnson, eq. 4.22
    assert displacement_of(POINT, 5000.0) == pytest.approx(a**2 / POINT.effective_radius, rel=1e-12)


def test_a_cylinder_in_a_hollow_one():
    assert LINE.half_width(7000.0) == pytest.approx(3.3002e-3, rel=1e-5)
    assert displacement_of(LINE, 7000.0) == pytest.approx(1.2583e-6, rel=1e-5)
    assert stiffness_of(LINE, 7000.0) == pytest.approx(7.12519e9, rel=1e-6)


def test_the_rocker_law():
    load, length = 112.8e3, ROCKER.length
    assert displacement_of(ROCKER, load) == pytest.approx(1.530451e-10 * load**0.9 / length**0.8)
    assert stiffness_of(ROCKER, load) == pytest.approx(7.26e9 * load**0.1 * length**0.8, rel=1e-5)


@pytest.mark.parametrize("pivot", EVERY, ids=lambda pivot: type(pivot).__name__)
@pytest.mark.parametrize("load", [2.5e3, 4e4])
def test_stiffness_is_the_slope(pivot, load):
    step = 1e-4 * load
    slope = (displacement_of(pivot, load + step) - displacement_of(pivot, load - step)) / (2.0 * step)
    assert stiffness_of(pivot, load) == pytest.approx(1.0 / slope, rel=1e-6)


@pytest.mark.parametrize("pivot", EVERY, ids=lambda pivot: type(pivot).__name__)
def test_displacement_begins_at_zero_and_rises(pivot):
    places = [displacement_of(pivot, load) for load in (0.0, 1.0, 1e2, 1e4, 1e5)]
    assert places[0] == 0.0
    assert np.all(np.diff(places) > 0.0)


def test_a_housing_in_series_adds_its_own_displacement():
    soft = PointContact(0.100, 0.102, housing_stiffness=2e9)
    assert displacement_of(soft, 5000.0) == pytest.approx(displacement_of(POINT, 5000.0) + 5000.0 / 2e9)
    assert 1.0 / stiffness_of(soft, 5000.0) == pytest.approx(1.0 / stiffness_of(POINT, 5000.0) + 1.0 / 2e9)


def test_a_rigid_pivot_stays():
    assert displacement_of(RigidPivot(), 1e6) == 0.0
    assert math.isinf(stiffness_of(RigidPivot(), 1e6))


def test_a_table_goes_on_behind_its_last_point():
    table = TablePivot((1e3, 2e3), (1e-6, 1.5e-6))
    assert displacement_of(table, 3e3) == pytest.approx(2e-6)
    assert displacement_of(table, 500.0) == pytest.approx(0.5e-6)


@pytest.mark.parametrize(
    ("build", "word"),
    [
        (lambda: PointContact(0.1, 0.1), "housing_radius"),
        (lambda: PointContact(0.1, 0.2, poisson_ratio=0.7), "poisson_ratio"),
        (lambda: SpringPivot(0.0), "stiffness"),
        (lambda: LineContact(0.07, 0.08, 0.07, 0.0, 0.02), "depth"),
        (lambda: TablePivot((1e3, 500.0), (1e-6, 2e-6)), "rise"),
        (lambda: TablePivot((1e3,), (1e-6, 2e-6)), "displacements"),
    ],
)
def test_impossible_pivots_are_refused(build, word):
    with pytest.raises(InputError, match=word):
        build()


def test_pressure_of_a_contact_carries_its_load():
    """The ellipsoid of Hertz: P = 2/3 pi a^2 p_0 on a circle, P' = pi/2 b p_0 on a strip."""
    a = math.cbrt(0.75 * 5000.0 * POINT.effective_radius / POINT.effective_modulus)
    assert POINT.contact_pressure(5000.0) * 2.0 / 3.0 * math.pi * a**2 == pytest.approx(5000.0, rel=1e-12)
    b = LINE.half_width(7000.0)
    assert LINE.contact_pressure(7000.0) * 0.5 * math.pi * b * LINE.length == pytest.approx(7000.0, rel=1e-12)


def test_the_rocker_has_the_law_of_palmgren():
    """4.36e-7 Q^0.9/l^0.8 with Q in pounds, l and the displacement in inches."""
    pounds, inches = 900.0, 3.0
    found = displacement_of(RockerContact(inches * 0.0254), pounds * 4.4482216) / 0.0254
    assert found == pytest.approx(4.36e-7 * pounds**0.9 / inches**0.8, rel=1e-6)
