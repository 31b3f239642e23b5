"""Free motions of a rotor among pads: tables of an independent program, pads without inertia, thresholds."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scaled_pads import FOUR_LOAD, LEVER, bearing, four_pads, pad
from test_pad_tables import supported

from babbitt.core.notices import InputError
from babbitt.reynolds.model import Resolution
from babbitt.reynolds.stability.rotor import critical_mass_of_rotor
from babbitt.reynolds.tilting_pads.dynamics import (
    PadCoefficients,
    condensed_at,
    full_coefficients,
    impedance,
    reduced_coefficients,
)
from babbitt.reynolds.tilting_pads.pivots import SpringPivot
from babbitt.reynolds.tilting_pads.rotor import (
    rotor_modes,
    threshold_cross_coupling,
    threshold_inertia,
    threshold_mass,
    with_cross_coupling,
    with_inertia,
)
from babbitt.reynolds.tilting_pads.solve import solve_tilting_pads

GRID = Resolution(4, 96)
HEAVY = full_coefficients(solve_tilting_pads(four_pads(inertia=0.05 * LEVER**2), FOUR_LOAD, GRID))
LIGHT = full_coefficients(solve_tilting_pads(four_pads(), FOUR_LOAD, GRID))

MOTIONS = {
    5.0: ((-0.471206, 0.896026), (-0.569098, 0.855802)),
    20.0: ((-0.160953, 0.587270), (-0.314243, 0.883098)),
    100.0: ((-0.033903, 0.280519), (-0.066932, 0.448455)),
}


@pytest.mark.parametrize("mass", list(MOTIONS))
def test_motions_of_rotor_and_pads(mass):
    for mode, (growth, frequency) in zip(rotor_modes(HEAVY, mass), MOTIONS[mass], strict=False):
        assert (mode.growth, mode.frequency) == pytest.approx((growth, frequency), abs=2e-6)
        assert mode.stable
        assert mode.log_decrement == pytest.approx(-2.0 * math.pi * growth / frequency, rel=1e-4)


def test_pads_without_inertia_have_motions_of_first_order():
    modes = rotor_modes(LIGHT, 20.0)
    assert [(mode.growth, mode.frequency) for mode in modes[:2]] == [
        pytest.approx((-0.166595, 0.588555), abs=2e-6), pytest.approx((-0.324665, 0.893151), abs=2e-6),
    ]  # fmt: skip
    assert len(modes) == 2 + 4  # two of the rotor, one of every pad
    assert all(mode.frequency == 0.0 and math.isinf(mode.log_decrement) for mode in modes[2:])


def test_little_inertia_comes_close_to_none_with_its_first_power():
    none, *some = (
        np.array(
            [complex(mode.growth, mode.frequency) for mode in rotor_modes(with_inertia(LIGHT, size), 20.0)[:6]]
        )
        for size in (0.0, 1e-6 * LEVER**2, 1e-7 * LEVER**2)
    )
    assert len(none) == 6
    more, less = (np.abs(one - none) for one in some)
    assert less == pytest.approx(0.1 * more, rel=0.01)
    assert (more < 2e-5 * np.abs(none)).all()


def test_pads_on_springs():
    modes = rotor_modes(full_coefficients(solve_tilting_pads(supported(20.0), FOUR_LOAD, GRID)), 20.0)
    assert [(mode.growth, mode.frequency) for mode in modes[:2]] == [
        pytest.approx((-0.106094, 0.727093), abs=3e-6), pytest.approx((-0.107563, 0.543167), abs=3e-6),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("mass", "inertia", "frequency"),
    [(5.0, 7.254118, 0.317340), (20.0, 4.964790, 0.364578), (100.0, 8.927669, 0.246981)],
)
def test_heavy_pads_flutter(mass, inertia, frequency):
    found = threshold_inertia(LIGHT, mass, 0.01 * LEVER**2, 100.0 * LEVER**2)
    assert found.value / LEVER**2 == pytest.approx(inertia, rel=1e-5)
    assert found.frequency == pytest.approx(frequency, rel=1e-5)
    at = rotor_modes(with_inertia(LIGHT, found.value), mass)[0]
    assert at.growth == pytest.approx(0.0, abs=1e-8)


def test_symmetric_condensed_coefficients_know_no_critical_mass():
    condensed = condensed_at(LIGHT, 1.0)
    assert math.isinf(critical_mass_of_rotor(condensed.stiffness, condensed.damping))
    assert math.isinf(threshold_mass(LIGHT, 1.0, 1e4).value)


def pendulum(stiffness, damping):
    """Journal without pads."""
    return PadCoefficients(
        ("x", "y"),
        np.zeros((2, 2)),
        np.asarray(stiffness, dtype=float),
        np.asarray(damping, dtype=float),
        np.ones(2),
        1.0,
    )


def test_a_journal_without_pads_swings_as_an_oscillator():
    modes = rotor_modes(pendulum(np.diag([4.0, 9.0]), 0.2 * np.eye(2)), 1.0)
    for mode, square in zip(sorted(modes, key=lambda mode: mode.frequency), (4.0, 9.0), strict=True):
        assert mode.growth == pytest.approx(-0.1)
        assert mode.frequency == pytest.approx(math.sqrt(square - 0.01))
        assert mode.whirl == pytest.approx(0.0, abs=1e-9)
        assert mode.share == pytest.approx(1.0)


def test_cross_stiffness_drives_a_forward_whirl_beyond_a_mass():
    k, q, c = 4.0, 1.5, 1.0  # the forward whirl has lambda = j w with k = m w^2 and q = c w
    driven = pendulum([[k, q], [-q, k]], c * np.eye(2))
    found = threshold_mass(driven, 0.1, 100.0)
    assert found.value == pytest.approx(k * c**2 / q**2, rel=1e-7)
    assert found.frequency == pytest.approx(q / c, rel=1e-7)
    worst = rotor_modes(driven, 1.1 * found.value)[0]
    assert worst.forward
    assert worst.whirl == pytest.approx(1.0)
    assert not rotor_modes(replace(driven, sense=-1.0), 1.1 * found.value)[0].forward
    assert critical_mass_of_rotor(driven.stiffness, driven.damping) == pytest.approx(found.value, rel=1e-7)


def test_an_undamped_journal_has_no_threshold():
    """Its motions neither grow nor die away, whatever round-off makes of them."""
    rng = np.random.default_rng(3)
    for _ in range(20):
        turn = np.linalg.qr(rng.normal(size=(2, 2)))[0]
        held = pendulum(turn @ np.diag(10.0 ** rng.uniform(-2.0, 8.0, 2)) @ turn.T, np.zeros((2, 2)))
        assert all(mode.stable for mode in rotor_modes(held, 3.0))
        assert math.isinf(threshold_mass(held, 1e-2, 1e4).value)
    assert threshold_mass(pendulum([[4.0, 1.0], [-1.0, 4.0]], np.zeros((2, 2))), 1e-2, 1e2).value == 0.0


def test_a_direction_that_nothing_holds_does_not_grow():
    turn = np.array([[math.cos(0.3), -math.sin(0.3)], [math.sin(0.3), math.cos(0.3)]])
    loose = pendulum(turn @ np.diag([4.0, 0.0]) @ turn.T, turn @ np.diag([1.0, 0.0]) @ turn.T)
    assert all(mode.stable for mode in rotor_modes(loose, 2.0))


def test_motions_of_very_stiff_pivots_are_those_of_rigid_ones():
    stiff = four_pads(inertia=0.05 * LEVER**2, law=SpringPivot(1e12), mass=1e-3)
    modes = rotor_modes(full_coefficients(solve_tilting_pads(stiff, FOUR_LOAD, GRID)), 20.0)
    slow = [mode for mode in modes if mode.frequency < 1e3]
    rigid = rotor_modes(HEAVY, 20.0)
    assert len(slow) == len(rigid)
    for one, two in zip(slow, rigid, strict=True):
        assert (one.growth, one.frequency) == pytest.approx((two.growth, two.frequency), abs=2e-6)


def test_a_clockwise_bearing_whirls_in_its_own_sense():
    mirrored = replace(HEAVY, sense=-1.0)
    for one, two in zip(rotor_modes(HEAVY, 20.0), rotor_modes(mirrored, 20.0), strict=True):
        assert two.whirl == pytest.approx(-one.whirl)
    turned = solve_tilting_pads(
        bearing((pad(angle, 75.0, 0.55, 0.4) for angle in (-90, 0, 90, 180)), 0.7, speed=-1.0),
        (FOUR_LOAD[0], -FOUR_LOAD[1]), GRID,
    )  # fmt: skip
    assert full_coefficients(turned).sense == -1.0
    for one, two in zip(rotor_modes(LIGHT, 20.0)[:2], rotor_modes(full_coefficients(turned), 20.0), strict=False):
        assert (two.growth, two.frequency, two.whirl) == pytest.approx((one.growth, one.frequency, one.whirl))


def test_impossible_masses_are_refused():
    with pytest.raises(InputError, match="mass of the rotor"):
        rotor_modes(LIGHT, -1.0)
    with pytest.raises(InputError, match="threshold"):
        threshold_mass(LIGHT, 2.0, 1.0)


@pytest.mark.parametrize("sense", [1.0, -1.0])
@pytest.mark.parametrize("cross", [0.0, 0.4, 1.9, 2.5])
def test_cross_coupling_on_an_isotropic_bearing(sense, cross):
    """Whirl z = x + j y in circles, forward and backward: m lambda^2 + c lambda + k - j q = 0."""
    mass, k, c = 3.0, 4.0, 1.5
    driven = with_cross_coupling(replace(pendulum(k * np.eye(2), c * np.eye(2)), sense=sense), cross)
    found = rotor_modes(driven, mass)
    assert len(found) == 2
    for mode, side in zip(found, (1.0, -1.0), strict=True):
        root = np.sqrt(complex(c * c - 4.0 * mass * (k - 1j * cross)))
        exact = max(((-c + root) / (2.0 * mass), (-c - root) / (2.0 * mass)), key=lambda one: one.imag * side)
        assert (mode.growth, mode.frequency) == pytest.approx((exact.real, abs(exact.imag)), rel=1e-9)
        assert mode.log_decrement == pytest.approx(-2.0 * math.pi * exact.real / abs(exact.imag), rel=1e-9)
        if cross > 0.0:
            assert mode.whirl == pytest.approx(side)
    assert found[0].stable == (cross < c * math.sqrt(k / mass))


def test_the_cross_coupling_that_a_rotor_bears_is_its_frequency_times_the_damping():
    mass, k, c = 3.0, 4.0, 1.5
    found = threshold_cross_coupling(pendulum(k * np.eye(2), c * np.eye(2)), mass, 1e-3, 1e3)
    assert found.value == pytest.approx(c * math.sqrt(k / mass), rel=1e-8)
    assert found.frequency == pytest.approx(math.sqrt(k / mass), rel=1e-8)


def test_unequal_stiffness_bears_more_cross_coupling():
    """Characteristic polynomial m^2 s^4 + 2 m c s^3 + (m(k1 + k2) + c^2) s^2 + c(k1 + k2) s + k1 k2 + q^2."""
    mass, c, k1, k2 = 2.0, 0.7, 3.0, 5.0
    found = threshold_cross_coupling(pendulum(np.diag([k1, k2]), c * np.eye(2)), mass, 1e-3, 1e3)
    square = 0.5 * (k1 + k2) / mass  # from the odd powers
    q2 = (mass * (k1 + k2) + c * c) * square - mass**2 * square**2 - k1 * k2
    assert found.value == pytest.approx(math.sqrt(q2), rel=1e-8)
    assert found.frequency == pytest.approx(math.sqrt(square), rel=1e-8)


def test_reduced_coefficients_are_exact_at_their_own_frequency():
    for ratio in (0.5, 1.0):
        reduced = reduced_coefficients(HEAVY, ratio)
        assert reduced.labels == ("x", "y")
        frequency = ratio * HEAVY.speed
        assert impedance(reduced, frequency) == pytest.approx(impedance(HEAVY, frequency), rel=1e-12)


def test_full_and_reduced_agree_on_a_rotor_that_whirls_at_the_reduced_frequency():
    """At its threshold a motion neither grows nor decays, so that coefficients of its frequency are exact."""
    full = threshold_cross_coupling(HEAVY, 100.0, 1e-3, 1e3)
    reduced = reduced_coefficients(HEAVY, full.frequency / HEAVY.speed)
    found = threshold_cross_coupling(reduced, 100.0, 1e-3, 1e3)
    assert (found.value, found.frequency) == pytest.approx((full.value, full.frequency), rel=1e-6)
    synchronous = threshold_cross_coupling(reduced_coefficients(HEAVY, 1.0), 100.0, 1e-3, 1e3)
    assert abs(synchronous.value / full.value - 1.0) > 0.01
