"""A quantity with its symbol, SI unit and the engineer's unit."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from babbitt.core.language import decimal
from babbitt.core.quantities.display import SI, TOO_LARGE, TOO_SMALL, DisplayUnit, in_system, ladder_of


@dataclass(frozen=True)
class Quantity:
    """A named quantity.

    Attributes
    ----------
    name : str
        Key in results and JSON.
    symbol : str
        As printed in equations, in plain Unicode.
    unit : str
        SI unit of the value in results and JSON.
    metric : DisplayUnit
        The engineer's unit of the SI.
    digits : int
        Significant digits worth showing.
    meaning : str
        One line.
    """

    name: str
    symbol: str
    unit: str
    metric: DisplayUnit
    digits: int
    meaning: str

    @property
    def display(self) -> DisplayUnit:
        """The engineer's unit of the system that is spoken now (`displayed_in`)."""
        return in_system(self.metric)

    def shown(self, value: float) -> float:
        """Convert an SI value to the engineer's unit."""
        return value * self.display.scale + self.display.offset

    def suited(self, *values: float) -> Quantity:
        """The same quantity in the unit of its size in which the largest of some SI values reads best.

        >>> from babbitt.core.quantities import QUANTITIES
        >>> mass = QUANTITIES["critical_mass"]
        >>> light, heavy = mass.suited(37.4), mass.suited(370.0)
        >>> light.format(37.4), light.display.label, heavy.format(370.0), heavy.display.label
        ('37.4', 'kg', '0.370', 't')
        """
        largest = max((abs(value) for value in values if math.isfinite(value)), default=0.0)
        ladder = ladder_of(self.metric)
        if largest * self.display.scale <= self.display.nothing or not ladder:
            return self
        if TOO_SMALL <= largest * self.display.scale < TOO_LARGE:
            return self
        fitting = [SI[unit] for unit in ladder if largest * in_system(SI[unit]).scale >= 1.0]
        return replace(self, metric=fitting[-1] if fitting else SI[ladder[0]])

    def format(self, value: float) -> str:
        """Write an SI value in the engineer's unit, without the unit, as every table and check shows it.

        The decimals are those of the unit where they leave no more than four significant digits; whole numbers
        are written out, and a number below one keeps three significant digits.

        >>> from babbitt.core.quantities import QUANTITIES
        >>> film, power = QUANTITIES["minimum_film_thickness"], QUANTITIES["friction_power"]
        >>> film.format(52.34e-6), power.format(28503.0), power.format(285030.0), power.format(141.8)
        ('52.3', '28.50', '285.0', '0.142')
        >>> power.format(-9.6e-7)
        '0'
        """
        shown, decimals = self.shown(value), self.display.decimals
        if abs(shown) <= self.display.nothing and not self.display.offset:
            return "0"
        size = abs(shown)
        if not self.display.offset and round(size, LEAST_DIGITS) < 1.0:
            decimals = max(decimals, LEAST_DIGITS - 1 - math.floor(math.log10(size)))
        elif not self.display.offset:
            decimals = min(decimals, max(0, self.display.digits - 1 - math.floor(math.log10(size))))
        plain = decimals <= LONGEST and size < 1e7
        return decimal(f"{shown:.{decimals}f}" if plain else f"{shown:.{LEAST_DIGITS - 1}e}")

    def with_unit(self, value: float) -> str:
        """Write an SI value in the engineer's unit, with the unit; a dash for what is not finite."""
        if not math.isfinite(value):
            return "–"
        return f"{self.format(value)}{'' if self.display.label == '°' else ' '}{self.display.label}".rstrip()

    def told_apart(self, value: float, other: float) -> tuple[str, str]:
        """Two SI values in one unit, with it, and with as many digits as tell that they differ.

        >>> from babbitt.core.quantities import QUANTITIES
        >>> flow = QUANTITIES["total_flow"]
        >>> flow.told_apart(45e-3 / 60, 46e-3 / 60), flow.told_apart(45e-3 / 60, 45.0123e-3 / 60)
        (('45.0 L/min', '46.0 L/min'), ('45.000 L/min', '45.012 L/min'))
        """
        suited = self.suited(value, other)
        texts = suited.with_unit(value), suited.with_unit(other)
        if texts[0] != texts[1] or value == other:
            return texts
        first, second = suited.shown(value), suited.shown(other)
        for digits in range(FEWEST_DIGITS, MOST_DIGITS):
            finer, other_finer = (f"{one:#.{digits}g}".rstrip(".") for one in (first, second))
            if finer != other_finer:
                unit = suited.display.label
                return decimal(f"{finer} {unit}").rstrip(), decimal(f"{other_finer} {unit}").rstrip()
        return texts


FEWEST_DIGITS, MOST_DIGITS = 5, 16
"""Digits beyond those of tables, and those that a number of the machine has."""

LEAST_DIGITS, LONGEST = 3, 6
"""Significant digits of a number below one; decimals beyond which an exponent reads better."""


def quantity(name: str, symbol: str, unit: str, display: str, digits: int, meaning: str) -> Quantity:
    """One quantity, shown in a unit of `SI`."""
    return Quantity(name, symbol, unit, SI[display], digits, meaning)


AXES = ("xx", "xy", "yx", "yy")
"""Entries of a 2 x 2 matrix: direction of the force, direction of the motion."""


def entries(name: str, symbol: str, unit: str, display: str, meaning: str) -> tuple[Quantity, ...]:
    """One quantity for each entry of a matrix: ``name_xx``, and its ``meaning`` from force in x to motion in x.

    >>> [one.meaning for one in entries("stiffness", "k_", "N/m", "MN/m", "Force in {} over move in {}")[:2]]
    ['Force in x over move in x', 'Force in x over move in y']
    """
    return tuple(
        quantity(f"{name}_{axes}", f"{symbol}{axes}", unit, display, 4, meaning.format(*axes)) for axes in AXES
    )
