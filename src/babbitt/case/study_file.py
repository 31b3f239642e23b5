"""A study and its case: in one file, or a study in a file of its own that names the file of the case."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import Literal

from pydantic import Field, ValidationError

from babbitt.case.case_file import CaseFile
from babbitt.case.loading import STUDY, load_case, problems_of, read_tree, text_of
from babbitt.case.part import Part
from babbitt.case.parts.fields import Name
from babbitt.case.parts.study import StudyBlock
from babbitt.case.problems import CaseError, Problem
from babbitt.core.files.printing import printable
from babbitt.core.files.reading import Reach
from babbitt.core.units import AS_WRITTEN

__all__ = ["StudiedCase", "StudyFile", "load_case_or_study", "load_study"]

EXAMPLE = "study: {kind: tolerance, vary: {load: {uniform: [10 kN, 14 kN]}}}"


@dataclass(frozen=True)
class StudiedCase:
    """A case, the study of it if there is one, and every file that was read."""

    case: CaseFile
    study: StudyBlock | None
    files: tuple[FilePath, ...]


class StudyFile(Part):
    """A study in a file of its own."""

    babbitt: Literal[1] = Field(1, description="Version of the case language.")
    case: Name = Field(description="File of the case, sought from the folder of the study.")
    study: StudyBlock = Field(description="What is asked of it.")


def load_study(path: str | FilePath, reach: Reach = Reach.FOLDER) -> StudiedCase:
    """Read a study and its case.

    Parameters
    ----------
    path : str or Path
        A case file with a block `study`, or a file with `case` and `study`.
    reach : Reach
        Where it may name other files.

    Raises
    ------
    CaseError
        With every problem of the file, or that it holds no study.
    """
    found = load_case_or_study(path, reach)
    if found.study is None:
        says = "holds no study"
        raise CaseError([Problem(printable(path), 0, "", says, allowed=f"a block such as {EXAMPLE}")])
    return found


def load_case_or_study(path: str | FilePath, reach: Reach = Reach.FOLDER) -> StudiedCase:
    """Read a case, with its study if there is one; raises as `load_study`, but for a file without a study."""
    path = FilePath(path)
    given = _mapping_in(path)
    if "case" in given and "kind" not in given and STUDY in given:
        return _own_file(path, reach)
    case = load_case(path, reach)
    return StudiedCase(case, case.study_block, (path, *case.files))


def _mapping_in(path: FilePath) -> dict[str, object]:
    """What stands in a file; nothing where it holds no mapping, which is reported where it is read as a case."""
    given = read_tree(text_of(path), printable(path)).plain()
    return given if isinstance(given, dict) else {}


def _own_file(path: FilePath, reach: Reach) -> StudiedCase:
    root = read_tree(text_of(path), printable(path))
    given = root.plain()
    try:
        found = StudyFile.model_validate(given, context=AS_WRITTEN)
    except ValidationError as error:
        raise CaseError(problems_of(error.errors(include_url=False), given, printable(path), root)) from None
    named = path.parent / found.case
    inside = named.resolve().is_relative_to(path.parent.resolve())
    if reach is Reach.FOLDER and not inside:
        says = f"{printable(found.case)} lies outside the folder of the study"
        allowed, hint = "a file in the folder of the study or below it", "add --allow-outside if you trust it"
        line = root.line_of(("case",))
        raise CaseError([Problem(printable(path), line, "case", says, allowed=allowed, hint=hint)])
    case = load_case(named, reach)
    return StudiedCase(case, found.study, (path, named, *case.files))
