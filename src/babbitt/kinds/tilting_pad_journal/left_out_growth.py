"""What the growth of shaft and pads would take of the clearance, of bearings that are solved without it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.one_temperature import kept_stability
from babbitt.kinds.tilting_pad_journal.warnings import BORE_CHECKS
from babbitt.reynolds.tilting_pads.pad_heat import STEEL_EXPANSION

__all__ = ["CLOSES", "left_out_growth", "warnings_about_left_out_growth"]

CLOSES = 0.22
"""Share of the assembled clearance that growth takes at the temperatures of films without it, from which on it may
leave no film: narrower, the films warm further.

Assumption by measurement of 177 random bearings (three to six pads on all pivots, 20 to 600 mm, 3 to 95 m/s, 0.1
to 4 MPa, ISO VG 22 to 100, assembled clearances of 0.6 to 2.6 permille, housing as warm as the fresh oil): of
those that growth closes, with or without bending, it is 0.23 or more."""

THINNER_BY_GROWTH, HOTTER_BY_GROWTH, LESS_STABLE_BY_GROWTH = 1.5, 1.5, 3.0
"""Shares of the film thickness, of the rise of bores above the fresh oil, and of log decrement and threshold
cross-coupling that growth takes, or adds, over what it takes of the clearance (assumption by measurement: of the
same bearings less in nineteen of twenty from a share of 0.05 on; at most 1.7, 1.8 and, but for one, 2.9)."""

OF_FILM = (*FILM_CHECKS, "C111")
"""Limits of the film thickness, also by the speed at which it is reached."""


def warnings_about_left_out_growth(
    case: PadCase, checks: Sequence[Check], values: Mapping[str, float]
) -> Iterator[Notice]:
    """Whether growth, which is left out, may close the clearance or miss a limit that is kept without it.

    Parameters
    ----------
    case : PadCase
    checks : sequence of Check
    values : Mapping of str to float
        Named results.
    """
    if case.heat.growth is not None or case.oil_supply is None:
        return
    supply, housing = case.oil_supply.temperature, case.heat.housing_temperature
    share = left_out_growth(case, values, supply if housing is None else housing)
    if share > CLOSES:
        yield Notice("W422", "closes", {"share": share})
    elif near := (
        *kept_stability("W422", checks, 1.0 - LESS_STABLE_BY_GROWTH * share),
        *kept_films_and_bores(checks, share, supply),
    ):
        yield Notice("W422", "kept", {
            "share": share, "kept": near, "stable": LESS_STABLE_BY_GROWTH * share,
            "film": THINNER_BY_GROWTH * share, "hotter": HOTTER_BY_GROWTH * share,
        })  # fmt: skip


def kept_films_and_bores(checks: Iterable[Check], share: float, supply_temperature: float) -> Iterator[Notice]:
    """Limits that thinner films and hotter bores would miss, each with its margin.

    Parameters
    ----------
    checks : iterable of Check
    share : float
        Of the clearance that growth takes.
    supply_temperature : float
        K.

    Examples
    --------
    >>> from babbitt.core.result import Bound
    >>> film = Check("C101", "minimum_film_thickness", 1.15e-5, 1e-5, Bound.AT_LEAST, "")
    >>> bore = Check("C108", "maximum_temperature", 380.0, 387.0, Bound.AT_MOST, "")
    >>> [one.message for one in kept_films_and_bores([film, bore], 0.1, 320.0)]
    ['by 15.0 % (C101)', 'by 7.0 K (C108)']
    >>> list(kept_films_and_bores([film, bore], 0.05, 320.0))
    []
    """
    for one in checks:
        if not one.ok or one.advisory:
            continue
        if one.code in OF_FILM and (1.0 - THINNER_BY_GROWTH * share) * one.value < one.limit:
            yield Notice("W422", "stable", {"margin": one.margin, "check": one.code})
        hotter = HOTTER_BY_GROWTH * share * (one.value - supply_temperature)
        if one.code in BORE_CHECKS and one.value + hotter > one.limit:
            yield Notice("W422", "temperature", {"margin": one.limit - one.value, "check": one.code})


def left_out_growth(case: PadCase, values: Mapping[str, float], housing: float) -> float:
    """Share of the assembled clearance that a journal and pads of steel would take, in a housing of a temperature.

    alpha (T - T_housing) (R + t)/c of the pad that it narrows most; T is that of the journal, or of the films
    where the journal has none. Of what grows behind the pads the housing makes room for all.
    """
    journal = values.get("journal_temperature", math.nan)
    warmer = (values["effective_temperature"] if math.isnan(journal) else journal) - housing
    radius = 0.5 * case.bearing.diameter
    return max(
        STEEL_EXPANSION * warmer * (radius + pad.thickness) / pad.assembled_clearance for pad in case.bearing.pads
    )
