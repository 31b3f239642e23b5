"""The closed-form characteristics of the full bearing in DIN 31652: an alternative to the tables.

Fitted by Butenschoen (dissertation, Karlsruhe 1976) to his own solutions; coefficients as in DIN 31652-2 and
in the public source of the multibody code MBDyn. Against his tables for B/D 1/8 ... 1 and eps 0.1 ... 0.99
they are off by up to 7 % in So, 2.5 deg in the attitude angle and 3.2 % in side flow, between the widths of
his tables by more (`DEVIATIONS`), so they serve for comparison with programs that use them and not as the default.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from babbitt.core.notices import InputError
from babbitt.kinds.journal.iso7902.characteristics.curves import check_eccentricity, check_load
from babbitt.kinds.journal.iso7902.characteristics.tables import curves
from babbitt.numerics.scalar_or_array import Value, functions_for

WIDTH_RATIOS = (0.125, 1.0)  # the range of Butenschoen's tables; outside, the polynomials mean nothing
DEVIATIONS = {"sommerfeld_number": 0.11, "attitude_angle_degrees": 2.5, "side_flow": 0.042}
"""Largest deviation from our own curves over B/D 1/8 ... 1: relative, absolute from eps 0.1 on, relative."""
LARGEST_ATTITUDE_DEVIATION = 13.0  # deg, at eps towards 0, where the true angle tends to about 90 deg at B/D 1/8
_MOST_STEPS = 200


@dataclass(frozen=True)
class ClosedFormCurves:
    """DIN 31652 closed forms of the full bearing; a
    `babbitt.kinds.journal.iso7902.characteristics.curves.BearingCurves`.

    Parameters
    ----------
    width_ratio : float
        B/D, 1/8 to 1.

    Raises
    ------
    InputError
        E006 if B/D is outside the range of the fit.

    Examples
    --------
    >>> fit = ClosedFormCurves(0.5)
    >>> round(fit.sommerfeld_number(0.7), 3)
    0.864
    >>> round(fit.eccentricity_ratio(0.864), 3)
    0.7
    """

    width_ratio: float

    def __post_init__(self) -> None:
        low, high = WIDTH_RATIOS
        if not low <= self.width_ratio <= high:
            raise InputError(
                "E006",
                f"the closed forms of DIN 31652 hold for a width ratio B/D from {low:g} to {high:g}; given was "
                f"{self.width_ratio:g}. The tables reach from 0.1 to 1.5.",
            )

    @property
    def span_degrees(self) -> int:
        """360: the closed forms are for the full bearing alone."""
        return 360

    @property
    def largest_eccentricity_ratio(self) -> float:
        """Where the fitted tables end."""
        return 0.99

    @cached_property
    def largest_sommerfeld_number(self) -> float:
        """So at the largest eccentricity ratio."""
        return self.sommerfeld_number(self.largest_eccentricity_ratio)

    @cached_property
    def _load_coefficients(self) -> tuple[float, float]:
        x = self.width_ratio
        a1 = 1.1642 - 1.9456 * x + 7.1161 * x**2 - 10.1073 * x**3 + 5.0141 * x**4
        a2 = -1.000026 - 0.023634 * x - 0.4215 * x**2 - 0.038817 * x**3 - 0.090551 * x**4
        return a1, a2

    @cached_property
    def _attitude_coefficients(self) -> tuple[float, float, float, float, float]:
        x = self.width_ratio
        return (
            1.152624 - 0.105465 * x,
            -2.5905 + 0.798745 * x,
            8.73393 - 2.3291 * x,
            -13.3414 + 3.424337 * x,
            6.6294 - 1.591732 * x,
        )

    def sommerfeld_number(self, eccentricity_ratio: Value) -> Value:
        """So, from the short bearing times a fitted factor.

        So = x^2 eps/(2 (1 - eps^2)^2) sqrt(pi^2 (1 - eps^2) + 16 eps^2) a1 (eps - 1)/(a2 + eps).
        """
        check_eccentricity(eccentricity_ratio, self)
        a1, a2 = self._load_coefficients
        rest = 1.0 - eccentricity_ratio**2
        root = functions_for(eccentricity_ratio).sqrt(math.pi**2 * rest + 16.0 * eccentricity_ratio**2)
        short: Value = 0.5 * self.width_ratio**2 * eccentricity_ratio / rest**2 * root
        return short * a1 * (eccentricity_ratio - 1.0) / (a2 + eccentricity_ratio)

    def attitude_angle(self, eccentricity_ratio: Value) -> Value:
        """Attitude angle beta [rad]: a polynomial times arctan(pi sqrt(1 - eps^2)/(2 eps))."""
        check_eccentricity(eccentricity_ratio, self)
        b1, b2, b3, b4, b5 = self._attitude_coefficients
        f, eps = functions_for(eccentricity_ratio), eccentricity_ratio
        angle: Value = f.atan2(math.pi * f.sqrt(1.0 - eps**2), 2.0 * eps)
        return (b1 + eps * (b2 + eps * (b3 + eps * (b4 + eps * b5)))) * angle

    def side_flow_number(self, eccentricity_ratio: Value) -> Value:
        """Q3* = (x - 0.223 x^3) eps/4."""
        check_eccentricity(eccentricity_ratio, self)
        x = self.width_ratio
        return 0.25 * (x - 0.223 * x**3) * eccentricity_ratio

    def pressure_ratio(self, eccentricity_ratio: Value) -> Value:
        """p_max/p from the tables of the full bearing, as the closed forms do not give it."""
        return curves(360, self.width_ratio).pressure_ratio(eccentricity_ratio)

    def eccentricity_ratio(self, sommerfeld_number: Value) -> Value:
        """The eccentricity ratio that carries a load; ``sommerfeld_number`` gives it back to round-off.

        Raises
        ------
        ValueError
            If the Sommerfeld number is negative, not a number, or above `largest_sommerfeld_number`.
        """
        check_load(sommerfeld_number, self)
        if isinstance(sommerfeld_number, np.ndarray):
            roots = [self._root(float(load)) for load in sommerfeld_number.flat]
            return np.array(roots).reshape(sommerfeld_number.shape).view(type(sommerfeld_number))
        return self._root(sommerfeld_number)

    def _root(self, load: float) -> float:
        """Solve ln So(eps) = ln(load) over t = ln(eps/(1 - eps)), in which it is nearly straight.

        False position with the Illinois rule (Dowell and Jarratt, BIT 11, 1971). So/eps grows from its
        limit at 0, but for a dip of about 1 % at small B/D, so that its values at both ends bracket the root.
        """
        last = self.largest_eccentricity_ratio
        a1, a2 = self._load_coefficients
        tangent = -0.5 * math.pi * self.width_ratio**2 * a1 / a2
        if load < 1e-12 * tangent:  # straight to round-off; and no logarithm of zero
            return load / tangent
        low, high = _logit(last * load / self.largest_sommerfeld_number), _logit(min(1.05 * load / tangent, last))
        miss_low, miss_high = self._miss(low, load), self._miss(high, load)
        place = low
        for _ in range(_MOST_STEPS):
            if miss_high == miss_low:
                break
            last_place, place = place, high - miss_high * (high - low) / (miss_high - miss_low)
            miss = self._miss(place, load)
            if abs(place - last_place) < 1e-15 or miss == 0.0:
                break
            if miss > 0.0:
                high, miss_high, miss_low = place, miss, 0.5 * miss_low
            else:
                low, miss_low, miss_high = place, miss, 0.5 * miss_high
        return min(_logistic(place), last)

    def _miss(self, place: float, load: float) -> float:
        return math.log(self.sommerfeld_number(min(_logistic(place), self.largest_eccentricity_ratio)) / load)


def _logit(eccentricity_ratio: float) -> float:
    return math.log(eccentricity_ratio / (1.0 - eccentricity_ratio))


def _logistic(place: float) -> float:
    return 1.0 / (1.0 + math.exp(-place))
