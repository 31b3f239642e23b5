"""A process that answers questions, with a pipe of its own: what happens to it concerns no other one."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from importlib.util import find_spec
from multiprocessing import get_context
from multiprocessing.connection import Connection
from typing import Any

from babbitt.core.child_process import end_with_parent
from babbitt.core.picklable_error import PicklableError

__all__ = ["Ended", "Worker"]

TICK = 0.1
"""Seconds between two looks whether the answer is wanted still."""

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


class Worker:
    """A process that answers one question after the other.

    Parameters
    ----------
    niceness : int
        By how much it stands back for other processes, where the system knows such a thing.
    """

    def __init__(self, niceness: int) -> None:
        context = get_context("spawn")
        self._pipe, other_end = context.Pipe()
        self._process = context.Process(target=_answer_all, args=(other_end, niceness), daemon=True)
        self._process.start()
        other_end.close()  # the process has the only one left, so that the pipe ends with it

    @property
    def lives(self) -> bool:
        """Whether it can be asked."""
        return self._process.is_alive()

    def answer(
        self, function: Callable[..., Any], given: tuple[Any, ...], longest: float, is_wanted: Callable[[], bool]
    ) -> Any:
        """Ask and wait; the process is ended where no answer comes.

        Raises
        ------
        Ended
        Exception
            What the function raised.
        """
        try:
            self._pipe.send((function, given))
            succeeded, found = self.heard(longest, is_wanted)
        except (EOFError, OSError):
            self.end()
            raise Ended("died") from None
        if succeeded:
            return found
        raise found

    def heard(self, longest: float, is_wanted: Callable[[], bool]) -> Any:
        """What the process says next, at first that it is ready.

        Raises
        ------
        Ended
            The process, too.
        EOFError, OSError
            Where it died.
        """
        latest = time.monotonic() + longest
        while not self._pipe.poll(TICK):
            if not is_wanted() or time.monotonic() > latest:
                self.end()
                raise Ended("too_long" if is_wanted() else "cancelled")
        return self._pipe.recv()

    def end(self) -> None:
        """End the process."""
        self._process.kill()
        self._process.join()


def _answer_all(pipe: Connection, niceness: int) -> None:
    """Say that all is ready, then answer until nobody asks any more."""
    end_with_parent()
    _prepare(niceness)
    pipe.send(None)
    with suppress(EOFError):
        while True:
            pipe.send(_answer(*pipe.recv()))


def _answer(function: Callable[..., Any], given: tuple[Any, ...]) -> tuple[bool, Any]:
    try:
        return True, function(*given)
    except MemoryError:
        return False, Ended("died")
    except Exception as error:
        return False, error


def _prepare(niceness: int) -> None:
    """Bound the memory of a worker, have it stand back, and load what the first question needs."""
    if hasattr(os, "nice"):  # not on Windows
        os.nice(niceness)
    if find_spec("resource") is not None:  # not on Windows: there memory is not bounded
        resource = import_module("resource")
        resource.setrlimit(resource.RLIMIT_DATA, (LARGEST, LARGEST))
    from babbitt.app.answer import answer
    from babbitt.core.kind import kinds

    answer(kinds()["journal"].read_template())
