"""What the whirl of a rotor adds to the answer of a bearing: numbers, verdicts, warnings."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Protocol

import numpy as np

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.reynolds.stability.whirl_limits import Threshold, Whirl

__all__ = [
    "CarriesRotor",
    "missing_thresholds",
    "warnings_about_whirl",
    "whirl_checks",
    "whirl_values",
    "without_critical_mass",
]


STABLE = "the rotor is stable at this speed; no threshold was found up to ten times it"
WHIRLING = "the rotor whirls at this speed; no threshold was found down to a tenth of it"
JUMPS = "the rotor's stability changes in a jump, at a speed that films in a bore that gives way leave open"
LOST = "no film was found at a speed on the way to the threshold, which therefore stays open"
"""Why there is no threshold speed."""


class CarriesRotor(Protocol):
    """A bearing that may know its part of the mass of the rotor, kg, and the stiffness of the shaft, N/m."""

    @property
    def rotor_mass(self) -> float | None:
        """Kg; None where it is not known."""

    @property
    def shaft_stiffness(self) -> float | None:
        """N/m; None for a rigid shaft."""


def whirl_values(case: CarriesRotor, whirl: Whirl) -> dict[str, float]:
    """Stable masses, whirl frequency and threshold speed, for a rigid rotor and on its elastic shaft, SI."""
    values = {"rotor_mass": whirl.rotor_mass, "whirl_frequency_ratio": whirl.frequency_ratio}
    values["stable_at_any_mass"] = 1.0 if whirl.stable.least == 0.0 and np.isinf(whirl.stable.greatest) else 0.0
    values |= _bounds(whirl)
    if whirl.threshold.speed is not None:
        values["threshold_speed"] = whirl.threshold.speed
    if whirl.elastic is not None and case.shaft_stiffness is not None:
        values["shaft_stiffness"] = case.shaft_stiffness
        if whirl.elastic.threshold.speed is not None:
            values["threshold_speed_elastic"] = whirl.elastic.threshold.speed
    return values


def whirl_checks(case: CarriesRotor, whirl: Whirl | None) -> Iterator[Check]:
    """The mass of the rotor against the critical ones; nothing where the whirl is unknown."""
    if whirl is None:
        return
    own = case.rotor_mass is not None
    source = "rotor_mass of the case" if own else "load over g, as if the load were the weight of the rotor"
    for name, mass in _bounds(whirl).items():
        bound = Bound.AT_MOST if name == "least_stable_mass" else Bound.AT_LEAST
        yield Check("C115", name, mass, whirl.rotor_mass, bound, source, not own)


def missing_thresholds(whirl: Whirl) -> dict[str, str]:
    """Threshold speeds that were sought and not found, each with the reason."""
    found = {"threshold_speed": (whirl.stable, whirl.threshold)}
    if whirl.elastic is not None:
        found["threshold_speed_elastic"] = (whirl.elastic.stable, whirl.elastic.threshold)
    return {
        name: _why_unknown(threshold, stable.reserve(whirl.rotor_mass) >= 1.0)
        for name, (stable, threshold) in found.items()
        if threshold.speed is None
    }


def _why_unknown(threshold: Threshold, is_stable: bool) -> str:
    if threshold.is_lost:
        return LOST
    return JUMPS if threshold.jumps else STABLE if is_stable else WHIRLING


def without_critical_mass(whirl: Whirl | None) -> Notice | None:
    """Why no bound of the mass of the rotor is known; None where there is one, or no whirl was asked for."""
    if whirl is None or _bounds(whirl):
        return None
    any_mass = whirl.stable.least == 0.0 and math.isinf(whirl.stable.greatest)
    return Notice("C115", "any_mass" if any_mass else "unknown")


def warnings_about_whirl(whirl: Whirl) -> Iterator[Notice]:
    """A rotor too heavy or too light for the film."""
    stable = whirl.stable if whirl.elastic is None else whirl.elastic.stable
    if stable.reserve(whirl.rotor_mass) >= 1.0:
        return
    elastic = "" if whirl.elastic is None else "_elastic"
    whirling: tuple[Notice, ...] = ()
    if whirl.frequency_ratio > 0.0:
        whirling = (Notice("W120", "frequency", {"whirl_frequency_ratio": whirl.frequency_ratio}),)
    if stable.greatest == 0.0:
        yield Notice("W120", f"none{elastic}")
        return
    heavy = not 0.0 < stable.least < math.inf
    yield Notice("W120", f"critical{elastic}" if heavy else "least", {
        "bound": stable.greatest if heavy else stable.least, "rotor_mass": whirl.rotor_mass, "whirl": whirling,
    })  # fmt: skip


def _bounds(whirl: Whirl) -> dict[str, float]:
    """Bounds of the stable masses that there are, kg; 0 as critical mass where no mass is stable."""
    bounds = {}
    if np.isfinite(whirl.stable.greatest):
        bounds["critical_mass"] = whirl.stable.greatest
    if 0.0 < whirl.stable.least < math.inf:
        bounds["least_stable_mass"] = whirl.stable.least
    if whirl.elastic is not None and math.isfinite(whirl.elastic.stable.greatest):
        bounds["critical_mass_elastic"] = whirl.elastic.stable.greatest
    return bounds
