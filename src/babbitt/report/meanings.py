"""What a quantity means where a kind of bearing gives it a meaning of its own."""

from __future__ import annotations

from babbitt.core.kind import find_kind
from babbitt.core.language import translated
from babbitt.core.quantities import QUANTITIES

__all__ = ["PUMPED", "meaning", "own_meaning", "remark_on_zero"]

PUMPED = {
    "total_flow": "Oil through all restrictors",
    "effective_viscosity": "Dynamic viscosity of the oil in the film",
    "supply_pressure": "Gauge pressure before the restrictors",
    "iterations": "Steps of the search",
}
"""Of bearings that pumped oil carries: no film flow Q3 and supply flow Qp, no effective temperature."""

OF_ZERO = {
    "critical_mass": "no rotor is stable",
    "critical_mass_elastic": "no rotor on this shaft is stable",
}
"""What a value of zero says that the quantity's meaning does not."""


def remark_on_zero(name: str, value: float) -> str:
    """What follows the meaning of a quantity that is zero; empty for others.

    >>> remark_on_zero("critical_mass", 0.0), remark_on_zero("critical_mass", 12.0)
    ('; 0: no rotor is stable', '')
    """
    return f"; 0: {translated(OF_ZERO[name])}" if value == 0.0 and name in OF_ZERO else ""


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
