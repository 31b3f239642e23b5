"""Problem, method, solution: what is computed, how, and what came out of it.

A problem is one bearing at one operating point and clearance, in SI, frozen, and constructible by hand. A method
solves it. A solution keeps the problem, the result that an engineer reads, and the fields behind it, so that
reports, figures and exports read what was solved instead of solving it again.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Protocol, runtime_checkable

from babbitt.core.kind import kind_mistake
from babbitt.core.notices import explanations
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result

__all__ = ["Calculation", "CoefficientsOverSpeed", "Method", "Problem", "Solution"]


class Problem(Protocol):
    """One bearing at one operating point and clearance.

    It may also have ``given``, what the case gave in other terms than those of the calculation: pairs of what, and
    in which words; ``warnings``, notices of what of the case may be meant otherwise than it was read; and
    ``assumptions``. The two of them become part of every `Solution`.
    """

    @property
    def name(self) -> str:
        """Which bearing, operating point and clearance."""

    @property
    def kind(self) -> str:
        """Name of its `babbitt.core.kind.Kind`."""


@dataclass(frozen=True)
class Solution:
    """What a method found for a problem.

    Attributes
    ----------
    problem : Problem
    result : Result
        Values, checks and warnings; warnings and assumptions of the problem that it lacks come first.
    state : object
        The fields behind the values, in the form of the method; None where the values are all there is.
    """

    problem: Any
    result: Result
    state: Any = None

    def __post_init__(self) -> None:
        for says in _mistakes_of_checks(self.result):
            raise kind_mistake(self.result.kind, says)
        found = self.result
        warnings = _lacking(self.problem, "warnings", found.warnings)
        assumptions = _lacking(self.problem, "assumptions", found.assumptions)
        if warnings or assumptions:
            joined = replace(
                found, warnings=(*warnings, *found.warnings), assumptions=(*assumptions, *found.assumptions)
            )
            object.__setattr__(self, "result", joined)

    def without_state(self) -> Solution:
        """The same without its fields, which take memory where many are kept."""
        return replace(self, state=None)


def _lacking(problem: Any, name: str, there: Sequence[Any]) -> tuple[Any, ...]:
    """Warnings or assumptions of a problem that its result does not have."""
    return tuple(one for one in getattr(problem, name, ()) if one not in there)


def _mistakes_of_checks(result: Result) -> Iterator[str]:
    """What of the checks no report could show."""
    for check in result.checks:
        if check.code not in explanations():
            yield f"no words.en.toml has the code {check.code} of its check"
        if check.quantity not in QUANTITIES:
            yield f"its check {check.code} is of {check.quantity!r}, which is no quantity"


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

    def only(self, problem: Any, quantities: Collection[str]) -> Any:
        """The problem without searches that tell none of some quantities and no limit; here the same."""
        return problem

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

    def only(self, quantities: Collection[str]) -> Calculation:
        """The calculation as far as it tells some quantities, all limits, and what questions the result."""
        return replace(self, problem=self.method.only(self.problem, quantities))

    def solve(self, progress: ProgressCallback = no_progress) -> tuple[Solution, ...]:
        """Solve the problem by its method."""
        return self.method.solve(self.problem, progress)
