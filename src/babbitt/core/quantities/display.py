"""The engineer's units, of the SI and of the US, and which of them tables and reports speak now."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, replace
from typing import Literal, get_args

from babbitt.core.language import unit_sign
from babbitt.core.units import KINDS, ZERO_CELSIUS
from babbitt.core.units.kinds import kind_of

__all__ = [
    "LADDERS",
    "SI",
    "SYSTEMS",
    "TOO_LARGE",
    "TOO_SMALL",
    "US",
    "DisplayUnit",
    "System",
    "displayed_in",
    "in_system",
    "is_spoken",
    "ladder_of",
    "us_partner",
    "written_in_system",
]


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
    "percent": DisplayUnit("%", 1e2, decimals=2, nothing=1e-9),
    "permille": DisplayUnit("‰", 1e3),
    "mm": DisplayUnit("mm", 1e3, decimals=2, digits=6),
    "um": DisplayUnit("µm", 1e6, decimals=1),
    "MPa": DisplayUnit("MPa", 1e-6, decimals=2),
    "degC": DisplayUnit("°C", 1.0, -ZERO_CELSIUS, decimals=1),
    "rpm": DisplayUnit("rpm", 9.549296585513721, decimals=0),
    "rpm2": DisplayUnit("rpm", 9.549296585513721, decimals=2),
    "deg": DisplayUnit("°", 57.29577951308232, decimals=1, nothing=1e-9),
    "kN": DisplayUnit("kN", 1e-3, decimals=2),
    "Nm": DisplayUnit("N m", decimals=2),
    "kW": DisplayUnit("kW", 1e-3, decimals=2, nothing=1e-7),
    "L/min": DisplayUnit("L/min", 6e4, decimals=1, nothing=1e-9),
    "L/min2": DisplayUnit("L/min", 6e4, decimals=2, nothing=1e-9),
    "mPas": DisplayUnit("mPa s", 1e3, decimals=2),
    "mm2/s": DisplayUnit("mm²/s", 1e6, decimals=2),
    "m/s": DisplayUnit("m/s", decimals=2),
    "mm/s": DisplayUnit("mm/s", 1e3, decimals=2),
    "kg/m3": DisplayUnit("kg/m³", decimals=1),
    "MJ/m3K": DisplayUnit("MJ/(m³ K)", 1e-6),
    "pv": DisplayUnit("MPa m/s", 1e-6, decimals=1),
    "kPa": DisplayUnit("kPa", 1e-3, decimals=1, nothing=1e-9),
    "1e-6/K": DisplayUnit("1e-6/K", 1e6, decimals=1),
    "J/kgK": DisplayUnit("J/(kg K)", decimals=0),
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
    "W/m2K": DisplayUnit("W/(m² K)"),
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


def _per(kind: str, unit: str) -> float:
    """Shown value over SI value of an everyday unit."""
    return 1.0 / KINDS[kind].everyday[unit]


_POUNDS_PER_CUBIC_FOOT = _per("kg", "lb") / _per("m", "ft") ** 3
_FAHRENHEIT = _per("K", "degF")
_PSI, _FEET, _INCHES = _per("Pa", "psi"), _per("m", "ft"), _per("m", "in")
_FORCE = _per("N", "lbf")
_STIFFNESS = DisplayUnit("klbf/in", _per("N/m", "klbf/in"))
_DAMPING = DisplayUnit("lbf s/in", _per("N s/m", "lbf s/in"), decimals=1)
_FLOW = _per("m3/s", "gpm")
_MOMENT = _per("N m", "lbf ft")
_HEAT = 4186.8
"""J/(kg K) in one Btu/(lb degF), by the definition of the Btu of the international table."""

US = {
    "mm": DisplayUnit("in", _INCHES, decimals=4, digits=6),
    "um": DisplayUnit("mil", _per("m", "mil"), decimals=3),
    "um2": DisplayUnit("mil", _per("m", "mil"), decimals=4),
    "MPa": DisplayUnit("psi", _PSI, decimals=1),
    "MPa3": DisplayUnit("psi", _PSI, decimals=2),
    "kPa": DisplayUnit("psi", _PSI, decimals=2, nothing=1e-9),
    "GPa": DisplayUnit("Mpsi", 1e-6 * _PSI),
    "degC": DisplayUnit("°F", _FAHRENHEIT, 32.0 - ZERO_CELSIUS * _FAHRENHEIT, decimals=1),
    "K": DisplayUnit("°F", _FAHRENHEIT, decimals=1),
    "kN": DisplayUnit("lbf", _FORCE, decimals=1),
    "N": DisplayUnit("lbf", _FORCE, decimals=2),
    "Nm": DisplayUnit("lbf ft", _MOMENT, decimals=2),
    "kNm": DisplayUnit("lbf ft", _MOMENT, decimals=1),
    "kW": DisplayUnit("hp", _per("W", "hp"), decimals=2, nothing=1e-7),
    "W": DisplayUnit("hp", _per("W", "hp"), decimals=3),
    "L/min": DisplayUnit("gpm", _FLOW, decimals=2, nothing=1e-9),
    "L/min2": DisplayUnit("gpm", _FLOW, decimals=3, nothing=1e-9),
    "mm3/s": DisplayUnit("in³/s", _INCHES**3, decimals=4),
    "mPas": DisplayUnit("cP", _per("Pa s", "cP"), decimals=2),
    "mm2/s": DisplayUnit("cSt", _per("m2/s", "cSt"), decimals=2),
    "m/s": DisplayUnit("ft/s", _FEET, decimals=1),
    "mm/s": DisplayUnit("in/s", _INCHES, decimals=3),
    "kg/m3": DisplayUnit("lb/ft³", _POUNDS_PER_CUBIC_FOOT, decimals=2),
    "MJ/m3K": DisplayUnit("Btu/(ft³ °F)", _POUNDS_PER_CUBIC_FOOT / _HEAT),
    "J/kgK": DisplayUnit("Btu/(lb °F)", 1.0 / _HEAT),
    "W/m2K": DisplayUnit("Btu/(h ft² °F)", 3600.0 * _POUNDS_PER_CUBIC_FOOT * _FEET / _HEAT),
    "pv": DisplayUnit("psi ft/s", _PSI * _FEET, decimals=0),
    "1e-6/K": DisplayUnit("1e-6/°F", 1e6 / _FAHRENHEIT, decimals=2),
    "t": DisplayUnit("lb", _per("kg", "lb"), decimals=1),
    "kg": DisplayUnit("lb", _per("kg", "lb"), decimals=1),
    "N/um": _STIFFNESS,
    "MN/m": _STIFFNESS,
    "GN/m": DisplayUnit("Mlbf/in", _per("N/m", "Mlbf/in")),
    "kN/m": DisplayUnit("lbf/in", _per("N/m", "lbf/in"), decimals=1),
    "kNs/m": _DAMPING,
    "MNs/m": DisplayUnit("klbf s/in", _per("N s/m", "klbf s/in")),
    "Ns/m": _DAMPING,
    "kNm/rad": DisplayUnit("lbf ft/rad", _MOMENT, decimals=1),
    "kNm/mrad": DisplayUnit("lbf ft/mrad", 1e-3 * _MOMENT, decimals=1),
    "Nms/rad": DisplayUnit("lbf ft s/rad", _MOMENT, decimals=2),
    "cm2": DisplayUnit("in²", _INCHES**2, decimals=3),
    "mrad": DisplayUnit("mil/in", 1e3, decimals=4),
}
"""By the name of a unit of `SI` that of the US; one that is missing is written alike in both."""

LIKE = {
    "m": "mm", "cm": "mm", "micron": "um", "MN": "kN", "Pa": "MPa", "bar": "MPa", "mbar": "kPa", "°C": "degC",
    "g": "kg", "mPa s": "mPas", "l/min": "L/min", "K": "",
}  # fmt: skip
"""Units of case files that take the partner of another one; K takes none, for it may be that of a difference."""

WRITTEN = {"°F": "degF"}
"""Units of tables that case files write otherwise."""

_PARTNERS = {SI[name]: unit for name, unit in US.items()}
_BY_LABEL = {(SI[name].label, SI[name].scale): unit for name, unit in reversed(US.items())}
"""For units with decimals of their own."""

System = Literal["si", "us"]
SYSTEMS: tuple[System, ...] = get_args(System)

_SYSTEM: ContextVar[System] = ContextVar("babbitt_system_of_units", default="si")


@contextmanager
def displayed_in(system: str) -> Iterator[None]:
    """Tables, reports and plots that are made inside speak the units of a system; ends with the block.

    Raises
    ------
    ValueError
        For a system that is not known.

    >>> from babbitt.core.quantities import QUANTITIES
    >>> with displayed_in("us"):
    ...     QUANTITIES["outlet_temperature"].with_unit(323.15)
    '122.0 °F'
    >>> QUANTITIES["outlet_temperature"].with_unit(323.15)
    '50.0 °C'
    """
    chosen = next((one for one in SYSTEMS if one == system), None)
    if chosen is None:
        raise ValueError(f"'{system}' is no system of units; there are: {', '.join(SYSTEMS)}")
    former = _SYSTEM.set(chosen)
    try:
        yield
    finally:
        _SYSTEM.reset(former)


def is_spoken(system: System) -> bool:
    """Whether tables, reports and plots speak the units of a system now."""
    return _SYSTEM.get() == system


def in_system(unit: DisplayUnit) -> DisplayUnit:
    """The unit of the system that is spoken now which stands for one of the SI, by its sign in the language."""
    if (sign := unit_sign(unit.label)) != unit.label:
        return replace(unit, label=sign)
    if _SYSTEM.get() == "si":
        return unit
    return _PARTNERS.get(unit) or _BY_LABEL.get((unit.label, unit.scale), unit)


def us_partner(unit: str) -> str:
    """The unit of the US that stands for one of the SI, both as case files write them; the same where none does.

    >>> [us_partner(unit) for unit in ("mm", "um", "kN", "degC", "mPa s", "L/min", "rpm")]
    ['in', 'mil', 'lbf', 'degF', 'cP', 'gpm', 'rpm']
    """
    shown, kind = US.get(LIKE.get(unit, unit)), kind_of(unit)
    if shown is None or kind is None:
        return unit
    written = WRITTEN.get(shown.label, shown.label)
    return written if written in kind.everyday else unit


def written_in_system(unit: str) -> str:
    """The unit of the system that is spoken now which stands for one of the SI, as case files write them."""
    return unit if _SYSTEM.get() == "si" else us_partner(unit)


def ladder_of(unit: DisplayUnit) -> tuple[str, ...]:
    """The ladder of `LADDERS` on which a unit of the SI stands, and with it that of the US; empty for none."""
    return next((units for units in LADDERS if unit in (SI[name] for name in units)), ())
