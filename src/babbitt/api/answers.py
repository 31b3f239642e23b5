"""What a solved case gives back: the result of one bearing, or those of several."""

from __future__ import annotations

from typing import TYPE_CHECKING

from babbitt.solving import MachineResult

if TYPE_CHECKING:
    from babbitt.api.machine_results import MachineResults
    from babbitt.api.results import BearingResult

__all__ = ["answer", "first_answer"]


def answer(found: MachineResult) -> BearingResult | MachineResults:
    """Give the result of one bearing where there is one, else those of all."""
    from babbitt.api.machine_results import MachineResults

    return first_answer(found) if len(found.solutions) == 1 else MachineResults(found)


def first_answer(found: MachineResult) -> BearingResult:
    """Give the result of the first bearing, of its first steady state where there are several."""
    from babbitt.api.results import BearingResult

    return BearingResult(found.solutions[0], found.case_hash, found.case_text)
