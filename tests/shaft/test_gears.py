"""Tooth forces against hand calculations, rules of thumb of hands, and mirror images."""

import math
from dataclasses import replace

import numpy as np
import pytest
from shafts import rigid

from babbitt.kinds.shaft.answer import answered
from babbitt.kinds.shaft.gears import Gear, Helix
from babbitt.kinds.shaft.model import Shaft, Support

WHEEL = Gear("Wheel", 0.09, 0.3, math.radians(20.0), math.radians(12.0), Helix.RIGHT, math.radians(90.0), 1200.0)


def test_the_tooth_force_of_a_hand_calculation():
    """F_t = 2 · 1200 / 0.3 = 8000 N, F_r = 8000 tan 20° / cos 12° = 2976.8 N, F_a = 8000 tan 12° = 1700.5 N."""
    size = WHEEL.tooth_force()
    assert (size.tangential, size.radial, size.axial) == pytest.approx((8000.0, 2976.8, 1700.5), abs=0.05)


def test_the_force_on_a_driven_wheel_below_its_pinion():
    """Turning counter-clockwise, its upper side goes to -x: the pinion pushes it there, and down."""
    load = WHEEL.load()
    assert load.force == pytest.approx((-8000.0, -2976.8, -1700.5), abs=0.05)
    assert load.moment == pytest.approx((0.15 * -1700.5, 0.0, 1200.0), abs=0.05)


@pytest.mark.parametrize("turn", [1.0, -1.0])
@pytest.mark.parametrize("helix", [Helix.RIGHT, Helix.LEFT])
def test_the_thumb_shows_the_thrust_of_a_driver(turn, helix):
    """Fingers along the rotation, right hand for a right-hand helix: the thumb shows the thrust on the driver.

    Shigley, ch. 13; a driver takes torque against its rotation.
    """
    driver = replace(WHEEL, torque=-1200.0 * turn, helix=helix)
    right = helix is Helix.RIGHT
    assert math.copysign(1.0, driver.load().force[2]) == (turn if right else -turn)


def test_a_pair_of_gears_is_in_equilibrium():
    """What pinion and wheel do to each other is equal and opposite at the pitch point.

    They have hands of the other sense and torques in the ratio of their diameters.
    """
    pinion = replace(
        WHEEL, diameter=0.1, mesh_angle=WHEEL.mesh_angle + math.pi, torque=400.0, helix=Helix.LEFT
    ).load()
    wheel = WHEEL.load()
    assert np.add(pinion.force, wheel.force) == pytest.approx(0.0, abs=1e-9)
    apart = 0.5 * (0.1 + 0.3)  # from the axis of the wheel up to that of the pinion
    moment = np.add(pinion.moment, wheel.moment) + np.cross((0.0, apart, 0.0), pinion.force)
    assert moment == pytest.approx(0.0, abs=1e-9)


def test_a_double_helix_has_no_thrust():
    double = replace(WHEEL, helix=Helix.DOUBLE)
    assert double.load().force[2] == 0.0
    assert double.tooth_force().radial == WHEEL.tooth_force().radial


def test_a_shaft_of_a_hand_calculation():
    """One wheel between two bearings, moments about bearing 1 by hand.

    Horizontal: 8000 · 90/300 = 2400 N on the far bearing. Vertical: the radial force gives 2976.8 · 90/300 =
    893.0 N downward, the couple 1700.5 · 0.15 = 255.07 N m gives 850.2 N; its force points to -z above the axis,
    which lifts the far side: 893.0 - 850.2 = 42.8 N.
    """
    shaft = Shaft((Support("A", 0.0, axial=True), Support("B", 0.3)), (WHEEL.load(),))
    forces = answered(shaft).bearing_forces
    assert forces[1] == pytest.approx([-2400.0, -42.8, 0.0], abs=0.1)
    assert forces[0] == pytest.approx([-5600.0, -2934.0, -1700.5], abs=0.1)


def mirrored(gear):
    """The gear of the mirror image at the plane y-z: the sense of rotation and the hand change."""
    other = {Helix.RIGHT: Helix.LEFT, Helix.LEFT: Helix.RIGHT, Helix.DOUBLE: Helix.DOUBLE}[gear.helix]
    return replace(gear, helix=other, mesh_angle=math.pi - gear.mesh_angle, torque=-gear.torque)


@pytest.mark.parametrize("mesh_angle", np.radians([0.0, 35.0, 90.0, 200.0, -70.0]))
def test_the_mirror_image_turns_the_other_way(mesh_angle):
    gear = replace(WHEEL, mesh_angle=float(mesh_angle))
    supports = rigid(0.0, 0.3)
    one = answered(Shaft(supports, (gear.load(),))).bearing_forces
    other = answered(Shaft(supports, (mirrored(gear).load(),))).bearing_forces
    assert other == pytest.approx(one * [-1.0, 1.0, 1.0], abs=1e-9)


def test_astern_turns_the_tangential_and_axial_force_alone():
    """With the same roles torque, tangential force and thrust change sign; the radial force stays."""
    ahead, astern = WHEEL.load(), replace(WHEEL, torque=-WHEEL.torque).load()
    assert np.add(ahead.force, astern.force) == pytest.approx((0.0, -2.0 * 2976.8, 0.0), abs=0.1)
