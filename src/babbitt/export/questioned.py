"""Warnings that question coefficients and speeds without any, as plain data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from babbitt.core.notices import InputError
from babbitt.export.coefficients import CoefficientTable

UNSOLVED = "unsolved_speeds_rad_per_s"
"""Key of the speeds that were asked for and are not in the table."""


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


def unsolved_record(table: CoefficientTable) -> dict[str, list[float]]:
    """The speeds that a table lacks; nothing where it lacks none."""
    return {UNSOLVED: list(table.unsolved_speeds)} if table.unsolved_speeds else {}


def unsolved_from(where: str, record: Mapping[str, Any]) -> tuple[float, ...]:
    """The speeds that `unsolved_record` wrote.

    Raises
    ------
    InputError
        E003 for anything else.
    """
    given = record.get(UNSOLVED, [])
    if not _is_list(given) or not all(isinstance(speed, int | float) for speed in given):
        raise InputError("E003", f"{where}: {UNSOLVED} must be a list of numbers")
    return tuple(float(speed) for speed in given)


def _is_list(given: object) -> bool:
    return isinstance(given, Sequence) and not isinstance(given, str)
