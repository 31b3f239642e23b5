"""Design check of one bearing as a long film: from the inputs to values, verdicts and warnings."""

from __future__ import annotations

import math
from collections.abc import Iterator
from time import perf_counter

import numpy as np

from babbitt.core.notices import Notice
from babbitt.core.result import Check, Matrix, Outcome, Result
from babbitt.design.bounds import NO_BOUNDS
from babbitt.design.checks import checks_not_made, clearance_check, limit_checks
from babbitt.design.conditions import PrescribedEccentricity, PrescribedLoad
from babbitt.design.directions import directions_of, narrowest_direction
from babbitt.design.heat_balance import NoFilmError
from babbitt.design.infinite_width import flattered_films, warnings_about_width
from babbitt.design.own_limits import checks_by_experience, missed_but_for_own
from babbitt.design.warnings import warnings_about_film, warnings_about_running
from babbitt.kinds.journal.infinitely_long_bearing.mean_temperature import mean_temperature_film
from babbitt.kinds.journal.infinitely_long_bearing.model import COARSE_BELOW, LongFilmCase, NusseltLaw
from babbitt.kinds.journal.infinitely_long_bearing.pressure import circle
from babbitt.kinds.journal.infinitely_long_bearing.solve import film_at_eccentricity, film_under_load
from babbitt.kinds.journal.infinitely_long_bearing.state import LongFilmState
from babbitt.kinds.journal.one_dimension import (
    long_film_values,
    rows_over_angle,
    solved,
    warnings_about_oil_range,
    warnings_about_thickness,
)

METHOD = "long_film"

ATMOSPHERE = 101325.0
"""Pa; standard atmosphere, to which the published relative load is referred."""

LAMINAR_UP_TO = 1500.0
"""Local Reynolds number ρ u h/η above which the laminar law is invalid."""


def long_film_check(case: LongFilmCase) -> Result:
    """Solve a bearing as a long film that exchanges heat with journal and bush.

    Parameters
    ----------
    case : LongFilmCase

    Returns
    -------
    Result
        With a status in every case.
    """
    start = perf_counter()
    outcome, capacity, state = solved(lambda: _found(case))
    values: dict[str, float] = {}
    checks: tuple[Check, ...] = ()
    not_made: tuple[Notice, ...] = ()
    warnings = case.warnings
    arrays: dict[str, Matrix] = {}
    if state is not None:
        values, arrays = _values(case, state), _arrays(state)
        around = directions_of(case, state.attitude_angle, circle(case.cells, case.film.start)[0])
        arrays |= rows_over_angle({"film_direction": around})
        if outcome.solved:
            bounds = flattered_films(values) if isinstance(case.duty, PrescribedLoad) else NO_BOUNDS
            checks = (*limit_checks(case, values, bounds), clearance_check(case, values))
            not_made = checks_not_made(case, values, bounds)
            warnings = tuple(_warnings(case, state, values, checks))
        values["iterations"] = float(state.iterations)
    values = {name: float(value) for name, value in values.items()} | {"wall_time": perf_counter() - start}
    return Result(
        case.name,
        case.kind,
        METHOD,
        outcome,
        values,
        checks,
        warnings,
        not_made,
        (*case.lubricant.assumptions_but_of_conduction, *case.assumptions, *_assumptions(case)),
        settings=_settings(case),
        arrays=arrays,
        failure=None if outcome.solved else _failure(case, outcome, capacity, state),
    )


def _found(case: LongFilmCase) -> LongFilmState:
    """The film under the load, or at the eccentricity of the case."""
    if isinstance(case.duty, PrescribedEccentricity):
        return film_at_eccentricity(case.film, case.duty.eccentricity_ratio)
    return film_under_load(case.film, case.duty.load)


def _values(case: LongFilmCase, state: LongFilmState) -> dict[str, float]:
    bearing, temperatures = case.bearing, state.temperatures
    values = long_film_values(case, state, _mean_temperature(state), state.flow) | {
        "eccentricity_ratio": state.eccentricity_ratio,
        "narrowest_gap_angle": narrowest_direction(case, state.attitude_angle),
        "supply_angle": case.supply_angle,
        "rupture_angle": state.pressure.rupture_angle,
        "relative_load": state.load_along / (bearing.diameter * bearing.width * ATMOSPHERE),
        "friction_torque": state.friction_torque,
        "friction_heat": state.heat_source,
        "film_flow": state.flow,
        "flow_inconsistency": state.flow_spread,
        "rupture_temperature": state.rupture_temperature,
        "outlet_temperature": float(temperatures.film[-1]),
        "maximum_temperature": float(temperatures.film.max()),
        "heat_to_oil": temperatures.to_oil,
        "heat_to_surroundings": temperatures.to_housing,
        "heat_to_shaft": temperatures.to_shaft,
        "heat_film_to_bush": temperatures.film_to_bush,
        "heat_film_to_journal": temperatures.film_to_journal,
        "energy_balance_error": state.energy_balance_error,
    }
    if not math.isnan(temperatures.journal):
        values["journal_temperature"] = temperatures.journal
    if temperatures.bush is not None:
        values["maximum_bush_temperature"] = float(temperatures.bush.max())
    if case.exchange.ambient_temperature is not None:
        values["ambient_temperature"] = case.exchange.ambient_temperature
    try:
        alone = mean_temperature_film(state.film, state.eccentricity_ratio)
    except NoFilmError:
        return values
    return values | {
        "mean_temperature_load_ratio": state.load / alone.load,
        "mean_temperature_relative_load_ratio": state.load_along / alone.load_along,
        "mean_temperature_outlet": alone.outlet_temperature,
    }


def _mean_temperature(state: LongFilmState) -> float:
    """Mean temperature of the full film in K."""
    middle = 0.5 * (state.temperatures.film[1:] + state.temperatures.film[:-1])
    return float(middle @ state.pressure.full) / float(state.pressure.full.sum())


def _arrays(state: LongFilmState) -> dict[str, Matrix]:
    """Fields over the angle from the widest gap, each as one row."""
    fields = {
        "film_angle": circle(state.film.cells, state.film.start)[0],
        "film_thickness": state.film_thickness,
        "film_pressure": state.film_pressure,
        "film_temperature": state.temperatures.film,
    }
    if state.temperatures.bush is not None:
        fields["bush_temperature"] = state.temperatures.bush
    return rows_over_angle(fields)


def _warnings(
    case: LongFilmCase, state: LongFilmState, values: dict[str, float], checks: tuple[Check, ...]
) -> Iterator[Notice]:
    yield from case.warnings
    yield from warnings_about_width(case, values)
    if not case.discretisation.conserves_flow:
        spread = values["flow_inconsistency"]
        yield Notice("W150", values={"scheme": case.discretisation.value, "spread": spread})
    yield from warnings_about_thickness(case)
    if case.cells < COARSE_BELOW:
        yield Notice("W152", values={"sectors": case.cells, "least": COARSE_BELOW})
    film, oil = state.temperatures.film, case.lubricant
    yield from warnings_about_oil_range(case, float(film.min()), float(film.max()), oil.temperature_range)
    local = oil.density(film) * case.film.surface_speed * state.film_thickness / oil.dynamic_viscosity(film)
    highest = float(np.max(local))
    if highest > LAMINAR_UP_TO and values["film_reynolds_number"] <= values["critical_reynolds_number"]:
        yield Notice("W101", "local", {"film_reynolds_number": highest, "limit": LAMINAR_UP_TO})
    yield from warnings_about_film(case, values)
    yield from warnings_about_running(case, values, checks)
    yield from missed_but_for_own(checks, checks_by_experience(case, values))


def _assumptions(case: LongFilmCase) -> Iterator[str]:
    yield "Infinitely long film: no oil passes the sides; at the same temperatures its load is an upper bound."
    yield "Neither heat nor pressure changes the clearance given. Laminar film, one temperature across it."
    where = "at the widest gap"
    if case.supply_angle != math.pi:
        where = f"{math.degrees(case.supply_angle):.4g} deg behind the narrowest gap, wherever the journal lies,"
    yield f"Oil enters {where} with the supply temperature; none of the hot oil comes around again."
    yield "The effective temperature is the mean over the full film; nothing is computed with it."
    if case.exchange.bush is None:
        yield "Adiabatic bush: all heat leaves with the oil" + (
            " and along the shaft." if case.exchange.shaft_conductance else "."
        )


def _settings(case: LongFilmCase) -> dict[str, str]:
    law, nusselt = "own", case.exchange.nusselt
    if isinstance(nusselt, NusseltLaw):
        law = f"{nusselt.coefficient:g} (Pe h/D)^{nusselt.exponent:.4g}"
    return {
        "lubricant": case.lubricant.name,
        "discretisation": case.discretisation.value,
        "exchange_zone": case.film.zone.value,
        "nusselt": law,
        "sectors": str(case.cells),
    }


def _failure(case: LongFilmCase, outcome: Outcome, capacity: float | None, state: LongFilmState | None) -> Notice:
    code, far = outcome.code, None
    if outcome is Outcome.OVERLOADED and isinstance(case.duty, PrescribedLoad) and capacity is not None:
        far = Notice("S001", "largest_load", {"reached": capacity, "load": case.duty.load})
    elif state is not None:
        far = Notice(code, "film_breaks", {
            "iterations": state.iterations, "change": state.residual, "angle": state.pressure.rupture_angle,
        })  # fmt: skip
    elif outcome is Outcome.NOT_CONVERGED and not case.discretisation.conserves_flow:
        far = Notice("S004", "local_flow", {"discretisation": case.discretisation.value})
    return Notice(code, "tried", {"far": far or outcome.value})
