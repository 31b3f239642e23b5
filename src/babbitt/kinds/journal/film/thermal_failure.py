"""Where a film with its own temperatures gave way: the largest load that still had a film, and words for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from babbitt.core.notices import explanations
from babbitt.core.result import Outcome
from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.conditions import PrescribedLoad
from babbitt.design.failure import STARVED, STARVED_REMEDY
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
    """Overload where a film seems to run away, or does not come to rest, although the last one there was, is cool.

    A gap that closes grows hot at its thinnest place without bound, whatever closed it: a tilted journal that
    touches at an edge is no matter of heat. Nor does a film come to rest where the last one is as good as closed.
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


def thermal_failure(case: FilmCase, found: Equilibrium[FilmState]) -> str:
    """Say what gave way, the last film that there was, and what to try."""
    load = (
        f" under {_kilonewtons(case.duty.load)} kN"
        if isinstance(case.duty, PrescribedLoad)
        else " at this position"
    )
    match found.outcome:
        case Outcome.OVERLOADED:
            far = f"no film with its own temperatures was found{load}: its thinnest place closes"
        case Outcome.THERMAL_RUNAWAY:
            far = f"the film{load} would be hotter than {CEILING - ZERO_CELSIUS:.0f} °C somewhere"
        case Outcome.NO_LUBRICANT_DATA:
            far = f"the film{load} would be hotter than the laws of {case.lubricant.name} reach"
        case Outcome.NO_CLEARANCE:
            far = "the clearance is used up by thermal growth"
        case Outcome.STARVED_RECESS:
            return f"{STARVED}. Try: {STARVED_REMEDY}"
        case Outcome.OUTSIDE_CLEARANCE:
            far = f"{load.strip()} the journal would touch or cut the bore"
        case _:
            far = f"film, temperatures and journal{load} did not come to rest together"
    remedy = explanations()[found.outcome.code].remedy
    adiabatic = case.heat is not None and case.heat.walls is None
    if adiabatic and found.outcome is Outcome.THERMAL_RUNAWAY:
        remedy = f"`thermal: full`, for walls cool a film as thin as this; {remedy[0].lower()}{remedy[1:]}"
    return f"{far}{_last(case, found.film)}. Try: {remedy[0].lower()}{remedy[1:]}"


def _last(case: FilmCase, state: FilmState | None) -> str:
    if state is None or state.thermal is None:
        return ""
    least = state.solution.minimum_film_thickness * 1e6
    hottest = state.thermal.maximum_temperature - ZERO_CELSIUS
    there = f"h_min = {least:.3g} µm, hottest place {hottest:.0f} °C"
    if isinstance(case.duty, PrescribedLoad) and state.load < 0.999 * case.duty.load:
        return f". The largest load with a film was about {_kilonewtons(state.load)} kN, with {there}"
    return f". The last film that settled had {there}"


def _kilonewtons(force: float) -> str:
    """A force in kN, with three digits and no exponent."""
    return f"{force / 1e3:.0f}" if force >= 1e5 else f"{force / 1e3:.3g}"
