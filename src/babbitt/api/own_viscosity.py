"""A viscosity law of one's own as a function of temperature, sampled to a table of the case language."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from babbitt.api.common_parts import TableLubricant
from babbitt.api.given import as_given
from babbitt.api.own_function import failure, named
from babbitt.case.problems import CaseError, Problem
from babbitt.core.units import QuantityError, si

__all__ = ["viscosity_law"]

LONGEST_STEP = 2.0
"""K between two points: an oil by Walther's law is met within 0.05 % above 0 degC."""


def viscosity_law(
    viscosity: Callable[[float], float],
    *,
    coldest: Any,
    warmest: Any,
    describe: str,
    **known: Any,
) -> TableLubricant:
    """A lubricant by a viscosity law of one's own, sampled at once.

    Parameters
    ----------
    viscosity : callable
        Dynamic viscosity in Pa s of a temperature in K, falling. It is called with one number at a time.
    coldest, warmest : float or str
        Where the law holds, K or text with a unit; it is sampled from one to the other, 2 K apart or less, with
        Andrade's law between. A result outside carries W107.
    describe : str
        Name of the lubricant in reports.
    **known
        What else is known of it: fields of `babbitt.TableLubricant`, such as ``density="870 kg/m3"``.

    Raises
    ------
    CaseError
        For a function that fails, is not positive and finite or does not fall, and for temperatures that do not
        rise.

    Examples
    --------
    >>> oil = viscosity_law(
    ...     lambda kelvin: 6e-5 * math.exp(1000.0 / (kelvin - 175.0)), coldest="0 degC", warmest="120 degC",
    ...     describe="Vogel oil", density="870 kg/m3",
    ... )
    >>> len(oil.points), f"{oil.lubricant().viscosity('60 degC') * 1e3:.2f} mPa s"
    (61, '33.44 mPa s')
    """
    first, last = _temperature("coldest", coldest), _temperature("warmest", warmest)
    if not last > first:
        raise _refused("warmest", f"{warmest} is not above {coldest}", "a temperature above the coldest")
    steps = max(2, math.ceil((last - first) / LONGEST_STEP - 1e-9))
    temperatures = [first + (last - first) * number / steps for number in range(steps)] + [last]
    points = [
        {"temperature": kelvin, "dynamic_viscosity": _sampled(viscosity, kelvin, describe)}
        for kelvin in temperatures
    ]
    return TableLubricant(**{"source": "a function of temperature", **known, "name": describe, "points": points})


def _sampled(viscosity: Callable[[float], float], kelvin: float, describe: str) -> float:
    allowed = "one positive number, the viscosity in Pa s, for every temperature in K"
    try:
        given = viscosity(kelvin)
    except Exception as error:
        raise _refused("viscosity", failure(viscosity, describe, f"{kelvin:g} K", error), allowed) from None
    try:
        found = float(given)
    except (TypeError, ValueError):
        says = f"{named(viscosity, describe)} gives a {type(given).__name__} at {kelvin:g} K"
        raise _refused("viscosity", says, allowed) from None
    if not (math.isfinite(found) and found > 0.0):
        raise _refused("viscosity", f"{named(viscosity, describe)} gives {found:g} at {kelvin:g} K", allowed)
    return found


def _temperature(name: str, given: Any) -> float:
    try:
        return si("K")(as_given(given, "viscosity_law", (name,)))
    except QuantityError as error:
        raise _refused(name, error.says, error.allowed) from None


def _refused(field: str, says: str, allowed: str) -> CaseError:
    return CaseError([Problem("viscosity_law", 0, field, says, allowed=allowed)])
