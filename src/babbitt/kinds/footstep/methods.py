"""The methods of footsteps."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.solution import Method, Solution

if TYPE_CHECKING:
    from babbitt.kinds.footstep.model_case import FootstepProblem

__all__ = ["METHODS", "SteadyStates"]


@dataclass(frozen=True)
class SteadyStates(Method):
    """Every steady state of a heel: ``superposition`` or ``narrow_groove``."""

    name: str

    def solve(self, problem: FootstepProblem, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Find every steady state, the hottest first; one solution tells of none."""
        from babbitt.kinds.footstep.check import heel_results
        from babbitt.kinds.footstep.states import Method as Equations

        asked = replace(problem, method=Equations(self.name))
        return tuple(Solution(asked, result) for result in heel_results(asked))


METHODS: dict[str, Method] = {name: SteadyStates(name) for name in ("superposition", "narrow_groove")}
"""By the name that a case file gives."""
