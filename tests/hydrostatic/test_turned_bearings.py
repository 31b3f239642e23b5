"""Turning a bearing with recesses, its load with it, changes nothing but angles."""

import math

import numpy as np
import pytest
from hydrostatic_bearings import CLEARANCE, SPEED, feeding, journal, journal_film

from babbitt.case import parse_case
from babbitt.core.result import Outcome
from babbitt.kinds.hydrostatic.geometry import RecessedJournal, pitches_around
from babbitt.kinds.hydrostatic.impedance import Compressibility, damping_loss, impedance
from babbitt.kinds.hydrostatic.state import state_at
from babbitt.kinds.hydrostatic.surfaces import Grid
from babbitt.solving import solve

LOOSE = Grid(48, 4)
OIL = Compressibility(1e-5, 1e9)


def loss_turned_by(angle, speed=SPEED):
    place = 0.5 * CLEARANCE * np.array([math.cos(angle - 1.2), math.sin(angle - 1.2)])
    state = state_at(journal_film(journal(math.degrees(angle) - 90.0), speed), feeding(), place, LOOSE)
    return damping_loss(state.response, state.network, OIL), state


@pytest.mark.parametrize("angle", [0.3, 0.25 * math.pi, 2.0, -2.9])
def test_damping_lost_to_the_oil_knows_no_axes(angle):
    upright, turned = loss_turned_by(0.0)[0], loss_turned_by(angle)[0]
    assert 0.0 < upright < 1.0
    assert turned == pytest.approx(upright, rel=1e-9)


def test_no_motion_loses_more_than_the_largest_share():
    """Power lost by motions in all directions, over what damping takes from them: the loss is its maximum."""
    loss, state = loss_turned_by(0.0)
    stiff = impedance(state.response, state.network, Compressibility(0.0, 1e9), 0.0)[1]
    soft = impedance(state.response, state.network, OIL, 0.0)[1]
    angles = np.linspace(0.0, math.pi, 721)
    motions = np.array([np.cos(angles), np.sin(angles)])
    power = np.einsum("ik,ij,jk->k", motions, stiff, motions)
    shares = np.einsum("ik,ij,jk->k", motions, stiff - soft, motions) / power
    assert shares.max() == pytest.approx(loss, rel=1e-4)


@pytest.mark.parametrize("angle", [-135, -125, -60, -50, -40, -30, 0, 10, 130, 140, 170, 350])
def test_a_single_recess_stands_anywhere(angle):
    """Its distance to itself is a turn; a remainder of that once left 5e-14 degrees."""
    assert pitches_around((math.radians(angle),)) == pytest.approx([2.0 * math.pi])
    shape = RecessedJournal(0.1, 0.1, CLEARANCE, (math.radians(angle),), 1.0, 0.07)
    assert shape.is_regular


@pytest.mark.parametrize("angle", [-135, -60, 130])
def test_a_case_with_a_single_recess_is_read_wherever_it_stands(angle):
    parse_case(SINGLE.replace("ANGLE", str(angle)))


def test_pitches_of_a_row_sum_to_a_turn():
    assert pitches_around((3.0, -1.0, 0.5)) == pytest.approx([2.5, 2.0 * math.pi - 4.0, 1.5])


SINGLE = """
kind: hydrostatic_journal
name: One recess
diameter: 100 mm
width: 100 mm
radial_clearance: 50 um
recesses: {number: 1, first: ANGLE deg, extent: 60 deg}
recess_length: 70 mm
recess_oil: {depth: 1 mm, bulk_modulus: 1 GPa}
restrictor: {kind: capillary, diameter: 0.8 mm, length: 100 mm}
supply: {pressure: 5 MPa}
oil: {viscosity: 20 mPa s, density: 870 kg/m3, heat_capacity: 2000 J/(kg K)}
load: 2 kN
load_angle: -90 deg
speed: 1500 rpm
"""


@pytest.mark.thorough
@pytest.mark.parametrize("first", ["-133.92 deg", "-96.61 deg"])
def test_a_ring_with_twice_the_load_is_overloaded_wherever_its_recesses_stand(first):
    """1.8 MPa over all of its 2.0 m² carry half of 7.2 MN; in one of the frames the search came to no end."""
    turn = math.radians(float(first.split()[0]) + 133.92)
    x, y = 47054.0, 258050.0
    moments = (x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn))
    text = OVERLOADED.replace("FIRST", first).replace("MOMENTS", ", ".join(f"{one!r} N m" for one in moments))
    (result,) = solve(parse_case(text)).results
    assert result.outcome is Outcome.OVERLOADED


OVERLOADED = """
kind: hydrostatic_thrust_ring
method: film
name: Ring
accuracy: draft
recess_oil: {depth: 0.722 mm}
supply: {pump_flow: 74.83 L/min, relief_pressure: 1.8009 MPa}
oil: {lubricant: ISO VG 68, supply_temperature: 42.6 degC}
restrictor: {kind: membrane_valve, conductance: 11.641 L/(min MPa), compliance: 0.04321 1/MPa}
outer_diameter: 1906.32 mm
inner_diameter: 1037.08 mm
recess_inner_diameter: 1186.36 mm
recess_outer_diameter: 1757.04 mm
recesses: {number: 8, extent: 18.439 deg, first: FIRST}
load: 7.1921e+06 N
moments: [MOMENTS]
speed: 40.523 rpm
"""
