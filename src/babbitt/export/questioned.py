"""Warnings that question coefficients as plain data, a list of codes for each speed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from babbitt.core.notices import InputError
from babbitt.export.coefficients import CoefficientTable


def warnings_record(table: CoefficientTable) -> dict[str, list[list[str]]]:
    """The warnings as plain data, a list for each speed; nothing where no speed has one."""
    return {"warnings": [list(codes) for codes in table.warnings]} if table.warnings else {}


def warnings_from(where: str, record: Mapping[str, Any]) -> tuple[tuple[str, ...], ...]:
    """The warnings that `warnings_record` wrote.

    Raises
    ------
    InputError
        E003 for anything else.
    """
    given = record.get("warnings", [])
    if not _is_list(given) or not all(_is_list(codes) for codes in given):
        raise InputError("E003", f"{where}: warnings must be a list of codes for each speed")
    return tuple(tuple(str(code) for code in codes) for codes in given)


def _is_list(given: object) -> bool:
    return isinstance(given, Sequence) and not isinstance(given, str)
