"""The method of shaft lines."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.solution import Method, Solution

if TYPE_CHECKING:
    from babbitt.kinds.shaft_line.design import LineDesign

__all__ = ["FREQUENCY_DOMAIN", "FrequencyDomain"]


@dataclass(frozen=True)
class FrequencyDomain(Method):
    """Static films, axial vibration about them in the frequency domain."""

    name: ClassVar[str] = "frequency domain"

    def solve(self, problem: LineDesign, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve films and line; the solution keeps the answer of the line."""
        from babbitt.kinds.shaft_line.check import line_solution

        return (line_solution(problem),)

    def refuse(self, problem: LineDesign) -> None:
        """Refuse pads that do not balance and a motion without bound."""
        from babbitt.kinds.shaft_line.model import state_of
        from babbitt.kinds.thrust.design import operating_state
        from babbitt.kinds.thrust.failures import NoPadFilmError

        with suppress(NoPadFilmError):  # reported as no solution
            static = operating_state(problem.thrust)
            state_of(problem.duty, static.films, static.share)


FREQUENCY_DOMAIN = FrequencyDomain()
