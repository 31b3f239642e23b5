"""The bearing of the published long film, and what its source leaves open."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.journal.infinitely_long_bearing.model import BushRing, Discretisation, HeatExchange, LongFilm
from babbitt.kinds.journal.infinitely_long_bearing.solve import film_at_eccentricity
from babbitt.kinds.journal.infinitely_long_bearing.state import LongFilmState
from babbitt.properties.lubricants import ConstantProperty, LinearProperty, Lubricant, Walther
from babbitt.validation.reference_data import reference_data

ATMOSPHERE = 101325.0

FITTED_CLEARANCE = {
    Discretisation.PUBLISHED_MEAN: 56.33e-6,
    Discretisation.PUBLISHED_LITERAL: 56.76e-6,
    Discretisation.CONSISTENT: 55.5e-6,
}
"""m; not published. Only viscosity times (R/c)² can be found from the table, and the oil is not published."""

WALL = 5e-3
"""m; wall of the bush, not published."""


def oil() -> Lubricant:
    """Thin synthetic gear oil; viscosity of a data sheet of its class, density and heat capacity assumed."""
    law = Walther.through((50.0 + ZERO_CELSIUS, 10.5e-6), (100.0 + ZERO_CELSIUS, 3.0e-6), additive=0.6)
    return Lubricant(
        name="IPM-10",
        viscosity_law=law,
        density_law=LinearProperty(820.0, 20.0 + ZERO_CELSIUS, -0.738),
        heat_capacity_law=LinearProperty(4186.8 * 0.433, 15.0 + ZERO_CELSIUS, 4186.8 * 0.0011),
        conductivity_law=ConstantProperty(0.135),
        temperature_range=(20.0 + ZERO_CELSIUS, 150.0 + ZERO_CELSIUS),
        source="data-sheet level of the oil class",
    )


def film(
    discretisation: Discretisation,
    speed: float,
    clearance: float | None = None,
    exchange: HeatExchange | None = None,
    cells: int = 360,
) -> LongFilm:
    """The published bearing at a speed in rpm; the clearance in m is the fitted one if not given."""
    data = reference_data("long_film")
    return LongFilm(
        diameter=1e-3 * data["diameter_mm"],
        width=1e-3 * data["width_mm"],
        clearance=clearance or FITTED_CLEARANCE[discretisation],
        angular_speed=speed * math.pi / 30.0,
        lubricant=oil(),
        inlet_temperature=data["inlet_temperature_C"] + ZERO_CELSIUS,
        exchange=exchange or HeatExchange(),
        discretisation=discretisation,
        cells=cells,
    )


def relative_load(state: LongFilmState) -> float:
    """Load along the eccentricity over D L p_atm."""
    return state.load_along / (state.film.diameter * state.film.width * ATMOSPHERE)


@lru_cache
def solved(
    discretisation: Discretisation, speed: float, eccentricity_ratio: float, clearance: float | None = None
) -> LongFilmState:
    """The film at an eccentricity ratio; speed in rpm."""
    return film_at_eccentricity(film(discretisation, speed, clearance), eccentricity_ratio)


@lru_cache
def conducting_bush_ratio(discretisation: Discretisation, speed: float, eccentricity_ratio: float) -> float:
    """Load along the eccentricity with a bush of 100 W/(m K) that gives off no heat, over that without."""
    base = film(discretisation, speed)
    ring = BushRing(base.diameter + 2.0 * WALL, 100.0)
    bush = film_at_eccentricity(replace(base, exchange=HeatExchange(bush=ring)), eccentricity_ratio)
    return bush.load_along / solved(discretisation, speed, eccentricity_ratio).load_along
