"""From a case to its result: films, values, checks, warnings."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from time import perf_counter

from babbitt.core.notices import InputError, Notice
from babbitt.core.result import Bound, Check, Outcome, Result
from babbitt.core.solution import Solution
from babbitt.core.units import ZERO_CELSIUS
from babbitt.design.bounds import Bounds, certain, undecided
from babbitt.design.checks import checks_not_made, limit_checks
from babbitt.design.heat_balance import Equilibrium
from babbitt.design.own_limits import asked_for_margins, checks_by_experience, missed_but_for_own
from babbitt.design.turbulence import ALL_TURBULENT
from babbitt.kinds.tilting_pad_journal.cross_coupling import (
    SOUGHT,
    CrossCoupling,
    cross_coupling_of,
    with_decrements_over_speed,
)
from babbitt.kinds.tilting_pad_journal.dynamics import PadDynamics, dynamics_of
from babbitt.kinds.tilting_pad_journal.failure import failure_of_pads, feasible_growth
from babbitt.kinds.tilting_pad_journal.film import operating_films
from babbitt.kinds.tilting_pad_journal.fuller_model import warnings_of_fuller_model
from babbitt.kinds.tilting_pad_journal.level_one import (
    about_synchronous_verdict,
    cross_coupling_checks,
    cross_coupling_not_checked,
    cross_coupling_rows,
    cross_coupling_values,
    pedestal_rows,
    pedestal_values,
)
from babbitt.kinds.tilting_pad_journal.margins import PadMargin, pad_margins
from babbitt.kinds.tilting_pad_journal.model import PadCase, Thermal
from babbitt.kinds.tilting_pad_journal.one_temperature import warnings_about_one_temperature
from babbitt.kinds.tilting_pad_journal.sensitivity import with_sensitivity
from babbitt.kinds.tilting_pad_journal.state import PadFilms
from babbitt.kinds.tilting_pad_journal.thermal_assumptions import thermal_assumptions
from babbitt.kinds.tilting_pad_journal.thermal_values import thermal_rows, thermal_values
from babbitt.kinds.tilting_pad_journal.values import (
    dynamic_rows,
    dynamic_values,
    eccentricity_ratio,
    film_values,
    pad_rows,
)
from babbitt.kinds.tilting_pad_journal.warnings import (
    about_stability_on_the_ramp,
    starved_bounds,
    warnings_about_kept_limits,
    warnings_of_solution,
)
from babbitt.reynolds.tilting_pads.pivots import RockerContact

__all__ = ["LEAST_DECREMENT", "PadSolutionState", "judged", "least_decrement", "pad_solution", "refuse_starvation"]

METHOD = "film"

LEAST_DECREMENT = 0.1
DECREMENT_SOURCE = "least log decrement of API 617, as API RP 684 explains it"
USER = "limit set in the case"
LARGEST_HEAT_ERROR = 1e-3
"""Of the heat balance of films with their own temperatures, over the heat made."""
LAMINAR = "C110"
"""The check of other methods that the film is laminar; here W407 reports it."""


@dataclass(frozen=True, eq=False)
class PadSolutionState:
    """What stands behind a result: films, dynamics, margins.

    Attributes
    ----------
    films : PadFilms
    dynamics : PadDynamics
    margins : tuple of PadMargin
    cross_coupling : CrossCoupling or None
        None where the case anticipates none.
    """

    films: PadFilms
    dynamics: PadDynamics
    margins: tuple[PadMargin, ...]
    cross_coupling: CrossCoupling | None = None


def pad_solution(case: PadCase) -> Solution:
    """Solve one bearing, and ask what other models and numbers make of it.

    Returns
    -------
    Solution
        Its result has a status in every case; its state is a `PadSolutionState`, None without equilibrium.

    Raises
    ------
    InputError
        E101 where the supply is less than what leaves by the sides of the pads.
    """
    found = judged(case)
    result, state = found.result, found.state
    if state is None:
        return found
    if state.cross_coupling is not None:
        driven = with_decrements_over_speed(case, state.cross_coupling)
        result = replace(result, arrays={**result.arrays, **cross_coupling_rows(driven)})
        state = replace(state, cross_coupling=driven)
    if case.assumption_sensitivity:
        result = with_sensitivity(case, result, lambda other: by_its_model(other)[0])
    return Solution(case, result, state)


def judged(case: PadCase) -> Solution:
    """Solve one bearing, with what its fuller model says of the limits; nothing at other speeds or numbers.

    Raises
    ------
    InputError
        As of `pad_solution`.
    """
    result, state = by_its_model(case)
    if state is None:
        return Solution(case, result)
    told = warnings_of_fuller_model(case, state.films, result, result_and_films)
    return Solution(case, replace(result, warnings=(*result.warnings, *told)), state)


def result_and_films(case: PadCase) -> tuple[Result, PadFilms | None]:
    """A bearing by its own model; no films without equilibrium."""
    result, state = by_its_model(case)
    return result, None if state is None else state.films


def by_its_model(case: PadCase) -> tuple[Result, PadSolutionState | None]:
    """Films, dynamics and checks of a bearing; no state without equilibrium."""
    begun = perf_counter()
    found = operating_films(case)
    if found.film is None or not found.outcome.solved:
        return unsolved(case, found, perf_counter() - begun), None
    films = found.film
    refuse_starved(case, films)
    margins = pad_margins(case, films.solution)
    dynamics = dynamics_of(case, films.solution)
    driven = cross_coupling_of(case, dynamics.full)
    values = film_values(case, films, margins) | thermal_values(case, films) | dynamic_values(case, dynamics)
    values |= pedestal_values(case, films) | cross_coupling_values(driven)
    values |= {"iterations": float(found.evaluations), "wall_time": perf_counter() - begun}
    bounds = starved_bounds(case, films)
    heat = tuple(heat_checks(case, values))
    checks = (
        *checks_of(case, values, bounds),
        *stability_checks(case, values),
        *certain(heat, bounds),
        *cross_coupling_checks(case, values, *least_decrement(case)),
    )
    usual = replace(case, least_log_decrement=None)
    replaced = (
        *checks_by_experience(case, values),
        *stability_checks(usual, values),
        *cross_coupling_checks(usual, values, *least_decrement(usual)),
    )
    held = asked_for_margins(checks, replaced)
    told = tuple(warnings_of_solution(case, films, dynamics, margins, values))
    return Result(
        case.name,
        case.kind,
        METHOD,
        Outcome.CONVERGED,
        {name: float(value) for name, value in values.items() if math.isfinite(value)},
        checks=checks,
        warnings=(
            *case.warnings,
            *told,
            *about_stability_on_the_ramp(checks, told),
            *missed_but_for_own(checks, replaced),
            *warnings_about_kept_limits(films, held),
            *warnings_about_one_temperature(case, held, values),
            *about_synchronous_verdict(values, [least_decrement(one)[0] for one in (case, usual)]),
        ),
        not_checked=(
            *checks_not_made(case, values, bounds),
            *not_checked_here(case, values),
            *cross_coupling_not_checked(case, values),
            *undecided(heat, bounds),
        ),
        assumptions=(*case.assumed_of_lubricant, *case.assumptions, *assumptions_of(case)),
        settings=settings_of(case, dynamics),
        arrays=pad_rows(case, films.solution)
        | thermal_rows(case, films)
        | dynamic_rows(case, dynamics)
        | cross_coupling_rows(driven)
        | pedestal_rows(case, dynamics),
        missing=missing_of(case, values),
    ), PadSolutionState(films, dynamics, margins, driven)


def unsolved(case: PadCase, found: Equilibrium[PadFilms], time: float) -> Result:
    """The result of a bearing without equilibrium, with the last place that was reached."""
    last: dict[str, float] = {"wall_time": time}
    warnings = case.warnings
    if found.film is not None:
        solution = found.film.solution
        last |= {
            "eccentricity_ratio": eccentricity_ratio(case, solution),
            "minimum_film_thickness": solution.minimum_film_thickness,
            "effective_temperature": found.film.temperature,
        }
        if (share := feasible_growth(found)) is not None:
            last["growth_share"] = share
            warnings = (*warnings, Notice("W406", values={"growth_share": share}))
    return Result(
        case.name, case.kind, METHOD, found.outcome, last, warnings=warnings,
        assumptions=(*case.assumed_of_lubricant, *case.assumptions, *assumptions_of(case)),
        settings=settings_of(case, None), failure=failure_of_pads(case, found),
    )  # fmt: skip


def refuse_starvation(case: PadCase) -> None:
    """Refuse a supply that starves the pads, which their films tell; asked only where a flow is given.

    Raises
    ------
    InputError
        E101.
    """
    if case.oil_supply is None or case.oil_supply.flow is None:
        return
    found = operating_films(case)
    if found.film is not None and found.outcome.solved:
        refuse_starved(case, found.film)


def refuse_starved(case: PadCase, films: PadFilms) -> None:
    """Refuse a supply less than what leaves by the sides: with all else carried over the pads still starve."""
    given = None if case.oil_supply is None else case.oil_supply.flow
    least = films.solution.side_flow
    if given is not None and given < least:
        said = f"{case.name}: supply.flow is {given * 6e4:.4g} L/min, and {least * 6e4:.4g} L/min"
        raise InputError(
            "E101",
            f"{said} leave by the sides of the pads alone: they starve, whatever is carried over. Give more than "
            "that, or leave flow out for pads that get what they draw in.",
        )


def checks_of(case: PadCase, values: Mapping[str, float], bounds: Bounds) -> Iterator[Check]:
    """Film, load, temperature and metal, as of every journal bearing."""
    yield from (one for one in limit_checks(case, values, bounds) if one.code != LAMINAR)


def stability_checks(case: PadCase, values: Mapping[str, float]) -> Iterator[Check]:
    """Log decrement of the rotor, and what every pad is short of being unloaded."""
    if "log_decrement" in values:
        limit, source = least_decrement(case)
        yield Check("C401", "log_decrement", values["log_decrement"], limit, Bound.AT_LEAST, source)
    if "least_pad_margin" in values:
        source = "eccentricity ratio at the pivot, at which a pad unloads"
        yield Check("C402", "least_pad_margin", values["least_pad_margin"], 0.0, Bound.AT_LEAST, source, True)


def least_decrement(case: PadCase) -> tuple[float, str]:
    """Least log decrement, and where it comes from."""
    own = case.least_log_decrement
    return (LEAST_DECREMENT, DECREMENT_SOURCE) if own is None else (own, USER)


def heat_checks(case: PadCase, values: Mapping[str, float]) -> Iterator[Check]:
    """Heat balance of films with their own temperatures, and what a probe in a pad may read."""
    if "film_dissipation" not in values:
        return
    error, source = abs(values["energy_balance_error"]), "heat that the films make, by what takes it"
    yield Check("C403", "energy_balance_error", error, LARGEST_HEAT_ERROR, Bound.AT_MOST, source, True)
    for code, limit in (("C404", case.probe_alarm), ("C405", case.probe_trip)):
        if limit is not None:
            yield Check(code, "probe_temperature", values["probe_temperature"], limit, Bound.AT_MOST, USER)


def not_checked_here(case: PadCase, values: Mapping[str, float]) -> Iterator[Notice]:
    """Which of these lack data."""
    if "log_decrement" not in values:
        yield Notice("C401")
    if "least_pad_margin" not in values:
        yield Notice("C402")
    if any(isinstance(pad.pivot, RockerContact) for pad in case.bearing.pads):
        yield Notice("C409")
    if case.thermal.is_resolved:
        return
    if case.probe_alarm is not None:
        yield Notice("C404")
    if case.probe_trip is not None:
        yield Notice("C405")


def settings_of(case: PadCase, dynamics: PadDynamics | None) -> dict[str, str]:
    """Choices that the numbers depend on, and what the rows of the matrices of journal and pads are."""
    named = {
        "lubricant": case.lubricant.name,
        "thermal": case.thermal.value,
        "accuracy": case.accuracy.value,
        "feed": case.feed.kind,
        "cavitation": "reynolds",
        "turbulence": "laminar" if case.turbulence is None else case.turbulence.name,
    }
    if dynamics is not None:
        named["motions"] = ", ".join(dynamics.full.labels)
    return named


def assumptions_of(case: PadCase) -> Iterator[str]:
    """What is assumed of every bearing of this kind."""
    if not case.thermal.is_resolved:
        yield (
            "Films of one viscosity that rupture where pressure and its gradient vanish (Reynolds); pads tilt "
            f"without friction about their pivots alone, in the plane of the bearing; {shapes_of(case)}; ambient "
            "or groove pressure on all edges of a pad."
        )
    if case.turbulence is not None:
        yield (
            f"Turbulence after {case.turbulence.name}: films are laminar up to the local Reynolds number "
            f"41.3 sqrt(R/c) of the widest pad, fully turbulent from {ALL_TURBULENT:g} times that."
        )
    yield "The moment of the shear on a pad about its pivot is left out, as in published tables."
    yield (
        "Stiffness and damping are synchronous: pads follow at the frequency of the rotation; viscosity and the "
        "extent of the films stay as at rest."
    )
    yield "An unloaded pad stands concentric with its bore: it carries nothing and shears the oil that it passes."
    if case.thermal is Thermal.GLOBAL:
        yield (
            f"One temperature for all films; {case.feed.carry_over:.0%} of the oil that leaves a pad over its "
            "trailing edge enters the next; all heat goes with the oil."
        )
    if case.thermal.is_resolved:
        yield from thermal_assumptions(case)
    if case.thermal is not Thermal.ISOTHERMAL and not case.assumption_sensitivity:
        yield (
            "How far carry-over, and what else is assumed of the heat, moves the answer: method: "
            "{assumption_sensitivity: true}."
        )


def shapes_of(case: PadCase) -> str:
    """How the pads of films of one temperature keep their shapes."""
    if not any(pad.bends for pad in case.bearing.pads):
        return "rigid pads"
    return (
        "pads bend by pressure, at rest and in motion, along the one shape that an even pressure gives a beam "
        "held at the pivot; where they unload is that of their round bores"
    )


def missing_of(case: PadCase, values: Mapping[str, float]) -> dict[str, str]:
    """Values that belong to the result and were not found, and why."""
    missing = {}
    if case.rotor_mass is not None and "threshold_mass" not in values:
        missing["threshold_mass"] = "no mass up to a thousand times that of the rotor is unstable"
    if case.anticipated_cross_coupling is not None and "critical_cross_coupling" not in values:
        missing["critical_cross_coupling"] = (
            f"no cross-coupling up to {SOUGHT[1]:g} times that anticipated is unstable"
        )
    if "given_flow" in values and "surplus_flow" not in values:
        missing["surplus_flow"] = "the flow given is less than the pads draw in, none is left over"
        if "heat_to_oil" in values:
            missing["outlet_temperature"] = starved_outlet(values)
    if "fit_error" not in values:
        missing["fit_error"] = "stiffness, damping and virtual mass are fitted over three whirl ratios or more"
    return missing


def starved_outlet(values: Mapping[str, float]) -> str:
    """Why the oil that leaves starved pads has no temperature, with that by the heat balance of the oil given."""
    rise = values["heat_to_oil"] / (values["volumetric_heat_capacity"] * values["given_flow"])
    leaving = values["supply_temperature"] + rise - ZERO_CELSIUS
    return (
        "the flow given is less than the pads draw in: films with all of that oil do not tell how hot it leaves; "
        f"their heat would bring the oil that is given to {leaving:.1f} °C"
    )
