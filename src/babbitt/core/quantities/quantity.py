"""A quantity with its symbol, SI unit and the engineer's unit."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from babbitt.core.units import ZERO_CELSIUS


@dataclass(frozen=True)
class DisplayUnit:
    """How an SI value is shown: ``shown = si * scale + offset``, with at most so many decimals and digits.

    What is not larger than `nothing`, in the unit shown, is the round-off of a balance and shown as 0.
    """

    label: str
    scale: float = 1.0
    offset: float = 0.0
    decimals: int = 3
    nothing: float = 0.0
    digits: int = 4


SI = {
    "": DisplayUnit(""),
    "balance": DisplayUnit("", nothing=1e-12),
    "count": DisplayUnit("", decimals=0),
    "percent": DisplayUnit("%", 1e2, decimals=2),
    "permille": DisplayUnit("‰", 1e3),
    "mm": DisplayUnit("mm", 1e3, decimals=2, digits=6),
    "um": DisplayUnit("µm", 1e6, decimals=1),
    "MPa": DisplayUnit("MPa", 1e-6, decimals=2),
    "degC": DisplayUnit("°C", 1.0, -ZERO_CELSIUS, decimals=1),
    "rpm": DisplayUnit("rpm", 9.549296585513721, decimals=0),
    "rpm2": DisplayUnit("rpm", 9.549296585513721, decimals=2),
    "deg": DisplayUnit("°", 57.29577951308232, decimals=1),
    "kN": DisplayUnit("kN", 1e-3, decimals=2),
    "Nm": DisplayUnit("N m", decimals=2),
    "kW": DisplayUnit("kW", 1e-3, decimals=2, nothing=1e-7),
    "L/min": DisplayUnit("L/min", 6e4, decimals=1, nothing=1e-9),
    "mPas": DisplayUnit("mPa s", 1e3, decimals=2),
    "mm2/s": DisplayUnit("mm²/s", 1e6, decimals=2),
    "m/s": DisplayUnit("m/s", decimals=2),
    "mm/s": DisplayUnit("mm/s", 1e3, decimals=2),
    "kg/m3": DisplayUnit("kg/m³", decimals=1),
    "MJ/m3K": DisplayUnit("MJ/(m³ K)", 1e-6),
    "pv": DisplayUnit("MPa m/s", 1e-6, decimals=1),
    "kPa": DisplayUnit("kPa", 1e-3, decimals=1),
    "1e-6/K": DisplayUnit("1e-6/K", 1e6, decimals=1),
    "s": DisplayUnit("s"),
    "t": DisplayUnit("t", 1e-3),
    "N": DisplayUnit("N", decimals=2),
    "MPa3": DisplayUnit("MPa", 1e-6, decimals=4),
    "mm3/s": DisplayUnit("mm³/s", 1e9, decimals=2),
    "kNm": DisplayUnit("kN m", 1e-3, decimals=2),
    "N/um": DisplayUnit("N/µm", 1e-6, decimals=2),
    "um2": DisplayUnit("µm", 1e6, decimals=2),
    "MN/m": DisplayUnit("MN/m", 1e-6),
    "kNs/m": DisplayUnit("kN s/m", 1e-3),
    "kNm/rad": DisplayUnit("kN m/rad", 1e-3),
    "Nms/rad": DisplayUnit("N m s/rad"),
    "W": DisplayUnit("W", decimals=1),
    "K": DisplayUnit("K", decimals=1),
    "cm2": DisplayUnit("cm²", 1e4, decimals=2),
    "mrad": DisplayUnit("mm/m", 1e3, decimals=4),
    "kNm/mrad": DisplayUnit("kN m/mrad", 1e-6),
    "GPa": DisplayUnit("GPa", 1e-9),
    "GN/m": DisplayUnit("GN/m", 1e-9),
    "MNs/m": DisplayUnit("MN s/m", 1e-6),
    "Hz": DisplayUnit("Hz", 0.15915494309189535),
    "%": DisplayUnit("%", 1e2, decimals=1),
    "urad": DisplayUnit("µrad", 1e6, decimals=1),
    "kg": DisplayUnit("kg", decimals=1),
    "Ns/m": DisplayUnit("N s/m", decimals=1),
    "kN/m": DisplayUnit("kN/m", 1e-3, decimals=1),
}

LADDERS = (
    ("kg", "t"),
    ("Ns/m", "kNs/m", "MNs/m"),
    ("kN/m", "MN/m", "GN/m"),
    ("W", "kW"),
    ("N", "kN"),
    ("Nm", "kNm"),
    ("kPa", "MPa"),
)
"""Units of one size, rising; a number that the usual one would show with many digits or zeros takes another."""

TOO_SMALL, TOO_LARGE = 0.1, 1e4
"""Numbers, in a unit, for which a table takes the next one of its ladder."""


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
    display : DisplayUnit
        The engineer's unit.
    digits : int
        Significant digits worth showing.
    meaning : str
        One line.
    """

    name: str
    symbol: str
    unit: str
    display: DisplayUnit
    digits: int
    meaning: str

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
        ladder = next((units for units in LADDERS if self.display in (SI[unit] for unit in units)), ())
        if largest * self.display.scale <= self.display.nothing or not ladder:
            return self
        if TOO_SMALL <= largest * self.display.scale < TOO_LARGE:
            return self
        fitting = [SI[unit] for unit in ladder if largest * SI[unit].scale >= 1.0]
        return replace(self, display=fitting[-1] if fitting else SI[ladder[0]])

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
        return f"{shown:.{decimals}f}" if decimals <= LONGEST and size < 1e7 else f"{shown:.{LEAST_DIGITS - 1}e}"

    def with_unit(self, value: float) -> str:
        """Write an SI value in the engineer's unit, with the unit; a dash for what is not finite."""
        if not math.isfinite(value):
            return "–"
        return f"{self.format(value)}{'' if self.display.label == '°' else ' '}{self.display.label}".rstrip()


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
