"""Sweeps: a case solved for every value of one of its fields, each value through the whole case."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from babbitt.case.case_file import CaseFile
from babbitt.case.variation import variation_of
from babbitt.core.notices import InputError
from babbitt.core.result import Outcome, Result
from babbitt.study.case_sweep import SweepTask, answers_of
from babbitt.study.inputs import Input
from babbitt.study.laws import Listed

__all__ = ["Sweep", "sweep", "swept"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Sweep:
    """Answers over one varied number.

    Attributes
    ----------
    path : str
        Which number of the case was varied, such as ``"clearance.mean"``.
    points : ndarray, shape (n,)
        The values it took, in SI.
    outcomes : tuple of Outcome or None, length n
        How each calculation ended; None where the case refuses the value.
    values : Mapping[str, ndarray]
        Each named result in SI, shape (n,); NaN where there is no operating point, so that a curve has a gap.
    refused : Mapping[int, str]
        Place of every value that was refused, and why.
    """

    path: str
    points: Array
    outcomes: tuple[Outcome | None, ...]
    values: Mapping[str, Array]
    refused: Mapping[int, str] = field(default_factory=dict)

    @property
    def solved(self) -> NDArray[np.bool_]:
        """Which points have an operating point, shape (n,)."""
        return np.array([outcome is not None and outcome.solved for outcome in self.outcomes], dtype=np.bool_)

    def __getitem__(self, name: str) -> Array:
        """Named result over the sweep, shape (n,); all NaN if no point has it."""
        return self.values.get(name, np.full(self.points.shape, np.nan))


def sweep(case: CaseFile, path: str, points: Iterable[float], name: str | None = None) -> Sweep:
    """Solve a case for each value of one of its fields.

    Every value goes through the whole case, as if it stood in the file: what the case derives from the field
    follows it, and a value that the case does not take is refused.

    Parameters
    ----------
    case : CaseFile
        From `babbitt.load_case`, `babbitt.parse_case` or `babbitt.case.case_from_dict`.
    path : str
        The field as the file has it: ``"load"``, ``"clearance.mean"``, ``"operating_points.0.speed"``.
    points : iterable of float
        Values in SI.
    name : str, optional
        Of the result, where the case has several.

    Returns
    -------
    Sweep
        Every point has an outcome; one that is not solved or refused leaves a gap and stops nothing.

    Raises
    ------
    TypeError
        If `case` is not a case, such as a design or the path of a file.
    InputError
        If every point is refused, what the first is refused for. E005 where the case has no such result, or
        several and none is named, and for a case that was not read or was changed since.

    Examples
    --------
    >>> import babbitt
    >>> found = sweep(babbitt.parse_case(babbitt.template("journal")), "load", [4e3, 8e3])
    >>> bool(found["minimum_film_thickness"][0] > found["minimum_film_thickness"][1])
    True
    """
    if not isinstance(case, CaseFile):
        given = type(case).__name__
        raise TypeError(
            f"sweep takes a case, not {given}; read one with babbitt.load_case(path) or parse_case(text)"
        )
    taken = [float(point) for point in points]
    if not taken:
        return swept(path, [], [], {})
    variation = variation_of(case, path)
    varied = Input(path, variation.field, Listed(tuple(taken)))
    task = SweepTask(case.kind, variation.given, variation.file, variation.reach, (varied,))
    found = answers_of(task)
    chosen = name or _only_name(case.name, found.results.values())
    by_place = {place: _named(results, chosen) for place, results in found.results.items()}
    if not any(by_place.values()):
        there = ", ".join(_names(found.results.values()))
        raise InputError("E005", f"{case.name}: no result '{chosen}'; there are: {there}")
    return swept(path, taken, [by_place.get(place) for place in range(len(taken))], found.refused)


def swept(path: str, points: list[float], results: list[Result | None], refused: Mapping[int, str]) -> Sweep:
    """Gather answers, None where there is none, into curves."""
    names = dict.fromkeys(name for result in results if result is not None for name in result.values)
    values = {name: np.array([_value(result, name) for result in results]) for name in names}
    outcomes = tuple(None if result is None else result.outcome for result in results)
    return Sweep(path, np.array(points), outcomes, values, refused)


def _value(result: Result | None, name: str) -> float:
    return np.nan if result is None or not result.outcome.solved else result.values.get(name, np.nan)


def _named(results: Iterable[Result], name: str) -> Result | None:
    return next((result for result in results if result.name == name), None)


def _names(answers: Iterable[Iterable[Result]]) -> dict[str, None]:
    return dict.fromkeys(result.name for results in answers for result in results)


def _only_name(case: str, answers: Iterable[Iterable[Result]]) -> str:
    names = list(_names(answers))
    if len(names) > 1:
        raise InputError("E005", f"{case}: there are several results, name one of them: {', '.join(names)}")
    return names[0] if names else ""
