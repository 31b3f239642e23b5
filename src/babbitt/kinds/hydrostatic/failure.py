"""Why a hydrostatic bearing has no state to answer with, and how far the search came."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from babbitt.core.notices import Notice
from babbitt.design.heat_balance import CEILING
from babbitt.kinds.hydrostatic.answer import Answer, answer, answer_at
from babbitt.kinds.hydrostatic.heat_balance import temperature_rise
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.pumping import is_pumped
from babbitt.kinds.hydrostatic.state import SearchOutcome

__all__ = ["failure"]

THROTTLED, OPEN = 0.3, 0.8
"""Recess over supply pressure of the centred journal outside which restrictors are to be changed: as of W302."""

SENSIBLE = 100.0
"""Gap over that from which the search begins, beyond which no film is left."""


def failure(case: HydrostaticCase, found: Answer) -> Notice | None:
    """How far a search came that failed; None of one that found a state in which all recesses are full."""
    match found.ending:
        case SearchOutcome.SOLVED:
            lowest = float(found.network.pressures.min())
            recess = int(found.network.pressures.argmin()) + 1
            starved = lowest < case.cavitation_pressure
            return Notice("S302", "recess", {"recess": recess, "pressure": lowest}) if starved else None
        case SearchOutcome.OVERLOADED:
            return overloaded(case, found)
        case SearchOutcome.LIFTED_OFF:
            force = float(found.response.force[0])
            return Notice("S303", values={"load": case.duty.load or 0.0, "gap": found.rest_gap, "force": force})
        case SearchOutcome.UNSTABLE_NETWORK:
            return Notice("S301", values={"least_eigenvalue": found.network.least_eigenvalue})
        case SearchOutcome.THERMAL_RUNAWAY:
            return Notice("S002", "recesses", {"ceiling": CEILING, "rise": temperature_rise(case, found)})
        case _ if 0.0 < found.minimum_gap <= SENSIBLE * case.rest_gap:
            return Notice("S004", "last_gap", {
                "steps": found.steps, "gap": found.minimum_gap, "carried": found.carried,
            })  # fmt: skip
        case _:  # gaps beyond every film are no place
            return Notice("S004", "gap_closed" if found.minimum_gap <= 0.0 else "gap_lost")


def overloaded(case: HydrostaticCase, found: Answer) -> Notice:
    """Whether the load or its moment is too much, and how far it came."""
    load, share = case.duty.load or 0.0, found.carried
    level = replace(case, duty=replace(case.duty, moments=(0.0, 0.0)))
    if any(case.duty.moments) and answer(level).ending is SearchOutcome.SOLVED:
        moment = math.hypot(*case.duty.moments)
        came = Notice("S001", "of_both", {"share": share}) if share > 0.01 else ""
        return Notice("S001", "moment", {"load": load, "moment": moment, "offset": moment / load, "came": came})
    return Notice("S001", "recesses", {
        "load": load, "carried": share * load, "share": share, "restrictors": about_restrictors(case),
    })  # fmt: skip


def about_restrictors(case: HydrostaticCase) -> Notice | str:
    """Which way to change the restrictors of an overloaded bearing.

    Where a pad touches, its recess has the pressure of the supply whatever the restrictor. A journal is carried by
    the difference of its recesses, which open restrictors do not let arise, nor those that let hardly any oil in.
    """
    if not case.is_journal or is_pumped(case):
        return ""
    centred = answer_at(replace(case, accuracy="draft"), np.zeros(2), case.rest_gap)
    if centred.ending is not SearchOutcome.SOLVED:
        return ""
    ratio = float(centred.network.pressures.mean()) / centred.network.supply_pressure
    if THROTTLED <= ratio <= OPEN:
        return ""
    return Notice("S001", "narrow" if ratio > OPEN else "widen", {"ratio": ratio})
