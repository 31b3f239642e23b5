"""What is to be known of coefficients over speed: speeds left out, warnings, what a format cannot hold."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from babbitt.core.notices import Effect, explanations
from babbitt.export import OVER_FREQUENCY, CoefficientTable
from babbitt.export.numbers import rounded_rpm

__all__ = ["code_lines", "format_lines", "left_out_lines", "table_lines", "warnings_lines"]


def left_out_lines(run: Any) -> list[str]:
    """Why a speed of a run is in no table, speed by speed."""
    failed = [(speed, outcome.value) for speed, outcome in run.unsolved]
    failed += [(speed, "no stiffness with following temperatures") for speed in run.unfollowed]
    return [f"{why} at {speed * 30.0 / math.pi:.6g} rpm; left out" for speed, why in sorted(failed)]


def table_lines(table: CoefficientTable, format_name: str) -> Iterator[str]:
    """Warnings of a table, and what of it the format or its temperatures do not show."""
    yield from warnings_lines(table)
    yield from format_lines(table, format_name)


def format_lines(table: CoefficientTable, format_name: str) -> Iterator[str]:
    """What of a table the format or its temperatures do not show."""
    if table.over_frequency is not None and format_name not in OVER_FREQUENCY:
        yield (
            f"{format_name} has no axis of frequency: the coefficients written are synchronous; ross3, csv and "
            "json hold them over frequency, too"
        )
    if "following" in table.temperatures:
        yield (
            "the stiffness holds for slow changes; for whirl and vibration export with "
            "temperature_coefficients: frozen"
        )


def warnings_lines(table: CoefficientTable) -> Iterator[str]:
    """Codes speed by speed, then what each of them says; nothing for a table without warnings."""
    for speed, codes in zip(table.speeds, table.warnings, strict=False):  # no warnings at all: none for any speed
        if codes:
            yield f"{rounded_rpm(float(speed)):.6g} rpm: {' '.join(codes)}"
    yield from code_lines(table)


def code_lines(table: CoefficientTable) -> Iterator[str]:
    """What each code of the warnings of a table says."""
    for code in dict.fromkeys(code for codes in table.warnings for code in codes):
        known = explanations()[code]
        yield f"{code}  {known.title}{' (no verdict)' if known.effect is Effect.NO_VERDICT else ''}"
