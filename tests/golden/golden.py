"""What Babbitt answers today, kept beside what it answers now: results as JSON, reports as plain data.

Goldens guard moves of code that must change no number. Where a number is meant to change,
``python tests/golden/golden.py`` writes them anew, and the changelog says why.
"""

from __future__ import annotations

import gzip
import json
import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from unittest.mock import patch

import babbitt
from babbitt.case import kinds
from babbitt.core.quantities import QUANTITIES
from babbitt.report import content as report_content
from babbitt.report.export import to_json
from babbitt.solving import MachineResult, solve

HERE = Path(__file__).parent
EXAMPLES = HERE.parents[1] / "examples"
CASES = {
    **{f"template_{kind}": kind for kind in kinds()},
    **{f"example_{path.stem}": path for path in sorted(EXAMPLES.glob("*.yaml"))},
}
"""Name of the golden: kind of a template, or file of an example."""

VOLATILE = {"case_hash", "hash", "babbitt", "version", "wall_time", "iterations", "svg", "case_text"}
VOLATILE |= {
    "level",
    "shared_assumptions",
    "sketch",
    "language",
    "words",
    "checker",
    "advice",
    "conclusion",
    "decides",
    "left_out",
}
"""What may differ from run to run, or is a picture, a copy of the input or the layout of a report."""

FORMULAS, FILMS, COEFFICIENTS = 1e-10, 1e-7, 1e-4
"""Relative tolerances: results of closed formulas, of films, and of derivatives and small differences."""

BY_FORMULA = ("iso7902", "quick", "statics", "superposition")
LOOSE = (
    "stiffness",
    "damping",
    "mass",
    "threshold",
    "whirl",
    "error",
    "stability",
    "amplif",
    "decrement",
    "modes",
)
NUMBER = re.compile(r"[-−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")

ROUND_OFF = 1e-10
"""In the engineer's unit: what is smaller is zero, and its digits differ from processor to processor."""
ENTRY_ROUND_OFF = 1e-12
"""The same of an entry of an array, over its largest."""


def solved(name: str) -> MachineResult:
    """Results of one case."""
    source = CASES[name]
    case = babbitt.load_case(source) if isinstance(source, Path) else babbitt.parse_case(babbitt.template(source))
    return solve(case)


def answer(machine: MachineResult) -> dict[str, Any]:
    """Results and report of one case, without what is volatile."""
    with patch("matplotlib.figure.Figure.savefig"):  # pictures are volatile, and most of the time
        made = {"results": to_json(machine), "report": report_content.content(machine)}
    kept: dict[str, Any] = json.loads(json.dumps(lasting(made)))
    return kept


def lasting(data: Any) -> Any:
    """The same data without what is volatile."""
    if isinstance(data, dict):
        return {key: lasting(value) for key, value in data.items() if key not in VOLATILE}
    return [lasting(value) for value in data] if isinstance(data, list | tuple) else data


def stored(name: str) -> dict[str, Any]:
    """The golden of one case."""
    with gzip.open(HERE / f"{name}.json.gz", "rt", encoding="utf-8") as file:
        kept: dict[str, Any] = json.load(file)
    return kept


def differences(
    kept: Any, now: Any, tolerance: float, where: str = "", nothing: float = ROUND_OFF
) -> Iterator[str]:
    """Where two pieces of data differ by more than numbers may; differences up to `nothing` are none."""
    if isinstance(kept, dict) and isinstance(now, dict):
        for key in sorted(kept.keys() ^ now.keys()):
            yield f"{where}/{key}: only in the {'golden' if key in kept else 'answer'}"
        for key in kept.keys() & now.keys():
            own = COEFFICIENTS if any(word in key for word in LOOSE) else tolerance
            unit = QUANTITIES[key].display.scale if key in QUANTITIES else 1.0
            zero = max(ROUND_OFF / unit, ENTRY_ROUND_OFF * largest(kept[key]))
            yield from differences(kept[key], now[key], max(own, tolerance), f"{where}/{key}", zero)
    elif isinstance(kept, list) and isinstance(now, list):
        if len(kept) != len(now):
            yield f"{where}: {len(kept)} entries in the golden, {len(now)} in the answer"
        for place, (one, other) in enumerate(zip(kept, now, strict=False)):
            yield from differences(one, other, tolerance, f"{where}/{place}", nothing)
    elif isinstance(kept, float) and isinstance(now, int | float) and not isinstance(now, bool):
        if not math.isclose(kept, now, rel_tol=tolerance, abs_tol=nothing):
            yield f"{where}: {kept!r} in the golden, {now!r} in the answer"
    elif isinstance(kept, str) and isinstance(now, str):
        if not same_text(kept, now):
            yield f"{where}: {kept!r} in the golden, {now!r} in the answer"
    elif kept != now:
        yield f"{where}: {kept!r} in the golden, {now!r} in the answer"


def largest(data: Any) -> float:
    """The largest entry of an array of numbers; 0 of anything else."""
    if isinstance(data, list):
        return max(map(largest, data), default=0.0)
    return abs(data) if isinstance(data, float) else 0.0


def same_text(kept: str, now: str) -> bool:
    """Whether two texts are the same but for the last digit printed of their numbers."""
    if kept == now:
        return True
    if NUMBER.sub("#", kept) != NUMBER.sub("#", now):
        return False
    pairs = zip(NUMBER.findall(kept), NUMBER.findall(now), strict=True)
    return all(abs(_value(one) - _value(other)) <= max(1.01 * _step(one), ROUND_OFF) for one, other in pairs)


def _value(text: str) -> float:
    return float(text.replace("−", "-"))


def _step(text: str) -> float:
    """One unit of the last digit printed."""
    mantissa, _, exponent = text.partition("e")
    return float(10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2])))


def tolerance_of(data: dict[str, Any]) -> float:
    """Of the numbers of one case: that of its least exact method."""
    methods = {one["method"] for one in data["results"]["bearings"]}
    return FORMULAS if methods <= {*BY_FORMULA} else FILMS


if __name__ == "__main__":
    for case_name in CASES:
        text = json.dumps(answer(solved(case_name)), ensure_ascii=False, sort_keys=True).encode()
        (HERE / f"{case_name}.json.gz").write_bytes(gzip.compress(text, mtime=0))
        print(case_name, len(text))
