"""Pads with one recess by closed forms: prototype, calculus, published exercise."""

import math

import numpy as np
import pytest
from hydrostatic_bearings import ANNULAR, CIRCULAR, CIRCULAR_CAPILLARY, CIRCULAR_ORIFICE, SPEED, case
from scipy.optimize import brentq, minimize_scalar

from babbitt.kinds.hydrostatic.check import hydrostatic_check
from babbitt.kinds.hydrostatic.closed_forms import crude_lands, lands_of
from babbitt.kinds.hydrostatic.geometry import CircularPad, RectangularPad
from babbitt.kinds.hydrostatic.impedance import Compressibility, damping_loss, impedance, static_coefficients
from babbitt.kinds.hydrostatic.model import Oil, OperatingConditions, Recesses
from babbitt.kinds.hydrostatic.network import Feeding
from babbitt.kinds.hydrostatic.optimum import (
    least_power_gap,
    least_power_viscosity,
    stiffest_ratio,
)
from babbitt.kinds.hydrostatic.restrictors import Capillary, ConstantFlow, MembraneValve
from babbitt.kinds.hydrostatic.single_recess import gap_under, pad_at
from babbitt.kinds.hydrostatic.supply import FixedPressure

LANDS, OIL = lands_of(CIRCULAR), Compressibility(5e-6, 1.2e9)


def fed(restrictor, pressure=5e6):
    return Feeding((restrictor,), FixedPressure(pressure))


def at(restrictor, gap=40e-6):
    return pad_at(LANDS, fed(restrictor), 0.03, gap)


@pytest.mark.parametrize(
    ("restrictor", "gap", "expected"),
    [
        (CIRCULAR_CAPILLARY, 40e-6, (0.5230329, 11112.062, 4.2143525e-6, 3.9750664e8, 7.0830863e6)),
        (CIRCULAR_ORIFICE, 40e-6, (0.6303137, 13391.290, 5.0787708e-6, 5.4215809e8, 7.7871742e6)),
        (ConstantFlow(4e-6), 40e-6, (0.4964301, 10546.875, 4e-6, 7.9101562e8, 1.2942963e7)),
        (CIRCULAR_CAPILLARY, 30.80095e-6, (0.7060339, 15000.0, 2.5974047e-6, 4.2948271e8, 1.1022956e7)),
        (CIRCULAR_ORIFICE, 37.07214e-6, (0.7060339, 15000.0, 4.5288771e-6, 5.5153001e8, 8.5792298e6)),
    ],
)
def test_circular_pad_of_the_prototype(restrictor, gap, expected):
    state = at(restrictor, gap)
    stiffness, damping = static_coefficients(state.response, state.network)
    found = state.recess_pressure / 5e6, state.load, state.flow, stiffness[0, 0], damping[0, 0]
    assert found == pytest.approx(expected, rel=1e-6)


def test_membrane_valve_of_the_prototype():
    state = at(MembraneValve(0.5e-12, 2e-7))
    stiffness, _ = static_coefficients(state.response, state.network)
    assert (state.recess_pressure, state.flow, state.network.slope[0], stiffness[0, 0]) == pytest.approx(
        (2.614178e6, 4.212764e-6, 1.059132e-13, 7.817138e8), rel=1e-6
    )


def test_gap_under_a_load():
    assert gap_under(LANDS, fed(CIRCULAR_CAPILLARY), 0.03, 15e3, 1e-7) == pytest.approx(30.80095e-6, rel=1e-6)
    assert gap_under(LANDS, fed(CIRCULAR_ORIFICE), 0.03, 15e3, 1e-7) == pytest.approx(37.07214e-6, rel=1e-6)
    assert gap_under(LANDS, fed(CIRCULAR_ORIFICE), 0.03, 25e3, 1e-7) == 0.0


@pytest.mark.parametrize(
    ("restrictor", "hertz", "expected"),
    [
        (CIRCULAR_CAPILLARY, 0.0, (3.9750664e8, 6.5928677e6)),
        (CIRCULAR_CAPILLARY, 10.0, (4.2099568e8, 6.5639003e6)),
        (CIRCULAR_CAPILLARY, 100.0, (1.8740042e9, 4.7720014e6)),
        (CIRCULAR_CAPILLARY, 1e3, (4.2686641e9, 1.8188264e6)),
        (CIRCULAR_CAPILLARY, 1e4, (4.3324836e9, 1.7401221e6)),
        (CIRCULAR_ORIFICE, 0.0, (5.4215809e8, 7.0304719e6)),
        (CIRCULAR_ORIFICE, 100.0, (2.1901991e9, 4.7302637e6)),
        (CIRCULAR_ORIFICE, 1e3, (4.2844778e9, 1.8072314e6)),
    ],
)
def test_coefficients_over_frequency(restrictor, hertz, expected):
    state = at(restrictor)
    stiffness, damping = impedance(state.response, state.network, OIL, 2.0 * math.pi * hertz)
    assert (stiffness[0, 0], damping[0, 0]) == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(("restrictor", "loss"), [(CIRCULAR_CAPILLARY, 0.069), (ConstantFlow(4e-6), 0.158)])
def test_compressible_oil_costs_damping(restrictor, loss):
    state = at(restrictor)
    losses = [damping_loss(state.response, state.network, Compressibility(v, 1.2e9)) for v in (0.0, 5e-6, 1e-5)]
    assert losses[0] == 0.0
    assert losses[1] == pytest.approx(loss, abs=6e-4)
    assert losses[2] == pytest.approx(2.0 * losses[1], rel=1e-12)


def test_limits_of_frequency():
    state = at(CIRCULAR_CAPILLARY)
    stiffness, damping = impedance(state.response, state.network, OIL, 1e8)
    assert stiffness[0, 0] == pytest.approx(LANDS.effective_area**2 * 1.2e9 / 5e-6, rel=1e-6)
    assert damping[0, 0] == pytest.approx(1.739313866e6, rel=1e-6)


@pytest.mark.parametrize("restrictor", [CIRCULAR_CAPILLARY, CIRCULAR_ORIFICE, ConstantFlow(4e-6, 2e-13)])
def test_stiffness_is_the_slope_of_the_load(restrictor):
    step = 1e-9
    slope = -(at(restrictor, 40e-6 + step).load - at(restrictor, 40e-6 - step).load) / (2.0 * step)
    state = at(restrictor)
    assert static_coefficients(state.response, state.network)[0][0, 0] == pytest.approx(slope, rel=1e-6)


def test_constant_flow_beats_orifice_beats_capillary():
    """Malanoski and Loeb, J. Basic Eng. 83 (1961) 179: the order at equal load and gap."""
    pressure, gap = 2.5e6, 40e-6
    land = LANDS.conductance(gap, 0.03)
    flow = land * pressure
    capillary = CIRCULAR_CAPILLARY
    orifice = CIRCULAR_ORIFICE
    tubes = Capillary(0.6e-3, 0.06 * capillary.conductance * 2.5e6 / flow, 0.03)
    scale = math.sqrt(flow / (orifice.factor * math.sqrt(2.5e6)))
    hole = type(orifice)(orifice.diameter * scale, 870.0, 0.62)
    found = []
    for restrictor in (tubes, hole, ConstantFlow(flow)):
        state = at(restrictor, gap)
        assert state.recess_pressure == pytest.approx(pressure, rel=1e-6)
        found.append(static_coefficients(state.response, state.network)[0][0, 0] * gap / state.load)
    assert found == pytest.approx([1.5, 6.0 * 0.5 / 1.5, 3.0], rel=1e-5)


def test_annular_pad_of_the_prototype():
    lands = lands_of(ANNULAR)
    assert lands.effective_area == pytest.approx(1.6493527e-2, rel=1e-7)
    assert lands.conductance(50e-6, 0.02) == pytest.approx(1.2473087e-11 + 2.0136069e-11, rel=1e-7)
    state = pad_at(lands, fed(Capillary(0.8e-3, 0.06, 0.02, 4), 3e6), 0.02, 50e-6)
    stiffness, damping = static_coefficients(state.response, state.network)
    assert (state.recess_pressure / 3e6, state.load, state.flow, stiffness[0, 0], damping[0, 0]) == pytest.approx(
        (0.50681468, 25077.485, 4.9580397e-5, 7.4207086e8, 4.6236157e6), rel=1e-7
    )
    stiffness, damping = impedance(state.response, state.network, OIL, 200.0 * math.pi)
    assert (stiffness[0, 0], damping[0, 0]) == pytest.approx((8.4310589e8, 4.5704855e6), rel=1e-7)


def test_thin_annular_pad_is_two_strips():
    radius, land, recess = 10.0, 1e-3, 2e-3
    pad = type(ANNULAR)(radius, radius + land, radius + land + recess, radius + 2.0 * land + recess)
    around = 2.0 * math.pi * radius
    lands = lands_of(pad)
    assert lands.flow_factor == pytest.approx(2.0 * around / land, rel=1e-3)
    assert lands.effective_area == pytest.approx(around * (recess + land), rel=1e-3)
    assert lands.squeeze_factor == pytest.approx(2.0 * around * land**3, rel=1e-3)


@pytest.mark.parametrize(
    ("sides", "land", "expected"),
    [((2.0, 1.0), 0.1, (54.23492, 0.852897)), ((2.0, 1.0), 0.2, (24.23492, 0.711587)),
     ((2.0, 1.0), 0.3, (14.23492, 0.576071)), ((3.0, 1.0), 0.25, (26.23492, 0.67874))],
)  # fmt: skip
def test_rectangular_pad_with_equal_lands(sides, land, expected):
    pad = RectangularPad(*sides, sides[0] - 2.0 * land, sides[1] - 2.0 * land)
    lands = lands_of(pad)
    assert (lands.flow_factor, lands.effective_area / pad.area) == pytest.approx(expected, abs=2e-5)
    crude = crude_lands(pad)
    assert crude.flow_factor < lands.flow_factor
    assert crude.effective_area == pytest.approx(lands.effective_area, rel=0.12)


def test_published_exercise():
    """A study-help exercise: pad of 0.1 m, 80 cP, 30 um, 60 kN, 4e-6 m3/s; printed: R0 = 28.5 mm, 50.89 W."""
    load, flow, gap = 60e3, 4e-6, 30e-6

    def excess(recess):
        lands = lands_of(CircularPad(0.05, recess))
        return lands.effective_area * flow / lands.conductance(gap, 0.08) - load

    recess = brentq(excess, 0.01, 0.045)
    assert recess == pytest.approx(28.5e-3, abs=1e-4)
    assert load / lands_of(CircularPad(0.05, 28.5e-3)).effective_area * flow == pytest.approx(50.89, abs=0.05)


def test_stiffest_pressure_ratios_by_search():
    def stiffness(ratio, restrictor):  # gap given, restrictor made to suit: K over A_e p_s / h
        drop = 1.0 - ratio
        return -3.0 * ratio * drop if isinstance(restrictor, Capillary) else -6.0 * ratio * drop / (2.0 - ratio)

    for restrictor in (CIRCULAR_CAPILLARY, CIRCULAR_ORIFICE):
        best = minimize_scalar(stiffness, (0.3, 0.6), args=(restrictor,)).x
        assert stiffest_ratio(restrictor) == pytest.approx(best, abs=1e-6)
    assert stiffest_ratio(ConstantFlow(1e-6)) is None


def test_least_power():
    gap = least_power_gap(40e-6, 100.0, 50.0)
    powers = [100.0 * share**3 + 50.0 / share for share in np.array([0.99, 1.0, 1.01]) * gap / 40e-6]
    assert powers[1] < min(powers[0], powers[2])
    assert 50.0 / (gap / 40e-6) / (100.0 * (gap / 40e-6) ** 3) == pytest.approx(3.0, rel=1e-12)
    viscosity = least_power_viscosity(0.02, 100.0, 50.0)
    assert 50.0 * viscosity / 0.02 == pytest.approx(100.0 * 0.02 / viscosity, rel=1e-12)


def test_least_power_of_the_prototype():
    half = LANDS.conductance(1.0, 0.03) * (0.5 * 5e6) * 5e6, 0.03 * SPEED**2 * LANDS.friction_area
    assert least_power_gap(1.0, *half) == pytest.approx(51.82774e-6, rel=1e-6)


def test_powers_and_temperature_of_the_prototype():
    made = case(
        CIRCULAR, OperatingConditions(None, gap=40e-6, angular_speed=SPEED), "quick", "hydrostatic_pad",
        fed(CIRCULAR_CAPILLARY), Oil(0.03, 870.0, 2000.0), recesses=Recesses(1e-3, 1.0), compressibility=OIL,
    )  # fmt: skip
    result = hydrostatic_check(made)
    assert (result.friction_power, result.pumping_power, result.temperature_rise) == pytest.approx(
        (170.7768, 21.07176, 26.1624), rel=1e-5
    )
    assert result.compressibility_damping_loss == pytest.approx(0.069, abs=5e-4)
