"""One pad of a thrust bearing and the frame of its pivot."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.thrust.face import PlaneFace, SteppedFace, TaperedFace, face_rows
from babbitt.reynolds.oil.turbulence import FilmTurbulence

__all__ = ["DEGREE", "Pivot", "ThrustPad"]

Array = NDArray[np.float64]

USUAL_INTERVALS = 64
"""Intervals along a pad: the load is within 0.1 % of the limit of a fine grid (`tests/thrust`)."""
DEGREE = 8
"""Of the polynomials across it."""


class Pivot(Enum):
    """How a pad may move.

    A point pivot lets it tilt about two axes, a line pivot about the radius through the pivot only.
    """

    POINT = "point"
    LINE = "line"
    FIXED = "fixed"


@dataclass(frozen=True)
class ThrustPad:
    """A pad between two radii.

    Attributes
    ----------
    inner_radius, outer_radius : float
        m.
    extent : float
        Angle of the pad, rad.
    pivot_radius : float
        m. For a fixed pad the radius at which its height counts.
    pivot_fraction : float
        Angle of the pivot from the leading edge over the extent.
    pivot : Pivot
    face : PlaneFace, TaperedFace or SteppedFace
        What is taken off the pad.
    crown : float
        Height of the crown, m: how much farther the middle of every edge lies from the runner than the middle of
        the pad, by parabolas along and across. A sphere where the pad is as long as wide. Negative: concave.
    turbulence : FilmTurbulence or None
        None: laminar.
    """

    inner_radius: float
    outer_radius: float
    extent: float
    pivot_radius: float
    pivot_fraction: float
    pivot: Pivot = Pivot.POINT
    face: PlaneFace | TaperedFace | SteppedFace = PlaneFace()  # noqa: RUF009  (frozen, without fields)
    crown: float = 0.0
    turbulence: FilmTurbulence | None = None

    def __post_init__(self) -> None:
        if not 0.0 < self.inner_radius < self.outer_radius:
            raise InputError(
                "E201",
                f"radii of the pad are {self.inner_radius:g} and {self.outer_radius:g} m; the "
                "inner must be positive and less than the outer.",
            )
        if not 0.0 < self.extent < 2.0 * math.pi:
            raise InputError("E201", f"extent of the pad is {self.extent:g} rad; allowed: between 0 and one turn.")
        if not self.inner_radius < self.pivot_radius < self.outer_radius:
            raise InputError(
                "E201",
                f"pivot_radius is {self.pivot_radius:g} m; it must lie on the pad, between "
                f"{self.inner_radius:g} and {self.outer_radius:g} m.",
            )
        if not 0.0 < self.pivot_fraction < 1.0:
            raise InputError(
                "E201",
                f"pivot_fraction is {self.pivot_fraction:g}; it must lie between 0, the leading "
                "edge, and 1, the trailing edge.",
            )

    @property
    def pivot_angle(self) -> float:
        """Angle of the pivot from the leading edge, rad."""
        return self.pivot_fraction * self.extent

    @property
    def area(self) -> float:
        """Area of the pad, m2."""
        return 0.5 * self.extent * (self.outer_radius**2 - self.inner_radius**2)

    @property
    def is_plane(self) -> bool:
        """Whether films of different thickness are similar to each other."""
        return isinstance(self.face, PlaneFace) and self.crown == 0.0 and self.turbulence is None

    @property
    def free_tilts(self) -> tuple[int, ...]:
        """Which of (height, slope along the radius, slope along the motion) the moments on the pivot decide."""
        return {Pivot.POINT: (1, 2), Pivot.LINE: (2,), Pivot.FIXED: ()}[self.pivot]

    @property
    def intervals(self) -> int:
        """Intervals along the pad, such that an edge of the face falls on a line."""
        edge = getattr(self.face, "fraction", 0.0)
        return min(
            range(USUAL_INTERVALS - 8, USUAL_INTERVALS + 17),
            key=lambda n: (abs(edge * n - round(edge * n)), abs(n - USUAL_INTERVALS)),
        )

    def form(self) -> tuple[tuple[float, ...], ...]:
        """Departure from a plane for the film (`SectorPad.form`); empty for a plane."""
        return face_rows(self.face, self.crown, self.intervals)

    def from_pivot(self) -> Array:
        """Matrix that takes (h_p, alpha_x, alpha_y) of the pivot frame to (height, slope_x, slope_y) of the film.

        h = h_p + alpha_x X + alpha_y Y with X = r cos(theta - theta_p) - r_p, Y = r sin(theta - theta_p).
        """
        c, s = math.cos(self.pivot_angle), math.sin(self.pivot_angle)
        return np.array([[1.0, -self.pivot_radius, 0.0], [0.0, c, -s], [0.0, s, c]])

    def corners(self) -> Array:
        """(1, X, Y) of the four corners: leading inner, leading outer, trailing inner, trailing outer; (4, 3)."""
        rows = []
        for angle in (-self.pivot_angle, self.extent - self.pivot_angle):
            for radius in (self.inner_radius, self.outer_radius):
                rows.append((1.0, radius * math.cos(angle) - self.pivot_radius, radius * math.sin(angle)))
        return np.array(rows)

    def mirrored(self) -> ThrustPad:
        """The same pad for the other sense of rotation: leading and trailing edge change places."""
        from dataclasses import replace

        return replace(self, pivot_fraction=1.0 - self.pivot_fraction, face=self.face.mirrored())
