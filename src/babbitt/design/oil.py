"""The oil of a film at one temperature, or why there is none."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.design.heat_balance import CEILING, NoFilmError
from babbitt.numerics.scalar_or_array import clipped
from babbitt.properties.lubricants import Lubricant

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

__all__ = ["bounded_viscosity", "highest_usable", "properties_at", "usable_viscosity"]

COLDEST = 243.15
"""Temperature in K below which the oil is taken as at it: a search passes there, no answer lies there."""


def properties_at(oil: Lubricant, temperature: float) -> tuple[float, float, float]:
    """Density in kg/m³, dynamic viscosity in Pa s and volumetric heat capacity in J/(m³ K) at a temperature in K.

    Raises
    ------
    NoFilmError
        When a law of the lubricant has no usable value there.
    """
    try:
        density = oil.density(temperature)
        found = density, oil.kinematic_viscosity(temperature) * density, oil.volumetric_heat_capacity(temperature)
    except InputError:
        raise NoFilmError(Outcome.NO_LUBRICANT_DATA) from None
    if min(found) <= 0.0:
        raise NoFilmError(Outcome.NO_LUBRICANT_DATA)
    return found


def bounded_viscosity(oil: Lubricant) -> Callable[[Array], Array]:
    """Dynamic viscosity over temperature, held at its ends below -30 °C and above the last usable temperature."""
    import numpy as np

    highest = highest_usable(oil)

    def viscosity(temperature: Array) -> Array:
        return np.asarray(oil.dynamic_viscosity(np.clip(temperature, COLDEST, highest)))

    return viscosity


def usable_viscosity(oil: Lubricant) -> Callable[[float], float]:
    """`bounded_viscosity` of single temperatures."""
    highest = highest_usable(oil)
    return lambda temperature: oil.dynamic_viscosity(clipped(temperature, COLDEST, highest))


def highest_usable(oil: Lubricant) -> float:
    """Highest temperature in K, up to 300 °C, at which the laws of an oil have usable values."""
    high = CEILING
    while high > COLDEST:
        try:
            properties_at(oil, high)
        except NoFilmError:
            high -= 1.0
        else:
            return high
    raise NoFilmError(Outcome.NO_LUBRICANT_DATA)
