"""Supply pressure beside what the film carries: what ISO 7902 and films of one temperature leave out."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.core.notices import Notice

__all__ = ["SHARE_OF_LOAD", "pressed_area", "throttling", "warnings_about_pressing"]

SHARE_OF_LOAD = 0.1
"""Force of a pocket over the load from which W192 warns (assumption).

Films of one temperature with a pocket of 60 deg opposite the load are there 5 % thinner than without pressure."""

REPORTED_HEATING = 1.0
"""K by which throttling warms the oil, from which it is reported."""


def pressed_area(diameter: float, width: float, extent: float) -> float:
    """Projected area in m² over which a pocket of that width (m) and extent (rad) presses on the journal.

    >>> round(pressed_area(0.12, 0.05, math.radians(20.0)) * 1e4, 3)  # cm²
    10.419
    """
    return width * diameter * math.sin(0.5 * extent)


def throttling(code: str, pressure: float, heat_capacity: float) -> tuple[Notice, ...]:
    """What throttling warms the oil by, p/(ρ c), where it is notable; Pa, J/(m³ K)."""
    heating = pressure / heat_capacity
    return (Notice(code, "warming", {"rise": heating}),) if heating > REPORTED_HEATING else ()


def warnings_about_pressing(share: float, pressure: float, heat_capacity: float) -> Iterator[Notice]:
    """What the feeds of a film of one temperature do that its heat balance does not know.

    Parameters
    ----------
    share : float
        What their pressure adds to the load, over the load.
    pressure : float
        The highest of them, Pa.
    heat_capacity : float
        Of the oil, J/(m³ K).
    """
    warming = throttling("W192", pressure, heat_capacity)
    if share > SHARE_OF_LOAD:
        yield Notice("W192", "pressed_film", {"pressure": pressure, "share": share, "warming": warming})
    elif warming:
        yield Notice("W192", "throttled", {"pressure": pressure, "warming": warming})
