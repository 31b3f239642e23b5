"""The pressure behind tubes, with films whose flow is a formula."""

import math
from types import SimpleNamespace

import pytest

from babbitt.core.result import Outcome
from babbitt.design.conditions import OilSupply
from babbitt.design.ducts import Duct
from babbitt.design.feeding import arrival
from babbitt.design.heat_balance import NoFilmError

OIL = SimpleNamespace(density=lambda _: 850.0, kinematic_viscosity=lambda _: 100e-6)
SUPPLY = OilSupply(323.15, 0.2e6, tubes=(Duct(0.004, 2.0),))
RESISTANCE = 128.0 * 100e-6 * 850.0 * 2.0 / (math.pi * 0.004**4)
"""Of the tube in Pa s/m³, by Hagen and Poiseuille."""

CONDUCTANCE = 1.0 / (3.0 * RESISTANCE)
"""Of the film in m³/(s Pa): three quarters of the pressure arrive."""


def film_from(pressure):
    """Flow of a film that lives from a pressure on, and the pressures at which it was asked for."""
    asked = []

    def flow_at(there):
        asked.append(there)
        return CONDUCTANCE * there if there >= pressure else None

    return flow_at, asked


@pytest.mark.parametrize("lives_from", [0.0, 0.05e6, 0.1e6, 0.1499e6])
def test_film_and_tube_share_the_pressure_wherever_the_film_begins(lives_from):
    flow_at, asked = film_from(lives_from)
    found = arrival(SUPPLY, OIL, flow_at)
    assert found.element_pressure == pytest.approx(0.15e6, rel=1e-11)
    assert found.element_pressure + found.tube_loss == pytest.approx(0.2e6, rel=1e-11)
    assert len(asked) < 20


@pytest.mark.parametrize("lives_from", [0.151e6, 0.18e6, 0.1999e6])
def test_no_film_where_every_one_takes_more_than_the_tube_passes(lives_from):
    """The pressure at which films begin balances nothing: it is no answer."""
    flow_at, asked = film_from(lives_from)
    with pytest.raises(NoFilmError) as told:
        arrival(SUPPLY, OIL, flow_at)
    assert told.value.outcome is Outcome.OVERLOADED
    assert told.value.least_flow == pytest.approx(CONDUCTANCE * lives_from, rel=0.01)
    assert len(asked) < 20


def test_a_flow_that_jumps_past_what_the_tube_passes_is_no_balance():
    with pytest.raises(NoFilmError) as told:
        arrival(SUPPLY, OIL, lambda pressure: CONDUCTANCE * pressure * (1.0 if pressure < 0.12e6 else 5.0))
    assert told.value.outcome is Outcome.NOT_CONVERGED
