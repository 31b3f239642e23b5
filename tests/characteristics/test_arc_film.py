"""The Reynolds solution behind the tables: limits, balances and order of accuracy."""

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad
from scipy.optimize import brentq

from babbitt.validation.research.arc_film import FULL, solve_arc
from babbitt.validation.research.film_grid import axial_nodes, circumferential_nodes
from babbitt.validation.research.ruptured_film import flow_balance, force, ruptured_pressure, side_flow_number


def film(eccentricity_ratio, width_ratio, cells, start=0.0, end=FULL):
    balance = flow_balance(start, end, eccentricity_ratio, width_ratio, cells)
    pressure, wet = ruptured_pressure(balance, np.ones((cells[0] - 1, cells[1]), dtype=bool))
    return balance, pressure, wet


@pytest.mark.parametrize(("eccentricity_ratio", "tolerance"), [(0.2, 0.002), (0.5, 0.003), (0.8, 0.009)])
def test_narrow_bearing_is_ocvirks_short_bearing(eccentricity_ratio, tolerance):
    x, eps = 0.05, eccentricity_ratio
    narrow = solve_arc(FULL, x, eps, cells=(90, 8))
    root = math.sqrt(math.pi**2 * (1 - eps**2) + 16 * eps**2)
    assert narrow.sommerfeld_number == pytest.approx(0.5 * x**2 * eps / (1 - eps**2) ** 2 * root, rel=tolerance)
    short_attitude = math.atan2(math.pi * math.sqrt(1 - eps**2), 4 * eps)
    assert narrow.attitude_angle == pytest.approx(short_attitude, abs=math.radians(0.05))
    assert narrow.side_flow_number == pytest.approx(x * eps / 4, rel=0.002)
    assert math.pi < narrow.film_end_angle < math.pi + x  # half the film, but for a strip of about the width


@pytest.mark.parametrize("eccentricity_ratio", [0.2, 0.6, 0.9])
def test_wide_bearing_is_sommerfelds_with_reynolds_rupture(eccentricity_ratio):
    def gap(phi):
        return 1 + eccentricity_ratio * np.cos(phi)

    def slope(phi, rupture):  # of the pressure in a film without side flow that ruptures at `rupture`
        return 6 * (gap(phi) - gap(rupture)) / gap(phi) ** 3

    rupture = brentq(lambda end: quad(slope, 0, end, args=(end,))[0], 3.2, 5.0, xtol=1e-13)
    # by parts: int P cos = -int P' sin, int P sin = int P' cos, since P = 0 at both ends
    along = 0.5 * quad(lambda phi: slope(phi, rupture) * np.sin(phi), 0, rupture)[0]
    across = 0.5 * quad(lambda phi: slope(phi, rupture) * np.cos(phi), 0, rupture)[0]

    # side flow costs load in proportion to D/B; two widths extrapolate to none
    wide, wider = (solve_arc(FULL, x, eccentricity_ratio, cells=(90, 28)) for x in (8.0, 16.0))
    forces = [s.sommerfeld_number * np.exp(1j * s.attitude_angle) for s in (wide, wider)]
    endless = 2 * forces[1] - forces[0]
    assert_allclose([endless.real, endless.imag], [along, across], rtol=0.002)
    assert wider.film_end_angle == pytest.approx(rupture, abs=0.01)


def test_force_turns_square_to_the_centres_as_a_short_bearing_nears_its_centre():
    turned = [solve_arc(FULL, x, 1e-4, cells=(60, 6)).attitude_angle for x in (0.2, 0.1, 0.05)]
    assert turned == sorted(turned)
    assert math.degrees(turned[-1]) == pytest.approx(90.0, abs=0.6)


@pytest.mark.parametrize("span_degrees", [360, 180, 90])
def test_load_and_flow_are_proportional_to_a_small_eccentricity(span_degrees):
    near, nearer = (solve_arc(math.radians(span_degrees), 0.8, eps, cells=(60, 6)) for eps in (2e-4, 1e-4))
    assert near.sommerfeld_number == pytest.approx(2 * nearer.sommerfeld_number, rel=1e-5)
    assert near.side_flow_number == pytest.approx(2 * nearer.side_flow_number, rel=1e-3)


@pytest.mark.parametrize(("eccentricity_ratio", "width_ratio"), [(0.3, 1.0), (0.7, 0.5), (0.95, 1.0)])
def test_error_is_of_second_order(eccentricity_ratio, width_ratio):
    numbers = []
    for cells in ((60, 6), (120, 12), (240, 24)):
        balance, pressure, wet = film(eccentricity_ratio, width_ratio, cells)
        flow = side_flow_number(balance, pressure, wet, width_ratio)
        numbers.append([math.hypot(*force(balance, pressure)), flow])
    coarse, middle, fine = np.array(numbers)
    order = np.log2(np.abs((coarse - middle) / (middle - fine)))
    assert_allclose(order[0], 2.0, atol=0.15)
    assert order[1] > 1.7  # the flow rides on the ragged edge of the ruptured region


@pytest.mark.parametrize(("eccentricity_ratio", "width_ratio"), [(0.5, 1.0), (0.9, 0.4), (0.97, 1.5)])
def test_what_enters_the_film_and_does_not_leave_at_its_end_leaves_at_the_rims(eccentricity_ratio, width_ratio):
    # oil dragged in at the widest gap less oil dragged out at the rupture, plus the pressure flow at the inlet
    balance, pressure, wet = film(eccentricity_ratio, width_ratio, (720, 40))
    slope_in = (pressure[1] - pressure[0]) / (balance.angle[1] - balance.angle[0])
    gap_in = 1 + eccentricity_ratio * math.cos(0.5 * balance.angle[1])
    inflow = gap_in - gap_in**3 * float(balance.depth @ slope_in) / 6
    ends = [balance.angle[1 + np.flatnonzero(row).max()] for row in wet.T]
    gaps_out = 1 + eccentricity_ratio * np.cos([*ends, math.pi])
    outflow = float(balance.depth @ gaps_out)
    flow = width_ratio * (inflow - outflow) / 4 / 2  # q/(D^3 psi omega): U C_R B/2 = D^3 psi omega x/8
    assert side_flow_number(balance, pressure, wet, width_ratio) == pytest.approx(flow, rel=0.004)


def test_side_flow_is_the_pressure_slope_at_the_rim():
    eccentricity_ratio, width_ratio = 0.7, 0.8
    balance, pressure, wet = film(eccentricity_ratio, width_ratio, (360, 40))
    near, far = 1 - axial_nodes(40)[[-2, -3]]
    slope = (pressure[:, -2] * far / near - pressure[:, -3] * near / far) / (far - near)
    gap = 1 + eccentricity_ratio * np.cos(balance.angle)
    expected = float(balance.width @ (gap**3 * slope)) / (48 * width_ratio)
    assert side_flow_number(balance, pressure, wet, width_ratio) == pytest.approx(expected, rel=1e-3)


def test_ruptured_film_meets_reynolds_condition():
    slopes = []
    for cells in ((120, 10), (480, 10)):
        balance, pressure, wet = film(0.6, 1.0, cells)
        assert (pressure >= 0).all()
        assert (pressure[1:-1, :-1][~wet] == 0).all()
        assert 0.3 < wet.mean() < 0.9
        last = int(np.flatnonzero(pressure[:, 0]).max())
        slopes.append(np.diff(pressure[:, 0])[last - 1] / np.diff(balance.angle)[last - 1])
    # pressure and slope vanish together, so the slope at the last wet node goes with the size of the cell
    assert slopes[0] < slopes[1] < 0.0
    assert slopes[1] / slopes[0] < 0.45


def test_starting_guess_does_not_matter():
    span = math.radians(120)
    cold = solve_arc(span, 0.7, 0.85, cells=(60, 6))
    warm = solve_arc(span, 0.7, 0.85, cells=(60, 6), attitude_guess=0.9)
    assert warm.attitude_angle == pytest.approx(cold.attitude_angle, abs=1e-8)
    assert warm.sommerfeld_number == pytest.approx(cold.sommerfeld_number, rel=1e-8)


def test_arc_that_reaches_the_widest_gap_and_beyond_the_rupture_is_a_full_bearing():
    # attitude 60.4 deg: an arc of 242 deg begins at the widest gap; what it lacks lies in the ruptured region
    full = solve_arc(FULL, 0.5, 0.42, cells=(120, 8))
    span = 2 * (math.pi - full.attitude_angle)
    arc = solve_arc(span, 0.5, 0.42, cells=(120, 8))
    assert arc.sommerfeld_number == pytest.approx(full.sommerfeld_number, rel=1e-4)
    assert arc.attitude_angle == pytest.approx(full.attitude_angle, abs=1e-4)
    assert arc.side_flow_number == pytest.approx(full.side_flow_number, rel=1e-3)
    assert arc.film_end_angle == pytest.approx(full.film_end_angle, abs=0.02)


def test_nodes_crowd_where_the_gap_is_narrow():
    even = circumferential_nodes(0.5, 4.0, 0.0, 50)
    assert_allclose(even, np.linspace(0.5, 4.0, 51), atol=1e-12)
    angle = circumferential_nodes(0.0, FULL, 0.99, 100)
    steps = np.diff(angle)
    assert (steps > 0).all()
    assert steps.max() < 2.0 * FULL / 100
    assert steps[50] < 0.15 * FULL / 100
    assert_allclose(angle + angle[::-1], FULL, atol=1e-12)


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        ((0.0, 1.0, 0.5), "span"),
        ((7.0, 1.0, 0.5), "span"),
        ((FULL, 0.0, 0.5), "width ratio"),
        ((FULL, math.nan, 0.5), "width ratio"),
        ((FULL, 1.0, 0.0), "eccentricity"),
        ((FULL, 1.0, 1.0), "eccentricity"),
    ],
)
def test_impossible_bearings_are_refused(arguments, named):
    with pytest.raises(ValueError, match=named):
        solve_arc(*arguments)


def test_grid_of_a_handful_of_cells_is_refused():
    with pytest.raises(ValueError, match="cells"):
        solve_arc(FULL, 1.0, 0.5, cells=(40, 2))
