"""What a film with temperatures of its own keeps, or one with thinner oil, where estimates cannot tell."""

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
from babbitt.kinds.journal.film.load_slope import confirmed_state
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.orbit_results import orbit_of
from babbitt.kinds.journal.film.stable_equilibrium import converged_film, place_of
from babbitt.kinds.journal.film.thermal_film import film_within_ducts
from babbitt.reynolds.model import Cavitation
from babbitt.reynolds.stability.rotor import RIGID, stable_masses_of_rotor

__all__ = ["film_over_viscosity", "fuller_film", "thinner_orbit"]

THINNER_OIL = 0.35
"""Viscosity over that of one temperature with which the film of a tilted journal must keep its limit where no film
with temperatures of its own is known, or that of the loaded film if less.

Assumption: the thinnest of 165 films of tilted journals, which a search climbed to, is as thick as with 0.39 of it
(docs/theory/procedure.md)."""


def fuller_film(case: FilmCase, state: FilmState) -> Callable[[Check, float], Notice | None] | None:
    """What of the limits of film, metal and rotor a bearing does not keep beyond one temperature.

    Asked of a gap that is narrowed, and of a rotor of known mass. Tilt, a crowned bore and one that is out of
    round take the same length from the film however thick it is: ``h_min = c (1 - ε) - |slope| B/2`` at the edge
    of a tilted journal. The same change of ε takes a larger share of what is left. And where the critical mass
    rises steeply with ε, or a hole feeds the film, that of films with temperatures of their own is anything from
    a fifth to many times as large. So the film must be solved again: with temperatures of its own and walls that
    conduct (``case.fuller``), or, of a narrowed gap where these are not known, with thinner oil.

    Parameters
    ----------
    case : FilmCase
    state : FilmState
        Its film.

    Returns
    -------
    callable or None
        Of a check of film thickness, metal or mass of the rotor, and the viscosity over that of the loaded film;
        None for others, whose film goes at most with the viscosity, for a prescribed position, and without load.
    """
    if not isinstance(case.duty, PrescribedLoad) or (case.fuller is None and not case.bearing.is_narrowed):
        return None
    if case.duty.load == 0.0:
        return None
    if case.fuller is not None:
        return _with_own_temperatures(case)
    return _with_thinner_oil(film_over_viscosity(case, state))


def thinner_orbit(case: FilmCase, state: FilmState) -> Callable[[Check, float], Notice | None] | None:
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
        if check.code == "C115":
            return _about_mass(case, check, found)
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


def _about_mass(case: FilmCase, check: Check, found: Equilibrium[FilmState]) -> Notice | None:
    """Whether the rotor whirls in a film with temperatures of its own, at one of the bounds of its mass."""
    if not found.outcome.solved or found.film is None:
        return None
    film = confirmed_state(of_own_temperatures(case), found.film)[0].solution
    elastic = check.quantity.endswith("_elastic")
    shaft = case.shaft_stiffness if elastic and case.shaft_stiffness is not None else RIGID
    stable = stable_masses_of_rotor(film.stiffness, film.damping, shaft)
    if stable.reserve(check.limit) >= 1.0:
        return None
    heavy = check.limit > stable.greatest
    return Notice("W191", "thermal_critical_mass" if heavy else "thermal_least_mass", {
        "margin": check.margin, "check": check.code, "mass": stable.greatest if heavy else stable.least,
    })  # fmt: skip


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
