"""Where a film with its own temperatures gave way: the largest load that still had a film, and what it says."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from babbitt.core.notices import Notice
from babbitt.core.result import Outcome
from babbitt.design.conditions import PrescribedLoad
from babbitt.design.heat_balance import CEILING, Equilibrium, NoFilmError
from babbitt.design.oil import highest_usable
from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.model import Accuracy, FilmCase
from babbitt.kinds.journal.film.thermal_search import ThermalSearch

__all__ = ["last_film", "thermal_failure", "what_gave_way"]

HALVINGS, BISECTIONS = 10, 3
"""Of the load until a film is found, and then between the last two."""

HOT = 0.5
"""Share of the way from fresh oil to the end of the oil's laws that a film must have gone to be called hot.

An assumption: no source draws this line.
"""

CLOSED = 3e-3
"""Least gap of the last film, in clearances, up to which a heavier load closes it: three times what the film
method takes for a film. An assumption, too."""
OPEN = 0.5
"""Least gap of the last film, in clearances, from which the search lost its way, however it ended; it does so
where a load points into a groove. An assumption, too."""


def last_film(case: FilmCase, film_at: Callable[[FilmCase, ThermalSearch], FilmState]) -> FilmState | None:
    """Film under the largest load, to some percent, below one that has none; None where there is none at all.

    On a draft grid, and with the clearance and the oil's properties of the round that had no film: it only tells
    how far the bearing is from carrying its load. Once a film is found, heavier ones climb from there.

    Parameters
    ----------
    case : FilmCase
        Its load has no film.
    film_at : callable
        Film of a case by a search; may raise `NoFilmError`.
    """
    if not isinstance(case.duty, PrescribedLoad):
        return None
    whole = case.duty.load

    def under(share: float, search: ThermalSearch) -> FilmState | None:
        try:
            return film_at(replace(case, duty=PrescribedLoad(share * whole), accuracy=Accuracy.DRAFT), search)
        except NoFilmError:
            return None

    high, low, found, sought = 1.0, 1.0, None, ThermalSearch()
    for _ in range(HALVINGS):
        high, low, sought = low, 0.5 * low, ThermalSearch()
        found = under(low, sought)
        if found is not None:
            break
    if found is None:
        return None
    for _ in range(BISECTIONS):
        middle, climbing = 0.5 * (low + high), sought.climbing()
        better = under(middle, climbing)
        if better is None:
            high = middle
        else:
            low, found, sought = middle, better, climbing
    return found


def what_gave_way(case: FilmCase, outcome: Outcome, last: FilmState | None) -> Outcome:
    """Overload where a film seems to run away, or does not converge, although the last one there was, is cool.

    A gap that closes grows hot at its thinnest place without bound, whatever closed it: a tilted journal that
    touches at an edge is no matter of heat. Nor does a film converge where the last one is as good as closed.
    A film that is thick at the last has not closed: whether the search says so is a matter of round-off.

    Parameters
    ----------
    case : FilmCase
    outcome : Outcome
        Of the search under the whole load.
    last : FilmState or None
        Of `last_film`.
    """
    if last is None or last.thermal is None or case.oil_supply is None:
        return outcome
    left = last.solution.minimum_film_thickness / last.solution.film.clearance
    closed = Outcome.NOT_CONVERGED if left > OPEN else Outcome.OVERLOADED
    if outcome is Outcome.OVERLOADED:
        return closed
    thin = left <= CLOSED
    hot = outcome in (Outcome.THERMAL_RUNAWAY, Outcome.NO_LUBRICANT_DATA)
    if not hot and not (thin and outcome is Outcome.NOT_CONVERGED):
        return outcome
    fresh = case.oil_supply.temperature
    risen = last.thermal.maximum_temperature - fresh
    return outcome if risen > HOT * (highest_usable(case.lubricant) - fresh) else closed


def thermal_failure(case: FilmCase, found: Equilibrium[FilmState]) -> Notice:
    """What gave way, the last film that there was, and what to try."""
    outcome, code = found.outcome, found.outcome.code
    where = (
        Notice(code, "under_load", {"load": case.duty.load})
        if isinstance(case.duty, PrescribedLoad)
        else Notice(code, "at_position")
    )
    match outcome:
        case Outcome.OVERLOADED:
            far = Notice("S001", "thinnest", {"where": where})
        case Outcome.THERMAL_RUNAWAY:
            far = Notice("S002", "hottest", {"where": where, "ceiling": CEILING})
        case Outcome.NO_LUBRICANT_DATA:
            far = Notice("S005", "hottest", {"where": where, "lubricant": case.lubricant.name})
        case Outcome.NO_CLEARANCE:
            far = Notice("S003", "growth")
        case Outcome.STARVED_RECESS:
            return Notice("S302", "pocket")
        case Outcome.OUTSIDE_CLEARANCE:
            far = Notice("S006", "touches", {"where": where})
        case _:
            far = Notice(code, "not_together", {"where": where})
    last = "" if found.film is None else _last(case, code, found.film)
    if outcome is Outcome.THERMAL_RUNAWAY and case.heat is not None and case.heat.walls is None:
        return Notice("S002", "adiabatic", {"far": far, "last": last})
    if outcome is Outcome.NOT_CONVERGED and found.film is not None and _carries_all(case, found.film):
        return Notice("S004", "whole_load", {"far": far, "last": last})
    return Notice(code, "tried_film", {"far": far, "last": last})


def _carries_all(case: FilmCase, state: FilmState) -> bool:
    """Whether a film carries the load that is asked for; a lighter one is then no remedy."""
    return isinstance(case.duty, PrescribedLoad) and state.load >= 0.999 * case.duty.load


def _last(case: FilmCase, code: str, state: FilmState) -> Notice | str:
    if state.thermal is None:
        return ""
    place = Notice(code, "last_place", {
        "minimum_film_thickness": state.solution.minimum_film_thickness,
        "maximum_temperature": state.thermal.maximum_temperature,
    })  # fmt: skip
    if isinstance(case.duty, PrescribedLoad) and not _carries_all(case, state):
        return Notice(code, "last_load", {"load": state.load, "place": place})
    return Notice(code, "last_film", {"place": place})
