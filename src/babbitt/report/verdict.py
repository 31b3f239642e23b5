"""What a result says about a bearing, in one word, and the doubts of many bearings gathered by code."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum

from babbitt.notices import EXPLANATIONS
from babbitt.quantities import QUANTITIES
from babbitt.report.text import counted_results, plain_text
from babbitt.results import Bound, Check, Result

NAMES_SHOWN = 2
"""How many bearings a gathered line names before it counts the rest."""


class Verdict(Enum):
    """The judgement of one bearing, readable without colour."""

    OK = "ok"
    ADVICE = "advice"
    FAIL = "FAIL"
    UNSOLVED = "no solution"


@dataclass(frozen=True)
class Group:
    """One code and what it says about one or more bearings.

    Attributes
    ----------
    code, title : str
        The code and what it means in general.
    bearings : str
        Which bearings, shortened when many.
    message : str
        The numbers of the case.
    remedy : str
        What to do; empty when the register knows none.
    """

    code: str
    title: str
    bearings: str
    message: str
    remedy: str = ""


def verdict(result: Result) -> Verdict:
    """Judge one result.

    A missed limit outweighs missed advice; an unsolved result has no operating point to judge.
    """
    if not result.outcome.solved:
        return Verdict.UNSOLVED
    if not result.within_limits:
        return Verdict.FAIL
    return Verdict.OK if all(check.ok for check in result.checks) else Verdict.ADVICE


def check_verdict(check: Check) -> Verdict:
    """Judge one comparison."""
    if check.ok:
        return Verdict.OK
    return Verdict.ADVICE if check.advisory else Verdict.FAIL


def governing(result: Result, quantity: str) -> Check | None:
    """The strictest limit on a quantity, advice left aside."""
    checks = [c for c in result.checks if c.quantity == quantity and not c.advisory]
    return min(checks, key=lambda check: check.margin, default=None)


def worst(result: Result) -> Check | None:
    """The limit with the least relative margin, advice left aside."""
    return min((c for c in result.checks if not c.advisory), key=lambda check: check.margin, default=None)


def written(quantity: str, value: float) -> str:
    """A value in the engineer's unit, with the unit.

    >>> written("minimum_film_thickness", 52.34e-6)
    '52.3 µm'
    """
    known = QUANTITIES.get(quantity)
    if not math.isfinite(value):
        return "–"
    if known is None:
        return f"{value:.4g}"
    return f"{known.format(value)} {known.display.label}".rstrip()


def comparison(check: Check) -> str:
    """A value beside its limit: ``P̄ = 1.30 MPa > 1.20 MPa``."""
    known = QUANTITIES.get(check.quantity)
    symbol = known.symbol if known else check.quantity
    kept = {Bound.AT_MOST: "≤", Bound.AT_LEAST: "≥"}
    missed = {Bound.AT_MOST: ">", Bound.AT_LEAST: "<"}
    sign = (kept if check.ok else missed)[check.bound]
    value, limit = written(check.quantity, check.value), written(check.quantity, check.limit)
    if value == limit and not check.ok:
        value, limit = f"{value} (rounded)", limit
    return f"{symbol} = {value} {sign} {limit}"


def margin(check: Check) -> str:
    """The distance to the limit: in K for a temperature, otherwise relative; positive when it is kept."""
    known = QUANTITIES.get(check.quantity)
    if not math.isfinite(check.margin):
        return "–"
    if known is not None and known.unit == "K":
        gap = check.limit - check.value if check.bound is Bound.AT_MOST else check.value - check.limit
        return f"{gap:+.1f} K"
    return f"{check.margin:+.0%}"


def missed_limits(results: Sequence[Result]) -> tuple[Group, ...]:
    """Violated limits of solved bearings, gathered by code, the worst margin first in each group."""
    return _missed(results, lambda check: not check.advisory)


def missed_advice(results: Sequence[Result]) -> tuple[Group, ...]:
    """Missed recommendations of solved bearings, gathered by code."""
    return _missed(results, lambda check: check.advisory)


def _missed(results: Sequence[Result], concerned: Callable[[Check], bool]) -> tuple[Group, ...]:
    found: dict[tuple[str, str], list[tuple[Result, Check]]] = {}
    for result in results:
        if result.outcome.solved:
            for check in result.checks:
                if not check.ok and concerned(check):
                    found.setdefault((check.code, check.quantity), []).append((result, check))
    groups = []
    for (code, quantity), misses in sorted(found.items()):
        misses.sort(key=lambda miss: miss[1].margin)
        check = misses[0][1]
        known = QUANTITIES.get(quantity)
        message = comparison(check) if len(misses) == 1 else f"worst {comparison(check)}"
        groups.append(
            Group(
                code,
                known.meaning if known else quantity,
                _who([result for result, _ in misses], results),
                message,
                EXPLANATIONS[code].remedy if code in EXPLANATIONS else "",
            )
        )
    return tuple(groups)


def gathered_warnings(results: Sequence[Result]) -> tuple[Group, ...]:
    """Warnings of all bearings, one group a code."""
    found: dict[str, list[tuple[Result, str]]] = {}
    for result in results:
        for notice in result.warnings:
            found.setdefault(notice.code, []).append((result, plain_text(notice.message)))
    groups = []
    for code, notices in sorted(found.items()):
        messages = list(dict.fromkeys(message for _, message in notices))
        message = messages[0] if len(messages) == 1 else f"for example: {messages[0]}"
        explanation = EXPLANATIONS[code]
        bearings = list({id(result): result for result, _ in notices}.values())
        groups.append(Group(code, explanation.title, _who(bearings, results), message, explanation.remedy))
    return tuple(groups)


def unsolved(results: Sequence[Result]) -> tuple[Group, ...]:
    """Bearings without an operating point, and why."""
    return tuple(
        Group(
            result.outcome.code,
            result.outcome.value,
            plain_text(result.name),
            plain_text(result.message),
            EXPLANATIONS[result.outcome.code].remedy if result.outcome.code in EXPLANATIONS else "",
        )
        for result in results
        if not result.outcome.solved
    )


def _who(bearings: Sequence[Result], of: Sequence[Result]) -> str:
    if len(bearings) == len(of) and len(of) > 1:
        return f"all {counted_results([result.name for result in of])}"
    names = [plain_text(result.name) for result in bearings]
    if len(names) <= NAMES_SHOWN:
        return ", ".join(names)
    return f"{', '.join(names[:NAMES_SHOWN])} and {len(names) - NAMES_SHOWN} more"
