"""The ISO 7902 design check of many bearings at once: the functions for one, with `Lanes` in place of numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome, Result, Verdict
from babbitt.design.heat_balance import Equilibrium, NoFilmError, coolest_temperature, heat_surplus
from babbitt.design.heat_balance_lanes import coolest_temperatures
from babbitt.kinds.journal.iso7902.film import Film, curves_of, film_at, starved_film_at
from babbitt.kinds.journal.iso7902.model import DesignCase
from babbitt.kinds.journal.iso7902.procedure import result_of
from babbitt.kinds.journal.iso7902.supply_capacity import gets_less
from babbitt.numerics.lanes import in_branches, lanes_at, lanes_of
from babbitt.numerics.scalar_or_array import Array

__all__ = ["check_many"]

Index = NDArray[np.intp]
FilmAt = Callable[..., Film]


def check_many(case: DesignCase, count: int) -> Iterator[tuple[Index, tuple[Result, Verdict] | None]]:
    """Run the ISO 7902 procedure for many bearings.

    Parameters
    ----------
    case : DesignCase
        Its numbers that differ from bearing to bearing are `Lanes`.
    count : int
        Bearings.

    Yields
    ------
    index : ndarray of int
        Bearings whose checks and remarks are the same, each numbered once.
    answer : (Result, Verdict) or None
        Results in lanes. None for bearings that are to be checked one by one: what has no solution, or a heat
        balance whose way is not plain.
    """
    full = _temperatures(case, count, film_at)
    starved = np.full(count, np.nan)
    short = _getting_less(case, full)
    if short.size:
        starved[short] = _temperatures(lanes_at(case, short), short.size, starved_film_at)
    solved = np.isfinite(full)
    solved[short] &= np.isfinite(starved[short])
    if not solved.all():
        yield np.flatnonzero(~solved), None
    is_short = np.zeros(count, bool)
    is_short[short] = True
    for kind in (solved & ~is_short, solved & is_short):
        yield from in_branches(lambda index: _answer(case, full, starved, index), np.flatnonzero(kind))


def _answer(case: DesignCase, full: Array, starved: Array, index: Index) -> tuple[Result, Verdict]:
    own = lanes_at(case, index)
    shape = curves_of(own)
    found = Equilibrium(Outcome.CONVERGED, film_at(lanes_of(full[index]), own, shape), 0, 0.0)
    limited = None
    if np.isfinite(starved[index]).all():
        film = starved_film_at(lanes_of(starved[index]), own, shape)
        limited = Equilibrium(Outcome.CONVERGED, film, 0, 0.0)
    result = result_of(own, found, limited, 0.0)
    return result, result.verdict


def _temperatures(case: DesignCase, count: int, film_of: FilmAt) -> Array:
    """Effective temperatures in K; NaN where they are to be found one by one."""
    if case.effective_temperature is not None:
        return np.broadcast_to(np.asarray(case.effective_temperature, float), (count,)).copy()
    shape = curves_of(case)

    def surplus(lanes: Index, temperatures: Array) -> Array:
        def of(index: Index) -> object:
            own = lanes_at(case, lanes[index])
            try:
                film = film_of(lanes_of(temperatures[index]), own, lanes_at(shape, lanes[index]))
            except NoFilmError as failure:
                if failure.outcome is Outcome.NO_LUBRICANT_DATA and index.size > 1:
                    raise  # some of them may have
                return np.nan
            return heat_surplus(film, own)

        return _collected(of, temperatures.size)

    coolest = _collected(lambda index: coolest_temperature(lanes_at(case, index)), count)
    return coolest_temperatures(surplus, coolest)


def _collected(formula: Callable[[Index], object], count: int) -> Array:
    """A number for each lane; NaN where the formula breaks off."""
    found = np.full(count, np.nan)
    for index, answer in in_branches(formula, np.arange(count)):
        if answer is not None:
            found[index] = answer
    return found


def _getting_less(case: DesignCase, temperatures: Array) -> Index:
    """Bearings that get less oil than the standard gives them, where that is balanced."""
    if case.effective_temperature is not None:
        return np.empty(0, np.intp)
    solved = np.flatnonzero(np.isfinite(temperatures))
    found: list[Index] = []

    def less(index: Index) -> bool:
        own = lanes_at(case, index)
        return bool(gets_less(film_at(lanes_of(temperatures[index]), own, curves_of(own))))

    for index, answer in in_branches(less, solved):
        if answer:
            found.append(index)
    return np.sort(np.concatenate(found)) if found else np.empty(0, np.intp)
