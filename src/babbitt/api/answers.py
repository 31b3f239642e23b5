"""What a solved case gives back: the result of one bearing, or those of several."""

from __future__ import annotations

from typing import TYPE_CHECKING

from babbitt import solving
from babbitt.case.case_file import CaseFile
from babbitt.case.loading import located
from babbitt.core.notices import InputError
from babbitt.core.progress import ProgressCallback, no_progress

if TYPE_CHECKING:
    from babbitt.api.case import Case
    from babbitt.api.machine_results import MachineResults
    from babbitt.api.results import BearingResult

__all__ = ["answer", "first_answer", "solutions_of", "solve"]


def solve(case: CaseFile, progress: ProgressCallback = no_progress) -> MachineResults:
    """Solve every bearing of a case.

    Parameters
    ----------
    case : CaseFile
        Such as a `babbitt.JournalBearing`, or what `babbitt.load_case` reads.
    progress : callable
        Called with the numbers of the cycles of an orbit, which takes long, by something that hands them on.

    Returns
    -------
    MachineResults
        Also of one bearing, whose own `solve` gives its result alone.

    Raises
    ------
    CaseError
        With what is missing, and for what a method refuses.
    TypeError
        If `case` is not a case, such as the path of its file.
    """
    from babbitt.api.machine_results import MachineResults

    return MachineResults(solutions_of(case, progress))


def solutions_of(case: CaseFile, progress: ProgressCallback = no_progress) -> solving.MachineResult:
    """Solve a case that is complete.

    Raises
    ------
    CaseError, TypeError
        As `solve`.
    """
    if not isinstance(case, CaseFile):
        given = type(case).__name__
        raise TypeError(
            f"solve takes a case, not {given}; read one with babbitt.load_case(path) or parse_case(text)"
        )
    complete = case.complete()
    try:
        return solving.solve(complete, progress)
    except InputError as error:
        raise located(error, complete, type(case).__name__) from None


def answer(found: solving.MachineResult, case: Case) -> BearingResult | MachineResults:
    """Give the result of one bearing where there is one, else those of all."""
    from babbitt.api.machine_results import MachineResults

    return first_answer(found, case) if len(found.solutions) == 1 else MachineResults(found)


def first_answer(found: solving.MachineResult, case: Case) -> BearingResult:
    """Give the result of the first bearing of a case, of its first steady state where there are several."""
    from babbitt.api.results import BearingResult

    return BearingResult(found.solutions[0], found.case_hash, found.case_text, case)
