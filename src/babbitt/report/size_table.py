"""The tables of a size: permitted intervals, choices, preferred numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import groupby

from babbitt.core.check_text import distance
from babbitt.core.language import decimal, translated
from babbitt.report.study_values import (
    DASH,
    MARGIN_DECIMALS,
    Scale,
    StudyTable,
    bearing_text,
    check_title,
    input_scale,
    reason_text,
)
from babbitt.report.text import plain_text
from babbitt.study.appraisal import ALL_LIMITS, RECOMMENDED
from babbitt.study.permitted import Trial
from babbitt.study.size import Size, size_of
from babbitt.study.study import Study

__all__ = ["rounded", "size_scale", "size_tables"]

DIGITS = 4
"""Significant digits of an end, rounded into the interval."""

STEPS = {"distances": "equal distances", "ratios": "equal ratios", "": "uneven steps"}
"""How the values of a scan stand, in words."""

LIMITS = {
    ALL_LIMITS: "within all limits",
    RECOMMENDED: "within all limits and recommendations",
}


def size_scale(study: Study) -> Scale:
    """How the values of the field are shown."""
    (about,) = study.inputs
    return input_scale(about)


def size_tables(study: Study) -> Iterator[StudyTable]:
    """Every permitted interval with what ends it, or the nearest miss where there is none; choices likewise."""
    size, scale = size_of(study), size_scale(study)
    if size.choices:
        title = translated("Choices of {field} {limits}", field=size.path, limits=_limits(size))
        yield _tried(title, translated("choice"), size.choices)
    elif size.intervals:
        yield _intervals(study, size, scale)
        yield from _remarks(size, scale)
    else:
        miss = size.nearest_miss or size.scan[0]
        row = (scale.text(miss.value), _reason(miss, alone=False), _margin(miss))
        heads = ((size.path, scale.unit), (translated("nearest miss"), ""), (translated("margin"), ""))
        title = translated("No value of the scan is {limits}", limits=_limits(size))
        yield StudyTable(title, heads, (row,), 2, (_scanned(size, scale),))
    if size.preferred:
        numbers = {f"{scale.text(one.value)} {scale.unit}".strip(): one for one in size.preferred}
        yield _tried(translated("Preferred numbers (R20 of ISO 3)"), size.path, numbers)


def _intervals(study: Study, size: Size, scale: Scale) -> StudyTable:
    alone = len(set(study.columns["bearing"]) - {""}) == 1
    first, last, below, above = map(translated, ("from", "to", "below it", "above it"))
    heads = ((first, scale.unit), (last, scale.unit), (below, ""), (above, ""))
    rows = tuple(
        (
            rounded(scale.shown(one.lower.value), upward=True),
            rounded(scale.shown(one.upper.value), upward=False),
            _said(one.below, alone),
            _said(one.above, alone),
            _margin(one.best),
            rounded(scale.shown(one.best.value), upward=one.best is one.lower),
        )
        for one in size.intervals
    )
    columns = (*heads, (translated("largest margin"), ""), (translated("at"), scale.unit))
    return StudyTable(f"{size.path} {_limits(size)}", columns, rows, 4, (_scanned(size, scale),))


def _remarks(size: Size, scale: Scale) -> Iterator[StudyTable]:
    """Permitted values of the scan that pass with remarks, next to each other those with the same codes."""
    if not any(one.permitted and one.remarks for one in size.scan):
        return
    alike = groupby(size.scan, lambda one: (one.permitted, one.remarks))
    runs = [(codes, list(run)) for (permitted, codes), run in alike if permitted]
    rows = tuple(
        (scale.text(run[0].value), scale.text(run[-1].value), str(len(run)), " ".join(codes) or translated("none"))
        for codes, run in runs
    )
    first, last, values, remarks = map(translated, ("from", "to", "values", "remarks"))
    heads = ((first, scale.unit), (last, scale.unit), (values, ""), (remarks, ""))
    note = translated(
        "Values of the scan, from the first to the last of a kind; babbitt explain says what a code means."
    )
    codes = dict.fromkeys(code for one, _ in runs for code in one)
    meanings = "; ".join(map(check_title, codes))
    yield StudyTable(translated("Remarks on permitted values"), heads, rows, 2, (note, meanings))


def _tried(title: str, first: str, trials: Mapping[str, Trial]) -> StudyTable:
    others = ("permitted", "why not, or remarks", "governed by", "least margin")
    heads = ((first, ""), *((translated(name), "") for name in others))
    rows = tuple(
        (
            plain_text(choice),
            translated("yes" if one.permitted else "no"),
            _reason(one, alone=True) or " ".join(one.remarks),
            one.code or DASH,
            _margin(one),
        )
        for choice, one in trials.items()
    )
    return StudyTable(title, heads, rows, 4)


def _margin(one: Trial) -> str:
    return distance(one.margin, one.kelvin, MARGIN_DECIMALS)


def _limits(size: Size) -> str:
    """Which limits count."""
    known = LIMITS.get(size.limits[0])
    which = translated(known) if known else translated("within {codes} alone", codes=", ".join(size.limits))
    if size.at_mean:
        return translated("{limits}, at the mean clearance alone", limits=which)
    if not size.over_tolerance:
        return which
    return translated("{limits}, at smallest, mean and largest clearance", limits=which)


def _scanned(size: Size, scale: Scale) -> str:
    first, last = size.scan[0].value, size.scan[-1].value
    return translated(
        "Scanned at {number} values from {first} to {last} at {step}; what is narrower than a step may be missed.",
        number=len(size.scan),
        first=_plain(scale.shown(first)),
        last=f"{_plain(scale.shown(last))} {scale.unit}".rstrip(),
        step=translated(STEPS[size.steps]),
    )


def _said(outside: Trial | None, alone: bool) -> str:
    """Why a value next to an interval is not permitted."""
    if outside is None:
        return translated("end of the scan")
    return _reason(outside, alone=alone)


def _reason(one: Trial, *, alone: bool) -> str:
    """Why a value is not permitted, in the units that are spoken, behind its bearing where there are others."""
    said = reason_text(one.reason, one.code)
    return plain_text(said if alone or not one.bearing else f"{bearing_text(one.bearing)}: {said}")


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
    return decimal(f"{float(f'{value:.{DIGITS}g}'):.8g}")
