"""Worker processes of the page: bounded in time and memory, replaced when they die, the latest question first."""

from __future__ import annotations

import asyncio
import math
import os
import time
from abc import ABC, abstractmethod
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, CancelledError
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from multiprocessing import get_context
from threading import Thread
from typing import Any

from pebble import ProcessExpired, ProcessFuture, ProcessPool

from babbitt.app.units import spoken
from babbitt.core.picklable_error import PicklableError

__all__ = ["LONGEST", "LONGEST_STUDY", "Ended", "InUnits", "Latest", "Questions", "Solver", "outcome_of"]

LONGEST = 30.0
"""Seconds that an answer may take."""

LONGEST_STUDY = 600.0
"""Seconds that a study may take."""

STALE = 5.0
"""Seconds after which a question that is no longer of interest is ended: before that its answer is near, and a new
process takes as long."""

POLL = 0.5
"""Seconds between two looks at a question that runs."""

LARGEST = 4 << 30
"""Bytes of memory of a worker."""


class Ended(PicklableError):  # noqa: N818 - not an error of the program
    """A question that was not answered: ended by its time limit, withdrawn, or its process died.

    Attributes
    ----------
    why : str
        ``too_long``, ``cancelled`` or ``died``: keys of the catalogue of words.
    """

    def __init__(self, why: str) -> None:
        super().__init__(why)
        self.why = why


class Questions(ABC):
    """What takes questions."""

    @abstractmethod
    def start(self, function: Callable[..., Any], *given: Any, longest: float = LONGEST) -> ProcessFuture[Any]:
        """Ask; the answer comes by the future."""

    async def ask(self, function: Callable[..., Any], *given: Any, longest: float = LONGEST) -> Any:
        """Ask and wait.

        Raises
        ------
        Ended
        """
        try:
            return await outcome_of(self.start(function, *given, longest=longest))
        except BrokenExecutor:  # a process died before it took the question
            return await outcome_of(self.start(function, *given, longest=longest))


class Solver(Questions):
    """Processes that answer the questions of all sessions.

    Parameters
    ----------
    workers : int, optional
        Half as many as cores by default, and at least one.
    niceness : int
        By how much they stand back for other processes, where the system knows such a thing.
    """

    def __init__(self, workers: int | None = None, niceness: int = 0) -> None:
        self._count = workers or max(1, (os.cpu_count() or 1) // 2)
        self._niceness = niceness
        self._pool = self._new_pool()
        self._open: set[ProcessFuture[Any]] = set()

    def _new_pool(self) -> ProcessPool:
        return ProcessPool(
            max_workers=self._count,
            initializer=_prepared,
            initargs=(self._niceness,),
            context=get_context("spawn"),
        )

    def start(self, function: Callable[..., Any], *given: Any, longest: float = LONGEST) -> ProcessFuture[Any]:
        """Ask; the answer comes by the future."""
        try:
            future = self._pool.schedule(function, args=given, timeout=longest)
        except RuntimeError:  # a process was killed while it held the pipe of all: the pool cannot go on
            self._renew()
            future = self._pool.schedule(function, args=given, timeout=longest)
        self._open.add(future)
        future.add_done_callback(self._open.discard)
        return future

    def _renew(self) -> None:
        """Take new processes, and end the questions that the old ones will not answer."""
        lost, self._pool = self._pool, self._new_pool()
        for future in list(self._open):
            future.cancel()  # type: ignore[no-untyped-call]
        Thread(target=_ended, args=(lost,), daemon=True).start()

    def close(self) -> None:
        """End all processes."""
        _ended(self._pool)


class InUnits(Questions):
    """Asks a solver for answers in the units of one page.

    Parameters
    ----------
    solver : Solver
    system : callable
        The system of units that the page shows now.
    """

    def __init__(self, solver: Solver, system: Callable[[], str]) -> None:
        self._solver, self._system = solver, system

    def start(self, function: Callable[..., Any], *given: Any, longest: float = LONGEST) -> ProcessFuture[Any]:
        """Ask; the answer comes by the future."""
        return self._solver.start(spoken, self._system(), function, *given, longest=longest)


def _ended(pool: ProcessPool) -> None:
    pool.stop()  # type: ignore[no-untyped-call]
    pool.join()


async def outcome_of(future: ProcessFuture[Any]) -> Any:
    """The answer of a future.

    Raises
    ------
    Ended
    BrokenExecutor
        Where all processes died and the question was not taken up.
    """
    try:
        return await asyncio.wrap_future(future)
    except TimeoutError:
        raise Ended("too_long") from None
    except (CancelledError, asyncio.CancelledError):
        raise Ended("cancelled") from None
    except (ProcessExpired, MemoryError):
        raise Ended("died") from None


@dataclass
class _Question:
    function: Callable[..., Any]
    given: tuple[Any, ...]


class Latest:
    """The questions of one session: of those that wait only the latest is asked, and answers come in their order.

    Parameters
    ----------
    solver : Questions
    """

    def __init__(self, solver: Questions) -> None:
        self._solver = solver
        self._waiting: _Question | None = None
        self._running: ProcessFuture[Any] | None = None
        self._begun = math.inf

    async def ask(self, function: Callable[..., Any], *given: Any) -> Any:
        """The answer; None where a later question has taken the place of this one.

        Raises
        ------
        Ended
        """
        mine = self._waiting = _Question(function, given)
        while self._running is not None:
            running = self._running
            await asyncio.wait([asyncio.wrap_future(running)], timeout=POLL)
            if self._waiting is not mine:
                return None
            self._end_if_stale(running)
        try:
            return await self._answer(mine)
        except BrokenExecutor:  # a process died before it took the question
            return await self._answer(mine)

    def withdraw(self) -> None:
        """Take back what no process has taken up yet: its answer would be of a case that has changed since."""
        self._waiting = None
        if self._running is not None and not self._running.running():
            self._running.cancel()  # type: ignore[no-untyped-call]

    async def _answer(self, question: _Question) -> Any:
        self._begun = math.inf
        self._running = future = self._solver.start(question.function, *question.given)
        try:
            return await outcome_of(future)
        finally:
            if self._running is future:
                self._running = None

    def _end_if_stale(self, running: ProcessFuture[Any]) -> None:
        """Withdraw a question that nobody waits for and that has been worked at for long."""
        if running.done():
            self._running = None if self._running is running else self._running
        elif running.running():
            self._begun = min(self._begun, time.monotonic())
            if time.monotonic() - self._begun > STALE:
                running.cancel()  # type: ignore[no-untyped-call]


def _prepared(niceness: int) -> None:
    """Bound the memory of a worker, have it stand back, and load what the first question needs."""
    if hasattr(os, "nice"):  # not on Windows
        os.nice(niceness)
    if find_spec("resource") is not None:  # not on Windows: there memory is not bounded
        resource = import_module("resource")
        resource.setrlimit(resource.RLIMIT_DATA, (LARGEST, LARGEST))
    from babbitt.app.answer import answer
    from babbitt.core.kind import kinds

    answer(kinds()["journal"].read_template())
