"""Heat made in the sectors of the film and heat taken by their walls."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.design.heat_balance import NoFilmError
from babbitt.kinds.journal.infinitely_long_bearing.model import Discretisation, ExchangeZone, LongFilm
from babbitt.kinds.journal.infinitely_long_bearing.pressure import Gap, Pressure

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Sectors:
    """What the heat balance needs of every sector, SI; arrays of shape (n,).

    Attributes
    ----------
    capacity_flow : ndarray
        ρ c_p Q in W/K.
    source : ndarray
        Friction less flow work, W.
    friction : ndarray
        Power of the journal, W.
    to_journal, to_bush : ndarray
        Conductance in W/K from the film to the journal, and to the middle of the bush wall.
    peclet : ndarray
    """

    capacity_flow: Array
    source: Array
    friction: Array
    to_journal: Array
    to_bush: Array
    peclet: Array


def viscosity_at(film: LongFilm, temperature: Array) -> Array:
    """Dynamic viscosity in Pa s at temperatures in K.

    Raises
    ------
    NoFilmError
        When a law of the lubricant has no usable value there.
    """
    return _usable(film.lubricant.dynamic_viscosity, temperature)


def sectors_of(film: LongFilm, gap: Gap, pressure: Pressure, viscosity: Array, temperature: Array) -> Sectors:
    """Heat source and conductances of every sector, with the properties in its middle.

    Parameters
    ----------
    film : LongFilm
    gap, pressure
        Without dimension, as of `babbitt.kinds.journal.infinitely_long_bearing.pressure`.
    viscosity, temperature : ndarray
        At the nodes, Pa s and K.

    Raises
    ------
    NoFilmError
        When a law of the lubricant has no usable value.
    """
    oil, u, radius, c = film.lubricant, film.surface_speed, film.radius, film.clearance
    middle = 0.5 * (temperature[1:] + temperature[:-1])
    eta = 0.5 * (viscosity[1:] + viscosity[:-1])
    h, area = c * gap.sectors, radius * gap.step * film.width
    rise = (pressure.nodes[1:] - pressure.nodes[:-1]) * (u * radius / c**2)
    flow = flow_of(film, pressure)
    share = _share(film, gap, pressure)
    heat_capacity = _usable(oil.volumetric_heat_capacity, middle)
    conductivity = _usable(oil.conductivity, middle)
    peclet = u * h * heat_capacity / conductivity
    alpha = film.exchange.nusselt(peclet, h / film.diameter) * conductivity / h
    # the whole rise of pressure lies in the full part of the sector in which the film breaks
    friction = share * (eta * u / h) * (area * u) + h / (2.0 * radius * gap.step) * rise * (area * u)
    return Sectors(
        capacity_flow=heat_capacity * flow,
        source=friction - flow * rise,
        friction=friction,
        to_journal=share * alpha * area,
        to_bush=share * area * _through_bush(film, alpha),
        peclet=peclet,
    )


def flow_of(film: LongFilm, pressure: Pressure) -> Array:
    """Circumferential flow in m³/s that carries the heat of every sector, as the discretisation has it."""
    scale = film.clearance * film.surface_speed * film.width
    if film.discretisation is Discretisation.PUBLISHED_MEAN:
        mean = float(pressure.flow @ pressure.full) / float(pressure.full.sum())
        return np.full(pressure.flow.size, scale * mean)
    return scale * pressure.flow


def flow_spread(pressure: Pressure) -> float:
    """Inconsistency of the flow over the full film, ``(max Q - min Q)/mean Q``."""
    full = pressure.flow[pressure.full >= 1.0]
    return float((full.max() - full.min()) / full.mean())


def _share(film: LongFilm, gap: Gap, pressure: Pressure) -> Array:
    """Share of every sector that rubs and exchanges heat."""
    if film.zone is ExchangeZone.ALL_AROUND:
        return np.ones(gap.sectors.size)
    if film.zone is ExchangeZone.FILM:
        return pressure.full
    at_rupture = 1.0 + gap.eccentricity_ratio * np.cos(pressure.rupture_angle)
    return np.asarray(pressure.full + (1.0 - pressure.full) * np.minimum(at_rupture / gap.sectors, 1.0))


def _through_bush(film: LongFilm, alpha: Array) -> Array:
    """Coefficient k1 in W/(m² K), referred to the bore, from the film to the middle of the bush wall."""
    bush = film.exchange.bush
    if bush is None or bush.conductivity == 0.0:
        return np.zeros(alpha.size)
    middle = 0.5 * (film.diameter + bush.outer_diameter)
    resistance = film.diameter / (2.0 * bush.conductivity) * np.log(middle / film.diameter)
    return np.asarray(alpha / (1.0 + alpha * resistance))


def _usable(law: object, temperature: Array) -> Array:
    try:
        found = np.asarray(law(temperature))  # type: ignore[operator]
    except InputError:
        raise NoFilmError(Outcome.NO_LUBRICANT_DATA) from None
    if not found.min() > 0.0:
        raise NoFilmError(Outcome.NO_LUBRICANT_DATA)
    return found
