"""How verdicts and checks read."""

from __future__ import annotations

import math
from collections.abc import Iterable
from enum import Enum

from babbitt.core.quantities import QUANTITIES
from babbitt.core.quantities.quantity import SI
from babbitt.core.result import Bound, Check, Result, Verdict
from babbitt.report.text import counted

LARGEST_MARGIN = 5.0
"""Relative distance to a limit beyond which its size tells nothing more."""


class CheckWord(Enum):
    """How one comparison with a limit came out."""

    PASS = "pass"
    MISSED = "missed"
    FAIL = "fail"


def worst_verdict(results: Iterable[Result]) -> Verdict:
    """The gravest verdict of several results."""
    order = list(Verdict)
    return max((result.verdict for result in results), key=order.index)


def unchecked(result: Result) -> str:
    """How many checks could not be made for want of data; empty for none.

    A verdict counts only what was checked, so this stands beside it.
    """
    number = len(result.not_checked)
    return f"{counted(number, 'check')} not made" if number else ""


def check_word(check: Check) -> CheckWord:
    """Whether a limit is kept; a recommendation or a screening indicator is missed without failing."""
    if check.ok:
        return CheckWord.PASS
    return CheckWord.MISSED if check.advisory else CheckWord.FAIL


def missed_codes(result: Result) -> list[str]:
    """Codes of the limits that a result misses."""
    return [check.code for check in result.limits if not check.ok]


def governing(result: Result, quantity: str) -> Check | None:
    """The strictest limit on a quantity, recommendations left aside; it may hold for the starved film."""
    return strictest(check for check in result.limits if check.quantity.removeprefix("starved_") == quantity)


def governing_temperature(result: Result) -> Check | None:
    """The strictest of all limits on temperatures, of oil, walls, metal and probes alike."""
    return strictest(check for check in result.limits if is_temperature(check.quantity))


def is_temperature(quantity: str) -> bool:
    """Whether a quantity is a temperature, which a rise or a difference is not.

    >>> is_temperature("outlet_temperature"), is_temperature("temperature_rise"), is_temperature("load")
    (True, False, False)
    """
    known = QUANTITIES.get(quantity)
    return known is not None and known.display == SI["degC"]


def strictest(checks: Iterable[Check]) -> Check | None:
    """The check with the least margin; None of none."""
    return min(checks, key=lambda check: check.margin, default=None)


def written(quantity: str, value: float) -> str:
    """A value in the engineer's unit, with the unit.

    >>> written("minimum_film_thickness", 52.34e-6)
    '52.3 µm'
    """
    return alike(quantity, value)[0]


def alike(quantity: str, *values: float) -> tuple[str, ...]:
    """Values of a quantity in one unit, with the unit.

    >>> alike("friction_power", 21.3, 4500.0), alike("friction_power", 21.3)
    (('0.0213 kW', '4.50 kW'), ('21.3 W',))
    """
    known = QUANTITIES.get(quantity)
    if known is None:
        return tuple(number(quantity, value) for value in values)
    shown = known.suited(*values)
    return tuple(map(shown.with_unit, values))


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
    value, limit = value_and_limit(check)
    return f"{symbol} = {value} {sign} {limit}"


def value_and_limit(check: Check) -> tuple[str, str]:
    """Both in one unit; of a limit that is barely missed as many digits of the value as tell so."""
    value, limit = alike(check.quantity, check.value, check.limit)
    known = QUANTITIES.get(check.quantity)
    if value != limit or check.ok or known is None:
        return value, limit
    shown = known.suited(check.value, check.limit)
    bound = shown.shown(check.limit)
    for digits in range(5, 16):
        if float(f"{shown.shown(check.value):.{digits}g}") != float(f"{bound:.{digits}g}"):
            return f"{shown.shown(check.value):.{digits}g} {shown.display.label}".rstrip(), limit
    return f"{value} (rounded)", limit


def margin(check: Check) -> str:
    """The distance to the limit: in K for a temperature, otherwise relative; positive when it is kept.

    Relative margins above `LARGEST_MARGIN` say no more than that.
    """
    known = QUANTITIES.get(check.quantity)
    if not math.isfinite(check.margin):
        return "–"
    if known is not None and known.unit == "K":
        gap = check.limit - check.value if check.bound is Bound.AT_MOST else check.value - check.limit
        return f"{gap:+.1f} K"
    return f"{check.margin:+.0%}" if check.margin <= LARGEST_MARGIN else f"over {LARGEST_MARGIN:+.0%}"
