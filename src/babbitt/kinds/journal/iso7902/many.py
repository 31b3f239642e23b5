"""The ISO 7902 design check of many bearings at once: the functions for one, with `Lanes` in place of numbers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.result import Outcome, Result, Verdict
from babbitt.design.heat_balance import Equilibrium, NoFilmError, coolest_temperature, heat_surplus
from babbitt.design.heat_balance_lanes import coolest_temperatures
from babbitt.design.verdict_lanes import by_verdict
from babbitt.kinds.journal.iso7902.film import (
    Film,
    SuppliedFilm,
    curves_of,
    film_at,
    starved_film_at,
    supplied_film,
)
from babbitt.kinds.journal.iso7902.model import DesignCase
from babbitt.kinds.journal.iso7902.procedure import METHOD, Design, design_of, result_of
from babbitt.kinds.journal.iso7902.supply_capacity import gets_less
from babbitt.kinds.journal.limits_of_clearance import many_held_at_limits
from babbitt.numerics.lanes import chooser, in_branches, lanes_of
from babbitt.numerics.scalar_or_array import Array

__all__ = ["check_many"]

Index = NDArray[np.intp]
FilmAt = Callable[..., Film]
FilmT = TypeVar("FilmT", bound=Film)
Choose = Callable[[Index], DesignCase]


@dataclass(frozen=True)
class _Found:
    """A film with all the oil that it wants, one with less where it gets less, and what both come to."""

    case: DesignCase
    film: SuppliedFilm
    starved: Equilibrium[Film] | None
    design: Design


def check_many(case: DesignCase, count: int) -> Iterator[tuple[Index, Result, Verdict]]:
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
        Bearings whose checks are the same, and their verdict. Those that are left out are to be solved one by
        one: what has no solution, a heat balance whose way is not plain, and what keeps its limits at its mean
        clearance and not so at the limits of that.
    result : Result
        Its numbers in lanes; remarks only as far as the verdict depends on them.
    verdict : Verdict
    """
    yield from many_held_at_limits(case, count, _check_many)


def _check_many(case: DesignCase, count: int) -> Iterator[tuple[Index, Result, Verdict]]:
    """The procedure at the clearance of the case."""
    own = chooser(case)
    full = _temperatures(case, own, np.arange(count), film_at)
    starved = np.full(count, np.nan)
    short = _getting_less(case, own, full)
    starved[short] = _temperatures(case, own, short, starved_film_at)
    is_short = np.zeros(count, bool)
    is_short[short] = True
    for kind in (np.isfinite(full) & ~is_short, np.isfinite(full) & is_short & np.isfinite(starved)):
        for index, found in in_branches(
            lambda lanes: _found(own(lanes), full, starved, lanes), np.flatnonzero(kind)
        ):
            if found is not None:
                for lanes, result, verdict in by_verdict(
                    found, found.design.checks, index.size, _failed, _with_remarks
                ):
                    yield index[lanes], result, verdict


def _found(case: DesignCase, full: Array, starved: Array, index: Index) -> _Found:
    shape = curves_of(case)
    film = supplied_film(case, film_at(lanes_of(full[index]), case, shape))
    limited = None
    if np.isfinite(starved[index]).all():
        limited = _equilibrium(starved_film_at(lanes_of(starved[index]), case, shape))
    return _Found(case, film, limited, design_of(case, film, limited))


def _equilibrium(film: FilmT) -> Equilibrium[FilmT]:
    return Equilibrium(Outcome.CONVERGED, film, 0, 0.0)


def _failed(found: _Found) -> Result:
    case, design = found.case, found.design
    return Result(case.name, case.kind, METHOD, Outcome.CONVERGED, design.values, design.checks)


def _with_remarks(found: _Found) -> tuple[Result, Verdict]:
    result = result_of(found.case, _equilibrium(found.film), found.starved, found.design, 0.0)
    return result, result.verdict


def _temperatures(case: DesignCase, choose: Choose, bearings: Index, film_of: FilmAt) -> Array:
    """Effective temperatures in K of some bearings; NaN where they are to be found one by one."""
    if case.effective_temperature is not None:
        given = np.asarray(case.effective_temperature, float)
        return given[bearings] if given.ndim else np.full(bearings.shape, given)
    shape_of = chooser(curves_of(case))

    def surplus(lanes: Index, temperatures: Array) -> Array:
        def of(index: Index) -> object:
            chosen = bearings[lanes[index]]
            own = choose(chosen)
            try:
                film = film_of(lanes_of(temperatures[index]), own, shape_of(chosen))
            except NoFilmError as failure:
                if failure.outcome is Outcome.NO_LUBRICANT_DATA and index.size > 1:
                    raise  # some of them may have
                return np.nan
            return heat_surplus(film, own)

        return _collected(of, temperatures.size)

    coolest = _collected(lambda index: coolest_temperature(choose(bearings[index])), bearings.size)
    return coolest_temperatures(surplus, coolest)


def _collected(formula: Callable[[Index], object], count: int) -> Array:
    """A number for each lane; NaN where the formula breaks off."""
    found = np.full(count, np.nan)
    for index, answer in in_branches(formula, np.arange(count)):
        if answer is not None:
            found[index] = answer
    return found


def _getting_less(case: DesignCase, choose: Choose, temperatures: Array) -> Index:
    """Bearings that get less oil than the standard gives them, where that is balanced."""
    if case.effective_temperature is not None:
        return np.empty(0, np.intp)
    solved = np.flatnonzero(np.isfinite(temperatures))
    found: list[Index] = []

    def less(index: Index) -> bool:
        own = choose(index)
        film = film_at(lanes_of(temperatures[index]), own, curves_of(own))
        return bool(gets_less(supplied_film(own, film)))

    for index, answer in in_branches(less, solved):
        if answer:
            found.append(index)
    return np.sort(np.concatenate(found)) if found else np.empty(0, np.intp)
