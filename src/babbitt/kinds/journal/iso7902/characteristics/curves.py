"""What the characteristics of one bearing shape answer: load, direction, flow and pressure over eccentricity."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np

from babbitt.numerics.piecewise_cubic import PiecewiseCubic
from babbitt.numerics.scalar_or_array import Array, Value, outside
from babbitt.numerics.spline_cuts import SplineCuts

_ROUND_OFF = 1e-13


class BearingCurves(Protocol):
    """Dimensionless characteristics of one span and one B/D, whatever they are computed from.

    Every method takes one number or an array of them; an argument outside the range raises `ValueError`.
    """

    @property
    def span_degrees(self) -> int:
        """Angle of the bearing arc [deg]."""

    @property
    def width_ratio(self) -> float:
        """B/D."""

    @property
    def largest_eccentricity_ratio(self) -> float:
        """Where the curves end."""

    @property
    def largest_sommerfeld_number(self) -> float:
        """So at the largest eccentricity ratio; a larger load has no answer."""

    def sommerfeld_number(self, eccentricity_ratio: Value) -> Value:
        """So = F psi^2/(B D eta omega)."""

    def attitude_angle(self, eccentricity_ratio: Value) -> Value:
        """Angle from the load line to the narrowest gap [rad]."""

    def side_flow_number(self, eccentricity_ratio: Value) -> Value:
        """Q3* = Q3/(D^3 psi omega)."""

    def pressure_ratio(self, eccentricity_ratio: Value) -> Value:
        """Largest film pressure over the specific load."""

    def eccentricity_ratio(self, sommerfeld_number: Value) -> Value:
        """The inverse of `sommerfeld_number`."""


@dataclass(frozen=True, eq=False)
class CharacteristicCurves:
    """Characteristics of one span and one B/D from the tables of our own Reynolds solutions; a `BearingCurves`.

    Between nodes the curves are cubic splines over t = ln(eps/(1 - eps)). Below the first node (eps = 0.01)
    they follow the limit of small eccentricity: So and Q3* proportional to eps, beta linear in eps, p_max/p
    constant.

    Attributes
    ----------
    span_degrees : int
        Angle of the bearing arc [deg].
    width_ratio : float
        B/D.
    log_load, attitude, log_flow, log_pressure : PiecewiseCubic
        ln So, beta [rad], ln Q3* and ln(p_max/p) over t.
    smallest_eccentricity_ratio, largest_eccentricity_ratio : float
        First and last node of the tables.
    """

    span_degrees: int
    width_ratio: float
    log_load: PiecewiseCubic | SplineCuts
    attitude: PiecewiseCubic | SplineCuts
    log_flow: PiecewiseCubic | SplineCuts
    log_pressure: PiecewiseCubic | SplineCuts
    smallest_eccentricity_ratio: float
    largest_eccentricity_ratio: float
    smallest_tabulated_sommerfeld_number: float = field(init=False)
    largest_sommerfeld_number: float = field(init=False)
    _attitude_slope: float = field(init=False, repr=False)

    def __post_init__(self) -> None:
        first = self.smallest_eccentricity_ratio
        slope = self.attitude.first_slope / (first * (1.0 - first))  # d beta/d eps = d beta/dt dt/d eps
        object.__setattr__(self, "_attitude_slope", slope)
        object.__setattr__(self, "smallest_tabulated_sommerfeld_number", self.sommerfeld_number(first))
        last = self.sommerfeld_number(self.largest_eccentricity_ratio)
        object.__setattr__(self, "largest_sommerfeld_number", last)

    def sommerfeld_number(self, eccentricity_ratio: Value) -> Value:
        """So = F psi^2/(B D eta omega); strictly increasing in eps, 0 at eps = 0."""
        inside, place = self._place(eccentricity_ratio)
        load: Value = _power(self.log_load, place)
        return load * (eccentricity_ratio / inside)

    def attitude_angle(self, eccentricity_ratio: Value) -> Value:
        """Angle beta from the load line to the narrowest gap, positive with rotation [rad]."""
        inside, place = self._place(eccentricity_ratio)
        beyond = self._attitude_slope * (eccentricity_ratio - inside)
        angle: Value = _at(self.attitude, place) + beyond
        return angle

    def side_flow_number(self, eccentricity_ratio: Value) -> Value:
        """Q3* = Q3/(D^3 psi omega), both rims together."""
        inside, place = self._place(eccentricity_ratio)
        flow: Value = _power(self.log_flow, place)
        return flow * (eccentricity_ratio / inside)

    def pressure_ratio(self, eccentricity_ratio: Value) -> Value:
        """Largest film pressure over the specific load, p_max/p."""
        _, place = self._place(eccentricity_ratio)
        pressure: Value = _power(self.log_pressure, place)
        return pressure

    def eccentricity_ratio(self, sommerfeld_number: Value) -> Value:
        """The eccentricity ratio that carries a load; ``sommerfeld_number`` gives it back to round-off.

        Raises
        ------
        ValueError
            If the Sommerfeld number is negative, not a number, or above `largest_sommerfeld_number`.
        """
        check_load(sommerfeld_number, self)
        least = self.smallest_tabulated_sommerfeld_number
        linear = self.smallest_eccentricity_ratio / least
        if isinstance(sommerfeld_number, np.ndarray):
            place = self.log_load.places_of(np.log(np.maximum(sommerfeld_number, least)))
            curved = np.minimum(1.0 / (1.0 + np.exp(-place)), self.largest_eccentricity_ratio)
            found = np.where(sommerfeld_number <= least, sommerfeld_number * linear, curved)
            return found.view(type(sommerfeld_number))
        if sommerfeld_number <= least:
            return sommerfeld_number * linear
        assert isinstance(self.log_load, PiecewiseCubic), "loads of many cuts are lanes"
        place = self.log_load.place_of(math.log(sommerfeld_number))
        return min(1.0 / (1.0 + math.exp(-place)), self.largest_eccentricity_ratio)

    def _place(self, eccentricity_ratio: Value) -> tuple[Value, Value]:
        """Eccentricity within the nodes, and its t = ln(eps/(1 - eps))."""
        first = self.smallest_eccentricity_ratio
        if isinstance(eccentricity_ratio, np.ndarray):
            check_eccentricity(eccentricity_ratio, self)
            inside = np.maximum(eccentricity_ratio, first)
            return inside, np.log(inside / (1.0 - inside))
        if not 0.0 <= eccentricity_ratio <= self.largest_eccentricity_ratio:
            check_eccentricity(eccentricity_ratio, self)
        within = max(float(eccentricity_ratio), first)
        return within, math.log(within / (1.0 - within))


def _at(function: PiecewiseCubic | SplineCuts, place: float | Array) -> Any:
    return function.at(place) if isinstance(place, float) else function.at_many(place)


def _power(function: PiecewiseCubic | SplineCuts, place: float | Array) -> Any:
    """What a function gives whose logarithm is known."""
    level = _at(function, place)
    return math.exp(level) if isinstance(level, float) else np.exp(level)


def check_eccentricity(eccentricity_ratio: float | Array, curves: BearingCurves) -> None:
    """Raise `ValueError` for an eccentricity ratio outside the curves."""
    largest = curves.largest_eccentricity_ratio
    if outside(eccentricity_ratio, 0.0, largest):
        raise ValueError(
            f"the eccentricity ratio must be from 0 to {largest:g}, where the characteristics are known; "
            f"given was {_worst(eccentricity_ratio):.6g}"
        )


def check_load(sommerfeld_number: float | Array, curves: BearingCurves) -> None:
    """Raise `ValueError` for a Sommerfeld number that no eccentricity ratio of the curves carries."""
    largest = curves.largest_sommerfeld_number
    # a load computed at the largest eccentricity may differ in its last bits, as `math` and numpy do
    if outside(sommerfeld_number, 0.0, largest * (1.0 + _ROUND_OFF)):
        raise ValueError(
            f"the Sommerfeld number must be from 0 to {largest:.6g}, which is reached at an eccentricity ratio "
            f"of {curves.largest_eccentricity_ratio:g} for a span of {curves.span_degrees} deg and B/D = "
            f"{curves.width_ratio:g}; given was {_worst(sommerfeld_number):.6g}"
        )


def _worst(value: float | Array) -> float:
    """The value to name in a message."""
    values = np.ravel(value)
    return float(values[np.argmax(np.where(values < 0.0, np.inf, np.nan_to_num(values, nan=np.inf)))])
