"""The stepped beam against closed forms of textbooks, symmetries and balances."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shafts import on_supports, rigid, upward, weightless

from babbitt.kinds.shaft.answer import answered
from babbitt.kinds.shaft.model import Piece, PointLoad, Shaft, Support

FORCE, SPAN = 12e3, 0.8
EI = weightless(1.0).bending_stiffness


def loads_in_y(shaft):
    """What the bearings carry upward, as the shaft feels it."""
    return -answered(shaft).bearing_forces[:, 1]


def deflection_at(shaft, station):
    curves = answered(shaft).curves
    return np.array([np.interp(station, curves.stations, plane) for plane in curves.deflection.T])


def test_two_equal_spans_under_uniform_load():
    """3/8, 10/8 and 3/8 of the load of a span (any textbook of statics)."""
    piece = Piece(2.0 * SPAN, 0.1)
    found = loads_in_y(on_supports(rigid(0.0, SPAN, 2.0 * SPAN), (), [piece]))
    assert found == pytest.approx(np.array([3.0, 10.0, 3.0]) / 8.0 * piece.weight * SPAN, rel=1e-10)


def test_two_equal_spans_under_a_force_in_the_middle_of_each():
    """5/16, 22/16 and 5/16 of the force."""
    loads = [upward(0.5 * SPAN, -FORCE), upward(1.5 * SPAN, -FORCE)]
    found = loads_in_y(on_supports(rigid(0.0, SPAN, 2.0 * SPAN), loads, [weightless(2.0 * SPAN)]))
    assert found == pytest.approx(np.array([5.0, 22.0, 5.0]) / 16.0 * FORCE, rel=1e-10)


def test_one_span_loaded_lifts_the_far_bearing():
    """13/32, 22/32 and -3/32 of a force in the middle of the first span."""
    loads = [upward(0.5 * SPAN, -FORCE)]
    found = loads_in_y(on_supports(rigid(0.0, SPAN, 2.0 * SPAN), loads, [weightless(2.0 * SPAN)]))
    assert found == pytest.approx(np.array([13.0, 22.0, -3.0]) / 32.0 * FORCE, rel=1e-10)


def test_three_equal_spans_under_uniform_load():
    """0.4, 1.1, 1.1 and 0.4 of the load of a span."""
    piece = Piece(3.0 * SPAN, 0.1)
    found = loads_in_y(on_supports(rigid(0.0, SPAN, 2.0 * SPAN, 3.0 * SPAN), (), [piece]))
    assert found == pytest.approx(np.array([0.4, 1.1, 1.1, 0.4]) * piece.weight * SPAN, rel=1e-10)


def test_a_sunk_middle_bearing_takes_less():
    """Settlement d of the middle of two spans: -6 EI d / L³ on it, half of that on each other bearing."""
    sunk = 0.1e-3
    supports = rigid(0.0, SPAN, 2.0 * SPAN)
    supports = (supports[0], replace(supports[1], offset=(0.0, -sunk)), supports[2])
    found = loads_in_y(on_supports(supports, (), [weightless(2.0 * SPAN)]))
    taken = 6.0 * EI * sunk / SPAN**3
    assert found == pytest.approx([0.5 * taken, -taken, 0.5 * taken], rel=1e-9)


def test_a_soft_middle_bearing_shares_by_its_stiffness():
    """The beam on two bearings sinks F (2L)³ / 48 EI in the middle; the spring and the beam share the force."""
    stiffness = 40e6
    supports = rigid(0.0, SPAN, 2.0 * SPAN)
    supports = (supports[0], replace(supports[1], stiffness=stiffness), supports[2])
    found = loads_in_y(on_supports(supports, [upward(SPAN, -FORCE)], [weightless(2.0 * SPAN)]))
    of_beam = 48.0 * EI / (2.0 * SPAN) ** 3
    taken = FORCE * stiffness / (stiffness + of_beam)
    assert found == pytest.approx([0.5 * (FORCE - taken), taken, 0.5 * (FORCE - taken)], rel=1e-10)


def test_slope_and_deflection_of_a_simple_beam():
    """F L² / 16 EI at its ends and F L³ / 48 EI in the middle; the slope is dy/dz, positive behind the load."""
    shaft = on_supports(rigid(0.0, SPAN), [upward(0.5 * SPAN, -FORCE)], [weightless(SPAN)])
    answer = answered(shaft)
    slope = FORCE * SPAN**2 / (16.0 * EI)
    assert answer.slopes[:, 1] == pytest.approx([-slope, slope], rel=1e-12)
    assert answer.slopes[:, 0] == pytest.approx(0.0, abs=1e-15)
    assert deflection_at(shaft, 0.5 * SPAN)[1] == pytest.approx(-FORCE * SPAN**3 / (48.0 * EI), rel=1e-12)
    assert np.abs(answer.curves.moment).max() == pytest.approx(FORCE * SPAN / 4.0, rel=1e-12)


def test_a_couple_tilts_both_ends_alike():
    """A couple M in the middle: M L / 24 EI at both ends, of the other sign, as it turns the middle."""
    couple = 900.0
    load = PointLoad("Couple", 0.5 * SPAN, (0.0, 0.0, 0.0), (0.0, couple, 0.0))
    answer = answered(on_supports(rigid(0.0, SPAN), [load], [weightless(SPAN)]))
    middle = np.interp(0.5 * SPAN, answer.curves.stations, answer.curves.slope[:, 0])
    assert answer.slopes[:, 0] == pytest.approx([-couple * SPAN / (24.0 * EI)] * 2, rel=1e-12)
    assert middle == pytest.approx(couple * SPAN / (12.0 * EI), rel=1e-12)
    assert answer.bearing_forces[:, 0] == pytest.approx([-couple / SPAN, couple / SPAN], rel=1e-12)


def test_an_overhang_bends_by_its_own_steps():
    """Castigliano on a stepped cantilever behind two bearings: sum of the pieces."""
    thin, over = weightless(0.4, 0.06), 0.4
    shaft = on_supports(rigid(0.0, SPAN), [upward(SPAN + over, -FORCE)], [weightless(SPAN), thin])
    of_span = FORCE * over**2 * SPAN / (3.0 * EI)
    of_overhang = FORCE * over**3 / (3.0 * thin.bending_stiffness)
    assert deflection_at(shaft, SPAN + over)[1] == pytest.approx(-of_span - of_overhang, rel=1e-11)


STATIONS = st.floats(0.0, 2.0)
SHAFT = [weightless(0.7, 0.12), weightless(0.5, 0.09), weightless(0.8, 0.15)]


@settings(max_examples=30, deadline=None)
@given(first=STATIONS, second=STATIONS)
def test_deflections_are_reciprocal(first, second):
    """Maxwell: the deflection here of a force there is that there of the same force here."""
    supports = [Support("A", 0.2), Support("B", 1.0, stiffness=80e6), Support("C", 1.9, stiffness=300e6)]
    at_first, at_second = upward(first, FORCE), upward(second, FORCE)
    marks = [upward(first, 0.0), upward(second, 0.0)]  # so that curves have a point there
    here = deflection_at(on_supports(supports, [at_first, *marks], SHAFT), second)[1]
    there = deflection_at(on_supports(supports, [at_second, *marks], SHAFT), first)[1]
    own = deflection_at(on_supports(supports, [at_first, *marks], SHAFT), first)[1]
    assert here == pytest.approx(there, rel=1e-9, abs=1e-9 * own + 1e-12 * FORCE / 80e6)  # on the rigid support


@settings(max_examples=30, deadline=None)
@given(
    loads=st.lists(st.tuples(STATIONS, *[st.floats(-1e5, 1e5)] * 5), max_size=5),
    places=st.lists(st.integers(0, 40), min_size=2, max_size=6, unique=True),
    stiffness=st.sampled_from([math.inf, 1e12, 200e6, 1e6]),
    offset=st.floats(-1e-3, 1e-3),
)
def test_forces_and_moments_balance(loads, places, stiffness, offset):
    supports = [
        Support(
            str(place), place / 20.0, axial=place == min(places), stiffness=stiffness, offset=(0.0, offset * place)
        )
        for place in places
    ]
    acting = [PointLoad("Load", z, (x, y, a), (p, q, 0.0)) for z, x, y, a, p, q in loads]
    pieces = [replace(one, density=7850.0) for one in SHAFT]
    assert answered(Shaft(tuple(supports), tuple(acting), tuple(pieces))).equilibrium_error() < 1e-9


def test_two_bearings_carry_the_same_by_statics_and_by_the_beam():
    load = PointLoad("Gear", 0.3, (3e3, -8e3, 2e3), (150.0, -80.0, 400.0))
    supports = (Support("A", 0.1, axial=True), Support("B", 1.7))
    beam = on_supports(supports, [load], SHAFT)
    assert answered(beam).bearing_forces == pytest.approx(
        answered(replace(beam, pieces=())).bearing_forces, rel=1e-12
    )
    assert answered(replace(beam, pieces=())).slopes is None
    soft = replace(beam, supports=(supports[0], replace(supports[1], stiffness=1e7, offset=(1e-3, 0.0))))
    assert answered(soft).bearing_forces == pytest.approx(answered(beam).bearing_forces, rel=1e-12)
