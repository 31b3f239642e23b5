"""Five pads with the load on one, as both programs solve them. Standard library only: both sides import it."""

from __future__ import annotations

import sys
from collections.abc import Callable
from math import pi
from pathlib import Path
from time import process_time
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "two_lands"))

from case import answer, row

__all__ = [
    "ANGLES",
    "ARC",
    "ASSEMBLED",
    "DIAMETER",
    "LOAD",
    "PRELOAD",
    "SPEED",
    "THICKNESS",
    "VISCOSITY",
    "WIDTH",
    "answer",
    "processor_times",
    "row",
]

DIAMETER, WIDTH, ASSEMBLED, PRELOAD = 0.3999992, 0.263144, 194.564e-6, 0.3
ANGLES, ARC, THICKNESS = (54.0, 126.0, 198.0, 270.0, 342.0), 60.0, 0.05
"""Degrees, degrees, m."""
SPEED, VISCOSITY = 900.0 * pi / 30.0, 0.0190062
LOAD = 112814.90696191376
"""Downwards."""


def processor_times(call: Callable[[], Any], seconds: float, least: int) -> list[float]:
    """Seconds of the processor in each of the calls that fit into a time, after one that does not count."""
    call()
    taken: list[float] = []
    while len(taken) < least or sum(taken) < seconds:
        begun = process_time()
        call()
        taken.append(process_time() - begun)
    return taken
