"""A study and its case: in one file, or a study in a file of its own that names the file of the case."""

from __future__ import annotations

from pathlib import Path as FilePath
from typing import Literal

from pydantic import Field, ValidationError

from babbitt.case.case_file import CaseFile
from babbitt.case.document import Node
from babbitt.case.loading import load_case, problems_of, read_tree, text_of
from babbitt.case.part import Part
from babbitt.case.parts.fields import Name
from babbitt.case.parts.study import StudyBlock
from babbitt.case.problems import CaseError, Problem
from babbitt.core.files.printing import printable
from babbitt.core.files.reading import Reach
from babbitt.core.units import AS_WRITTEN

__all__ = ["StudyFile", "load_study"]

EXAMPLE = "study: {kind: tolerance, vary: {load: {uniform: [10 kN, 14 kN]}}}"


class StudyFile(Part):
    """A study in a file of its own."""

    babbitt: Literal[1] = Field(1, description="Version of the case language.")
    case: Name = Field(description="File of the case, sought from the folder of the study.")
    study: StudyBlock = Field(description="What is asked of it.")


def load_study(
    path: str | FilePath, reach: Reach = Reach.FOLDER
) -> tuple[CaseFile, StudyBlock, tuple[FilePath, ...]]:
    """Read a study and its case.

    Parameters
    ----------
    path : str or Path
        A case file with a block `study`, or a file with `case` and `study`.
    reach : Reach
        Where it may name other files.

    Returns
    -------
    CaseFile, StudyBlock, tuple of Path
        With every file that was read.

    Raises
    ------
    CaseError
        With every problem of the file, or that it holds no study.
    """
    path = FilePath(path)
    root = read_tree(text_of(path), printable(path))
    given = root.plain()
    if isinstance(given, dict) and "case" in given and "kind" not in given:
        return _own_file(path, root, reach)
    case = load_case(path, reach)
    if case.study_block is None:
        raise CaseError([Problem(printable(path), 0, "", "holds no study", allowed=f"a block such as {EXAMPLE}")])
    return case, case.study_block, (path, *case.files)


def _own_file(path: FilePath, root: Node, reach: Reach) -> tuple[CaseFile, StudyBlock, tuple[FilePath, ...]]:
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
    return case, found.study, (path, named, *case.files)
