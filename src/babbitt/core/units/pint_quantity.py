"""Numbers in SI as quantities of pint, in the registry that the whole application shares."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from babbitt.core.units.reading import _for_pint

__all__ = ["pint_quantity"]


def pint_quantity(value: Any, unit: str) -> Any:
    """Give a number or an array in SI its unit.

    Parameters
    ----------
    value : float or ndarray
    unit : str
        As `babbitt.core.quantities.Quantity.unit` writes it, such as ``N s/m``.

    Returns
    -------
    pint.Quantity
        In the application registry, so that it goes together with the quantities of other programs.

    Examples
    --------
    >>> pint_quantity(2.5, "N s/m").to("kN s/m").magnitude
    0.0025
    """
    registry = import_module("pint").get_application_registry()
    return registry.Quantity(value, "dimensionless" if unit == "1" else _for_pint(unit))
