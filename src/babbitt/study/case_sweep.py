"""A case solved for every combination of values of some fields by the engine of studies; each answer is kept."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from babbitt.case.case_file import CaseFile
from babbitt.case.parts.study import StudyBlock, Vary
from babbitt.case.variation import CaseVariation, case_variation
from babbitt.core.files.reading import Reach
from babbitt.core.notices import InputError
from babbitt.core.result import Result, Verdict
from babbitt.solving import solve
from babbitt.study.engine import Engine, InterruptedStudyError, NoWatch, Watch
from babbitt.study.grids import product
from babbitt.study.inputs import Input, inputs_of
from babbitt.study.laws import Choices
from babbitt.study.rows import REFUSED, Columns, RowTask
from babbitt.study.shares import EVERYWHERE
from babbitt.study.sweep_values import MOST_VALUES, SweepValues
from babbitt.study.workers import Alone, Workers

__all__ = ["CaseSweep", "Everywhere", "SweepTask", "SweptField", "answers_of", "sweep_case", "varied_in"]


@dataclass(frozen=True)
class SweptField:
    """A field that varies.

    Attributes
    ----------
    path : str
    values : SweepValues
    present : float or None
        What the file itself has in the field, in the unit of the values.
    """

    path: str
    values: SweepValues
    present: float | None


@dataclass(frozen=True, eq=False)
class SweepTask(RowTask):
    """Rows whose answers are whole results, of every steady state, or the error for which one is refused."""

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all columns."""
        return ("row", "group", *(one.path for one in self.inputs), "status", "verdict", "result")

    def answers(self, rows: Columns) -> Columns:
        """Answer rows; a row that is refused stops nothing."""
        lines = [line for place in range(rows["row"].size) for line in self._lines(rows, place)]
        return {name: _column(name, lines) for name in self.names}

    def case(self, values: Mapping[str, Any]) -> CaseFile:
        """The case with values of a row in its fields, which its messages name."""
        return self.titled(values, f" with {', '.join(f'{one.path}: {values[one.path]}' for one in self.inputs)}")

    def _lines(self, rows: Columns, place: int) -> Iterator[dict[str, Any]]:
        row = {name: column[place] for name, column in rows.items()}
        try:
            for result in solve(self.case(row)).results:
                status = result.outcome.name.lower()
                yield {**row, "status": status, "verdict": result.verdict.key, "result": result}
        except InputError as error:  # of some methods only the film tells what cannot be
            yield {**row, "status": REFUSED, "verdict": Verdict.NO_SOLUTION.key, "result": error}


def _column(name: str, lines: Sequence[Mapping[str, Any]]) -> Any:
    made = np.empty(len(lines), np.int64 if name == "row" else object)
    for place, line in enumerate(lines):
        made[place] = line[name]
    return made


@dataclass(frozen=True)
class SweepAnswers:
    """Results by the numbers of their rows, why other rows are refused, and whether all were come to."""

    results: Mapping[int, tuple[Result, ...]]
    refused: Mapping[int, str]
    interrupted: bool


def answers_of(task: SweepTask, workers: Workers | None = None, watch: Watch | None = None) -> SweepAnswers:
    """Solve a case for every combination of values of its inputs.

    Raises
    ------
    InputError
        What the first row is refused for, if all are.
    KeyboardInterrupt
        When no row is finished.
    """
    engine = Engine(task, workers or Alone(), 1, None, watch or NoWatch())
    interrupted = False
    try:
        columns = engine.answers(*product(task.inputs))
    except InterruptedStudyError as error:
        if error.finished is None:
            raise KeyboardInterrupt from None
        columns, interrupted = error.finished, True
    finally:
        engine.workers.stop()
    refused: dict[int, InputError] = {}
    results: dict[int, list[Result]] = {}
    for row, answer in zip(columns["row"].tolist(), columns["result"], strict=True):
        if isinstance(answer, InputError):
            refused[row] = answer
        else:
            results.setdefault(row, []).append(answer)
    solved = {row: tuple(found) for row, found in results.items() if row not in refused}
    if refused and not solved:
        raise refused[min(refused)]
    return SweepAnswers(solved, {row: str(refused[row]) for row in sorted(refused)}, interrupted)


@dataclass(frozen=True, eq=False)
class CaseSweep:
    """Answers of a case over some of its fields.

    Attributes
    ----------
    name : str
        Of the case.
    fields : tuple of SweptField
        The last one varies fastest from row to row.
    task : SweepTask
    answers : mapping of int to tuple of Result
        By the number of each row that could be used.
    refused : mapping of int to str
        Row of every combination that the case does not take, and why.
    interrupted : bool
        Whether the sweep was interrupted, so that other rows were not solved.
    """

    name: str
    fields: tuple[SweptField, ...]
    task: SweepTask
    answers: Mapping[int, tuple[Result, ...]]
    refused: Mapping[int, str]
    interrupted: bool = False

    def rows(self) -> Iterator[tuple[int, Result]]:
        """Every answer with the number of its row."""
        for row, results in sorted(self.answers.items()):
            for result in results:
                yield row, result

    @property
    def count(self) -> int:
        """Rows, finished or not."""
        return int(np.prod([len(one.values.texts) for one in self.fields]))

    def places(self, row: int) -> tuple[int, ...]:
        """Which value of each field a row has."""
        return tuple(map(int, np.unravel_index(row, [len(one.values.texts) for one in self.fields])))

    def texts(self, row: int) -> tuple[str, ...]:
        """The values of a row as they would stand in the case file."""
        return tuple(one.values.texts[place] for one, place in zip(self.fields, self.places(row), strict=True))

    def case(self, row: int) -> CaseFile:
        """The case of a row."""
        inputs = zip(self.task.inputs, self.places(row), strict=True)
        return self.task.case({one.path: one.listed[place] for one, place in inputs})

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the answers, each once."""
        return tuple(dict.fromkeys(result.name for _, result in self.rows()))

    @property
    def solved(self) -> bool:
        """Whether every row has an answer, and every answer is an operating point."""
        done = not self.refused and not self.interrupted
        return done and all(result.outcome.solved for _, result in self.rows())


def sweep_case(
    fields: Sequence[tuple[CaseVariation | Everywhere, SweepValues]],
    workers: Workers | None = None,
    watch: Watch | None = None,
) -> CaseSweep:
    """Solve a case for each combination of values of some of its fields.

    Parameters
    ----------
    fields : sequence of (CaseVariation or Everywhere, SweepValues)
        The case file with each field, or a quantity in all places where it stands, and its values.
    workers : Workers, optional
        Who computes; this process by itself if not given.
    watch : Watch, optional
        Follows the progress.

    Returns
    -------
    CaseSweep
        With a status for every row; one that the case does not take stops nothing. An interrupt ends it with
        the rows that are finished.

    Raises
    ------
    InputError
        What the first row is refused for, if all are; E005 for a field that is named twice, E003 for too many
        rows.
    KeyboardInterrupt
        When no row is finished.
    """
    first = fields[0][0]
    paths = [variation.path for variation, _ in fields]
    if again := next((path for path in paths if paths.count(path) > 1), None):
        raise InputError("E005", f"{first.file}: '{again}' is named twice; give all its values at once")
    rows = int(np.prod([len(values.texts) for _, values in fields]))
    if rows > MOST_VALUES:
        says = f"the values make {rows} rows; allowed: {MOST_VALUES}"
        raise InputError("E003", f"{first.file}: {says}; give fewer, or write a study (babbitt study)")
    inputs = tuple(_input(variation, values) for variation, values in fields)
    given = first.given
    task = SweepTask(given["kind"], given, first.file, first.reach, inputs)
    found = answers_of(task, workers, watch)
    swept = tuple(
        SweptField(variation.path, values, values.number_of(variation.present)) for variation, values in fields
    )
    name = str(given.get("name", ""))
    return CaseSweep(name, swept, task, found.results, found.refused, found.interrupted)


@dataclass(frozen=True)
class Everywhere:
    """A quantity of a case that varies in all places by one share of what stands there, such as ``*.speed``.

    Attributes
    ----------
    case : CaseFile
    path : str
    file : Path
    given : mapping
        What stands in the file.
    reach : Reach
    inputs : tuple of Path
        The other files that the case names.
    """

    case: CaseFile
    path: str
    file: Path
    given: Mapping[str, Any]
    reach: Reach
    inputs: tuple[Path, ...]

    @property
    def present(self) -> float:
        """The share that the case as it stands has."""
        return 1.0

    def input_of(self, values: SweepValues) -> Input:
        """The field with its values; raises InputError where nothing gives the quantity."""
        vary = {self.path: Vary(values=values.texts)}
        (found,) = inputs_of(self.case, StudyBlock(kind="sweep", vary=vary))
        return found


def varied_in(
    file: Path, path: str, bearing: str | None = None, reach: Reach = Reach.FOLDER
) -> CaseVariation | Everywhere:
    """Read a case file of which one field, or a quantity everywhere, is to vary; as `case_variation`."""
    if not path.startswith(EVERYWHERE):
        return case_variation(file, path, bearing, reach)
    read = case_variation(file, "name", bearing, reach)
    return Everywhere(read.unchanged, path, file, read.given, reach, read.inputs)


def _input(variation: CaseVariation | Everywhere, values: SweepValues) -> Input:
    """A field whose values stand in the case as they are written."""
    if isinstance(variation, Everywhere):
        return variation.input_of(values)
    law = Choices(tuple(values.texts))
    known = {text: text for text in values.texts}
    return Input(variation.path, variation.field, law, form="choice", given=known)
