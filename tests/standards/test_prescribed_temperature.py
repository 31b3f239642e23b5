"""The design check at a temperature that is given instead of found."""

from dataclasses import replace

import pytest
from design_cases import CASE_A, CASE_C

from babbitt.results import Outcome
from babbitt.standards.iso7902.model import GivenLoad
from babbitt.standards.iso7902.procedure import check, check_at_temperature


@pytest.mark.parametrize("case", [CASE_A, CASE_C], ids=["A", "C"])
def test_at_the_temperature_of_equilibrium_nothing_changes(case):
    found = check(case)
    given = check_at_temperature(case, found.values["effective_temperature"])
    for name, value in found.values.items():
        if name not in ("iterations", "wall_time", "energy_balance_error"):
            assert given.values[name] == pytest.approx(value, rel=1e-12), name
    assert given.checks == found.checks
    assert given.outcome is Outcome.CONVERGED
    assert given.values["iterations"] == 1.0


def test_the_open_heat_balance_is_told():
    equilibrium = check(CASE_A).values["effective_temperature"]
    colder = check_at_temperature(CASE_A, equilibrium - 5.0)
    warmer = check_at_temperature(CASE_A, equilibrium + 5.0)
    assert colder.values["energy_balance_error"] > 0.1
    assert warmer.values["energy_balance_error"] < -0.1
    assert any("57.1 °C" in text and "not closed" in text for text in colder.assumptions)
    assert colder.values["minimum_film_thickness"] > warmer.values["minimum_film_thickness"]


def test_what_cannot_run_ends_with_a_status():
    overloaded = check_at_temperature(replace(CASE_A, duty=GivenLoad(36e6)), 330.0)
    assert overloaded.outcome is Outcome.OVERLOADED
    assert "56.9 °C" in overloaded.message
    tight = replace(CASE_A.bearing, relative_clearance=1e-4, expansion_bearing=1e-6, expansion_journal=30e-6)
    assert check_at_temperature(replace(CASE_A, bearing=tight), 330.0).outcome is Outcome.NO_CLEARANCE
