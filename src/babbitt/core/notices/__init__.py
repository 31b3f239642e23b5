"""Every error, warning and status that Babbitt can say: code, meaning, remedy.

A notice in a result carries its code and the message with the numbers of the case. What the code means in
general and what can be done stands here once; ``babbitt explain CODE`` and the documentation print it.
The first letter tells the kind: E unusable input, W warning that rides along with a result, S no solution.
"""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.core.notices.checks import CHECKS
from babbitt.core.notices.explanation import Effect, Explanation, Subject
from babbitt.core.notices.footstep import FOOTSTEP
from babbitt.core.notices.hydrostatics import HYDROSTATICS
from babbitt.core.notices.journal import JOURNAL
from babbitt.core.notices.no_solution import NO_SOLUTION
from babbitt.core.notices.one_dimension import ONE_DIMENSION
from babbitt.core.notices.thrust import THRUST
from babbitt.core.notices.tilting_pads import TILTING_PADS
from babbitt.core.notices.unusable import UNUSABLE
from babbitt.core.picklable_error import PicklableError

__all__ = ["EXPLANATIONS", "BabbittError", "Effect", "Explanation", "InputError", "Notice", "Subject"]

EXPLANATIONS: dict[str, Explanation] = (
    UNUSABLE | JOURNAL | ONE_DIMENSION | FOOTSTEP | HYDROSTATICS | THRUST | TILTING_PADS | NO_SOLUTION | CHECKS
)


@dataclass(frozen=True)
class Notice:
    """A warning about a result: the code of an `Explanation` and the numbers of this case."""

    code: str
    message: str

    def __post_init__(self) -> None:
        if self.code not in EXPLANATIONS:
            raise KeyError(f"notice code {self.code} is not registered in babbitt.core.notices")

    @property
    def effect(self) -> Effect:
        """What it does to the verdict of the result that carries it."""
        return EXPLANATIONS[self.code].effect


class BabbittError(PicklableError):
    """A mistake or a failure that the user can understand and act upon.

    Parameters
    ----------
    code : str
        A code of `EXPLANATIONS`.
    message : str
        What was wrong in this case, with its numbers and what is allowed.
    """

    def __init__(self, code: str, message: str) -> None:
        if code not in EXPLANATIONS:
            raise KeyError(f"error code {code} is not registered in babbitt.core.notices")
        super().__init__(message)
        self.code = code
        self.message = message


class InputError(BabbittError):
    """The input cannot be used; nothing was computed and nothing was written."""
