"""What the terminal says of coefficients that a warning questions."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.notices import Effect, explanations
from babbitt.export import CoefficientTable
from babbitt.export.questioned import questioned_speeds

__all__ = ["warnings_lines"]


def warnings_lines(table: CoefficientTable) -> Iterator[str]:
    """Codes speed by speed, then what each of them says; nothing for a table without warnings."""
    questioned = questioned_speeds(table)
    for speed, codes in questioned.items():
        yield f"{speed}: {codes}"
    for code in dict.fromkeys(code for codes in table.warnings for code in codes):
        known = explanations()[code]
        yield f"{code}  {known.title}{' (no verdict)' if known.effect is Effect.NO_VERDICT else ''}"
