"""How well the hottest place and the film thickness of a bearing are known."""

from __future__ import annotations

from typing import Any

from babbitt.numerics.scalar_or_array import functions_for

__all__ = ["UNCERTAIN", "UNCERTAIN_FILM", "UNCERTAIN_SHARE", "shear_heat", "uncertain_temperature"]

UNCERTAIN, UNCERTAIN_SHARE = 6.0, 0.2
"""By how much the hottest place may be hotter than computed: K, or a share of its rise above the fresh oil where
that is more. The bearing of Fillon, Bligoud and Frene (1992) lies 0.7 K below the measurement with a rise of 9 K
and 5.2 K with one of 31 K (`babbitt validate fillon_1992`): misses grow with the rise, up to a sixth of it. A
fifth, and no less than 6 K, for nothing tells that small rises are known better. Assumption: of one bearing, and
for thrust pads and films of plain bearings of that one, too."""

UNCERTAIN_FILM = 0.02
"""Share of the least film thickness by which the grid of ``accuracy: engineering`` may miss it.

With temperatures of their own, loaded films and those beside grooves around the bore are off by 1 to 2 %
(docs/theory/thermal_film.md)."""


def uncertain_temperature(hottest: float, supplied: float) -> float:
    """How much hotter than computed the hottest place of a bearing may be, K.

    Parameters
    ----------
    hottest, supplied : float
        Of the place as computed, and of the fresh oil, K.

    >>> uncertain_temperature(330.0, 320.0), uncertain_temperature(370.0, 320.0)
    (6.0, 10.0)
    """
    return max(UNCERTAIN, UNCERTAIN_SHARE * (hottest - supplied))


def shear_heat(speed: Any, viscosity: Any) -> Any:
    """U sqrt(η) in m/s and the root of Pa s, the root of the heat of shear over conduction across the gap, η U²/λ.

    >>> round(shear_heat(-50.0, 0.01), 3)
    5.0
    """
    return abs(speed) * functions_for(viscosity).sqrt(viscosity)
