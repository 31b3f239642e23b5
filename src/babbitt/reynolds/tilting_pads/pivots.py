"""How far the pivot of a pad gives way under its load.

Every law is a displacement u(P) that starts at zero; its stiffness is dP/du. In closed form

    u = a P^b + P (A - B ln P) + P / k,

with the power of a contact of points, the logarithm of one of lines, and whatever lies in series; a table
stands for what was measured.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np

from babbitt.core.notices import InputError

__all__ = [
    "Curve",
    "HertzContact",
    "LineContact",
    "Pivot",
    "PointContact",
    "RigidPivot",
    "RockerContact",
    "SpringPivot",
    "TablePivot",
    "YIELD",
    "displacement_of",
    "stiffness_of",
]

ROCKER_FACTOR, ROCKER_EXPONENT, ROCKER_WIDTH_EXPONENT = 1.530451e-10, 0.9, 0.8
"""u = 1.530451e-10 P^0.9 / l^0.8 (SI): steel rocker in a steel housing, as the pad models of ROSS 2.3 have it.

It is Palmgren's empirical law of a steel roller on its raceway (A. Palmgren, Ball and Roller Bearing Engineering,
1959; T. A. Harris, Rolling Bearing Analysis), 4.36e-7 Q^0.9/l^0.8 in inches and pounds, 3.84e-5 Q^0.9/l^0.8 in mm
and N. That a rocker in its hollow gives way as a roller does is an assumption: radii do not enter. About 40 %
softer than the contact of Hertz at 100 kN."""

YIELD = 650e6
"""Pa, assumption: yield strength of pivots of which none is given, that of 42CrMo4, quenched and tempered, 40 to
100 mm (ISO 683-2)."""

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

    def columns(self, force: float = 1.0, length: float = 1.0) -> tuple[float, float, float, float, float]:
        """Columns of the law in the kernels, in units of force and length in N and m."""
        share = force / length
        return (
            self.factor * float(force**self.exponent) / length,
            self.exponent,
            (self.line - self.line_slope * math.log(force)) * share,
            self.line_slope * share,
            self.compliance * share,
        )

    def at(self, load: float) -> tuple[float, float]:
        """Displacement u, m, and slope du/dP, m/N, under a load in N."""
        from babbitt.reynolds.tilting_pads._pivot_curve import pivot_curve  # numba, which reading a case needs not

        table = np.array(self.loads, dtype=np.float64), np.array(self.displacements, dtype=np.float64)
        displacement, slope = pivot_curve(np.array(self.columns()), *table, load)
        return float(displacement), float(slope)


NONE = Curve()
"""No displacement under any load."""


@dataclass(frozen=True)
class RigidPivot:
    """A pivot that does not give way."""

    def curve(self) -> Curve:
        """Displacement under load."""
        return NONE


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
class HertzContact:
    """A round pivot of ``radius`` in a hollow of ``housing_radius``, m, of elastic bodies (Hertz).

    1/R* = 1/r_1 - 1/r_2, and 1/E* the sum of (1 - nu^2)/E over both bodies: K. L. Johnson, Contact Mechanics
    (1985), eq. 4.17 and 4.19.

    Attributes
    ----------
    radius, housing_radius : float
        m; the second above the first, ``inf`` for a plane.
    elastic_modulus, housing_elastic_modulus : float
        Pa.
    poisson_ratio, housing_poisson_ratio : float
    housing_stiffness : float
        In series, N/m; ``inf``: rigid.
    yield_strength : float
        Of the softer body, Pa.
    """

    radius: float
    housing_radius: float
    elastic_modulus: float = field(default=210e9, kw_only=True)
    poisson_ratio: float = field(default=0.3, kw_only=True)
    housing_elastic_modulus: float = field(default=210e9, kw_only=True)
    housing_poisson_ratio: float = field(default=0.3, kw_only=True)
    housing_stiffness: float = field(default=math.inf, kw_only=True)
    yield_strength: float = field(default=YIELD, kw_only=True)

    def __post_init__(self) -> None:
        check_positive(
            self, "radius", "elastic_modulus", "housing_elastic_modulus", "housing_stiffness", "yield_strength"
        )
        if not self.housing_radius > self.radius:
            raise InputError("E101", f"housing_radius is {self.housing_radius} m; it must be more than the radius "
                             f"of the pivot in it, {self.radius} m (inf for a plane).")  # fmt: skip
        for name in ("poisson_ratio", "housing_poisson_ratio"):
            if not 0.0 <= getattr(self, name) <= 0.5:
                raise InputError("E101", f"{name} is {getattr(self, name)}; it must lie between 0 and 0.5.")

    @property
    def effective_radius(self) -> float:
        """Radius R* of the contact, m."""
        return 1.0 / (1.0 / self.radius - 1.0 / self.housing_radius)

    @property
    def compliances(self) -> tuple[float, float]:
        """(1 - nu^2)/E of both bodies, 1/Pa."""
        own = (1.0 - self.poisson_ratio**2) / self.elastic_modulus
        return own, (1.0 - self.housing_poisson_ratio**2) / self.housing_elastic_modulus

    @property
    def effective_modulus(self) -> float:
        """Modulus E* of the contact, Pa."""
        return 1.0 / sum(self.compliances)

    def contact_pressure(self, load: float) -> float:
        """Largest pressure p_0 in the contact, Pa, under a load in N."""
        raise NotImplementedError

    yield_factor: ClassVar[float]
    """p_0 at which the bodies begin to yield below their surfaces, over their yield strength."""

    @property
    def bearable_pressure(self) -> float:
        """p_0 at which the bodies begin to yield, Pa."""
        return self.yield_factor * self.yield_strength


@dataclass(frozen=True)
class PointContact(HertzContact):
    """A sphere in a hollow sphere; attributes as of `HertzContact`.

    u = (3 P / (4 E* sqrt(R*)))^(2/3) and dP/du = (6 E*^2 R* P)^(1/3): Johnson, eq. 4.23.
    """

    yield_factor: ClassVar[float] = 1.60
    """Johnson (1985), 4.5(b), with Poisson's ratio 0.3."""

    def contact_pressure(self, load: float) -> float:
        """p_0 = (6 P E*^2/(pi^3 R*^2))^(1/3): Johnson, eq. 4.24."""
        modulus, radius = self.effective_modulus, self.effective_radius
        return float((6.0 * load * modulus**2 / (math.pi**3 * radius**2)) ** (1.0 / 3.0))

    def curve(self) -> Curve:
        """Displacement under load."""
        factor = (3.0 / (4.0 * self.effective_modulus * math.sqrt(self.effective_radius))) ** (2.0 / 3.0)
        return Curve(factor=factor, exponent=2.0 / 3.0, compliance=1.0 / self.housing_stiffness)


@dataclass(frozen=True)
class LineContact(HertzContact):
    """A cylinder along ``length`` in a hollow one; further attributes as of `HertzContact`.

    b = sqrt(4 P' R*/(pi E*)), P' the load per length, and
    u = P' sum (1 - nu_i^2)/(pi E_i) [2 ln(2 d_i/b) - nu_i/(1 - nu_i)]: Johnson, eq. 4.45 and 5.57. It depends on
    the depths d_i below the contact to which a displacement is counted.

    Attributes
    ----------
    length, depth, housing_depth : float
        Of the contact, and d_i, m.
    """

    length: float
    depth: float
    housing_depth: float

    def __post_init__(self) -> None:
        super().__post_init__()
        check_positive(self, "length", "depth", "housing_depth")

    yield_factor: ClassVar[float] = 1.67
    """Johnson (1985), 4.5(a)."""

    def contact_pressure(self, load: float) -> float:
        """p_0 = sqrt(P' E*/(pi R*)): Johnson, eq. 4.46."""
        return math.sqrt(load / self.length * self.effective_modulus / (math.pi * self.effective_radius))

    def half_width(self, load: float) -> float:
        """Half the width b of the contact, m, under a load in N."""
        return math.sqrt(4.0 * load / self.length * self.effective_radius / (math.pi * self.effective_modulus))

    def curve(self) -> Curve:
        """Displacement under load: 2 ln(2 d/b) = ln(4 d^2/b_1^2) - ln P, b_1 the half width under 1 N."""
        depths = self.depth, self.housing_depth
        ratios = self.poisson_ratio, self.housing_poisson_ratio
        unit = self.half_width(1.0)
        line, slope = 0.0, 0.0
        for compliance, depth, nu in zip(self.compliances, depths, ratios, strict=True):
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
    return pivot.curve().at(load)[0]


def stiffness_of(pivot: Pivot, load: float) -> float:
    """Stiffness dP/du of a pivot, N/m, at a load in N; infinite for a rigid one.

    Not a number where the displacement falls with the load: a contact of lines as wide as it is deep is beyond its
    law.
    """
    if isinstance(pivot, RigidPivot):
        return math.inf
    _, slope = pivot.curve().at(max(load, LIGHTEST))
    if slope < 0.0:
        return math.nan
    return 1.0 / slope


def check_positive(part: object, *names: str) -> None:
    """Refuse numbers that are not positive."""
    for name in names:
        value = getattr(part, name)
        if not value > 0.0:
            raise InputError("E101", f"{name} is {value}; it must be a positive number (SI units).")
