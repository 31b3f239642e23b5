"""Supply elements and the oil flow that the supply pressure drives through the film.

The supply-flow number is ``Qp* = Qp η/(D³ ψ³ p_en)``. Holes and pockets follow the fits in general use with
ISO 7902 (``q_H``, ``q_P``), valid for a relative width 0.05 to 0.7; beyond, a published gearbox study (2023) keeps
the correction of the nearest bound and the true width in the logarithm. Both groove formulas are exact integrals
of the cube of the film thickness over the groove.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Protocol

from babbitt.kinds.journal.feed_pressure import pressed_area
from babbitt.numerics.scalar_or_array import clipped, functions_for, smaller

FIT_RANGE = (0.05, 0.7)
"""Range of relative width in which the fits ``q_H`` and ``q_P`` are defined."""

LOGARITHM_UP_TO = 0.9
"""Relative width up to which ``ln(1/s)`` takes the true one (assumption): at 1 the flow would be infinite."""


class Arrangement(Enum):
    """Where holes, slots or pockets sit, seen from the load."""

    OPPOSITE = "opposite"
    SIDE = "side"
    BOTH_SIDES = "both_sides"

    def film_factor(self, eccentricity_ratio: float) -> float:
        """Cube of the film thickness at the element over the concentric one, summed over the elements."""
        match self:
            case Arrangement.OPPOSITE:
                return (1.0 + eccentricity_ratio) ** 3
            case Arrangement.SIDE:
                return 1.0
            case Arrangement.BOTH_SIDES:
                return 2.0

    @property
    def angle(self) -> float:
        """From the middle of the element that feeds the loaded film to the load, in the sense of rotation, rad.

        An element at the side stands before the load. Of two the other, behind the load, gives its oil to the
        unloaded half, from which it comes round to the first: it adds nothing.
        """
        return math.pi if self is Arrangement.OPPOSITE else 0.5 * math.pi

    def angle_in(self, span: float) -> float:
        """The same in a film of that span in rad: elements at both sides stand where the arc ends."""
        return min(self.angle, 0.5 * span) if self is Arrangement.BOTH_SIDES else self.angle


def gap_factor(eccentricity_ratio: float, attitude_angle: float, before_load: float) -> float:
    """Film thickness over the radial clearance at an angle before the load, in the sense of rotation, rad.

    ``1 - ε cos(α + β)``: the narrowest gap lies at the attitude angle β behind the load.

    >>> round(gap_factor(0.6, math.radians(50.0), math.radians(130.0)), 6)
    1.6
    """
    angle = before_load + attitude_angle
    cosine: float = functions_for(angle).cos(angle)
    return 1.0 - eccentricity_ratio * cosine


def share_at_place(eccentricity_ratio: float, attitude_angle: float, before: float, behind: float) -> float:
    """Q_p of two elements where they stand over that of `Arrangement.BOTH_SIDES`, which takes the concentric gap.

    The mean cube of the gaps at both, ``((1 - ε cos(α_1 + β))³ + (1 - ε cos(α_2 - β))³)/2``, and no more than 1.

    Parameters
    ----------
    eccentricity_ratio, attitude_angle : float
        Of the film; the angle in rad.
    before, behind : float
        From the middle of the element before the load to the load, and from the load to that behind it, rad.

    Examples
    --------
    At the ends of an arc of 90 deg, pockets of 20 deg; at 90 deg to the load:

    >>> beta = math.radians(22.0)
    >>> round(share_at_place(0.843, beta, math.radians(55.0), math.radians(55.0)), 2)
    0.28
    >>> share_at_place(0.843, beta, math.radians(90.0), math.radians(90.0))
    1.0
    """
    entry = gap_factor(eccentricity_ratio, attitude_angle, before)
    leaving = gap_factor(eccentricity_ratio, attitude_angle, -behind)
    return smaller(0.5 * (entry**3 + leaving**3), 1.0)


class SupplyElement(Protocol):
    """What feeds the film: a hole, a slot, a pocket or a groove."""

    def relative_width(self, bearing_width: float) -> float:
        """Axial size of the element over the bearing width."""
        ...

    def supply_flow_number(self, eccentricity_ratio: float, bearing_width: float, width_ratio: float) -> float:
        """Supply-flow number Qp*."""
        ...


def fitted_width(relative_width: float) -> float:
    """Relative width at which ``q_H`` and ``q_P`` are taken: the nearest within their range.

    >>> fitted_width(0.73), fitted_width(0.01), fitted_width(0.3)
    (0.7, 0.05, 0.3)
    """
    return clipped(relative_width, *FIT_RANGE)


def logarithm_width(relative_width: float) -> float:
    """Relative width in ``ln(1/s)``: the true one, as far as an element leaves lands beside it.

    >>> logarithm_width(0.82), logarithm_width(0.01), logarithm_width(0.95)
    (0.82, 0.01, 0.9)
    """
    return smaller(relative_width, LOGARITHM_UP_TO)


def hole_fit(s: float) -> float:
    """Correction ``q_H`` for a hole of relative diameter `s`."""
    return 1.204 + s * (0.368 + s * (-1.046 + s * 1.942))


def pocket_fit(s: float) -> float:
    """Correction ``q_P`` for a pocket of relative width `s`."""
    return 1.188 + s * (1.582 + s * (-2.585 + s * 5.563))


def equivalent_holes(length: float, width: float) -> tuple[float, float]:
    """Round holes that keep the total perimeter and the total area of a slot.

    Parameters
    ----------
    length, width : float
        Of the slot, in m.

    Returns
    -------
    diameter : float
        In m.
    number : float
        How many such holes; not an integer in general.

    Examples
    --------
    >>> diameter, number = equivalent_holes(0.050, 0.012)
    >>> round(diameter * 1e3, 3), round(number, 4)
    (19.355, 2.0393)
    """
    perimeter, area = 2.0 * (length + width), length * width
    diameter = 4.0 * area / perimeter
    return diameter, perimeter / (math.pi * diameter)


def _local_flow(fit: Callable[[float], float], s: float) -> float:
    lands: float = functions_for(s).log(1.0 / logarithm_width(s))
    return math.pi / 48.0 / (lands * fit(fitted_width(s)))


@dataclass(frozen=True)
class Holes:
    """One hole, or two at ±90°: `number` counts the holes at each place.

    `edge` is the angle in rad from the downstream edge of a hole to the load; None where the place says no more:
    at its middle, or where the arc ends. `axial_extent` is the width in m that the holes of one place take
    side by side, or the slot that they stand for (`equivalent_holes`); None where that is not known.
    """

    diameter: float
    arrangement: Arrangement
    number: float = 1.0
    edge: float | None = None
    axial_extent: float | None = None

    def edge_before_load(self, span: float) -> float:
        """Where the journal draws the loaded film of that span from it; angles in rad, that before the load."""
        return self.arrangement.angle_in(span) if self.edge is None else self.edge

    def places(self, span: float) -> tuple[float, float]:
        """Angles in rad from the hole before the load to it, and on to that behind it, each at its near edge."""
        before = self.edge_before_load(span)
        return before, before

    def relative_width(self, bearing_width: float) -> float:
        """Hole diameter over bearing width."""
        return self.diameter / bearing_width

    def axial_width(self, bearing_width: float) -> float:
        """Width in m over which the holes of one place give oil to the film: side by side along the shaft."""
        return smaller(bearing_width, self.number * self.diameter)

    def supply_flow_number(self, eccentricity_ratio: float, bearing_width: float, width_ratio: float) -> float:
        """Supply-flow number Qp*."""
        s = self.relative_width(bearing_width)
        return self.number * self.arrangement.film_factor(eccentricity_ratio) * _local_flow(hole_fit, s)


@dataclass(frozen=True)
class Pockets:
    """One pocket, or two at about ±90°. The extent around the bore, rad, does not enter the flow by pressure.

    `edge` is the angle in rad from the downstream edge of the pocket to the load; None where the place says no
    more: at its middle, or where the arc ends. `behind` is that from the load to the middle of the pocket behind
    it; None where both stand evenly.
    """

    width: float
    arrangement: Arrangement
    edge: float | None = None
    extent: float = 0.0
    behind: float | None = None

    def edge_before_load(self, span: float) -> float:
        """Where the journal draws the loaded film of that span from it; angles in rad, that before the load."""
        return self.arrangement.angle_in(span) if self.edge is None else self.edge

    def places(self, span: float) -> tuple[float, float]:
        """Angles in rad from the middle of the pocket before the load to it, and on to that behind it."""
        before = self.edge_before_load(span) + 0.5 * self.extent
        return before, before if self.behind is None else self.behind

    def pressed_area(self, bearing_diameter: float) -> float:
        """Projected area in m² over which one pocket presses on the journal."""
        return pressed_area(bearing_diameter, self.width, min(self.extent, math.pi))

    def relative_width(self, bearing_width: float) -> float:
        """Pocket width over bearing width."""
        return self.width / bearing_width

    def axial_width(self, bearing_width: float) -> float:
        """Width in m over which a pocket gives oil to the film."""
        return smaller(bearing_width, self.width)

    def supply_flow_number(self, eccentricity_ratio: float, bearing_width: float, width_ratio: float) -> float:
        """Supply-flow number Qp*."""
        s = self.relative_width(bearing_width)
        return self.arrangement.film_factor(eccentricity_ratio) * _local_flow(pocket_fit, s)


@dataclass(frozen=True)
class CircumferentialGroove:
    """A groove around the whole circumference."""

    width: float

    def relative_width(self, bearing_width: float) -> float:
        """Groove width over bearing width."""
        return self.width / bearing_width

    def supply_flow_number(self, eccentricity_ratio: float, bearing_width: float, width_ratio: float) -> float:
        """Supply-flow number Qp*, the integral of h³ over 360°."""
        share = math.pi / 24.0 * (1.0 + 1.5 * eccentricity_ratio**2)
        return share / width_ratio / (1.0 - self.relative_width(bearing_width))


@dataclass(frozen=True)
class HalfCircumferentialGroove:
    """A groove around the unloaded half (180°), which ends where the loaded half begins."""

    width: float

    def edge_before_load(self, span: float) -> float:
        """Where the journal draws the loaded film from it: at its edge at the side before the load, rad."""
        return Arrangement.SIDE.angle

    def pressed_area(self, bearing_diameter: float) -> float:
        """Projected area in m² over which the groove presses on the journal."""
        return pressed_area(bearing_diameter, self.width, math.pi)

    def axial_width(self, bearing_width: float) -> float:
        """Width in m over which the groove gives oil to the film."""
        return smaller(bearing_width, self.width)

    def relative_width(self, bearing_width: float) -> float:
        """Groove width over bearing width."""
        return self.width / bearing_width

    def supply_flow_number(self, eccentricity_ratio: float, bearing_width: float, width_ratio: float) -> float:
        """Supply-flow number Qp*, the integral of h³ over the half opposite the narrowest gap."""
        e = eccentricity_ratio
        share = (math.pi * (1.0 + 1.5 * e**2) + 6.0 * e + 4.0 / 3.0 * e**3) / 48.0
        return share / width_ratio / (1.0 - self.relative_width(bearing_width))
