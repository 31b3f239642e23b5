"""What is taken off the face of a pad: nothing, a taper before a land, a step."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Self

import numpy as np

from babbitt.core.notices import InputError

__all__ = ["PlaneFace", "SteppedFace", "TaperedFace", "face_rows"]

ROWS_PER_INTERVAL = 8
"""Rows of a face for each interval of the film; a step is a ramp over one row, between two Gauss points."""
CROWN_COLUMNS = 17


@dataclass(frozen=True)
class PlaneFace:
    """A plane."""

    def offset(self, along: float, before_edge: bool) -> float:
        """Departure from the plane at a share of the extent, m."""
        return 0.0

    def mirrored(self) -> Self:
        """The face seen by a runner that turns the other way."""
        return self


@dataclass(frozen=True)
class TaperedFace:
    """A plane that rises from ``depth`` (m) at the leading edge to the land at ``fraction`` of the extent."""

    depth: float
    fraction: float
    at_trailing_edge: bool = False

    def __post_init__(self) -> None:
        _require("taper", self.depth, self.fraction)

    def offset(self, along: float, before_edge: bool) -> float:
        """Departure from the land at a share of the extent, m."""
        distance = 1.0 - along if self.at_trailing_edge else along
        return self.depth * max(0.0, 1.0 - distance / self._length)

    @property
    def _length(self) -> float:
        return 1.0 - self.fraction if self.at_trailing_edge else self.fraction

    def mirrored(self) -> TaperedFace:
        """The face seen by a runner that turns the other way."""
        return TaperedFace(self.depth, 1.0 - self.fraction, not self.at_trailing_edge)


@dataclass(frozen=True)
class SteppedFace:
    """A plane ``depth`` (m) below the land from the leading edge to ``fraction`` of the extent."""

    depth: float
    fraction: float
    at_trailing_edge: bool = False

    def __post_init__(self) -> None:
        _require("step", self.depth, self.fraction)

    def offset(self, along: float, before_edge: bool) -> float:
        """Departure from the land at a share of the extent, m; ``before_edge`` decides on the edge itself."""
        low = before_edge if abs(along - self.fraction) < 1e-9 else along < self.fraction
        return self.depth if low != self.at_trailing_edge else 0.0

    def mirrored(self) -> SteppedFace:
        """The face seen by a runner that turns the other way."""
        return SteppedFace(self.depth, 1.0 - self.fraction, not self.at_trailing_edge)


def _require(what: str, depth: float, fraction: float) -> None:
    if not depth > 0.0:
        raise InputError("E201", f"depth of the {what} is {depth:g} m; it must be positive.")
    if not 0.0 < fraction < 1.0:
        raise InputError("E201", f"length of the {what} is {fraction:g} of the pad; allowed: between 0 and 1.")


@lru_cache(maxsize=32)
def face_rows(
    face: PlaneFace | TaperedFace | SteppedFace, crown: float, intervals: int
) -> tuple[tuple[float, ...], ...]:
    """Departure from a plane in rows from the leading to the trailing edge; empty for a plane.

    Parameters
    ----------
    face : PlaneFace, TaperedFace or SteppedFace
    crown : float
        Of the middle over the middle of the edges, m.
    intervals : int
        Of the film; edges of the face fall on its lines.
    """
    if isinstance(face, PlaneFace) and crown == 0.0:
        return ()
    count = intervals * ROWS_PER_INTERVAL
    edge = round(getattr(face, "fraction", 0.0) * intervals) * ROWS_PER_INTERVAL
    across = np.linspace(-1.0, 1.0, CROWN_COLUMNS if crown else 2)
    rows = []
    for row in range(count + 1):
        along = row / count
        of_face = face.offset(getattr(face, "fraction", 0.0) if row == edge else along, row <= edge)
        bulge = crown * ((2.0 * along - 1.0) ** 2 + across**2)
        rows.append(tuple(float(value) for value in of_face + bulge))
    return tuple(rows)
