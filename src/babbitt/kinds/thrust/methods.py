"""The method of thrust bearings."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.solution import Method, Solution

if TYPE_CHECKING:
    from babbitt.kinds.thrust.design import ThrustDesign

__all__ = ["THRUST_FILM", "ThrustFilm"]


@dataclass(frozen=True)
class ThrustFilm(Method):
    """Films of all pads in two dimensions, and how the pads share the load."""

    name: ClassVar[str] = "film"

    def solve(self, problem: ThrustDesign, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve films and load sharing; the solution keeps them."""
        from babbitt.kinds.thrust.check import thrust_solution

        return (thrust_solution(problem),)

    def refuse(self, problem: ThrustDesign) -> None:
        """Refuse pads that do not balance."""
        from babbitt.kinds.thrust.design import operating_state
        from babbitt.kinds.thrust.failures import NoPadFilmError

        with suppress(NoPadFilmError):  # reported as no solution
            operating_state(problem)


THRUST_FILM = ThrustFilm()
