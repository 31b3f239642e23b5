"""Values of other libraries, numbers of numpy and quantities of pint, as those that the case language knows."""

from __future__ import annotations

from typing import Any

__all__ = ["as_python"]


def as_python(value: Any) -> Any:
    """Give a number or quantity of another library as a Python number or as text with its unit.

    Parameters
    ----------
    value : object
        A numpy scalar or array, a pint quantity of any registry, with a number or an array; anything else is given
        back as it is.

    Returns
    -------
    object
        Of an array a list, of lists where it has several dimensions.

    Examples
    --------
    >>> import numpy as np
    >>> as_python(np.float32(0.5)), as_python(np.int64(3)), as_python(np.array([1.0, 2.0])), as_python("5 mm")
    (0.5, 3, [1.0, 2.0], '5 mm')
    """
    if hasattr(value, "magnitude") and hasattr(value, "units") and hasattr(value, "to_root_units"):
        return _of_pint(value)
    if hasattr(value, "dtype") and hasattr(value, "tolist"):
        return value.tolist()
    return value


def _of_pint(quantity: Any) -> Any:
    """Text of a quantity: in its own unit where that means the same here, else in root units."""
    if not _is_known(quantity.units):
        quantity = quantity.to_root_units()
    unit = f"{quantity.units:~C}".replace("**", "").replace("*", " ")
    return _with_unit(as_python(quantity.magnitude), unit)


def _is_known(units: Any) -> bool:
    """Whether a unit of some registry has the same size in ours."""
    from babbitt.core.units.reading import pint_registry

    try:
        ours = pint_registry().Quantity(2.0, str(units)).to_root_units()
        theirs = units._REGISTRY.Quantity(2.0, units).to_root_units()
    except Exception:  # pint reports unknown units with many types of exception
        return False
    return bool(ours.magnitude == theirs.magnitude and str(ours.units) == str(theirs.units))


def _with_unit(number: Any, unit: str) -> Any:
    if isinstance(number, list):
        return [_with_unit(one, unit) for one in number]
    return f"{number!r} {unit}".rstrip() if unit else number
