"""What a result says about a bearing in one word, and how a check reads."""

from __future__ import annotations

import math
from collections.abc import Iterable
from enum import Enum

from babbitt.quantities import QUANTITIES
from babbitt.report.text import counted
from babbitt.results import Bound, Check, Result


class Verdict(Enum):
    """The judgement of one bearing, readable without colour."""

    OK = "ok"
    ADVICE = "advice"
    FAIL = "FAIL"
    UNSOLVED = "no solution"

    @property
    def key(self) -> str:
        """The word for programs: ``ok``, ``advice``, ``fail``, ``no_solution``."""
        return self.value.lower().replace(" ", "_")


def verdict(result: Result) -> Verdict:
    """Judge one result.

    A missed limit outweighs missed advice; an unsolved result has no operating point to judge.
    """
    if not result.outcome.solved:
        return Verdict.UNSOLVED
    if not result.within_limits:
        return Verdict.FAIL
    return Verdict.OK if all(check.ok for check in result.checks) else Verdict.ADVICE


def worst_verdict(results: Iterable[Result]) -> Verdict:
    """The gravest verdict of several results."""
    order = list(Verdict)
    return max((verdict(result) for result in results), key=order.index)


def unchecked(result: Result) -> str:
    """How many checks could not be made for want of data; empty for none.

    A verdict counts only what was checked, so this stands beside it.
    """
    number = len(result.not_checked)
    return f"{counted(number, 'check')} not made" if number else ""


def check_verdict(check: Check) -> Verdict:
    """Judge one comparison."""
    if check.ok:
        return Verdict.OK
    return Verdict.ADVICE if check.advisory else Verdict.FAIL


def governing(result: Result, quantity: str) -> Check | None:
    """The strictest limit on a quantity, advice left aside; it may hold for the starved film instead."""
    checks = [c for c in result.checks if c.quantity.removeprefix("starved_") == quantity and not c.advisory]
    return min(checks, key=lambda check: check.margin, default=None)


def written(quantity: str, value: float) -> str:
    """A value in the engineer's unit, with the unit.

    >>> written("minimum_film_thickness", 52.34e-6)
    '52.3 µm'
    """
    known = QUANTITIES.get(quantity)
    unit = known.display.label if known and math.isfinite(value) else ""
    return f"{number(quantity, value)} {unit}".rstrip()


def number(quantity: str, value: float) -> str:
    """A value in the engineer's unit, without the unit.

    >>> number("minimum_film_thickness", 52.34e-6), number("side_flow", math.nan)
    ('52.3', '–')
    """
    known = QUANTITIES.get(quantity)
    if not math.isfinite(value):
        return "–"
    return known.format(value) if known else f"{value:.4g}"


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
