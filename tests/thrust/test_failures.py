"""Failures of pads: what they say, and that a pool of processes gets them back."""

import pickle

import pytest

from babbitt.core.result import Outcome
from babbitt.kinds.thrust.failures import ConcavePadError, OverloadedPadsError, ThermalRunawayError, TiltedPadError
from babbitt.kinds.thrust.work import WorkBoundError

FAILURES = {
    Outcome.OVERLOADED: OverloadedPadsError(100e3, 10e3, stepped=True),
    Outcome.THERMAL_RUNAWAY: ThermalRunawayError(),
    Outcome.NOT_CONVERGED: TiltedPadError(2, 5e-6),
    Outcome.WORK_BOUND: WorkBoundError(),
}


@pytest.mark.parametrize("outcome", FAILURES)
def test_a_failure_is_pickled_with_its_notice(outcome):
    error = FAILURES[outcome]
    copied = pickle.loads(pickle.dumps(error))
    assert (type(copied), copied.failure) == (type(error), error.failure)
    assert str(copied) == error.failure.message
    assert Outcome.of(copied.failure) is outcome


def test_all_concave_pads_carry_as_often_what_one_does():
    one = ConcavePadError(-5e-6, 40e3)
    all_pads = ConcavePadError(-5e-6, 40e3, thrust=1e6, number=8)
    assert "a pad carries at most 40.00 kN: " in str(one)
    assert "the pads carry at most 320.0 kN of 1000 kN: " in str(all_pads)
