"""The methods of hydrostatic bearings and of jacking pockets."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.solution import Method, Solution

if TYPE_CHECKING:
    from babbitt.kinds.hydrostatic.jacking_model import JackingCase
    from babbitt.kinds.hydrostatic.model import HydrostaticCase

__all__ = ["JACKING_METHODS", "METHODS", "Jacking", "Recesses"]


@dataclass(frozen=True)
class Recesses(Method):
    """Films between recesses fed through restrictors: ``film`` in two dimensions, ``quick`` by closed forms."""

    name: str

    def solve(self, problem: HydrostaticCase, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve network, films and heat balance."""
        from babbitt.kinds.hydrostatic.check import hydrostatic_solution

        return (hydrostatic_solution(replace(problem, method=self.name)),)

    def refuse(self, problem: HydrostaticCase) -> None:
        """Refuse a position that leaves no gap, and recesses that are too short for closed forms."""
        from babbitt.kinds.hydrostatic.check import refuse_contact, refuse_short_recess

        asked = replace(problem, method=self.name)
        refuse_contact(asked)
        refuse_short_recess(asked)


@dataclass(frozen=True)
class Jacking(Method):
    """Pockets that lift a shaft at rest: ``film`` in two dimensions, ``quick`` by lumped lands."""

    name: str

    def solve(self, problem: JackingCase, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Find breakaway and the lifted shaft."""
        from babbitt.kinds.hydrostatic.jacking import jacking_check

        asked = replace(problem, method=self.name)
        return (Solution(asked, jacking_check(asked)),)


METHODS: dict[str, Method] = {name: Recesses(name) for name in ("film", "quick")}
"""By the name that a case file gives."""

JACKING_METHODS: dict[str, Method] = {name: Jacking(name) for name in ("film", "quick")}
"""By the name that a case file gives."""
