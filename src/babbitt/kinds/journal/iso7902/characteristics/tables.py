"""The tables of bearing characteristics that ship with Babbitt, and curves cut from them at one B/D.

The nodes are Reynolds solutions of our own (`babbitt.validation.research.arc_film`), made by
``scripts/generate_characteristics.py``. Between the nodes ln So, beta, ln Q3* and ln(p_max/p) are bicubic
splines over t = ln(eps/(1 - eps)) and ln(B/D). A spline reproduces straight lines, so interpolating ln So is
the same as interpolating the nearly constant load factor ln(So (1 - eps)/(eps B/D)) over these variables.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from babbitt.core.notices import InputError
from babbitt.kinds.journal.iso7902.characteristics.curves import CharacteristicCurves
from babbitt.numerics.lanes import Lanes
from babbitt.numerics.piecewise_cubic import PiecewiseCubic
from babbitt.numerics.scalar_or_array import Array, Value, outside
from babbitt.numerics.spline_cuts import SplineCuts, cuts_of
from babbitt.numerics.tensor_spline import TensorSpline

TABLE_FILE = "tables.npz"
SPANS_DEGREES = (360, 180, 150, 120, 90)


@dataclass(frozen=True, eq=False)
class CharacteristicTable:
    """Node values of one span.

    Attributes
    ----------
    span_degrees : int
        Angle of the bearing arc [deg].
    eccentricity_ratios : ndarray, shape (n,)
        Nodes in eps.
    width_ratios : ndarray, shape (m,)
        Nodes in B/D.
    sommerfeld_numbers, attitude_angles, side_flow_numbers, pressure_ratios : ndarray, shape (n, m)
        So, beta [rad], Q3*, p_max/p.
    """

    span_degrees: int
    eccentricity_ratios: Array
    width_ratios: Array
    sommerfeld_numbers: Array
    attitude_angles: Array
    side_flow_numbers: Array
    pressure_ratios: Array

    @cached_property
    def spline(self) -> TensorSpline:
        """ln So, beta, ln Q3* and ln(p_max/p) over t = ln(eps/(1 - eps)) and ln(B/D)."""
        eps = self.eccentricity_ratios
        return TensorSpline(
            first_nodes=np.log(eps / (1.0 - eps)),
            second_nodes=np.log(self.width_ratios),
            values=np.stack(
                [
                    np.log(self.sommerfeld_numbers),
                    self.attitude_angles,
                    np.log(self.side_flow_numbers),
                    np.log(self.pressure_ratios),
                ]
            ),
        )


@lru_cache(maxsize=len(SPANS_DEGREES))
def table(span_degrees: int) -> CharacteristicTable:
    """Node values of one of the tabulated spans.

    Parameters
    ----------
    span_degrees : int
        360, 180, 150, 120 or 90.

    Raises
    ------
    InputError
        E006 for any other span.
    """
    if span_degrees not in SPANS_DEGREES:
        raise InputError(
            "E006",
            f"characteristics are tabulated for spans of {', '.join(map(str, SPANS_DEGREES))} deg; given was "
            f"{span_degrees:g} deg. Take the next smaller span, which is on the safe side.",
        )
    stored = _stored()
    index = SPANS_DEGREES.index(span_degrees)
    return CharacteristicTable(
        span_degrees=span_degrees,
        eccentricity_ratios=stored["eccentricity_ratio"],
        width_ratios=stored["width_ratio"],
        sommerfeld_numbers=stored["sommerfeld_number"][index],
        attitude_angles=stored["attitude_angle"][index],
        side_flow_numbers=stored["side_flow_number"][index],
        pressure_ratios=stored["pressure_ratio"][index],
    )


@lru_cache(maxsize=1)
def _stored() -> dict[str, Array]:
    with files("babbitt.kinds.journal.iso7902.characteristics").joinpath(TABLE_FILE).open("rb") as file:
        stored = np.load(file, allow_pickle=False)
        if tuple(stored["span_degrees"].tolist()) != SPANS_DEGREES:
            raise RuntimeError(f"{TABLE_FILE} was made for other spans; run scripts/generate_characteristics.py")
        return {name: stored[name] for name in stored.files}


def curves(span_degrees: int, width_ratio: Value) -> CharacteristicCurves:
    """Characteristics over eccentricity for one span and one B/D, or for one B/D in each of many lanes.

    Parameters
    ----------
    span_degrees : int
        360, 180, 150, 120 or 90.
    width_ratio : float or Lanes
        B/D, 0.1 to 1.5.

    Returns
    -------
    CharacteristicCurves
        The same object for the same arguments, where they are numbers.

    Raises
    ------
    InputError
        E006 for a span or a B/D outside the tables.

    Examples
    --------
    >>> full = curves(360, 1.0)
    >>> round(full.sommerfeld_number(0.5), 3)
    0.891
    >>> round(full.eccentricity_ratio(0.891), 3)
    0.5
    """
    if isinstance(width_ratio, Lanes):
        _check_width_ratio(width_ratio, table(span_degrees))
        return _curves(span_degrees, width_ratio, cuts_of(table(span_degrees).spline, np.log(width_ratio)))
    return _curves_of_one(span_degrees, float(width_ratio))


@lru_cache(maxsize=4096)
def _curves_of_one(span_degrees: int, width_ratio: float) -> CharacteristicCurves:
    nodes = table(span_degrees)
    _check_width_ratio(width_ratio, nodes)
    return _curves(span_degrees, width_ratio, nodes.spline.cut(math.log(width_ratio)))


def _curves(
    span_degrees: int, width_ratio: Any, functions: tuple[PiecewiseCubic, ...] | tuple[SplineCuts, ...]
) -> CharacteristicCurves:
    log_load, attitude, log_flow, log_pressure = functions
    nodes = table(span_degrees)
    return CharacteristicCurves(
        span_degrees=span_degrees,
        width_ratio=width_ratio,
        log_load=log_load,
        attitude=attitude,
        log_flow=log_flow,
        log_pressure=log_pressure,
        smallest_eccentricity_ratio=float(nodes.eccentricity_ratios[0]),
        largest_eccentricity_ratio=float(nodes.eccentricity_ratios[-1]),
    )


def sommerfeld_number(span_degrees: int, eccentricity_ratio: ArrayLike, width_ratio: ArrayLike) -> Array:
    """So over arrays of eccentricity and of B/D, which broadcast against each other.

    Agrees with ``curves(span_degrees, width_ratio).sommerfeld_number(eccentricity_ratio)`` to round-off;
    meant for maps and samples in which every point has its own B/D.

    Parameters
    ----------
    span_degrees : int
        360, 180, 150, 120 or 90.
    eccentricity_ratio : array_like
        eps, 0 to 0.99.
    width_ratio : array_like
        B/D, 0.1 to 1.5.

    Returns
    -------
    ndarray
        So, of the broadcast shape.

    Raises
    ------
    InputError
        E006 for a span or a B/D outside the tables.
    ValueError
        For an eccentricity ratio outside 0 ... 0.99.
    """
    nodes = table(span_degrees)
    eccentricities, ratios = np.asarray(eccentricity_ratio, float), np.asarray(width_ratio, float)
    _check_width_ratio(ratios, nodes)
    first, last = float(nodes.eccentricity_ratios[0]), float(nodes.eccentricity_ratios[-1])
    if outside(eccentricities, 0.0, last):
        raise ValueError(f"the eccentricity ratio must be from 0 to {last:g}, where the characteristics are known")
    inside = np.maximum(eccentricities, first)
    log_load = nodes.spline.at_many(0, np.log(inside / (1.0 - inside)), np.log(ratios))
    return np.asarray(np.exp(log_load) * (eccentricities / inside))


ROUND_OFF = 1e-9
"""Relative slack at the ends of B/D: a width computed from a ratio may miss it by round-off."""


def _check_width_ratio(width_ratio: float | Array, nodes: CharacteristicTable) -> None:
    low, high = float(nodes.width_ratios[0]), float(nodes.width_ratios[-1])
    if outside(width_ratio, low * (1.0 - ROUND_OFF), high * (1.0 + ROUND_OFF)):
        given = f"; given was {width_ratio:g}" if not isinstance(width_ratio, np.ndarray) else ""
        raise InputError(
            "E006", f"characteristics are tabulated for a width ratio B/D from {low:g} to {high:g}{given}"
        )
