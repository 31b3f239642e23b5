"""What the growth of shaft and pads would take of the clearance, of bearings that are solved without it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.one_temperature import kept_stability
from babbitt.reynolds.tilting_pads.pad_heat import STEEL_EXPANSION

__all__ = ["CLOSES", "left_out_growth", "warnings_about_left_out_growth"]

CLOSES = 0.3
"""Share of the assembled clearance that growth takes at the temperatures of films without it, from which on it may
leave no film: narrower, the films warm further.

Assumption by measurement of 63 random bearings (of those of `one_temperature.LESS_STABLE`; assembled clearances of
0.6 to 1.7 permille, housing 5 K warmer than the fresh oil): of the 14 that growth closes it is 0.35 to 0.79 in
films with temperatures of their own, of the other 49 at most 0.42, and from 1.2 permille on at most 0.27."""

LESS_STABLE_BY_GROWTH = 2.0
"""Share of log decrement and threshold cross-coupling that growth takes, over what it takes of the clearance: less
in 47 of the same 49 bearings with a film, at most 2.2 (assumption by measurement)."""


def warnings_about_left_out_growth(
    case: PadCase, checks: Sequence[Check], values: Mapping[str, float]
) -> Iterator[Notice]:
    """Whether growth, which is left out, may close the clearance or end a stability that is kept.

    Parameters
    ----------
    case : PadCase
    checks : sequence of Check
        Those of stability among them.
    values : Mapping of str to float
        Named results.
    """
    if case.heat.growth is not None or case.oil_supply is None:
        return
    housing = case.heat.housing_temperature
    share = left_out_growth(case, values, case.oil_supply.temperature if housing is None else housing)
    if share > CLOSES:
        yield Notice("W422", "closes", {"share": share})
    elif near := kept_stability("W422", checks, 1.0 - LESS_STABLE_BY_GROWTH * share):
        yield Notice("W422", "stability", {"share": share, "kept": near})


def left_out_growth(case: PadCase, values: Mapping[str, float], housing: float) -> float:
    """Share of the assembled clearance that a journal and pads of steel would take, in a housing of a temperature.

    alpha (T - T_housing) (R + t)/c of the pad that it narrows most; T is that of the journal, or of the films
    where the journal has none. Of what grows behind the pads the housing makes room for all.
    """
    warmer = values.get("journal_temperature", values["effective_temperature"]) - housing
    radius = 0.5 * case.bearing.diameter
    return max(
        STEEL_EXPANSION * warmer * (radius + pad.thickness) / pad.assembled_clearance for pad in case.bearing.pads
    )
