"""Warnings that question coefficients, speed by speed, in the form of each file."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

from babbitt.core.notices import InputError
from babbitt.export.coefficients import Array, CoefficientTable
from babbitt.export.numbers import rounded_rpm

_SPEED = re.compile(r"([-+.\deE]+) rpm: ([A-Za-z0-9 ]+)")

NEAR = 1e-9
"""Share of a speed by which that of a note may differ from it: notes have twelve digits."""


def questioned_speeds(table: CoefficientTable) -> dict[str, str]:
    """Codes of every speed that has some, by the speed in words.

    >>> import numpy as np
    >>> unit = np.array([np.eye(2)] * 2)
    >>> speeds, codes = np.array([0.0, 100 * np.pi]), ((), ("W407",))
    >>> questioned_speeds(CoefficientTable("A", speeds, unit, unit, warnings=codes))
    {'3000 rpm': 'W407'}
    """
    pairs = zip(table.speeds, table.warnings, strict=False)  # no warnings at all: none for any speed
    return {f"{rounded_rpm(float(speed)):.12g} rpm": " ".join(codes) for speed, codes in pairs if codes}


def warnings_note(table: CoefficientTable) -> str:
    """All of `questioned_speeds` in one line; empty for none."""
    return "; ".join(f"{speed}: {codes}" for speed, codes in questioned_speeds(table).items())


def warnings_of_note(note: str, speeds: Array) -> tuple[tuple[str, ...], ...]:
    """The warnings that `warnings_note` wrote, for the speeds of a table in rad/s."""
    told = {float(speed): tuple(codes.split()) for speed, codes in _SPEED.findall(note)}

    def codes_at(speed: float) -> tuple[str, ...]:
        rpm = rounded_rpm(speed)
        return next((codes for at, codes in told.items() if math.isclose(at, rpm, rel_tol=NEAR)), ())

    return tuple(codes_at(float(speed)) for speed in speeds)


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
