"""Files as they were written before, and the same as they are written today."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from babbitt.case.aliases import Move, moves
from babbitt.case.case_file import CaseFile
from babbitt.case.case_hash import case_hash
from babbitt.case.document import read_document
from babbitt.case.kinds import KINDS
from babbitt.case.loading import load_case, parsed_in
from babbitt.case.moved_text import NotMovableError, moved_text
from babbitt.case.problems import CaseError, Problem
from babbitt.core.files.printing import printable
from babbitt.core.files.reading import Reach

__all__ = ["FormerPlace", "Upgrade", "former_places", "upgraded"]


@dataclass(frozen=True)
class FormerPlace:
    """A value at a place where it is still read.

    Attributes
    ----------
    line : int
    former, today : str
        Path in the file, and path in a file of today.
    """

    line: int
    former: str
    today: str

    def __str__(self) -> str:
        return f"line {self.line}: {self.former} stands in {self.today} now"


@dataclass(frozen=True)
class Upgrade:
    """A case file as it is written today.

    Attributes
    ----------
    text : str
        That of the file where nothing is moved.
    moved : tuple of FormerPlace
        In the order of the file.
    """

    text: str
    moved: tuple[FormerPlace, ...]


def former_places(case: CaseFile) -> tuple[FormerPlace, ...]:
    """What of a file is not written as it is today; empty for a case of another origin.

    Examples
    --------
    >>> from babbitt.case import parse_case, template
    >>> old = template("jacking_pocket").replace("diameter: 200 mm", "accuracy: draft\\ndiameter: 200 mm")
    >>> print(*former_places(parse_case(old)))
    line 8: accuracy stands in method.accuracy now
    """
    if not case.text:
        return ()
    return tuple(
        FormerPlace(line, _dotted(move.path), _dotted((*move.base, *move.today)))
        for line, move in _moves(case.text)
    )


def upgraded(file: Path, reach: Reach = Reach.FOLDER) -> Upgrade:
    """Write a case file as it is written today: comments and order stay, and so does what it says.

    Parameters
    ----------
    file : Path
    reach : Reach
        Where the case may name other files.

    Raises
    ------
    CaseError
        For a file that cannot be used, and where a value cannot be moved by itself.
    """
    case = load_case(file, reach)
    text = case.text.replace("\r\n", "\n")
    for _ in former_places(case):
        for line, move in _moves(text)[:1]:  # none where an anchor has moved it for all that take it
            try:
                text = moved_text(text, move)
            except NotMovableError as error:
                raise _unmovable(file, line, move, str(error)) from None
    if "\r\n" in case.text:
        text = text.replace("\n", "\r\n")
    if text != case.text and not _says_the_same(case, text, file, reach):
        says = "what is written at its former place cannot be moved by itself"
        hint = "write it by hand: " + "; ".join(map(str, former_places(case)))
        raise CaseError([Problem(printable(file), 0, "", says, hint=hint)])
    return Upgrade(text, former_places(case))


def _says_the_same(case: CaseFile, text: str, file: Path, reach: Reach) -> bool:
    """Whether a text is the same case, with nothing left at a former place."""
    try:
        made = parsed_in(text, file, reach)
    except CaseError:
        return False
    return case_hash(made) == case_hash(case) and not former_places(made)


def _moves(text: str) -> list[tuple[int, Move]]:
    """What is not written as it is today, with its line, in the order of the lines."""
    root = read_document(text)
    given = root.plain()
    found = [(root.line_of(move.path), move) for move in moves(KINDS[given["kind"]], given)]
    return sorted(found, key=lambda one: one[0])


def _unmovable(file: Path, line: int, move: Move, why: str) -> CaseError:
    today = _dotted((*move.base, *move.today))
    says = f"{why}, so that it cannot be moved to {today} by itself"
    return CaseError([Problem(printable(file), line, _dotted(move.path), says, hint=f"write {today} by hand")])


def _dotted(path: tuple[str | int, ...]) -> str:
    return ".".join(map(str, path))
