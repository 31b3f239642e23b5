"""From rows to answers: chunks, workers, the store, progress."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, wait
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.picklable_error import PicklableError
from babbitt.core.result import Verdict
from babbitt.study.rows import Columns, RowTask, empty_answers, joined, solved_as_arrays, solved_rows
from babbitt.study.store import Store
from babbitt.study.workers import Workers

__all__ = ["MOST_IN_CHUNK", "Engine", "InterruptedStudyError", "NoWatch", "Watch", "chunk_size"]

MOST_IN_CHUNK = 4096
"""Rows."""

WORK_OF_CHUNK = 1.0
"""Seconds."""

LISTENING = 0.2
"""Seconds after which the wait for a chunk looks up, so that an interrupt is heard."""


class Watch(Protocol):
    """What follows the progress of a study."""

    def begins(self, rows: int) -> None:
        """So many more rows are to be computed."""

    def advances(self, rows: int, failed: int) -> None:
        """So many are done, so many of them without a solution."""


class NoWatch:
    """Tell nothing."""

    def begins(self, rows: int) -> None:
        """Tell nothing."""

    def advances(self, rows: int, failed: int) -> None:
        """Tell nothing."""


class InterruptedStudyError(PicklableError):
    """An interrupt ended a study.

    Attributes
    ----------
    done, rows : int
        Rows that are finished, of all.
    finished : Columns or None
        Their answers; None where there is none.
    """

    def __init__(self, done: int, rows: int, finished: Columns | None = None) -> None:
        super().__init__(f"{done} of {rows} rows are finished")
        self.done, self.rows, self.finished = done, rows, finished


def chunk_size(seconds_a_row: float) -> int:
    """Rows of a chunk: a power of two, about `WORK_OF_CHUNK` of work.

    >>> chunk_size(0.01), chunk_size(3.0), chunk_size(1e-6)
    (64, 1, 4096)
    """
    wanted = WORK_OF_CHUNK / max(seconds_a_row, 1e-9)
    return int(2 ** np.floor(np.log2(np.clip(wanted, 1.0, MOST_IN_CHUNK))))


@dataclass(eq=False)
class Engine:
    """Computes rows, keeps finished chunks, and reads those that a run before has kept.

    Attributes
    ----------
    task : RowTask
    workers : Workers
    rows_in_chunk : int
    store : Store or None
    watch : Watch
    """

    task: RowTask
    workers: Workers
    rows_in_chunk: int
    store: Store | None
    watch: Watch

    def __post_init__(self) -> None:
        self._next_chunk = 0
        self._next_row = 0

    def answers(self, values: Mapping[str, NDArray[Any]], group: str | NDArray[Any]) -> Columns:
        """Answer rows.

        Parameters
        ----------
        values : mapping
            By the path of each input its values, shape (n,).
        group : str or array of str
            What the rows are for.

        Returns
        -------
        Columns
            In the order of the rows, whoever computed them and when.

        Raises
        ------
        InterruptedStudyError
            After an interrupt; finished chunks are kept in the store.
        InputError
            E007 where a chunk cannot be stored, or is that of other rows.
        """
        count = len(next(iter(values.values())))
        rows: Columns = {"row": np.arange(self._next_row, self._next_row + count, dtype=np.int64)}
        rows["group"] = np.full(count, group, object) if isinstance(group, str) else np.asarray(group, object)
        rows |= values
        chunks = self._chunks(rows)
        self._next_row += count
        self._next_chunk += len(chunks)
        self.watch.begins(count)
        done: dict[int, Columns] = {}
        for number, chunk in chunks.items():
            found = self.store.read(number) if self.store is not None else None
            if found is not None:
                _require_same(chunk, found, self.task)
                done[number] = found
                self._tell(found)
        self._compute({number: chunk for number, chunk in chunks.items() if number not in done}, done, count)
        return _taken_together([done.pop(number) for number in chunks]) if chunks else empty_answers(self.task)

    def _chunks(self, rows: Columns) -> dict[int, Columns]:
        """The rows in pieces, by the number of their chunk."""
        size = self.rows_in_chunk
        count = rows["row"].size
        return {
            self._next_chunk + number: {name: column[first : first + size] for name, column in rows.items()}
            for number, first in enumerate(range(0, count, size))
        }

    def _compute(self, chunks: Mapping[int, Columns], done: dict[int, Columns], count: int) -> None:
        waiting = iter(chunks.items())
        running: dict[Future[Columns], int] = {}
        try:
            self._fill(running, waiting)
            while running:
                finished, _ = wait(running, timeout=LISTENING, return_when=FIRST_COMPLETED)
                lost = [number for future in finished if (number := self._take(future, running, done)) is not None]
                if lost:
                    self._start_again(running, lost, chunks)
                self._fill(running, waiting)
        except KeyboardInterrupt:
            for future in [one for one in running if one.done() and not one.cancelled()]:
                self._take(future, running, done)
            self.workers.stop()
            kept = joined([done[number] for number in sorted(done)]) if done else None
            rows = 0 if kept is None else np.unique(kept["row"]).size
            raise InterruptedStudyError(rows, count, kept) from None

    def _fill(self, running: dict[Future[Columns], int], waiting: Iterator[tuple[int, Columns]]) -> None:
        """Keep a few more chunks at the workers than they compute at once, not all, which would take memory."""
        while len(running) < 2 * self.workers.count:
            number, chunk = next(waiting, (-1, {}))
            if number < 0:
                return
            running[self.workers.submit(self.task, chunk)] = number

    def _take(
        self, future: Future[Columns], running: dict[Future[Columns], int], done: dict[int, Columns]
    ) -> int | None:
        """Keep the answers of a chunk; the number of the chunk where its worker was lost."""
        number = running.pop(future)
        try:
            found = future.result()
        except BrokenExecutor:
            return number
        if self.store is not None:
            self.store.write(number, found, self.task.inputs)
        done[number] = found
        self._tell(found)
        return None

    def _start_again(
        self, running: dict[Future[Columns], int], lost: list[int], chunks: Mapping[int, Columns]
    ) -> None:
        """Give the chunks of lost workers to new ones."""
        numbers = sorted([*lost, *running.values()])
        running.clear()
        if not self.workers.renew():
            says = "the processes that compute were ended from outside, again and again (is there memory enough?)"
            raise InputError("E007", f"{says}; use fewer --workers")
        for number in numbers:
            running[self.workers.submit(self.task, chunks[number])] = number

    def _tell(self, found: Columns) -> None:
        without = found["verdict"] == Verdict.NO_SOLUTION.key
        self.watch.advances(np.unique(found["row"]).size, np.unique(found["row"][without]).size)


def _taken_together(parts: list[Columns]) -> Columns:
    """What `joined` gives, each column taken out of the tables, so that a million rows are in memory once."""
    return {name: np.concatenate([part.pop(name) for part in parts]) for name in list(parts[0])}


def _require_same(rows: Columns, found: Columns, task: RowTask) -> None:
    """Refuse a stored chunk that answers other rows."""
    _, first = np.unique(found["row"], return_index=True)
    same = np.array_equal(found["row"][first], rows["row"]) and all(
        np.array_equal(found[one.path][first], rows[one.path], equal_nan=not one.is_choice) for one in task.inputs
    )
    if not same:
        says = "the folder of the study holds chunks of other samples"
        raise InputError("E007", f"{says}; choose another --out, or delete the folder")


TIMED_TOGETHER = 2048
"""Rows whose time tells that of one of them, where rows are solved as arrays."""


def timed(task: RowTask, row: Columns) -> float:
    """Seconds of a row among many; it was answered before, so that everything is compiled.

    Of rows that are solved as arrays no more than fill the largest chunk: what shares an array may differ in the
    last bit from what is in another, and must not with the speed of the machine.
    """
    together = {name: np.repeat(column, TIMED_TOGETHER) for name, column in row.items()}
    together["row"] = np.arange(TIMED_TOGETHER)
    solved_as_arrays(task, together)  # imports what arrays need
    begin = time.perf_counter()
    if solved_as_arrays(task, together) is not None:
        return min((time.perf_counter() - begin) / TIMED_TOGETHER, WORK_OF_CHUNK / MOST_IN_CHUNK)
    begin = time.perf_counter()
    solved_rows(task, row)
    return time.perf_counter() - begin
