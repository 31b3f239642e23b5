"""The film of a journal whose gap is narrowed at places, with temperatures of its own, or with thinner oil."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.conditions import PrescribedLoad
from babbitt.design.heat_balance import Equilibrium
from babbitt.kinds.journal.film.isothermal import FilmState, resolution_of
from babbitt.kinds.journal.film.layout import load_vector
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.orbit_results import orbit_of
from babbitt.kinds.journal.film.stable_equilibrium import converged_film, place_of
from babbitt.kinds.journal.film.thermal_film import film_within_ducts
from babbitt.reynolds.model import Cavitation

__all__ = ["film_over_viscosity", "narrowed_gap", "narrowed_gap_of_orbit"]

THINNER_OIL = 0.35
"""Viscosity over that of one temperature with which the film of a tilted journal must keep its limit where no film
with temperatures of its own is known, or that of the loaded film if less.

Assumption: the thinnest of 165 films of tilted journals, which a search climbed to, is as thick as with 0.39 of it
(docs/theory/procedure.md)."""


def narrowed_gap(case: FilmCase, state: FilmState) -> Callable[[Check, float], Notice | None] | None:
    """What of the limits of film and metal a gap that tilt or form narrows does not keep beyond one temperature.

    Tilt, a crowned bore and one that is out of round take the same length from the film however thick it is:
    ``h_min = c (1 - ε) - |slope| B/2`` at the edge of a tilted journal. The same change of ε takes a larger share
    of what is left, so that the film must be solved again: with temperatures of its own and walls that conduct
    (``case.fuller``), or where these are not known with thinner oil.

    Parameters
    ----------
    case : FilmCase
    state : FilmState
        Its film.

    Returns
    -------
    callable or None
        Of a check of film thickness or metal, and the viscosity over that of the loaded film; None for other gaps,
        whose film goes at most with the viscosity, for a prescribed position, and without load.
    """
    if not case.bearing.is_narrowed or not isinstance(case.duty, PrescribedLoad) or case.duty.load == 0.0:
        return None
    if case.fuller is not None:
        return _with_own_temperatures(case)
    return _with_thinner_oil(film_over_viscosity(case, state))


def narrowed_gap_of_orbit(case: FilmCase, state: FilmState) -> Callable[[Check, float], Notice | None] | None:
    """What of the film thickness of an orbit a narrowed gap does not keep with thinner oil; None for other gaps.

    Films with temperatures of their own are known under steady loads alone.
    """
    return _with_thinner_oil(orbit_over_viscosity(case, state)) if case.bearing.is_narrowed else None


def _with_own_temperatures(case: FilmCase) -> Callable[[Check, float], Notice | None]:
    @cache
    def thermal() -> Equilibrium[FilmState]:
        return film_within_ducts(of_own_temperatures(case))[1]

    def about(check: Check, _: float) -> Notice | None:
        found = thermal()
        if check.is_in_kelvin:
            hottest = 0.0 if found.film is None else hottest_bush(found.film)
            if not found.outcome.solved or hottest <= check.limit:
                return None
            return Notice("W191", "thermal_bush", {
                "margin": check.limit - check.value, "check": check.code, "hottest": hottest,
            })  # fmt: skip
        if not found.outcome.solved or found.film is None:
            return Notice("W191", "no_thermal_film", {
                "margin": check.margin, "check": check.code, "outcome": found.outcome.value,
            })  # fmt: skip
        thin = found.film.solution.minimum_film_thickness
        if thin < check.limit:
            return Notice("W191", "thermal_film", {"margin": check.margin, "check": check.code, "thin": thin})
        return None

    return about


def hottest_bush(state: FilmState) -> float:
    """Highest temperature of the bush of a film with temperatures of its own, K."""
    return 0.0 if state.thermal is None else float(state.thermal.bush_temperature.max())


def of_own_temperatures(case: FilmCase) -> FilmCase:
    """The case with a film that conserves its oil and has its own temperatures, and nothing besides it."""
    return replace(
        case, heat=case.fuller, fuller=None, cavitation=Cavitation.MASS_CONSERVING, changing_load=None,
        asperities=None, tilt_coefficients=False, error_estimate=False, limiting_speeds=False, friction_factor=1.0,
    )  # fmt: skip


def _with_thinner_oil(over_viscosity: Callable[[float], float]) -> Callable[[Check, float], Notice | None]:
    def about(check: Check, thinner: float) -> Notice | None:
        if check.is_in_kelvin:
            return None
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
