"""Films whose supplies deliver given flows: flooded where the film draws less, starved where it asks for more.

The state of such a supply is one number x. Up to 1 it is the liquid fraction with which the supply fills the gap
behind it, at cavitation pressure; from there up to 2 the supply is full and its pressure rises to ambient. What a
flooded supply delivers beyond what the film draws returns without passing the film. With q(x) the net flow of a
supply (what it sends off less what the film brings back), Q the flow given and x_1 the state of a flooded supply:

    x <= x_1,   q(x) <= Q,   one of both an equality.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.numerics.roots import bracketed_root
from babbitt.reynolds.model import Cavitation, FilmStart, JournalFilm
from babbitt.reynolds.solution import FilmSolution

__all__ = ["FedFilm", "PrescribedFlow", "feed_film"]

Array = NDArray[np.float64]

BRIM = 1.0 - 1e-12
"""Fill that stands for flooded: the film is solved as that of a starved supply, without a seam between both."""
LEAST_FILL = 0.01
"""Fill below which no film is sought."""
CLOSENESS = 1e-3
"""Of net flow to given flow: a film jumps a little where a line ruptures, and no fill may meet the flow better."""
NUDGES = (1.0, 0.995, 1.005)
"""Factors on a fill at which a film is sought where one fill gives none."""
STEP = 1e-4
"""Relative step for derivatives: smaller ones meet the noise of the converged film."""
ROUGHLY = 1e-4
"""Closeness in the logarithm of a fill that is only the place to start from."""
MOST_FILMS = 150
"""Films after which the search gives up."""


@dataclass(frozen=True)
class PrescribedFlow:
    """A flow in m3/s that some supplies share with one fill.

    Attributes
    ----------
    members : tuple of int
        Places of the supplies in ``FilmSolution.supply_flow``.
    flow : float
    """

    members: tuple[int, ...]
    flow: float


@dataclass(frozen=True, eq=False)
class FedFilm:
    """Film with its supplies.

    Attributes
    ----------
    solution : FilmSolution
        ``outcome`` counts for the flows as well: converged, or overloaded where no film carries the load on so
        little oil.
    fill : tuple of float
        Liquid fraction that every supply sends off, 1 where flooded; in the order of ``supply_flow``.
    drawn : tuple of float
        What the film takes of every given flow, m3/s.
    surplus : float
        Part of all given flows that returns without passing the film, m3/s.
    least_flow : float or None
        Where the film failed for want of oil: the least flow in m3/s, of all supplies with given flow, with which
        a film was found.
    """

    solution: FilmSolution
    fill: tuple[float, ...]
    drawn: tuple[float, ...]
    surplus: float
    least_flow: float | None = None

    @property
    def starved(self) -> bool:
        """Whether a supply delivers less than the film would draw."""
        return min(self.fill, default=1.0) < 0.5 * (1.0 + BRIM)


def feed_film(
    film: JournalFilm, given: Sequence[PrescribedFlow], settle: Callable[[JournalFilm], FilmSolution]
) -> FedFilm:
    """Find how far each supply of given flow fills the film.

    Parameters
    ----------
    film : JournalFilm
        With all supplies flooded; the pressures of those with given flow do not count.
    given : sequence of PrescribedFlow
    settle : callable
        Solves a film, at its load or position.

    Returns
    -------
    FedFilm

    Raises
    ------
    InputError
        E101 if the film does not conserve mass, a flow is not positive, or a supply is named twice or unknown.
    """
    check(film, given)
    search = _Search(film, tuple(given), settle)
    full = np.full(len(given), flooded_state(film))
    try:
        return search.balanced(full)
    except _NoFilmError as failure:
        return search.failed(failure)


def check(film: JournalFilm, given: Sequence[PrescribedFlow]) -> None:
    """Refuse flows that cannot be given."""
    if film.cavitation is not Cavitation.MASS_CONSERVING:
        raise InputError("E101", "a given supply flow needs Cavitation.MASS_CONSERVING, which counts the oil.")
    grooves = 0 if film.film_start is FilmStart.PERIODIC else len(film.lands)
    known = grooves + len(film.pockets)
    named = [number for one in given for number in one.members]
    if sorted(set(named)) != sorted(named) or not all(0 <= number < known for number in named):
        raise InputError("E101", f"given flows name the supplies {named}; each of 0 to {known - 1} at most once.")
    for one in given:
        if not (math.isfinite(one.flow) and one.flow > 0.0):
            raise InputError("E101", f"a given supply flow is {one.flow} m3/s; it must be positive.")


def flooded_state(film: JournalFilm) -> float:
    """State of a full supply at ambient pressure."""
    return 2.0 if film.cavitation_pressure < 0.0 else 1.0


def with_states(film: JournalFilm, states: dict[int, float]) -> JournalFilm:
    """Film whose supplies have given states; see the head of this file."""

    def fill_and_pressure(state: float) -> tuple[float, float]:
        fill = min(state, BRIM)
        return fill, film.cavitation_pressure * min(max(2.0 - state, 0.0), 1.0)

    lands, pockets = list(film.lands), list(film.pockets)
    order = film.land_order
    grooves = 0 if film.film_start is FilmStart.PERIODIC else len(lands)
    for number, state in states.items():
        fill, pressure = fill_and_pressure(state)
        if number >= grooves:
            pockets[number - grooves] = replace(pockets[number - grooves], fill=fill, pressure=pressure)
            continue
        behind, before = order[number], order[(number + 1) % grooves]  # counter-clockwise of each other
        lands[behind] = replace(lands[behind], end_pressure=pressure)
        lands[before] = replace(lands[before], start_pressure=pressure)
        entered = before if film.angular_speed >= 0.0 else behind
        lands[entered] = replace(lands[entered], start_fill=fill)
    return replace(film, lands=tuple(lands), pockets=tuple(pockets))


class _NoFilmError(Exception):
    """No film was found at some states."""

    def __init__(self, solution: FilmSolution) -> None:
        super().__init__(solution.outcome.value)
        self.solution = solution


class _Search:
    """States of the supplies at which flows and fills agree."""

    def __init__(
        self, film: JournalFilm, given: tuple[PrescribedFlow, ...], settle: Callable[[JournalFilm], FilmSolution]
    ) -> None:
        self._film = film
        self._given = given
        self._settle = settle
        self._flows = np.array([one.flow for one in given])
        self._highest = flooded_state(film)
        self._films = 0
        self._last: tuple[Array, FilmSolution] | None = None
        self._least: float | None = None

    def balanced(self, full: Array) -> FedFilm:
        """Flooded, or with the fills that the flows allow."""
        drawn = self.drawn(full)
        if (drawn <= self._flows).all():
            return self.answer(full)
        if self._flows.size == 1:
            return self.answer(np.array([self.single(0, full, drawn, 1e-13)]))
        return self.answer(self.several(full, drawn))

    def film_at(self, states: Array) -> FilmSolution:
        """Film at some states, or a little beside where there is none."""
        if self._last is not None and (self._last[0] == states).all():
            return self._last[1]
        for nudge in NUDGES:
            self._films += 1
            near = np.minimum(states * nudge, self._highest)
            members = {number: x for one, x in zip(self._given, near, strict=True) for number in one.members}
            solution = self._settle(with_states(self._film, members))
            if solution.outcome.solved:
                break
        if not solution.outcome.solved or self._films > MOST_FILMS:
            raise _NoFilmError(solution)
        self._last = states.copy(), solution
        return solution

    def drawn(self, states: Array) -> Array:
        """Net flows at some states, m3/s."""
        flows = self.film_at(states).supply_flow
        drawn = np.array([flows[list(one.members)].sum() for one in self._given])
        total = float(drawn.sum())
        self._least = total if self._least is None else min(self._least, total)
        return drawn

    def single(self, place: int, states: Array, drawn: Array, closeness: float) -> float:
        """State of one supply that takes its flow, to some closeness of its logarithm, the others as they are."""
        states = states.copy()

        def excess(log_state: float) -> float:
            states[place] = math.exp(log_state)
            return float(self.drawn(states)[place] / self._flows[place] - 1.0)

        high = math.log(states[place])
        low, ratio = high, float(drawn[place] / self._flows[place])
        while True:  # the flow grows with about the square of the fill
            low = max(low - max(0.1, 0.6 * math.log(max(ratio, 1.0))), math.log(LEAST_FILL))
            ratio = excess(low) + 1.0
            if ratio <= 1.0:
                break
            if low <= math.log(LEAST_FILL):
                raise _NoFilmError(self.film_at(states))
            high = low
        return math.exp(bracketed_root(excess, low, high, closeness, closeness))

    def several(self, full: Array, drawn: Array) -> Array:
        """States of several supplies: a root of the function of Fischer and Burmeister in both inequalities."""
        from scipy.optimize import root

        top, bottom = math.log(self._highest), math.log(LEAST_FILL)

        def disagreement(logs: Array) -> Array:
            slack = top - logs
            try:
                spare = 1.0 - self.drawn(np.exp(np.clip(logs, bottom, top))) / self._flows
            except _NoFilmError:
                if self._films > MOST_FILMS:
                    raise
                return np.full(logs.size, 10.0)  # a bad place: the search turns back
            return np.asarray(slack + spare - np.hypot(slack, spare))

        begin = np.log(full) - 0.5 * np.log(np.maximum(drawn / self._flows, 1.0))
        for _ in range(3):
            found = root(
                disagreement, begin, method="hybr", options={"xtol": 1e-12, "factor": 0.3, "eps": STEP**2}
            )
            logs = np.clip(found.x, bottom, top)
            if np.abs(disagreement(logs)).max() < CLOSENESS:
                break
            begin = np.log(self.one_after_the_other(np.exp(logs)))
        return np.asarray(np.exp(logs))

    def one_after_the_other(self, states: Array) -> Array:
        """Two rounds in which every supply finds its state, the others keeping theirs: a better place to start."""
        states = states.copy()
        for place in [*range(states.size)] * 2:
            states[place] = self._highest
            drawn = self.drawn(states)
            if drawn[place] > self._flows[place]:
                states[place] = self.single(place, states, drawn, ROUGHLY)
        return states

    def answer(self, states: Array) -> FedFilm:
        """Film at its final states."""
        solution, drawn = self.film_at(states), self.drawn(states)
        fill = [1.0] * solution.supply_flow.size
        for one, state in zip(self._given, states, strict=True):
            for number in one.members:
                fill[number] = min(float(state), 1.0)
        taken = np.minimum(drawn, self._flows)
        starved = states < self._highest * BRIM
        wrong = np.where(starved, np.abs(drawn - self._flows), np.maximum(drawn - self._flows, 0.0))
        if (starved & (states < 1.001 * LEAST_FILL) & (drawn > self._flows)).any():
            raise _NoFilmError(solution)
        if (wrong > CLOSENESS * self._flows).any():
            solution = replace(solution, outcome=Outcome.NOT_CONVERGED)
        return FedFilm(solution, tuple(fill), tuple(map(float, taken)), float((self._flows - taken).sum()))

    def failed(self, failure: _NoFilmError) -> FedFilm:
        """Where no film was found: of no flow at all, or of so little."""
        solution, count = failure.solution, failure.solution.supply_flow.size
        if self._least is not None and solution.outcome.solved:
            solution = replace(solution, outcome=Outcome.OVERLOADED)
        nothing = (0.0,) * len(self._given)
        return FedFilm(solution, (1.0,) * count, nothing, 0.0, self._least)
