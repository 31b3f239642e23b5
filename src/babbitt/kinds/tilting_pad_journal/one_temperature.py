"""Limits of tilting pads of one temperature that films with temperatures of their own may miss."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS
from babbitt.design.uncertainty import shear_heat, uncertain_temperature
from babbitt.kinds.tilting_pad_journal.level_one import STABILITY_CHECKS
from babbitt.kinds.tilting_pad_journal.model import PadCase

__all__ = ["HOTTER", "LESS_STABLE", "THINNER", "asks_own_temperatures", "warnings_about_one_temperature"]

HOTTER = 4.7e-3
"""K over the root of Pa m/s: by how much the hottest place of films with temperatures of their own lies above the
trailing edges of one temperature, over sqrt(p̄ U).

Assumption by measurement: of nineteen of twenty among 1014 random flooded bearings (10 to 70 m/s, 0.7 to 3 MPa;
docs/theory/tilting_pads.md) it is less, and at most 5.6e-3."""

HOTTER_BY_SHEAR = 7.5
"""K over m/s times the root of Pa s: the same over U sqrt(η_eff), the root of the heat of shear over conduction.

Assumption by measurement of 493 random bearings (10 to 85 m/s, 0.4 to 4 MPa, ISO VG 22 to 320, flooded, groove and
spray bar; docs/theory/tilting_pads.md): none is hotter than by this or by ``HOTTER``, 103 than by that alone."""

THINNER = 0.6
"""Margin of the film thickness by which these films may be thinner: of all of the same 493 by less."""

LESS_STABLE = 0.8
"""Log decrement and threshold cross-coupling of films with their own temperatures over those of one temperature.

Assumption by measurement of 167 random bearings (four or five pads on rockers, load on and between pads, 20 to
75 m/s, 0.3 to 2 MPa, ISO VG 22 to 68, assembled clearances of 0.6 to 1.8 permille, flexible shafts;
docs/theory/tilting_pads.md): of nineteen of twenty more than 0.82, median 0.92 and 0.94. With growth, too, they
are less than half of one in five."""


def warnings_about_one_temperature(
    case: PadCase, checks: Sequence[Check], values: Mapping[str, float]
) -> Iterator[Notice]:
    """Which kept limits of pads of one temperature films with temperatures of their own may miss.

    Asked where these are not solved themselves (`fuller_model`).

    Parameters
    ----------
    case : PadCase
    checks : sequence of Check
        Those of stability among them.
    values : Mapping of str to float
        Named results of films of one temperature.
    """
    if case.thermal.is_resolved or asks_own_temperatures(case, values):
        return
    near_stable = kept_stability("W416", checks, LESS_STABLE)
    if near_stable:
        yield Notice("W416", "stability", {"kept": near_stable, "left": LESS_STABLE})
    if case.oil_supply is None or "trailing_temperature" not in values:
        return
    of_metal = ("C108",) if case.limits.temperature is None else ("C104", "C108")
    speed = abs(values["surface_speed"])
    sheared = HOTTER_BY_SHEAR * shear_heat(speed, values["effective_viscosity"])
    hotter = max(HOTTER * math.sqrt(values["specific_load"] * speed), sheared)
    hottest = values["trailing_temperature"] + hotter
    uncertain, near = uncertain_temperature(hottest, case.oil_supply.temperature), []
    for check in checks:
        if not check.ok or check.advisory:
            continue
        margin = check.limit - check.value
        if check.code in of_metal and margin < hotter + uncertain:
            near.append(Notice("W416", "temperature", {"margin": margin, "check": check.code}))
        if check.code in FILM_CHECKS and check.margin < THINNER:
            near.append(Notice("W416", "film", {"margin": check.margin, "check": check.code}))
    if near:
        yield Notice("W416", "kept", {
            "kept": tuple(near), "hotter": hotter, "uncertain": uncertain, "thinner": THINNER,
        })  # fmt: skip


def asks_own_temperatures(case: PadCase, values: Mapping[str, float]) -> bool:
    """Whether the fuller films have temperatures of their own: of known fresh oil, laminar whatever their law."""
    laminar = case.turbulence is None or values.get("turbulent_share", 0.0) == 0.0
    return case.fuller is not None and case.oil_supply is not None and laminar


def kept_stability(code: str, checks: Iterable[Check], left: float) -> tuple[Notice, ...]:
    """Limits of stability that are kept and would not be by a share of the value, each with its margin.

    >>> from babbitt.core.result import Bound
    >>> near = Check("C406", "cross_coupling_ratio", 2.4, 2.0, Bound.AT_LEAST, "")
    >>> [one.message for one in kept_stability("W416", [near], 0.8)], kept_stability("W416", [near], 0.9)
    (['by 20.0 % (C406)'], ())
    """
    return tuple(
        Notice(code, "stable", {"margin": one.margin, "check": one.code})
        for one in checks
        if one.code in STABILITY_CHECKS and one.ok and left * one.value < one.limit
    )
