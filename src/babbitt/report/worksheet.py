"""The numbers of one bearing as a calculation goes on, and the making of its lines."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from babbitt.core.result import Result
from babbitt.report.expression import names, value
from babbitt.report.line import SUBSTITUTED_DIGITS, Line
from babbitt.report.vocabulary import VOCABULARY, calculated

if TYPE_CHECKING:
    from babbitt.kinds.journal.iso7902.model import DesignCase


class Worksheet:
    """Named numbers in the units of the calculation (SI, temperatures in °C); each line adds its own.

    Parameters
    ----------
    case : DesignCase
    result : Result
        The answer to that case, solved.
    """

    def __init__(self, case: DesignCase, result: Result) -> None:
        bearing = case.bearing
        known = dict(result.values)
        known |= {
            "angular_span": math.radians(bearing.span),
            "expansion_bearing": bearing.expansion_bearing,
            "expansion_journal": bearing.expansion_journal,
            "friction_factor": case.friction_factor,
        }
        if bearing.surfaces is not None:
            known |= vars(bearing.surfaces)
        if case.cooling is not None:
            known["heat_transfer_coefficient"] = case.cooling.heat_transfer_coefficient
            known["cooling_surface"] = case.cooling.surface
        self.numbers = {
            name: calculated(VOCABULARY[name], number) for name, number in known.items() if name in VOCABULARY
        }

    def __getitem__(self, name: str) -> float:
        return self.numbers[name]

    def __contains__(self, name: str) -> bool:
        return name in self.numbers

    def line(self, name: str, expression: str, remark: str = "", digits: int = SUBSTITUTED_DIGITS) -> Line:
        """A line with a formula. The value is the result's own; only what it does not name is computed here."""
        needed = {other: self.numbers[other] for other in names(expression)}
        if name not in self.numbers:
            self.numbers[name] = value(expression, needed)
        return Line(name, self.numbers[name], expression, needed, (), remark, digits)

    def read(self, name: str, *arguments: str, value: float | None = None, remark: str = "") -> Line:
        """A line whose value comes from characteristics or a table; `value` where the result does not name it."""
        if value is not None:
            self.numbers[name] = value
        needed = {other: self.numbers[other] for other in arguments}
        return Line(name, self.numbers[name], "", needed, arguments, remark)

    def given(self, name: str, remark: str = "", *, value: float | None = None) -> Line:
        """A line that states a value; `value` where the result does not name it."""
        if value is not None:
            self.numbers[name] = value
        return Line(name, self.numbers[name], remark=remark)

    def note(self, **numbers: float) -> None:
        """Remember numbers, in the units of the calculation, that later lines substitute."""
        self.numbers |= numbers
