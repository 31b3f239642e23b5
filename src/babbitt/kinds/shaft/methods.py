"""The methods of shafts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.solution import Method, Solution
from babbitt.kinds.shaft.check import shaft_solution
from babbitt.kinds.shaft.model import Shaft
from babbitt.kinds.shaft.overhung_coupling import CouplingProblem, coupling_solution
from babbitt.kinds.shaft.problem import ShaftProblem

__all__ = ["BEAM", "COUPLING_STATICS", "STATICS", "Beam", "CouplingStatics", "Statics", "method_of"]


@dataclass(frozen=True)
class Statics(Method):
    """Equilibrium of forces and moments of a rigid shaft on two radial bearings."""

    name: ClassVar[str] = "statics"

    def solve(self, problem: ShaftProblem, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Find the loads of the bearings."""
        return (shaft_solution(problem, self.name),)


@dataclass(frozen=True)
class Beam(Method):
    """A stepped beam on rigid or elastic bearings."""

    name: ClassVar[str] = "beam"

    def solve(self, problem: ShaftProblem, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Find the loads of the bearings and the bending of the shaft."""
        return (shaft_solution(problem, self.name),)


@dataclass(frozen=True)
class CouplingStatics(Method):
    """Equilibrium of a gear shaft with an overhung coupling."""

    name: ClassVar[str] = "statics"

    def solve(self, problem: CouplingProblem, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Find the loads of both bearings."""
        return (coupling_solution(problem, self.name),)


STATICS, BEAM, COUPLING_STATICS = Statics(), Beam(), CouplingStatics()


def method_of(shaft: Shaft) -> Method:
    """The beam where the pieces of the shaft are given, else statics."""
    return BEAM if shaft.pieces else STATICS
