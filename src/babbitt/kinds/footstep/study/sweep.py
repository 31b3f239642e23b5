"""Steady states of a footstep over face gap and clearance: every point solved by itself, since branches fold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.kinds.footstep.clearances import at_clearance
from babbitt.kinds.footstep.model import Footstep
from babbitt.kinds.footstep.states import Method, NoSteadyStateError, StateName, SteadyState, steady_states

__all__ = ["FootstepSweep", "sweep_heel"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class FootstepSweep:
    """Steady states on a grid.

    Attributes
    ----------
    face_gaps, clearances : tuple of float
        m.
    states : tuple of tuple of tuple
        For each face gap and each clearance its steady states; empty where none exists.
    """

    face_gaps: tuple[float, ...]
    clearances: tuple[float, ...]
    states: tuple[tuple[tuple[SteadyState, ...], ...], ...]

    def values(self, quantity: str, name: StateName) -> Array:
        """A quantity of one branch, shape (face gaps, clearances); not a number where there is no such state."""
        return np.array([[_value(states, quantity, name) for states in row] for row in self.states])

    @property
    def counts(self) -> NDArray[np.int64]:
        """Number of steady states, shape (face gaps, clearances)."""
        return np.array([[len(states) for states in row] for row in self.states])

    @property
    def names(self) -> tuple[StateName, ...]:
        """Branches that occur."""
        found = {state.name for row in self.states for states in row for state in states}
        return tuple(name for name in StateName if name in found)


def _value(states: tuple[SteadyState, ...], quantity: str, name: StateName) -> float:
    return next((float(getattr(state, quantity)) for state in states if state.name is name), float("nan"))


def sweep_heel(
    footstep: Footstep,
    face_gaps: Sequence[float],
    clearances: Sequence[float],
    method: Method = Method.SUPERPOSITION,
    watch: ProgressCallback = no_progress,
) -> FootstepSweep:
    """Solve a footstep for every face gap and clearance.

    Parameters
    ----------
    footstep : Footstep
        Smooth or grooved; its eccentricity ratio and the share of the tilt in the clearance stay.
    face_gaps, clearances : sequence of float
        m.
    method : Method
    watch : callable

    Returns
    -------
    FootstepSweep
    """
    found: list[list[tuple[SteadyState, ...]]] = [[() for _ in clearances] for _ in face_gaps]
    for place in watch(range(len(face_gaps) * len(clearances))):
        row, column = divmod(place, len(clearances))
        point = at_clearance(replace(footstep, face_gap=face_gaps[row]), clearances[column])
        try:
            found[row][column] = steady_states(point, method)
        except NoSteadyStateError:
            continue
    return FootstepSweep(tuple(face_gaps), tuple(clearances), tuple(map(tuple, found)))
