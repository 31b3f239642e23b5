"""What growth of shaft and pads and bending of pads would take, of bearings that are solved without them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.one_temperature import LESS_STABLE, kept_stability
from babbitt.kinds.tilting_pad_journal.warnings import is_of_bore
from babbitt.reynolds.tilting_pads.pad_heat import STEEL_EXPANSION

__all__ = ["CLOSES", "left_out_growth", "warnings_about_left_out_deformation"]

CLOSES = 0.22
"""Share of the assembled clearance that growth takes at the temperatures of films without it, from which on it may
leave no film: narrower, the films warm further.

Assumption by measurement of 177 random bearings (three to six pads on all pivots, 20 to 600 mm, 3 to 95 m/s, 0.1
to 4 MPa, ISO VG 22 to 100, assembled clearances of 0.6 to 2.6 permille, housing as warm as the fresh oil): of
those that growth closes, with or without bending, it is 0.23 or more."""

THINNER_BY_GROWTH, HOTTER_BY_GROWTH, LESS_STABLE_BY_GROWTH = 1.5, 1.5, 3.0
"""Shares of the film thickness, of the rise of bores above the fresh oil, and of log decrement and threshold
cross-coupling that growth takes, or adds, over what it takes of the clearance (assumption by measurement: of the
same bearings less in nineteen of twenty from a share of 0.05 on; more, up to 8, of log decrements above 1)."""

THINNER_BY_BENDING, LESS_STABLE_BY_BENDING = 0.06, 0.18
"""Shares of the film thickness, and of log decrement and threshold cross-coupling, that bending takes: of the same
bearings less in nineteen of twenty, half of them 0 and 0.03 (assumption by measurement; most of thin pads)."""

OF_FILM = (*FILM_CHECKS, "C111")
"""Limits of the film thickness, that of transition among them."""


@dataclass(frozen=True)
class _LeftOut:
    """Shares that may be less: of stability and film; and by which bores may be hotter above the fresh oil."""

    stable: float
    film: float
    hotter: float


def warnings_about_left_out_deformation(
    case: PadCase, checks: Sequence[Check], values: Mapping[str, float]
) -> Iterator[Notice]:
    """Whether growth or bending that is left out may close the clearance or miss a limit that is kept without.

    Of pads of one temperature also with what temperatures of their own take of the stability: limits must hold
    with all of it.

    Parameters
    ----------
    case : PadCase
    checks : sequence of Check
    values : Mapping of str to float
        Named results.
    """
    supply, share = math.nan if case.oil_supply is None else case.oil_supply.temperature, 0.0
    if case.heat.growth is None and case.oil_supply is not None:
        housing = case.heat.housing_temperature
        share = max(left_out_growth(case, values, supply if housing is None else housing), 0.0)
    if share > CLOSES:
        yield Notice("W422", "closes", {"share": share})
        return
    stiff = case.heat.bending is None
    stable = (1.0 - LESS_STABLE_BY_GROWTH * share) * (1.0 - LESS_STABLE_BY_BENDING * stiff)
    left = _LeftOut(
        stable=1.0 - stable * (1.0 if case.thermal.is_resolved else LESS_STABLE),
        film=1.0 - (1.0 - THINNER_BY_GROWTH * share) * (1.0 - THINNER_BY_BENDING * stiff),
        hotter=HOTTER_BY_GROWTH * share,
    )
    if (share > 0.0 or stiff) and (near := tuple(_kept_by_little(checks, left, supply))):
        yield Notice("W422", "kept", {
            "share": share, "kept": near, "stable": left.stable, "film": left.film, "hotter": left.hotter,
        })  # fmt: skip


def _kept_by_little(checks: Iterable[Check], left: _LeftOut, supply_temperature: float) -> Iterator[Notice]:
    """Limits that less stability, thinner films and hotter bores would miss, each with its margin.

    Of bores none where the temperature of the supply is not known (nan).

    >>> from babbitt.core.result import Bound
    >>> film = Check("C101", "minimum_film_thickness", 1.15e-5, 1e-5, Bound.AT_LEAST, "")
    >>> bore = Check("C108", "maximum_temperature", 380.0, 387.0, Bound.AT_MOST, "")
    >>> [one.message for one in _kept_by_little([film, bore], _LeftOut(0.3, 0.15, 0.15), 320.0)]
    ['by 15.0 % (C101)', 'by 7.0 K (C108)']
    >>> list(_kept_by_little([film, bore], _LeftOut(0.2, 0.1, 0.1), 320.0))
    []
    """
    yield from kept_stability("W422", checks, 1.0 - left.stable)
    for one in checks:
        if not one.ok or one.advisory:
            continue
        if one.code in OF_FILM and (1.0 - left.film) * one.value < one.limit:
            yield Notice("W422", "stable", {"margin": one.margin, "check": one.code})
        if is_of_bore(one) and one.value + left.hotter * (one.value - supply_temperature) > one.limit:
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
