"""Bound on the work of one thrust bearing or shaft line, counted in films and never in seconds.

A unit is a pass of film and temperature; what it takes is known within a factor of two, and so is what a
calculation takes at most, however loaded the machine is.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from babbitt.core.notices import Notice
from babbitt.core.picklable_error import PicklableError

__all__ = ["COLD_FILM", "MOST_WORK", "WorkBoundError", "bounded_work", "spend"]

MOST_WORK = 95_000
"""Units of one bearing or line: 20 to 55 s of processor, at 0.2 ms a unit as measured with the template with
adiabatic films and its runout, which takes 36 000, and 0.55 ms with sixteen such pads (1 of 94 random lines)."""

COLD_FILM = 7.0
"""Units of a film of one viscosity with its coefficients: eight to twenty passes and what goes around them."""

_left: ContextVar[list[float] | None] = ContextVar("work left", default=None)


class WorkBoundError(PicklableError):
    """The work that is allowed is used up; it tells nothing about the bearing.

    Attributes
    ----------
    failure : Notice
        What to try.
    """

    def __init__(self) -> None:
        self.failure = Notice("S009", "pads")
        super().__init__(self.failure.message)


@contextmanager
def bounded_work(units: float) -> Iterator[None]:
    """Allow what is called inside so many units, and no more."""
    token = _left.set([units])
    try:
        yield
    finally:
        _left.reset(token)


def spend(units: float) -> None:
    """Count work before it is done; outside of `bounded_work` any is allowed.

    Raises
    ------
    WorkBoundError
    """
    left = _left.get()
    if left is None:
        return
    left[0] -= units
    if left[0] < 0.0:
        raise WorkBoundError
