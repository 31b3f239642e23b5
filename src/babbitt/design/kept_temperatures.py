"""Limits of temperature that films with temperatures of their own keep by less than they can tell."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from babbitt.core.result import Check
from babbitt.design.uncertainty import uncertain_temperature

__all__ = ["KeptByLittle", "kept_by_little"]


@dataclass(frozen=True)
class KeptByLittle:
    """A check that is kept by a margin in K, less than what its value may be too cold by."""

    check: str
    margin: float
    uncertain: float


def kept_by_little(checks: Iterable[Check], supply_temperature: float) -> tuple[KeptByLittle, ...]:
    """Limits of temperature that are kept by less than the hottest bore is known to.

    Parameters
    ----------
    checks : iterable of Check
        Of the hottest bore; advice is left out.
    supply_temperature : float
        K.

    Examples
    --------
    >>> from babbitt.core.result import Bound
    >>> hot = Check("C108", "maximum_bush_temperature", 380.0, 387.0, Bound.AT_MOST, "")
    >>> kept_by_little([hot], 360.0), kept_by_little([hot], 320.0)
    ((), (KeptByLittle(check='C108', margin=7.0, uncertain=12.0),))
    """
    near = []
    for check in checks:
        unknown = uncertain_temperature(check.value, supply_temperature)
        if check.ok and not check.advisory and check.limit - check.value < unknown:
            near.append(KeptByLittle(check.code, check.limit - check.value, unknown))
    return tuple(near)
