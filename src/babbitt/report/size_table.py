"""The answer of `babbitt size`: permitted intervals, and choices, as a table."""

from __future__ import annotations

import math

from rich.console import Console
from rich.text import Text

from babbitt.report.bearing_table import engineers_table
from babbitt.report.table import console
from babbitt.report.text import plain_text
from babbitt.report.verdict import comparison, margin
from babbitt.study.permitted import Appraisal
from babbitt.study.size import ALL_LIMITS, LOGARITHMIC_FROM, RECOMMENDED, Size
from babbitt.study.size_choices import Choices
from babbitt.study.sweep_values import SHOWN

DIGITS = 4
"""Significant digits of an end, rounded into the interval."""

LIMITS = {
    ALL_LIMITS: "within all limits",
    RECOMMENDED: "within all limits and recommendations",
}


def print_size(size: Size, to: Console | None = None) -> None:
    """Print every permitted interval with what ends it, or the nearest miss where there is none."""
    to = to or console()
    unit = SHOWN.get(size.unit, size.unit)
    to.print(Text(f"{plain_text(size.name)}: {size.path} {_limits(size)}", style="bold"))
    if size.intervals:
        table = engineers_table()
        table.add_column(f"from\n{unit}", justify="right", no_wrap=True)
        table.add_column(f"to\n{unit}", justify="right", no_wrap=True)
        table.add_column("below it", overflow="fold")
        table.add_column("above it", overflow="fold")
        table.add_column(f"largest margin\nat {unit}".rstrip(), no_wrap=True)
        for one in size.intervals:
            table.add_row(
                rounded(one.lower.value, upward=True),
                rounded(one.upper.value, upward=False),
                Text(said(one.below)),
                Text(said(one.above)),
                Text(f"{_plain(one.best.value)}: {_margin(one.best)}"),
            )
        to.print(table)
        codes = dict.fromkeys(code for one in size.scan if one.permitted for code in one.remarks)
        if codes:
            to.print(Text(f"Permitted values with remarks: {' '.join(codes)}"))
    else:
        to.print(Text("No value of the scan is permitted."))
        miss = size.nearest_miss or size.scan[0]
        to.print(Text(f"Nearest miss: {_plain(miss.value)} {unit}, {said(miss)} ({_margin(miss)})"))
    to.print(Text(_scanned(size), style="dim"))


def print_choices(choices: Choices, unit: str = "", to: Console | None = None) -> None:
    """Print every choice with its margin, permitted or not."""
    to = to or console()
    to.print(Text(f"{plain_text(choices.name)}: {choices.path} {_limits(choices)}", style="bold"))
    table = engineers_table()
    table.add_column("choice", no_wrap=True)
    table.add_column("permitted", no_wrap=True)
    table.add_column("least margin", justify="right", no_wrap=True)
    table.add_column("governing check", overflow="fold")
    table.add_column("remarks", overflow="fold")
    for choice, one in choices.appraisals.items():
        table.add_row(
            Text(plain_text(f"{choice} {SHOWN.get(unit, unit)}".strip())),
            "yes" if one.permitted else "no",
            Text(margin(one.check) if one.check is not None else "–"),
            Text(said(one)),
            Text(" ".join(one.remarks)),
        )
    to.print(table)


def _limits(size: Size | Choices) -> str:
    """Which limits count."""
    (first, *_) = size.limits
    which = LIMITS.get(first, f"within {', '.join(size.limits)} alone")
    return f"{which}, at smallest, mean and largest clearance" if size.over_tolerance else which


def _scanned(size: Size) -> str:
    first, last = size.scan[0].value, size.scan[-1].value
    step = "equal ratios" if first > 0.0 and last >= LOGARITHMIC_FROM * first else "equal distances"
    unit = SHOWN.get(size.unit, size.unit)
    return (
        f"Scanned at {len(size.scan)} values from {_plain(first)} to {_plain(last)} {unit} at {step}; "
        "what is narrower than a step may be missed."
    )


def said(outside: Appraisal | None) -> str:
    """Why a value beside an interval is not permitted."""
    if outside is None:
        return "end of the scan"
    why = comparison(outside.check) if outside.check is not None else outside.reason
    whose = f"{outside.bearing}: " if outside.bearing else ""
    return plain_text(f"{outside.code} {whose}{why}".strip())


def _margin(one: Appraisal) -> str:
    return f"{margin(one.check)} ({one.code})" if one.check is not None else "no margin"


def rounded(value: float, *, upward: bool) -> str:
    """A value to `DIGITS` significant digits, rounded up or down.

    >>> rounded(46.41613, upward=False), rounded(46.41613, upward=True), rounded(11999.5, upward=True)
    ('46.41', '46.42', '12000')
    """
    if value == 0.0:
        return "0"
    step = 10.0 ** (math.floor(math.log10(abs(value))) + 1 - DIGITS)
    steps = value / step
    nearest = round(steps)
    if not math.isclose(steps, nearest, rel_tol=1e-9):
        nearest = math.ceil(steps) if upward else math.floor(steps)
    return _plain(nearest * step)


def _plain(value: float) -> str:
    """A value to `DIGITS` significant digits, without an exponent where it has few zeros.

    >>> _plain(12345.0), _plain(0.00123456), _plain(1e9)
    ('12340', '0.001235', '1e+09')
    """
    return f"{float(f'{value:.{DIGITS}g}'):.8g}"
