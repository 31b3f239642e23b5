"""One line of a calculation: what is computed, the formula, the numbers substituted, the result with its unit."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from babbitt.core.language import unit_sign
from babbitt.report.expression import Node, number_node, tree
from babbitt.report.vocabulary import PRINTED_UNITS, VOCABULARY, symbol

SUBSTITUTED_DIGITS = 5
"""Significant digits of a substituted number, so that a hand calculation meets the printed result."""


@dataclass(frozen=True)
class Line:
    """One step of a calculation.

    Attributes
    ----------
    name : str
        The quantity computed, a key of `VOCABULARY`.
    value : float
        In the units of the calculation: SI, temperatures in °C.
    expression : str
        How it is computed, as a Python expression in names of `VOCABULARY`; empty for a value that is given.
    numbers : Mapping[str, float]
        What the names stand for, in the units of the calculation.
    read_from : tuple of str
        For a value read from the characteristics: what it depends on.
    remark : str
        One line: where the formula comes from, or what limits it.
    digits : int
        Significant digits of the numbers substituted.
    """

    name: str
    value: float
    expression: str = ""
    numbers: Mapping[str, float] = field(default_factory=dict)
    read_from: tuple[str, ...] = ()
    remark: str = ""
    digits: int = SUBSTITUTED_DIGITS

    @property
    def meaning(self) -> str:
        """What is computed."""
        return VOCABULARY[self.name].meaning

    @property
    def symbol(self) -> Node:
        """Left side of the equation."""
        return symbol(self.name)

    @property
    def formula(self) -> Node | None:
        """Right side with symbols."""
        if self.read_from:
            return ["call", self.symbol, [symbol(name) for name in self.read_from]]
        return tree(self.expression, symbol) if self.expression else None

    @property
    def substituted(self) -> Node | None:
        """Right side with numbers."""
        if self.read_from:
            numbers = [_argument(name, self.numbers[name]) for name in self.read_from]
            return ["call", self.symbol, numbers]
        if not self.expression or self.expression in self.numbers:
            return None
        return tree(self.expression, self._number)

    @property
    def results(self) -> tuple[tuple[Node, str], ...]:
        """The result with its unit: in SI, and in the engineer's unit where that is another."""
        quantity = VOCABULARY[self.name]
        if quantity.unit == "K":
            return ((number_node(self.value, SUBSTITUTED_DIGITS), "°C"),)
        unit = PRINTED_UNITS.get(quantity.unit, quantity.unit).removesuffix(" (abs)")
        si = (number_node(self.value, max(SUBSTITUTED_DIGITS, quantity.digits)), unit)
        shown = quantity.metric
        if (shown.scale, shown.offset) == (1.0, 0.0):
            return (si,)
        return (
            si,
            (
                number_node(self.value * shown.scale + shown.offset, max(quantity.digits, 4)),
                unit_sign(shown.label),
            ),
        )

    def _number(self, name: str) -> Node:
        return number_node(self.numbers[name], max(self.digits, VOCABULARY[name].digits))


@dataclass(frozen=True)
class Section:
    """A heading with its lines."""

    title: str
    lines: tuple[Line, ...]
    remark: str = ""


def _argument(name: str, number: float) -> Node:
    if name == "angular_span":
        return ["row", [number_node(math.degrees(number), 4), ["op", "°"]]]
    return number_node(number, SUBSTITUTED_DIGITS)
