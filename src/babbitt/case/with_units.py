"""The numbers of a program, written with the units that a case file asks for."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from babbitt.case.field_types import expanded, quantity_in
from babbitt.case.part import Part
from babbitt.case.scalars import scalar
from babbitt.core.units import Kind, read

__all__ = ["FEW_DIGITS", "case_text", "quantity_text", "short_quantity", "with_units"]

FEW_DIGITS = 6
"""Significant digits of a quantity that is read by people."""


def with_units(given: Mapping[str, Any], part: Part) -> dict[str, Any]:
    """Write the numbers of what a part was given with their units.

    Parameters
    ----------
    given : Mapping
        As a program gave it.
    part : Part
        What was read from it, at least its usable fields.
    """
    values = vars(part)
    return {name: _field(type(part), name, one, values.get(name)) for name, one in given.items()}


def quantity_text(value: float, kind: Kind) -> str | float:
    """Write an SI value so that it is read back to the last bit.

    The first everyday unit that does so is taken, else the SI unit, which always does.

    >>> from babbitt.core.units import KINDS
    >>> quantity_text(0.12, KINDS["m"]), quantity_text(323.15, KINDS["K"]), quantity_text(0.1 + 0.2, KINDS["N"])
    ('120 mm', '50 degC', '0.30000000000000004 N')
    """
    if kind.one_unit or not math.isfinite(value):  # what is not finite is refused where it is read
        return value
    for unit in kind.everyday:
        short = f"{kind.from_si(value, unit):.12g} {unit}"
        if read(short, kind.key) == value:
            return short
    return f"{value!r} {kind.unit}"


def short_quantity(value: float, kind: Kind, digits: int = FEW_DIGITS, written: Callable[[str], str] = str) -> str:
    """Write an SI value to read, in the first everyday unit that suits it, or what is `written` for that one.

    >>> from babbitt.core.units import KINDS
    >>> short_quantity(0.5e-3 / 60.0, KINDS["m3/s"]), short_quantity(4e-6, KINDS["m"])
    ('0.5 L/min', '4 um')
    """
    if not kind.everyday:
        return f"{value:.{digits}g} {'' if kind.unit == '1' else kind.unit}".rstrip()
    numbers = {unit: kind.from_si(value, unit) for unit in kind.everyday}
    fitting = (unit for unit, number in numbers.items() if number == 0.0 or 0.1 <= abs(number) < 1e5)
    unit = written(next(fitting, next(iter(numbers))))
    return f"{kind.from_si(value, unit):.{digits}g} {'' if unit == '1' else unit}".rstrip()


def case_text(given: Mapping[str, Any]) -> str:
    """Write a case as the text of a file: a field a line, lists of numbers and small mappings on one line.

    >>> print(case_text({"kind": "journal", "load": "10 kN", "supply": {"temperature": "50 degC"}}), end="")
    kind: journal
    load: 10 kN
    supply: {temperature: 50 degC}
    """
    import yaml

    dumper = _dumper()

    def field(name: str, value: Any) -> str:
        inside = None if isinstance(value, dict | list) else False
        return str(
            yaml.dump(
                {name: value},
                Dumper=dumper,
                sort_keys=False,
                allow_unicode=True,
                width=110,
                default_flow_style=inside,
            )
        )

    return "".join(field(name, value) for name, value in given.items())


@cache
def _dumper() -> Any:
    """Writes a word in quotation marks where this language reads another value than YAML 1.1 does, such as 1e5."""
    import yaml

    class Dumper(getattr(yaml, "CSafeDumper", yaml.SafeDumper)):  # type: ignore[misc]
        pass

    def word(dumper: Any, text: str) -> Any:
        return dumper.represent_scalar("tag:yaml.org,2002:str", text, None if scalar(text) == text else "'")

    Dumper.add_representer(str, word)
    return Dumper


def _field(cls: type[Part], name: str, given: Any, value: Any) -> Any:
    if name not in cls.model_fields:
        return given
    annotation = cls.model_fields[name].rebuild_annotation()
    quantity = quantity_in(annotation)
    if isinstance(given, int | float) and not isinstance(given, bool) and quantity is None:
        given = expanded(annotation, given)
    return _value(given, value, None if quantity is None else quantity.kind)


def _value(given: Any, value: Any, kind: Kind | None) -> Any:
    match given:
        case Mapping() if isinstance(value, Part):
            return with_units(given, value)
        case list():
            values = value if isinstance(value, tuple) and len(value) == len(given) else [None] * len(given)
            return [_value(one, read_as, kind) for one, read_as in zip(given, values, strict=True)]
        case int() | float() if kind is not None and not isinstance(given, bool):
            return quantity_text(float(given), kind)
    return given
