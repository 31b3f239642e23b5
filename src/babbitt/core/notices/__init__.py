"""Every error, warning and status that Babbitt can say: code, meaning, remedy.

A notice in a result carries its code and the values of the case; its sentence is made where it is shown. What the
code means in general and what can be done stands once, in the ``words.en.toml`` of its kind or of this folder;
``babbitt explain CODE`` and the documentation print it. The first letter tells the kind: E unusable input, W
warning that rides along with a result, S no solution, C check.
"""

from __future__ import annotations

from babbitt.core.notices.explanation import Effect, Explanation, Subject
from babbitt.core.notices.notice import Notice
from babbitt.core.notices.words import explanations
from babbitt.core.picklable_error import PicklableError

__all__ = ["BabbittError", "Effect", "Explanation", "InputError", "Notice", "Subject", "explanations"]


class BabbittError(PicklableError):
    """A mistake or a failure that the user can understand and act upon.

    Parameters
    ----------
    code : str
        A code of `explanations`.
    message : str
        What was wrong in this case, with its numbers and what is allowed.
    """

    def __init__(self, code: str, message: str) -> None:
        if code not in explanations():
            raise KeyError(f"error code {code} is not registered in babbitt.core.notices")
        super().__init__(message)
        self.code = code
        self.message = message


class InputError(BabbittError):
    """The input cannot be used; nothing was computed and nothing was written."""
