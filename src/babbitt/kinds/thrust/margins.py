"""Limits of thrust pads kept by less than their films can tell."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.uncertainty import UNCERTAIN_FILM, uncertain_temperature
from babbitt.kinds.thrust.design import Oil
from babbitt.kinds.thrust.temperature_limits import hottest_of_pads

__all__ = ["warnings_about_margins"]

HOTTER = 5.2
"""K over m/s times the root of Pa s: by how much the hottest oil of adiabatic pads lies above the trailing edge of
pads of one temperature, over U sqrt(η).

Of 416 random pads (8 to 75 m/s, 0.8 to 4.5 MPa; docs/theory/thrust.md) it is less than 5.1 of nineteen of twenty
and at most 5.4. Its root is that of the heat of shear over conduction across the gap, η U²/λ. An assumption of
other pads."""

THINNER, MOST_THINNER = 0.02, 0.16
"""Margin of the film thickness by which adiabatic pads may be thinner, over U sqrt(η) and at most.

Nineteen of twenty of the same pads are thinner by less in each range of U sqrt(η), and slow ones thicker."""

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
    one_temperature = not oil.own_temperatures
    shear = shear_heat(values) if one_temperature else 0.0
    hotter, thinner = HOTTER * shear, max(UNCERTAIN_FILM, min(THINNER * shear, MOST_THINNER))
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
    if near and one_temperature:
        yield Notice("W215", "one_temperature", {
            "kept": tuple(near), "hotter": hotter, "uncertain": uncertain, "thinner": thinner,
        })  # fmt: skip
    elif near:
        yield Notice(
            "W215", "own_temperatures", {"kept": tuple(near), "uncertain": uncertain, "grid": UNCERTAIN_FILM}
        )


def hottest(values: Mapping[str, float]) -> float:
    """The hottest oil known of pads whose heat balance is made, K."""
    name = hottest_of_pads(values)
    return math.inf if name is None else values[name]


def shear_heat(values: Mapping[str, float]) -> float:
    """U sqrt(η) of pads of one temperature in m/s and the root of Pa s, for the heat of shear across the gap.

    >>> round(shear_heat({"surface_speed": 50.0, "effective_viscosity": 0.01}), 3)
    5.0
    """
    return values["surface_speed"] * math.sqrt(values["effective_viscosity"])
