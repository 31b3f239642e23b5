"""Recessed bearings against the prototype: finite volumes on graded grids with evidence of convergence."""

import math

import numpy as np
import pytest
from hydrostatic_bearings import (
    CAPILLARY,
    CLEARANCE,
    RING,
    RING_FEEDING,
    SPEED,
    case,
    down,
    feeding,
    journal,
    journal_film,
    ring_film,
)

from babbitt.kinds.hydrostatic.answer import answer
from babbitt.kinds.hydrostatic.check import hydrostatic_check
from babbitt.kinds.hydrostatic.friction import film_lands, pressure_torque, recess_inertia
from babbitt.kinds.hydrostatic.impedance import Compressibility, impedance, static_coefficients
from babbitt.kinds.hydrostatic.jacking import gap_for_flow, lift_at
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.lines import ENGINEERING, REFERENCE, Grid
from babbitt.kinds.hydrostatic.model import OperatingConditions
from babbitt.kinds.hydrostatic.restrictors import CheckValve, ConstantFlow, FlowValve, Orifice
from babbitt.kinds.hydrostatic.state import SearchOutcome, equilibrium_under, state_at
from babbitt.kinds.hydrostatic.supply import Pump

FINE = Grid(288, 8)
"""Lines between 4x and 8x of the prototype; its own figures of thin lands are good to 2e-3 at 4x."""

# eccentricity: W, K_yy, K_xx, Q on a recess; W, K_yy, K_xx between recesses
AT_REST = {
    0.0: (0.0, 6.30206e8, 6.30206e8, 5.013869e-5, 0.0, 6.30206e8, 6.30206e8),
    0.1: (3147.49, 6.28019e8, 6.26542e8, 5.013944e-5, 3140.13, 6.23681e8, 6.30983e8),
    0.2: (6270.09, 6.19661e8, 6.15884e8, 5.014755e-5, 6215.63, 6.04474e8, 6.32692e8),
    0.3: (9325.67, 6.00191e8, 5.99145e8, 5.018218e-5, 9165.56, 5.73706e8, 6.33645e8),
    0.4: (12242.46, 5.63032e8, 5.77564e8, 5.027886e-5, 11936.56, 5.33285e8, 6.31581e8),
    0.5: (14916.90, 5.02555e8, 5.52353e8, 5.048932e-5, 14486.76, 4.85899e8, 6.24361e8),
    0.6: (17225.97, 4.17050e8, 5.24328e8, 5.087331e-5, 16789.56, 4.34944e8, 6.10660e8),
    0.7: (19051.73, 3.10272e8, 4.93558e8, 5.148130e-5, 18837.01, 3.84507e8, 5.90429e8),
}


def at_rest(first, eps, fed=None, grid=ENGINEERING, **layout):
    return state_at(journal_film(journal(first, **layout)), fed or feeding(), down(eps), grid)


@pytest.mark.parametrize("eps", AT_REST)
def test_four_recesses_at_rest(eps):
    load, k_yy, k_xx, flow, load_between, k_yy_between, k_xx_between = AT_REST[eps]
    for first, expected in ((-90.0, (load, k_yy, k_xx)), (-45.0, (load_between, k_yy_between, k_xx_between))):
        state = at_rest(first, eps)
        stiffness, _ = static_coefficients(state.response, state.network)
        assert state.force[1] == pytest.approx(expected[0], rel=5e-4, abs=1e-5)
        assert (stiffness[1, 1], stiffness[0, 0]) == pytest.approx(expected[1:], rel=5e-3)
        assert state.mass_balance_error < 1e-9
        if first == -90.0:
            assert state.network.flows.sum() == pytest.approx(flow, rel=1e-3)


# first recess, eccentricity: pressures over that of the supply, or none printed; damping C_yy with its tolerance
PRESSURES = {
    (-90.0, 0.0): ((0.501261,) * 4, 5.91735e6, 5e-3),
    (-90.0, 0.5): ((0.817374, 0.441166, 0.291389, 0.441166), 7.56448e6, 5e-3),
    (-45.0, 0.5): ((0.675516, 0.321884, 0.321884, 0.675516), 7.83956e6, 5e-3),
    (-90.0, 0.7): (None, 1.00081e7, 8e-3),
    (-45.0, 0.7): (None, 1.50171e7, 8e-3),
}


@pytest.mark.parametrize("place", PRESSURES)
def test_recess_pressures_and_damping_at_rest(place):
    pressures, damping, tolerance = PRESSURES[place]
    state = at_rest(*place)
    assert pressures is None or state.network.pressures / 5e6 == pytest.approx(pressures, rel=1e-3)
    assert static_coefficients(state.response, state.network)[1][1, 1] == pytest.approx(damping, rel=tolerance)


# first recess, eccentricity: what the prototype extrapolates to, W, K_yy, Q, C_yy
EXTRAPOLATED = {
    (-90.0, 0.5): (14916.07, 5.02398e8, 5.04790e-5, None),
    (-90.0, 0.7): (19048.86, 3.10032e8, None, 1.00165e7),
    (-45.0, 0.7): (18838.64, 3.84568e8, None, 1.50383e7),
}


@pytest.mark.parametrize("place", EXTRAPOLATED)
def test_extrapolation_meets_that_of_the_prototype(place):
    load, stiffness, flow, damping = EXTRAPOLATED[place]
    found = []
    for lines in (384, 192):
        state = at_rest(*place, grid=Grid(lines, 18))
        k, c = static_coefficients(state.response, state.network)
        found.append(np.array([state.force[1], k[1, 1], state.network.flows.sum(), c[1, 1]]))
    best = found[0] + (found[0] - found[1]) / 3.0
    for ours, known, tolerance in zip(
        best, (load, stiffness, flow, damping), (2e-4, 5e-4, 2e-4, 5e-4), strict=True
    ):
        assert known is None or ours == pytest.approx(known, rel=tolerance)


@pytest.mark.parametrize(
    ("layout", "fed", "load", "stiffness"),
    [
        ({}, feeding(Orifice(0.35e-3, 870.0)), 13975.3, 8.08277e8),
        ({}, feeding(ConstantFlow(1.25e-5)), 45535.5, 4.09133e9),
        ({"groove": 6.0}, feeding(), 13830.8, 5.52081e8),
        ({"groove": 6.0, "first": -45.0}, feeding(), 12424.5, 4.27847e8),
        ({"number": 3}, feeding(number=3), 15038.0, None),
        ({"number": 6, "land": 20.0}, feeding(number=6), 15949.7, None),
    ],
)
def test_other_restrictors_and_layouts(layout, fed, load, stiffness):
    state = at_rest(**({"first": -90.0} | layout), eps=0.5, fed=fed, grid=FINE)
    assert state.force[1] == pytest.approx(load, rel=5e-4)
    if stiffness is not None:
        assert static_coefficients(state.response, state.network)[0][1, 1] == pytest.approx(stiffness, rel=2e-3)


CENTRED = {  # layout, feeding: flow, pressure ratio, stiffness
    "orifice": ({}, feeding(Orifice(0.35e-3, 870.0)), 2.188118e-5, 0.218757, 4.16723e8),
    "pumps": ({}, feeding(ConstantFlow(1.25e-5)), 5e-5, 0.499875, 1.03889e9),
    "flow valves": ({}, feeding(FlowValve(1e-5, 1e-12, 1e-9)), 4.999687e-5, 0.499843, 1.19399e9),
    "drain grooves": ({"groove": 6.0}, feeding(), 7.052805e-5, 0.298445, 5.29258e8),
    "three": ({"number": 3}, feeding(number=3), 4.340462e-5, 0.424328, 4.99774e8),
    "six": ({"number": 6, "land": 20.0}, feeding(number=6), 6.110259e-5, 0.594801, 6.91469e8),
}


@pytest.mark.parametrize("name", CENTRED)
def test_centred_journals(name):
    layout, fed, flow, ratio, stiffness = CENTRED[name]
    state = at_rest(-90.0, 0.0, fed=fed, grid=FINE, **layout)
    assert state.network.flows.sum() == pytest.approx(flow, rel=1e-3)
    assert state.network.pressures / 5e6 == pytest.approx(np.full(len(fed.restrictors), ratio), rel=1e-3)
    assert static_coefficients(state.response, state.network)[0][1, 1] == pytest.approx(stiffness, rel=5e-3)


def test_common_pump():
    state = at_rest(-90.0, 0.5, feeding(supply=Pump(5e-5, 1e-12)))
    assert state.network.supply_pressure == pytest.approx(4.505372e6, rel=1e-3)
    assert state.force[1] == pytest.approx(13441.2, rel=1e-3)
    assert state.network.flows.sum() == pytest.approx(4.54946e-5, rel=1e-3)


def test_steep_flow_valves_have_no_stable_state():
    assert at_rest(-90.0, 0.5, feeding(FlowValve(1e-5, 6e-12, 1.0))).ending is SearchOutcome.UNSTABLE_NETWORK


@pytest.mark.parametrize(
    ("hertz", "stiffness", "damping"),
    [(0.0, 6.30206e8, 5.73585e6), (10.0, 6.35990e8, 5.73419e6), (100.0, 1.190485e9, 5.57440e6),
     (1000.0, 1.41549e10, 1.83839e6), (1e4, 1.82266e10, 6.65048e5)],
)  # fmt: skip
def test_compressible_recesses(hertz, stiffness, damping):
    state = at_rest(-90.0, 0.0)
    found = impedance(state.response, state.network, Compressibility(3.6651914e-6, 1e9), 2.0 * math.pi * hertz)
    assert found[0][1, 1] == pytest.approx(stiffness, rel=2e-3)
    assert found[1][1, 1] == pytest.approx(damping, rel=5e-3)


@pytest.mark.parametrize(
    ("first", "angle", "place"),
    [(-90.0, -90.0, (0.0, -0.322592)), (-45.0, -90.0, (0.0, -0.329367)), (-90.0, -70.0, (0.114464, -0.304627))],
)
def test_equilibrium_at_rest(first, angle, place):
    load = 10e3 * np.array([math.cos(math.radians(angle)), math.sin(math.radians(angle))])
    state = equilibrium_under(journal_film(journal(first)), feeding(), load, np.zeros(2), ENGINEERING, 1e-7)
    assert state.solved
    assert state.at / CLEARANCE == pytest.approx(place, abs=1e-4)
    assert state.force == pytest.approx(-load, abs=1e-5)
    assert state.steps <= 5


def hybrid(load, restrictor=CAPILLARY, grid=ENGINEERING):
    return equilibrium_under(
        journal_film(journal(), SPEED), feeding(restrictor), np.array([0.0, -load]), np.zeros(2), grid, 1e-7
    )


HYBRID = {
    "20 kN": (20e3, CAPILLARY, 0.529596, 40.694, (0.91042, 0.44191, 0.24276, 0.39886), 5.04177e-5,
              4.5521e6, 0.0),
    "30 kN": (30e3, CAPILLARY, 0.806094, 44.019, (1.10406, 0.38428, 0.15993, 0.31796), 5.11142e-5,
              6.938e6, 0.066),
    "check": (30e3, CheckValve(CAPILLARY), 0.728366, 43.750, (1.16918, 0.40509, 0.18105, 0.34287),
              5.20495e-5, 5.888e6, 0.039),
}  # fmt: skip


@pytest.mark.parametrize("name", HYBRID)
def test_hybrid_equilibrium(name):
    load, restrictor, eps, attitude, pressures, flow, highest, dry = HYBRID[name]
    state = hybrid(load, restrictor)
    assert state.solved
    assert math.hypot(*state.at) / CLEARANCE == pytest.approx(eps, abs=2e-3)
    assert math.degrees(math.atan2(state.at[1], state.at[0])) + 90.0 == pytest.approx(attitude, abs=0.1)
    assert state.network.pressures / 5e6 == pytest.approx(pressures, abs=2e-3)
    assert state.network.flows.sum() == pytest.approx(flow, rel=2e-3)
    assert state.mass_balance_error < 1e-9
    assert state.maximum_pressure == pytest.approx(highest, rel=6e-3)
    assert state.dry_share == pytest.approx(dry, abs=0.012)  # of nodes: the grids differ
    back = -2.615e-6 if name == "30 kN" else 0.0
    assert min(state.network.flows.min(), 0.0) == pytest.approx(back, rel=5e-3)


COEFFICIENTS = {
    "20 kN": ((5.2391e8, 6.0337e8, -4.3164e8, 5.2976e8), (7.1106e6, -1.0091e6, -1.0091e6, 7.3765e6), 0.005),
    "check": ((7.250e8, 8.825e8, -8.157e8, 1.6017e9), (1.0876e7, -4.990e6, -4.990e6, 2.1994e7), 0.004),
}


@pytest.mark.parametrize("name", COEFFICIENTS)
def test_hybrid_coefficients(name):
    """By the variation that the prototype states for its own, with and without rupture."""
    stiffness, damping, tolerance = COEFFICIENTS[name]
    state = hybrid(*HYBRID[name][:2], REFERENCE)
    found = static_coefficients(state.response, state.network)
    assert found[0].ravel() == pytest.approx(stiffness, rel=tolerance)
    assert found[1].ravel() == pytest.approx(damping, rel=tolerance)


def test_hybrid_coefficients_with_rupture_on_a_fine_grid():
    """Rupture frozen on grid lines: the prototype itself varies by 2 % in K_xy and 16e6 N/m in K_yy."""
    state = hybrid(*HYBRID["30 kN"][:2], REFERENCE)
    stiffness, damping = static_coefficients(state.response, state.network)
    assert (stiffness[0, 0], stiffness[1, 0]) == pytest.approx((1.210e9, -1.3745e9), rel=0.01)
    assert stiffness[0, 1] == pytest.approx(1.08e9, rel=0.02)
    assert stiffness[1, 1] == pytest.approx(1.8e8, abs=2e7)
    assert damping.ravel() == pytest.approx((1.605e7, -1.117e7, -1.117e7, 1.884e7), rel=0.02)


def test_hybrid_at_a_given_place():
    state = state_at(journal_film(journal(), SPEED), feeding(), down(0.6), ENGINEERING)
    assert state.force == pytest.approx((14594.5, 17276.5), rel=2e-3)
    assert state.network.pressures / 5e6 == pytest.approx((0.875927, 0.233829, 0.261948, 0.605199), abs=1e-3)
    assert state.network.flows.sum() == pytest.approx(5.084597e-5, rel=2e-3)
    stiffness, damping = static_coefficients(state.response, state.network)
    assert stiffness.ravel() == pytest.approx((5.3198e8, 6.043e8, -4.2779e8, 4.498e8), rel=0.01)
    assert damping.ravel() == pytest.approx((6.043e6, 1.54e5, 1.54e5, 8.297e6), rel=0.02, abs=2e4)


def test_friction_of_the_hybrid_bearing():
    made = case(duty=OperatingConditions(20e3, -0.5 * math.pi, angular_speed=SPEED), accuracy="engineering")
    found = answer(made)
    shear = 0.02 * SPEED
    assert shear * film_lands(found.film.film, found.at, 0.05) == pytest.approx(3.117872, rel=5e-4)
    assert pressure_torque(made, found) == pytest.approx(0.1726676, rel=1e-3)
    assert shear * 4.0 * recess_inertia(made) / 1e-3 == pytest.approx(0.4605815, rel=1e-6)
    result = hydrostatic_check(made)
    assert (result.friction_power, result.pumping_power, result.power_ratio) == pytest.approx(
        (589.22, 252.24, 2.336), rel=1e-3
    )


RING_TABLE = {
    0.0: (23843.63, -319.674, 0.0, (0.402190, 0.402190, 0.690645, 0.690645)),
    1000.0 * math.pi / 30.0: (23843.63, -319.674, 137.819, (0.372919, 0.431461, 0.741036, 0.640255)),
}


@pytest.mark.parametrize("speed", RING_TABLE)
def test_tilted_thrust_ring(speed):
    force, about_x, about_y, pressures = RING_TABLE[speed]
    state = state_at(ring_film(RING, speed=speed), RING_FEEDING, np.array([0.0, 2e-4, 0.0]), REFERENCE)
    assert state.force[0] == pytest.approx(force, rel=1e-3)
    assert state.force[1] == pytest.approx(about_x, rel=1e-3)
    assert state.force[2] == pytest.approx(about_y, rel=3e-3, abs=1e-6)
    assert state.network.pressures / 3e6 == pytest.approx(pressures, rel=1e-3)
    assert state.network.flows.sum() == pytest.approx(4.559907e-5, rel=1e-3)
    stiffness, damping = static_coefficients(state.response, state.network)
    assert np.diag(stiffness) == pytest.approx((6.00722e8, 1.510440e6, 1.549400e6), rel=5e-3)
    assert (stiffness[0, 1], stiffness[1, 0]) == pytest.approx((-1.34542e6, -4.75716e6), rel=5e-3)
    assert np.diag(damping) == pytest.approx((5.54896e6, 16394.0, 13160.8), rel=5e-3)
    if speed:
        assert (stiffness[1, 2], stiffness[2, 1]) == pytest.approx((7.8632e5, -7.4246e5), rel=5e-3)
        assert (stiffness[0, 2], stiffness[2, 0]) == pytest.approx((-8.1046e5, 5.5484e6), rel=5e-3)


def test_level_thrust_ring():
    state = state_at(ring_film(RING), RING_FEEDING, np.zeros(3), REFERENCE)
    stiffness, damping = static_coefficients(state.response, state.network)
    assert state.force[0] == pytest.approx(23685.87, rel=1e-3)
    assert state.network.flows.sum() == pytest.approx(4.594313e-5, rel=1e-3)
    assert state.network.pressures / 3e6 == pytest.approx([0.542995] * 4, rel=1e-3)
    for matrix, known in (
        (stiffness, (6.49473e8, 1.645353e6, 1.645353e6)),
        (damping, (4.94623e6, 12716.8, 12716.8)),
    ):
        assert matrix == pytest.approx(np.diag(known), rel=2e-3, abs=1e-9 * known[0])
    turning = state_at(ring_film(RING, speed=1000.0 * math.pi / 30.0), RING_FEEDING, np.zeros(3), REFERENCE)
    stiffness, _ = static_coefficients(turning.response, turning.network)
    assert (stiffness[1, 2], stiffness[2, 1]) == pytest.approx((6.6585e5, -6.6585e5), rel=5e-3)


def test_thrust_ring_under_a_load():
    load = np.array([-25e3, 200.0, 0.0])
    state = equilibrium_under(
        ring_film(RING, speed=1000.0 * math.pi / 30.0), RING_FEEDING, load, np.zeros(3), REFERENCE, 1e-7
    )
    assert 50e-6 + state.at[0] == pytest.approx(48.0371e-6, rel=1e-3)
    assert state.at[1:] == pytest.approx((0.99721e-4, 4.3929e-5), rel=3e-3)
    assert state.network.pressures / 3e6 == pytest.approx((0.499744, 0.476814, 0.644598, 0.670920), rel=1e-3)
    assert state.network.flows.sum() == pytest.approx(4.29248e-5, rel=1e-3)
    assert state.force == pytest.approx(-load, abs=1e-4)


LIFT = {  # smallest gap in um: A_e in m2, G mu in m3, pressure in MPa, flow in L/min
    1.0: (2.05196e-3, 2.83142e-17, 9.7468, 1.6558e-4),
    2.0: (2.32405e-3, 6.32807e-17, 8.6057, 3.2674e-4),
    5.0: (2.96336e-3, 2.86786e-16, 6.7491, 1.16133e-3),
    10.0: (3.73493e-3, 1.18916e-15, 5.3549, 3.82066e-3),
    20.0: (4.78686e-3, 5.84580e-15, 4.1781, 1.46546e-2),
    40.0: (6.08781e-3, 3.26036e-14, 3.2853, 6.42666e-2),
    60.0: (6.92157e-3, 9.35739e-14, 2.8895, 0.162230),
}


def jacking(**changes):
    bearing = type(journal())(0.2, 0.15, 150e-6, (-0.5 * math.pi,), math.radians(16.0), 0.04)
    given = {"name": "J", "method": "film", "bearing": bearing, "viscosity": 0.1, "load": 20e3, "lift_gap": 40e-6}
    return JackingCase(**(given | changes))


@pytest.mark.parametrize("gap", LIFT)
def test_jacking_pocket(gap):
    area, conductance, pressure, flow = LIFT[gap]
    point = lift_at(jacking(), 1e-6 * gap)
    tolerance = 3e-3 if gap >= 5.0 else 5e-3
    found = (point.effective_area, 0.1 * point.flow / point.pressure, 1e-6 * point.pressure, 6e4 * point.flow)
    assert found == pytest.approx((area, conductance, pressure, flow), rel=tolerance)


def test_lift_grows_with_the_flow_and_pressure_falls():
    made = jacking()
    assert made.projected_area == pytest.approx(1.113385e-3, rel=1e-6)
    points = [lift_at(made, 1e-6 * gap) for gap in (1.0, 3.0, 10.0, 30.0, 70.0)]
    assert (np.diff([point.pressure for point in points]) < 0.0).all()
    assert (np.diff([point.flow for point in points]) > 0.0).all()
    assert gap_for_flow(made, points[2].flow) == pytest.approx(10e-6, rel=1e-3)
    assert math.isnan(gap_for_flow(made, 1.0))


def test_load_beyond_the_film_is_overload():
    state = equilibrium_under(
        journal_film(journal()), feeding(), np.array([0.0, -30e3]), np.zeros(2), Grid(64, 4), 0.5e-6
    )
    assert state.ending is SearchOutcome.OVERLOADED
    assert 0.65 < state.carried < 0.72  # 21.2 kN at most
