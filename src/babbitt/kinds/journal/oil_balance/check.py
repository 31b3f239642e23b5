"""The oil balance as a result: flows, which bearing starves first, orifices; and the bearings with it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

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
    return (Solution(problem, _held_at_limits(problem, result, found), found),
            *(one.solution for one in found.bearings))  # fmt: skip


def _supply_check(ratio: float) -> Check:
    source = "what the film draws itself, Q₃"
    return Check("C601", "least_supply_ratio", ratio, 1.0, Bound.AT_LEAST, source)


def _held_at_limits(problem: OilSystemProblem, result: Result, mean: Balance) -> Result:
    """The result of a balance, with what stands against it with other clearances than the mean.

    Bearings share the oil by their clearances: least of it reaches one while those of the others are largest, and
    most while they are smallest.
    """
    if not result.within_limits or not problem.with_limits:
        return result
    count = len(problem.calculations)
    least, largest = (_balance(problem.at_limits(count * (place,))) for place in (0, 1))
    against = [
        (Notice("W174", "all_least"), _against(mean, least)),
        (Notice("W174", "all_greatest"), _against(mean, largest)),
    ]
    if len(problem.with_limits) > 1:
        for own, variant in enumerate(("own_least", "own_greatest")):
            told = tuple(one for place in problem.with_limits for one in _against_own(problem, mean, place, own))
            against.append((Notice("W174", variant), told))
    return with_missed(result, against)


def _balance(problem: OilSystemProblem) -> Balance | None:
    """The balance of a system; None where none is found."""
    try:
        found = balanced(problem)
    except UnsolvedBearingError:
        return None
    return found if found.error <= BALANCED else None


def _against(mean: Balance, found: Balance | None) -> tuple[Notice, ...]:
    """What stands against bearings with other clearances than the mean, each with its name."""
    if found is None:
        return (Notice("W174", "no_film"),)
    pairs = zip(mean.bearings, found.bearings, strict=True)
    return tuple(_of_bearing(before, told) for before, after in pairs if (told := _clauses(before, after)))


def _against_own(problem: OilSystemProblem, mean: Balance, place: int, own: int) -> Iterator[Notice]:
    """What stands against one bearing at its first (0) or second (1) limit, all others being at the other."""
    count, before = len(problem.calculations), mean.bearings[place]
    mixed = problem.at_limits([own if one == place else 1 - own for one in range(count)])
    try:
        header = header_of(mixed, OTHER_CLEARANCES)
        found = fed(mixed.calculations[place], problem.system.lines[place], header.value)
        told = _clauses(before, found) if header.converged else (Notice("W174", "no_film"),)
    except UnsolvedBearingError:
        told = (Notice("W174", "no_film"),)
    if told:
        yield _of_bearing(before, told)


def _clauses(before: FedBearing, after: FedBearing) -> tuple[Notice, ...]:
    """What stands against a bearing at another clearance than the mean: its supply first."""
    own, usual = after.solution.result, before.solution.result
    told = standing_against(own, usual) if usual.within_limits else ()
    starved = _supply_check(after.ratio)
    return told if starved.ok else (missed_limit(starved, "W174"), *told)


def _of_bearing(before: FedBearing, told: tuple[Notice, ...]) -> Notice:
    return Notice("W174", "of_bearing", {"bearing": str(before.solution.result.name), "told": told})


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
