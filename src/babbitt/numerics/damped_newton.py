"""An equilibrium by Newton's method whose steps keep some room open (a gap), always with a status.

What is sought is an object: it looks at a place, tells whether that ends the search, and chooses the step from
there by a rule of its own (plain Newton, pseudo-time, creep). Steps that take too much of the room are halved.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from babbitt.numerics.scalar_or_array import Array

__all__ = ["NewtonEnd", "NewtonProblem", "damped_newton", "halved_for_room"]

StatusT = TypeVar("StatusT")
StatusT_co = TypeVar("StatusT_co", covariant=True)


class NewtonProblem(Protocol[StatusT_co]):
    """What an equilibrium search needs to know."""

    @property
    def no_room(self) -> StatusT_co:
        """Status of a search that no room, or no step, is left to."""

    @property
    def too_many_steps(self) -> StatusT_co:
        """Status of a search that goes on for ever."""

    def room(self, at: Array) -> float:
        """What is open at a place, not positive where it is none."""

    def kept_room(self, at: Array, room: float) -> float:
        """What a step from a place must leave open."""

    def look(self, at: Array, step: int) -> StatusT_co | None:
        """Evaluate a place, in the step of a number from 1; the status of a search that ends there."""

    def move(self, at: Array, room: float) -> Array | None:
        """Step from the place looked at last; None: there is none."""


@dataclass(frozen=True, eq=False)
class NewtonEnd(Generic[StatusT]):
    """Where a search ended: place, status, number of places looked at, and the room there."""

    at: Array
    status: StatusT
    steps: int
    room: float


def damped_newton(
    problem: NewtonProblem[StatusT],
    start: Array,
    most_steps: int,
    least_room: float = 0.0,
    most_halvings: int = 60,
) -> NewtonEnd[StatusT]:
    """Search an equilibrium.

    Parameters
    ----------
    problem : NewtonProblem
    start : ndarray
    most_steps : int
        Places to look at.
    least_room : float
        Room at which the search gives up.
    most_halvings : int
        Of a step; one that takes too much room even then is none.
    """
    at, room = start, problem.room(start)
    if not room > 0.0:
        return NewtonEnd(at, problem.no_room, 0, room)
    for step in range(1, most_steps + 1):
        status = problem.look(at, step)
        if status is not None:
            return NewtonEnd(at, status, step, room)
        move = problem.move(at, room)
        taken = None
        if move is not None:
            taken = halved_for_room(problem.room, at, move, problem.kept_room(at, room), most_halvings)
        if taken is None or not taken[1] > least_room:
            return NewtonEnd(at, problem.no_room, step, room)
        at, room = at + taken[0], taken[1]
    return NewtonEnd(at, problem.too_many_steps, most_steps, room)


def halved_for_room(
    room: Callable[[Array], float], at: Array, move: Array, kept: float, most_halvings: int = 60
) -> tuple[Array, float] | None:
    """A step halved until it leaves room, and that room; None where it never does."""
    for _ in range(most_halvings + 1):
        left = room(at + move)
        if left > kept:
            return move, left
        move = 0.5 * move
    return None
