"""The lumped heat balance: the temperature of a film at which the heat made in it equals the heat carried away.

`coolest_equilibrium` finds it for every kind whose film has one temperature (journals by ISO 7902 and as
isothermal films, hydrostatics, pads of thrust bearings, the infinitely long film of one mean temperature), each
with its own surplus of heat; it always ends with a status. A footstep closes its balance by Lambert's W, and the
two segments of a grooved long film warm each other: theirs are no search for one temperature.

For journals one balance covers oil cooling, housing cooling and both:
``P_f = k_A A (T_eff - T_amb) + ρ c Q (T_ex - T_en)`` with ``T_eff = (T_en + T_ex)/2`` for the oil and
``T_eff = T_B`` for the housing.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from babbitt.core.picklable_error import PicklableError
from babbitt.core.result import Outcome
from babbitt.design.conditions import CheckedProblem
from babbitt.numerics.roots import find_root
from babbitt.numerics.scalar_or_array import larger

CEILING = 573.15
"""Temperature in K (300 °C) beyond which no lubricating oil is followed; an equilibrium above is a runaway."""


@dataclass(frozen=True)
class SearchPolicy:
    """How closely the coolest equilibrium is sought, and at what cost.

    Attributes
    ----------
    step : float
        First step in K from the coolest possible film upward.
    growth, largest_step : float
        Each step is `growth` times the one before, up to `largest_step` in K.
    fine_step : float
        Step in K with which a step is walked again in which the surplus changed its sign or the film gave way.
    edge, dip : float
        In K: how closely the last temperature with a film and the least surplus between three steps are found.
    sure : float
        The last temperature with a film is sought no closer where it has so many times the surplus that was lost
        in the halving before: the balance does not close there. A surplus that ends in a fold, as the root of the
        distance to it, loses 2.4 times that at most.
    tolerance : float
        Of the temperature at which the balance closes, K.
    most_evaluations : int
        Films after which the search gives up as not converged.
    """

    step: float
    growth: float
    largest_step: float
    fine_step: float
    edge: float
    dip: float
    sure: float
    tolerance: float
    most_evaluations: int


FINE_SEARCH = SearchPolicy(2.0, 1.0, 2.0, 2.0, 1e-9, 1e-6, math.inf, 1e-12, 2000)
"""For films that cost microseconds: two equilibria may lie only kelvins apart, and even a bearing that warms by
millikelvins closes its heat balance to 1e-8."""

COARSE_SEARCH = SearchPolicy(2.0, 1.6, 16.0, 4.0, 0.05, 0.1, 10.0, 1e-9, 60)
"""For films that cost milliseconds, and more where they collapse: large steps first, small where they count."""

BOLD = SearchPolicy(10.0, 3.0, math.inf, math.inf, 0.05, 0.1, math.inf, 1e-7, 200)
"""For films whose surplus falls all the way, so that long steps pass nothing: pads and pressed oil."""

MOST_STEPS = 200
"""Bound on the steps of the root finder."""


class NoFilmError(PicklableError):
    """There is no film at this temperature.

    Attributes
    ----------
    outcome : Outcome
        Why: the clearance has closed, the load is too large, the lubricant's laws do not reach there, or the
        search for the film ended without an answer.
    capacity : float or None
        Largest load in N that the method knows a film for, if the load is too large.
    least_flow : float or None
        Least oil flow in m3/s with which a film was found, if the flow given is too small for the load.
    """

    def __init__(self, outcome: Outcome, capacity: float | None = None, least_flow: float | None = None) -> None:
        super().__init__(outcome.value)
        self.outcome = outcome
        self.capacity = capacity
        self.least_flow = least_flow


class FilmAtTemperature(Protocol):
    """What the heat balance needs to know of a film: temperature in K, J/(m3 K), m3/s, W."""

    @property
    def temperature(self) -> float: ...  # noqa: D102
    @property
    def volumetric_heat_capacity(self) -> float: ...  # noqa: D102
    @property
    def total_flow(self) -> float: ...  # noqa: D102
    @property
    def friction_power(self) -> float: ...  # noqa: D102


FilmT = TypeVar("FilmT")
FilmAtTemperatureT = TypeVar("FilmAtTemperatureT", bound=FilmAtTemperature)


@dataclass(frozen=True)
class Equilibrium(Generic[FilmT]):
    """How the heat balance ended: the film there (the last one reached if unsolved) and the work it took.

    `failure` tells why the film gave way, where it did.
    """

    outcome: Outcome
    film: FilmT | None
    evaluations: int
    last_temperature: float
    failure: NoFilmError | None = None


def outlet_temperature(effective_temperature: float, case: CheckedProblem) -> float | None:
    """Temperature in K of the oil that leaves: ``2 T_eff - T_en``; None where no oil is supplied.

    A film that gives its heat to a cool housing cannot leave colder than the surroundings: there the mean rule
    ends, and the oil leaves at the coolest temperature around.
    """
    if case.oil_supply is None:
        return None
    return larger(2.0 * effective_temperature - case.oil_supply.temperature, coolest_temperature(case))


def heat_paths(film: FilmAtTemperature, case: CheckedProblem) -> tuple[float, float]:
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


def heat_surplus(film: FilmAtTemperature, case: CheckedProblem) -> float:
    """Heat in W that a film makes and that nothing carries away."""
    return film.friction_power - sum(heat_paths(film, case))


def coolest_temperature(case: CheckedProblem) -> float:
    """Temperature in K below which the film cannot find its equilibrium: the coolest of inlet and ambient."""
    supply, cooling = case.oil_supply, case.cooling
    if cooling is None:
        assert supply is not None, "a case without a sink of heat has its temperature prescribed"
        return supply.temperature
    if supply is None:
        return cooling.ambient_temperature
    return min(supply.temperature, cooling.ambient_temperature)


def find_equilibrium(
    case: CheckedProblem,
    film_at: Callable[[float], FilmAtTemperatureT],
    policy: SearchPolicy = FINE_SEARCH,
    above: float = 0.0,
) -> Equilibrium[FilmAtTemperatureT]:
    """Find the coolest temperature at which oil and housing of a case carry the friction heat away.

    Parameters
    ----------
    case : CheckedProblem
        Supply and cooling.
    film_at, policy
        As of `coolest_equilibrium`.
    above : float
        Temperature in K below which there is none, where more is known than the temperatures around.
    """

    def surplus(_: float, film: FilmAtTemperatureT) -> float:
        return heat_surplus(film, case)

    return coolest_equilibrium(film_at, surplus, larger(coolest_temperature(case), above), policy)


def coolest_equilibrium(
    film_at: Callable[[float], FilmT],
    surplus: Callable[[float, FilmT], float],
    coolest: float,
    policy: SearchPolicy,
    ceiling: float = CEILING,
) -> Equilibrium[FilmT]:
    """Find the coolest temperature at which the heat balance closes; always ends with a status.

    A cold film makes more heat than it gives away. The temperature is raised step by step until the surplus turns
    negative, or until three steps enclose a least surplus that is negative in between; Chandrupatla's method
    closes in on this coolest equilibrium, the stable one. A large step in which something happens is walked again
    in fine ones.
    Where the film gives way on the way, the step to the last temperature with a film is looked at as well.

    Parameters
    ----------
    film_at : callable
        Film at a temperature in K; may raise `NoFilmError`.
    surplus : callable
        What a film at a temperature is heated more than cooled, in any unit: its sign and its root count.
    coolest : float
        Temperature in K below which there is no equilibrium.
    policy : SearchPolicy
        `FINE_SEARCH` for cheap films, `COARSE_SEARCH` for dear ones, `BOLD` where the surplus falls all the way.
    ceiling : float
        Temperature in K beyond which no film is followed.
    """
    search = _Search(film_at, surplus, coolest, policy)
    try:
        return _coolest(search, coolest, policy, ceiling)
    except _SpentError:
        return search.given_up()
    except NoFilmError as failure:  # between films that were found, or of one that is not found a second time
        return search.ended(failure, search.temperature)


def _coolest(search: _Search[FilmT], coolest: float, policy: SearchPolicy, ceiling: float) -> Equilibrium[FilmT]:
    low, step, largest = coolest, policy.step, policy.largest_step
    while True:  # a law may not reach the coolest temperature; a warm film needs it only from where it is defined
        try:
            surplus = search.surplus(low)
            break
        except NoFilmError as failure:
            if failure.outcome is not Outcome.NO_LUBRICANT_DATA or low >= ceiling:
                return search.ended(failure, low)
            low += policy.step
    if surplus <= 0.0 and low > coolest:
        return search.unsolved(Outcome.NO_LUBRICANT_DATA, low)
    earlier, before = None, (low, surplus)
    while surplus > 0.0:
        high = min(low + step, ceiling)
        coarse = step > policy.fine_step
        try:
            following = search.surplus(high)
        except NoFilmError as failure:
            if coarse:
                step = largest = policy.fine_step
                continue
            high = search.last_with_film(low, surplus, high)
            following = search.surplus(high)
            if following > 0.0:
                return search.ended(failure, high)
        if following <= 0.0 and coarse:
            step = largest = policy.fine_step
            continue
        if following > 0.0 and before[1] > surplus < following:
            dip = search.least(before[0], high)
            if search.surplus(dip) <= 0.0:
                return search.closed_in(before[0], dip)
        if following > 0.0 and high >= ceiling:
            return search.unsolved(Outcome.THERMAL_RUNAWAY, high)
        earlier = before if before[0] < low else None
        before, low, surplus = (low, surplus), high, following
        step = min(step * policy.growth, largest)
    return search.closed_in(before[0], low, earlier)


def at_prescribed_temperature(temperature: float, film_at: Callable[[float], FilmT]) -> Equilibrium[FilmT]:
    """Film at a temperature in K that is given instead of sought."""
    try:
        return Equilibrium(Outcome.CONVERGED, film_at(temperature), 1, temperature)
    except NoFilmError as failure:
        return Equilibrium(failure.outcome, None, 1, temperature, failure)


class _SpentError(Exception):
    """The search has had all the films that its policy allows."""


class _Search(Generic[FilmT]):
    """The surplus of heat over temperature, and the ways a search for its root can end."""

    def __init__(
        self,
        film_at: Callable[[float], FilmT],
        surplus: Callable[[float, FilmT], float],
        coolest: float,
        policy: SearchPolicy,
    ) -> None:
        self._film_at, self._surplus_of, self._coolest, self._policy = film_at, surplus, coolest, policy
        self._evaluations = 0
        self._last: tuple[float, FilmT | NoFilmError] | None = None
        self._before: tuple[float, FilmT | NoFilmError] | None = None

    def surplus(self, temperature: float) -> float:
        """Heat made less heat carried away."""
        if self._evaluations >= self._policy.most_evaluations:
            raise _SpentError
        self._evaluations += 1
        return self._surplus_of(temperature, self._film(temperature))

    def least(self, low: float, high: float) -> float:
        """Temperature of the least surplus between two temperatures."""
        from scipy.optimize import minimize_scalar

        options = {"xatol": self._policy.dip}
        found = minimize_scalar(self.surplus, bounds=(low, high), method="bounded", options=options)
        return float(found.x)

    def last_with_film(self, good: float, known: float, bad: float) -> float:
        """Highest temperature with a film between one that has and one that has not, by bisection.

        `known` is the surplus of the good one. The first one on the way whose film gives all its heat away is as
        good: the equilibrium lies below it. Sure that none does, one that is near will do.
        """
        while bad - good > self._policy.edge:
            middle = (good + bad) / 2.0
            try:
                surplus = self.surplus(middle)
            except NoFilmError:
                bad = middle
                continue
            good, lost, known = middle, abs(known - surplus), surplus
            if surplus <= 0.0 or surplus > self._policy.sure * lost:
                break
        return good

    def closed_in(self, low: float, high: float, beyond: tuple[float, float] | None = None) -> Equilibrium[FilmT]:
        """Root of the surplus between two temperatures that enclose it; `beyond` as of `find_root`."""
        if low == high:  # the coolest film already gives away all its heat
            return Equilibrium(Outcome.CONVERGED, self._film(low), self._evaluations, low)
        try:
            root = find_root(self.surplus, low, high, self._policy.tolerance, most_steps=MOST_STEPS, beyond=beyond)
        except NoFilmError as failure:
            return self.ended(failure, low)
        outcome = Outcome.CONVERGED if root.converged else Outcome.NOT_CONVERGED
        return Equilibrium(outcome, self._film(root.value), self._evaluations, root.value)

    def unsolved(self, outcome: Outcome, temperature: float) -> Equilibrium[FilmT]:
        """End without an equilibrium at a temperature that has a film."""
        return Equilibrium(outcome, self._film(temperature), self._evaluations, temperature)

    def ended(self, failure: NoFilmError, temperature: float) -> Equilibrium[FilmT]:
        """End where the film gave way."""
        try:
            film: FilmT | None = self._film(temperature)
        except NoFilmError:
            film = None
        return Equilibrium(failure.outcome, film, self._evaluations, temperature, failure)

    @property
    def temperature(self) -> float:
        """At which a film was sought last, K."""
        return self._coolest if self._last is None else self._last[0]

    def given_up(self) -> Equilibrium[FilmT]:
        """End where the films allowed have run out."""
        found = None if self._last is None else self._last[1]
        film = None if isinstance(found, NoFilmError) else found
        return Equilibrium(Outcome.NOT_CONVERGED, film, self._evaluations, self.temperature)

    def _film(self, temperature: float) -> FilmT:
        """Film at a temperature; the last two are kept, for a search closes in between them and ends at one."""
        if self._before is not None and self._before[0] == temperature:
            self._before, self._last = self._last, self._before
        if self._last is None or self._last[0] != temperature:
            self._before = self._last
            try:
                self._last = temperature, self._film_at(temperature)
            except NoFilmError as failure:
                self._last = temperature, failure
        found = self._last[1]
        if isinstance(found, NoFilmError):
            raise found
        return found
