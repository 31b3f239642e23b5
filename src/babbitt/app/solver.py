"""Worker processes of the page: bounded in time and memory, replaced when they die, the latest question first."""

from __future__ import annotations

import asyncio
import math
import os
import time
from abc import ABC, abstractmethod
from collections.abc import Awaitable, Callable
from concurrent.futures import Future
from contextlib import suppress
from dataclasses import dataclass
from queue import SimpleQueue
from threading import Event, Thread
from typing import Any

from babbitt.app.units import spoken
from babbitt.app.worker import Ended, Worker

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


class Pending(Future[Any]):
    """An answer to come. It can be cancelled while it is worked at, too; its process is ended then."""

    is_wanted = True

    def cancel(self) -> bool:
        """Say that nobody waits for it; whether it was still to come."""
        self.is_wanted = False
        return super().cancel() or self.running()


@dataclass(frozen=True)
class _Question:
    function: Callable[..., Any]
    given: tuple[Any, ...]
    longest: float
    answer: Pending


class Questions(ABC):
    """What takes questions."""

    @abstractmethod
    def start(self, function: Callable[..., Any], *given: Any, longest: float = LONGEST) -> Pending:
        """Ask; the answer comes by the future."""

    async def ask(self, function: Callable[..., Any], *given: Any, longest: float = LONGEST) -> Any:
        """Ask and wait.

        Raises
        ------
        Ended
        """
        return await _asked_again(lambda: outcome_of(self.start(function, *given, longest=longest)))


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
        count = workers or max(1, (os.cpu_count() or 1) // 2)
        self._niceness = niceness
        self._asked: SimpleQueue[_Question | None] = SimpleQueue()
        self._is_needed, self._is_open = Event(), True
        self._threads = [Thread(target=self._serve, daemon=True) for _ in range(count)]
        for one in self._threads:
            one.start()

    def start(self, function: Callable[..., Any], *given: Any, longest: float = LONGEST) -> Pending:
        """Ask; the answer comes by the future."""
        answer = Pending()
        self._asked.put(_Question(function, given, longest, answer))
        self._is_needed.set()
        return answer

    def close(self) -> None:
        """End all processes."""
        self._is_open = False
        if not self._is_needed.is_set():
            return
        for _ in self._threads:
            self._asked.put(None)
        for one in self._threads:
            one.join()

    def _serve(self) -> None:
        """Keep one process, and have it answer one question after the other."""
        self._is_needed.wait()
        worker = self._new_worker()
        while self._is_open:
            question = self._asked.get()
            worker = self._living(worker)  # it may have been killed while it waited
            if question is not None and question.answer.set_running_or_notify_cancel():
                self._answer(question, worker)
                worker = self._living(worker)
        worker.end()

    def _answer(self, question: _Question, worker: Worker) -> None:
        answer = question.answer
        try:
            found = worker.answer(
                question.function, question.given, question.longest, lambda: answer.is_wanted and self._is_open
            )
        except Exception as error:
            answer.set_exception(error)
        else:
            answer.set_result(found)

    def _living(self, worker: Worker) -> Worker:
        return worker if worker.lives or not self._is_open else self._new_worker()

    def _new_worker(self) -> Worker:
        """A process that is ready; one that died before it was tells so to whoever asks it."""
        worker = Worker(self._niceness)
        with suppress(Ended, EOFError, OSError):
            worker.heard(math.inf, lambda: self._is_open)
        return worker


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

    def start(self, function: Callable[..., Any], *given: Any, longest: float = LONGEST) -> Pending:
        """Ask; the answer comes by the future."""
        return self._solver.start(spoken, self._system(), function, *given, longest=longest)


async def outcome_of(future: Pending) -> Any:
    """The answer of a future.

    Raises
    ------
    Ended
    """
    try:
        return await asyncio.wrap_future(future)
    except asyncio.CancelledError:
        raise Ended("cancelled") from None


async def _asked_again(ask: Callable[[], Awaitable[Any]]) -> Any:
    """The answer of a question; one whose process died is asked once more.

    Raises
    ------
    Ended
    """
    try:
        return await ask()
    except Ended as ended:
        if ended.why != "died":
            raise
    return await ask()


class Latest:
    """The questions of one session: of those that wait only the latest is asked, and answers come in their order.

    Parameters
    ----------
    solver : Questions
    """

    def __init__(self, solver: Questions) -> None:
        self._solver = solver
        self._waiting: object = None
        self._running: Pending | None = None
        self._begun = math.inf

    async def ask(self, function: Callable[..., Any], *given: Any) -> Any:
        """The answer; None where a later question has taken the place of this one.

        Raises
        ------
        Ended
        """
        mine = self._waiting = object()
        while self._running is not None:
            running = self._running
            await asyncio.wait([asyncio.wrap_future(running)], timeout=POLL)
            if self._waiting is not mine:
                return None
            self._end_if_stale(running)

        async def asked() -> Any:
            return await self._answer(function, given) if self._waiting is mine else None

        return await _asked_again(asked)

    def withdraw(self) -> None:
        """Take back what no process has taken up yet: its answer would be of a case that has changed since."""
        self._waiting = None
        if self._running is not None and not self._running.running():
            self._running.cancel()

    async def _answer(self, function: Callable[..., Any], given: tuple[Any, ...]) -> Any:
        self._begun = math.inf
        self._running = future = self._solver.start(function, *given)
        try:
            return await outcome_of(future)
        finally:
            if self._running is future:
                self._running = None

    def _end_if_stale(self, running: Pending) -> None:
        """Withdraw a question that nobody waits for and that has been worked at for long."""
        if running.done():
            self._running = None if self._running is running else self._running
        elif running.running():
            self._begun = min(self._begun, time.monotonic())
            if time.monotonic() - self._begun > STALE:
                running.cancel()
