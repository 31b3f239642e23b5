"""Shapes of bearings with recesses, in SI. Their films and their closed forms are made from these."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

from babbitt.core.notices import InputError

__all__ = [
    "AnnularPad",
    "CircularPad",
    "PadShape",
    "RecessedJournal",
    "RectangularPad",
    "ThrustRing",
    "pitches_around",
    "positive",
]


def positive(**given: float) -> None:
    """Refuse quantities that are not positive numbers, by name."""
    for name, value in given.items():
        if not (math.isfinite(value) and value > 0.0):
            raise InputError("E101", f"{name} is {value}; it must be a positive number (SI units).")


@dataclass(frozen=True)
class CircularPad:
    """A round pad with a round recess in the middle; radii in m."""

    outer_radius: float
    recess_radius: float

    def __post_init__(self) -> None:
        positive(outer_radius=self.outer_radius, recess_radius=self.recess_radius)
        if not self.recess_radius < self.outer_radius:
            raise InputError("E101", f"recess_radius is {1e3 * self.recess_radius:.6g} mm; it must be below "
                             f"outer_radius, {1e3 * self.outer_radius:.6g} mm.")  # fmt: skip

    @property
    def area(self) -> float:
        """Of the whole pad, m2."""
        return math.pi * self.outer_radius**2

    @property
    def recess_area(self) -> float:
        """Of the recess, m2."""
        return math.pi * self.recess_radius**2


@dataclass(frozen=True)
class AnnularPad:
    """A ring with an annular recess between two lands; radii r1 < r2 < r3 < r4 in m."""

    inner_radius: float
    recess_inner_radius: float
    recess_outer_radius: float
    outer_radius: float

    def __post_init__(self) -> None:
        names = ("inner_radius", "recess_inner_radius", "recess_outer_radius", "outer_radius")
        values = [getattr(self, name) for name in names]
        positive(**dict(zip(names, values, strict=True)))
        if not values[0] < values[1] < values[2] < values[3]:
            said = ", ".join(f"{1e3 * value:.6g}" for value in values)
            raise InputError("E101", f"radii are {said} mm; they must grow in the order {', '.join(names)}.")

    @property
    def radii(self) -> tuple[float, float, float, float]:
        """From inside to outside, m."""
        return self.inner_radius, self.recess_inner_radius, self.recess_outer_radius, self.outer_radius

    @property
    def area(self) -> float:
        """Of the whole ring, m2."""
        return math.pi * (self.outer_radius**2 - self.inner_radius**2)

    @property
    def recess_area(self) -> float:
        """Of the recess, m2."""
        return math.pi * (self.recess_outer_radius**2 - self.recess_inner_radius**2)


@dataclass(frozen=True)
class RectangularPad:
    """A rectangle with a rectangular recess in the middle; sides in m."""

    length: float
    width: float
    recess_length: float
    recess_width: float

    def __post_init__(self) -> None:
        positive(length=self.length, width=self.width, recess_length=self.recess_length,
                 recess_width=self.recess_width)  # fmt: skip
        for side in ("length", "width"):
            recess, pad = getattr(self, f"recess_{side}"), getattr(self, side)
            if not recess < pad:
                raise InputError("E101", f"recess_{side} is {1e3 * recess:.6g} mm; it must be less than {side}, "
                                 f"{1e3 * pad:.6g} mm.")  # fmt: skip

    @property
    def lands(self) -> tuple[float, float]:
        """Land widths along and across, m."""
        return 0.5 * (self.length - self.recess_length), 0.5 * (self.width - self.recess_width)

    @property
    def area(self) -> float:
        """Of the whole pad, m2."""
        return self.length * self.width

    @property
    def recess_area(self) -> float:
        """Of the recess, m2."""
        return self.recess_length * self.recess_width


PadShape = CircularPad | AnnularPad | RectangularPad
"""Pads with one recess."""


@dataclass(frozen=True)
class ThrustRing:
    """A ring with several recesses side by side, all alike.

    Attributes
    ----------
    radii : AnnularPad
    recess_angles : tuple of float
        Middles of the recesses, rad.
    recess_extent : float
        rad.
    groove_extent : float
        Of drain grooves halfway between the recesses, rad; zero: none.
    """

    radii: AnnularPad
    recess_angles: tuple[float, ...]
    recess_extent: float
    groove_extent: float = 0.0

    def __post_init__(self) -> None:
        check_pitch(self.recess_angles, self.recess_extent, self.groove_extent)

    @property
    def recess_area(self) -> float:
        """Of one recess, m2."""
        r = self.radii
        return 0.5 * self.recess_extent * (r.recess_outer_radius**2 - r.recess_inner_radius**2)


@dataclass(frozen=True)
class RecessedJournal:
    """A round bore with equal rectangular recesses on its mid-plane.

    Attributes
    ----------
    diameter, width, clearance : float
        m; ``clearance`` is radial.
    recess_angles : tuple of float
        Middles of the recesses, rad, counter-clockwise from +x.
    recess_extent : float
        rad.
    recess_length : float
        Axial, m.
    groove_extent : float
        Of axial drain grooves halfway between the recesses, rad; zero: none.
    """

    diameter: float
    width: float
    clearance: float
    recess_angles: tuple[float, ...]
    recess_extent: float
    recess_length: float
    groove_extent: float = 0.0

    def __post_init__(self) -> None:
        positive(diameter=self.diameter, width=self.width, clearance=self.clearance,
                 recess_length=self.recess_length)  # fmt: skip
        if not self.recess_length < self.width:
            raise InputError("E101", f"recess_length is {1e3 * self.recess_length:.6g} mm; it must be less than "
                             f"the width of the bearing, {1e3 * self.width:.6g} mm.")  # fmt: skip
        if not 2.0 * self.clearance < self.diameter:
            raise InputError("E101", f"clearance is {1e3 * self.clearance:.6g} mm; it must be small against the "
                             f"diameter, {1e3 * self.diameter:.6g} mm.")  # fmt: skip
        check_pitch(self.recess_angles, self.recess_extent, self.groove_extent)

    @property
    def count(self) -> int:
        """Number of recesses."""
        return len(self.recess_angles)

    @property
    def radius(self) -> float:
        """Of the bore, m."""
        return 0.5 * self.diameter

    @property
    def axial_land(self) -> float:
        """Width of the land beside a recess, m."""
        return 0.5 * (self.width - self.recess_length)

    @property
    def recess_area(self) -> float:
        """Of one recess, m2."""
        return self.recess_length * self.radius * self.recess_extent

    @property
    def is_regular(self) -> bool:
        """Whether the recesses stand at equal distances."""
        pitch = 2.0 * math.pi / self.count
        return all(abs(one - pitch) < 1e-6 for one in pitches_around(self.recess_angles))


def check_pitch(angles: tuple[float, ...], extent: float, groove: float) -> None:
    """Refuse recesses that overlap each other or a drain groove."""
    turn = 2.0 * math.pi
    if not angles:
        raise InputError("E101", "recess_angles is empty; at least one recess is needed.")
    if not (math.isfinite(extent) and extent > 0.0):
        raise InputError("E101", f"recess_extent is {extent} rad; it must be positive.")
    if not 0.0 <= groove < turn:
        raise InputError("E101", f"groove_extent is {groove} rad; it must be zero or positive.")
    pitches = pitches_around(angles)
    if not extent < min(pitches) - groove - 1e-9:
        raise InputError("E101", f"recess_extent is {math.degrees(extent):.6g} deg; it must leave a land in the "
                         f"least pitch, {math.degrees(min(pitches)):.6g} deg, less drain grooves of "
                         f"{math.degrees(groove):.6g} deg.")  # fmt: skip


def pitches_around(angles: tuple[float, ...]) -> list[float]:
    """Distances from every recess to the next, rad, counter-clockwise from the first behind +x; in all a turn.

    The way over +x is closed by adding the turn: a remainder of it would leave round-off of one recess alone.
    """
    turn = 2.0 * math.pi
    ordered = sorted(angle % turn for angle in angles)
    return [b - a for a, b in pairwise([*ordered, ordered[0] + turn])]
