"""Quantities that only a calculation needs on its way to a result."""

from __future__ import annotations

from babbitt.core.quantities import DisplayUnit, Quantity

__all__ = ["KILO", "MICRO", "MILLI", "PER_MINUTE", "PRINTED_UNITS", "local"]

PRINTED_UNITS = {
    "1": "",
    "m2": "m²",
    "m3": "m³",
    "m2/s": "m²/s",
    "m3/s": "m³/s",
    "kg/m3": "kg/m³",
    "J/(m3 K)": "J/(m³ K)",
}

MICRO, MILLI = DisplayUnit("µm", 1e6), DisplayUnit("mm", 1e3)
KILO = DisplayUnit("kPa", 1e-3)
PER_MINUTE = DisplayUnit("L/min", 6e4)


def local(
    name: str, symbol: str, unit: str, meaning: str, digits: int = 4, shown: DisplayUnit | None = None
) -> Quantity:
    """A quantity shown in SI units unless others are given."""
    return Quantity(name, symbol, unit, shown or DisplayUnit(PRINTED_UNITS.get(unit, unit)), digits, meaning)
