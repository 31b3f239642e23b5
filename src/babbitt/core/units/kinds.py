"""The kinds of quantities a case may ask for, each with the units that engineers write every day.

The everyday units stand here as plain factors, so that a case file is read without loading pint; every other
unit goes through pint. A test holds the factors to those of pint. They are exact: as a fraction, or as a decimal
that is written so.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import Any

FREEZING = Fraction("273.15")
ZERO_CELSIUS = float(FREEZING)
"""K."""

INCH, POUND_FORCE, KILOGRAM_FORCE = Fraction("0.0254"), Fraction("4.4482216152605"), Fraction("9.80665")
FAHRENHEIT, LITRE = Fraction(5, 9), Fraction(1, 1000)
GALLON = 231 * INCH**3
"""m3, of the US."""

HORSEPOWER = 550 * 12 * INCH * POUND_FORCE
"""W, the mechanical one."""

TURN = Fraction(2.0 * math.pi)

RADIANS_OR_TURNS = "standards write angular speed so, others turns; write 'rad/s', or 'rev/s' or 'rpm'"
GAUGE = "write 'psi'; pressures of films and supplies stand above that of the surroundings"
AMBIGUOUS_TON = "'t' is the tonne, 1000 kg; a US ton is '2000 lb', an imperial one '2240 lb'"


@dataclass(frozen=True, eq=False)
class Kind:
    """A kind of quantity.

    Attributes
    ----------
    unit : str
        SI unit: what a number without unit is in, where it is taken.
    phrase : str
        With its article, for messages.
    example : str
        How an engineer writes one.
    factors : Mapping[str, Fraction or float]
        Factor to SI of each everyday unit, most usual first.
    offsets : Mapping[str, Fraction]
        What is added after the factor, for temperatures.
    open_to_pint : bool
        Whether units outside `everyday` are tried with pint. Not where pint cannot tell kinds apart: it
        takes 1 Hz for 1 rad/s.
    name : str
        Of a kind that shares its unit with another one; else the unit names it.
    ambiguous : Mapping[str, str]
        Units that are refused, as people mean different things by them, and what to write.
    one_unit : bool
        Whether all write it in one unit, so that a case file may leave the unit out. Not where people vary it:
        3000 is rpm to one and rad/s to another.
    guesses : tuple of str
        Units that a number without one may be in, where these are not the first of `everyday`.
    """

    unit: str
    phrase: str
    example: str
    factors: Mapping[str, Any]
    offsets: Mapping[str, Fraction] = field(default_factory=dict)
    open_to_pint: bool = True
    name: str = ""
    ambiguous: Mapping[str, str] = field(default_factory=dict)
    one_unit: bool = False
    guesses: tuple[str, ...] = ()

    @property
    def key(self) -> str:
        """Under which `KINDS` holds it."""
        return self.name or self.unit

    @cached_property
    def everyday(self) -> Mapping[str, float]:
        """Factors to SI, rounded."""
        return {unit: float(factor) for unit, factor in self.factors.items()}

    @cached_property
    def _exact(self) -> Mapping[str, Fraction]:
        return {unit: as_written(factor) for unit, factor in self.factors.items()}

    def to_si(self, number: float, unit: str) -> float:
        """Convert from an everyday unit, exactly but for one rounding: what is written in two units is one number.

        >>> KINDS["K"].to_si(50.0, "degC"), KINDS["m"].to_si(268.36, "mm"), KINDS["m"].to_si(1.0, "ft")
        (323.15, 0.26836, 0.3048)
        """
        if not math.isfinite(number):
            return number
        try:
            return float(as_written(number) * self._exact[unit] + self.offsets.get(unit, 0))
        except OverflowError:
            return math.copysign(math.inf, number)

    def from_si(self, value: float, unit: str) -> float:
        """Convert to an everyday unit.

        >>> KINDS["m"].from_si(0.25, "mm")
        250.0
        """
        return (value - float(self.offsets.get(unit, 0))) / self.everyday[unit]


def as_written(number: Fraction | float) -> Fraction:
    """A number exactly: of a float the shortest decimal that is it, which is what was written."""
    return number if isinstance(number, Fraction) else Fraction(repr(float(number)))


_ALL = (
    Kind(
        "m",
        "a length",
        "120 mm",
        {"mm": 1e-3, "m": 1.0, "um": 1e-6, "cm": 1e-2, "micron": 1e-6, "nm": 1e-9, "in": INCH, "inch": INCH}
        | {"mil": INCH / 1000, "mils": INCH / 1000, "thou": INCH / 1000, "ft": 12 * INCH},
    ),
    Kind("m2", "an area", "0.3 m2", {"m2": 1.0, "mm2": 1e-6, "cm2": 1e-4, "dm2": 1e-2}),
    Kind(
        "m3",
        "a volume",
        "500 L",
        {"L": 1e-3, "l": 1e-3, "m3": 1.0, "dm3": 1e-3, "cm3": 1e-6, "mL": 1e-6, "ml": 1e-6},
    ),
    Kind(
        "rad",
        "an angle",
        "75 deg",
        {"deg": TURN / 360, "°": TURN / 360, "degree": TURN / 360, "degrees": TURN / 360, "rad": 1.0}
        | {"mrad": 1e-3, "turn": TURN, "rev": TURN},
    ),
    Kind("s", "a time", "2 min", {"s": 1.0, "min": 60.0, "h": 3600.0, "ms": 1e-3}),
    Kind("kg", "a mass", "1.55 t", {"kg": 1.0, "t": 1e3, "g": 1e-3, "lb": 0.45359237}),
    Kind(
        "N",
        "a force",
        "36 kN",
        {"kN": 1e3, "N": 1.0, "MN": 1e6, "mN": 1e-3, "kgf": KILOGRAM_FORCE, "kp": KILOGRAM_FORCE}
        | {"kilopond": KILOGRAM_FORCE, "lbf": POUND_FORCE, "klbf": 1000 * POUND_FORCE},
    ),
    Kind(
        "Pa",
        "a pressure",
        "0.2 MPa",
        {"MPa": 1e6, "bar": 1e5, "kPa": 1e3, "Pa": 1.0, "GPa": 1e9, "mbar": 1e2, "N/mm2": 1e6, "N/m2": 1.0}
        | {"psi": POUND_FORCE / INCH**2, "atm": 101325.0, "kgf/cm2": KILOGRAM_FORCE * 10000},
        ambiguous={"psig": GAUGE, "psia": GAUGE},
    ),
    Kind(
        "K",
        "a temperature",
        "50 degC",
        {"degC": 1.0, "°C": 1.0, "C": 1.0, "celsius": 1.0, "K": 1.0}
        | {"degF": FAHRENHEIT, "°F": FAHRENHEIT, "F": FAHRENHEIT},
        dict.fromkeys(("degC", "°C", "C", "celsius"), FREEZING)
        | dict.fromkeys(("degF", "°F", "F"), FREEZING - 32 * FAHRENHEIT),
        guesses=("degC", "degF", "K"),
    ),
    Kind(
        "rad/s",
        "a rotational speed",
        "3000 rpm",
        {"rpm": TURN / 60, "1/min": TURN / 60, "min-1": TURN / 60, "/min": TURN / 60}
        | {"r/min": TURN / 60, "rev/min": TURN / 60, "turn/min": TURN / 60, "U/min": TURN / 60}
        | {"rad/s": 1.0, "Hz": TURN, "kHz": 1000 * TURN, "r/s": TURN, "rev/s": TURN, "rps": TURN, "turn/s": TURN}
        | {"rad/min": Fraction(1, 60), "deg/s": TURN / 360},
        open_to_pint=False,
        ambiguous=dict.fromkeys(("1/s", "s-1", "/s"), RADIANS_OR_TURNS),
    ),
    Kind(
        "rad/s",
        "a frequency",
        "100 Hz",
        {"Hz": TURN, "kHz": 1000 * TURN, "rad/s": 1.0, "MHz": 1000000 * TURN, "1/s": TURN, "s-1": TURN, "/s": TURN}
        | {"rpm": TURN / 60, "1/min": TURN / 60, "min-1": TURN / 60, "/min": TURN / 60},
        open_to_pint=False,
        name="frequency",
    ),
    Kind(
        "m/s",
        "a speed",
        "45 m/s",
        {"m/s": 1.0, "mm/s": 1e-3, "m/min": Fraction(1, 60), "km/h": Fraction(10, 36), "ft/s": 12 * INCH},
    ),
    Kind(
        "N/m",
        "a stiffness",
        "200 MN/m",
        {"N/m": 1.0, "kN/m": 1e3, "MN/m": 1e6, "GN/m": 1e9, "N/mm": 1e3, "kN/mm": 1e6, "N/um": 1e6}
        | {
            "lbf/in": POUND_FORCE / INCH,
            "klbf/in": 1000 * POUND_FORCE / INCH,
            "Mlbf/in": 1000000 * POUND_FORCE / INCH,
        },
    ),
    Kind(
        "Pa s",
        "a dynamic viscosity",
        "16 mPa s",
        {"mPa s": 1e-3, "Pa s": 1.0, "mPas": 1e-3, "Pas": 1.0, "cP": 1e-3, "P": 0.1},
    ),
    Kind(
        "m2/s",
        "a kinematic viscosity",
        "46 mm2/s",
        {"mm2/s": 1e-6, "cSt": 1e-6, "m2/s": 1.0, "cm2/s": 1e-4, "St": 1e-4},
    ),
    Kind(
        "kg/m3",
        "a density",
        "895 kg/m3",
        {"kg/m3": 1.0, "g/cm3": 1e3, "kg/L": 1e3, "kg/l": 1e3, "g/mL": 1e3},
        one_unit=True,
    ),
    Kind(
        "m3/s",
        "a flow rate",
        "26 L/min",
        {"L/min": LITRE / 60, "l/min": LITRE / 60, "m3/s": 1.0, "m3/h": Fraction(1, 3600), "L/s": LITRE}
        | {"l/s": LITRE, "cm3/s": 1e-6, "L/h": LITRE / 3600, "l/h": LITRE / 3600, "gpm": GALLON / 60},
    ),
    Kind(
        "W/(m2 K)",
        "a heat transfer coefficient",
        "20 W/(m2 K)",
        {"W/(m2 K)": 1.0, "W/m2/K": 1.0, "W/m2K": 1.0, "W/(m2K)": 1.0},
        one_unit=True,
    ),
    Kind(
        "Pa m/s",
        "a load times speed",
        "30 MPa m/s",
        {"Pa m/s": 1.0, "kPa m/s": 1e3, "MPa m/s": 1e6, "N/mm2 m/s": 1e6},
    ),
    Kind("W/K", "a thermal conductance", "0.2 W/K", {"W/K": 1.0, "mW/K": 1e-3, "kW/K": 1e3}, one_unit=True),
    Kind(
        "W/(m K)",
        "a thermal conductivity",
        "0.13 W/(m K)",
        {"W/(m K)": 1.0, "W/m/K": 1.0, "W/(mK)": 1.0},
        one_unit=True,
    ),
    Kind(
        "J/(kg K)",
        "a heat capacity",
        "1942 J/(kg K)",
        {"J/(kg K)": 1.0, "kJ/(kg K)": 1e3, "J/kg/K": 1.0, "kJ/kg/K": 1e3, "J/(kgK)": 1.0, "kJ/(kgK)": 1e3},
        one_unit=True,
    ),
    Kind(
        "J/(m3 K)",
        "a volumetric heat capacity",
        "1.8 MJ/(m3 K)",
        {"MJ/(m3 K)": 1e6, "J/(m3 K)": 1.0, "kJ/(m3 K)": 1e3, "J/m3/K": 1.0, "MJ/m3/K": 1e6},
    ),
    Kind(
        "1/K",
        "a coefficient per kelvin",
        "11e-6 1/K",
        {"1/K": 1.0, "/K": 1.0, "K-1": 1.0, "ppm/K": 1e-6, "1/degC": 1.0, "/degC": 1.0, "1/°C": 1.0}
        | {"um/(m K)": 1e-6, "um/m/K": 1e-6},
        one_unit=True,
    ),
    Kind(
        "1/Pa",
        "a coefficient of viscosity and pressure",
        "20 1/GPa",
        {"1/Pa": 1.0, "Pa-1": 1.0, "1/GPa": 1e-9, "GPa-1": 1e-9, "1/MPa": 1e-6, "1/bar": 1e-5}
        | {"m2/N": 1.0, "mm2/N": 1e-6},
    ),
    Kind(
        "m/Pa",
        "a displacement per pressure",
        "0.5 um/MPa",
        {"um/MPa": 1e-12, "m/Pa": 1.0, "mm/MPa": 1e-9, "um/bar": 1e-11, "m3/N": 1.0, "mm3/N": 1e-9},
    ),
    Kind(
        "kg/(m3 K)",
        "a change of density per kelvin",
        "-0.63 kg/(m3 K)",
        {"kg/(m3 K)": 1.0, "kg/m3/K": 1.0},
        one_unit=True,
    ),
    Kind(
        "J/(kg K2)",
        "a change of heat capacity per kelvin",
        "3.9 J/(kg K2)",
        {"J/(kg K2)": 1.0, "J/kg/K2": 1.0},
        one_unit=True,
    ),
    # Not a temperature: 10 K and 10 degC are the same difference, and no offset may creep in.
    Kind(
        "K",
        "a temperature difference",
        "900 K",
        {"K": 1.0, "delta_degC": 1.0, "delta_degF": FAHRENHEIT, "degR": FAHRENHEIT},
        open_to_pint=False,
        name="K difference",
        one_unit=True,
    ),
    Kind(
        "N s/m",
        "a damping",
        "80 kN s/m",
        {"kN s/m": 1e3, "N s/m": 1.0, "MN s/m": 1e6}
        | {"lbf s/in": POUND_FORCE / INCH, "klbf s/in": 1000 * POUND_FORCE / INCH},
    ),
    Kind(
        "kg m2", "a moment of inertia", "0.06 kg m2", {"kg m2": 1.0, "g m2": 1e-3, "kg cm2": 1e-4, "kg mm2": 1e-6}
    ),
    Kind(
        "N m",
        "a moment",
        "200 N m",
        {"N m": 1.0, "kN m": 1e3} | {"lbf ft": 12 * INCH * POUND_FORCE, "lbf in": INCH * POUND_FORCE},
    ),
    Kind("N m/rad", "a stiffness against tilt", "40 kN m/rad", {"N m/rad": 1.0, "kN m/rad": 1e3, "MN m/rad": 1e6}),
    Kind("N m s/rad", "a damping of tilt", "5 N m s/rad", {"N m s/rad": 1.0, "kN m s/rad": 1e3}),
    Kind(
        "m3/(s Pa)",
        "a conductance",
        "0.06 L/(min MPa)",
        {
            "L/(min MPa)": LITRE / 60 / 1000000,
            "L/(min bar)": LITRE / 60 / 100000,
            "m3/(s Pa)": 1.0,
            "cm3/(s MPa)": 1e-12,
        },
    ),
    Kind("W", "a power", "31 kW", {"kW": 1e3, "W": 1.0, "MW": 1e6, "hp": HORSEPOWER}),
    Kind(
        "1",
        "a number without unit",
        "1.6e-3, '1.6 permille' or '0.16 %'",
        {"": 1.0, "permille": 1e-3, "‰": 1e-3, "%": 1e-2, "percent": 1e-2, "ppm": 1e-6},
        open_to_pint=False,
        one_unit=True,
    ),
)


def keyed(kinds: Iterable[Kind]) -> dict[str, Kind]:
    """Give kinds by their keys, each of which belongs to one of them.

    Raises
    ------
    ValueError
        When two share a key: the second would shadow the first.
    """
    made: dict[str, Kind] = {}
    for kind in kinds:
        if kind.key in made:
            raise ValueError(f"two kinds of quantities are keyed {kind.key!r}")
        made[kind.key] = kind
    return made


KINDS: dict[str, Kind] = keyed(_ALL)
"""All kinds by their SI unit, or by their name where two share one."""


def kind_of(unit: str) -> Kind | None:
    """Kind that an everyday unit belongs to, or None.

    >>> kind_of("t").phrase
    'a mass'
    """
    return next((kind for kind in _ALL if unit in kind.everyday), None)
