"""Where the friction heat goes, and the temperature at which what is made equals what is carried away.

One balance covers oil cooling, housing cooling and both:
``P_f = k_A A (T_eff - T_amb) + ρ c Q (T_ex - T_en)`` with ``T_eff = (T_en + T_ex)/2`` for the oil and
``T_eff = T_B`` for the housing.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from babbitt.design.conditions import Designed
from babbitt.design.roots import find_root
from babbitt.results import Outcome

CEILING = 573.15
"""Temperature in K (300 °C) beyond which no lubricating oil is followed; an equilibrium above is a runaway."""

FIRST_STEP = 20.0
"""First step in K from the coolest possible film (ISO 7902 starts 20 K above the inlet)."""

TEMPERATURE_TOLERANCE = 1e-12
"""In K; small, so that even a bearing that warms by millikelvins closes its heat balance to 1e-8."""

MOST_EVALUATIONS = 200
"""Bound on the evaluations of the film in one heat balance."""


class NoClearanceError(Exception):
    """The bearing grips the journal at this temperature."""


class FilmCollapseError(Exception):
    """The load asks for more than any film carries."""


class FilmNotFoundError(Exception):
    """The search for the film ended without an answer."""


UNSOLVED = {
    FilmCollapseError: Outcome.OVERLOADED,
    NoClearanceError: Outcome.NO_CLEARANCE,
    FilmNotFoundError: Outcome.NOT_CONVERGED,
}
"""What each failure of a film means for the bearing."""


class WarmFilm(Protocol):
    """What the heat balance needs to know of a film: temperature in K, J/(m3 K), m3/s, W."""

    @property
    def temperature(self) -> float: ...  # noqa: D102
    @property
    def volumetric_heat_capacity(self) -> float: ...  # noqa: D102
    @property
    def total_flow(self) -> float: ...  # noqa: D102
    @property
    def friction_power(self) -> float: ...  # noqa: D102


FilmT = TypeVar("FilmT", bound=WarmFilm)


@dataclass(frozen=True)
class Equilibrium(Generic[FilmT]):
    """How the heat balance ended: the film there (the last one reached if unsolved) and the work it took."""

    outcome: Outcome
    film: FilmT | None
    evaluations: int
    last_temperature: float


def heat_paths(film: WarmFilm, case: Designed) -> tuple[float, float]:
    """Heat to the oil and to the surroundings in W, at the temperature of the film."""
    to_oil = to_surroundings = 0.0
    if case.oil_supply is not None:
        rise = 2.0 * (film.temperature - case.oil_supply.temperature)
        to_oil = film.volumetric_heat_capacity * film.total_flow * rise
    if case.cooling is not None:
        cooling = case.cooling
        conductance = cooling.heat_transfer_coefficient * cooling.surface
        to_surroundings = conductance * (film.temperature - cooling.ambient_temperature)
    return to_oil, to_surroundings


def balanced_temperature(film: WarmFilm, case: Designed) -> float:
    """Temperature in K at which heat paths as strong as now would carry the friction power of now."""
    strength = pull = 0.0
    if case.oil_supply is not None:
        oil = 2.0 * film.volumetric_heat_capacity * film.total_flow
        strength, pull = strength + oil, pull + oil * case.oil_supply.temperature
    if case.cooling is not None:
        housing = case.cooling.heat_transfer_coefficient * case.cooling.surface
        strength, pull = strength + housing, pull + housing * case.cooling.ambient_temperature
    return (film.friction_power + pull) / strength


def coolest_temperature(case: Designed) -> float:
    """Temperature in K below which the film cannot settle: the coolest of inlet and ambient."""
    sinks = []
    if case.oil_supply is not None:
        sinks.append(case.oil_supply.temperature)
    if case.cooling is not None:
        sinks.append(case.cooling.ambient_temperature)
    return min(sinks)


def find_equilibrium(case: Designed, film_at: Callable[[float], FilmT]) -> Equilibrium[FilmT]:
    """Find the lowest temperature at which the heat balance closes; always ends with a status.

    The balanced temperature less the assumed one is positive in a cold film. The assumed temperature is raised
    in growing steps until it turns negative, which encloses the coolest and therefore stable equilibrium; Brent's
    method closes in. Where the film collapses on the way, the last temperature with a film is sought by bisection.

    Parameters
    ----------
    case : Designed
        Supply and cooling.
    film_at : callable
        Film at a temperature in K; may raise `FilmCollapseError`, `NoClearanceError` or `FilmNotFoundError`.
    """
    evaluations = 0

    def excess(temperature: float) -> float:
        nonlocal evaluations
        evaluations += 1
        return balanced_temperature(film_at(temperature), case) - temperature

    low, step = coolest_temperature(case), FIRST_STEP
    try:
        excess(low)
    except tuple(UNSOLVED) as failure:
        return Equilibrium(UNSOLVED[type(failure)], None, evaluations, low)
    while True:
        high = min(low + step, CEILING)
        try:
            enclosed = excess(high) <= 0.0
        except tuple(UNSOLVED) as failure:
            last = _last_film(excess, low, high)
            if excess(last) > 0.0:
                return Equilibrium(UNSOLVED[type(failure)], film_at(last), evaluations, last)
            high, enclosed = last, True
        if enclosed:
            break
        if high >= CEILING:
            return Equilibrium(Outcome.THERMAL_RUNAWAY, film_at(high), evaluations, high)
        low, step = high, 2.0 * step
    try:
        return _closed(excess, film_at, low, high, lambda: evaluations)
    except FilmNotFoundError:
        return Equilibrium(Outcome.NOT_CONVERGED, None, evaluations, low)


def _closed(
    excess: Callable[[float], float],
    film_at: Callable[[float], FilmT],
    low: float,
    high: float,
    count: Callable[[], int],
) -> Equilibrium[FilmT]:
    """Close in on the temperature between two."""
    root = find_root(excess, low, high, TEMPERATURE_TOLERANCE, most_steps=MOST_EVALUATIONS)
    outcome = Outcome.CONVERGED if root.converged else Outcome.NOT_CONVERGED
    return Equilibrium(outcome, film_at(root.value), count(), root.value)


def at_prescribed_temperature(temperature: float, film_at: Callable[[float], FilmT]) -> Equilibrium[FilmT]:
    """Film at a temperature in K that is given instead of sought."""
    try:
        return Equilibrium(Outcome.CONVERGED, film_at(temperature), 1, temperature)
    except tuple(UNSOLVED) as failure:
        return Equilibrium(UNSOLVED[type(failure)], None, 1, temperature)


def _last_film(excess: Callable[[float], float], good: float, bad: float) -> float:
    """Highest temperature with a film between one that has and one that has not, to 1e-9 K by bisection."""
    while bad - good > 1e-9:
        middle = (good + bad) / 2.0
        if middle in (good, bad):
            break
        try:
            excess(middle)
        except tuple(UNSOLVED):
            bad = middle
        else:
            good = middle
    return good
