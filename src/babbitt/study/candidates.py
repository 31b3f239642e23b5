"""Designs that were computed: one for the lines of each row, and what ranks them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from babbitt.core.result import ROUND_OFF, Verdict
from babbitt.study.held_film import value_held
from babbitt.study.rows import Columns, advisory_name, kelvin_name

__all__ = ["CRITERION", "METHOD", "Candidate", "candidates_of", "key_of", "least", "ranked", "standing"]

METHOD = "method"
"""Path of the input that tells by what a design is solved."""

CRITERION = (
    "all limits kept at the smallest, mean and largest clearance with the oil that the feed delivers, "
    "first without remarks; with a margin of at least {reserve} to each limit; then with the fewest "
    "recommendations and usual rules missed, these by the least in steps of a tenth; then least friction "
    "power, then least flow. Designs with less margin follow, by their margin"
)
"""How designs are ranked."""

WITHIN = (Verdict.PASS.key, Verdict.REMARKS.key)
ORDER = [verdict.key for verdict in Verdict]

Line = Mapping[str, Any]
Departures = Callable[[Line], Iterator[str]]


@dataclass(frozen=True)
class Candidate:
    """A design that was computed, by its worst clearance.

    Attributes
    ----------
    row : int
    fields : mapping
        By path what was tried: SI numbers, or words.
    verdict, code : str
        Of the worst bearing, operating point or clearance; the check with the least margin.
    margin : float
    power, flow : float
        Largest friction power in W and oil flow in m3/s, of the films that limits are held against.
    lines : tuple of mapping
        Of each clearance, the smallest first, the columns of its line in SI.
    remarks : tuple of str
        Codes of the remarks with which it passes.
    departures : tuple of str
        Recommendations and usual rules that it misses at some clearance.
    short : float
        By how much it misses the recommendations, the sum of the worst margins in steps of a tenth.
    kelvin : float
        The margin in K where the check is that of a temperature, else NaN.
    """

    row: int
    fields: Mapping[str, Any]
    verdict: str
    code: str
    margin: float
    power: float
    flow: float
    lines: tuple[Line, ...]
    remarks: tuple[str, ...]
    departures: tuple[str, ...]
    short: float = 0.0
    kelvin: float = math.nan

    @property
    def within(self) -> bool:
        """Whether it keeps all limits."""
        return self.verdict in WITHIN

    @property
    def values(self) -> Line:
        """The columns of the mean clearance."""
        return self.lines[len(self.lines) // 2]


def least(values: Iterable[float]) -> float:
    """The least of numbers that are known; NaN where none is.

    >>> least([math.nan, -0.5]), least([-0.5, math.nan]), least([math.nan])
    (-0.5, -0.5, nan)
    """
    return min((value for value in values if math.isfinite(value)), default=math.nan)


def key_of(fields: Mapping[str, Any]) -> tuple[Any, ...]:
    """What is the same of a design whatever method solves it."""
    return tuple(value for path, value in fields.items() if path != METHOD)


def standing(one: Candidate, reserve: float) -> tuple[float, ...]:
    """The place of a design by the criterion (`CRITERION`); what has no reserve stands by its margin."""
    margin = one.margin if math.isfinite(one.margin) else -math.inf
    first = (not one.within, ORDER.index(one.verdict))
    if margin < reserve:
        return (*first, math.inf, -margin, one.power)
    return (*first, len(one.departures), one.short, one.power, one.flow)


def ranked(candidates: Sequence[Candidate], reserve: float) -> list[Candidate]:
    """Designs, the best first."""
    return sorted(candidates, key=lambda one: standing(one, reserve))


def candidates_of(
    columns: Columns, paths: Sequence[str], advisories: Sequence[str], departures: Departures
) -> list[Candidate]:
    """One candidate for the lines of each row.

    Parameters
    ----------
    columns : Columns
    paths : sequence of str
        Of the fields that vary.
    advisories : sequence of str
        Codes of recommendations and screening indicators.
    departures : callable
        From a line the usual rules of its kind that it does not keep.
    """
    places: dict[int, list[int]] = {}
    for place, row in enumerate(columns["row"].tolist()):
        places.setdefault(row, []).append(place)
    listed = {name: column.tolist() for name, column in columns.items()}
    made = []
    for own in places.values():
        lines = tuple({name: column[place] for name, column in listed.items()} for place in own)
        made.append(_candidate(lines, paths, advisories, departures))
    return made


def _candidate(
    lines: Sequence[Line], paths: Sequence[str], advisories: Sequence[str], departures: Departures
) -> Candidate:
    worst = min(lines, key=lambda line: line["margin"] if math.isfinite(line["margin"]) else -math.inf)
    margins = {code: least(line.get(advisory_name(code), math.nan) for line in lines) for code in advisories}
    missed = {code: margin for code, margin in margins.items() if margin < -ROUND_OFF}
    rules = [said for line in lines for said in departures(line)]
    remarks = [code for line in lines if line["verdict"] == Verdict.REMARKS.key for code in line["codes"].split()]
    power, flow = (
        float(np.max([value_held(line, name) for line in lines])) for name in ("friction_power", "total_flow")
    )
    return Candidate(
        row=lines[0]["row"],
        fields={path: worst[path] for path in paths if path != METHOD},
        verdict=max((line["verdict"] for line in lines), key=ORDER.index),
        code=worst["governing_check"],
        margin=worst["margin"],
        power=power,
        flow=flow,
        lines=tuple(lines),
        remarks=tuple(dict.fromkeys(remarks)),
        departures=tuple(dict.fromkeys((*missed, *rules))),
        short=round(-sum(missed.values()), 1),
        kelvin=worst.get(kelvin_name(worst["governing_check"]), math.nan),
    )
