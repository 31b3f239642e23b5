"""What a tolerance study tells: yields with their confidence, percentiles, failing checks, worst cases."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from babbitt.core.result import Verdict
from babbitt.study.grids import CORNER, SAMPLE
from babbitt.study.rows import Columns

if TYPE_CHECKING:
    from babbitt.study.study import Study

__all__ = [
    "ALL",
    "Capability",
    "Spread",
    "ToleranceSummary",
    "Yield",
    "tolerance_summary",
    "yield_of",
]

Array = NDArray[np.float64]

CONFIDENCE = 0.95

ALL = "all bearings"

PERCENTILES = (0.135, 1.0, 5.0, 50.0, 95.0, 99.0, 99.865)
"""The outer ones are three standard deviations of a normal law from its mean."""

CONSTANT = 1e-12
"""Standard deviation over the mean of what does not vary but by round-off."""

NEAR_NORMAL = (0.5, 1.0)
"""Assumption: largest magnitudes of skewness and excess kurtosis of what is near a normal law."""

WITHIN = (Verdict.PASS.key, Verdict.REMARKS.key)


@dataclass(frozen=True)
class Yield:
    """Share of a sample within all limits.

    Attributes
    ----------
    bearing : str
        Or `ALL`: every bearing of the machine within its limits.
    samples, within, unsolved : int
    share, low, high : float
        With the ends of its 95 % interval.
    method : str
        How the interval was found.
    """

    bearing: str
    samples: int
    within: int
    unsolved: int
    share: float
    low: float
    high: float
    method: str


@dataclass(frozen=True)
class Spread:
    """How an output of one bearing scatters, over the samples that have a solution; SI.

    Attributes
    ----------
    bearing, output : str
    mean, deviation, least, most : float
    percentiles : dict of float to float
    """

    bearing: str
    output: str
    mean: float
    deviation: float
    least: float
    most: float
    percentiles: dict[float, float]


@dataclass(frozen=True)
class Capability:
    """How often one check fails, and its Cpk.

    Attributes
    ----------
    bearing, code : str
    failures, samples : int
        Samples beyond the limit, of all that have a solution and the check.
    cpk : float
        Distance of the mean margin from zero over three standard deviations; holds for margins near a normal law.
    near_normal : bool
        Whether skewness and kurtosis are those of one, about.
    varies : bool
        Whether the margin scatters at all; NaN is the Cpk of one that does not.
    """

    bearing: str
    code: str
    failures: int
    samples: int
    cpk: float
    near_normal: bool
    varies: bool = True


@dataclass(frozen=True)
class ToleranceSummary:
    """What a tolerance study tells.

    Attributes
    ----------
    yields : tuple of Yield
        All bearings first.
    spreads : tuple of Spread
    capabilities : tuple of Capability
        What fails most often first.
    worst_sample, worst_corner : dict or None
        The line with the least margin: its columns. A line without a solution is worse than any.
    tornado : dict
        By bearing and output (or ``margin``), by input the squared rank correlation (Spearman) with its sign.
    """

    yields: tuple[Yield, ...]
    spreads: tuple[Spread, ...]
    capabilities: tuple[Capability, ...]
    worst_sample: dict[str, Any] | None
    worst_corner: dict[str, Any] | None
    tornado: dict[tuple[str, str], dict[str, float]]


def tolerance_summary(study: Study) -> ToleranceSummary:
    """Summarise a tolerance study."""
    sample = study.of(SAMPLE)
    batches = list(study.description["batches"])
    sampling = study.block.sampling
    bearings = [str(one) for one in dict.fromkeys(sample["bearing"]) if one]
    yields = [_yield(sample, "", batches, sampling)]
    if len(bearings) > 1:
        yields += [_yield(sample, bearing, batches, sampling) for bearing in bearings]
    spreads, capabilities, tornado = [], [], {}
    for bearing in bearings:
        own = {name: column[sample["bearing"] == bearing] for name, column in sample.items()}
        spreads += [_spread(own, bearing, output) for output in study.outputs]
        capabilities += _capabilities(own, bearing)
        for output, shares in _tornados(own, study.inputs, (*study.outputs, "margin")).items():
            tornado[bearing, output] = shares
    capabilities.sort(key=lambda one: (-one.failures, one.cpk if math.isfinite(one.cpk) else math.inf))
    return ToleranceSummary(
        tuple(yields),
        tuple(one for one in spreads if math.isfinite(one.mean)),
        tuple(capabilities),
        _worst(sample),
        _worst(study.of(CORNER)),
        tornado,
    )


def _yield(sample: Columns, bearing: str, batches: Sequence[int], sampling: str) -> Yield:
    """Share within limits; a row without an answer for a bearing has failed for it."""
    rows, places = np.unique(sample["row"], return_inverse=True)
    bad = ~np.isin(sample["verdict"], WITHIN)
    unsolved = sample["verdict"] == Verdict.NO_SOLUTION.key
    if bearing:
        of_it = (sample["bearing"] == bearing) | (sample["bearing"] == "")
        bad, unsolved = bad & of_it, unsolved & of_it
    failed = np.bincount(places, weights=bad, minlength=rows.size) > 0
    without = int((np.bincount(places, weights=unsolved, minlength=rows.size) > 0).sum())
    within = ~failed
    share, low, high, method = yield_of(within, batches, sampling)
    return Yield(bearing or ALL, rows.size, int(within.sum()), without, share, low, high, method)


def yield_of(within: NDArray[np.bool_], batches: Sequence[int], sampling: str) -> tuple[float, float, float, str]:
    """Share within limits, with the ends of its 95 % interval and how they were found.

    Random samples: exact binomial interval (Clopper and Pearson 1934). Hypercubes and Sobol sequences, whose
    points are not independent: Student's t over independent batches; the binomial interval, which is wider, where
    all batches agree or there is one.
    """
    count, good = within.size, int(within.sum())
    share = good / count if count else math.nan
    exact = stats.binomtest(good, count).proportion_ci(CONFIDENCE, "exact") if count else None
    low, high = (float(exact.low), float(exact.high)) if exact is not None else (math.nan, math.nan)
    if sampling == "random" or len(batches) < 2 or sum(batches) != count:
        name = "binomial" if sampling == "random" else "binomial, wider than that of an even sample"
        return share, low, high, name
    ends = np.cumsum(batches)
    means = np.array([part.mean() for part in np.split(within, ends[:-1])])
    deviation = float(means.std(ddof=1))
    if deviation == 0.0:
        return share, low, high, "binomial, as all batches agree"
    half = float(stats.t.ppf(0.5 * (1.0 + CONFIDENCE), means.size - 1)) * deviation / math.sqrt(means.size)
    return share, max(0.0, share - half), min(1.0, share + half), f"{means.size} batches"


def _spread(own: Columns, bearing: str, output: str) -> Spread:
    values = own[output][np.isfinite(own[output])]
    if not values.size:
        return Spread(bearing, output, math.nan, math.nan, math.nan, math.nan, {})
    found = np.percentile(values, PERCENTILES)
    deviation = float(values.std(ddof=1)) if values.size > 1 else 0.0
    percentiles = dict(zip(PERCENTILES, map(float, found), strict=True))
    return Spread(
        bearing, output, float(values.mean()), deviation, float(values.min()), float(values.max()), percentiles
    )


def _capabilities(own: Columns, bearing: str) -> list[Capability]:
    made = []
    solved = own["verdict"] != Verdict.NO_SOLUTION.key
    failed = [set(str(codes).split()) for codes in own["failed_checks"]]
    codes = [name.removeprefix("margin_") for name in own if name.startswith("margin_")]
    codes += sorted(set().union(*failed) - set(codes)) if failed else []
    for code in codes:
        failures = sum(code in one for one in failed)
        margins = own.get(f"margin_{code}", np.full(solved.size, np.nan))
        margins = margins[np.isfinite(margins)]
        deviation = float(margins.std(ddof=1)) if margins.size > 1 else 0.0
        varies = margins.size > 1 and deviation > CONSTANT * abs(float(margins.mean()))
        cpk = float(margins.mean()) / (3.0 * deviation) if varies else math.nan
        samples = max(margins.size, failures)
        made.append(Capability(bearing, code, failures, samples, cpk, _near_normal(margins), varies))
    return made


def _near_normal(values: Array) -> bool:
    if values.size < 3 or values.std() <= CONSTANT * abs(values.mean()):
        return False
    return bool(abs(stats.skew(values)) < NEAR_NORMAL[0] and abs(stats.kurtosis(values)) < NEAR_NORMAL[1])


def _worst(columns: Columns) -> dict[str, Any] | None:
    """The line with the least margin."""
    if not columns["row"].size:
        return None
    margin = columns["margin"].copy()
    margin[columns["verdict"] == Verdict.NO_SOLUTION.key] = -np.inf
    if not np.any(np.isfinite(margin) | np.isneginf(margin)):
        return None
    place = int(np.nanargmin(margin))
    return {name: column[place] for name, column in columns.items()}


def _tornados(
    own: Columns, inputs: Sequence[dict[str, Any]], outputs: Sequence[str]
) -> dict[str, dict[str, float]]:
    """By output and input squared rank correlations with their sign; NaN where one of both is constant."""
    paths = [one["path"] for one in inputs if "values" not in one]
    whole = {path: _ranks(own[path]) for path in paths}
    made = {}
    for output in outputs:
        known = np.isfinite(own[output])
        ranks = _ranks(own[output][known])
        given = whole if known.all() else {path: _ranks(own[path][known]) for path in paths}
        made[output] = {path: _signed_square(given[path], ranks) for path in paths}
    return made


def _ranks(values: Array) -> Array:
    """Ranks about their mean, ties sharing theirs, as a vector of length one; zeros of what does not vary."""
    ranks = stats.rankdata(values) - 0.5 * (values.size + 1)
    length = float(np.linalg.norm(ranks))
    return np.asarray(ranks / length if length > 0.0 else ranks)


def _signed_square(one: Array, other: Array) -> float:
    """Square of the correlation of two vectors of length one, with its sign (Spearman 1904)."""
    if not one.any() or not other.any():
        return math.nan
    rho = float(one @ other)
    return math.copysign(rho * rho, rho)
