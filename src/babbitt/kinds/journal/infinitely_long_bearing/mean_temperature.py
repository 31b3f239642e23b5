"""The method of one mean film temperature, to which the long film is compared.

The film has the viscosity of ``T = (T_in + T_out)/2``, where ``T_out`` follows from its own heat balance: all
friction heat leaves with the oil.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from babbitt.design.heat_balance import FINE_SEARCH, NoFilmError, coolest_equilibrium
from babbitt.design.oil import properties_at
from babbitt.kinds.journal.infinitely_long_bearing.model import ExchangeZone, HeatExchange, LongFilm, NusseltLaw
from babbitt.kinds.journal.infinitely_long_bearing.pressure import Gap, divergence_form
from babbitt.kinds.journal.infinitely_long_bearing.walls import sectors_of


@dataclass(frozen=True)
class MeanTemperatureFilm:
    """Film of one temperature: temperature and outlet temperature in K, loads in N, power in W."""

    temperature: float
    outlet_temperature: float
    load_along: float
    load_across: float
    friction_power: float

    @property
    def load(self) -> float:
        """Resultant in N."""
        return float(np.hypot(self.load_along, self.load_across))


def mean_temperature_film(
    film: LongFilm, eccentricity_ratio: float, friction: ExchangeZone = ExchangeZone.FILM
) -> MeanTemperatureFilm:
    """The film of one mean temperature at an eccentricity ratio.

    Parameters
    ----------
    film : LongFilm
        Its discretisation does not matter: without change of viscosity all are the same.
    eccentricity_ratio : float
    friction : ExchangeZone
        Where the film rubs; the published comparison does not say.

    Raises
    ------
    NoFilmError
        When the balance does not close up to 300 °C, or the laws of the lubricant end before.
    """
    adiabatic = replace(film, exchange=HeatExchange(NusseltLaw(0.0)), exchange_zone=friction)
    gap = Gap.of(eccentricity_ratio, film.cells, film.start)
    pressure = divergence_form(gap, np.ones(film.cells + 1))
    inlet = np.full(film.cells + 1, film.inlet_temperature)
    unit = sectors_of(adiabatic, gap, pressure, np.ones(film.cells + 1), inlet)
    power = float(unit.source.sum())
    flow = film.clearance * film.surface_speed * film.width * float(pressure.flow[0])

    def surplus(temperature: float, oil: tuple[float, float, float]) -> float:
        _, viscosity, heat_capacity = oil
        return viscosity * power - 2.0 * heat_capacity * flow * (temperature - film.inlet_temperature)

    oil_at = partial(properties_at, film.lubricant)
    found = coolest_equilibrium(oil_at, surplus, film.inlet_temperature, FINE_SEARCH)
    if found.film is None or not found.outcome.solved:
        raise found.failure or NoFilmError(found.outcome)
    temperature, (_, viscosity, _) = found.last_temperature, found.film
    scale = viscosity * film.surface_speed * film.radius**2 * film.width / film.clearance**2
    along, across = (scale * one for one in pressure.load(gap.step))
    leaving = 2.0 * temperature - film.inlet_temperature
    return MeanTemperatureFilm(temperature, leaving, along, across, viscosity * power)
