"""The permitted values of one field of a case: largest load, window of the clearance, least speed or width."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.case.case_file import CaseFile
from babbitt.case.loading import case_from_dict
from babbitt.case.parts.study import StudyBlock, Vary
from babbitt.case.variation import variation_of
from babbitt.case.with_units import short_quantity
from babbitt.core.notices import InputError
from babbitt.core.result import Verdict
from babbitt.study.appraisal import ALL_LIMITS
from babbitt.study.corners import leaves_out_limits
from babbitt.study.fields import numbers_of, path_in, present_quantity
from babbitt.study.permitted import Interval, Trial, find_permitted
from babbitt.study.rows import Columns, RowTask, joined, kelvin_name
from babbitt.study.size_choices import preferred_numbers, standard_choices

if TYPE_CHECKING:
    from babbitt.study.engine import Engine
    from babbitt.study.study import Study

__all__ = [
    "LOGARITHMIC_FROM",
    "SCAN_POINTS",
    "Size",
    "default_scan",
    "scan_of",
    "searched",
    "size_block",
    "size_of",
]

SCAN, END, PREFERRED = "scan", "end", "preferred"
"""What rows are for."""

SCAN_POINTS, MOST_POINTS = 64, 2000
"""Values of one scan: if nothing is said, and at most."""

LOGARITHMIC_FROM = 20.0
"""Ratio of last and first value from which the values of a scan have equal ratios, else equal distances."""

DECADE = 10.0
"""Factor below and above the value of the case that a scan covers where no range is given."""

PERMITTED = (Verdict.PASS.key, Verdict.REMARKS.key)


@dataclass(frozen=True, repr=False)
class Size:
    """The permitted values of a field.

    Attributes
    ----------
    name, path : str
        Of the case; the field.
    unit : str
        Of all values, in SI.
    present : float or None
        What the case itself has in the field.
    limits : tuple of str
        ``("all",)``, ``("recommended",)`` or the codes asked for.
    over_tolerance : bool
        Whether the limits hold at the smallest, mean and largest clearance of the tolerances.
    at_mean : bool
        Whether some limits alone hold at the mean of a clearance that has a smallest and a largest value: unlike
        all limits they are not held at those, too.
    intervals : tuple of Interval
        Ascending; empty where no value of the scan is permitted, and for choices.
    scan : tuple of Trial
    preferred : tuple of Trial
        Of the preferred numbers within the intervals, where they were asked for.
    choices : mapping of str to Trial
        By the choice as it stands in a case file; empty for numbers.
    """

    name: str
    path: str
    unit: str
    present: float | None
    limits: tuple[str, ...]
    over_tolerance: bool
    at_mean: bool
    intervals: tuple[Interval, ...]
    scan: tuple[Trial, ...]
    preferred: tuple[Trial, ...]
    choices: Mapping[str, Trial]

    def __repr__(self) -> str:
        chosen = [name for name, one in self.choices.items() if one.permitted]
        ranges = [f"{one.lower.value:.6g} to {one.upper.value:.6g} {self.unit}" for one in self.intervals]
        permitted = ", ".join([*ranges, *chosen]) or "nothing"
        return f"{self.name}: {self.path} permitted: {permitted}\n  .intervals, .scan, .choices"

    @property
    def steps(self) -> str:
        """How the values of the scan stand: at equal ``distances`` or ``ratios``; empty where they do neither."""
        values = np.array([one.value for one in self.scan])
        if _are_alike(np.diff(values)):
            return "distances"
        return "ratios" if (values > 0.0).all() and _are_alike(values[1:] / values[:-1]) else ""

    @property
    def permitted(self) -> bool:
        """Whether any value or choice is permitted."""
        return any(one.permitted for one in self.scan)

    @property
    def nearest_miss(self) -> Trial | None:
        """Of the values that are not permitted the one with the largest margin; None where none has a margin."""
        missed = [one for one in self.scan if not one.permitted and math.isfinite(one.margin)]
        return max(missed, key=lambda one: one.margin, default=None)


def _are_alike(steps: NDArray[np.float64]) -> bool:
    return bool(np.allclose(steps, steps[:1], rtol=1e-3, atol=0.0))


def default_scan(case: CaseFile, block: StudyBlock) -> StudyBlock:
    """A size with the values that it tries if none are given: choices of the field, or a decade to each side."""
    if block.field is None:
        return block
    vary = size_block(case, block.field).vary
    return block.model_copy(update={"vary": vary, "field": None})


def scan_of(case: CaseFile, path: str, first: Any = None, last: Any = None, points: int = SCAN_POINTS) -> Vary:
    """Values of a scan: with equal ratios over a wide range of positive numbers, else with equal distances.

    Parameters
    ----------
    case : CaseFile
    path : str
    first, last : quantity, optional
        As a case file has them; one that is not given lies a decade from what the case has in the field.
    points : int

    Raises
    ------
    InputError
        E003 for ends that are no quantities of the field or do not ascend, for fewer than 2 or more than
        `MOST_POINTS` values, and where an end is needed: the case has no positive number in the field, or a
        temperature, of which a decade means nothing.
    """
    number, kind = numbers_of(case, path)
    if not 2 <= points <= MOST_POINTS:
        raise InputError("E003", f"a scan has 2 to {MOST_POINTS} points, not {points}")
    present = present_quantity(case, path)
    if (first is None or last is None) and (present is None or present <= 0.0 or kind.offsets):
        says = "the case has no number in" if present is None else "a decade means nothing about the value of"
        raise InputError("E003", f"{says} '{path}'; give both ends of a range (--from and --to)")
    low = number(first) if first is not None else (present or 0.0) / DECADE
    high = number(last) if last is not None else (present or 0.0) * DECADE
    unit = "" if kind.one_unit else f" {kind.unit}"
    begin, end = (
        given if isinstance(given, str) else f"{value!r}{unit}" for given, value in ((first, low), (last, high))
    )
    if not low < high:
        said = [
            short_quantity(each, kind) if given is None else given for given, each in ((first, low), (last, high))
        ]
        raise InputError(
            "E003", f"'{path}': the range begins at {said[0]} and ends at {said[1]}; give a larger end"
        )
    name = "log_range" if low > 0.0 and high >= LOGARITHMIC_FROM * low else "range"
    return Vary.model_validate({name: (begin, end, points)})


def size_block(
    case: CaseFile,
    path: str,
    first: Any = None,
    last: Any = None,
    points: int = SCAN_POINTS,
    among: Sequence[Any] = (),
    limits: Sequence[str] = (ALL_LIMITS,),
    over_tolerance: bool = False,
    preferred: bool = False,
) -> StudyBlock:
    """A study of kind size; arguments are those of `scan_of` and of the block of a case file.

    Raises
    ------
    InputError
        As `scan_of`.
    """
    ranged = first is not None or last is not None
    words = among or (() if ranged else _choices(case, path))
    vary = Vary(values=tuple(words)) if words else scan_of(case, path, first, last, points)
    return StudyBlock(
        kind="size", vary={path: vary}, limits=tuple(limits), over_tolerance=over_tolerance, preferred=preferred
    )


def _choices(case: CaseFile, path: str) -> tuple[str, ...]:
    """What people choose among in a field, with what the case itself has there."""
    usual = standard_choices(path)
    own = variation_of(case, path_in(case, path)).present if usual else None
    return usual if own in usual or not isinstance(own, str) else (own, *usual)


def searched(task: RowTask, block: StudyBlock, engine: Engine) -> Columns:
    """Compute the scan, then every end of a permitted interval, then the preferred numbers within."""
    (one,) = task.inputs
    values = one.listed if one.is_choice else np.unique(one.listed)
    parts = [engine.answers({one.path: values}, SCAN)]
    if one.is_choice:
        return parts[0]

    def answered(value: float) -> Trial:
        parts.append(engine.answers({one.path: np.array([value])}, END))
        return _trials(parts[-1], one.path)[0]

    intervals = _permitted(_trials(parts[0], one.path), answered)
    numbers = preferred_numbers(intervals, one.unit) if block.preferred else ()
    if numbers:
        parts.append(engine.answers({one.path: np.array(numbers)}, PREFERRED))
    return joined(parts)


def size_of(study: Study) -> Size:
    """The permitted intervals of a study, or its permitted choices.

    Raises
    ------
    InputError
        E007 for a study that was interrupted.
    """
    (about,) = study.inputs
    path, block = about["path"], study.block
    scan = _trials(study.of(SCAN), path)
    choices = (
        dict(zip(map(str, dict.fromkeys(study.columns[path])), scan, strict=True)) if "values" in about else {}
    )
    ends = {one.value: one for one in _trials(study.of(END), path)}
    try:
        intervals = () if choices else _permitted(scan, ends.__getitem__)
    except KeyError:
        raise InputError("E007", "the study is not finished; the same command goes on") from None
    case = case_from_dict(dict(study.description["case"]), study.description["name"])
    return Size(
        str(study.description["name"]),
        path,
        about["unit"],
        None if choices else present_quantity(case, path),
        block.limits,
        block.over_tolerance,
        not block.over_tolerance and block.limits != (ALL_LIMITS,) and leaves_out_limits(case),
        intervals,
        scan,
        _trials(study.of(PREFERRED), path),
        choices,
    )


def _permitted(scan: Sequence[Trial], answered: Callable[[float], Trial]) -> tuple[Interval, ...]:
    """The permitted intervals; each value is asked for once."""
    known = {one.value: one for one in scan}

    def tried(value: float) -> Trial:
        if value not in known:
            known[value] = answered(value)
        return known[value]

    return find_permitted(scan, tried)


def _trials(columns: Columns, path: str) -> tuple[Trial, ...]:
    """How the bearings of each row do: the one that does worst decides."""
    lines: dict[int, list[Trial]] = {}
    places: dict[str, int] = {}
    for place, row in enumerate(columns["row"].tolist()):
        value = columns[path][place]
        at = float(places.setdefault(value, len(places))) if isinstance(value, str) else float(value)
        lines.setdefault(row, []).append(_of_line(columns, place, at))
    made = []
    for found in lines.values():
        remarks = tuple(dict.fromkeys(code for one in found for code in one.remarks))
        worst = min(found, key=_standing)
        made.append(Trial(**{**vars(worst), "remarks": remarks}))
    return tuple(made)


def _of_line(columns: Columns, place: int, value: float) -> Trial:
    """How one bearing does."""
    verdict, message = str(columns["verdict"][place]), str(columns["message"][place])
    permitted, bearing = verdict in PERMITTED, str(columns["bearing"][place])
    if permitted or verdict == Verdict.FAIL.key:
        code, margin = str(columns["governing_check"][place]), float(columns["margin"][place])
        remarks = tuple(str(columns["codes"][place]).split()) if permitted else ()
        warm = columns.get(kelvin_name(code))
        kelvin = math.nan if warm is None else float(warm[place])
        return Trial(value, permitted, margin, code, bearing, "" if permitted else message, remarks, kelvin)
    code = found[0] if (found := re.match(r"[A-Z]\d{3}\b", message)) else ""
    return Trial(value, False, math.nan, code, bearing, message)


def _standing(one: Trial) -> tuple[bool, float]:
    """What sorts the worst bearing first: one that fails without a margin, then the least margin."""
    return one.permitted, one.margin if math.isfinite(one.margin) else math.inf if one.permitted else -math.inf
