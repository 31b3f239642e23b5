"""Design check of one bearing by its film: from the inputs to values, verdicts and warnings."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from time import perf_counter

from babbitt.core.notices import Notice
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.result import Check, Matrix, Result
from babbitt.core.solution import Solution
from babbitt.design.bounds import certain, undecided
from babbitt.design.checks import (
    checks_not_made,
    clearance_check,
    limit_checks,
    pressure_check,
    pressure_not_checked,
)
from babbitt.design.conditions import PrescribedLoad, contact_film
from babbitt.design.failure import failure_of
from babbitt.design.feeding import Arrival
from babbitt.design.heat_balance import Equilibrium
from babbitt.design.oil import usable_viscosity
from babbitt.design.own_limits import asked_for_margins, checks_by_experience, missed_but_for_own
from babbitt.design.warnings import warnings_about_supply
from babbitt.kinds.journal.film.assumptions import film_assumptions, film_settings
from babbitt.kinds.journal.film.fuller_film import thinner_orbit, warnings_of_fuller_film
from babbitt.kinds.journal.film.grid_error import grid_errors
from babbitt.kinds.journal.film.isothermal import FilmState, under_found_load
from babbitt.kinds.journal.film.layout import closed_pockets, fed_all_around
from babbitt.kinds.journal.film.load_slope import confirmed_state, slope_not_asked, warnings_about_slope
from babbitt.kinds.journal.film.mixed_results import mixed_results
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.orbit_results import (
    orbit_checks,
    orbit_failure,
    orbit_of,
    orbit_rows,
    orbit_values,
    orbit_warnings,
)
from babbitt.kinds.journal.film.other_equilibria import (
    equilibrium_checks,
    equilibrium_points,
    equilibrium_values,
    flattered_by_equilibrium,
    warnings_about_equilibria,
)
from babbitt.kinds.journal.film.thermal_failure import thermal_failure
from babbitt.kinds.journal.film.thermal_film import film_within_ducts
from babbitt.kinds.journal.film.thermal_results import (
    settings_found,
    stiffness_values,
    thermal_rows,
    warnings_about_heat,
    with_own_coefficients,
)
from babbitt.kinds.journal.film.transition import transition_speed
from babbitt.kinds.journal.film.unloaded import NO_LOAD, missing_without_load
from babbitt.kinds.journal.film.values import fills_of, film_values, rows_of, supply_pressures, tilt_values
from babbitt.kinds.journal.film.warnings import film_warnings
from babbitt.kinds.journal.film.whirl import whirl_of
from babbitt.kinds.journal.limits_of_clearance import held_at_limits
from babbitt.kinds.journal.one_temperature import warnings_about_margins
from babbitt.reynolds.model import Cavitation
from babbitt.reynolds.stability.whirl_checks import (
    missing_thresholds,
    whirl_checks,
    whirl_values,
    without_critical_mass,
)
from babbitt.reynolds.stability.whirl_limits import Whirl

METHOD = "film"

OF_TILT = ("tilt_stiffness", "tilt_damping", "film_moment_x", "film_moment_y")
"""What `tilt_coefficients` asks for."""

LIMITING_SPEEDS = {
    "transition_speed": "transition_film_thickness",
    "threshold_speed": "whirl_frequency_ratio",
    "threshold_speed_elastic": "shaft_stiffness",
}
"""Speeds that a case may leave out, each with the result beside which it stands."""

SPEED_NOT_ASKED = "not looked for, as limiting_speeds: false asks"
"""Why such a speed is missing."""

NO_CALM_FILM = "no film was found at this position without the supply pressure; only their sum is known"
"""Why the flows by film pressure and by supply pressure are missing."""


def film_check(case: FilmCase, watch: ProgressCallback = no_progress) -> Result:
    """Solve the film of a bearing by its thermal model; see `film_solution`."""
    return film_solution(case, watch).result


def film_solution(case: FilmCase, watch: ProgressCallback = no_progress) -> Solution:
    """Solve a film as `film_by_its_model`, and say what one with temperatures of its own misses of its limits.

    What keeps its limits at a mean clearance is solved at the limits of that, too.
    """
    found = _held_against_fuller(case, watch)
    held = held_at_limits(case, found.result, lambda other: _held_against_fuller(other, no_progress).result)
    return replace(found, result=held)


def _held_against_fuller(case: FilmCase, watch: ProgressCallback) -> Solution:
    """A film at one clearance, and what one with temperatures of its own misses of its limits."""
    found = film_by_its_model(case, watch)
    return replace(found, result=beside_fuller_film(found.result, case.with_own_temperatures()))


def beside_fuller_film(result: Result, film: FilmCase | None) -> Result:
    """A result of one temperature with what a film with temperatures of its own misses of its limits."""
    told = tuple(warnings_of_fuller_film(result, film, lambda other: film_by_its_model(other).result))
    return replace(result, warnings=(*result.warnings, *told)) if told else result


def film_by_its_model(case: FilmCase, watch: ProgressCallback = no_progress) -> Solution:
    """Solve the film of a bearing by its thermal model.

    Parameters
    ----------
    case : FilmCase
    watch : ProgressCallback
        Follows the cycles of an orbit.

    Returns
    -------
    Solution
        Its result has a status in every case; the values of an unsolved case describe the last film reached. Its
        state is the `FilmState` at the equilibrium position, or None where no film was found.

    Notes
    -----
    Without a heat model (``case.heat``) the film has one viscosity, that at the effective temperature. As in
    ISO 7902 the oil enters with ``T_en``, leaves with ``T_ex``, and ``T_eff`` is the mean of both; without oil
    supply ``T_eff`` is that of the bearing.
    """
    start = perf_counter()
    asked = case
    case, found, beyond = film_within_ducts(case)
    if beyond is not None:
        case = replace(case, warnings=(*case.warnings, *_warnings_about_ducts(asked, case, beyond)))
    outcome = found.outcome
    failed = None if outcome.solved else _failure(case, found)
    values: dict[str, float] = {}
    checks: tuple[Check, ...] = ()
    warnings = case.warnings
    not_made: tuple[Notice, ...] = ()
    arrays, settings = {}, film_settings(case)
    no_mass = no_tilt = whirl = None
    solved = None
    if found.film is not None:
        state, slope = confirmed_state(case, found.film)
        solved = state
        frozen, values, followed = state, film_values(case, state), True
        if case.cavitation is not Cavitation.HALF_SOMMERFELD:
            arrays = {"stiffness": rows_of(state.solution.stiffness), "damping": rows_of(state.solution.damping)}
        if state.fed is not None:
            arrays["supply_fill"] = (fills_of(case, state.fed),)
        if closed_pockets(case):
            arrays["groove_angles"] = (tuple(feed.angle for feed in case.bearing.feeds),)
            arrays["groove_pressures"] = (supply_pressures(case, state.solution.film),)
        if outcome.solved:
            if case.tilt_coefficients and not closed_pockets(case):
                from babbitt.reynolds.surface.tilt_coefficients import tilt_coefficients

                tilt = tilt_coefficients(state.solution, case.accuracy.resolution)
                if tilt.outcome.solved:
                    arrays |= {"tilt_stiffness": rows_of(tilt.stiffness), "tilt_damping": rows_of(tilt.damping)}
                    values |= tilt_values(tilt, state.load * case.bearing.width)
            no_tilt = _without_tilt(case, arrays)
            if state.thermal is not None:
                arrays |= thermal_rows(case, state.thermal)
                state, followed = with_own_coefficients(case, state)
                arrays["stiffness"] = rows_of(state.solution.stiffness)
                settings |= settings_found(case, followed)
                if state is not frozen:
                    arrays["frozen_stiffness"] = rows_of(frozen.solution.stiffness)
            loaded = under_found_load(case, state)
            whirl = whirl_of(loaded, frozen) if case.cavitation is not Cavitation.HALF_SOMMERFELD else None
            values |= _running_values(loaded, state, whirl)
            values |= grid_errors(case, state) if case.error_estimate else {}
            places = equilibrium_points(case, state) if case.heat is None else None
            values |= equilibrium_values(places)
            no_mass = without_critical_mass(whirl)
            limits = (*film_limits(case, values), *equilibrium_checks(case, values))
            flattered = flattered_by_equilibrium(case, state.solution)
            checks = (*certain(limits, flattered), *whirl_checks(case, whirl), clearance_check(case, values))
            not_made = (
                *checks_not_made(case, values),
                *pressure_not_checked(case),
                *undecided(limits, flattered),
                *slope_not_asked(frozen, slope),
                *((no_mass,) if no_mass else ()),
            )
            warnings = (
                *film_warnings(case, state, values, checks, whirl),
                *warnings_about_slope(case, slope),
                *((no_tilt,) if no_tilt else ()),
            )
            if state.thermal is not None:
                values |= stiffness_values(state)
                warnings = (*warnings, *warnings_about_heat(case, state, values, followed))
            if isinstance(case.duty, PrescribedLoad):
                warnings = (*warnings, *warnings_about_equilibria(state.solution, places))
            mixed = mixed_results(case, state)
            values |= mixed.values
            arrays |= mixed.arrays
            warnings = (*warnings, *mixed.warnings)
            orbit = orbit_of(case, state, watch)
            if orbit is not None:
                outcome = orbit.outcome
                failed = None if outcome.solved else orbit_failure(case, orbit)
                values |= orbit_values(case, orbit)
                arrays["orbit"] = orbit_rows(orbit)
                on_orbit = tuple(orbit_checks(checks, values))
                of_film, checks = checks, (*checks, *on_orbit)
                replaced = checks_by_experience(case, values)
                own = missed_but_for_own(on_orbit, orbit_checks(replaced, values), "orbit")
                held = tuple(orbit_checks(asked_for_margins(of_film, replaced), values))
                near = _about_margins_on_orbit(case, state, held, values)
                warnings = (*warnings, *orbit_warnings(case, orbit, values), *near, *own)
        values |= _supply_of_ducts(asked, beyond)
        values["iterations"] = float(found.evaluations)
    values["wall_time"] = perf_counter() - start
    without_load = missing_without_load(case, found.film)
    result = Result(
        case.name,
        case.kind,
        METHOD,
        outcome,
        {name: float(value) for name, value in values.items() if not math.isnan(value)},
        checks,
        warnings,
        not_made,
        (*case.assumed_of_lubricant, *case.assumptions, *film_assumptions(case)),
        settings,
        arrays,
        {name: NO_CALM_FILM for name in ("side_flow", "supply_flow") if math.isnan(values.get(name, 0.0))}
        | ({"critical_mass": no_mass.message} if no_mass else {})
        | (dict.fromkeys(OF_TILT, no_tilt.message) if no_tilt else {})
        | _missing_speeds(case, values, whirl, without_load)
        | without_load,
        failed,
    )
    return Solution(asked, result, solved)


def _failure(case: FilmCase, found: Equilibrium[FilmState]) -> Notice:
    """Why there is no film, and what of a given flow that feeds grooves around the whole bore."""
    failed = failure_of(case, found) if case.heat is None else thermal_failure(case, found)
    flooded = case.oil_supply is not None and case.oil_supply.flow is not None and fed_all_around(case)
    return Notice("S001", "all_around", {"failed": failed}) if flooded and failed.code == "S001" else failed


def _warnings_about_ducts(asked: FilmCase, case: FilmCase, beyond: Arrival) -> Iterator[Notice]:
    """Report a film that would draw more oil than tubes and holes pass, and of one not limited to that."""
    yield from warnings_about_supply(beyond.limit, beyond.flow)
    if case is asked:
        yield Notice("W186")


def _supply_of_ducts(asked: FilmCase, beyond: Arrival | None) -> dict[str, float]:
    """The supply of a film whose tubes and holes pass less than it would draw; else empty."""
    if beyond is None or beyond.limit is None or asked.oil_supply is None:
        return {}
    return {
        "supply_pressure": asked.oil_supply.pressure,
        "element_pressure": beyond.element_pressure,
        "tube_loss": beyond.tube_loss,
        "hole_loss": beyond.hole_loss,
        "supply_limit": beyond.limit,
    }


def _without_tilt(case: FilmCase, arrays: Mapping[str, Matrix]) -> Notice | None:
    """Why coefficients of tilt that were asked for are not given; None where they are, or were not asked for."""
    if not case.tilt_coefficients or "tilt_stiffness" in arrays:
        return None
    return Notice("W197", "closed" if closed_pockets(case) else "not_found")


def _running_values(case: FilmCase, state: FilmState, whirl: Whirl | None) -> dict[str, float]:
    values = {} if whirl is None else whirl_values(case, whirl)
    contact = contact_film(case) if case.limiting_speeds else None
    slow = transition_speed(case, state, contact) if contact is not None else None
    if slow is not None:
        values["transition_speed"] = slow
    return values


def _missing_speeds(
    case: FilmCase, values: Mapping[str, float], whirl: Whirl | None, without_load: Collection[str]
) -> dict[str, str]:
    """The speeds that were not looked for or not found, each with the reason."""
    if case.limiting_speeds:
        sought = missing_thresholds(whirl) if whirl is not None and case.whirl_speed else {}
        return dict.fromkeys(sought, NO_LOAD) if without_load else sought
    return {name: SPEED_NOT_ASKED for name, known_by in LIMITING_SPEEDS.items() if known_by in values}


def film_limits(case: FilmCase, values: dict[str, float]) -> Iterator[Check]:
    """Those of every method; a film that was solved as turbulent need not be laminar."""
    yield from (one for one in limit_checks(case, values) if one.code != "C110" or case.turbulence is None)
    yield from pressure_check(case, values)


def _about_margins_on_orbit(
    case: FilmCase, state: FilmState, checks: tuple[Check, ...], values: dict[str, float]
) -> Iterator[Notice]:
    """Limits that the worst instants of an orbit keep by less than one temperature can show."""
    if case.heat is None:
        narrowed = thinner_orbit(case, state)
        yield from warnings_about_margins(checks, values, (), usable_viscosity(case.lubricant), narrowed)
