"""Stability figures of hydrostatic and hybrid journal bearings."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from babbitt.case import parse_case, template
from babbitt.kinds.hydrostatic.answer import answer
from babbitt.kinds.hydrostatic.check import hydrostatic_check
from babbitt.kinds.hydrostatic.impedance import impedance
from babbitt.reynolds.stability.rotor import growth_rates
from babbitt.reynolds.stability.whirl_limits import STANDARD_GRAVITY

EXAMPLE = Path(__file__).parents[2] / "examples" / "spindle_bearing.yaml"
TEXT = EXAMPLE.read_text(encoding="utf-8")


def spindle(rpm, method="quick", more=""):
    case = parse_case(TEXT.replace("speed: 1500 rpm", f"speed: {rpm} rpm") + more).design()
    return replace(case, method=method)


@pytest.mark.parametrize("method", ["quick", "film"])
def test_hybrid_spindle_at_speed_has_a_threshold(method):
    """At 6000 rpm k_xy exceeds k_xx, and no figure of stability was given."""
    result = hydrostatic_check(spindle(6000, method))
    assert result.stiffness_xy > result.stiffness_xx
    assert result.rotor_mass == pytest.approx(20e3 / STANDARD_GRAVITY)
    assert result.critical_mass > result.rotor_mass  # stable here, not far above
    assert result.stable_at_any_mass == 0.0
    assert 0.45 < result.whirl_frequency_ratio < 0.55
    assert 6000.0 < result.threshold_speed * 30.0 / math.pi < 12000.0
    assert {"C115"} <= {check.code for check in result.checks}


@pytest.mark.parametrize("shaft", ["", "shaft_stiffness: 2 GN/m"])
def test_journal_stands_on_its_threshold_there(shaft):
    """Solved anew at the threshold speed, the least damped motion of the rotor neither grows nor decays."""
    case = spindle(6000, more=f"\n{shaft}\n")
    result = hydrostatic_check(case)
    name = "threshold_speed_elastic" if shaft else "threshold_speed"
    speed = result.values[name]
    there = replace(case, duty=replace(case.duty, angular_speed=speed))
    found = answer(there)
    frequency = hydrostatic_check(there).whirl_frequency_ratio * speed
    stiffness, damping = impedance(found.response, found.network, there.compressibility, frequency)
    rate = growth_rates(result.rotor_mass, stiffness, damping, case.shaft_stiffness or math.inf).item()
    assert abs(rate) < 2e-3 * frequency


def test_critical_mass_is_that_of_the_coefficients_at_the_whirl_frequency():
    """Compressible oil: stiffness and damping at the frequency of the whirl, not those of slow motion."""
    case = spindle(6000, more="\n")
    soft = replace(case, compressibility=replace(case.compressibility, bulk_modulus=5e7))
    result, found = hydrostatic_check(soft), answer(soft)
    frequency = result.whirl_frequency_ratio * case.duty.angular_speed
    stiffness, damping = impedance(found.response, found.network, soft.compressibility, frequency)
    for share, grows in ((0.99, False), (1.01, True)):
        rate = growth_rates(share * result.critical_mass, stiffness, damping).item()
        assert (rate > 0.0) is grows
    stiff = hydrostatic_check(case)
    assert abs(result.critical_mass / stiff.critical_mass - 1.0) > 0.01


def test_sense_of_rotation_and_direction_of_the_load_change_nothing():
    case = spindle(4000)
    turned = replace(case, duty=replace(case.duty, angular_speed=-case.duty.angular_speed))
    names = ("critical_mass", "whirl_frequency_ratio", "threshold_speed")
    one, other = hydrostatic_check(case), hydrostatic_check(turned)
    assert [one.values[n] for n in names] == pytest.approx([other.values[n] for n in names], rel=1e-6)


def test_journal_at_rest_and_pads_have_none():
    for case in (spindle(0), parse_case(template("hydrostatic_pad")).design()):
        assert not {"critical_mass", "stable_at_any_mass"} & set(hydrostatic_check(case).values)


def test_rotor_heavier_than_its_film_carries_is_told():
    result = hydrostatic_check(spindle(6000, more="\nrotor_mass: 20 t\n"))
    assert {"W120"} <= {notice.code for notice in result.warnings}
    (check,) = (one for one in result.checks if one.code == "C115")
    assert not check.ok
    assert result.threshold_speed < 6000.0 * math.pi / 30.0
    assert np.isfinite(result.critical_mass)
