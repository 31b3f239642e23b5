"""Limits that films with temperatures of their own keep by less than they can tell."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS
from babbitt.design.uncertainty import UNCERTAIN_FILM, uncertain_temperature

__all__ = ["KeptByLittle", "about_kept_film", "kept_by_little"]


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


def about_kept_film(code: str, checks: Iterable[Check]) -> Iterator[Notice]:
    """Warn by a code of limits of the film thickness that are kept by less than the grid may miss.

    A limit of zero any film keeps.

    >>> from babbitt.core.result import Bound
    >>> thin, thick = (Check("C101", "h_min", h, 1e-5, Bound.AT_LEAST, "") for h in (1.01e-5, 2e-5))
    >>> [notice.values["kept"][0].values["check"] for notice in about_kept_film("W172", (thick, thin))]
    ['C101']
    """
    kept = tuple(
        Notice(code, "film", {"margin": one.margin, "check": one.code})
        for one in checks
        if one.code in FILM_CHECKS and one.ok and not one.advisory
        if one.limit > 0.0 and one.margin < UNCERTAIN_FILM
    )
    if kept:
        yield Notice(code, "film_kept", {"kept": kept, "uncertain": UNCERTAIN_FILM})
