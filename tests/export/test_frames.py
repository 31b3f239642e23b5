"""Changes of frame: what must not change, what changes sign, and the road back."""

import math
from dataclasses import replace

import numpy as np
import pytest
from coefficient_tables import assert_same, table
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from babbitt.core.notices import InputError
from babbitt.export import Frame, Rotation, for_rotor_programs, in_load_frame, mirrored, rotated

ANGLES = st.floats(-7.0, 7.0)


def unit(angle):
    return np.array([math.cos(angle), math.sin(angle)])


def critical_mass(k, c):
    """Mass at the stability limit of a rigid rotor and square of its whirl frequency (Lund 1974)."""
    k_eff = (k[0, 0] * c[1, 1] + k[1, 1] * c[0, 0] - k[0, 1] * c[1, 0] - k[1, 0] * c[0, 1]) / np.trace(c)
    whirl = ((k[0, 0] - k_eff) * (k[1, 1] - k_eff) - k[0, 1] * k[1, 0]) / np.linalg.det(c)
    return k_eff / whirl, whirl


@given(ANGLES)
def test_turning_the_axes_keeps_trace_determinant_and_circulation(angle):
    before = table(mass=np.arange(32.0).reshape(8, 2, 2))
    after = rotated(before, angle)
    for matrices in ("stiffness", "damping", "mass"):
        one, other = getattr(before, matrices), getattr(after, matrices)
        assert_allclose(np.trace(other, axis1=1, axis2=2), np.trace(one, axis1=1, axis2=2), rtol=1e-12)
        scale = np.abs(one).max() ** 2
        assert_allclose(np.linalg.det(other), np.linalg.det(one), rtol=0.0, atol=1e-12 * scale)
        assert_allclose(other[:, 0, 1] - other[:, 1, 0], one[:, 0, 1] - one[:, 1, 0], rtol=1e-9)


@given(ANGLES, ANGLES)
def test_the_work_of_the_film_on_a_motion_does_not_depend_on_the_axes(angle, direction):
    before = table()
    after = rotated(before, angle)
    seen_before, seen_after = unit(direction), unit(direction - angle)
    work = np.einsum("i,nij,j->n", seen_before, before.stiffness, seen_before)
    assert_allclose(np.einsum("i,nij,j->n", seen_after, after.stiffness, seen_after), work, rtol=0.0, atol=1e-3)
    # the load, too, is one arrow in space whatever the axes
    arrow = after.frame.load_angle + after.frame.x_axis_angle - before.frame.load_angle
    assert abs(math.remainder(arrow, 2.0 * math.pi)) < 1e-12


@given(ANGLES)
def test_stability_is_the_same_in_every_frame(angle):
    before = table()
    turned = rotated(before, angle)
    for after in (turned, mirrored(before), mirrored(turned), in_load_frame(before)):
        for i in range(before.speeds.size):
            expected = critical_mass(before.stiffness[i], before.damping[i])
            assert_allclose(critical_mass(after.stiffness[i], after.damping[i]), expected, rtol=1e-9)


@given(ANGLES)
def test_turning_back_gives_the_table_back(angle):
    assert_same(rotated(rotated(table(), angle), -angle), table(), rtol=1e-9)


def test_a_quarter_turn_in_numbers():
    k = np.array([[[1.0, 2.0], [3.0, 4.0]]])
    turned = rotated(table(speeds=1, stiffness=k, damping=k, static={}), math.pi / 2)
    # the new x axis is the old y axis, the new y axis the old -x axis
    assert_allclose(turned.stiffness[0], [[4.0, -3.0], [-2.0, 1.0]], atol=1e-15)
    assert turned.frame.x_axis_angle == math.pi / 2


def test_the_other_end_sees_the_other_rotation_and_the_other_cross_coupling():
    before = table()
    after = mirrored(before)
    assert after.frame.rotation is Rotation.CLOCKWISE
    assert_allclose(after.frame.load_angle, math.radians(-105.0))
    assert_allclose(after.stiffness[:, 0, 1], -before.stiffness[:, 0, 1], rtol=0.0)
    assert_allclose(after.stiffness[:, 1, 0], -before.stiffness[:, 1, 0], rtol=0.0)
    diagonal = np.diagonal(before.damping, axis1=1, axis2=2)
    assert_allclose(np.diagonal(after.damping, axis1=1, axis2=2), diagonal, rtol=0.0)


@given(ANGLES)
def test_looking_from_the_other_end_twice_is_looking_once(angle):
    start = rotated(table(), angle)
    assert_same(mirrored(mirrored(start)), start, rtol=1e-14)


@given(ANGLES)
def test_turning_seen_from_the_other_end_is_turning_back(angle):
    assert_same(mirrored(rotated(table(), angle)), rotated(mirrored(table()), -angle), rtol=1e-9)


def test_frame_of_lund_and_thomsen_for_a_load_straight_down():
    before = table(frame=Frame())
    after = in_load_frame(before)
    assert after.frame.load_angle == 0.0
    for mine, theirs in ((after.stiffness, before.stiffness), (after.damping, before.damping)):
        assert_allclose(mine[:, 0, 0], theirs[:, 1, 1], rtol=1e-14)
        assert_allclose(mine[:, 1, 1], theirs[:, 0, 0], rtol=1e-14)
        assert_allclose(mine[:, 0, 1], -theirs[:, 1, 0], rtol=1e-14)
        assert_allclose(mine[:, 1, 0], -theirs[:, 0, 1], rtol=1e-14)


@given(ANGLES)
def test_in_the_frame_of_the_load_all_views_of_a_bearing_are_one(angle):
    seen_from_front, seen_from_behind = rotated(table(), angle), mirrored(rotated(table(), angle))
    one, other = in_load_frame(seen_from_front), in_load_frame(seen_from_behind)
    assert one.frame.rotation is other.frame.rotation is Rotation.COUNTER_CLOCKWISE
    assert_allclose(one.stiffness, other.stiffness, rtol=1e-9)
    assert_allclose(one.damping, in_load_frame(table()).damping, rtol=1e-9)


def test_without_a_load_direction_there_is_no_frame_of_the_load():
    with pytest.raises(InputError, match="where its load points"):
        in_load_frame(table(frame=Frame(load_angle=None)))


def test_rotor_programs_get_their_axes_back_and_no_clockwise_table():
    start = table()
    assert_same(for_rotor_programs(rotated(start, 0.7)), start, rtol=1e-9)
    assert for_rotor_programs(start) is start
    with pytest.raises(InputError, match="other end"):
        for_rotor_programs(mirrored(start))
    turned = replace(mirrored(start), frame=replace(mirrored(start).frame, rotation=Rotation.COUNTER_CLOCKWISE))
    for_rotor_programs(turned)  # it is the declared rotation that counts
