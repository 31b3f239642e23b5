"""What the terminal says of coefficients that a warning questions."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.notices import Effect, explanations
from babbitt.export import CoefficientTable
from babbitt.export.numbers import rounded_rpm

__all__ = ["warnings_lines"]


def warnings_lines(table: CoefficientTable) -> Iterator[str]:
    """Codes speed by speed, then what each of them says; nothing for a table without warnings."""
    for speed, codes in zip(table.speeds, table.warnings, strict=False):  # no warnings at all: none for any speed
        if codes:
            yield f"{rounded_rpm(float(speed)):.12g} rpm: {' '.join(codes)}"
    for code in dict.fromkeys(code for codes in table.warnings for code in codes):
        known = explanations()[code]
        yield f"{code}  {known.title}{' (no verdict)' if known.effect is Effect.NO_VERDICT else ''}"
