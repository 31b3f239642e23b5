"""Bearings of the tests of the front door; each is solved once."""

from __future__ import annotations

from functools import cache
from typing import Any

from film_bearings import GROOVES, solved

from babbitt.api.results import BearingResult
from babbitt.solving import MachineResult

UNFED = [{"angle": f"{angle} deg", "extent": "20 deg", "pressure": "0 Pa"} for angle in (0, 180)]
"""Grooves full of oil at ambient pressure."""

FAN = {"kind": "rotating", "magnitude": "6 kN", "speed_ratio": 1}

ISO7902: dict[str, Any] = {
    "method": "iso7902", "grooves": None, "accuracy": None, "span": "180 deg",
    "supply_element": {"kind": "pocket", "width": "40 mm", "place": "both_sides"},
}  # fmt: skip

CASES: dict[str, dict[str, Any]] = {
    "grooved": {},
    "clockwise": {"speed": "-3000 rpm"},
    "pressure-fed": {"grooves": GROOVES},
    "lemon": {"bore": {"kind": "lobes", "preload": 0.5}},
    "thermal": {"thermal": "adiabatic", "grooves": GROOVES},
    "moving": {"dynamic_load": FAN},
    "elastic": {"compliance": [{"kind": "column", "displacement_per_pressure": "0.5 um/MPa"}]},
    "starved": {"grooves": GROOVES, "supply": {"temperature": "45 degC", "flow": "3 L/min"}},
    "closed pocket": {"pockets": [{"angle": "-90 deg", "extent": "30 deg", "width": "30 mm", "flow": "0 L/min"}]},
    "overloaded": {"load": "90 MN"},
    "iso7902": ISO7902,
}


@cache
def machine_of(name: str) -> MachineResult:
    return solved(**({"grooves": UNFED, "accuracy": "draft"} | CASES[name]))


def result_of(name: str) -> BearingResult:
    """The result of one of `CASES`."""
    return BearingResult(machine_of(name).solutions[0])
