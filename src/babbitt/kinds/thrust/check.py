"""Design check of a thrust bearing: values, verdicts and warnings."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from time import perf_counter

import numpy as np

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check, Outcome, Result
from babbitt.core.solution import Solution
from babbitt.design.checks import highest_specific_load
from babbitt.design.own_limits import asked_for_margins, missed_but_for_own, of_unknown_metal, sets_specific_load
from babbitt.kinds.thrust.assumed import oil_assumptions
from babbitt.kinds.thrust.design import (
    USUAL_FILM_LIMIT,
    USUAL_FILM_SOURCE,
    ThrustDesign,
    ThrustState,
    bearing_state,
    share_on,
)
from babbitt.kinds.thrust.failures import NoPadFilmError
from babbitt.kinds.thrust.margins import warnings_about_margins
from babbitt.kinds.thrust.pad_attitude import attitude_at_rest, attitude_on_runout
from babbitt.kinds.thrust.pressure_limits import PRESSURE, pressure_checks, pressures_not_checked
from babbitt.kinds.thrust.temperature_limits import TemperatureLimits
from babbitt.kinds.thrust.values import pad_arrays, share_values
from babbitt.kinds.thrust.warnings import LEAST_SHARE, sharing_warnings
from babbitt.kinds.thrust.work import MOST_WORK, WorkBoundError, bounded_work

__all__ = ["thrust_check"]

METHOD = "film"
TURNS = 24
"""Positions of the collar, at least, at which its runout is shared out slowly."""
TURNING_FILM = "quasi_static_minimum_film_thickness"
WAVES = 4
"""So many waves around the face are seen at so many positions."""


def thrust_check(design: ThrustDesign) -> Result:
    """Solve a thrust bearing; see `thrust_solution`."""
    return thrust_solution(design).result


def thrust_solution(design: ThrustDesign) -> Solution:
    """Solve a thrust bearing, with a bound on the work (`babbitt.kinds.thrust.work`).

    Parameters
    ----------
    design : ThrustDesign

    Returns
    -------
    Solution
        Its result has a status in every case; its state is that of the pads, None where they find no film.
    """
    with bounded_work(MOST_WORK):
        return _checked(design)


def _checked(design: ThrustDesign) -> Solution:
    start = perf_counter()
    try:
        state = bearing_state(design)
        shared = tuple(sharing_warnings(design, state))  # before a runout may use up the work
    except (NoPadFilmError, WorkBoundError) as error:
        failed = Result(
            design.name,
            design.kind,
            METHOD,
            Outcome.of(error.failure),
            {},
            failure=error.failure,
            warnings=design.warnings,
            assumptions=(*design.oil.assumed_of_lubricant, *design.assumptions, *_assumptions(design)),
        )
        return Solution(design, failed)
    values = share_values(design, state)
    of_runout: list[Notice] = []
    missed: tuple[Notice, ...] = ()
    if any(one.amplitude > 0.0 for one in design.runouts):
        try:
            of_turning, least_load = _turned(design, state)
            values |= of_turning
            if least_load < LEAST_SHARE <= values["smallest_pad_load"] / state.share.mean_load:
                of_runout.append(Notice("W201", "turning", {"share": least_load}))
        except (NoPadFilmError, WorkBoundError) as error:
            missed = (Notice("C202", "turning", {"reason": error.failure}),)
            of_runout.append(Notice("W209", values={"reason": error.failure}))
    values["wall_time"] = perf_counter() - start
    least, thinnest = "minimum_film_thickness", values["minimum_film_thickness"]
    if values.get(TURNING_FILM, math.inf) < thinnest:
        least, thinnest = TURNING_FILM, values[TURNING_FILM]
    limit = Check("C202", least, thinnest, design.film_limit, Bound.AT_LEAST, design.film_limit_source)
    held = () if missed and limit.ok else (limit,)  # the film at rest alone may miss the limit, but not keep it
    metal = design.temperatures.given_metal
    checks = (*held, *design.temperatures.checks(values), *pressure_checks(metal, values))
    replaced = _by_experience(design, limit, values)
    result = Result(
        design.name,
        design.kind,
        METHOD,
        Outcome.CONVERGED,
        values,
        checks,
        (
            *design.warnings,
            *shared,
            *of_runout,
            *missed_but_for_own(checks, replaced),
            *warnings_about_margins(design.oil, asked_for_margins(checks, replaced), values),
        ),
        (
            *(() if held else missed),
            *design.temperatures.not_checked(values),
            *pressures_not_checked(metal),
        ),
        (
            *design.oil.assumed_of_lubricant,
            *design.assumptions,
            *_assumptions(design),
            *design.temperatures.assumptions(),
        ),
        settings={"lubricant": design.lubricant.name, "pivot": design.bearing.pad.pivot.value},
        arrays=pad_arrays(state.share, design.speed),
    )
    return Solution(design, result, state)


def _by_experience(design: ThrustDesign, of_film: Check, values: Mapping[str, float]) -> tuple[Check, ...]:
    """The checks without limits that the case sets, or gives to its metal."""
    given = design.temperatures.given_metal
    usual = None if given is None else given.without_own_limits
    limits = TemperatureLimits(None, usual)
    of_film = replace(of_film, limit=USUAL_FILM_LIMIT, source=USUAL_FILM_SOURCE)
    found = of_film, *limits.checks(values), *pressure_checks(usual, values)
    of_load = highest_specific_load(PRESSURE, values, None) if sets_specific_load(given) else None
    return of_unknown_metal(found, given, of_load)


def _turned(design: ThrustDesign, state: ThrustState) -> tuple[dict[str, float], float]:
    """Of a collar that turns so slowly that nothing swings: largest load ratio and thinnest film, and least ratio.

    Raises
    ------
    NoPadFilmError
        If the pads find no film at a position of the collar, though they have one on a collar without runout.
    """
    largest, least, thinnest, share = 0.0, math.inf, math.inf, state.share
    least_count = TURNS * math.ceil(max(one.order for one in design.runouts) / WAVES)
    number = design.bearing.number
    count = number * math.ceil(least_count / number)  # whichever pad is called the first
    alike = attitude_at_rest(design.bearing).is_even  # then a turn by one pitch gives pads other names only
    for turned in 2.0 * np.pi * np.arange(count // number if alike else count) / count:
        stands = attitude_on_runout(design.bearing, design.runouts, float(turned))
        share = share_on(state.films, share, stands)
        largest = max(largest, share.largest_over_mean)
        least = min(least, float(share.loads.min()) / share.mean_load)
        thinnest = min(thinnest, *(pad.minimum_film_thickness for pad in share.states))
    return {"quasi_static_load_ratio": largest, TURNING_FILM: thinnest}, least


def _assumptions(design: ThrustDesign) -> tuple[str, ...]:
    said = list(oil_assumptions(design.oil))
    if design.oil.supply_temperature is not None:
        said.append("Each pad takes in what the pad before it sends off, mixed with fresh oil.")
    if design.turbulence is not None:
        said.append(f"Turbulence by {design.turbulence.name}: {design.turbulence.source}.")
    return tuple(said)
