"""The checker's page as plain data: inputs, limits, what governs, and what identifies the calculation."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.chapters import Chapter
from babbitt.report.check_content import check_content
from babbitt.report.columns import ABSENT
from babbitt.report.symbols import symbol_node
from babbitt.report.text import plain_text

__all__ = ["checker_content"]

Data = dict[str, Any]

INPUTS = (
    "diameter",
    "width",
    "inner_diameter",
    "outer_diameter",
    "relative_clearance",
    "radial_clearance",
    "load",
    "angular_speed",
    "supply_temperature",
    "supply_pressure",
    "given_flow",
    "ambient_temperature",
    "rotor_mass",
)
"""Numbers of the case by which a checker knows it again; those that a kind has among its results are shown."""


def checker_content(parts: Sequence[Chapter], limits: Sequence[Data]) -> Data:
    """What the page of the checker repeats.

    Parameters
    ----------
    parts : sequence of Chapter
    limits : sequence of dict
        Of each limit the bearing that comes closest to it.

    Returns
    -------
    dict
        ``columns`` and ``rows`` of inputs, ``governing`` checks of each bearing, ``limits``.
    """
    shown = [part.shown.result for part in parts]
    names = [name for name in INPUTS if any(_has(result, name) for result in shown)]
    quantities = [
        QUANTITIES[name].suited(*(one.values[name] for one in shown if _has(one, name))) for name in names
    ]
    return {
        "columns": [{"heading": [symbol_node(one.symbol)], "unit": one.display.label} for one in quantities],
        "rows": [
            {
                "name": plain_text(part.name),
                "cells": [
                    quantity.format(part.shown.result.values[name]) if _has(part.shown.result, name) else ABSENT
                    for name, quantity in zip(names, quantities, strict=True)
                ],
                "verdict": part.shown.result.verdict.value,
            }
            for part in parts
        ],
        "governing": [
            check_content(governing) | {"bearing": plain_text(part.name)}
            for part in parts
            if (governing := part.shown.result.governing_check) is not None
        ],
        "limits": [one for one in limits if not one["advice"]],
    }


def _has(result: Result, name: str) -> bool:
    return name in QUANTITIES and math.isfinite(result.values.get(name, math.nan))
