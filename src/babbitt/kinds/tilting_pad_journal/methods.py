"""The method of tilting-pad journal bearings."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.solution import Method, Solution

if TYPE_CHECKING:
    from babbitt.kinds.tilting_pad_journal.coefficients_over_speed import PadSpeedRun
    from babbitt.kinds.tilting_pad_journal.model import PadCase

__all__ = ["PAD_FILM", "PadFilm"]


@dataclass(frozen=True)
class PadFilm(Method):
    """Films of all pads in two dimensions, their tilts, and the place of the journal."""

    name: ClassVar[str] = "film"

    def solve(self, problem: PadCase, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve films and heat balance; the solution keeps them."""
        from babbitt.kinds.tilting_pad_journal.check import pad_solution

        return (pad_solution(problem),)

    def coefficients_over_speed(self, problem: PadCase, speeds: Iterable[float]) -> PadSpeedRun:
        """Solve at several speeds, the heat balance anew at each."""
        from babbitt.kinds.tilting_pad_journal.coefficients_over_speed import run_over_speed

        return run_over_speed(problem, speeds)

    def is_clockwise(self, problem: PadCase) -> bool:
        """Whether the journal turns clockwise, seen against z."""
        return problem.sense < 0.0

    def refuse(self, problem: PadCase) -> None:
        """Refuse a supply that starves the pads."""
        from babbitt.kinds.tilting_pad_journal.check import refuse_starvation

        refuse_starvation(problem)


PAD_FILM = PadFilm()
