"""Column names that carry their unit, made from the vocabulary of quantities."""

from __future__ import annotations

from functools import cache

from babbitt.core.quantities import QUANTITIES


def static_column(name: str) -> str:
    """The column of a quantity: its name and its SI unit.

    >>> static_column("load"), static_column("eccentricity_ratio"), static_column("side_flow")
    ('load_N', 'eccentricity_ratio', 'side_flow_m3_per_s')
    """
    unit = QUANTITIES[name].unit
    if unit in ("", "1"):
        return name
    spelled = unit.replace("(", "").replace(")", "").replace("/", "_per_").replace(" ", "_")
    return f"{name}_{spelled}"


@cache
def _columns() -> dict[str, str]:
    return {static_column(name): name for name in QUANTITIES}


def static_quantity(column: str) -> str | None:
    """The quantity of a column, or None where the column is something else.

    >>> static_quantity("load_N"), static_quantity("load_kN")
    ('load', None)
    """
    return _columns().get(column)
