"""Questions whose answers are written in the language of one page."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pebble import ProcessFuture

from babbitt.app.solver import LONGEST, Questions
from babbitt.core.language import written_in

__all__ = ["InLanguage", "said"]


class InLanguage(Questions):
    """Asks a solver for answers in a language.

    Parameters
    ----------
    solver : Questions
    tongue : str
    """

    def __init__(self, solver: Questions, tongue: str) -> None:
        self._solver, self._tongue = solver, tongue

    def start(self, function: Callable[..., Any], *given: Any, longest: float = LONGEST) -> ProcessFuture[Any]:
        """Ask; the answer comes by the future."""
        return self._solver.start(said, self._tongue, function, *given, longest=longest)


def said(tongue: str, function: Callable[..., Any], *given: Any) -> Any:
    """What a function says, in a language."""
    with written_in(tongue):
        return function(*given)
