"""From what the engineer writes to an SI number: a number, or a number and a unit, and nothing else.

Text never reaches an evaluator: it must be one number and a short product of unit names with one-digit
exponents, so that no expression from a file can keep the machine busy.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

from babbitt.core.nearest_name import nearest_names
from babbitt.core.picklable_error import PicklableError
from babbitt.core.units.kinds import AMBIGUOUS_TON, KINDS, Kind, kind_of

LONGEST = 60
"""Characters; a longer text is no quantity."""

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,3})?"
_QUANTITY = re.compile(rf"({_NUMBER})\s*(.*)", re.DOTALL)
_FACTOR = r"[^\W\d_]+(?:-?[1-9])?"
_UNIT = re.compile(rf"(?:1\s?)?/?\s?\(?{_FACTOR}(?:(?:\)?\s?/\s?|\s)\(?{_FACTOR})*\)?")
_COMMA = re.compile(r"([-+]?\d+),(\d+)(.*)", re.DOTALL)
_THOUSANDS = re.compile(r"([-+]?\d{1,3}(?:[ '_\u00a0\u202f]\d{3})+(?:\.\d+)?)(.*)", re.DOTALL)
_SPELLING = str.maketrans("µμ²³⁻¹·*", "uu23-1  ", "^")


INCH_MARKS = ('"', "''", "\N{DOUBLE PRIME}", "\N{RIGHT DOUBLE QUOTATION MARK}")
DIFFERENCES = "write a difference in 'K', 'delta_degC', 'delta_degF' or 'degR'"


class QuantityError(PicklableError, ValueError):
    """What was given is no quantity of the kind asked for.

    Attributes
    ----------
    says : str
        What is wrong.
    allowed : str
        What would do; empty where `says` tells.
    hint : str
        What to write instead, where that can be guessed.
    given : Kind or None
        The kind of quantity that was given, where it is known and another than was asked for.
    """

    def __init__(self, says: str, allowed: str = "", hint: str = "", given: Kind | None = None) -> None:
        super().__init__("; ".join([says] + [f"allowed: {allowed}"] * bool(allowed) + [hint] * bool(hint)))
        self.says, self.allowed, self.hint, self.given = says, allowed, hint, given


class SiNumber(float):
    """A number that was brought to SI by what read it, such as a table whose heading has the units."""


def read(given: object, unit: str) -> float:
    """Read a quantity.

    Parameters
    ----------
    given : object
        A number in SI, or text with a number and a unit.
    unit : str
        Of the kind wanted, a key of `babbitt.core.units.KINDS`.

    Returns
    -------
    float
        In SI.

    Raises
    ------
    QuantityError
        Not a finite number, an unknown unit, or a quantity of another kind.

    Examples
    --------
    >>> read("120 mm", "m"), read(0.12, "m"), read("1.6 permille", "1")
    (0.12, 0.12, 0.0016)
    >>> read("120 kg", "m")
    Traceback (most recent call last):
    babbitt.core.units.reading.QuantityError: '120 kg' is a mass; allowed: a length such as '120 mm'
    """
    kind = KINDS[unit]
    if isinstance(given, str):
        return _read_text(given, kind)
    if isinstance(given, bool) or not isinstance(given, int | float):
        raise QuantityError(f"{_noun(given)} is not a quantity", _wanted(kind))
    try:
        return _finite(float(given), str(given), kind)
    except OverflowError:
        raise QuantityError("the number is far too large", _wanted(kind)) from None


def written(value: float, unit: str) -> str:
    """Write an SI value in an everyday unit.

    >>> written(0.25, "mm"), written(323.15, "degC")
    ('250 mm', '50 degC')
    """
    kind = kind_of(unit)
    if kind is None:
        raise KeyError(unit)
    return f"{kind.from_si(value, unit):.5g} {unit}".rstrip()


def bare_number(given: object) -> float | None:
    """Give the number that stands without unit, None where there is none or a unit stands with it.

    >>> bare_number(3000), bare_number("3000"), bare_number("3000 rpm")
    (3000.0, 3000.0, None)
    """
    if isinstance(given, bool) or not isinstance(given, int | float | str):
        return None
    try:
        return float(given)
    except (ValueError, OverflowError):
        return None


def plausible_units(number: float, kind: Kind, bounds: tuple[float, float] | None) -> list[str]:
    """Give the most usual units that bring a bare number into a range; rare ones are no good guess.

    A number that is large enough to be written without the prefix of the usual unit is rather in the unit without:
    12000 is 12 kN rather than 12 MN. Where no usual unit fits, that of SI may.

    >>> plausible_units(250.0, KINDS["m"], (0.001, 3.0)), plausible_units(36.0, KINDS["N"], (1.0, 1e9))
    (['mm'], ['kN', 'N'])
    >>> plausible_units(12000.0, KINDS["N"], (1.0, 1e9)), plausible_units(333.0, KINDS["K"], (243.15, 473.15))
    (['N', 'kN'], ['degF', 'K'])
    """
    fits: dict[float, str] = {}
    usual = list(kind.guesses or kind.everyday)[:3]
    for unit in _unprefixed_first(usual, number, kind):
        value = kind.to_si(number, unit)
        if bounds is None or bounds[0] <= value <= bounds[1]:
            fits.setdefault(value, unit)  # rpm and 1/min are one
    if not fits and bounds is not None and kind.unit in kind.everyday and bounds[0] <= number <= bounds[1]:
        return [kind.unit]
    return list(fits.values())[:2]


def _unprefixed_first(usual: list[str], number: float, kind: Kind) -> list[str]:
    """Move the SI unit before its multiples where the number counts at least one of the first of them."""
    first = kind.everyday[usual[0]]
    if kind.unit in usual and 1e3 <= first <= abs(number):
        return sorted(usual, key=lambda unit: unit != kind.unit)
    return usual


@lru_cache(maxsize=4096)
def _read_text(text: str, kind: Kind) -> float:
    trimmed = text.strip().replace("\N{MINUS SIGN}", "-")
    match = _QUANTITY.fullmatch(trimmed) if len(trimmed) <= LONGEST else None
    if match is None:
        raise QuantityError(f"{_quoted(text)} is not a quantity", _wanted(kind))
    _refuse_grouped_digits(trimmed)
    number, unit = float(match[1]), _normal(match[2])
    if unit == "":
        return _finite(number, _quoted(text), kind)
    if unit in kind.everyday:
        return _finite(kind.to_si(number, unit), _quoted(text), kind)
    if unit in kind.ambiguous:
        raise QuantityError(f"{_quoted(text)} is ambiguous", _wanted(kind), kind.ambiguous[unit])
    return _finite(_with_pint(number, unit, kind, text), _quoted(text), kind)


def _refuse_grouped_digits(text: str) -> None:
    if match := _COMMA.fullmatch(text):
        whole, rest, unit = match.groups()
        hint = f"write '{whole}.{rest}{unit}'"
        if len(rest) == 3:  # not '12.000', which stands for thousands as often
            plain = f"{float(f'{whole}.{rest}'):g}"
            hint = f"write '{whole}{rest}{unit}' if thousands are meant, or '{plain}{unit}'"
        raise QuantityError(f"{_quoted(text)} has a comma", "a decimal point", hint)
    if match := _THOUSANDS.fullmatch(text):
        digits = re.sub(r"[ '_\u00a0\u202f]", "", match[1])
        raise QuantityError(
            f"{_quoted(text)} has its digits grouped", "digits in one piece", f"write '{digits}{match[2]}'"
        )


def _normal(unit: str) -> str:
    """Bring the ways of writing a unit to one: ``W/(m²·K)`` and ``W/(m^2*K)`` to ``W/(m2 K)``.

    >>> _normal("W/(m²·K)"), _normal("mm**2 / s"), _normal("μm")
    ('W/(m2 K)', 'mm2/s', 'um')
    """
    text = " ".join(unit.replace("**", "").translate(_SPELLING).split())
    return re.sub(r"\s*([/()])\s*", r"\1", text).replace(")(", ") (") if "/" in text else text


def _with_pint(number: float, unit: str, kind: Kind, text: str) -> float:
    other = kind_of(unit)
    if other is not None:
        hint = DIFFERENCES if kind is KINDS["K difference"] and other is KINDS["K"] else ""
        raise QuantityError(f"{_quoted(text)} is {other.phrase}", _wanted(kind), hint, given=other)
    if unit in INCH_MARKS:
        raise QuantityError(f"{_quoted(text)} has a mark for a unit", _wanted(kind), f"write '{number:.12g} in'")
    if not _UNIT.fullmatch(unit):
        raise QuantityError(f"{_quoted(text)} is not a quantity", _wanted(kind))
    registry = pint_registry()
    try:
        factors = registry.parse_units(_for_pint(unit))
    except Exception:  # pint reports unknown units with many types of exception
        raise QuantityError(
            f"the unit of {_quoted(text)} is not known", _wanted(kind), _nearest(unit, kind)
        ) from None
    if any(_is_ton(name) for name, _ in registry.Quantity(1.0, factors).unit_items()):
        raise QuantityError(f"{_quoted(text)} is ambiguous", _wanted(kind), AMBIGUOUS_TON)
    if (
        not kind.open_to_pint
        or factors.dimensionality != registry.parse_units(_for_pint(kind.unit)).dimensionality
    ):
        found = _kind_by_dimension(factors)
        phrase = found.phrase if found is not None else "of another kind"
        raise QuantityError(f"{_quoted(text)} is {phrase}", _wanted(kind), _same_letters(unit, kind), found)
    return float(registry.Quantity(number, factors).to(_for_pint(kind.unit)).magnitude)


@lru_cache(maxsize=1)
def pint_registry() -> Any:
    """Give our own registry: other programs in the process may have changed the application-wide one."""
    import pint

    return pint.UnitRegistry(autoconvert_offset_to_baseunit=True)


def _is_ton(name: str) -> bool:
    """Whether a unit of pint is its ton, that of the US, with or without prefix."""
    return any(base == "ton" for _, base, _ in pint_registry().parse_unit_name(name))


def _for_pint(unit: str) -> str:
    text = re.sub(r"^/", "1/", unit.removeprefix("1 "))
    text = re.sub(r"(?<=[^\W\d_])(-?[1-9])", r"**\1", text.replace("°C", "degC").replace("°F", "degF"))
    return text.replace(" ", "*")


def _kind_by_dimension(factors: Any) -> Kind | None:
    registry = pint_registry()
    for kind in KINDS.values():
        if (
            kind.open_to_pint
            and registry.parse_units(_for_pint(kind.unit)).dimensionality == factors.dimensionality
        ):
            return kind
    return None


def _same_letters(unit: str, kind: Kind) -> str:
    return _meant([known for known in kind.everyday if known.lower() == unit.lower()])


def _nearest(unit: str, kind: Kind) -> str:
    """Hint at a unit: capitals mixed up, else one letter mistyped, else whatever looks alike."""
    mistyped = [known for known in kind.everyday if len(unit) > 1 and _differ_by_one_letter(unit, known)]
    alike = nearest_names(unit, kind.everyday)
    return _same_letters(unit, kind) or _meant(mistyped) or _meant(alike)


def _differ_by_one_letter(one: str, other: str) -> bool:
    return len(one) == len(other) and sum(a != b for a, b in zip(one, other, strict=True)) == 1


def _meant(units: Sequence[str]) -> str:
    return f"did you mean '{units[0]}'?" if units else ""


def _finite(value: float, shown: str, kind: Kind) -> float:
    if not math.isfinite(value):
        raise QuantityError(f"{shown} is not a finite number", _wanted(kind))
    return value


def _wanted(kind: Kind) -> str:
    example = kind.example if kind.unit == "1" else f"'{kind.example}'"
    return f"{kind.phrase} such as {example}"


def _noun(given: object) -> str:
    if given is None:
        return "an empty value"
    if isinstance(given, bool):
        return "true" if given else "false"
    if isinstance(given, dict | list | tuple):
        return "a mapping" if isinstance(given, dict) else "a list"
    return f"a {type(given).__name__}"


def _quoted(text: str) -> str:
    """Quote what was given, short and without control characters."""
    clean = "".join(char if char.isprintable() else "?" for char in text)
    return f"'{clean}'" if len(clean) <= LONGEST else f"'{clean[: LONGEST - 3]}...'"
