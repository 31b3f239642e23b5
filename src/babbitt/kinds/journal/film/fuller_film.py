"""Whether a film with temperatures of its own, or thinner oil, keeps what that of one temperature keeps."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from babbitt.core.notices import Effect, InputError, Notice
from babbitt.core.result import Check, Result
from babbitt.design.conditions import PrescribedLoad
from babbitt.design.missed_limit import missed_limit
from babbitt.kinds.journal.film.isothermal import FilmState, resolution_of
from babbitt.kinds.journal.film.layout import load_vector
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.orbit_results import orbit_of
from babbitt.kinds.journal.film.stable_equilibrium import converged_film, place_of

__all__ = ["film_over_viscosity", "misses_a_limit", "thinner_film", "thinner_orbit", "warnings_of_fuller_film"]

THINNER_OIL = 0.35
"""Viscosity over that of one temperature with which the film of a tilted journal must keep its limit where no film
with temperatures of its own is known, or that of the loaded film if less.

Assumption: the thinnest of 165 films of tilted journals, which a search climbed to, is as thick as with 0.39 of it
(docs/theory/procedure.md)."""


def warnings_of_fuller_film(
    result: Result, film: FilmCase | None, solve: Callable[[FilmCase], Result]
) -> Iterator[Notice]:
    """What a bearing of one temperature that misses no limit misses once its film has temperatures of its own.

    Parameters
    ----------
    result : Result
        Of one temperature, with its checks.
    film : FilmCase or None
        With temperatures of its own (`FilmCase.with_own_temperatures`); of None nothing is asked.
    solve : callable
        Result of a film.
    """
    if film is None or not result.keeps_all_limits:
        return
    try:
        told = tuple(_worse(result, solve(film)))
    except InputError as error:
        told = (Notice("W191", "no_thermal_film", {"outcome": error.message}),)
    if told:
        yield Notice("W191", "fuller", {"told": told})


def misses_a_limit(result: Result) -> bool:
    """Whether the film that a result is held against misses a limit, has no verdict, or is not found.

    A limit that is kept as the case sets it alone is missed, too (W219). Other remarks do not count.
    """
    told = (one for notice in result.warnings if notice.variant == "fuller" for one in notice.values["told"])
    return any(one.variant != "questioned" or any(map(_counts, one.values["remarks"])) for one in told)


def _counts(remark: Notice) -> bool:
    return remark.code == "W219" or remark.effect is Effect.NO_VERDICT


def _worse(result: Result, found: Result) -> Iterator[Notice]:
    """Limits that a film with temperatures of its own misses, and what questions it alone."""
    if not found.outcome.solved:
        yield Notice("W191", "no_thermal_film", {"outcome": found.outcome.value})
        return
    missed = tuple(missed_limit(one, "W191") for one in found.limits if not one.ok)
    yield from missed
    new = tuple(code for code in found.questioning_codes if code not in result.questioning_codes)
    if new and not missed:
        remarks = tuple(one for one in found.warnings if one.code in new)
        yield Notice("W191", "questioned", {"remarks": remarks, "codes": new})


def thinner_film(case: FilmCase, state: FilmState) -> Callable[[Check, float], Notice | None] | None:
    """What of the limits of the film a gap that tilt or form narrows does not keep with thinner oil.

    Tilt, a crowned bore and one that is out of round take the same length from the film however thick it is:
    ``h_min = c (1 - ε) - |slope| B/2`` at the edge of a tilted journal. The same change of ε takes a larger share
    of what is left, so that the film must be solved again. Asked where that with temperatures of its own is not
    known.

    Parameters
    ----------
    case : FilmCase
    state : FilmState
        Its film.

    Returns
    -------
    callable or None
        Of a check of film thickness, and the viscosity over that of the loaded film; None for other gaps, whose
        film goes at most with the viscosity, for a prescribed position, and without load.
    """
    if not case.bearing.is_narrowed or not isinstance(case.duty, PrescribedLoad) or case.duty.load == 0.0:
        return None
    return _with_thinner_oil(film_over_viscosity(case, state))


def thinner_orbit(case: FilmCase, state: FilmState) -> Callable[[Check, float], Notice | None] | None:
    """The same of the film thickness of an orbit: films with temperatures of their own bear steady loads alone."""
    return _with_thinner_oil(orbit_over_viscosity(case, state)) if case.bearing.is_narrowed else None


def _with_thinner_oil(over_viscosity: Callable[[float], float]) -> Callable[[Check, float], Notice | None]:
    def about(check: Check, thinner: float) -> Notice | None:
        factor = min(THINNER_OIL, 1.0 / thinner)
        thin = over_viscosity(factor)
        if thin <= 0.0:
            return Notice("W191", "no_film", {"margin": check.margin, "check": check.code, "factor": factor})
        if thin < check.limit:
            return Notice("W191", "narrowed_gap", {
                "margin": check.margin, "check": check.code, "factor": factor, "thin": thin,
            })  # fmt: skip
        return None

    return about


def film_over_viscosity(case: FilmCase, state: FilmState) -> Callable[[float], float]:
    """Least film thickness in m over a factor of the viscosity; 0 where no film is found.

    Parameters
    ----------
    case : FilmCase
        Of a given load.
    state : FilmState
        Its film; clearance, supply pressures and the bore, as it has given way, are kept.
    """
    assert isinstance(case.duty, PrescribedLoad)
    film, load, place = state.solution.film, load_vector(case, case.duty.load), place_of(state.solution)

    def thickness(factor: float) -> float:
        thin = replace(film, viscosity=factor * film.viscosity)
        found = converged_film(thin, load, resolution_of(case), place)
        return found.minimum_film_thickness if found.outcome.solved else 0.0

    return thickness


def orbit_over_viscosity(case: FilmCase, state: FilmState) -> Callable[[float], float]:
    """Least film thickness in m of an orbit over a factor of the viscosity; 0 where it does not close."""
    film = state.solution.film

    def thickness(factor: float) -> float:
        thin = replace(film, viscosity=factor * film.viscosity)
        orbit = orbit_of(case, replace(state, solution=replace(state.solution, film=thin)))
        return 0.0 if orbit is None or not orbit.outcome.solved else float(orbit.film_thickness.min())

    return thickness
