"""Reference accuracy goes to vanishing intervals where the film is full."""

import math
from dataclasses import replace

import pytest
from hydrostatic_bearings import CLEARANCE, SPEED, case, down

from babbitt.kinds.hydrostatic.check import hydrostatic_check
from babbitt.kinds.hydrostatic.model import OperatingConditions


def test_reference_is_the_extrapolated_film():
    """The prototype's own extrapolation of the bearing at rest at half the clearance."""
    made = case(duty=OperatingConditions(None, position=tuple(down(0.5))), accuracy="reference")
    result = hydrostatic_check(made)
    assert result.settings["extrapolated"] == "yes"
    assert result.load == pytest.approx(14916.07, rel=2e-4)
    assert result.stiffness_yy == pytest.approx(5.02398e8, rel=2e-4)
    assert result.total_flow == pytest.approx(5.04790e-5, rel=2e-4)
    assert result.arrays["stiffness"][1][1] == pytest.approx(result.stiffness_yy, rel=1e-12)
    assert sum(result.arrays["restrictor_flow"][0]) == pytest.approx(result.total_flow, rel=1e-12)
    plain = hydrostatic_check(replace(made, accuracy="engineering"))
    assert "extrapolated" not in plain.settings
    assert abs(plain.load / 14916.07 - 1.0) > abs(result.load / 14916.07 - 1.0)
    assert result.mass_balance_error < 1e-9


def test_under_a_load_the_place_is_extrapolated():
    made = case(duty=OperatingConditions(20e3, -0.5 * math.pi, angular_speed=SPEED), accuracy="reference")
    result = hydrostatic_check(made)
    assert result.load == pytest.approx(20e3, rel=1e-9)
    assert result.minimum_film_thickness == pytest.approx(CLEARANCE * (1.0 - result.eccentricity_ratio), rel=1e-12)
    # the prototype on two of its grids, extrapolated: eccentricity and attitude
    assert result.eccentricity_ratio == pytest.approx(0.529596 + (0.529596 - 0.529862) / 3.0, abs=3e-5)


def test_ruptured_films_and_closed_forms_are_left_as_they_are():
    ruptured = case(duty=OperatingConditions(30e3, -0.5 * math.pi, angular_speed=SPEED), accuracy="reference")
    for made in (ruptured, case(method="quick", accuracy="reference")):
        assert "extrapolated" not in hydrostatic_check(made).settings
