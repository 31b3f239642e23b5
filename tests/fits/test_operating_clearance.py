"""Clearance of the warm bearing: identity at 20 °C, sign of the expansion, linearity."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from babbitt.properties.fits import REFERENCE_TEMPERATURE, operating_relative_clearance

psis = st.floats(0.0, 0.01)
expansions = st.floats(5e-6, 3e-5)
temperatures = st.floats(250.0, 450.0)


@given(psis, expansions, expansions)
def test_nothing_changes_at_the_reference_temperature(psi, bearing, journal):
    assert operating_relative_clearance(psi, bearing, journal, REFERENCE_TEMPERATURE) == psi


@given(psis, expansions, temperatures)
def test_nothing_changes_when_both_expand_alike(psi, expansion, temperature):
    assert operating_relative_clearance(psi, expansion, expansion, temperature) == psi


@given(psis, expansions, expansions, temperatures)
def test_what_the_bearing_gains_the_journal_takes(psi, one, other, temperature):
    opened = operating_relative_clearance(psi, one, other, temperature) - psi
    closed = operating_relative_clearance(psi, other, one, temperature) - psi
    assert opened == pytest.approx(-closed, abs=1e-15)


def test_bronze_on_steel_opens_when_warm():
    """12e-6 1/K times 42.1135 K is 0.50536 permil."""
    warm = operating_relative_clearance(1.12e-3, 23e-6, 11e-6, REFERENCE_TEMPERATURE + 42.1135)
    assert warm == pytest.approx(1.625362e-3, abs=1e-9)


def test_clearance_can_close():
    assert operating_relative_clearance(0.2e-3, 11e-6, 16e-6, REFERENCE_TEMPERATURE + 60) < 0.0
