"""One row of a study, solved before all others: what its results are says what there is to be kept."""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.case.case_file import CaseFile
from babbitt.core.notices import InputError
from babbitt.core.result import Result
from babbitt.study import grids
from babbitt.study.rows import Columns, RowTask

__all__ = ["Example", "first_solved", "nominal_example"]

MOST_EXAMPLES = 20
"""Rows of a table among which one is sought that is solved."""


@dataclass(frozen=True, eq=False)
class Example:
    """One row of a study with its answers, which say what there is to be kept."""

    values: Columns
    results: tuple[Result, ...]


def nominal_example(case: CaseFile, task: RowTask) -> Example:
    """The answers at the medians; where the case does not take these, those of the case as it stands."""
    values, _ = grids.nominal(task.inputs)
    try:
        return Example(values, _results(task.case(grids.first_of(values))))
    except InputError:
        return Example(values, _results(case))


def first_solved(case: CaseFile, task: RowTask, values: Columns) -> Example:
    """The first row of a table that is solved; the case as it stands where none of the first ones is."""
    count = next(iter(values.values())).size
    for place in [one for one in range(count) if one not in task.refused][:MOST_EXAMPLES]:
        row = {path: column[place : place + 1] for path, column in values.items()}
        try:
            results = _results(task.case(grids.first_of(row)))
        except (InputError, ArithmeticError, ValueError, RuntimeError):
            continue
        if all(one.outcome.solved for one in results):
            return Example(row, results)
    return Example({path: column[:1] for path, column in values.items()}, _results(case))


def _results(case: CaseFile) -> tuple[Result, ...]:
    return tuple(one.solve()[0].result for one in case.calculations())
