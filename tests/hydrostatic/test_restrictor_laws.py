"""Restrictors, supply and the network between them and the film."""

import math

import numpy as np
import pytest
from hydrostatic_bearings import CIRCULAR_CAPILLARY, CIRCULAR_ORIFICE

from babbitt.core.notices import InputError
from babbitt.kinds.hydrostatic.network import Feeding, newton, solve_network
from babbitt.kinds.hydrostatic.restrictors import (
    Capillary,
    CheckValve,
    ConstantFlow,
    FlowValve,
    MembraneValve,
    MeteredFlow,
    Orifice,
    Slot,
)
from babbitt.kinds.hydrostatic.supply import FixedPressure, Pump

LAWS = {
    "capillary": CIRCULAR_CAPILLARY,
    "tubes with entry loss": Capillary(0.6e-3, 0.06, 0.03, 3, 2.24, 870.0),
    "orifice": CIRCULAR_ORIFICE,
    "slot": Slot(0.01, 1e-4, 0.02, 0.03),
    "pump": ConstantFlow(4e-6, 1e-13),
    "flow valve, controlled": FlowValve(1e-6, 1e-13, 1e-11),
    "flow valve, open": FlowValve(1e-5, 1e-12, 1e-12),
    "membrane valve": MembraneValve(0.5e-12, 2e-7),
    "check valve": CheckValve(CIRCULAR_CAPILLARY),
}


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("pressure", [0.4e6, 2.6e6, 4.4e6])
def test_slopes_are_those_of_the_flow(name, pressure):
    law, supply, step = LAWS[name].law, 5e6, 10.0
    _, by_recess, by_supply = law(pressure, supply)
    found = (law(pressure + step, supply)[0] - law(pressure - step, supply)[0]) / (2.0 * step)
    assert by_recess == pytest.approx(found, rel=1e-5, abs=1e-20)
    found = (law(pressure, supply + step)[0] - law(pressure, supply - step)[0]) / (2.0 * step)
    assert by_supply == pytest.approx(found, rel=1e-5, abs=1e-20)


def test_flows_of_the_prototype():
    assert CIRCULAR_CAPILLARY.conductance == pytest.approx(1.767145868e-12, rel=1e-9)
    assert CIRCULAR_ORIFICE.factor == pytest.approx(3.735570396e-9, rel=1e-9)
    lossy = Capillary(0.6e-3, 0.06, 0.03, entry_loss=2.24)
    assert lossy.law(2.5e6, 5e6)[0] == pytest.approx(4.062404e-6, rel=1e-6)


def test_entry_loss_vanishes_with_the_flow_and_tubes_add_up():
    lossy, plain = Capillary(0.6e-3, 0.06, 0.03, entry_loss=2.24), CIRCULAR_CAPILLARY
    assert lossy.law(5e6 - 1.0, 5e6)[0] == pytest.approx(plain.law(5e6 - 1.0, 5e6)[0], rel=1e-6)
    three = Capillary(0.6e-3, 0.06, 0.03, 3, 2.24)
    assert three.law(2e6, 5e6)[0] == pytest.approx(3.0 * lossy.law(2e6, 5e6)[0], rel=1e-12)


@pytest.mark.parametrize("name", ["capillary", "tubes with entry loss", "orifice", "slot"])
def test_oil_flows_back_as_it_flows_forth(name):
    law = LAWS[name].law
    assert law(7e6, 5e6)[0] == pytest.approx(-law(3e6, 5e6)[0], rel=1e-12)


def test_smoothed_orifice_is_the_square_root():
    drop = np.array([0.01, 0.1, 0.5]) * 5e6
    exact = CIRCULAR_ORIFICE.factor * np.sqrt(drop)
    found = [CIRCULAR_ORIFICE.law(5e6 - one, 5e6)[0] for one in drop]
    assert np.abs(found / exact - 1.0).max() < 3e-5


def test_check_valve_lets_nothing_back():
    assert CheckValve(CIRCULAR_CAPILLARY).law(6e6, 5e6) == (0.0, 0.0, 0.0)
    assert CheckValve(CIRCULAR_CAPILLARY).law(4e6, 5e6) == CIRCULAR_CAPILLARY.law(4e6, 5e6)


def solved(restrictors, supply, conductance):
    count = len(restrictors)
    start = np.full(count, 1e6)
    return solve_network(Feeding(tuple(restrictors), supply), conductance, conductance @ start, start, 5e6)


def test_pump_over_one_capillary_and_one_land():
    land, leakage = 1.611505828e-12, 1e-13
    state = solved([CIRCULAR_CAPILLARY], Pump(5e-6, leakage), np.array([[land]]))
    series = 1.0 / (1.0 / CIRCULAR_CAPILLARY.conductance + 1.0 / land)
    assert state.supply_pressure == pytest.approx(5e-6 / (leakage + series), rel=1e-10)
    assert state.supply_pressure == pytest.approx(5.302955e6, rel=1e-6)
    assert state.pressures[0] == pytest.approx(2.773620e6, rel=1e-6)


def test_relief_valve_overflows_or_is_shut():
    land = np.array([[1.611505828e-12]])
    free = solved([CIRCULAR_CAPILLARY], Pump(5e-6, 1e-13, 6e6), land)
    assert (free.overflow, free.supply_pressure < 6e6) == (0.0, True)
    relieved = solved([CIRCULAR_CAPILLARY], Pump(5e-6, 1e-13, 4e6), land)
    assert relieved.supply_pressure == 4e6
    assert relieved.overflow == pytest.approx(5e-6 - 4e-7 - relieved.flows.sum(), rel=1e-12)
    assert relieved.overflow > 0.0
    fixed = solved([CIRCULAR_CAPILLARY], FixedPressure(4e6), land)
    assert relieved.pressures == pytest.approx(fixed.pressures, rel=1e-12)


def test_network_of_unlike_recesses_balances():
    conductance = 1e-12 * np.array([[4.0, -1.0, 0.0], [-1.0, 5.0, -2.0], [0.0, -2.0, 3.0]])
    restrictors = [CIRCULAR_CAPILLARY, CIRCULAR_ORIFICE, MembraneValve(0.5e-12, 2e-7)]
    state = solved(restrictors, Pump(2e-5, 1e-13), conductance)
    assert state.converged
    laws = [one.law(p, state.supply_pressure)[0] for one, p in zip(restrictors, state.pressures, strict=True)]
    assert conductance @ state.pressures == pytest.approx(laws, rel=1e-9)
    assert sum(laws) == pytest.approx(2e-5 - 1e-13 * state.supply_pressure, rel=1e-9)


@pytest.mark.parametrize("conductance", [1e-18, 1e-15, 1e-12, 1e-9])
@pytest.mark.parametrize("name", LAWS)
def test_newton_finds_every_land(name, conductance):
    state = solved([LAWS[name]], FixedPressure(5e6), np.array([[conductance]]))
    assert state.converged


def test_valve_that_opens_faster_than_the_land_lets_out_is_unstable():
    """Where it meters; with its ports open it is a restrictor like any other, and there the pressure ends."""
    steep, land = FlowValve(1e-6, 2e-12, 1e-6), np.array([[1e-12]])
    fed = Feeding((steep,), FixedPressure(5e6))
    metering = newton(fed, land, np.zeros(1), np.zeros(1), np.zeros(1), 5e6, None)
    assert metering.converged
    assert metering.least_eigenvalue < 0.0
    opened = solved([steep], FixedPressure(5e6), land)
    assert opened.is_stable
    assert opened.pressures[0] == pytest.approx(5e6 * 1e-6 / (1e-6 + 1e-12), rel=1e-12)
    calm = solved([FlowValve(1e-6, 0.5e-12, 1e-6)], FixedPressure(5e6), np.array([[1e-12]]))
    assert calm.least_eigenvalue > 0.0


@pytest.mark.parametrize("gain", [0.0, 0.01, 0.05, 0.3])
def test_one_recess_behind_a_valve_has_its_exact_pressure(gain):
    """Q = min(Q_0 + k p, G_max (p_s - p)) = G p: metered p = Q_0/(G - k) below the kink, else the open ports."""
    first, most, supply = 0.2e-3 / 60.0, 5e-9 / 60.0, 5e6
    k = max(gain * 1e-9 / 60.0, 1e-20)
    valve = FlowValve(first, k, most)
    kink = (most * supply - first) / (most + k)
    for land in np.geomspace(1e-15, 1e-9, 40):
        metered = first / (land - k) if land > k else math.inf
        exact = metered if metered < kink else most * supply / (land + most)
        state = solved([valve], FixedPressure(supply), np.array([[land]]))
        assert state.converged
        assert state.is_stable
        assert state.pressures[0] == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Capillary(0.0, 0.1, 0.02), "diameter"),
        (lambda: Capillary(1e-3, math.nan, 0.02), "length"),
        (lambda: Capillary(1e-3, 0.1, -0.02), "viscosity"),
        (lambda: Capillary(1e-3, 0.1, 0.02, 0), "tubes"),
        (lambda: Orifice(1e-3, 870.0, 1.2), "discharge"),
        (lambda: Orifice(1e-3, 0.0), "density"),
        (lambda: Slot(0.01, 0.0, 0.02, 0.03), "gap"),
        (lambda: ConstantFlow(-1e-6), "flow"),
        (lambda: MeteredFlow(0.0), "flow"),
        (lambda: ConstantFlow(1e-6, -1.0), "leakage"),
        (lambda: FlowValve(1e-6, 1e-12, 0.0), "open_conductance"),
        (lambda: MembraneValve(0.0, 1e-7), "conductance"),
        (lambda: FixedPressure(-1.0), "supply_pressure"),
        (lambda: Pump(math.inf), "pump_flow"),
        (lambda: Pump(1e-6, 0.0, 0.0), "relief_pressure"),
    ],
)
def test_refused(make, words):
    with pytest.raises(InputError, match=words):
        make()
