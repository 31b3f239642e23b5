"""Texts and rows that are composed in units of the SI, in those of the US where these are spoken.

Quantities of the vocabulary show themselves in the units that are spoken (`babbitt.core.quantities`). What else a
report says, inputs, assumptions, answers, notes, is composed in units of the SI, and turned into those of the US
here, once, when all of it stands.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterable, Mapping
from typing import Any

from babbitt.core.language import decimal, translated
from babbitt.core.quantities.display import SI, US, DisplayUnit, is_spoken

__all__ = ["OF_RESULTS", "PARTNERS", "UNITS", "in_us_units", "numbers_in_us_units", "units_named_in_us_units"]

DIGITS, OF_RESULTS = 4, 3
"""Significant digits at least: of inputs, which may be exact with one digit, and of results, which are not."""

LONGEST = 7
"""Digits up to which a number is written without a power of ten."""

_FEET, _INCH, _POUND, _BTU = 0.3048, 0.0254, 0.45359237, 1055.05585262
_FAHRENHEIT = 1.8
_PSI = 6894.757293168
_GALLON = 3.785411784

OTHERS = {
    "m": ("ft", 1.0 / _FEET),
    "m²": ("ft²", _FEET**-2),
    "mL": ("in³", 1e-6 / _INCH**3),
    "L": ("gal", 1.0 / _GALLON),
    "kg m²": ("lb ft²", 1.0 / (_POUND * _FEET**2)),
    "1/K": ("1/°F", 1.0 / _FAHRENHEIT),
    "1/GPa": ("1/Mpsi", 1e-3 * _PSI),
    "1/MPa": ("1/psi", 1e-6 * _PSI),
    "µm/MPa": ("mil/kpsi", 1e-3 * _PSI / 25.4),
    "L/(min MPa)": ("gpm/psi", 1e-6 * _PSI / _GALLON),
    "W/K": ("Btu/(h °F)", 3600.0 / (_BTU * _FAHRENHEIT)),
    "W/(m K)": ("Btu/(h ft °F)", 3600.0 * _FEET / (_BTU * _FAHRENHEIT)),
    "kg/(m³ K)": ("lb/(ft³ °F)", _FEET**3 / (_POUND * _FAHRENHEIT)),
    "J/(kg K²)": ("Btu/(lb °F²)", 1.0 / (4186.8 * _FAHRENHEIT)),
}
"""Units of texts that no quantity of the vocabulary has: partner of the US, and how many of it are one."""

OTHERWISE = {
    "um": "µm", "degC": "°C", "mm2/s": "mm²/s", "kg/m3": "kg/m³", "J/(m3 K)": "J/(m³ K)", "J/(kg K2)": "J/(kg K²)",
    "kg/(m3 K)": "kg/(m³ K)", "W/(m2 K)": "W/(m² K)", "kg m2": "kg m²", "m2": "m²", "MNs/m": "MN s/m",
    "× 10⁻⁶/K": "1e-6/K", "10⁻⁶/K": "1e-6/K",
}  # fmt: skip
"""How units are written in texts beside their labels in tables."""

LABELS = {"1e-6/°F": {"× 10⁻⁶/K": "× 10⁻⁶/°F", "10⁻⁶/K": "10⁻⁶/°F"}}
"""Labels of partners by how the unit was written."""


def _partners() -> dict[str, tuple[str, float, float]]:
    """Label of the partner, factor and offset, by the label of a unit of the SI."""
    found = {label: (partner, factor, 0.0) for label, (partner, factor) in OTHERS.items()}
    for name, partner in US.items():
        unit: DisplayUnit = SI[name]
        factor = partner.scale / unit.scale
        found.setdefault(unit.label, (partner.label, factor, partner.offset - unit.offset * factor))
    found |= {written: found[label] for written, label in OTHERWISE.items() if label in found}
    return {
        written: (LABELS.get(partner, {}).get(written, partner), factor, offset)
        for written, (partner, factor, offset) in found.items()
    }


PARTNERS = _partners()

_SIGN, _NUMBER = r"[+±−-]?", r"\d+(?:[.{comma}]\d+)?(?:(?:e| × 10\^)[+−-]?\d+)?"
UNITS = "|".join(re.escape(unit) for unit in sorted(PARTNERS, key=len, reverse=True))
_NAMED = re.compile(rf"(?<= in )(?:{UNITS})(?=$|[ ),.;:])")
_BETWEEN = r"(?:, | to | and | × | in place of | instead of | bis | und | и | до |…| – )"


def _patterns(comma: str) -> tuple[re.Pattern[str], re.Pattern[str]]:
    number = _SIGN + _NUMBER.format(comma=comma)
    before, behind = r"(?<![\w.,/^*°])(?<!pad )(?<!recess )", r"(?![\w/²³°(^])"
    run = rf"{before}(by )?({number}(?:{_BETWEEN}{number})*)[ \u00a0\u2009]({UNITS}){behind}"
    return re.compile(number), re.compile(run)


ENGLISH, WITH_COMMA = _patterns(""), _patterns(",")
"""A number; and numbers before one unit."""

OWN_WORDS = ("name", "notes", "source", "bearing")
"""Keys of what stands in the words of the case."""

NOT_TEXT = (
    "words", "hash", "version", "language", "svg", "symbol", "formula", "substituted", "spoken", "sections",
    "case_text", "references", "heading",
)  # fmt: skip
"""Keys of what is no text, of lines of the calculation, which stay in the SI, and of titles of publications."""

RESULTS = ("answers", "tables", "findings", "warnings")
"""Keys of what tells results."""

OF_THE_CASE = ("Name", "Notes", "Source", "Source of the numbers", "Operating point")
"""Rows of inputs whose values are words of the case."""


def in_us_units(data: Any, digits: int = DIGITS, own_words: Collection[str] = ()) -> Any:
    """What a report says, in the units that are spoken: in the SI as it is.

    Parameters
    ----------
    data : dict, list, str, ...
        Texts as they were composed; dictionaries with ``value`` or ``values`` and a ``unit``, and tables of
        ``columns`` with units and ``rows``, have their numbers and units apart.
    digits : int
        Significant digits of a number at least.
    own_words : collection of str
        Texts of the case that stay as they are.

    Examples
    --------
    >>> from babbitt.core.quantities import displayed_in
    >>> with displayed_in("us"):
    ...     in_us_units("pocket 40 mm wide, 100 to 115 °C, 2 pads"), in_us_units({"value": "20", "unit": "kN"})
    ('pocket 1.575 in wide, 212 to 239 °F, 2 pads', {'value': '4496', 'unit': 'lbf'})
    """
    return _converted(data, digits, own_words) if is_spoken("us") else data


def numbers_in_us_units(said: str, unit: str) -> str:
    """Numbers of results whose unit, one of `PARTNERS`, stands elsewhere, in that which is spoken."""
    turned: str = _numbers(said, unit, OF_RESULTS) if is_spoken("us") else said
    return turned


def units_named_in_us_units(said: str) -> str:
    """Units of scales, of which the numbers stand elsewhere.

    >>> units_named_in_us_units("Temperature of the film in °C along the hottest pad")
    'Temperature of the film in °F along the hottest pad'
    """
    return _NAMED.sub(lambda found: PARTNERS[found[0]][0], said)


def _converted(data: Any, digits: int, own_words: Collection[str]) -> Any:
    if isinstance(data, str):
        return data if data in own_words else _text(data, digits)
    if isinstance(data, list | tuple):
        return type(data)(_converted(one, digits, own_words) for one in data)
    if not isinstance(data, Mapping):
        return data
    if data.get("label") in [translated(one) for one in OF_THE_CASE]:
        return data
    made = {
        key: one if _stays(key, one) else _converted(one, OF_RESULTS if key in RESULTS else digits, own_words)
        for key, one in data.items()
    }
    if isinstance(made.get("caption"), str):
        made["caption"] = units_named_in_us_units(made["caption"])
    if data.get("unit") in PARTNERS and isinstance(data["unit"], str):
        for key in ("value", "values", "limited"):
            if key in data:
                made[key] = _numbers(data[key], data["unit"], digits)
        made["unit"] = PARTNERS[data["unit"]][0]
    if "columns" in data and "rows" in data:
        made["rows"] = _rows(data["columns"], made["rows"], digits)
    return made


def _stays(key: str, said: Any) -> bool:
    """Whether something stands as it is; ``bearings`` are chapters, or names in a row."""
    return key in (*OWN_WORDS, *NOT_TEXT) or (key == "bearings" and isinstance(said, str))


def _rows(columns: Iterable[Mapping[str, Any]], rows: Iterable[Any], digits: int) -> list[Any]:
    """Rows of a table whose columns have units above them."""
    units = [column.get("unit", "") for column in columns]
    if not any(unit in PARTNERS for unit in units):
        return list(rows)
    return [
        [
            _numbers(cell, unit, digits) if unit in PARTNERS else cell
            for cell, unit in zip(row, units, strict=False)
        ]
        if isinstance(row, list | tuple)
        else row
        for row in rows
    ]


def _numbers(said: Any, unit: str, digits: int) -> Any:
    """Numbers of which the unit stands elsewhere."""
    if not isinstance(said, str):
        return [_numbers(one, unit, digits) for one in said]
    number, _ = _pattern()
    return number.sub(lambda found: _number(found[0], unit, digits), said)


def _text(said: str, digits: int) -> str:
    number, run = _pattern()

    def turned(found: re.Match[str]) -> str:
        by, numbers, unit = found[1] or "", found[2], found[3]
        turned = number.sub(lambda one: _number(one[0], unit, digits, is_difference=bool(by)), numbers)
        return f"{by}{turned} {PARTNERS[unit][0]}"

    return run.sub(turned, said)


def _pattern() -> tuple[re.Pattern[str], re.Pattern[str]]:
    return WITH_COMMA if decimal("0.5") != "0.5" else ENGLISH


def _number(said: str, unit: str, least: int = DIGITS, *, is_difference: bool = False) -> str:
    """A number in the partner of its unit, as finely as it was written, to some digits at least.

    >>> _number("120.035", "mm"), _number("5", "um"), _number("0", "µm"), _number("20", "°C"), _number("500", "kN")
    ('4.72579', '0.1969', '0', '68', '112400')
    >>> _number("1.2 × 10^−5", "m"), _number("12e-6", "m"), _number("±5", "°C")
    ('0.00003937', '0.00003937', '±9')
    """
    plain = said.replace(" × 10^", "e").replace(",", ".").replace("−", "-").lstrip("±")
    sign = "±" if said.startswith("±") else "+" if said.startswith("+") else ""
    _, factor, offset = PARTNERS[unit]
    value = float(plain) * factor + (0.0 if is_difference or sign == "±" else offset)
    mantissa, _, power = plain.partition("e")
    step = abs(factor) * 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))
    if value == 0.0:
        return "0"
    size = math.floor(math.log10(abs(value)))
    digits = max(least, 1 + size - math.floor(math.log10(step)))
    shown = f"{value:.{digits}g}"
    if "e" in shown and -LONGEST < size < LONGEST:
        shown = f"{float(shown):.{max(digits - 1 - size, 0) if size < 0 else 0}f}"
    return sign + decimal(shown).replace("-", "−" if "−" in said else "-")
