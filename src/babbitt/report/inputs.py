"""What a bearing was computed from, as groups of rows."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from babbitt.report.rows import InputGroup, as_given
from babbitt.report.view import View

__all__ = ["inputs"]


def inputs(problem: Any, view: View, given: Iterable[tuple[str, str]]) -> tuple[InputGroup, ...]:
    """All inputs of a problem, grouped: as the case gave them, then by what they are.

    Parameters
    ----------
    problem : Problem
    view : View
        Of the method.
    given : iterable of (str, str)
        What the case gave in other terms than those of the calculation, and in which words.

    Returns
    -------
    tuple of InputGroup
        Groups that say nothing are left out.
    """
    return tuple(group for group in (as_given(given), *view.inputs(problem)) if group.rows)
