"""Rows of a study of journal bearings by ISO 7902, and of plain films of one temperature, solved as arrays.

The case is read once for each combination of words. Its numbers that vary become `Lanes`, are held against the
ranges of their fields as arrays, and pass the rules of the case, its design cases and the procedure as a single
number would. Rows that this does not know are solved one by one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.case.case_file import CaseFile
from babbitt.core.limited_flow import value_kept
from babbitt.core.notices import InputError
from babbitt.core.result import Result, Verdict
from babbitt.kinds.journal.film.many import PRODUCED, films_many
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.iso7902.many import check_many
from babbitt.kinds.journal.iso7902.model import DesignCase
from babbitt.numerics.lanes import assembled, in_branches, lanes_of
from babbitt.study.patched_case import ENDS, Steps, is_empty, patched, way_to
from babbitt.study.rows import (
    Columns,
    RowTask,
    answers_of_arrays,
    joined,
    kelvin_name,
    solved_one_by_one,
)

__all__ = ["solve_many"]

Index = NDArray[np.intp]
Problem = DesignCase | FilmCase

FEWEST = 16
"""Rows from which arrays are faster."""

MOST_TRIED = 8
"""Rows of a group of which one must be a case."""

OF_THE_SEARCH = ("iterations", "wall_time")
"""Results that tell how one bearing was found."""


def solve_many(task: RowTask, rows: Columns) -> Columns | None:
    """Solve rows as arrays, equal to one by one (`babbitt.study.rows.SolvesMany`)."""
    count = rows["row"].size
    if count < FEWEST or set(task.outputs) & set(OF_THE_SEARCH):
        return None
    parts: list[_Part] = []
    for index in _groups(task, rows, count):
        parts += _solved(task, rows, index)
    done = np.concatenate([part.places for part in parts]) if parts else np.empty(0, np.intp)
    left = np.flatnonzero(~np.isin(np.arange(count), done))
    if left.size == count:
        return None
    if left.size:
        parts.append(_one_by_one(task, {name: column[left] for name, column in rows.items()}, left))
    table = joined([part.columns for part in parts])
    order = np.lexsort((
        np.concatenate([part.orders for part in parts]), np.concatenate([part.places for part in parts])
    ))  # fmt: skip
    return {name: column[order] for name, column in table.items()}


@dataclass(frozen=True, eq=False)
class _Part:
    """Lines of a table, with the place of their row and their order within it."""

    places: Index
    orders: Index
    columns: Columns


def _one_by_one(task: RowTask, rows: Columns, places: Index) -> _Part:
    columns = solved_one_by_one(task, rows)
    of_row = dict(zip(rows["row"].tolist(), places.tolist(), strict=True))
    lines = np.array([of_row[number] for number in columns["row"].tolist()])
    return _Part(lines, np.arange(lines.size), columns)


def _groups(task: RowTask, rows: Columns, count: int) -> list[Index]:
    """Rows that differ in numbers alone: alike in words, whole numbers, and what their table leaves empty."""
    keys = []
    for one in task.inputs:
        column = rows[one.path]
        if one.is_choice or one.form not in ENDS:
            keys.append([str(value) for value in column])
        elif np.isnan(column).any():
            keys.append([str(is_empty(value)) for value in column])
    if not keys:
        return [np.arange(count)]
    _, of = np.unique(np.array(["\0".join(key) for key in zip(*keys, strict=True)]), return_inverse=True)
    return [np.flatnonzero(of == number) for number in range(int(of.max()) + 1)]


def _solved(task: RowTask, rows: Columns, index: Index) -> list[_Part]:
    """The rows of a group, as far as they are known as arrays."""
    own = {name: column[index] for name, column in rows.items()}
    case = _read(task, own) if index.size >= FEWEST else None
    if case is None:
        return []
    read, values = case
    calculations = read.calculations()
    if not all(_is_known(one.problem, task) for one in calculations):
        return []
    varied = _varied(task, own, read, values)
    if varied is None:
        return []
    names = [str(one.problem.name) for one in calculations]
    parts: list[_Part] = []
    for lanes, cases in _in_few_groups(read, varied, index.size):
        if [str(one.name) for one in cases] != names:
            continue
        found = [_answers(task, own, lanes, one) for one in cases]
        known = np.logical_and.reduce([np.isin(lanes, _lanes_in(answers)) for answers in found])
        keep = lanes[known]  # a row of which one bearing is left is left as a whole
        for order, answers in enumerate(found):
            for places, columns in answers:
                chosen = np.isin(places, keep)
                kept = {name: column[chosen] for name, column in columns.items()}
                parts.append(_Part(index[places[chosen]], np.full(int(chosen.sum()), order), kept))
    return parts


def _in_few_groups(
    case: CaseFile, varied: Mapping[Steps, NDArray[np.float64]], count: int
) -> list[tuple[Index, Sequence[Problem]]]:
    """Rows that the case takes, with their problems, those together that differ in numbers alone."""
    found = in_branches(lambda chosen: _problems(case, varied, chosen), np.arange(count))
    groups = [(index, cases) for index, cases in found if cases]
    try:
        every = np.concatenate([index for index, _ in groups] or [np.empty(0, np.intp)])
        order = np.argsort(every)
        rank = np.empty_like(order)
        rank[order] = np.arange(order.size)
        ends = np.cumsum([index.size for index, _ in groups])
        parts = [(rank[end - index.size : end], cases) for end, (index, cases) in zip(ends, groups, strict=True)]
        return [(every[order], assembled(parts))] if parts else []
    except ValueError:
        return groups


def _read(task: RowTask, rows: Columns) -> tuple[CaseFile, dict[str, Any]] | None:
    """The case of one of the rows, with its values; None where the first ones are no cases."""
    for place in range(min(MOST_TRIED, rows["row"].size)):
        values = {name: column[place] for name, column in rows.items()}
        try:
            return task.case(values), values
        except InputError:
            continue
    return None


def _is_known(problem: Any, task: RowTask) -> bool:
    """Whether a problem is one that may be solved as arrays, and has all results that are kept."""
    if isinstance(problem, FilmCase):
        return set(task.outputs) <= PRODUCED
    return isinstance(problem, DesignCase) and not _has_ducts(problem)


def _has_ducts(case: DesignCase) -> bool:
    """Whether oil comes through tubes or holes whose losses are balanced by a search of their own."""
    supply = case.oil_supply
    return supply is not None and bool(supply.tubes or supply.holes)


def _varied(
    task: RowTask, rows: Columns, case: CaseFile, values: Mapping[str, Any]
) -> dict[Steps, NDArray[np.float64]] | None:
    """Columns by the way to their numbers in the case that was read; None where one is not found there."""
    made = {}
    for one in task.inputs:
        if one.is_choice or one.form not in ENDS or is_empty(values[one.path]):
            continue
        steps = way_to(case, one, values[one.path])
        if steps is None:
            return None
        made[steps] = rows[one.path]
    return made


def _problems(case: CaseFile, varied: Mapping[Steps, NDArray[np.float64]], chosen: Index) -> Sequence[Problem]:
    """Problems of some rows, their numbers in lanes; none for rows that the case does not take."""
    found = patched(case, {steps: lanes_of(column[chosen]) for steps, column in varied.items()})
    if found is None:
        return ()
    return tuple(one.problem for one in found.calculations() if isinstance(one.problem, Problem))


def _answers(task: RowTask, rows: Columns, lanes: Index, case: Problem) -> list[tuple[Index, Columns]]:
    """Places of rows with their columns, of one bearing."""
    made = []
    solve = films_many if isinstance(case, FilmCase) else check_many
    for index, result, verdict in solve(case, lanes.size):  # type: ignore[arg-type]
        places = lanes[index]
        own = {name: column[places] for name, column in rows.items()}
        made.append((places, _columns(task, own, str(case.name), result, verdict)))
    return made


def _columns(task: RowTask, rows: Columns, name: str, result: Result, verdict: Verdict) -> Columns:
    count = rows["row"].size

    def column(value: Any) -> NDArray[np.float64]:
        return np.broadcast_to(np.asarray(value, float), (count,))

    margins: dict[str, NDArray[np.float64]] = {}
    advisories: dict[str, NDArray[np.float64]] = {}
    kelvins: dict[str, NDArray[np.float64]] = {}
    for check in result.checks:
        kept, margin = advisories if check.advisory else margins, column(check.margin)
        kept[check.code] = np.minimum(margin, kept.get(check.code, margin))
        if check.is_in_kelvin and not check.advisory:
            gap, kelvin = column(check.gap), kelvin_name(check.code)
            kelvins[kelvin] = np.minimum(gap, kelvins.get(kelvin, gap))
    values = {one: column(value_kept(result, one)) for one in task.outputs}
    verdicts, codes = np.full(count, verdict.key, object), " ".join(result.questioning_codes)
    return answers_of_arrays(task, rows, name, values | kelvins, margins, verdicts, advisories, codes)


def _lanes_in(answers: Sequence[tuple[Index, Columns]]) -> Index:
    return np.concatenate([places for places, _ in answers]) if answers else np.empty(0, np.intp)
