"""How far the pivot of a pad gives way under its load.

Every law is a displacement u(P) that starts at zero; its stiffness is dP/du. In closed form

    u = a P^b + P (A - B ln P) + P / k,

with the power of a contact of points, the logarithm of one of lines, and whatever lies in series; a table
stands for what was measured.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from babbitt.core.notices import InputError

__all__ = [
    "Curve",
    "LineContact",
    "Pivot",
    "PointContact",
    "RigidPivot",
    "RockerContact",
    "SpringPivot",
    "TablePivot",
    "contact_radius",
    "displacement_of",
    "stiffness_of",
]

ROCKER_FACTOR, ROCKER_EXPONENT, ROCKER_WIDTH_EXPONENT = 1.530451e-10, 0.9, 0.8
"""u = 1.530451e-10 P^0.9 / l^0.8 (SI): steel rocker in a steel housing, as the pad models of ROSS 2.3 have it.
About 40 % softer than the contact of Hertz at 100 kN."""

LIGHTEST = 1e-9
"""N: load at which the stiffness of an unloaded contact is taken, for that of a point vanishes with its load."""


@dataclass(frozen=True)
class Curve:
    """Displacement u = factor P^exponent + P (line - line_slope ln P) + compliance P, or a table of it.

    Attributes
    ----------
    factor, exponent : float
        m/N^exponent, and a number.
    line, line_slope, compliance : float
        m/N, with P in N.
    loads, displacements : tuple of float
        Table from (0, 0) on, N and m; straight between its points and behind the last. Empty: none.
    """

    factor: float = 0.0
    exponent: float = 1.0
    line: float = 0.0
    line_slope: float = 0.0
    compliance: float = 0.0
    loads: tuple[float, ...] = ()
    displacements: tuple[float, ...] = ()

    def displacement(self, load: float) -> float:
        """Displacement u(P), m, under a load in N; zero without load."""
        if load <= 0.0:
            return 0.0
        u = self.factor * float(load**self.exponent) + self.compliance * load
        if self.line or self.line_slope:
            u += load * (self.line - self.line_slope * math.log(load))
        if self.loads:
            first, second = self._piece(load)
            u += self.displacements[first] + (load - self.loads[first]) * self._slope(first, second)
        return u

    def flexibility(self, load: float) -> float:
        """Slope du/dP, m/N, at a load in N (at least `LIGHTEST`)."""
        load = max(load, LIGHTEST)
        slope = self.factor * self.exponent * float(load ** (self.exponent - 1.0)) + self.compliance
        if self.line or self.line_slope:
            slope += self.line - self.line_slope * (math.log(load) + 1.0)
        if self.loads:
            slope += self._slope(*self._piece(load))
        return slope

    def _piece(self, load: float) -> tuple[int, int]:
        """Numbers of the points of the table between which a load lies."""
        behind = min(max(int(np.searchsorted(self.loads, load)), 1), len(self.loads) - 1)
        return behind - 1, behind

    def _slope(self, first: int, second: int) -> float:
        """Slope between two points of the table, m/N."""
        rise = self.displacements[second] - self.displacements[first]
        return rise / (self.loads[second] - self.loads[first])


@dataclass(frozen=True)
class RigidPivot:
    """A pivot that does not give way."""

    def curve(self) -> Curve:
        """Displacement under load."""
        return Curve()


@dataclass(frozen=True)
class SpringPivot:
    """A pivot of constant stiffness, N/m."""

    stiffness: float

    def __post_init__(self) -> None:
        check_positive(self, "stiffness")

    def curve(self) -> Curve:
        """Displacement under load."""
        return Curve(compliance=1.0 / self.stiffness)


@dataclass(frozen=True)
class PointContact:
    """A sphere of ``radius`` in a hollow sphere of ``housing_radius``, m (Hertz).

    u = (3 P / (4 E* sqrt(R*)))^(2/3) and dP/du = (6 E*^2 R* P)^(1/3), 1/R* = 1/r_1 - 1/r_2 and 1/E* the sum of
    (1 - nu^2)/E over both bodies: K. L. Johnson, Contact Mechanics (1985), eq. 4.23.

    Attributes
    ----------
    radius, housing_radius : float
        m; the second above the first, ``inf`` for a plane.
    elastic_modulus, housing_elastic_modulus : float
        Pa.
    poisson_ratio, housing_poisson_ratio : float
    housing_stiffness : float
        In series, N/m; ``inf``: rigid.
    """

    radius: float
    housing_radius: float
    elastic_modulus: float = 210e9
    poisson_ratio: float = 0.3
    housing_elastic_modulus: float = 210e9
    housing_poisson_ratio: float = 0.3
    housing_stiffness: float = math.inf

    def __post_init__(self) -> None:
        check_contact(self)

    @property
    def effective_radius(self) -> float:
        """Radius R* of the contact, m."""
        return effective_radius(self.radius, self.housing_radius)

    @property
    def effective_modulus(self) -> float:
        """Modulus E* of the contact, Pa."""
        return 1.0 / sum(compliances(self))

    def curve(self) -> Curve:
        """Displacement under load."""
        factor = (3.0 / (4.0 * self.effective_modulus * math.sqrt(self.effective_radius))) ** (2.0 / 3.0)
        return Curve(factor=factor, exponent=2.0 / 3.0, compliance=1.0 / self.housing_stiffness)


@dataclass(frozen=True)
class LineContact:
    """A cylinder of ``radius`` along ``length`` in a hollow one of ``housing_radius``, m (Hertz).

    b = sqrt(4 P' R*/(pi E*)), P' the load per length, and
    u = P' sum (1 - nu_i^2)/(pi E_i) [2 ln(2 d_i/b) - nu_i/(1 - nu_i)]: K. L. Johnson, Contact Mechanics (1985),
    eq. 4.45 and 5.57. It depends on the depths d_i below the contact to which a displacement is counted.

    Attributes
    ----------
    radius, housing_radius, length : float
        m.
    depth, housing_depth : float
        d_i, m.
    elastic_modulus, housing_elastic_modulus : float
        Pa.
    poisson_ratio, housing_poisson_ratio : float
    housing_stiffness : float
        In series, N/m; ``inf``: rigid.
    """

    radius: float
    housing_radius: float
    length: float
    depth: float
    housing_depth: float
    elastic_modulus: float = 210e9
    poisson_ratio: float = 0.3
    housing_elastic_modulus: float = 210e9
    housing_poisson_ratio: float = 0.3
    housing_stiffness: float = math.inf

    def __post_init__(self) -> None:
        check_contact(self)
        check_positive(self, "length", "depth", "housing_depth")

    @property
    def effective_radius(self) -> float:
        """Radius R* of the contact, m."""
        return effective_radius(self.radius, self.housing_radius)

    @property
    def effective_modulus(self) -> float:
        """Modulus E* of the contact, Pa."""
        return 1.0 / sum(compliances(self))

    def half_width(self, load: float) -> float:
        """Half the width b of the contact, m, under a load in N."""
        return math.sqrt(4.0 * load / self.length * self.effective_radius / (math.pi * self.effective_modulus))

    def curve(self) -> Curve:
        """Displacement under load: 2 ln(2 d/b) = ln(4 d^2/b_1^2) - ln P, b_1 the half width under 1 N."""
        depths = self.depth, self.housing_depth
        ratios = self.poisson_ratio, self.housing_poisson_ratio
        unit = self.half_width(1.0)
        line, slope = 0.0, 0.0
        for compliance, depth, nu in zip(compliances(self), depths, ratios, strict=True):
            share = compliance / (math.pi * self.length)
            line += share * (2.0 * math.log(2.0 * depth / unit) - nu / (1.0 - nu))
            slope += share
        return Curve(line=line, line_slope=slope, compliance=1.0 / self.housing_stiffness)


@dataclass(frozen=True)
class RockerContact:
    """A steel rocker of ``length``, m, by the empirical law of `ROCKER_FACTOR`."""

    length: float
    housing_stiffness: float = math.inf

    def __post_init__(self) -> None:
        check_positive(self, "length", "housing_stiffness")

    def curve(self) -> Curve:
        """Displacement under load."""
        factor = ROCKER_FACTOR / self.length**ROCKER_WIDTH_EXPONENT
        return Curve(factor=factor, exponent=ROCKER_EXPONENT, compliance=1.0 / self.housing_stiffness)


@dataclass(frozen=True)
class TablePivot:
    """A pivot that was measured: rising loads in N and displacements in m, from the first load above zero on."""

    loads: tuple[float, ...]
    displacements: tuple[float, ...]

    def __post_init__(self) -> None:
        loads, places = (0.0, *self.loads), (0.0, *self.displacements)
        if len(loads) != len(places) or len(loads) < 2:
            raise InputError("E101", f"a pivot table has {len(self.loads)} loads and {len(self.displacements)} "
                             "displacements; give as many of both, at least one.")  # fmt: skip
        if not (np.all(np.diff(loads) > 0.0) and np.all(np.diff(places) > 0.0)):
            raise InputError(
                "E101", "loads and displacements of a pivot table must both rise, from above zero on."
            )

    def curve(self) -> Curve:
        """Displacement under load."""
        return Curve(loads=(0.0, *self.loads), displacements=(0.0, *self.displacements))


Pivot = RigidPivot | SpringPivot | PointContact | LineContact | RockerContact | TablePivot


def displacement_of(pivot: Pivot, load: float) -> float:
    """Displacement of a pivot, m, under a load in N."""
    return pivot.curve().displacement(load)


def stiffness_of(pivot: Pivot, load: float) -> float:
    """Stiffness dP/du of a pivot, N/m, at a load in N; infinite for a rigid one."""
    flexibility = pivot.curve().flexibility(load)
    return 1.0 / flexibility if flexibility > 0.0 else math.inf


def contact_radius(pivot: PointContact, load: float) -> float:
    """Radius of the contact circle, m: (3 P R*/(4 E*))^(1/3), Johnson, eq. 4.22."""
    return math.cbrt(0.75 * load * pivot.effective_radius / pivot.effective_modulus)


def effective_radius(inner: float, outer: float) -> float:
    """Radius of the ball on a plane that touches as one of ``inner`` radius does in one of ``outer``, m."""
    return 1.0 / (1.0 / inner - 1.0 / outer)


def compliances(contact: PointContact | LineContact) -> tuple[float, float]:
    """(1 - nu^2)/E of both bodies, 1/Pa."""
    own = (1.0 - contact.poisson_ratio**2) / contact.elastic_modulus
    return own, (1.0 - contact.housing_poisson_ratio**2) / contact.housing_elastic_modulus


def check_contact(contact: PointContact | LineContact) -> None:
    """Refuse contacts that do not lie in each other, and impossible materials."""
    check_positive(contact, "radius", "elastic_modulus", "housing_elastic_modulus", "housing_stiffness")
    if not contact.housing_radius > contact.radius:
        raise InputError("E101", f"housing_radius is {contact.housing_radius} m; it must be more than the radius "
                         f"of the pivot in it, {contact.radius} m (inf for a plane).")  # fmt: skip
    for name in ("poisson_ratio", "housing_poisson_ratio"):
        if not 0.0 <= getattr(contact, name) <= 0.5:
            raise InputError("E101", f"{name} is {getattr(contact, name)}; it must lie between 0 and 0.5.")


def check_positive(part: object, *names: str) -> None:
    """Refuse numbers that are not positive."""
    for name in names:
        value = getattr(part, name)
        if not value > 0.0:
            raise InputError("E101", f"{name} is {value}; it must be a positive number (SI units).")
