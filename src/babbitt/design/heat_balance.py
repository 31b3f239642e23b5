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

STEP = 2.0
"""Step in K of the search from the coolest possible film upward; two equilibria may lie only kelvins apart."""

TEMPERATURE_TOLERANCE = 1e-12
"""In K; small, so that even a bearing that warms by millikelvins closes its heat balance to 1e-8."""

MOST_STEPS = 200
"""Bound on the steps of the root finder."""


class NoFilmError(Exception):
    """There is no film at this temperature.

    Attributes
    ----------
    outcome : Outcome
        Why: the clearance has closed, the load is too large, the lubricant's laws do not reach there, or the
        search for the film ended without an answer.
    capacity : float or None
        Largest load in N that the method knows a film for, if the load is too large.
    """

    def __init__(self, outcome: Outcome, capacity: float | None = None) -> None:
        super().__init__(outcome.value)
        self.outcome = outcome
        self.capacity = capacity


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
    """How the heat balance ended: the film there (the last one reached if unsolved) and the work it took.

    `capacity` is the largest load in N at the temperature where the film gave way, for an overloaded bearing.
    """

    outcome: Outcome
    film: FilmT | None
    evaluations: int
    last_temperature: float
    capacity: float | None = None


def outlet_temperature(effective_temperature: float, case: Designed) -> float | None:
    """Temperature in K of the oil that leaves: ``2 T_eff - T_en``; None where no oil is supplied.

    A film that gives its heat to a cool housing cannot leave colder than the surroundings: there the mean rule
    ends, and the oil leaves at the coolest temperature around.
    """
    if case.oil_supply is None:
        return None
    return max(2.0 * effective_temperature - case.oil_supply.temperature, coolest_temperature(case))


def heat_paths(film: WarmFilm, case: Designed) -> tuple[float, float]:
    """Heat to the oil and to the surroundings in W, at the temperature of the film."""
    to_oil = to_surroundings = 0.0
    leaving = outlet_temperature(film.temperature, case)
    if case.oil_supply is not None and leaving is not None:
        to_oil = film.volumetric_heat_capacity * film.total_flow * (leaving - case.oil_supply.temperature)
    if case.cooling is not None:
        cooling = case.cooling
        conductance = cooling.heat_transfer_coefficient * cooling.surface
        to_surroundings = conductance * (film.temperature - cooling.ambient_temperature)
    return to_oil, to_surroundings


def coolest_temperature(case: Designed) -> float:
    """Temperature in K below which the film cannot settle: the coolest of inlet and ambient."""
    sinks = []
    if case.oil_supply is not None:
        sinks.append(case.oil_supply.temperature)
    if case.cooling is not None:
        sinks.append(case.cooling.ambient_temperature)
    return min(sinks)


def find_equilibrium(case: Designed, film_at: Callable[[float], FilmT]) -> Equilibrium[FilmT]:
    """Find the coolest temperature at which the heat balance closes; always ends with a status.

    A cold film makes more heat than it gives away. The temperature is raised in small steps until the surplus
    turns negative, or until three steps enclose a least surplus that is negative in between; Brent's method closes
    in on this coolest equilibrium, the stable one. Where the film gives way on the way, the step to the last
    temperature with a film is looked at as well.

    Parameters
    ----------
    case : Designed
        Supply and cooling.
    film_at : callable
        Film at a temperature in K; may raise `NoFilmError`.
    """
    search = _Search(case, film_at)
    low = coolest_temperature(case)
    while True:  # a law may not reach the coolest temperature; a warm film needs it only from where it is defined
        try:
            surplus = search.surplus(low)
            break
        except NoFilmError as failure:
            if failure.outcome is not Outcome.NO_LUBRICANT_DATA or low >= CEILING:
                return search.ended(failure, low)
            low += STEP
    if surplus <= 0.0 and low > coolest_temperature(case):
        return search.unsolved(Outcome.NO_LUBRICANT_DATA, low)
    before = (low, surplus)
    while surplus > 0.0:
        high = min(low + STEP, CEILING)
        try:
            following = search.surplus(high)
        except NoFilmError as failure:
            high = search.last_with_film(low, high)
            following = search.surplus(high)
            if following > 0.0:
                return search.ended(failure, high)
        if following > 0.0 and before[1] > surplus < following:
            dip = search.least(before[0], high)
            if search.surplus(dip) <= 0.0:
                return search.closed_in(before[0], dip)
        if following > 0.0 and high >= CEILING:
            return search.unsolved(Outcome.THERMAL_RUNAWAY, high)
        before, low, surplus = (low, surplus), high, following
    return search.closed_in(before[0], low)


def at_prescribed_temperature(temperature: float, film_at: Callable[[float], FilmT]) -> Equilibrium[FilmT]:
    """Film at a temperature in K that is given instead of sought."""
    try:
        return Equilibrium(Outcome.CONVERGED, film_at(temperature), 1, temperature)
    except NoFilmError as failure:
        return Equilibrium(failure.outcome, None, 1, temperature, failure.capacity)


class _Search(Generic[FilmT]):
    """The surplus of friction heat over temperature, and the ways a search for its root can end."""

    def __init__(self, case: Designed, film_at: Callable[[float], FilmT]) -> None:
        self._case = case
        self._film_at = film_at
        self._evaluations = 0

    def surplus(self, temperature: float) -> float:
        """Friction power less the heat carried away, W."""
        self._evaluations += 1
        film = self._film_at(temperature)
        return film.friction_power - sum(heat_paths(film, self._case))

    def least(self, low: float, high: float) -> float:
        """Temperature of the least surplus between two temperatures."""
        from scipy.optimize import minimize_scalar

        found = minimize_scalar(self.surplus, bounds=(low, high), method="bounded", options={"xatol": 1e-6})
        return float(found.x)

    def last_with_film(self, good: float, bad: float) -> float:
        """Highest temperature with a film between one that has and one that has not, to 1e-9 K by bisection."""
        while bad - good > 1e-9:
            middle = (good + bad) / 2.0
            try:
                self.surplus(middle)
            except NoFilmError:
                bad = middle
            else:
                good = middle
        return good

    def closed_in(self, low: float, high: float) -> Equilibrium[FilmT]:
        """Root of the surplus between two temperatures that enclose it."""
        if low == high:  # the coolest film already gives away all its heat
            return Equilibrium(Outcome.CONVERGED, self._film_at(low), self._evaluations, low)
        try:
            root = find_root(self.surplus, low, high, TEMPERATURE_TOLERANCE, most_steps=MOST_STEPS)
        except NoFilmError as failure:
            return self.ended(failure, low)
        outcome = Outcome.CONVERGED if root.converged else Outcome.NOT_CONVERGED
        return Equilibrium(outcome, self._film_at(root.value), self._evaluations, root.value)

    def unsolved(self, outcome: Outcome, temperature: float) -> Equilibrium[FilmT]:
        """End without an equilibrium at a temperature that has a film."""
        return Equilibrium(outcome, self._film_at(temperature), self._evaluations, temperature)

    def ended(self, failure: NoFilmError, temperature: float) -> Equilibrium[FilmT]:
        """End where the film gave way."""
        try:
            film: FilmT | None = self._film_at(temperature)
        except NoFilmError:
            film = None
        return Equilibrium(failure.outcome, film, self._evaluations, temperature, failure.capacity)
