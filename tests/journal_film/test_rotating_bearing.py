"""A bearing that turns, too: shear by the difference of both speeds, film forces by their sum."""

from __future__ import annotations

import math

import pytest

from babbitt.case import case_from_dict
from babbitt.solving import solve

RPM = math.pi / 30.0


def answer(**given):
    fields = {
        "kind": "journal",
        "name": "Bearing",
        "method": "iso7902",
        "diameter": "120 mm",
        "width": "60 mm",
        "clearance": {"kind": "relative", "mean": "1.4 permille"},
        "lubricant": {
            "kind": "constant",
            "dynamic_viscosity": "20 mPa s",
            "density": "860 kg/m3",
            "volumetric_heat_capacity": "1.8 MJ/(m3 K)",
        },
        "materials": {"bearing": "C45", "journal": "C45"},
        "effective_temperature": "60 degC",
        "speed": "3000 rpm",
        "span": "360 deg",
        "load": "6 kN",
    } | given
    (result,) = solve(case_from_dict(fields)).results
    assert result.outcome.solved, result.message
    return result


FILM = {"method": "film", "film_start": "widest_gap", "cavitation": "reynolds"}
METHODS = pytest.mark.parametrize("method", [{}, FILM], ids=["iso7902", "film"])


@METHODS
def test_counter_rotation_shears_more_than_the_concentric_film_of_petroff(method):
    found = answer(bearing_speed="-1500 rpm", **method)
    gap = 0.7e-3 * 0.12
    petroff = math.pi * 20e-3 * 0.12**3 * 0.06 / 4.0 / gap * (4500 * RPM) ** 2
    assert (
        found.friction_power > (1.0 if not method else 0.9) * petroff
    )  # a film that ruptures is not sheared all around
    assert found.friction_power == pytest.approx(5.44e3, rel=0.01 if not method else 0.25)
    assert found.film_reynolds_number == pytest.approx(
        found.density * 4500 * RPM * 0.06 * 0.7e-3 * 0.12 / 20e-3, rel=1e-3
    )


@METHODS
def test_surfaces_that_turn_together_make_no_heat_but_by_the_wedge(method):
    """P = F e sin(beta) omega where nothing is sheared."""
    found = answer(bearing_speed="3000 rpm", **method)
    eccentricity = found.eccentricity_ratio * 0.7e-3 * 0.12
    work = 6e3 * eccentricity * math.sin(found.attitude_angle) * 3000 * RPM
    assert found.friction_power == pytest.approx(work, rel=1e-5)
    assert found.film_reynolds_number == 0.0


@METHODS
@pytest.mark.parametrize("turning", [-1500.0, -700.0, 900.0, 2000.0])
def test_the_power_is_that_of_both_torques(method, turning):
    """By a bearing at rest with the same film: its torque by shear in proportion to the sliding speed."""
    found, at_rest = (
        answer(bearing_speed=f"{turning} rpm", **method),
        answer(speed=f"{3000 + turning} rpm", **method),
    )
    assert found.eccentricity_ratio == pytest.approx(at_rest.eccentricity_ratio, rel=1e-9)
    pressure = 3e3 * found.eccentricity_ratio * 0.7e-3 * 0.12 * math.sin(found.attitude_angle)
    shear = (at_rest.friction_torque - pressure) * (3000 - turning) / (3000 + turning)
    assert found.friction_torque == pytest.approx(shear + pressure, rel=1e-6)
    power = (shear + pressure) * 3000 * RPM - (shear - pressure) * turning * RPM
    assert found.friction_power == pytest.approx(power, rel=1e-6)


def test_whirl_is_told_by_the_speed_of_the_journal():
    """The film knows the sum of both speeds; the journal turns with what the bearing leaves."""
    turning, at_rest = answer(bearing_speed="1000 rpm", **FILM), answer(speed="4000 rpm", **FILM)
    assert turning.critical_mass == pytest.approx(at_rest.critical_mass, rel=1e-9)
    assert turning.whirl_frequency_ratio == pytest.approx(at_rest.whirl_frequency_ratio * 4.0 / 3.0, rel=1e-9)
    assert turning.threshold_speed == pytest.approx(at_rest.threshold_speed - 1000 * RPM, rel=1e-6)
