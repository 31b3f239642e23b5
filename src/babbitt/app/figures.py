"""Every figure of a case, those for which films are solved included."""

from __future__ import annotations

from babbitt.app.answer import Fault, Figure, faults_of, figure_of, solved
from babbitt.app.progress import followed
from babbitt.case import CaseError
from babbitt.core.language import keeping
from babbitt.report.view import view_of

__all__ = ["all_figures"]


def all_figures(text: str, progress: str) -> tuple[tuple[Fault, ...], tuple[Figure, ...]]:
    """What is wrong with a case, or every figure of every bearing.

    Parameters
    ----------
    text : str
    progress : str
        File for `babbitt.app.progress`: bearings that are done.
    """
    try:
        machine = solved(text)
    except CaseError as error:
        return faults_of(error), ()
    with keeping(machine.own_words):
        return (), tuple(
            figure_of(one.result, drawn)
            for one in followed(machine.solutions, progress)
            for drawn in view_of(one.result).figures(one, "svg")
        )
