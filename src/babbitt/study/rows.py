"""Rows of a study: a pure function of the case and the values in its fields, whoever computes it, and where."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from textwrap import shorten
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from babbitt.case.case_file import CaseFile
from babbitt.case.loading import build_case
from babbitt.case.named_files import NamedFiles
from babbitt.core.files.printing import printable
from babbitt.core.files.reading import Reach
from babbitt.core.kind import find_kind, imported
from babbitt.core.limited_flow import value_kept
from babbitt.core.notices import InputError
from babbitt.core.result import ROUND_OFF, Outcome, Result, Verdict
from babbitt.core.result_name import ResultName
from babbitt.study.appraisal import ALL_LIMITS, appraised
from babbitt.study.inputs import Input
from babbitt.study.patched_case import PatchedCases, is_empty
from babbitt.study.shares import given_with

__all__ = [
    "Columns",
    "RowTask",
    "SolvesMany",
    "advisory_name",
    "answers_of_arrays",
    "empty_answers",
    "joined",
    "answered",
    "kelvin_name",
    "margin_name",
    "solved_as_arrays",
    "solved_one_by_one",
    "solved_rows",
]

Columns: TypeAlias = "dict[str, NDArray[Any]]"
"""Arrays of one length by the names of their columns: float64, int64, or words (object)."""

REFUSED, ERROR = "refused", "error"
"""Status of a row that the case does not take, and of one whose computation broke off."""

WORDS = ("group", "bearing", "status", "verdict", "governing_check", "failed_checks", "codes", "message")
"""Columns of words that every table has."""

LONGEST_MESSAGE = 300
"""Characters of the reason of a row without an answer."""


@dataclass(frozen=True, eq=False)
class RowTask:
    """What every row of a study has in common.

    Attributes
    ----------
    kind : str
        Of the case.
    given : Mapping
        The case, with what its named files hold in their place, so that it can be solved anywhere.
    file : Path
        What messages call the case.
    reach : Reach
        Where the case may name other files.
    inputs : tuple of Input
        The fields that vary.
    outputs : tuple of str
        Quantities of the results that are kept.
    codes : tuple of str
        Limits whose margins are kept.
    advisories : tuple of str
        Recommendations and screening indicators whose margins are kept.
    limits : tuple of str
        What counts (`babbitt.study.appraisal.appraised`), where the study says so: messages then tell why a row
        does not pass. All limits where it does not, and messages of rows without an answer alone.
    temperatures : tuple of str
        Of `codes` those whose margins are kept in K, too.
    refused : mapping of int to str
        Rows that are no case, by their numbers, and why.
    table : str
        Name of the table in which the rows stand, which messages name in place of the file; empty without one.
    """

    kind: str
    given: Mapping[str, Any]
    file: Path
    reach: Reach
    inputs: tuple[Input, ...]
    outputs: tuple[str, ...] = ()
    codes: tuple[str, ...] = ()
    advisories: tuple[str, ...] = ()
    limits: tuple[str, ...] = ()
    temperatures: tuple[str, ...] = ()
    refused: Mapping[int, str] = field(default_factory=dict)
    table: str = ""

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all columns, in their order."""
        margins = (*map(margin_name, self.codes), *map(advisory_name, self.advisories))
        margins = (*margins, *map(kelvin_name, self.temperatures))
        inputs = tuple(one.path for one in self.inputs)
        return ("row", "group", "bearing", *inputs, *self.outputs, *margins, "margin", *WORDS[2:])

    def words_of(self) -> frozenset[str]:
        """Names of the columns that hold words."""
        return frozenset(WORDS) | {one.path for one in self.inputs if one.is_choice}

    def case(self, values: Mapping[str, Any]) -> CaseFile:
        """The case with values of a row in its fields; NaN or an empty word leaves what it says.

        Raises
        ------
        InputError
            For a value that the case does not take.
        """
        return self.titled(values, "")

    def titled(self, values: Mapping[str, Any], title: str) -> CaseFile:
        """The case as `case` gives it; `title` stands behind its name in messages."""
        given = dict(self.given)
        for one in self.inputs:
            if not is_empty(values[one.path]):
                given = given_with(one, given, self.file, self.reach, values[one.path])
        name = f"{printable(self.file)}{title}" if title else self.table or self.file.name
        return build_case(given, name, NamedFiles(self.file.parent, self.reach))

    def answers(self, rows: Columns) -> Columns:
        """Answer rows."""
        return solved_rows(self, rows)


class SolvesMany(Protocol):
    """What a kind may offer for many rows at once: arrays through its method, without an object a row."""

    def __call__(self, task: RowTask, rows: Columns) -> Columns | None:
        """Answer rows as `solved_rows` does, equal to it; None for a case or fields that it does not know."""


def margin_name(code: str) -> str:
    """Name of the column with the margin of a check."""
    return f"margin_{code}"


def advisory_name(code: str) -> str:
    """Name of the column with the margin of a recommendation or screening indicator."""
    return f"advisory_{code}"


def kelvin_name(code: str) -> str:
    """Name of the column with the margin of a check in K."""
    return f"kelvin_{code}"


def answered(task: RowTask, rows: Columns) -> Columns:
    """Answer rows: what a worker is given to do."""
    return task.answers(rows)


def solved_rows(task: RowTask, rows: Columns) -> Columns:
    """Solve rows one by one, or many at once where the kind can.

    Parameters
    ----------
    task : RowTask
    rows : Columns
        ``row`` (its number), ``group`` (what it is for) and a column for each input.

    Returns
    -------
    Columns
        Those of `RowTask.names`, a line for each row and bearing (operating point, clearance) of the case. A row
        that is refused or has no solution says why and stops nothing.
    """
    if (no_case := np.isin(rows["row"], list(task.refused))).any():
        return _with_refused(task, rows, no_case)
    found = solved_as_arrays(task, rows)
    return found if found is not None else solved_one_by_one(task, rows)


def _with_refused(task: RowTask, rows: Columns, no_case: NDArray[np.bool_]) -> Columns:
    """Answers of rows some of which are no case, in the order of the rows."""
    others = {name: column[~no_case] for name, column in rows.items()}
    parts = [solved_rows(task, others)] if others["row"].size else []
    lost = (_at(rows, int(place)) for place in np.flatnonzero(no_case))
    parts.append(_columns(task, [{**row, **_without_answer(REFUSED, task.refused[row["row"]])} for row in lost]))
    table = joined(parts)
    order = np.argsort(table["row"], kind="stable")
    return {name: column[order] for name, column in table.items()}


def solved_as_arrays(task: RowTask, rows: Columns) -> Columns | None:
    """Solve rows many at once where the kind can; None where it cannot."""
    kind = find_kind(task.kind)
    if kind is None or not kind.solve_many or task.limits:
        return None
    many: SolvesMany = imported(kind.solve_many)
    return many(task, rows)


def solved_one_by_one(task: RowTask, rows: Columns) -> Columns:
    """Solve rows case by case; parameters and columns as of `solved_rows`."""
    cases = PatchedCases(task)
    lines = [line for place in range(rows["row"].size) for line in _lines(task, cases, _at(rows, place))]
    return _columns(task, lines)


def _at(rows: Columns, place: int) -> dict[str, Any]:
    return {name: column[place] for name, column in rows.items()}


def _lines(task: RowTask, cases: PatchedCases, row: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """The answers of one row; problems of one name are set apart by their `variant`."""
    try:
        calculations = [one.only(task.outputs) for one in cases.case(row).calculations()]
    except InputError as error:
        yield {**row, **_without_answer(REFUSED, error.message)}
        return
    names = [str(one.problem.name) for one in calculations]
    for one, name in zip(calculations, names, strict=True):
        if names.count(name) > 1:
            name = str(ResultName(name, state=getattr(one.problem, "variant", "")))
        try:
            results = _first_of_each(solution.result for solution in one.solve())
            for result in results:
                own = name if len(results) == 1 else str(result.name)
                yield {**row, "bearing": own, **_answer(task, result)}
        except InputError as error:
            yield {**row, "bearing": name, **_without_answer(REFUSED, error.message)}
        except (ArithmeticError, ValueError, RuntimeError) as error:  # of one row among thousands
            yield {**row, "bearing": name, **_without_answer(ERROR, f"{type(error).__name__}: {error}")}


def _first_of_each(results: Iterable[Result]) -> list[Result]:
    """Results of a problem: of a system and its bearings all, of the steady states of one bearing the first."""
    found: dict[str, Result] = {}
    for one in results:
        found.setdefault(str(one.name.whole) if isinstance(one.name, ResultName) else one.name, one)
    return list(found.values())


def _without_answer(status: str, why: str) -> dict[str, Any]:
    """What stands in the line of a row that has no result."""
    return {"status": status, "verdict": Verdict.NO_SOLUTION.key, "message": _message(why)}


def _message(text: str) -> str:
    """A text on one line, cut between words where it is long."""
    return shorten(text, LONGEST_MESSAGE, placeholder=" ...")


def _answer(task: RowTask, result: Result) -> dict[str, Any]:
    found = appraised(result, task.limits or (ALL_LIMITS,))
    governing, solved = found.governing, result.outcome.solved
    values = {name: value_kept(result, name) for name in task.outputs} if solved else {}
    margins: dict[str, float] = {}
    advisories = [one for one in result.checks if solved and one.advisory and one not in found.checks]
    for check in (*found.checks, *advisories):
        name = advisory_name(check.code) if check in advisories else margin_name(check.code)
        margins[name] = min(check.margin, margins.get(name, math.inf))
        if check.is_in_kelvin:
            kelvin = kelvin_name(check.code)
            margins[kelvin] = min(check.gap, margins.get(kelvin, math.inf))
    explained = f"{found.code} {found.reason}".strip() if task.limits else "" if solved else found.reason
    return {
        **values,
        **margins,
        "margin": math.nan if governing is None else governing.margin,
        "status": result.outcome.name.lower(),
        "verdict": found.verdict.key,
        "governing_check": governing.code if governing is not None else "",
        "failed_checks": " ".join(found.failed),
        "codes": " ".join(found.codes),
        "message": _message(explained),
    }


def _columns(task: RowTask, lines: Sequence[Mapping[str, Any]]) -> Columns:
    words = task.words_of()
    made: Columns = {}
    for name in task.names:
        if name in words:
            made[name] = np.array([line.get(name, "") for line in lines], object)
        elif name == "row":
            made[name] = np.array([line[name] for line in lines], np.int64)
        else:
            made[name] = np.array([line.get(name, math.nan) for line in lines], np.float64)
    return made


def answers_of_arrays(
    task: RowTask,
    rows: Columns,
    bearing: str,
    values: Mapping[str, NDArray[Any]],
    margins: Mapping[str, NDArray[Any]],
    verdicts: NDArray[Any],
    advisories: Mapping[str, NDArray[Any]] | None = None,
    codes: str | NDArray[Any] = "",
) -> Columns:
    """The columns of rows that were solved as arrays, one bearing a row; what `SolvesMany` gives back.

    Parameters
    ----------
    task : RowTask
    rows : Columns
        As `solved_rows` gets them, shape (n,).
    bearing : str
        Name of the result.
    values : mapping
        By the name of a quantity its values in SI, shape (n,), and by `kelvin_name` margins in K; others than
        `RowTask.names` are left out.
    margins : mapping
        By the code of each limit its margin, shape (n,); NaN where it was not made. A margin of which no more
        than `babbitt.core.result.ROUND_OFF` is missing is kept.
    verdicts : ndarray of str
        Keys of `babbitt.core.result.Verdict`, shape (n,). Rows without a solution have their reason from
        elsewhere: such a chunk is better left to the rows one by one.
    advisories : mapping, optional
        By the code of each recommendation or screening indicator its margin, shape (n,).
    codes : str or array of str
        Of the warnings that question the rows that miss no limit.
    """
    count = rows["row"].size
    names = np.array([*margins, ""], object)
    table = np.array([margins[code] for code in names[:-1]] or np.full((1, count), np.nan), np.float64)
    made = np.isfinite(table).any(axis=0)
    least = np.where(np.isfinite(table), table, np.inf).argmin(axis=0)
    found: Columns = {**rows, "bearing": np.full(count, bearing, object), **values}
    found |= {margin_name(code): margins[code] for code in margins}
    found |= {advisory_name(code): margin for code, margin in (advisories or {}).items()}
    found["margin"] = np.where(made, table[least, np.arange(count)], np.nan)
    found["status"] = np.full(count, Outcome.CONVERGED.name.lower(), object)
    found["verdict"] = verdicts
    found["governing_check"] = names[np.where(made, least, len(margins))]
    failed = np.full(count, "", object)
    for code, margin in margins.items():
        missed = margin < -ROUND_OFF
        failed[missed] = [f"{before} {code}".strip() for before in failed[missed]]
    found["failed_checks"] = failed
    found["codes"] = np.where(failed == "", codes, failed).astype(object)
    found["message"] = np.full(count, "", object)
    nothing = np.full(count, np.nan)
    return {name: found.get(name, nothing) for name in task.names}


def empty_answers(task: RowTask) -> Columns:
    """A table without lines."""
    return _columns(task, [])


def joined(parts: Sequence[Columns]) -> Columns:
    """Tables of the same columns, one below the other."""
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
