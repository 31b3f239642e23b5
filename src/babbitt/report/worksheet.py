"""The numbers of one bearing as a calculation goes on, and the making of its lines."""

from __future__ import annotations

from collections.abc import Mapping

from babbitt.report.expression import names, value
from babbitt.report.line import SUBSTITUTED_DIGITS, Line
from babbitt.report.vocabulary import VOCABULARY, calculated


class Worksheet:
    """Named numbers in the units of the calculation (SI, temperatures in °C); each line adds its own.

    Parameters
    ----------
    known : Mapping
        Numbers in SI by the names of the vocabulary; others are left out.
    """

    def __init__(self, known: Mapping[str, float]) -> None:
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
