"""How far long work of a worker process is: it writes numbers into a small file, and the page reads them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sized
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, TypeVar

__all__ = ["FileWatch", "Progress", "followed", "progress_in"]

T_co = TypeVar("T_co", covariant=True)


class SizedIterable(Sized, Iterable[T_co], Protocol):
    """What can be counted and gone through."""


@dataclass(frozen=True)
class Progress:
    """What is done of all, and how much of it has no solution."""

    done: int = 0
    rows: int = 0
    failed: int = 0

    @property
    def share(self) -> float:
        """Of the work that is done, 0 to 1."""
        return self.done / self.rows if self.rows else 0.0


class FileWatch:
    """Follows a study (`babbitt.study.engine.Watch`) and writes how far it is.

    Parameters
    ----------
    file : str
    """

    def __init__(self, file: str) -> None:
        self._file = Path(file)
        self._now = Progress()

    def begins(self, rows: int) -> None:
        """So many more rows are to be computed."""
        self._write(Progress(self._now.done, self._now.rows + rows, self._now.failed))

    def advances(self, rows: int, failed: int) -> None:
        """So many are done, so many of them without a solution."""
        self._write(Progress(self._now.done + rows, self._now.rows, self._now.failed + failed))

    def _write(self, now: Progress) -> None:
        self._now = now
        beside = self._file.with_suffix(".new")
        beside.write_text(f"{now.done} {now.rows} {now.failed}", encoding="ascii")
        os.replace(beside, self._file)  # whoever reads finds the old numbers or the new ones


def followed(items: SizedIterable[T_co], file: str) -> Iterator[T_co]:
    """Go through items and write how many are done."""
    watch = FileWatch(file)
    watch.begins(len(items))
    for item in items:
        yield item
        watch.advances(1, 0)


def progress_in(file: str) -> Progress:
    """What stands in the file; nothing where work has not begun."""
    try:
        return Progress(*map(int, Path(file).read_text(encoding="ascii").split()))
    except (OSError, ValueError):
        return Progress()
