"""Limits kept by less than films with temperatures of their own differ from that of one temperature."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping

from babbitt.core.notices import Notice
from babbitt.core.result import Check
from babbitt.design.bounds import FILM_CHECKS
from babbitt.design.conditions import Limits

__all__ = ["checks_of_metal", "warnings_about_margins"]

THINNER, HOTTER = 0.45, 15.0
"""Margin of the film thickness, and K above the outlet, by which films with temperatures of their own may differ.

Assumptions by measurement (docs/theory/procedure.md, ``benchmarks/one_temperature.py``): nineteen of twenty films
with temperatures of their own and walls that conduct differ by less, from ISO 7902 and from films of one
temperature alike."""

RISE_OF_METAL = 6.2e-3
"""K over the root of Pa m/s: rise of the hottest bush above the inlet over sqrt(p̄ U), fast and loaded bearings.

Assumption by the same measurement, at 15 to 60 m/s and 1.5 to 5 MPa: of nineteen of twenty it is less."""

TURBULENT_SOONER = 2.1
"""Reynolds number of films with temperatures of their own over that of one temperature.

Assumption by the same measurement, nineteen of twenty lie below: their oil is thinner where it carries no load."""

LIGHTER = 0.1
"""Margin of the critical mass by which films with temperatures of their own may differ.

Assumption by the same measurement: of nineteen of twenty their critical mass is more than 0.98 of that of the film
with one temperature."""


def warnings_about_margins(
    checks: tuple[Check, ...], values: Mapping[str, float], of_metal: Collection[str]
) -> Iterator[Notice]:
    """Whether a limit is kept by less than films with temperatures of their own usually differ.

    Parameters
    ----------
    checks : tuple of Check
    values : Mapping[str, float]
        Named results of the film with one temperature.
    of_metal : collection of str
        Codes of the checks that hold the metal to its limit; see `checks_of_metal`.
    """
    near = []
    hottest = hottest_metal(values)
    for check in checks:
        if check.advisory or not check.ok:
            continue
        if check.code in FILM_CHECKS and check.margin < THINNER:
            near.append(Notice("W191", "film", {"margin": check.margin, "check": check.code}))
        if check.code in of_metal and check.limit < max(check.value + HOTTER, hottest):
            margin = check.limit - check.value
            near.append(Notice("W191", "temperature", {"margin": margin, "check": check.code}))
        if check.code == "C110" and check.value * TURBULENT_SOONER > check.limit:
            factor = check.limit / check.value
            near.append(Notice("W191", "reynolds_number", {"factor": factor, "check": check.code}))
        if check.code == "C115" and check.margin < LIGHTER:
            near.append(Notice("W191", "critical_mass", {"margin": check.margin, "check": check.code}))
    if near:
        yield Notice("W191", "kept", {"kept": tuple(near)})


def checks_of_metal(limits: Limits) -> tuple[str, ...]:
    """Codes of the checks that hold the metal to its limit: that of the case is one of the metal, too."""
    return ("C108",) if limits.temperature is None else ("C104", "C108")


def hottest_metal(values: Mapping[str, float]) -> float:
    """Temperature in K that the bush of a fast and loaded bearing may reach, by `RISE_OF_METAL`; 0 without inlet.

    >>> hottest_metal({"supply_temperature": 313.15, "specific_load": 4e6, "surface_speed": 25.0})
    375.15
    """
    if "supply_temperature" not in values:
        return 0.0
    rise = RISE_OF_METAL * math.sqrt(values["specific_load"] * abs(values["surface_speed"]))
    return values["supply_temperature"] + rise
