"""Results of the front door."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from front_door_cases import machine_of

from babbitt.api.results import BearingResult
from babbitt.solving import MachineResult


@pytest.fixture
def result() -> Callable[[str], BearingResult]:
    """The result of one of `CASES`."""
    return lambda name: BearingResult(machine_of(name).solutions[0])


@pytest.fixture
def machine() -> Callable[[str], MachineResult]:
    """The machine of one of `CASES`."""
    return machine_of
