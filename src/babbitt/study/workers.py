"""Who computes the chunks of a study: this process, processes of this machine, any executor, or dask."""

from __future__ import annotations

import multiprocessing
import signal
import threading
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from typing import Any, Protocol

from babbitt.core.child_process import end_with_parent
from babbitt.core.notices import InputError
from babbitt.core.optional_package import how_to_install, optional_package
from babbitt.study.rows import Columns, RowTask, answered

__all__ = ["Alone", "Cluster", "Given", "Processes", "Workers"]

RETRIES = 3
"""Times that the chunks of a lost worker are given to another one."""


class Workers(Protocol):
    """Where chunks go to be computed."""

    @property
    def count(self) -> int:
        """Chunks that are computed at once."""

    def submit(self, task: RowTask, rows: Columns) -> Future[Columns]:
        """Have a chunk computed."""

    def renew(self) -> bool:
        """Take up work again after a worker was lost; False where that cannot be done."""

    def stop(self) -> None:
        """End at once; what is being computed is dropped."""


class Alone:
    """This process computes, one chunk after the other."""

    count = 1

    def submit(self, task: RowTask, rows: Columns) -> Future[Columns]:
        """Compute a chunk now."""
        done: Future[Columns] = Future()
        try:
            done.set_result(answered(task, rows))
        except Exception as error:
            done.set_exception(error)
        return done

    def renew(self) -> bool:
        """Nobody can be lost."""
        return False

    def stop(self) -> None:
        """Nothing is left to end."""


class Processes:
    """Processes of this machine, which end with the one that started them.

    Parameters
    ----------
    count : int
    """

    def __init__(self, count: int) -> None:
        self.count = count
        self._lost = 0
        self._children: set[Any] = set()
        self._pool = self._started()

    def submit(self, task: RowTask, rows: Columns) -> Future[Columns]:
        """Have a chunk computed; its future fails where a process was lost already."""
        try:
            with _ignored_interrupts():  # inherited by the process; an interrupt goes to all that share a terminal
                found = self._pool.submit(answered, task, rows)
        except BrokenExecutor as error:
            found = Future()
            found.set_exception(error)
        self._children |= set(multiprocessing.active_children())
        return found

    def renew(self) -> bool:
        """Start new processes, a few times."""
        self._lost += 1
        if self._lost > RETRIES:
            return False
        self._pool.shutdown(wait=False, cancel_futures=True)
        self._pool = self._started()
        return True

    def stop(self) -> None:
        """End the processes at once."""
        self._pool.shutdown(wait=False, cancel_futures=True)
        for child in self._children:
            if child.is_alive():
                child.kill()

    def _started(self) -> ProcessPoolExecutor:
        # Spawned, since a process that is forked while a library holds a lock waits for it for ever.
        context = multiprocessing.get_context("spawn")
        return ProcessPoolExecutor(self.count, mp_context=context, initializer=end_with_parent)


class Given:
    """An executor that somebody else has made and ends.

    Parameters
    ----------
    executor : concurrent.futures.Executor
    count : int
        Chunks that it gets at once.
    """

    def __init__(self, executor: Executor, count: int) -> None:
        self._executor, self.count = executor, count

    def submit(self, task: RowTask, rows: Columns) -> Future[Columns]:
        """Have a chunk computed."""
        return self._executor.submit(answered, task, rows)

    def renew(self) -> bool:
        """Whoever made the executor renews it."""
        return False

    def stop(self) -> None:
        """Leave the executor to whoever made it."""


class Cluster:
    """A dask cluster, by the address of its scheduler.

    Parameters
    ----------
    address : str
        Such as ``tcp://10.0.0.1:8786``.

    Raises
    ------
    InputError
        E007 where dask is not installed or the scheduler does not answer.
    """

    def __init__(self, address: str) -> None:
        cure = how_to_install("distributed", "cluster")
        distributed = optional_package("distributed", "studies on a cluster", cure)
        try:
            self._client = distributed.Client(address, timeout="10s", set_as_default=False)
        except (OSError, TimeoutError, ValueError) as error:
            raise InputError("E007", f"no dask scheduler answers at {address}: {error}") from None
        self._executor = self._client.get_executor(retries=RETRIES, pure=False)
        self.count = max(1, sum(self._client.ncores().values()))

    def submit(self, task: RowTask, rows: Columns) -> Future[Columns]:
        """Have a chunk computed; dask gives it to another worker where one is lost."""
        found: Future[Columns] = self._executor.submit(answered, task, rows)
        return found

    def renew(self) -> bool:
        """Dask has tried already."""
        return False

    def stop(self) -> None:
        """Leave the cluster."""
        self._client.close(timeout=1)  # with it its chunks are forgotten


@contextmanager
def _ignored_interrupts() -> Iterator[None]:
    """Ignore interrupts for a moment, where this thread may say so."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
