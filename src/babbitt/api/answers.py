"""What a solved case gives back: the result of one bearing, or those of several."""

from __future__ import annotations

from typing import TYPE_CHECKING

from babbitt.core.solution import Solution
from babbitt.solving import MachineResult

if TYPE_CHECKING:
    from babbitt.api.result_set import MachineResults
    from babbitt.api.results import BearingResult

__all__ = ["answer", "answer_of"]


def answer(found: MachineResult) -> BearingResult | MachineResults:
    """Give the result of one bearing where there is one, else those of all."""
    from babbitt.api.result_set import MachineResults

    return answer_of(found.solutions[0]) if len(found.solutions) == 1 else MachineResults(found)


def answer_of(solution: Solution) -> BearingResult:
    """The result that a solution gives."""
    from babbitt.api.results import BearingResult

    return BearingResult(solution)
