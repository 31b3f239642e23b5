"""From a case to its result: state, values, warnings, checks."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator

import numpy as np

from babbitt.core.notices import InputError, Notice
from babbitt.core.result import Bound, Check, Outcome, Result
from babbitt.core.solution import Solution
from babbitt.kinds.hydrostatic.answer import Answer, coarser
from babbitt.kinds.hydrostatic.capacity import capacity
from babbitt.kinds.hydrostatic.extrapolation import half_of, richardson, richardson_of_matrices
from babbitt.kinds.hydrostatic.failure import failure
from babbitt.kinds.hydrostatic.geometry import RectangularPad, ThrustRing
from babbitt.kinds.hydrostatic.heat_balance import heated
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.pumping import held_pressure, highest_pressure, is_pumped
from babbitt.kinds.hydrostatic.rest import warnings_about_rest
from babbitt.kinds.hydrostatic.validity import warnings_of_solution
from babbitt.kinds.hydrostatic.values import arrays, values
from babbitt.kinds.hydrostatic.whirl import whirl_of
from babbitt.reynolds.stability.whirl_checks import (
    missing_thresholds,
    warnings_about_whirl,
    whirl_checks,
    whirl_values,
)

__all__ = ["hydrostatic_check"]

USER = "set in the case"
NO_COARSE_FILM = "the film on half the lines, with which it is compared, has not been solved"
"""Why there is no error of the grid."""


def hydrostatic_check(case: HydrostaticCase) -> Result:
    """Solve one bearing; see `hydrostatic_solution`."""
    return hydrostatic_solution(case).result


def hydrostatic_solution(case: HydrostaticCase) -> Solution:
    """Solve one bearing.

    Parameters
    ----------
    case : HydrostaticCase

    Returns
    -------
    Solution
        Its state holds the case at the temperature found, and the film.
        Typed failures: no film can carry the load, unstable recess network, starved recess, no equilibrium.

    Raises
    ------
    InputError
        E101 where a prescribed position leaves no gap, or closed forms do not reach.
    """
    begun = time.perf_counter()
    asked = case
    refuse_contact(case)
    refuse_short_recess(case)
    state = heated(case)
    case, found = state.case, state.found
    failed = failure(case, found)
    settings = {"method": case.method, "accuracy": case.accuracy if case.method == "film" else ""}
    if case.oil.lubricant is not None:
        settings["lubricant"] = case.oil.lubricant.name
    if failed is not None:
        last = {"supply_pressure": found.network.supply_pressure, "minimum_film_thickness": found.minimum_gap}
        result = Result(
            case.name, case.kind, case.method, Outcome.of(failed), last, assumptions=case.assumptions,
            failure=failed, settings=settings, warnings=case.warnings,
        )  # fmt: skip
        return Solution(asked, result, state)
    named, several = values(case, found), arrays(case, found)
    half = half_of(case, found)
    if half is not None:
        named = richardson(named, values(case, half))
        several = richardson_of_matrices(several, arrays(case, half))
        settings["extrapolated"] = "yes"
    if case.oil.supply_temperature is not None:
        named |= {
            "supply_temperature": case.oil.supply_temperature,
            "outlet_temperature": case.oil.supply_temperature + named["temperature_rise"],
        }
    if state.temperature is not None:
        named["effective_temperature"] = state.temperature
    if case.oil.is_warmed:
        named["energy_balance_error"] = abs(state.heat_error)
    whirl = whirl_of(case, found)
    missing = missing_thresholds(whirl) if whirl else {}
    if whirl is not None:
        named |= whirl_values(case, whirl)
    if case.least_gap is not None:
        limit = capacity(case, found)
        named |= {} if limit is None else {"load_capacity": limit}
    if found.film is not None and found.film.network.converged:
        error = grid_error(case, found)
        if error is None:
            missing["grid_error"] = NO_COARSE_FILM
        else:
            named["grid_error"] = error
    named |= {"iterations": float(found.steps), "wall_time": time.perf_counter() - begun}
    result = Result(
        case.name,
        case.kind,
        case.method,
        Outcome.CONVERGED,
        named,
        checks=(*checks(case, found, named), *whirl_checks(case, whirl)),
        not_checked=tuple(not_checked(case, found, named)),
        warnings=(
            *case.warnings,
            *warnings_of_solution(case, found, named),
            *warnings_about_rest(case),
            *(warnings_about_whirl(whirl) if whirl else ()),
        ),
        assumptions=case.assumptions,
        settings=settings,
        arrays=several,
        missing=missing,
    )
    return Solution(asked, result, state)


def grid_error(case: HydrostaticCase, found: Answer) -> float | None:
    """A third of the change of the film's force on half the lines, relative, moments by the bearing's radius.

    None where the film on half the lines has not been solved.
    """
    half = coarser(case, found)
    if not half.network.converged:
        return None
    change = half.response.force - found.response.force
    arm = 1.0 if case.is_journal else np.append(1.0, np.full(change.size - 1, 1.0 / case.reach))
    size = max(float(np.linalg.norm(found.response.force * arm)), 1e-300)
    return float(np.linalg.norm(change * arm)) / size / 3.0


def checks(case: HydrostaticCase, found: Answer, named: dict[str, float]) -> list[Check]:
    """Limits that the user set."""
    made = []
    if case.least_gap is not None:
        gap = named["minimum_film_thickness"]
        made.append(Check("C301", "minimum_film_thickness", gap, case.least_gap, Bound.AT_LEAST, USER))
        if case.duty.load is not None and "load_capacity" in named:
            source = "film at the least gap allowed" + ", or the pressure of its pumps" * is_pumped(case)
            made.append(Check("C302", "load", named["load"], named["load_capacity"], Bound.AT_MOST, source))
    limit = highest_pressure(case, found.network)
    if limit is not None:
        name = "recess_pressure" if is_pumped(case) else "supply_pressure"
        held = held_pressure(case, found.network) if is_pumped(case) else named["supply_pressure"]
        source = USER if case.highest_supply_pressure is not None else "pressure of the supply"
        made.append(Check("C303", name, held, limit, Bound.AT_MOST, source))
    return made


def not_checked(case: HydrostaticCase, found: Answer, named: dict[str, float]) -> Iterator[Notice]:
    """Limits that were held against nothing, and why."""
    loaded = case.duty.load is not None
    if case.least_gap is None:
        for code in ("C301", "C302") if loaded else ("C301",):
            yield Notice(code, "no_least_gap")
    elif loaded and "load_capacity" not in named:
        yield Notice("C302", "not_found")
    if highest_pressure(case, found.network) is None:
        yield Notice("C303")
    yield Notice("C305", values={"temperature_rise": named["temperature_rise"]})


def refuse_contact(case: HydrostaticCase) -> None:
    """Refuse a prescribed position without gap, and say where."""
    if case.duty.load is not None:
        return
    if case.is_journal:
        e = math.hypot(*case.duty.position)
        if not e < case.rest_gap:
            where = math.degrees(math.atan2(case.duty.position[1], case.duty.position[0]))
            raise InputError("E101", f"the journal stands {1e6 * e:.4g} µm off centre in a clearance of "
                             f"{1e6 * case.rest_gap:.4g} µm: there is no gap at {where:.4g} deg. Give an "
                             "eccentricity_ratio below 1.")  # fmt: skip
        return
    tilt = math.hypot(*case.duty.tilt)
    if isinstance(case.shape, ThrustRing) and not tilt * case.reach < case.rest_gap:
        where = math.degrees(math.atan2(-case.duty.tilt[0], case.duty.tilt[1]))
        raise InputError("E101", f"a tilt of {1e3 * tilt:.4g} mm/m closes the gap of {1e6 * case.rest_gap:.4g} µm "
                         f"at {where:.4g} deg on the outer edge. Give a smaller tilt or a wider gap.")  # fmt: skip


def refuse_short_recess(case: HydrostaticCase) -> None:
    """Refuse closed forms of a rectangle whose corners touch."""
    shape = case.shape
    if case.method != "quick" or not isinstance(shape, RectangularPad):
        return
    along, aside = shape.lands
    if math.isclose(along, aside, rel_tol=1e-6) and min(shape.recess_length, shape.recess_width) < along:
        raise InputError("E101", "the shorter side of the recess is less than the land is wide; closed forms end "
                         "there. Choose method: film.")  # fmt: skip
