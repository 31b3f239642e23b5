"""The unit in which a number is shown: that of its size; entries of one matrix share that of the largest."""

from __future__ import annotations

from collections.abc import Mapping

from babbitt.core.quantities import AXES, QUANTITIES, Quantity

__all__ = ["suited_among"]


def suited_among(name: str, *values: Mapping[str, float]) -> Quantity:
    """A quantity in the unit suited to its numbers, and to those of the entries of its matrix.

    Parameters
    ----------
    name : str
    *values : mapping of str to float
        Named numbers in SI of every result that is shown in the unit.

    >>> numbers = {"stiffness_xx": 3e10, "stiffness_xy": -2e6, "stiffness_yx": 2e6, "stiffness_yy": 5e10}
    >>> quantity = suited_among("stiffness_xy", numbers)
    >>> quantity.format(-2e6), quantity.display.label
    ('-0.00200', 'GN/m')
    """
    matrix, _, axes = name.rpartition("_")
    names = [f"{matrix}_{one}" for one in AXES] if axes in AXES else [name]
    return QUANTITIES[name].suited(*(one[entry] for one in values for entry in names if entry in one))
