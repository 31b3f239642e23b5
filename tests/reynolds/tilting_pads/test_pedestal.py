"""A bearing on a pedestal: springs in series, dynamic stiffness in series, pads that move with the housing."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scaled_pads import FOUR_LOAD, LEVER, bearing, four_pads, pad

from babbitt.core.notices import InputError
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.tilting_pads.dynamics import condensed_at, full_coefficients, impedance
from babbitt.reynolds.tilting_pads.pedestal import Pedestal, on_pedestal, way_of_gravity
from babbitt.reynolds.tilting_pads.pivots import SpringPivot
from babbitt.reynolds.tilting_pads.rotor import rotor_modes
from babbitt.reynolds.tilting_pads.solve import solve_tilting_pads

GRID = Resolution(4, 48)
FOUR = solve_tilting_pads(four_pads(inertia=0.05 * LEVER**2), FOUR_LOAD, GRID)
PADS = full_coefficients(FOUR)
SOFT = Pedestal((15.0, 25.0), (2.0, 3.0), 0.4)


def test_a_very_stiff_pedestal_changes_nothing():
    held = on_pedestal(PADS, FOUR.bearing, Pedestal((1e13, 1e13), mass=1.0))
    for ratio in (0.0, 0.5, 1.0):
        one, two = condensed_at(held, ratio), condensed_at(PADS, ratio)
        assert one.stiffness == pytest.approx(two.stiffness, abs=1e-9)
        assert one.damping == pytest.approx(two.damping, abs=1e-9)


def test_springs_in_series_at_rest():
    found = condensed_at(on_pedestal(PADS, FOUR.bearing, SOFT), 0.0)
    alone = condensed_at(PADS, 0.0)
    flexible = np.linalg.inv(alone.stiffness) + np.diag(1.0 / np.array(SOFT.stiffness))
    assert np.linalg.inv(found.stiffness) == pytest.approx(flexible, rel=1e-10, abs=1e-12)
    # slow motion: each spring passes the damping of its share of the way, S^T C S with S = K_i^-1 K
    pads, pedestal = (np.linalg.solve(k, found.stiffness) for k in (alone.stiffness, np.diag(SOFT.stiffness)))
    back = (np.linalg.solve(k.T, found.stiffness.T) for k in (alone.stiffness, np.diag(SOFT.stiffness)))
    left, right = back
    expected = left.T @ alone.damping @ pads + right.T @ np.diag(SOFT.damping) @ pedestal
    assert found.damping == pytest.approx(expected, rel=1e-10, abs=1e-12)


@pytest.mark.parametrize("frequency", [0.3, 1.0, 2.0, 6.5])
def test_dynamic_stiffness_in_series(frequency):
    """Pads on rigid pivots through their centres of gravity: their mass is part of the pedestal's."""
    heavy = tuple(replace(one, mass=0.1) for one in FOUR.bearing.pads)
    found = impedance(on_pedestal(PADS, replace(FOUR.bearing, pads=heavy), SOFT), frequency)
    pedestal = np.diag(
        [k + 1j * frequency * c - frequency**2 * 0.8 for k, c in zip(SOFT.stiffness, SOFT.damping, strict=True)]
    )
    expected = np.linalg.inv(impedance(PADS, frequency)) + np.linalg.inv(pedestal)
    assert np.linalg.inv(found) == pytest.approx(expected, rel=1e-9)


def test_a_rotor_on_a_soft_pedestal_swings_as_on_that_spring():
    """The film far stiffer than the pedestal, the rotor far heavier than the housing."""
    held = on_pedestal(PADS, FOUR.bearing, Pedestal((1e-4, 4e-4)))
    slow = sorted(mode.frequency for mode in rotor_modes(held, 100.0) if 0.0 < mode.frequency < 0.01)
    assert slow == pytest.approx([1e-3, 2e-3], rel=1e-4)


def test_centres_of_gravity_turn_about_the_pivots():
    """The way of a point of the pad, found by turning it."""
    for sense in (1.0, -1.0):
        own = pad(40.0, 70.0, 0.5, 0.3, law=SpringPivot(20.0), mass=0.3, inertia=0.5, mass_offset=0.05,
                  mass_inset=0.07)  # fmt: skip
        pads = bearing((own,), 0.7, speed=sense)
        normal, tangent = own.normal(), own.tangent()
        at = sense * own.mass_offset * tangent - own.mass_inset * normal  # from the pivot
        turn = 1e-6
        c, s = math.cos(turn), math.sin(turn)
        moved = (np.array([[c, -s], [s, c]]) @ at - at) / (turn * pads.lever(own))
        assert way_of_gravity(pads, own, "tilt") == pytest.approx(moved, rel=1e-5)
        assert way_of_gravity(pads, own, "pivot") == pytest.approx(normal)
        assert way_of_gravity(pads, own, "tangential") == pytest.approx(tangent)


def test_pads_with_a_point_mass_push_the_housing_with_all_their_momentum():
    """A pad whose inertia is that of its mass alone takes no energy from a motion in which that stays in place."""
    own = {"law": SpringPivot(20.0), "mass": 0.3, "mass_offset": 0.04}
    pads = four_pads(inertia=0.3 * 0.04**2, **own)
    solution = solve_tilting_pads(pads, FOUR_LOAD, GRID)
    held = on_pedestal(full_coefficients(solution), solution.bearing, Pedestal((15.0, 25.0), mass=0.4))
    values = np.linalg.eigvalsh(held.mass)
    assert values == pytest.approx(np.linalg.eigvalsh(held.mass.T))
    assert values.min() > -1e-12
    still = np.zeros(len(held.labels))
    still[-2] = 1.0  # the housing moves along x, pivots give way against it, and the pads stay
    for place, label in enumerate(held.labels[:-2]):
        if label.endswith("pivot"):
            number = int(label.split()[1]) - 1
            still[place] = -pads.pads[number].normal()[0]
    along = sum(0.3 * one.tangent()[0] ** 2 for one in pads.pads)  # rigid along tau
    assert still @ held.mass @ still == pytest.approx(0.4 + along)


def test_the_deflection_is_the_load_over_the_stiffness():
    assert SOFT.deflection((3.0, -5.0)) == pytest.approx((0.2, -0.2))


@pytest.mark.parametrize(
    "wrong", [{"stiffness": (0.0, 1.0)}, {"stiffness": (1.0, 1.0), "damping": (-1.0, 0.0)},
              {"stiffness": (1.0, 1.0), "mass": -1.0}],
)  # fmt: skip
def test_impossible_pedestals_are_refused(wrong):
    with pytest.raises(InputError, match="pedestal"):
        Pedestal(**wrong)
