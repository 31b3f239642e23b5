"""Numbers of a study as engineers read them: inputs in everyday units, outputs in those of the vocabulary."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.check_text import distance
from babbitt.core.language import ENGLISH, decimal, language, translated, translated_if_known, unit_sign
from babbitt.core.notices import explanations
from babbitt.core.notices.notice import retold
from babbitt.core.quantities import QUANTITIES
from babbitt.core.quantities.display import SI, in_system, written_in_system
from babbitt.core.result import Outcome
from babbitt.core.units import KINDS
from babbitt.report.names import format_members
from babbitt.report.text import plain_text
from babbitt.report.us_words import in_us_units
from babbitt.study.rows import Columns, kelvin_name

__all__ = [
    "DASH",
    "MARGIN_DECIMALS",
    "Scale",
    "StudyTable",
    "bearing_text",
    "check_title",
    "input_scale",
    "kelvin_scale",
    "margin_text",
    "output_scale",
    "percent",
    "reason_text",
    "refusal",
    "significant",
]

MARGIN_DECIMALS = 1
"""Of margins in percent."""

DASH = "–"
"""Stands where a table has no value."""

SHOWN = {"um": "µm", "degC": "°C", "degF": "°F", "deg": "°", "mm2/s": "mm²/s", "m2": "m²", "m3": "m³", "": ""}

USUAL = {"rad/s": "rpm", "Pa": "MPa", "K": "degC", "m2/s": "mm2/s", "rad": "deg", "m3/s": "L/min", "Pa s": "mPa s"}
"""Units that are taken whatever the size of the number."""

SIZES = {"smallest": "minimum", "mean": "mean", "largest": "maximum"}
"""Clearances of a bearing whose kind computes one, where corners vary it, and what they are called elsewhere."""

MEMBERS = {"minimum clearance": "minimum", "mean clearance": "mean", "maximum clearance": "maximum"} | {
    state: state for state in ("smooth heel", "grooved heel")
}
"""What a bearing is followed by where it has several results, and what that is called."""

SMALL_RATIO = 0.05
"""Numbers without unit below which permille read better."""


@dataclass(frozen=True)
class Scale:
    """A column as it is shown.

    Attributes
    ----------
    name : str
        Heading.
    unit : str
        As written in tables.
    factor, offset : float
        Shown value = SI value times factor plus offset.
    quantity : str
        Of the vocabulary, whose digits are taken; empty for inputs.
    """

    name: str
    unit: str
    factor: float = 1.0
    offset: float = 0.0
    quantity: str = ""

    @property
    def heading(self) -> str:
        """Name and unit for an axis."""
        return translated("{quantity} in {unit}", quantity=self.name, unit=self.unit) if self.unit else self.name

    def shown(self, values: Any) -> Any:
        """Values in the unit, for numbers and arrays alike."""
        return values * self.factor + self.offset

    def text(self, value: Any) -> str:
        """One value as text; words as they are."""
        if isinstance(value, str):
            return translated(SIZES[value]) if value in SIZES and language() != ENGLISH else plain_text(value)
        if not math.isfinite(value):
            return DASH
        return QUANTITIES[self.quantity].format(value) if self.quantity else significant(self.shown(value))


@dataclass(frozen=True)
class StudyTable:
    """A table of text.

    Attributes
    ----------
    title : str
    columns : tuple of (str, str)
        Heading and unit.
    rows : tuple of tuple of str
    words : int
        Columns from the left that hold words; all others hold numbers.
    notes : tuple of str
        Below it.
    """

    title: str
    columns: tuple[tuple[str, str], ...]
    rows: tuple[tuple[str, ...], ...]
    words: int = 1
    notes: tuple[str, ...] = ()


def bearing_text(name: str) -> str:
    """The bearing of a row, its clearance or state in the language that is written now.

    Rows keep names as text alone, so that it is read out of it.

    >>> bearing_text("Fan shaft [full] (minimum clearance)"), bearing_text("Gear (hot)")
    ('Fan shaft [full] (minimum clearance)', 'Gear (hot)')
    """
    bearing, _, member = name.rpartition(" (")
    which = MEMBERS.get(member.removesuffix(")")) if bearing else None
    return plain_text(name) if which is None else f"{plain_text(bearing)} ({format_members([which])})"


def significant(value: float, digits: int = 4) -> str:
    """A number with some significant digits.

    >>> significant(1234.56), significant(0.0123456), significant(35.0)
    ('1235', '0.01235', '35')
    """
    if not math.isfinite(value):
        return DASH
    if value != 0.0 and not 1e-4 <= abs(value) < 1e7:
        return decimal(f"{value:.{digits - 1}e}")
    text = f"{value:.{digits}g}"
    return f"{value:.0f}" if "e" in text else decimal(text)


def margin_text(columns: Columns, place: int) -> str:
    """The margin of the governing check of a line, in K for temperatures."""
    kelvin = columns.get(kelvin_name(str(columns["governing_check"][place])))
    return distance(columns["margin"][place], math.nan if kelvin is None else kelvin[place], MARGIN_DECIMALS)


def percent(share: float, digits: int = 1) -> str:
    """A share in percent."""
    return decimal(f"{100.0 * share:.{digits}f} %") if math.isfinite(share) else DASH


def input_scale(one: Mapping[str, Any], values: NDArray[Any] | None = None) -> Scale:
    """How the column of an input is shown, by the size of its numbers."""
    name = plain_text(one["path"])
    if "values" in one:
        return Scale(name, "")
    largest = max((abs(end) for end in one["support"]), default=0.0)
    if values is not None and values.size:
        largest = float(np.max(np.abs(values)))
    unit = one["unit"]
    if not unit:
        return Scale(name, "‰", 1e3) if 0.0 < largest < SMALL_RATIO else Scale(name, "")
    kind = KINDS[unit]
    wanted = USUAL.get(unit) or next(
        (each for each, factor in kind.everyday.items() if 1.0 <= largest / factor < 1e4),
        next(iter(kind.everyday)),
    )
    wanted = written_in_system(wanted)
    factor = 1.0 / kind.everyday[wanted]
    sign = unit_sign(SHOWN.get(wanted, wanted))
    return Scale(name, sign, factor, -kind.offsets.get(wanted, 0.0) * factor)


def output_scale(name: str) -> Scale:
    """How the column of an output is shown; its name is its symbol."""
    if name not in QUANTITIES:
        return Scale(name, "")
    known = QUANTITIES[name]
    return Scale(known.symbol, known.display.label, known.display.scale, known.display.offset, name)


def kelvin_scale(name: str) -> Scale:
    """How the column of margins in K is shown."""
    unit = in_system(SI["K"])
    return Scale(name, unit.label, unit.scale)


def check_title(code: str) -> str:
    """A check with its title."""
    known = explanations().get(code)
    return f"{code} {known.title}" if known is not None else code


_COMPARED = re.compile(r"[A-Z]\d{3} .+ = .+ [<>] .+")
"""What tells of a limit that is missed, in symbols and numbers alone."""


_REFUSED = re.compile(
    r"(?P<field>\S+: (?:[a-z_]\w*(?:\.\w+|\[[^\]]*\])*: )?)(?P<why>.+?) \[(?P<code>E\d{3})\](?: |$)", re.DOTALL
)
"""One of several faults of a case: its file and field, what is wrong, its code."""


def refusal(why: str) -> str:
    """Why a field is refused, in the language that is written where it knows the sentence, else as given.

    >>> refusal("20.0 is too large; allowed: 1 mm to 3 m")
    '20.0 is too large; allowed: 1 mm to 3 m'
    """
    found = translated_if_known(why)
    return why if found == why else _in_signs(re.sub(r" to (?=[-+−\d])", f" {translated('to')} ", found))


def _refused(why: str) -> str:
    said = refusal(why)
    return translated("not accepted by the case") if said == why else said


def _in_signs(said: str) -> str:
    """Numbers and units with the signs of the language."""
    return decimal(re.sub(r"(?<=\d )rpm\b", unit_sign("rpm"), said))


def reason_text(message: str, code: str, status: str = "") -> str:
    """Why a row has no answer or misses a limit, in the units that are spoken.

    Rows keep it as a sentence in English. Other languages have it where they know its form; else a missed limit
    has its numbers, a refusal its fields and codes, anything else the title of its code or how the calculation
    ended.

    Parameters
    ----------
    message, code, status : str
        Of the row, as `babbitt.study.rows` has them; without a status where that is unknown.
    """
    said: str = in_us_units(message)
    if language() == ENGLISH or not message:
        return said
    if _COMPARED.fullmatch(message):
        return _in_signs(said).replace("(rounded)", translated("{value} (rounded)", value="").strip())
    if code in explanations() and (told := retold(code, said)) is not None:
        return told
    if refusals := list(_REFUSED.finditer(said)):
        return "; ".join(f"{one['field']}{_refused(one['why'])} [{one['code']}]" for one in refusals)
    if status.upper() in Outcome.__members__:
        return translated(Outcome[status.upper()].value)
    return (
        check_title(code) if code in explanations() and code[0] != "E" else translated("not accepted by the case")
    )
