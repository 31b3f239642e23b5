"""What a quantity means where a kind of bearing gives it a meaning of its own."""

from __future__ import annotations

from babbitt.core.kind import find_kind
from babbitt.core.quantities import QUANTITIES

__all__ = ["PUMPED", "meaning", "own_meaning"]

PUMPED = {
    "total_flow": "Oil through all restrictors",
    "effective_viscosity": "Dynamic viscosity of the oil in the film",
    "supply_pressure": "Gauge pressure before the restrictors",
    "iterations": "Steps of the search",
}
"""Of bearings that pumped oil carries: no film flow Q3 and supply flow Qp, no effective temperature."""


def own_meaning(name: str, kind: str) -> str:
    """What a quantity means in a kind alone; empty where it means the same in all."""
    known = find_kind(kind)
    return known.load_meanings().get(name, "") if known is not None else ""


def meaning(name: str, kind: str) -> str:
    """Give one line on a quantity of a result.

    Parameters
    ----------
    name : str
        Of the vocabulary.
    kind : str
        Of the result.

    Examples
    --------
    >>> meaning("total_flow", "hydrostatic_pad"), meaning("total_flow", "journal")
    ('Oil through all restrictors', 'Total oil flow Q3 + Qp')
    """
    return own_meaning(name, kind) or QUANTITIES[name].meaning
