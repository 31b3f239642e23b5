"""The checker's page as plain data: inputs, limits, what governs, and what identifies the calculation."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from babbitt.core.language import translated
from babbitt.core.quantities import QUANTITIES
from babbitt.report.chapters import Chapter
from babbitt.report.check_content import check_content
from babbitt.report.columns import ABSENT
from babbitt.report.names import shown_name
from babbitt.report.symbols import symbol_node
from babbitt.report.verdict import worst_verdict

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


def checker_content(parts: Sequence[Chapter], limits: Sequence[Data], inputs: Sequence[Sequence[Data]]) -> Data:
    """What the page of the checker repeats.

    Parameters
    ----------
    parts : sequence of Chapter
    limits : sequence of dict
        Of each limit the bearing that comes closest to it.
    inputs : sequence of sequence of dict
        Of each part its groups of inputs. What has no diameter among its results, such as pads or a shaft, has
        them here row by row, for no numbers of a table know it again.

    Returns
    -------
    dict
        ``columns`` and ``rows`` of inputs, ``others`` of the bearings in that table, ``given`` inputs one by one,
        ``governing`` checks of each bearing, ``limits``.
    """
    names = [name for name in INPUTS if any(_values(part, name) for part in parts)]
    quantities = [
        QUANTITIES[name].suited(*(one for part in parts for one in _values(part, name))) for name in names
    ]
    symbols = [symbol_node(one.symbol) for one in quantities]
    in_table = [
        (shown_name(part.name), groups)
        for part, groups in zip(parts, inputs, strict=True)
        if _values(part, "diameter")
    ]
    return {
        "columns": [
            {"heading": [head], "unit": one.display.label} for head, one in zip(symbols, quantities, strict=True)
        ],
        "others": _others(in_table, symbols),
        "rows": [
            {
                "name": shown_name(part.name),
                "cells": [
                    " / ".join(dict.fromkeys(map(quantity.format, _values(part, name)))) or ABSENT
                    for name, quantity in zip(names, quantities, strict=True)
                ],
                "verdict": worst_verdict(part.results).value,
            }
            for part in parts
        ],
        "given": [
            {"name": shown_name(part.name), "rows": rows}
            for part, groups in zip(parts, inputs, strict=True)
            if not _values(part, "diameter") and (rows := _rows(groups))
        ],
        "governing": [governing for part in parts if (governing := _governing(part)) is not None],
        "limits": [one for one in limits if not one["advice"]],
    }


def _others(bearings: Sequence[tuple[str, Sequence[Data]]], shown: Sequence[Any]) -> list[Data]:
    """What each bearing was computed from besides its columns; first what all of several have in common.

    What the case gave in other terms stands there in those of the calculation.
    """
    own = [
        [
            (group["title"], row)
            for group in groups
            for row in group["rows"]
            if group["title"] != translated("As given") and row["symbol"] not in shown
        ]
        for _, groups in bearings
    ]
    common = [one for one in own[0] if all(one in rows for rows in own)] if len(own) > 1 else []
    named = [
        (translated("All bearings"), common),
        *(
            (name, [one for one in rows if one not in common])
            for (name, _), rows in zip(bearings, own, strict=True)
        ),
    ]
    return [
        {
            "name": name,
            "groups": [
                {"title": title, "rows": [row for of, row in rows if of == title]}
                for title in dict.fromkeys(of for of, _ in rows)
            ],
        }
        for name, rows in named
        if rows
    ]


def _rows(groups: Sequence[Data]) -> list[Data]:
    """The rows of all groups of inputs but the method, which is in the hash and on no drawing."""
    return [row for group in groups if group["title"] != translated("Method") for row in group["rows"]]


def _values(part: Chapter, name: str) -> list[float]:
    """A number of a bearing at each of its clearances that has it."""
    values = [result.values.get(name, math.nan) for result in part.results]
    return [value for value in values if name in QUANTITIES and math.isfinite(value)]


def _governing(part: Chapter) -> Data | None:
    """The check with the least margin at any of the clearances of a bearing."""
    found = [(check, result.name) for result in part.results if (check := result.governing_check) is not None]
    if not found:
        return None
    check, name = min(found, key=lambda one: one[0].margin if math.isfinite(one[0].margin) else -math.inf)
    return check_content(check) | {"bearing": shown_name(name)}
