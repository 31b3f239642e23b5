"""Problem, method, solution: what is computed, how, and what came out of it.

A problem is one bearing at one operating point and clearance, in SI, frozen, and constructible by hand. A method
solves it. A solution keeps the problem, the result that an engineer reads, and the fields behind it, so that
reports, figures and exports read what was solved instead of solving it again.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Protocol, runtime_checkable

from babbitt.core.notices import Notice
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.result import Result

__all__ = ["Calculation", "CoefficientsOverSpeed", "Method", "Problem", "Solution"]


class Problem(Protocol):
    """One bearing at one operating point and clearance."""

    @property
    def name(self) -> str:
        """Which bearing, operating point and clearance."""

    @property
    def kind(self) -> str:
        """Name of its `babbitt.core.kind.Kind`."""

    @property
    def given(self) -> Sequence[tuple[str, str]]:
        """What the case gave in other terms than those of the calculation: what, and in which words."""

    @property
    def warnings(self) -> Sequence[Notice]:
        """What of the case may be meant otherwise than it was read."""


@dataclass(frozen=True)
class Solution:
    """What a method found for a problem.

    Attributes
    ----------
    problem : Problem
    result : Result
        Values, checks and warnings.
    state : object
        The fields behind the values, in the form of the method; None where the values are all there is.
    """

    problem: Any
    result: Result
    state: Any = None

    def without_state(self) -> Solution:
        """The same without its fields, which take memory where many are kept."""
        return replace(self, state=None)


class Method(ABC):
    """How a problem is solved; the fields of a method are its options."""

    if TYPE_CHECKING:  # a field of the class or of the method

        @property
        def name(self) -> str:
            """The name by which a case file asks for the method."""

    @abstractmethod
    def solve(self, problem: Any, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve a problem: one solution, or one for each of several steady states."""

    def solve_one(self, problem: Any) -> Solution:
        """Solve a problem that has one solution."""
        (found,) = self.solve(problem)
        return found

    def refuse(self, problem: Any) -> None:  # noqa: B027 - most methods refuse nothing
        """Raise what `solve` would raise of an unusable problem, with at most one film solved; here nothing.

        Raises
        ------
        InputError
        """


@runtime_checkable
class CoefficientsOverSpeed(Protocol):
    """A method that gives stiffness and damping over the speed of the journal."""

    def coefficients_over_speed(self, problem: Any, speeds: Iterable[float]) -> Any:
        """Solve a problem at several speeds in rad/s, its heat balance anew at each."""

    def is_clockwise(self, problem: Any) -> bool:
        """Whether the journal turns against the sense that rotor programs take for granted."""


@dataclass(frozen=True)
class Calculation:
    """A problem, and the method that its case asks for."""

    problem: Problem
    method: Method

    def solve(self, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve the problem by its method."""
        return self.method.solve(self.problem, progress)
