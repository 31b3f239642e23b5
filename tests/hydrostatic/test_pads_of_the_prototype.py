"""Every printed figure of the pads' prototype, to 1e-6 or to half of its last digit."""

import math

import numpy as np
import pytest
from hydrostatic_bearings import (
    ANNULAR,
    CIRCULAR,
    CIRCULAR_CAPILLARY,
    CIRCULAR_ORIFICE,
    CLEARANCE,
    SPEED,
    case,
    down,
    feeding,
    journal,
)

from babbitt.kinds.hydrostatic.check import hydrostatic_check
from babbitt.kinds.hydrostatic.closed_forms import lands_of
from babbitt.kinds.hydrostatic.impedance import Compressibility, impedance, static_coefficients
from babbitt.kinds.hydrostatic.lines import DRAFT, ENGINEERING
from babbitt.kinds.hydrostatic.lumped import centred_stiffness, lumped_at
from babbitt.kinds.hydrostatic.lumps import journal_lumps
from babbitt.kinds.hydrostatic.model import Oil, OperatingConditions, Recesses
from babbitt.kinds.hydrostatic.network import Feeding
from babbitt.kinds.hydrostatic.restrictors import Capillary, MembraneValve, MeteredFlow
from babbitt.kinds.hydrostatic.single_recess import pad_at
from babbitt.kinds.hydrostatic.state import state_at
from babbitt.kinds.hydrostatic.supply import FixedPressure, Pump
from babbitt.kinds.hydrostatic.surfaces import FilmOil, ring_surface

OIL = Compressibility(5e-6, 1.2e9)
PUMP = MeteredFlow(4e-6)


def printed(text):
    """A printed number with the tolerance that its digits allow."""
    digits = text.split("e")[0].replace(".", "").replace("-", "").lstrip("0")
    return pytest.approx(float(text), rel=max(1e-6, 0.51 * 10.0 ** -(len(digits) - 1) / (int(digits[0]) or 1)))


def pad(restrictor, duty, supply=None):
    return case(
        CIRCULAR, duty, "quick", "hydrostatic_pad", Feeding((restrictor,), supply or FixedPressure(5e6)),
        Oil(0.03, 870.0, 2000.0), recesses=Recesses(1e-3, 1.0), compressibility=OIL,
    )  # fmt: skip


AT_GAP, LOADED = (
    OperatingConditions(None, gap=40e-6, angular_speed=SPEED),
    OperatingConditions(15e3, angular_speed=SPEED),
)
ROWS = {  # gap in um, pressure ratio, W, Q, K, C of stiff oil, friction and pumping power, temperature rise
    "capillary": (CIRCULAR_CAPILLARY, AT_GAP, "40 0.5230329 11112.062 4.2143525e-6 3.9750664e8 7.0830863e6 "
                  "170.7768 21.07176 26.1624"),
    "orifice": (CIRCULAR_ORIFICE, AT_GAP, "40 0.6303137 13391.290 5.0787708e-6 5.4215809e8 7.7871742e6 "
                "170.7768 25.39385 22.1986"),
    "capillary, 15 kN": (CIRCULAR_CAPILLARY, LOADED, "30.80095 0.7060339 15000 2.5974047e-6 4.2948271e8 "
                         "1.1022956e7 221.6455 12.98702 51.9158"),
    "orifice, 15 kN": (CIRCULAR_ORIFICE, LOADED, "37.07214 0.7060339 15000 4.5288771e-6 5.5153001e8 8.5792298e6 "
                       "184.2284 22.64439 26.2521"),
    "pump": (PUMP, AT_GAP, "40 0.4964301 10546.875 4.0000000e-6 7.9101562e8 1.2942963e7 170.7768 20.00000 "
             "27.4105"),
}  # fmt: skip


@pytest.mark.parametrize("name", ROWS)
def test_round_pads(name):
    restrictor, duty, row = ROWS[name]
    gap, ratio, load, flow, stiffness, damping, friction, pumping, rise = row.split()
    made = pad(restrictor, duty)
    result = hydrostatic_check(made)
    assert 1e6 * result.gap == (pytest.approx(40.0) if gap == "40" else printed(gap))
    assert result.mean_pressure_ratio == printed(ratio)
    assert result.load == (pytest.approx(15e3) if load == "15000" else printed(load))
    assert result.total_flow == printed(flow)
    assert result.gap_stiffness == printed(stiffness)
    stiff = pad_at(lands_of(CIRCULAR), made.feeding, 0.03, result.gap)
    assert static_coefficients(stiff.response, stiff.network)[1][0, 0] == printed(damping)
    assert result.friction_power == printed(friction)
    assert result.pumping_power == printed(pumping)
    assert result.temperature_rise == printed(rise)


def test_round_pad_constants():
    lands = lands_of(CIRCULAR)
    assert CIRCULAR_CAPILLARY.conductance == printed("1.767145868e-12")
    assert CIRCULAR_ORIFICE.factor == printed("3.735570396e-9")
    assert lands.effective_area == printed("4.249087633e-3")
    assert lands.conductance(40e-6, 0.03) == printed("1.611505828e-12")
    assert lands.squeeze_damping(40e-6, 0.03) == printed("1.739313866e6")
    assert CIRCULAR_CAPILLARY.reynolds_number(4.417865e-6) == pytest.approx(250.0, abs=25.0)
    assert CIRCULAR_CAPILLARY.law(2.5e6, 5e6)[0] == printed("4.417865e-6")
    assert Capillary(0.6e-3, 0.06, 0.03, entry_loss=2.24).law(2.5e6, 5e6)[0] == printed("4.062404e-6")


def test_pump_and_membrane_of_round_pads():
    result = hydrostatic_check(pad(CIRCULAR_CAPILLARY, AT_GAP, Pump(5e-6, 1e-13)))
    assert 1e-6 * result.supply_pressure == printed("5.302955")
    assert 1e-6 * result.arrays["recess_pressure"][0][0] == printed("2.773620")
    state = pad_at(lands_of(CIRCULAR), Feeding((MembraneValve(0.5e-12, 2e-7),), FixedPressure(5e6)), 0.03, 40e-6)
    assert state.recess_pressure == printed("2.614178e6")
    assert state.flow == printed("4.212764e-6")
    assert state.network.slope[0] == printed("1.059132e-13")
    assert static_coefficients(state.response, state.network)[0][0, 0] == printed("7.817138e8")


def test_least_power_of_the_round_pad():
    """Land friction only, at half the supply pressure: the recess is made so deep that it does not rub."""
    lands = lands_of(CIRCULAR)
    gap = 51.82774e-6
    friction = 0.03 * SPEED**2 * lands.friction_area / gap
    pumping = lands.conductance(gap, 0.03) * 2.5e6 * 5e6
    assert (friction, pumping) == (printed("131.4528"), printed("43.81761"))
    assert friction == pytest.approx(3.0 * pumping, rel=1e-6)


@pytest.mark.parametrize(
    ("restrictor", "loss"), [(CIRCULAR_CAPILLARY, 6.9), (CIRCULAR_ORIFICE, 9.7), (PUMP, 15.8)]
)
def test_damping_lost_by_round_pads(restrictor, loss):
    result = hydrostatic_check(pad(restrictor, AT_GAP))
    assert 100.0 * result.compressibility_damping_loss == pytest.approx(loss, abs=0.05)


def test_annular_pad():
    lands = lands_of(ANNULAR)
    tubes = Capillary(0.8e-3, 0.06, 0.02, 4)
    fed = Feeding((tubes,), FixedPressure(3e6))
    assert tubes.conductance == printed("3.3510322e-11")
    assert lands.squeeze_damping(50e-6, 0.02) == printed("5.0929931e5")
    for grid in (DRAFT, ENGINEERING):  # polynomials across: hardly any grid is left
        film = state_at(lambda own: ring_surface(ANNULAR, 50e-6, FilmOil(0.02, 0.0, 3e6), own), fed,
                        np.zeros(3), grid)  # fmt: skip
        stiffness, damping = impedance(film.response, film.network, OIL, 200.0 * math.pi)
        assert stiffness[0, 0] == printed("8.4310589e8")
        assert damping[0, 0] == printed("4.5704855e6")


def test_quick_networks_of_journals():
    for number, land, known in ((3, 30.0, "4.6869867e8"), (4, 30.0, "6.1264365e8"), (6, 20.0, "6.8813186e8")):
        bearing = journal(number=number, land=land)
        lumps, fed = journal_lumps(bearing, 0.02, 0.0), feeding(number=number)
        centred = lumped_at(lumps, fed, np.zeros(2))
        stiffness = static_coefficients(centred.response, centred.network)[0][1, 1]
        assert stiffness == printed(known)
        assert centred_stiffness(bearing, 5e6, centred.network.pressures[0] / 5e6) == printed(known)


@pytest.mark.parametrize(("number", "land"), [(3, 30.0), (4, 30.0), (6, 20.0)])
@pytest.mark.parametrize("share", [0.0, 0.5, 20.0 / 90.0])  # load onto a recess, between, anywhere
def test_quick_network_near_the_centre_is_its_closed_form(number, land, share):
    """At an eccentricity of 1e-4 to 1e-8; what is left is of second order, and nothing beside it."""
    bearing = journal(-90.0 + share * 360.0 / number, number, land)
    lumps, fed = journal_lumps(bearing, 0.02, 0.0), feeding(number=number)
    ratio = lumped_at(lumps, fed, np.zeros(2)).network.pressures[0] / 5e6
    closed = centred_stiffness(bearing, 5e6, ratio)

    def excess(eps):
        up, below = (lumped_at(lumps, fed, down(one)).response.force[1] for one in (-eps, eps))
        return (below - up) / (2.0 * eps * CLEARANCE) / closed - 1.0

    assert excess(1e-4) == pytest.approx(0.0, abs=1e-8)
    assert excess(8e-3) / excess(4e-3) == pytest.approx(4.0, rel=2e-3)
    assert (4.0 * excess(5e-5) - excess(1e-4)) / 3.0 == pytest.approx(0.0, abs=1e-10)
