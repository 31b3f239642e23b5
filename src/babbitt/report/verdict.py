"""How verdicts and checks read."""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum

from babbitt.core.language import translated
from babbitt.core.limited_flow import whole
from babbitt.core.quantities import QUANTITIES
from babbitt.core.quantities.display import SI
from babbitt.core.result import Check, Result, Verdict
from babbitt.report.text import counted


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
    return translated("{checks} not made", checks=counted(number, "check")) if number else ""


def check_word(check: Check) -> CheckWord:
    """Whether a limit is kept; a recommendation or a screening indicator is missed without failing."""
    if check.ok:
        return CheckWord.PASS
    return CheckWord.MISSED if check.advisory else CheckWord.FAIL


def missed_codes(result: Result) -> list[str]:
    """Codes of the limits that a result misses."""
    return [check.code for check in result.limits if not check.ok]


def governing(result: Result, quantity: str) -> Check | None:
    """The strictest limit on a quantity, recommendations left aside; of whichever film it is held against."""
    return strictest(check for check in result.limits if whole(check.quantity) == quantity)


def governing_temperature(result: Result) -> Check | None:
    """The strictest of all limits on temperatures, of oil, walls, metal and probes alike."""
    return strictest(check for check in result.limits if is_temperature(check.quantity))


def is_temperature(quantity: str) -> bool:
    """Whether a quantity is a temperature, which a rise or a difference is not.

    >>> is_temperature("outlet_temperature"), is_temperature("temperature_rise"), is_temperature("load")
    (True, False, False)
    """
    known = QUANTITIES.get(quantity)
    return known is not None and known.metric == SI["degC"]


def strictest(checks: Iterable[Check]) -> Check | None:
    """The check with the least margin; None of none."""
    return min(checks, key=lambda check: check.margin, default=None)
