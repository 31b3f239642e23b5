"""Values of one field as the command line takes them: a list, or first, last and number, each with its unit."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace

from babbitt.core.notices import InputError
from babbitt.core.units import QuantityError, bare_number, read
from babbitt.core.units.kinds import kind_of

MOST_VALUES = 500
"""Values of one sweep."""

ALLOWED = "such as '1 kN, 2 kN, 5 kN', first:last:number such as '1 kN:10 kN:10', or '1 kN:100 kN:7:log'"

LOGARITHMIC = "log"
"""Behind the number of values: they stand at equal ratios."""

SHOWN = {"um": "µm", "degC": "°C", "degF": "°F", "deg": "°"}
"""Units of case files that tables and plots write otherwise."""

_NUMBER = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,3})?)\s*(.*)", re.DOTALL)


@dataclass(frozen=True)
class SweepValues:
    """Values in the order given.

    Attributes
    ----------
    texts : tuple of str
        As they would stand in the case file.
    numbers : tuple of float, or None
        In `unit`; None where some value is a word.
    unit : str
        Of the numbers; empty for numbers without unit.
    logarithmic : bool
        Whether they stand at equal ratios.
    """

    texts: tuple[str, ...]
    numbers: tuple[float, ...] | None
    unit: str
    logarithmic: bool = False

    @property
    def unit_shown(self) -> str:
        """The unit as tables and plots write it.

        >>> values_of("80 um:120 um:3").unit_shown, values_of("1 kN, 2 kN").unit_shown
        ('µm', 'kN')
        """
        return SHOWN.get(self.unit, self.unit)

    def number_of(self, given: object) -> float | None:
        """What stands in a case file, as a number in the unit of these; None where it is none."""
        return None if self.numbers is None else _in_unit(str(given).strip(), self.unit)


def values_of(text: str) -> SweepValues:
    """Read the values of a sweep.

    Parameters
    ----------
    text : str
        Values between commas, or the first, the last and the number of equally spaced ones between colons, at
        equal ratios with ``:log`` behind them. All are given in the unit of the first.

    Raises
    ------
    InputError
        E003 for anything else, and for more than `MOST_VALUES`.

    Examples
    --------
    >>> values_of("1 kN:2 kN:3").texts, values_of("500 N, 1 kN").numbers, values_of("draft, reference").numbers
    (('1 kN', '1.5 kN', '2 kN'), (500.0, 1000.0), None)
    >>> values_of("1 kN:100 kN:3:log").texts
    ('1 kN', '10 kN', '100 kN')
    """
    if text.count(":") == 2:
        return _spaced(text)
    if text.count(":") == 3 and text.rpartition(":")[2].strip() == LOGARITHMIC:
        return replace(_spaced(text.rpartition(":")[0], _at_equal_ratios), logarithmic=True)
    texts = tuple(part.strip() for part in text.split(","))
    if not all(texts):
        raise _refused(text, "a value is empty")
    if len(texts) > MOST_VALUES:
        raise _refused(text, f"{len(texts)} values; at most {MOST_VALUES} make a sweep")
    unit = _unit_of(texts[0])
    numbers = tuple(_in_unit(one, unit) for one in texts) if unit is not None else ()
    known = tuple(number for number in numbers if number is not None)
    return SweepValues(texts, known, unit or "") if len(known) == len(texts) else SweepValues(texts, None, "")


def _at_equal_distances(first: float, last: float, share: float) -> float:
    return first + (last - first) * share


def _at_equal_ratios(first: float, last: float, share: float) -> float:
    if not first * last > 0.0:
        raise _refused(f"{first:g}:{last:g}", "equal ratios need two ends of one sign, neither of them zero")
    return first * float((last / first) ** share)


def _spaced(text: str, between: Callable[[float, float, float], float] = _at_equal_distances) -> SweepValues:
    first_text, last_text, count = (part.strip() for part in text.split(":"))
    if not count.isdecimal() or not 2 <= int(count) <= MOST_VALUES:
        raise _refused(text, f"the last part is the number of values, 2 to {MOST_VALUES}")
    unit = _unit_of(first_text)
    if unit is None:
        raise _refused(text, f"'{first_text}' is no number with a unit")
    if _lacks_unit(last_text, unit):
        raise _refused(text, f"'{last_text}' has no unit; write '{last_text} {unit}'")
    first, last = _in_unit(first_text, unit), _in_unit(last_text, unit)
    if first is None or last is None:
        raise _refused(text, f"'{last_text}' is no quantity of the kind of '{first_text}'")
    steps = int(count) - 1
    numbers = tuple(between(first, last, place / steps) for place in range(steps + 1))
    return SweepValues(tuple(f"{number:.12g} {unit}".strip() for number in numbers), numbers, unit)


def _unit_of(text: str) -> str | None:
    """Unit of a quantity, empty where it has none; None for a word."""
    found = _NUMBER.fullmatch(text)
    if found is None or (found[2] and kind_of(found[2].strip()) is None):
        return None
    return found[2].strip()


def _in_unit(text: str, unit: str) -> float | None:
    """The number of a text in a unit, None where it is of another kind or none at all."""
    found = _NUMBER.fullmatch(text)
    if found is None:
        return None
    if found[2].strip() == unit:
        return float(found[1])
    kind = kind_of(unit)
    if kind is None or _lacks_unit(text, unit):
        return None
    try:
        return kind.from_si(read(text, kind.key), unit)
    except QuantityError:
        return None


def _lacks_unit(text: str, unit: str) -> bool:
    """Whether a text is a number without unit where a file refuses one: beside units that people vary."""
    bare, kind = bare_number(text), kind_of(unit)
    free = kind is None or kind.one_unit or (bare == 0.0 and not kind.offsets)
    return bare is not None and not free


def _refused(text: str, says: str) -> InputError:
    return InputError("E003", f"VALUES '{text}': {says}; allowed: {ALLOWED}")
