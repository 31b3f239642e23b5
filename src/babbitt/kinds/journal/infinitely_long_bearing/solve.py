"""The long film in equilibrium: viscosity, pressure, heat and temperature in turn."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.result import Outcome
from babbitt.design.eccentricity_search import film_that_carries, rising_eccentricities
from babbitt.design.heat_balance import NoFilmError
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilm
from babbitt.kinds.journal.infinitely_long_bearing.network import temperatures
from babbitt.kinds.journal.infinitely_long_bearing.pressure import (
    Gap,
    Pressure,
    divergence_form,
    load_of_divergence_form,
    published_form,
)
from babbitt.kinds.journal.infinitely_long_bearing.state import LongFilmState
from babbitt.kinds.journal.infinitely_long_bearing.walls import sectors_of, viscosity_at
from babbitt.numerics.anderson import AndersonOptions, fixed_point

Array = NDArray[np.float64]

TEMPERATURE_TOLERANCE, LOAD_TOLERANCE = 1e-4, 1e-6
"""In K between two iterations, and of the load."""

LARGEST_CHANGE = 40.0
"""K; a cold film heats itself far beyond its equilibrium in one step, out of the range of any oil."""

MOST_ITERATIONS = 400
RELAXED = AndersonOptions(MOST_ITERATIONS, memory=1, damping=0.85, largest_share=2.0)
"""Relaxed passes, each improved by what the one before taught."""

GREATEST_ECCENTRICITY = 0.99
"""As of the characteristics of the standard: above, a rigid film says nothing."""

GREATEST_STRETCH = math.log(GREATEST_ECCENTRICITY / (1.0 - GREATEST_ECCENTRICITY))
SCAN = rising_eccentricities(GREATEST_ECCENTRICITY)


def film_at_eccentricity(film: LongFilm, eccentricity_ratio: float, start: Array | None = None) -> LongFilmState:
    """The film in thermal equilibrium at an eccentricity ratio.

    Parameters
    ----------
    film : LongFilm
    eccentricity_ratio : float
        0 to 1, both excluded.
    start : ndarray, optional
        Temperatures to start from, K, at the nodes; those of the inlet if not given.

    Returns
    -------
    LongFilmState
        Not converged after 400 iterations: its `converged` says so.

    Raises
    ------
    InputError
        E003 for an eccentricity outside its bounds.
    NoFilmError
        When the laws of the lubricant end before an equilibrium.
    """
    if not 0.0 < eccentricity_ratio < 1.0:
        raise InputError("E003", f"eccentricity_ratio must lie between 0 and 1, given {eccentricity_ratio!r}")
    gap = Gap.of(eccentricity_ratio, film.cells, film.start)
    return _iterated(film, lambda viscosity: gap, start)


def film_under_load(film: LongFilm, load: float) -> LongFilmState:
    """The film that carries a load, with the least eccentricity that does.

    The position is found anew for each temperature field on the way; where that loses its way, the eccentricity is
    raised step by step to the first that carries the load, since a film that heats up can carry less when pressed
    closer.

    Parameters
    ----------
    film : LongFilm
    load : float
        N, the resultant.

    Raises
    ------
    NoFilmError
        OVERLOADED with the largest load reached; NOT_CONVERGED; NO_LUBRICANT_DATA.
    """
    if not 0.0 < load < math.inf:
        raise InputError("E003", f"load must be above 0, given {load!r}")
    try:
        state = _iterated(film, _Position(film, load), None, most=60)
        if state.converged and abs(state.load / load - 1.0) < 1e-5:
            return state
    except NoFilmError:
        pass
    return _scanned(film, load)


def _scanned(film: LongFilm, load: float) -> LongFilmState:
    def film_near(eccentricity: float, near: LongFilmState) -> LongFilmState:
        return film_at_eccentricity(film, eccentricity, near.temperatures.film)

    return film_that_carries(load, _rising(film), film_near)


class _Position:
    """Moves the gap towards a load by one Newton step for each viscosity field that it is given.

    Over ``ln(ε/(1 - ε))`` the logarithm of the load is nearly a straight line.
    """

    def __init__(self, film: LongFilm, load: float) -> None:
        self.film, self.stretch = film, 0.0
        scale = film.surface_speed * film.radius**2 * film.width / film.clearance**2
        self.wanted = math.log(load / scale)

    def __call__(self, viscosity: Array) -> Gap:
        level = self._level(self.stretch, viscosity)
        ahead = self._level(self.stretch + 1e-4, viscosity)
        self.stretch += max(-1.0, min(1.0, (self.wanted - level) * 1e-4 / (ahead - level)))
        if self.stretch > GREATEST_STRETCH:
            raise NoFilmError(Outcome.OVERLOADED)
        return self._gap(self.stretch)

    def _gap(self, stretch: float) -> Gap:
        return Gap.of(1.0 / (1.0 + math.exp(-stretch)), self.film.cells, self.film.start)

    def _level(self, stretch: float, viscosity: Array) -> float:
        gap = self._gap(stretch)
        if self.film.discretisation.conserves_flow:
            return math.log(math.hypot(*load_of_divergence_form(gap, viscosity)))
        return math.log(math.hypot(*published_form(gap, viscosity).load(gap.step)))


def _pressure(film: LongFilm, gap: Gap, viscosity: Array) -> Pressure:
    form = divergence_form if film.discretisation.conserves_flow else published_form
    return form(gap, viscosity)


def _iterated(
    film: LongFilm, gap_at: Callable[[Array], Gap], start: Array | None, most: int = MOST_ITERATIONS
) -> LongFilmState:
    begin = np.full(film.cells + 1, film.inlet_temperature) if start is None else start
    passes = _Passes(film, gap_at)
    found = fixed_point(passes.residual, passes.settled, begin, replace(RELAXED, most_evaluations=most))
    assert passes.state is not None  # a search looks at its start
    return replace(passes.state, iterations=found.evaluations, converged=found.converged)


@dataclass(eq=False)
class _Passes:
    """A pass of viscosity, pressure, heat and temperature as a map of the temperatures at the nodes, K."""

    film: LongFilm
    gap_at: Callable[[Array], Gap]
    state: LongFilmState | None = None
    load_before: float = math.inf

    def residual(self, assumed: Array) -> Array:
        """Change of the temperatures, bounded."""
        film = self.film
        if self.state is not None:
            self.load_before = self.state.load
        viscosity = viscosity_at(film, assumed)
        gap = self.gap_at(viscosity)
        pressure = _pressure(film, gap, viscosity)
        scale = film.surface_speed * film.radius**2 * film.width / film.clearance**2
        along, across = (scale * one for one in pressure.load(gap.step))
        sectors = sectors_of(film, gap, pressure, viscosity, assumed)
        if not sectors.capacity_flow.min() > 0.0:
            raise NoFilmError(Outcome.NOT_CONVERGED)
        found = temperatures(film, sectors)
        moved = found.film - assumed
        change = max(float(moved.max()), -float(moved.min()))
        if not math.isfinite(change):
            raise NoFilmError(Outcome.NOT_CONVERGED)
        self.state = LongFilmState(film, gap, viscosity, pressure, sectors, found, along, across, 0, False, change)
        return np.asarray(np.clip(moved, -LARGEST_CHANGE, LARGEST_CHANGE)) if change > LARGEST_CHANGE else moved

    def settled(self, _: Array, change: Array) -> bool:
        """Whether neither temperatures nor load change any more."""
        load = 0.0 if self.state is None else self.state.load
        still = abs(load - self.load_before) <= LOAD_TOLERANCE * load
        return still and max(float(change.max()), -float(change.min())) < TEMPERATURE_TOLERANCE


def _rising(film: LongFilm) -> Iterator[LongFilmState]:
    """Films of growing eccentricity, each begun from the one before."""
    start: Array | None = None
    for eccentricity in SCAN:
        state = film_at_eccentricity(film, eccentricity, start)
        if not state.converged:
            raise NoFilmError(Outcome.NOT_CONVERGED)
        yield state
        start = state.temperatures.film
