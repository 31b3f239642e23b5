"""A check in words: its value beside its limit, in one unit, and the distance between them."""

from __future__ import annotations

import math

from babbitt.core.language import decimal, translated
from babbitt.core.quantities import QUANTITIES
from babbitt.core.quantities.display import SI, in_system
from babbitt.core.result import Bound, Check

__all__ = ["alike", "comparison", "distance", "margin", "number", "value_and_limit", "written"]

LARGEST_MARGIN = 5.0
"""Relative distance to a limit beyond which its size tells nothing more."""


def written(quantity: str, value: float) -> str:
    """A value in the engineer's unit, with the unit.

    >>> written("minimum_film_thickness", 52.34e-6)
    '52.3 µm'
    """
    return alike(quantity, value)[0]


def alike(quantity: str, *values: float) -> tuple[str, ...]:
    """Values of a quantity in one unit, with the unit.

    >>> alike("friction_power", 21.3, 4500.0), alike("friction_power", 21.3)
    (('0.0213 kW', '4.50 kW'), ('21.3 W',))
    """
    known = QUANTITIES.get(quantity)
    if known is None:
        return tuple(number(quantity, value) for value in values)
    shown = known.suited(*values)
    return tuple(map(shown.with_unit, values))


def number(quantity: str, value: float) -> str:
    """A value in the engineer's unit, without the unit.

    >>> number("minimum_film_thickness", 52.34e-6), number("side_flow", math.nan)
    ('52.3', '–')
    """
    known = QUANTITIES.get(quantity)
    if not math.isfinite(value):
        return "–"
    return known.format(value) if known else decimal(f"{value:.4g}")


def comparison(check: Check) -> str:
    """A value beside its limit: ``P̄ = 1.30 MPa > 1.20 MPa``."""
    known = QUANTITIES.get(check.quantity)
    symbol = known.symbol if known else check.quantity
    kept = {Bound.AT_MOST: "≤", Bound.AT_LEAST: "≥"}
    missed = {Bound.AT_MOST: ">", Bound.AT_LEAST: "<"}
    sign = (kept if check.ok else missed)[check.bound]
    value, limit = value_and_limit(check)
    return f"{symbol} = {value} {sign} {limit}"


def value_and_limit(check: Check) -> tuple[str, str]:
    """Both in one unit; of a limit that is barely missed as many digits of both as tell so."""
    known = QUANTITIES.get(check.quantity)
    if known is None or check.ok:
        value, limit = alike(check.quantity, check.value, check.limit)
        return value, limit
    value, limit = known.told_apart(check.value, check.limit)
    return translated("{value} (rounded)", value=value) if value == limit else value, limit


def margin(check: Check) -> str:
    """The distance to the limit, as `distance` writes it; from a limit of zero in the unit of the value.

    >>> margin(Check("C203", "unload_margin_bound", 0.269, 0.0, Bound.AT_LEAST, "a film cannot pull"))
    '+26.9 points'
    """
    if check.limit == 0.0 and not check.is_in_kelvin and math.isfinite(check.gap):
        sign = "−" if check.gap < 0.0 else "+"
        said = written(check.quantity, abs(check.gap))
        return sign + (translated("{number} points", number=said[:-1].strip()) if said.endswith("%") else said)
    return distance(check.margin, check.gap if check.is_in_kelvin else math.nan)


def distance(share: float, kelvin: float = math.nan, decimals: int = 0) -> str:
    """A distance to a limit: in K for a temperature, otherwise relative; positive when it is kept.

    Relative distances above `LARGEST_MARGIN` say no more than that.

    >>> distance(0.12, 9.64), distance(-0.031), distance(0.0123, decimals=1), distance(7.0)
    ('+9.6 K', '-3%', '+1.2%', 'over +500%')
    """
    if not math.isfinite(share):
        return "–"
    if math.isfinite(kelvin):
        unit = in_system(SI["K"])
        return decimal(f"{kelvin * unit.scale:+.1f} {unit.label}")
    if share <= LARGEST_MARGIN:
        return decimal(f"{share:+.{decimals}%}")
    return translated("over {margin}", margin=decimal(f"{LARGEST_MARGIN:+.0%}"))
