"""What all pages of a server share: worker processes of answers and of long work, and the kernels."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from babbitt.app.kernels import ABOUT, kernels_are_compiled, kernels_compiled, kernels_loaded
from babbitt.app.progress import Progress, progress_in
from babbitt.app.solver import LONGEST_STUDY, Solver

__all__ = ["Service", "started"]

BEHIND = 10
"""Niceness of processes whose answers may come a moment later than those of a value that moves."""


class Service:
    """Worker processes of a server.

    Attributes
    ----------
    drafts : Solver
        Of answers while a value moves: they wait for nothing else.
    solver : Solver
        Of answers on the grid of the case.
    slow : Solver
        Of studies and other work of minutes, so that no answer waits for them.
    is_ready : bool
        Whether no kernels are to be loaded or compiled any more.
    """

    def __init__(self) -> None:
        self.drafts, self.solver, self.slow = Solver(), Solver(niceness=BEHIND), Solver(1, niceness=BEHIND)
        self._folder = TemporaryDirectory(prefix="babbitt-")
        self._compiling: Any = None
        self.is_ready = False

    @property
    def compiling(self) -> Progress | None:
        """How far kernels are that are being compiled; None where none are."""
        if self._compiling is None or self._compiling.done():
            return None
        now = progress_in(self._file)
        return now if now.rows else Progress(0, ABOUT)

    @property
    def _file(self) -> str:
        return str(Path(self._folder.name) / "kernels")

    def load_kernels(self) -> None:
        """Have the kernels loaded, or compiled where there are none, so that no question of a visitor waits.

        One process begins after the other: the first answer, which seldom needs kernels, does not wait for them.
        """
        self.solver.start(kernels_are_compiled).add_done_callback(self._load_or_compile)

    def _load_or_compile(self, compiled: Any) -> None:
        if not _succeeded(compiled):
            self.is_ready = True
        elif compiled.result():
            self.is_ready = True
            self.drafts.start(kernels_loaded).add_done_callback(self._load_behind)
        else:
            self._compiling = self.slow.start(kernels_compiled, self._file, longest=LONGEST_STUDY)
            self._compiling.add_done_callback(self._end_compiling)

    def _load_behind(self, loaded: Any) -> None:
        if _succeeded(loaded):
            self.solver.start(kernels_loaded)

    def _end_compiling(self, _: Any) -> None:
        self.is_ready = True

    def close(self) -> None:
        """End all processes."""
        self.drafts.close()
        self.solver.close()
        self.slow.close()
        self._folder.cleanup()


def _succeeded(future: Any) -> bool:
    return not future.cancelled() and future.exception() is None


def started() -> Service:
    """Worker processes that load what the first questions need."""
    service = Service()
    service.load_kernels()
    return service
