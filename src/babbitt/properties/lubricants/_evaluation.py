"""How a law is evaluated: one formula, fast on a float, element by element on an array.

Inside a temperature iteration a law is called thousands of times with a plain float, where `math` is some ten
times faster than numpy. Each law therefore writes its formula once for a module ``m`` that is either `math`
or `numpy`, and `evaluate` picks the module, guards the argument and refuses a result that is no number.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.numerics.scalar_or_array import functions_for

Value = TypeVar("Value", float, NDArray[np.float64])
"""A float or an array of floats; what goes in comes out."""

Point = tuple[float, float]
"""A known point of a law: temperature in K and the value there, in SI."""


def evaluate(formula: Callable[[Any, Any], Any], temperature: Value, *, above: float, law: str) -> Value:
    """Evaluate ``formula(m, temperature)`` with ``m`` the module that suits the argument.

    Parameters
    ----------
    formula : callable
        Function of the module (`math` or `numpy`) and the temperature.
    temperature : float or ndarray
        Absolute temperature in K.
    above : float
        Temperature in K that the argument must exceed for the formula to have a meaning.
    law : str
        Name of the law, for the message.

    Returns
    -------
    float or ndarray
        Of the shape of `temperature`.

    Raises
    ------
    InputError
        E006 when the temperature is not a finite number above the bound, or the formula overflows there.
    """
    result: Value
    if isinstance(temperature, (float, int)):
        if not above < temperature < math.inf:
            raise _outside(law, temperature, above)
        try:
            result = formula(math, temperature)
        except OverflowError:
            raise _outside(law, temperature, above) from None
        return result
    temperatures = np.asanyarray(temperature, dtype=np.float64)
    usable = (temperatures > above) & (temperatures < math.inf)
    if not usable.all():
        raise _outside(law, float(temperatures[~usable].flat[0]), above)
    with np.errstate(over="ignore", invalid="ignore"):
        result = formula(np, temperatures)
    finite = np.isfinite(result)
    if not finite.all():
        raise _outside(law, float(temperatures[~finite].flat[0]), above)
    return result


def _outside(law: str, temperature: float, above: float) -> InputError:
    return InputError(
        "E006",
        f"{law} has no value at {temperature:g} K; allowed are finite temperatures above {above:g} K at which "
        "the formula does not overflow. Temperatures are in kelvin: 50 °C is 323.15 K.",
    )


def require_positive(owner: str, **values: float) -> None:
    """Refuse values that are not finite and greater than zero.

    Raises
    ------
    InputError
        E003, naming the field.
    """
    for field, value in values.items():
        if not 0.0 < value < math.inf:
            raise InputError("E003", f"{owner}: {field} must be a finite number above 0, given {value!r}.")


def require_finite(owner: str, **values: float) -> None:
    """Refuse values that are infinite or not a number.

    Raises
    ------
    InputError
        E003, naming the field.
    """
    for field, value in values.items():
        if not functions_for(value).isfinite(value):
            raise InputError("E003", f"{owner}: {field} must be a finite number, given {value!r}.")


def require_range(owner: str, temperature_range: tuple[float, float]) -> None:
    """Refuse a temperature range that is not lower < upper, both at least 0 K.

    Raises
    ------
    InputError
        E003.
    """
    lower, upper = temperature_range
    if not 0.0 <= lower < upper:
        raise InputError(
            "E003",
            f"{owner}: temperature_range must be (lower, upper) in K with 0 <= lower < upper, "
            f"given ({lower!r}, {upper!r}).",
        )


def require_falling(owner: str, *points: Point) -> None:
    """Refuse points that are not all positive, or whose values do not fall while the temperature rises.

    The points must come in order of temperature.

    Raises
    ------
    InputError
        E003 for a number that is not positive and finite, E006 when the values do not fall.
    """
    for temperature, value in points:
        require_positive(owner, temperature=temperature, viscosity=value)
    for (colder, thick), (warmer, thin) in itertools.pairwise(points):
        if not (colder < warmer and thick > thin):
            raise InputError(
                "E006",
                f"{owner}: the points must differ in temperature and the viscosity must fall while the "
                f"temperature rises, given {thick:g} at {colder:g} K and {thin:g} at {warmer:g} K. "
                "Are two values exchanged?",
            )
