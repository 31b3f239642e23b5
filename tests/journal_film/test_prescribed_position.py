"""Prescribed positions and the half-Sommerfeld condition through the case language."""

import math

import pytest
from film_bearings import answer, case, solved

from babbitt.core.result import Outcome
from babbitt.kinds.journal.case.build import iso7902_cases
from babbitt.kinds.journal.film.check import film_solution
from babbitt.kinds.journal.film.unloaded import NEEDS_A_LOAD
from babbitt.kinds.journal.report.film_figures import all_figures
from babbitt.study.comparison import compare_methods

AT_60 = {"effective_temperature": "60 degC"}


def at(x, y):
    """Position as text with its unit, or in m."""
    given = {"x": x, "y": y}
    return {"load": None, "position": {n: v if isinstance(v, str) else f"{v} m" for n, v in given.items()}}


@pytest.mark.parametrize("speed", ["3000 rpm", "-3000 rpm"])
def test_the_position_found_for_a_load_gives_back_the_load_and_its_direction(speed):
    given = AT_60 | {"speed": speed, "load_angle": "-60 deg"}
    found = answer(**given)
    assert found.load_angle == pytest.approx(math.radians(-60.0), abs=1e-6)
    sense = math.copysign(1.0, float(speed.split()[0]))
    angle = math.radians(-60.0) + sense * found.attitude_angle
    away = found.eccentricity_ratio * 0.5 * found.operating_relative_clearance * found.diameter
    # the load angle of the case does not matter to a prescribed position
    there = answer(**AT_60, speed=speed, **at(away * math.cos(angle), away * math.sin(angle)))
    assert there.load == pytest.approx(found.load, rel=2e-3)
    assert there.load_angle == pytest.approx(found.load_angle, abs=2e-3)
    assert there.minimum_film_thickness == pytest.approx(found.minimum_film_thickness, rel=1e-3)


def test_the_heat_balance_closes_at_a_prescribed_position():
    result = answer(**at("60 um", "-70 um"))
    assert abs(result.energy_balance_error) < 1e-8


def test_a_position_that_touches_the_bore_is_no_film():
    (result,) = solved(**at("160 um", "0 um")).results
    assert result.outcome is Outcome.OUTSIDE_CLEARANCE
    assert result.outcome.code == "S006"
    assert "touch" in result.message


def test_the_standard_leaves_prescribed_positions_to_the_film():
    given = case(**at("60 um", "-70 um"), span="360 deg")
    assert iso7902_cases(given, given) == ()
    (comparison,) = compare_methods(given)
    labels = {variant.label for variant in comparison.variants}
    assert "film, one temperature" in labels
    assert not labels & {"ISO 7902", "long film"}


HALF = {
    "grooves": None,
    "cavitation": "half_sommerfeld",
    "effective_temperature": "60 degC",
    "width": None,
    "width_ratio": 0.1,
    "load": None,
    "accuracy": "reference",
}


@pytest.mark.parametrize("eccentricity", [0.2, 0.5])
def test_a_narrow_half_sommerfeld_film_is_that_of_dubois_and_ocvirk(eccentricity):
    # F = eta U B^3 eps / (4 c^2 (1 - eps^2)^2) sqrt(16 eps^2 + pi^2 (1 - eps^2)), DuBois and Ocvirk (1953), eq. 5
    result = answer(**HALF, eccentricity_ratio=eccentricity)
    speed, width = result.surface_speed, result.width
    clearance = 0.5 * result.operating_relative_clearance * result.diameter
    e = eccentricity
    expected = (
        result.effective_viscosity * speed * width**3 * e / (4.0 * clearance**2 * (1.0 - e**2) ** 2)
        * math.sqrt(16.0 * e**2 + math.pi**2 * (1.0 - e**2))
    )  # fmt: skip
    assert result.load == pytest.approx(expected, rel=0.02)
    tangent = math.pi * math.sqrt(1.0 - e**2) / (4.0 * e)
    assert math.tan(result.attitude_angle) == pytest.approx(tangent, rel=0.02)


@pytest.mark.thorough
def test_a_half_sommerfeld_film_claims_neither_flow_nor_stiffness():
    result = answer(**HALF, eccentricity_ratio=0.5)
    for name in ("total_flow", "side_flow", "supply_flow", "stiffness_xx", "damping_yy", "critical_mass"):
        assert name not in result.values
    assert result.arrays == {}
    (comparison,) = compare_methods(case(**HALF | {"width_ratio": 0.5}, eccentricity_ratio=0.5))
    labels = [variant.label for variant in comparison.variants]
    assert labels[0] == "film at 60 °C, half-Sommerfeld"
    assert "film, Reynolds" in labels


def test_the_threshold_of_whirl_is_that_of_the_load_found():
    given = AT_60 | {"load": "10 kN", "load_angle": "-20 deg", "rotor_mass": "3 t"}
    found = answer(**given)
    angle = math.radians(-20.0) + found.attitude_angle
    away = found.eccentricity_ratio * 0.5 * found.operating_relative_clearance * found.diameter
    place = at(away * math.cos(angle), away * math.sin(angle))
    there = answer(**AT_60, rotor_mass="3 t", **place)  # its load angle is -90 deg, which nothing depends on
    assert there.threshold_speed == pytest.approx(found.threshold_speed, rel=5e-3)
    assert there.critical_mass == pytest.approx(found.critical_mass, rel=5e-3)


CENTRED = {
    "position": {"x": "0 um", "y": "0 um"}, "effective_temperature": "50 degC", "load": None, "accuracy": "draft"
}  # fmt: skip


@pytest.mark.parametrize(
    "fed",
    [
        {"grooves": None, "film_start": "periodic", "cavitation": "half_sommerfeld"},
        {"grooves": None, "film_start": "periodic", "cavitation": "reynolds"},
        {"grooves": None, "film_start": "periodic", "cavitation": "reynolds", "error_estimate": True},
        {"grooves": None, "film_start": "widest_gap", "cavitation": "reynolds"},
        {"rotor_mass": "100 kg"},
    ],
)
def test_a_centred_journal_carries_nothing_and_has_petroffs_torque(fed):
    result = answer(**CENTRED | fed)
    values, clearance = result.values, result.values["operating_relative_clearance"] * 0.1
    assert values["load"] == values["sommerfeld_number"] == 0.0
    assert values.keys().isdisjoint(NEEDS_A_LOAD)
    assert result.missing.keys() >= set(NEEDS_A_LOAD)
    shear = values["effective_viscosity"] * values["angular_speed"] * 0.1 / clearance
    if "film_start" in fed:  # grooves take a part of the bore, and are not full of shear
        assert values["friction_torque"] == pytest.approx(shear * math.pi * 0.2 * 0.12 * 0.1, rel=1e-3)
    assert all(math.isfinite(value) for value in values.values())


def test_figures_of_a_centred_journal_vary_no_load():
    (design,) = case(**CENTRED, grooves=None, film_start="periodic", cavitation="reynolds").problems()
    drawn = [drawing.name for drawing in all_figures(film_solution(design))]
    assert "pressure-map" in drawn
    assert "stability-map" not in drawn
