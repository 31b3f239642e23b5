"""The bearing that both programs solve, and how either is timed. Standard library only: both sides import it."""

from __future__ import annotations

import json
import statistics
import sys
from collections.abc import Callable
from math import pi, radians
from pathlib import Path
from time import perf_counter
from typing import Any

DIAMETER = 0.4
WIDTH = 0.263
CLEARANCE = 195e-6
LAND = radians(176.0)
"""Two lands, above and below; the grooves lie at 0 and 180 degrees."""
VISCOSITY = 20.75e-3
SPEED = 900.0 * pi / 30.0
LOAD = 112.8e3
"""Downwards."""


def timed(call: Callable[[], Any], seconds: float, least: int = 5) -> list[float]:
    """Seconds of each of the calls that fit into a time, after one that does not count."""
    call()
    taken: list[float] = []
    while len(taken) < least or sum(taken) < seconds:
        begun = perf_counter()
        call()
        taken.append(perf_counter() - begun)
    return taken


def row(program: str, model: str, mesh: str, times: list[float], **answer: Any) -> dict[str, Any]:
    """What one program says on one mesh: medians in seconds, position over clearance, K and C in SI."""
    return {
        "program": program,
        "model": model,
        "mesh": mesh,
        "time": statistics.median(times),
        "fastest": min(times),
        "calls": len(times),
        **answer,
    }


def answer(record: dict[str, Any]) -> None:
    """Hand a record over in the file named by the first argument; libraries may talk on standard output."""
    Path(sys.argv[1]).write_text(json.dumps(record), encoding="utf-8")
