"""Every error, warning and status that Babbitt can say: code, meaning, remedy.

A notice in a result carries its code and the message with the numbers of the case. What the code means in
general and what can be done stands here once; ``babbitt explain CODE`` and the documentation print it.
The first letter tells the kind: E unusable input, W doubt that rides along with a result, S no solution.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Explanation:
    """What a code means and what to do about it."""

    title: str
    meaning: str
    remedy: str


@dataclass(frozen=True)
class Notice:
    """A doubt about a result: the code of an `Explanation` and the numbers of this case."""

    code: str
    message: str

    def __post_init__(self) -> None:
        if self.code not in EXPLANATIONS:
            raise KeyError(f"notice code {self.code} is not registered in babbitt.notices")


class BabbittError(Exception):
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
            raise KeyError(f"error code {code} is not registered in babbitt.notices")
        super().__init__(message)
        self.code = code
        self.message = message


class InputError(BabbittError):
    """The input cannot be used; nothing was computed and nothing was written."""


EXPLANATIONS: dict[str, Explanation] = {
    # -- unusable input -------------------------------------------------------------------------------------
    "E001": Explanation(
        "File cannot be read",
        "The file does not exist, is not readable, is empty, too large, or is not text.",
        "Check the path. A case file is a UTF-8 text file of at most 1 MB.",
    ),
    "E002": Explanation(
        "Not valid YAML",
        "The text cannot be parsed as YAML: a bracket, an indentation, a quotation mark, a duplicate key, "
        "or an anchor that refers to itself.",
        "Look at the line named. `babbitt new journal` writes a file that works.",
    ),
    "E003": Explanation(
        "Field not usable",
        "A field is missing, unknown, of the wrong unit or type, or outside the range that makes sense.",
        "The message names the line, the field, what was given and what is allowed.",
    ),
    "E004": Explanation(
        "Fields contradict each other",
        "Two fields that are each allowed cannot both be true, such as a bore smaller than its journal.",
        "Correct one of the fields named.",
    ),
    "E005": Explanation(
        "Not in the catalogue",
        "A lubricant, material, tolerance class or case of that name is not on board.",
        "`babbitt list lubricants`, `babbitt list materials` show the names; own data can be given in the case.",
    ),
    "E006": Explanation(
        "Value outside a law or a table",
        "A quantity lies outside the range for which a law, fit or table is defined.",
        "The message names the range. Give own data where the catalogue ends.",
    ),
    "E007": Explanation(
        "Output cannot be written",
        "The folder does not exist, is not writable, or an extra needed for this format is not installed.",
        "Check the path; `pip install 'babbitt[report]'` installs what PDF, HTML and plots need.",
    ),
}
