"""Questions whose answers are written in the language of one page."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from babbitt.app.solver import LONGEST, Pending, Questions
from babbitt.core.language import written_in

__all__ = ["InLanguage", "said"]


class InLanguage(Questions):
    """Asks a solver for answers in a language.

    Parameters
    ----------
    solver : Questions
    language : str
    """

    def __init__(self, solver: Questions, language: str) -> None:
        self._solver, self._language = solver, language

    def start(self, function: Callable[..., Any], *given: Any, longest: float = LONGEST) -> Pending:
        """Ask; the answer comes by the future."""
        return self._solver.start(said, self._language, function, *given, longest=longest)


def said(language: str, function: Callable[..., Any], *given: Any) -> Any:
    """What a function says, in a language."""
    with written_in(language):
        return function(*given)
