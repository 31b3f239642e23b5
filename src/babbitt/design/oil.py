"""The oil of a film at one temperature, or why there is none."""

from __future__ import annotations

from babbitt.design.heat_balance import NoFilmError
from babbitt.lubricants import Lubricant
from babbitt.notices import InputError
from babbitt.results import Outcome


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
