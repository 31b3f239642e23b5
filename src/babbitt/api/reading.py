"""From what a program gives to a case, which need not be complete, or to a part of one, which must be."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, TypeVar

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from babbitt.case.case_file import CaseFile
from babbitt.case.error_messages import Path
from babbitt.case.loading import problems_of, table_problem
from babbitt.case.named_files import NamedFiles, TableError
from babbitt.case.part import Part, usable_part
from babbitt.case.problems import CaseError

__all__ = ["read_case", "read_part"]

CaseT = TypeVar("CaseT", bound=CaseFile)
PartT = TypeVar("PartT", bound=Part)


def read_case(
    model: type[CaseT], given: Mapping[str, Any], where: str, files: NamedFiles
) -> tuple[CaseT, tuple[str, ...]]:
    """Read a case that need not be complete.

    Parameters
    ----------
    model : type
        Of the case language.
    given : Mapping
        In its words; numbers are in SI.
    where : str
        What to call it in messages.
    files : NamedFiles
        What it may read.

    Returns
    -------
    CaseFile, tuple of str
        The case, with its usable fields only where some are missing, and the paths of those.

    Raises
    ------
    CaseError
        With all that is wrong; what is missing is not.
    """
    try:
        read = model.with_named_files(dict(given), files)
    except TableError as error:
        raise CaseError([table_problem(error, given, where)]) from None
    try:
        return model.model_validate(read).with_files(tuple(files.taken)), ()
    except ValidationError as error:
        found = error.errors(include_url=False)
    if wrong := [one for one in found if one["ctx"]["missing"] is None]:
        raise CaseError(problems_of(wrong, given, where))
    return usable_part(model, read, None), tuple(dict.fromkeys(_missing(found)))


def read_part(model: type[PartT], given: Mapping[str, Any], where: str) -> PartT:
    """Read a part of a case, which is complete.

    Raises
    ------
    CaseError
        With all that is wrong or missing.
    """
    try:
        return model.model_validate(dict(given))
    except ValidationError as error:
        raise CaseError(problems_of(error.errors(include_url=False), given, where)) from None


def refuse_incomplete(model: type[CaseFile], given: Mapping[str, Any], where: str, files: NamedFiles) -> None:
    """Say what is missing in a case that was read.

    Raises
    ------
    CaseError
    """
    read_part(model, model.with_named_files(dict(given), files), where)


def _missing(found: Iterable[ErrorDetails]) -> Iterable[str]:
    for details in found:
        path: Path = (*details["loc"], *details["ctx"]["missing"])
        yield ".".join(str(step) for step in path)
