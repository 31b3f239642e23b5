"""The hottest oil of thrust pads against what the case, experience and the bearing metal allow."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check
from babbitt.design.checks import USER, fed_temperature_limit, recommended_temperature
from babbitt.properties.materials import (
    BearingMetal,
    bearing_metal,
    metal_temperature_limit,
)

__all__ = ["ASSUMED_METAL", "TemperatureLimits", "hottest_of_pads"]

ASSUMED_METAL = "B83"
"""Assumption where neither metal nor limit is given: tin Babbitt, with which thrust pads are lined as a rule."""

PRESCRIBED = "effective_temperature"
"""Of films whose temperature is given: no answer of a heat balance, so that it can miss a limit, never keep it."""


@dataclass(frozen=True)
class TemperatureLimits:
    """What pads may heat up to.

    Attributes
    ----------
    highest : float or None
        Set in the case, K.
    given_metal : BearingMetal or None
        Of the faces, as the case has it.
    """

    highest: float | None = None
    given_metal: BearingMetal | None = None

    @property
    def metal(self) -> BearingMetal | None:
        """Of the faces: as given, else `ASSUMED_METAL`, unless the case sets a limit of its own."""
        if self.given_metal is None and self.highest is None:
            return bearing_metal(ASSUMED_METAL)
        return self.given_metal

    def checks(self, values: Mapping[str, float]) -> Iterator[Check]:
        """C104, C108 and C109, as of journal bearings.

        Parameters
        ----------
        values : Mapping of str to float
            Named results, K.
        """
        hottest = hottest_of_pads(values)
        if hottest is not None:
            yield from self._held(values, hottest)
        elif PRESCRIBED in values:
            yield from (check for check in self._held(values, PRESCRIBED) if not check.ok)

    def _held(self, values: Mapping[str, float], hottest: str) -> Iterator[Check]:
        by_experience = fed_temperature_limit(None)
        if self.highest is not None:
            general = by_experience.general, f"{by_experience.source}; for the oil that leaves"
            yield Check("C104", hottest, values[hottest], self.highest, Bound.AT_MOST, USER, general=general)
        else:
            drained = "outlet_temperature" if "outlet_temperature" in values else hottest
            yield Check(
                "C104", drained, values[drained], by_experience.general, Bound.AT_MOST, by_experience.source
            )
        if self.metal is not None:
            limit = metal_temperature_limit(self.metal)
            yield Check("C108", hottest, values[hottest], limit.value, Bound.AT_MOST, self._source(limit.source))
        if self.given_metal is not None and (advised := recommended_temperature(self.given_metal)) is not None:
            yield Check("C109", hottest, values[hottest], advised.value, Bound.AT_MOST, advised.source, True)

    def not_checked(self, values: Mapping[str, float]) -> Iterator[Notice]:
        """Which of these checks lack data, and which."""
        if hottest_of_pads(values) is None:
            missed = {check.code for check in self.checks(values)}
            yield from (Notice(code, "no_heat_balance") for code in ("C104", "C108") if code not in missed)
            return
        if self.metal is None:
            yield Notice("C108", "no_metal")

    def assumptions(self) -> Iterator[str]:
        """What is assumed of the metal, against which pressures are held, and temperatures that are known."""
        if self.given_metal is None:
            yield f"The pads are lined with {ASSUMED_METAL}, a tin Babbitt: no bearing metal is given."

    def _source(self, source: str) -> str:
        return source if self.given_metal is not None else f"assumption: {ASSUMED_METAL}; {source}"


def hottest_of_pads(values: Mapping[str, float]) -> str | None:
    """Name of the hottest temperature known of the pads; None where no temperature is known.

    Pads and collar take no heat, so that the hottest oil is at least as hot as the metal under it.
    """
    names = (
        "maximum_temperature",
        "hottest_trailing_temperature",
        "trailing_temperature",
    )
    return next((name for name in names if name in values), None)
