"""The result as plain data for other programs, in SI, under names that never change their meaning."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from babbitt.core.notices import Notice
from babbitt.core.result import Check, Matrix, Result
from babbitt.report.totals import totals

if TYPE_CHECKING:
    from babbitt.solving import MachineResult


def to_json(machine: MachineResult) -> dict[str, Any]:
    """Turn a solved machine into plain dictionaries, lists, strings and finite numbers.

    Parameters
    ----------
    machine : MachineResult

    Returns
    -------
    dict
        ``babbitt``, ``case``, ``bearings`` as the public contract has them, and ``case_hash``. Values in SI.
        A bearing without a solution has no ``results``; the last state its iteration reached stands under
        ``last_state``, so that no program takes it for an operating point. Numbers that do not exist are
        absent, or null where a key must stand; NaN and infinity never appear. ``totals`` stands where a sum over
        the bearings means something.
    """
    record: dict[str, Any] = {
        "babbitt": machine.version,
        "case": machine.name,
        "case_hash": machine.case_hash,
        "bearings": [bearing_record(result) for result in machine.results],
    }
    summed = totals(machine.results)
    if summed is not None:
        record["totals"] = _finite(summed.values)
    return record


def write_json(machine: MachineResult) -> str:
    """The JSON text of `to_json`, indented, ending with a newline; letters of all scripts stay readable."""
    record = to_json(machine)
    text = json.dumps(record, indent=2, ensure_ascii=False, allow_nan=False)
    try:
        text.encode()
    except UnicodeEncodeError:  # half a surrogate pair in a name: only an escape can stand for it
        text = json.dumps(record, indent=2, ensure_ascii=True, allow_nan=False)
    return text + "\n"


def escaped(text: str) -> str:
    """The same JSON in ASCII alone, for an output that does not take all letters.

    >>> print(escaped('{"name": "ψ"}'))
    {
      "name": "\\u03c8"
    }
    """
    return json.dumps(json.loads(text), indent=2, ensure_ascii=True) + ("\n" if text.endswith("\n") else "")


def bearing_record(result: Result) -> dict[str, Any]:
    """One bearing of `to_json`."""
    numbers: dict[str, Any] = {**_finite(result.values)}
    numbers |= {
        name: [[_number(value) for value in row] for row in rows]
        for name, rows in result.arrays.items()
        if _has_numbers(rows)
    }
    solved, governing = result.outcome.solved, result.governing_check
    record: dict[str, Any] = {
        "name": result.name,
        "kind": result.kind,
        "method": result.method,
        "status": result.outcome.name.lower(),
        "verdict": result.verdict.key,
        "within_limits": result.within_limits,
        "governing_check": None if governing is None else governing.code,
        "margin": _number(result.margin),
        "results": numbers if solved else {},
        "missing": dict(result.missing) if solved else {},
        "checks": [_check(check) for check in result.checks] if solved else [],
        "not_checked": _notices(result.not_checked),
        "warnings": _warnings(result.warnings),
        "assumptions": list(result.assumptions),
        "settings": dict(result.settings),
        "message": result.message,
    }
    if not solved:
        record["last_state"] = numbers
    return record


def _notices(notices: Iterable[Notice]) -> list[dict[str, Any]]:
    return [
        {"code": notice.code, "message": notice.message, "values": notice.plain_values()} for notice in notices
    ]


def _warnings(notices: Iterable[Notice]) -> list[dict[str, Any]]:
    effects = [notice.effect.name.lower() for notice in notices]
    return [{**notice, "effect": effect} for notice, effect in zip(_notices(notices), effects, strict=True)]


def _finite(values: Mapping[str, float]) -> dict[str, float]:
    return {name: float(value) for name, value in values.items() if math.isfinite(value)}


def _check(check: Check) -> dict[str, Any]:
    return {
        "code": check.code,
        "quantity": check.quantity,
        "value": _number(check.value),
        "limit": _number(check.limit),
        "bound": check.bound.value,
        "ok": check.ok,
        "margin": _number(check.margin),
        "advisory": check.advisory,
        "source": check.source,
    }


def _has_numbers(rows: Matrix) -> bool:
    """Whether a quantity has a number anywhere; an empty one has all it should."""
    values = [value for row in rows for value in row]
    return not values or any(map(math.isfinite, values))


def _number(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
