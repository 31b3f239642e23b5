"""Viscosity index by ISO 2909 / ASTM D2270, methods A and B, in all three directions.

The index compares the oil with two reference oils of the same viscosity at 100 °C, one of index 0 with the
viscosity L at 40 °C and one of index 100 with H. L and H are quadratics in ν₁₀₀ by ranges (`REFERENCE_OILS`).
Symbols: Y = ν₁₀₀ and U = ν₄₀ in mm²/s. Public functions take and return m²/s.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from babbitt.core.notices import InputError
from babbitt.numerics.lane_roots import find_roots
from babbitt.numerics.lanes import Lanes, lanes_of
from babbitt.numerics.scalar_or_array import functions_for, larger
from babbitt.properties.lubricants._evaluation import require_finite, require_positive

_MM2_PER_S = 1e-6
_LOWEST_NU100 = 2.0
_LARGEST_NU40 = 1e6
_METHOD_B_SCALE = 0.00715


@dataclass(frozen=True)
class ReferenceOils:
    """L and H over one range of Y: ``L = a Y² + b Y + c``, ``H = d Y² + e Y + f``, all in mm²/s."""

    lower: float
    upper: float
    a: float
    b: float
    c: float
    d: float
    e: float
    f: float

    def index_0(self, y: float) -> float:
        """L, viscosity at 40 °C of the reference oil of index 0."""
        return (self.a * y + self.b) * y + self.c

    def index_100(self, y: float) -> float:
        """H, viscosity at 40 °C of the reference oil of index 100."""
        return (self.d * y + self.e) * y + self.f


REFERENCE_OILS = (
    # ASTM D2270-10, table 2 (coefficients of quadratic equations) and equations (3), (4) above 70 mm²/s.
    ReferenceOils(2.0, 3.8, 1.14673, 1.7576, -0.109, 0.84155, 1.5521, -0.077),
    ReferenceOils(3.8, 4.4, 3.38095, -15.4952, 33.196, 0.78571, 1.7929, -0.183),
    ReferenceOils(4.4, 5.0, 2.5000, -7.2143, 13.812, 0.82143, 1.5679, 0.119),
    ReferenceOils(5.0, 6.4, 0.10100, 16.6350, -45.469, 0.04985, 9.1613, -18.557),
    ReferenceOils(6.4, 7.0, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656),
    ReferenceOils(7.0, 7.7, 0.01191, 21.4750, -72.870, 0.79762, -0.7321, 14.610),
    ReferenceOils(7.7, 9.0, 0.41858, 16.1558, -56.040, 0.05794, 10.5156, -28.240),
    ReferenceOils(9.0, 12.0, 0.88779, 7.5527, -16.600, 0.26665, 6.7015, -10.810),
    ReferenceOils(12.0, 15.0, 0.76720, 10.7972, -38.180, 0.20073, 8.4658, -22.490),
    ReferenceOils(15.0, 18.0, 0.97305, 5.3135, -2.200, 0.28889, 5.9741, -4.930),
    ReferenceOils(18.0, 22.0, 0.97256, 5.2500, -0.980, 0.24504, 7.4160, -16.730),
    ReferenceOils(22.0, 28.0, 0.91413, 7.4759, -21.820, 0.20323, 9.1267, -34.230),
    ReferenceOils(28.0, 40.0, 0.87031, 9.7157, -50.770, 0.18411, 10.1015, -46.750),
    ReferenceOils(40.0, 55.0, 0.84703, 12.6752, -133.310, 0.17029, 11.4866, -80.620),
    ReferenceOils(55.0, 70.0, 0.85921, 11.1009, -83.190, 0.17130, 11.3680, -76.940),
    ReferenceOils(70.0, math.inf, 0.83531, 14.6731, -216.246, 0.16841, 11.8493, -96.947),
)


def viscosity_index(nu40: float, nu100: float) -> float:
    r"""Viscosity index of an oil from its two viscosities.

    Method A where U ≥ H, method B where the oil is better than index 100:

    .. math::

        VI_A = 100\,\frac{L - U}{L - H}, \qquad
        VI_B = 100 + \frac{10^N - 1}{0.00715}, \quad N = \frac{\lg H - \lg U}{\lg Y}

    Parameters
    ----------
    nu40, nu100 : float
        Kinematic viscosity at 40 and at 100 °C in m²/s.

    Returns
    -------
    float
        The index, not rounded (the standards report whole numbers).

    Raises
    ------
    InputError
        E003 for numbers that are not positive, E006 for ``nu100 >= nu40`` or ``nu100`` below 2 mm²/s.

    Notes
    -----
    Source: ISO 2909 / ASTM D2270, procedures A and B. The second example is the one of ASTM D2270, which finds
    156.37 from the rounded H = 28.97 of its table; both are reported as 156.

    Examples
    --------
    >>> round(viscosity_index(73.30e-6, 8.86e-6), 2)
    92.43
    >>> round(viscosity_index(22.83e-6, 5.05e-6), 1)
    156.5
    """
    u = _millimetres("nu40", nu40)
    y = _millimetres("nu100", nu100)
    if y >= u:
        raise InputError(
            "E006",
            f"nu100 = {y:g} mm2/s must be smaller than nu40 = {u:g} mm2/s: an oil thins while it warms. "
            "Are the two values exchanged?",
        )
    oils = _oils_at(y)
    low, high = oils.index_0(y), oils.index_100(y)
    if u >= high:
        return 100.0 * (low - u) / (low - high)
    return 100.0 + (math.pow(high / u, 1.0 / math.log10(y)) - 1.0) / _METHOD_B_SCALE


def nu40_from_viscosity_index(index: float, nu100: float) -> float:
    """Kinematic viscosity at 40 °C from the viscosity index and the viscosity at 100 °C.

    Closed form: methods A and B solved for U.

    Parameters
    ----------
    index : float
        Viscosity index; also below 0 and above 100.
    nu100 : float
        Kinematic viscosity at 100 °C in m²/s.

    Returns
    -------
    float
        In m²/s.

    Raises
    ------
    InputError
        E003 for numbers that are not usable, E006 for `nu100` below 2 mm²/s or an index that no oil of this
        viscosity can have.

    Examples
    --------
    >>> round(nu40_from_viscosity_index(90.0, 8.0e-6) * 1e6, 2)
    63.63
    """
    require_finite("viscosity index", index=index)
    y = _millimetres("nu100", nu100)
    u = _u_of(_oils_at(y), y, index)
    if not u > y:
        raise InputError(
            "E006",
            f"no oil with nu100 = {y:g} mm2/s has the viscosity index {index:g}: nu40 would be {u:.3g} mm2/s.",
        )
    return u * _MM2_PER_S


def nu100_from_viscosity_index(index: float, nu40: float) -> float:
    """Kinematic viscosity at 100 °C from the viscosity index and the viscosity at 40 °C.

    Up to index 100 the viscosity at 40 °C is a quadratic in ν₁₀₀ on each range of `REFERENCE_OILS`, solved in
    closed form; above, the root is found numerically. Where two ranges do not quite meet (by 0.2 % at most,
    since the standard rounds its coefficients) and U falls into the gap, the limit between them is returned.

    Parameters
    ----------
    index : float
        Viscosity index; also below 0 and above 100.
    nu40 : float
        Kinematic viscosity at 40 °C in m²/s.

    Returns
    -------
    float
        In m²/s.

    Raises
    ------
    InputError
        E003 for numbers that are not usable, E006 where the result would be below 2 mm²/s or not below `nu40`.

    Examples
    --------
    >>> round(nu100_from_viscosity_index(90.0, 50.0e-6) * 1e6, 3)
    6.874
    """
    require_finite("viscosity index", index=index)
    u = _millimetres("nu40", nu40)
    y = next(_solutions(index, u), math.nan)
    if not _LOWEST_NU100 <= y < u:
        raise InputError(
            "E006",
            f"no oil with nu40 = {u:g} mm2/s and viscosity index {index:g} lies in the range of ISO 2909 "
            f"(nu100 from {_LOWEST_NU100:g} mm2/s and below nu40). Give nu40 and nu100 instead.",
        )
    return y * _MM2_PER_S


def _u_of(oils: ReferenceOils, y: float, index: float) -> float:
    """Viscosity at 40 °C: methods A and B solved for U."""
    high = oils.index_100(y)
    if index <= 100.0:
        low = oils.index_0(y)
        return low - index * (low - high) / 100.0
    thinner: float = functions_for(y).pow(y, math.log10(1.0 + _METHOD_B_SCALE * (index - 100.0)))
    return high / thinner


def _solutions(index: float, u: float) -> Iterator[float]:
    """Every Y with U(Y) = u, range by range, rising; the range limit where u falls between two ranges."""
    previous_end = _u_of(REFERENCE_OILS[0], _LOWEST_NU100, index) * (1.0 - 1e-12)  # 2 mm²/s itself is allowed
    for oils in REFERENCE_OILS:
        start = _u_of(oils, oils.lower, index)
        if previous_end <= u <= start:
            yield oils.lower
        upper = min(oils.upper, u)  # nu100 is below nu40, so the last range ends there
        if upper <= oils.lower:
            return
        previous_end = _u_of(oils, upper, index)
        if start <= u <= previous_end:
            yield larger(_y_of(oils, upper, index, u), oils.lower)  # round-off may leave the range


def _y_of(oils: ReferenceOils, upper: float, index: float, u: float) -> float:
    """Root of U(Y) = u within one range that brackets it."""
    if index <= 100.0:
        share = index / 100.0
        a = oils.a - share * (oils.a - oils.d)
        b = oils.b - share * (oils.b - oils.e)
        c = oils.c - share * (oils.c - oils.f) - u
        # U rises over the range, so of the two roots it is the one with the positive derivative 2 a Y + b.
        return _root_with_positive_slope(a, b, c)
    if isinstance(u, Lanes):
        return _roots(lambda lanes, y: _u_of(oils, y, index) / u[lanes] - 1.0, oils.lower, upper, u.size)
    from scipy.optimize import brentq

    return float(brentq(lambda y: _u_of(oils, y, index) / u - 1.0, oils.lower, upper, xtol=1e-14, rtol=1e-14))


def _roots(function: Callable[[Any, Any], Any], lower: float, upper: Any, count: int) -> Any:
    """Roots between bounds, one a lane; where they are not found, no number."""
    low, high = (np.array(np.broadcast_to(end, (count,)), float) for end in (lower, upper))
    lanes = np.arange(count)
    return lanes_of(find_roots(function, low, high, function(lanes, low), function(lanes, high)))


def _root_with_positive_slope(a: float, b: float, c: float) -> float:
    """Root of a Y² + b Y + c whose derivative is positive, without cancellation; `a` may be 0 or negative."""
    square = larger(b * b - 4.0 * a * c, 0.0)
    slope: float = functions_for(square).sqrt(square)
    return (slope - b) / (2.0 * a) if b < 0.0 else -2.0 * c / (b + slope)


def _oils_at(y: float) -> ReferenceOils:
    if y < _LOWEST_NU100:
        raise InputError(
            "E006",
            f"ISO 2909 defines the viscosity index from nu100 = {_LOWEST_NU100:g} mm2/s, given {y:g} mm2/s.",
        )
    return next(oils for oils in reversed(REFERENCE_OILS) if y >= oils.lower)


def _millimetres(field: str, nu: float) -> float:
    """Kinematic viscosity in mm²/s of one in m²/s; refuses what cannot have been meant in m²/s."""
    require_positive("viscosity index", **{field: nu})
    if nu / _MM2_PER_S > _LARGEST_NU40:
        raise InputError("E003", f"{field} is in m2/s (46 mm2/s is 46e-6), given {nu:g}, which is no oil.")
    return nu / _MM2_PER_S
