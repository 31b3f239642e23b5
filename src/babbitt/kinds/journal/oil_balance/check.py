"""The oil balance as a result: flows, which bearing starves first, orifices; and the bearings with it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import cache

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check, Matrix, Outcome, Result
from babbitt.core.solution import Solution
from babbitt.design.ducts import LAMINAR_UP_TO
from babbitt.design.missed_limit import missed_limit
from babbitt.kinds.journal.limits_of_clearance import standing_against, with_missed
from babbitt.kinds.journal.oil_balance.model import OilSystemProblem
from babbitt.kinds.journal.oil_balance.network import (
    Balance,
    FedBearing,
    UnsolvedBearingError,
    balanced,
    fed,
    header_of,
)
from babbitt.kinds.journal.oil_balance.proposals import Proposal, proposed
from babbitt.numerics.roots import Root

__all__ = ["METHOD", "oil_balance_solutions"]

METHOD = "oil_balance"

BALANCED = 1e-8
"""Error of the balance of flows, over the delivery of the pump, up to which it has converged."""

OTHER_CLEARANCES = 1e-6
"""Relative, of the pressure of the header with clearances that are not those of the answer."""


def oil_balance_solutions(problem: OilSystemProblem) -> tuple[Solution, ...]:
    """Balance pump and bearings: the solution of the oil system, then those of the bearings with it."""
    try:
        found = balanced(problem)
    except UnsolvedBearingError as error:
        variant = "need_unknown" if error.solution.result.outcome.solved else "oil_balance"
        failure = Notice("S004", variant, {"bearing": error.solution.result.name, "pressure": error.pressure})
        return (_solution(problem, Outcome.NOT_CONVERGED, failure), error.solution)
    if found.error > BALANCED:
        ended = math.isfinite(found.error)
        failure = (
            Notice("S004", "oil_balance_error", {"error": found.error}) if ended else Notice("S004", "header")
        )
        return (_solution(problem, Outcome.NOT_CONVERGED, failure),)
    made = proposed(problem)
    result = Result(
        problem.name,
        problem.kind,
        METHOD,
        Outcome.CONVERGED,
        _values(found),
        (_supply_check(_least(found)),),
        tuple(_warnings(problem, found, made)),
        settings=_names(problem),
        arrays=_arrays(problem, found, made),
    )
    bearings = (one.solution for one in found.bearings)
    return _held_at_limits(problem, found, (Solution(problem, result, found), *bearings))


def _supply_check(ratio: float) -> Check:
    source = "what the film draws itself, Q₃"
    return Check("C601", "least_supply_ratio", ratio, 1.0, Bound.AT_LEAST, source)


def _held_at_limits(
    problem: OilSystemProblem, mean: Balance, solutions: tuple[Solution, ...]
) -> tuple[Solution, ...]:
    """The system and its bearings, each with what stands against it with other clearances than the mean.

    Bearings share the oil by their clearances: least of it reaches one while those of the others are largest, and
    most while they are smallest.
    """
    if not problem.with_limits or not any(one.result.within_limits for one in solutions):
        return solutions
    against = tuple(_against(problem, mean))

    def held(place: int, solution: Solution) -> Solution:
        if not solution.result.within_limits:
            return solution
        told = ((at[min(place, 1)], told.get(place, ())) for at, told in against)
        return replace(solution, result=with_missed(solution.result, told))

    return tuple(held(place, one) for place, one in enumerate(solutions))


Told = dict[int, tuple[Notice, ...]]
"""What stands against the system (0) and against its bearings (from 1)."""


Found = FedBearing | UnsolvedBearingError | None
"""A bearing; which one has no operating point; None where the system has no balance."""


def _against(problem: OilSystemProblem, mean: Balance) -> Iterator[tuple[tuple[Notice, Notice], Told]]:
    """Clearances at their limits in words to system and bearing, each with what then stands against them."""
    count = len(problem.calculations)
    for limit, both in enumerate((Notice("W174", "all_least"), Notice("W174", "all_greatest"))):
        yield (both, both), _told(mean, _all_of(problem.at_limits(count * (limit,))))
    if len(problem.with_limits) > 1:
        beside = _beside(problem)
        least = Notice("W174", "one_least"), Notice("W174", "own_least")
        greatest = Notice("W174", "one_greatest"), Notice("W174", "own_greatest")
        for limit, at in enumerate((least, greatest)):
            yield at, _told(mean, ((one, beside(one, limit)) for one in problem.with_limits))


def _all_of(problem: OilSystemProblem) -> Iterator[tuple[int, Found]]:
    """All bearings of a system in balance, by their place."""
    try:
        found = balanced(problem)
    except UnsolvedBearingError as error:
        yield from ((place, error) for place in range(len(problem.calculations)))
        return
    yield from enumerate(found.bearings) if found.error <= BALANCED else [(0, None)]


def _beside(problem: OilSystemProblem) -> Callable[[int, int], Found]:
    """To find the bearing of a place at its first (0) or second (1) limit beside all others at the other."""

    @cache
    def header(limits: tuple[int, ...]) -> Root:
        return header_of(problem.at_limits(limits), OTHER_CLEARANCES)

    def found(place: int, limit: int) -> Found:
        limits = tuple(limit if one == place else 1 - limit for one in range(len(problem.calculations)))
        try:
            pressure = header(limits)
            one = problem.at_limits(limits).calculations[place]
            return fed(one, problem.system.lines[place], pressure.value) if pressure.converged else None
        except UnsolvedBearingError as error:
            return error

    return found


def _told(mean: Balance, found: Iterable[tuple[int, Found]]) -> Told:
    """What stands against bearings, by their place, and against the system, whose lines deliver too little.

    Without a film of one bearing the system has no balance, and the others are not solved either.
    """
    of_system: list[Notice] = []
    told: Told = {}
    for place, after in found:
        before = mean.bearings[place].solution.result
        if isinstance(after, FedBearing):
            told[place + 1] = standing_against(after.solution.result, before)
            if not (supply := _supply_check(after.ratio)).ok:
                of_system.append(_of_bearing(before.name, missed_limit(supply, "W174")))
        elif after is None:
            of_system.append(Notice("W174", "no_film"))
        else:
            lacking = after.solution.result
            lacks = Notice("W174", "no_need" if lacking.outcome.solved else "no_film")
            of_system.append(_of_bearing(lacking.name, lacks))
            told[place + 1] = (lacks if lacking.name == before.name else of_system[-1],)
    return {0: tuple(dict.fromkeys(of_system)), **told}


def _of_bearing(name: str, told: Notice) -> Notice:
    return Notice("W174", "of_bearing", {"bearing": name, "told": told})


def _solution(problem: OilSystemProblem, outcome: Outcome, failure: Notice) -> Solution:
    result = Result(problem.name, problem.kind, METHOD, outcome, {}, settings=_names(problem), failure=failure)
    return Solution(problem, result)


def _names(problem: OilSystemProblem) -> dict[str, str]:
    return {f"bearing_{place}": line.bearing for place, line in enumerate(problem.system.lines, start=1)}


def _least(found: Balance) -> float:
    return min(one.ratio for one in found.bearings)


def _values(found: Balance) -> dict[str, float]:
    return {
        "header_pressure": found.header_pressure,
        "pump_delivery": found.delivery,
        "relief_flow": found.relief_flow,
        "least_supply_ratio": _least(found),
        "oil_balance_error": found.error,
    }


def _arrays(problem: OilSystemProblem, found: Balance, made: Proposal) -> dict[str, Matrix]:
    whole = sum(one.supplied for one in found.bearings)
    rows: dict[str, Sequence[float]] = {
        "line_pressure": [one.pressure for one in found.bearings],
        "line_flow": [one.supplied for one in found.bearings],
        "line_need": [one.needed for one in found.bearings],
        "line_supply_ratio": [one.ratio for one in found.bearings],
        "line_share": [one.supplied / whole for one in found.bearings],
        "line_reynolds_number": [one.tube_reynolds_number for one in found.bearings],
        "line_orifice": [math.nan if one.orifice_diameter is None else one.orifice_diameter
                         for one in problem.system.lines],
        "line_orifice_proposed": made.diameters,
    }  # fmt: skip
    return {name: (tuple(map(float, row)),) for name, row in rows.items() if not all(map(math.isnan, row))}


def _warnings(problem: OilSystemProblem, found: Balance, made: Proposal) -> Iterator[Notice]:
    for line, one in zip(problem.system.lines, found.bearings, strict=True):
        if one.tube_reynolds_number > LAMINAR_UP_TO:
            yield Notice(
                "W601",
                values={"bearing": line.bearing, "reynolds": one.tube_reynolds_number, "limit": LAMINAR_UP_TO},
            )
    pump, margin = problem.system.pump, problem.system.margin
    if math.isnan(made.header_pressure):
        yield Notice("W602", "pump", {"flow": made.flow, "margin": margin, "delivery": pump.delivery(0.0)})
        return
    lacking = [
        line.bearing for line, one in zip(problem.system.lines, made.diameters, strict=True) if math.isnan(one)
    ]
    if lacking:
        yield Notice("W602", "bearings", {"bearings": ", ".join(lacking), "margin": margin})
