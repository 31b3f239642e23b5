"""What is wrong with a case file, reported once per fault with its place."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from babbitt.core.notices import InputError, explanations

MOST_SHOWN = 50
"""Problems printed of one file; who has more made one mistake many times."""


@dataclass(frozen=True)
class Problem:
    """One fault of a case file.

    Attributes
    ----------
    file : str
        Name of the file, or what stands for it.
    line : int
        Counted from 1; 0 where there is no text.
    field : str
        Path such as ``bearings[2 'Output wheel'].diameter``; empty for the file as a whole.
    says : str
        What is wrong.
    given : str
        What stands there, as far as it can be shown in a few words.
    allowed : str
        What would do.
    hint : str
        What to try.
    code : str
        A code of `babbitt.core.notices.explanations`.
    """

    file: str
    line: int
    field: str
    says: str
    given: str = ""
    allowed: str = ""
    hint: str = ""
    code: str = "E003"

    def __post_init__(self) -> None:
        if self.code not in explanations():
            raise KeyError(f"error code {self.code} is not registered in babbitt.core.notices")

    @property
    def message(self) -> str:
        """What is wrong, what is allowed and what to try, in one line.

        >>> Problem("a.yaml", 3, "span", "'200 deg' is not tabulated", allowed="180 deg").message
        "'200 deg' is not tabulated; allowed: 180 deg"
        """
        allowed = f"allowed: {self.allowed}" if self.allowed else ""
        return "; ".join(part for part in (self.says, allowed, self.hint) if part)

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}" if self.line else self.file
        field = f" {self.field}:" if self.field else ""
        return f"{place}:{field} {self.message} [{self.code}]"


class CaseError(InputError):
    """A case file cannot be used.

    Parameters
    ----------
    problems : iterable of Problem
        At least one.

    Attributes
    ----------
    problems : tuple of Problem
        All that is wrong, file by file in the order of the lines.
    """

    def __init__(self, problems: Iterable[Problem]) -> None:
        of_file: dict[str, list[Problem]] = {}
        for problem in dict.fromkeys(problems):
            of_file.setdefault(problem.file, []).append(problem)
        shown: list[str] = []
        for file, found in of_file.items():
            found.sort(key=lambda problem: problem.line)
            shown += [str(problem) for problem in found[:MOST_SHOWN]]
            if (more := len(found) - MOST_SHOWN) > 0:
                shown.append(f"{file}: and {more} more problems")
        self.problems = tuple(problem for found in of_file.values() for problem in found)
        super().__init__(self.problems[0].code, "\n".join(shown))
