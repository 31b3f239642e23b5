"""The method of overhung couplings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from babbitt.core.notices import Notice
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.result import Outcome, Result
from babbitt.core.solution import Method, Solution
from babbitt.kinds.coupling.statics import OverhungCoupling, bearing_loads

__all__ = ["STATICS", "ShaftProblem", "Statics"]


@dataclass(frozen=True)
class ShaftProblem:
    """A gear shaft whose bearings share its loads."""

    name: str
    kind: str
    shaft: OverhungCoupling
    given: tuple[tuple[str, str], ...] = ()
    warnings: tuple[Notice, ...] = ()
    assumptions: tuple[str, ...] = ()


@dataclass(frozen=True)
class Statics(Method):
    """Equilibrium of forces and moments of a rigid shaft."""

    name: ClassVar[str] = "statics"

    def solve(self, problem: ShaftProblem, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Find the loads of both bearings."""
        loads = bearing_loads(problem.shaft)
        values = {
            "reaction_1": loads.reaction_1,
            "reaction_2": loads.reaction_2,
            "reaction_without_coupling": loads.reaction_without_coupling,
            "reaction_angle_1": loads.angle_1,
            "reaction_angle_2": loads.angle_2,
            "coupling_arm": problem.shaft.coupling_arm,
        }
        result = Result(problem.name, problem.kind, self.name, Outcome.CONVERGED, values)
        return (Solution(problem, result),)


STATICS = Statics()
