"""Limits of thrust pads kept by less than their films can tell."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.uncertainty import UNCERTAIN_FILM, shear_heat, uncertain_temperature
from babbitt.kinds.thrust.design import Oil
from babbitt.kinds.thrust.temperature_limits import hottest_of_pads

__all__ = ["warnings_about_margins"]

SLOWER, HOTTER_AT_LEAST = 32.0, 23.0
"""K over m/s times the root of Pa s, and K up to which that holds: how much hotter the hottest oil of resolved
films may be, of slow pads. See `hotter_by_shear`."""

HOTTER, HOTTER_THAN_MEANS = 9.7, 2.8
"""K over m/s times the root of Pa s: by how much the hottest oil of resolved films may lie above the trailing edge
of pads of one temperature, and above the hottest of adiabatic means over the radius, over U sqrt(η).

That is the root of the heat of shear over conduction across the gap, η U²/λ. Assumptions by measurement of 150 and
148 random pads on point pivots (5 to 70 m/s, 0.6 to 4.5 MPa, ISO VG 22 to 460; docs/theory/thrust.md): none is
hotter by more. Adiabatic means of 416 others stay below 5.4 above the trailing edge."""

THINNER, MOST_THINNER = 1.0, 0.55
"""Margin of the film thickness by which resolved films may be thinner than those of one temperature, over
U sqrt(η) and at most: of none of the same pads by more. Of slower pads than those it is an assumption."""

THINNER_THAN_MEANS = 0.25
"""The same above adiabatic means over the radius, at most: of none of 148 by more."""

FILM_CHECK, HEAT_CHECKS = "C202", ("C104", "C108")
DRAINED = "outlet_temperature"
"""Oil that leaves has limits of its own: of adiabatic pads it is no hotter."""


def warnings_about_margins(oil: Oil, checks: Iterable[Check], values: Mapping[str, float]) -> Iterator[Notice]:
    """Which kept limits films with temperatures of their own, or real ones, may miss.

    Parameters
    ----------
    oil : Oil
        Of the pads.
    checks : iterable of Check
    values : Mapping of str to float
        Named results: temperatures in K, ``effective_viscosity`` in Pa s, ``surface_speed`` in m/s.
    """
    supplied = oil.supply_temperature
    if supplied is None:
        return
    hotter, thinner = _may_differ(oil, values)
    near, uncertain = [], uncertain_temperature(hottest(values) + hotter, supplied)
    for check in checks:
        if not check.ok or check.advisory:
            continue
        if check.code in HEAT_CHECKS and check.quantity != DRAINED:
            margin = check.limit - check.value
            if margin < hotter + uncertain:
                near.append(Notice("W215", "temperature", {"margin": margin, "check": check.code}))
        if check.code == FILM_CHECK and check.margin < thinner:
            near.append(Notice("W215", "film", {"margin": check.margin, "check": check.code}))
    if near and not oil.resolved:
        yield Notice("W215", "adiabatic" if oil.own_temperatures else "one_temperature", {
            "kept": tuple(near), "hotter": hotter, "uncertain": uncertain, "thinner": thinner,
        })  # fmt: skip
    elif near:
        yield Notice("W215", "resolved", {"kept": tuple(near), "uncertain": uncertain, "grid": UNCERTAIN_FILM})


def _may_differ(oil: Oil, values: Mapping[str, float]) -> tuple[float, float]:
    """K by which resolved films may be hotter than these, and the margin by which they may be thinner."""
    if oil.resolved:
        return 0.0, UNCERTAIN_FILM
    shear = shear_heat(values["surface_speed"], values["effective_viscosity"])
    if oil.own_temperatures:
        return hotter_by_shear(shear, HOTTER_THAN_MEANS), THINNER_THAN_MEANS
    return hotter_by_shear(shear, HOTTER), max(UNCERTAIN_FILM, min(THINNER * shear, MOST_THINNER))


def hotter_by_shear(shear: float, fast: float) -> float:
    """K by which resolved films may be hotter, over U sqrt(η) and the K that fast pads add to each of that.

    >>> hotter_by_shear(0.5, HOTTER), hotter_by_shear(1.0, HOTTER), hotter_by_shear(10.0, HOTTER)
    (16.0, 23.0, 97.0)
    """
    return max(min(SLOWER * shear, HOTTER_AT_LEAST), fast * shear)


def hottest(values: Mapping[str, float]) -> float:
    """The hottest oil known of pads whose heat balance is made, K."""
    name = hottest_of_pads(values)
    return math.inf if name is None else values[name]
