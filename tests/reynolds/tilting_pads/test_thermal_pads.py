"""Tilting pads with their temperatures: numbers of an independent calculation, balances, frames."""

import math

import pytest
from fillon_pads import LOAD, fillon_bearing, fillon_heat

from babbitt.core.result import Outcome
from babbitt.reynolds.tilting_pads.dynamics import condensed_at, full_coefficients
from babbitt.reynolds.tilting_pads.solution import PadStatus
from babbitt.reynolds.tilting_pads.thermal_pads import find_thermal_tilting_pads

# highest bore temperature in degC at 1000, 2000, 3000, 4000 rpm, of a prototype with Lobatto points across the gap
BORE = {
    "A": (64.5, 67.1, 70.8, 74.84),
    "B": (49.3, 57.5, 64.6, 70.67),
    "C": (48.6, 56.2, 62.8, 68.5),
    "D": (48.6, 56.2, 62.8, 68.33),
    "E": (48.9, 57.1, 64.7, 71.53),
}
# at 4000 rpm: smallest gap in um, stiffness in 1e8 N/m, damping in 1e5 N s/m on 6 x 192
COEFFICIENTS = {"A": (29.32, 3.523, 6.035), "B": (30.70, 3.563, 6.077), "D": (31.01, 3.512, 5.768),
                "E": (27.98, 4.312, 7.253)}  # fmt: skip
# preload 0: eccentricity in um, temperature in degC, smallest gap in um, power in kW, stiffness in 1e8 N/m
UNLOADED = {"A": (145.21, 71.20, 32.65, 1.83, 2.876), "B": (144.80, 67.42, 34.35, 1.89, 2.869),
            "E": (130.90, 65.59, 34.60, 1.91, 2.871)}  # fmt: skip


def hottest_bore(solution):
    """Highest bore temperature, degC."""
    return max(pad.bore.max() for pad in solution.temperatures) - 273.15


@pytest.mark.parametrize("model", "ABCDE")
def test_bore_temperatures_of_an_independent_calculation(model):
    for rpm, expected in zip((1000.0, 2000.0, 3000.0, 4000.0), BORE[model], strict=True):
        found = find_thermal_tilting_pads(fillon_bearing(rpm), LOAD, fillon_heat(model))
        assert found.outcome is Outcome.CONVERGED
        assert hottest_bore(found) == pytest.approx(expected, abs=0.3)


@pytest.mark.parametrize("model", COEFFICIENTS)
def test_gap_and_coefficients_of_an_independent_calculation(model):
    found = find_thermal_tilting_pads(fillon_bearing(), LOAD, fillon_heat(model))
    gap, stiffness, damping = COEFFICIENTS[model]
    seen = condensed_at(full_coefficients(found), 1.0)
    assert found.minimum_film_thickness * 1e6 == pytest.approx(gap, rel=0.005)
    assert seen.stiffness[1, 1] / 1e8 == pytest.approx(stiffness, rel=0.01)
    assert seen.damping[1, 1] / 1e5 == pytest.approx(damping, rel=0.01)


@pytest.mark.parametrize("model", UNLOADED)
def test_unloaded_pads_of_an_independent_calculation(model):
    found = find_thermal_tilting_pads(fillon_bearing(assembled=148e-6), LOAD, fillon_heat(model))
    eccentricity, temperature, gap, power, stiffness = UNLOADED[model]
    assert [pad.status for pad in found.pads[:2]] == [PadStatus.UNLOADED] * 2
    assert [pad.status for pad in found.pads[2:]] == [PadStatus.LOADED] * 2
    assert hottest_bore(found) == pytest.approx(temperature, abs=0.3)
    assert math.hypot(*found.position) * 1e6 == pytest.approx(eccentricity, rel=2e-3)
    assert found.minimum_film_thickness * 1e6 == pytest.approx(gap, rel=0.01)
    assert found.friction_power / 1e3 == pytest.approx(power, abs=0.006)
    assert condensed_at(full_coefficients(found), 1.0).stiffness[1, 1] / 1e8 == pytest.approx(stiffness, rel=0.02)


@pytest.mark.parametrize("model", "ABCDE")
@pytest.mark.parametrize("assembled", [78.4e-6, 148e-6])
def test_heat_closes(model, assembled):
    found = find_thermal_tilting_pads(fillon_bearing(assembled=assembled), LOAD, fillon_heat(model))
    assert found.energy_balance_error == pytest.approx(0.0, abs=2e-4)
    assert found.power_error == pytest.approx(0.0, abs=1e-9)
    assert abs(found.journal_heat) < 1e-6 * found.dissipation
    if model in "CDE":
        assert 0.01 < found.pad_heat / found.dissipation < 0.06
    for pad in found.pads:
        assert pad.inflow == pytest.approx(pad.outflow + pad.side_flow, rel=1e-9)
