"""How far a study is: rows, rate, time left, share without a solution; on standard error where somebody looks."""

from __future__ import annotations

import sys
from typing import Any

__all__ = ["StudyProgress"]


class StudyProgress:
    """A bar on standard error; nothing where that is a file.

    Parameters
    ----------
    what : str
        What the bar is called.
    """

    def __init__(self, what: str) -> None:
        self._what = what
        self._done = self._failed = 0
        self._bar: Any = None
        self._task: Any = None

    def __enter__(self) -> StudyProgress:
        if sys.stderr.isatty():
            from rich.console import Console
            from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

            columns = (TextColumn("{task.description}", markup=False), BarColumn(), MofNCompleteColumn())
            said = TextColumn(
                "rows, {task.fields[rate]}, {task.fields[failed]} without solution, left", markup=False
            )
            self._bar = Progress(
                *columns, said, TimeRemainingColumn(), console=Console(stderr=True), transient=True
            )
            self._task = self._bar.add_task(self._what, total=0, rate="–", failed="0 %")
            self._bar.start()
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.stop()

    def begins(self, rows: int) -> None:
        """So many more rows are to be computed."""
        if self._bar is not None:
            self._bar.update(self._task, total=self._bar.tasks[0].total + rows)

    def advances(self, rows: int, failed: int) -> None:
        """So many are done, so many of them without a solution."""
        self._done += rows
        self._failed += failed
        if self._bar is not None:
            speed = self._bar.tasks[0].speed
            rate = f"{speed:.4g} a second" if speed else "–"
            share = f"{100.0 * self._failed / self._done:.1f} %"
            self._bar.update(self._task, advance=rows, rate=rate, failed=share)
