"""The methods of footsteps."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from babbitt.core.progress import Watch, unwatched
from babbitt.core.solution import Method, Solution

if TYPE_CHECKING:
    from babbitt.kinds.footstep.model_case import HeelCase

__all__ = ["METHODS", "SteadyStates"]


@dataclass(frozen=True)
class SteadyStates:
    """Every steady state of a heel: ``superposition`` or ``narrow_groove``."""

    name: str

    def solve(self, problem: HeelCase, progress: Watch = unwatched) -> tuple[Solution, ...]:
        """Find every steady state, the hottest first; one solution tells of none."""
        from babbitt.kinds.footstep.check import heel_results

        return tuple(Solution(problem, result) for result in heel_results(problem))

    def refuse(self, problem: HeelCase) -> None:
        """Refuse nothing that a case file may say."""


METHODS: dict[str, Method] = {name: SteadyStates(name) for name in ("superposition", "narrow_groove")}
"""By the name that a case file gives."""
