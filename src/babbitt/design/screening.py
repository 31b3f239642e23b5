"""Rules of thumb that hold for every journal bearing."""

from __future__ import annotations

from babbitt.numerics.scalar_or_array import functions_for

STANDARD_GRAVITY = 9.80665
"""Standard acceleration of gravity in m/s² (CGPM 1901)."""

ROTORDYNAMIC_CHECK_ABOVE = 20.0
"""Surface speed in m/s above which a rotordynamic check is recommended."""


def recommended_relative_clearance(surface_speed: float) -> float:
    """Recommended mean relative clearance ``0.8e-3 U^(1/4)`` for a surface speed in m/s (Vogelpohl).

    >>> round(1e3 * recommended_relative_clearance(45.0), 1)
    2.1
    """
    root: float = functions_for(surface_speed).pow(surface_speed, 0.25)
    return 0.8e-3 * root
