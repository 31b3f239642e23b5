"""What the whirl of a rotor adds to the answer of a bearing: numbers, verdicts, doubts."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Protocol

from babbitt.film.whirl import Whirl
from babbitt.notices import Notice
from babbitt.results import Bound, Check

__all__ = ["CarriesRotor", "doubts_about_whirl", "whirl_checks", "whirl_values"]


class CarriesRotor(Protocol):
    """A bearing that may know its part of the mass of the rotor, kg, and the stiffness of the shaft, N/m."""

    @property
    def rotor_mass(self) -> float | None:
        """Kg; None where it is not known."""

    @property
    def shaft_stiffness(self) -> float | None:
        """N/m; None for a rigid shaft."""


def whirl_values(case: CarriesRotor, whirl: Whirl) -> dict[str, float]:
    """Critical mass, whirl frequency and threshold speed, for a rigid rotor and on its elastic shaft, SI."""
    values = {"rotor_mass": whirl.rotor_mass, "whirl_frequency_ratio": whirl.frequency_ratio}
    values["stable_at_any_mass"] = float(math.isinf(whirl.critical_mass))
    if math.isfinite(whirl.critical_mass):
        values["critical_mass"] = whirl.critical_mass
    if whirl.threshold_speed is not None:
        values["threshold_speed"] = whirl.threshold_speed
    if whirl.elastic is not None and case.shaft_stiffness is not None:
        values["shaft_stiffness"] = case.shaft_stiffness
        if math.isfinite(whirl.elastic.critical_mass):
            values["critical_mass_elastic"] = whirl.elastic.critical_mass
        if whirl.elastic.threshold_speed is not None:
            values["threshold_speed_elastic"] = whirl.elastic.threshold_speed
    return values


def whirl_checks(case: CarriesRotor, whirl: Whirl | None) -> Iterator[Check]:
    """The mass of the rotor against the critical ones; nothing where the whirl is unknown."""
    if whirl is None:
        return
    own = case.rotor_mass is not None
    source = "rotor_mass of the case" if own else "load over g, as if the load were the weight of the rotor"
    for name, critical in _critical_masses(whirl).items():
        if math.isfinite(critical):
            yield Check("C115", name, critical, whirl.rotor_mass, Bound.AT_LEAST, source, not own)


def doubts_about_whirl(whirl: Whirl) -> Iterator[Notice]:
    """A rotor heavier than the least critical mass."""
    least = min(_critical_masses(whirl).values())
    if least < whirl.rotor_mass:
        shaft = " on its elastic shaft" if whirl.elastic is not None else ""
        yield Notice(
            "W120",
            f"critical mass{shaft} {least:.4g} kg < {whirl.rotor_mass:.4g} kg; whirl at "
            f"{whirl.frequency_ratio:.2f} of the speed",
        )


def _critical_masses(whirl: Whirl) -> dict[str, float]:
    rigid = {"critical_mass": whirl.critical_mass}
    return rigid if whirl.elastic is None else rigid | {"critical_mass_elastic": whirl.elastic.critical_mass}
