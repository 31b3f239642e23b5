"""One bearing in full, for the terminal."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product
from typing import Any

from rich import box
from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from babbitt.core import check_text
from babbitt.core.quantities import QUANTITIES, Quantity
from babbitt.core.result import Check, Result, Verdict
from babbitt.report import verdict as verdicts
from babbitt.report.coefficient_temperatures import temperature_remark
from babbitt.report.meanings import meaning, remark_on_zero
from babbitt.report.text import plain_text
from babbitt.report.units_of_matrices import suited_among
from babbitt.report.us_words import in_us_units
from babbitt.report.verdict import CheckWord

STYLES = {
    Verdict.PASS: "green",
    Verdict.REMARKS: "yellow",
    Verdict.FAIL: "bold red",
    Verdict.NO_VERDICT: "bold yellow",
    Verdict.NO_SOLUTION: "bold red",
}
RECESS = ("recess_pressure", "pressure_ratio", "restrictor_flow")
"""Of every recess of a hydrostatic bearing."""
SUPPORT = ("support_station", "support_load")
"""Of every bearing of a shaft."""
SUPPORTS = (*SUPPORT, "support_load_angle", "support_axial_load", "support_slope_x", "support_slope_y")
PAD = ("pad_pivot_angle", "pad_load", "pad_minimum_film_thickness")
"""Of every pad of a journal bearing."""
CHECK_STYLES = {CheckWord.PASS: "green", CheckWord.MISSED: "yellow", CheckWord.FAIL: "bold red"}


def engineers_table(**settings: Any) -> Table:
    """An empty table: a rule below its heading, and nothing else drawn."""
    return Table(box=box.SIMPLE_HEAD, show_edge=False, pad_edge=False, padding=(0, 1, 0, 0), **settings)


def bearing_table(result: Result) -> RenderableType:
    """All quantities and checks of a bearing; for an unsolved one its name alone."""
    word = result.verdict
    heading = Text(plain_text(result.name), style="bold")
    heading.append(f"   {result.method}   ", style="dim")
    heading.append(word.value, style=STYLES[word])
    heading.append(f"   {verdicts.unchecked(result)}" if result.not_checked else "")
    if word is Verdict.NO_SOLUTION:
        return heading
    table = engineers_table()
    table.add_column("quantity", overflow="fold")
    table.add_column("symbol")
    table.add_column("value", justify="right", no_wrap=True)
    table.add_column("unit", no_wrap=True)
    for name, value in result.values.items():
        quantity = QUANTITIES.get(name)
        if quantity is not None and math.isfinite(value) and name != "wall_time":
            said = meaning(name, result.kind) + remark_on_zero(name, value) + temperature_remark(name, result)
            shown = suited_among(name, result.values)
            table.add_row(said, shown.symbol, shown.format(value), shown.display.label)
    for name in result.missing:  # the reasons stand below, together
        table.add_row(meaning(name, result.kind), QUANTITIES[name].symbol, "–", "")
    return Group(
        heading,
        table,
        *_supplies(result),
        *_by_part(result, "recess", RECESS, RECESS),
        *_by_part(result, "bearing", SUPPORT, SUPPORTS),
        *_by_part(result, "pad", PAD, (*PAD, "pad_probe_temperature", "pad_maximum_temperature")),
        *_frequencies(result),
        *([_checks(result.checks)] if result.checks else []),
    )


def _supplies(result: Result) -> list[Table]:
    """Flows and temperature of every groove, pocket and hole of a film with its own temperatures."""
    heads = {
        "groove_angles": "at",
        "groove_pressures": "under",
        "groove_fresh_flows": "fresh oil",
        "groove_returned_flows": "goes back",
        "groove_temperatures": "mixed at",
    }
    names = [name for name in heads if name in result.arrays and result.arrays[name][0]]
    if "groove_angles" not in names:
        return []
    table = engineers_table()
    table.add_column("supply", justify="right")
    for name in names:
        table.add_column(f"{heads[name]} {QUANTITIES[name].display.label}", justify="right", no_wrap=True)
    columns = [result.arrays[name][0] for name in names]
    for place, row in enumerate(zip(*columns, strict=True), start=1):
        table.add_row(
            str(place), *(QUANTITIES[name].format(value) for name, value in zip(names, row, strict=True))
        )
    return [table]


def _by_part(result: Result, part: str, needed: Sequence[str], wanted: Sequence[str]) -> list[Table]:
    """One row a recess, pad or bearing, by name or number; none where there is one or no such thing."""
    if not all(name in result.arrays and len(result.arrays[name][0]) > 1 for name in needed):
        return []
    names = [name for name in wanted if name in result.arrays]
    table = engineers_table()
    named = any(name.startswith(f"{part}_") for name in result.settings)
    table.add_column(part, justify="left" if named else "right")
    for name in names:
        quantity = QUANTITIES[name]
        unit = f" {quantity.display.label}" if quantity.display.label else ""
        table.add_column(f"{quantity.symbol}{unit}", justify="right", no_wrap=True)
    columns = [result.arrays[name][0] for name in names]
    for place, row in enumerate(zip(*columns, strict=True), start=1):
        table.add_row(
            plain_text(result.settings.get(f"{part}_{place}", str(place))),
            *(QUANTITIES[name].format(value) for name, value in zip(names, row, strict=True)),
        )
    return [table]


def _frequencies(result: Result) -> list[Table]:
    """Stiffness and damping at the frequencies asked for, one row each."""
    if "dynamic_frequency" not in result.arrays:
        return []
    frequency, stiffness, damping = (QUANTITIES[f"dynamic_{one}"] for one in ("frequency", "stiffness", "damping"))
    table = engineers_table()
    table.add_column(f"frequency {frequency.display.label}", justify="right")
    shown = matrix_entries(len(result.arrays["dynamic_stiffness"][0]))
    for quantity, letter in ((stiffness, "K"), (damping, "C")):
        for name in shown:
            table.add_column(f"{letter}{name} {matrix_unit(quantity, name)}", justify="right", no_wrap=True)
    for place, at in enumerate(result.arrays["dynamic_frequency"][0]):
        cells = [
            f"{quantity.shown(result.arrays[quantity.name][place][entry]):.5g}"
            for quantity in (stiffness, damping)
            for entry in shown.values()
        ]
        table.add_row(frequency.format(at), *cells)
    return [table]


def matrix_entries(size: int) -> dict[str, int]:
    """Subscripts and places of a matrix written row by row; of a ring, in z and two tilts, the diagonal alone.

    >>> matrix_entries(1), matrix_entries(4)
    ({'': 0}, {'_xx': 0, '_xy': 1, '_yx': 2, '_yy': 3})
    """
    if size == 9:
        return {"_zz": 0, "_φx": 4, "_φy": 8}
    axes = "xy" if size == 4 else ""
    return {f"_{one}{two}": place for place, (one, two) in enumerate(product(axes, axes))} or {"": 0}


def matrix_unit(quantity: Quantity, index: str) -> str:
    """Unit of an entry of stiffness or damping: forces over moves, of tilts (φ) moments over angles."""
    unit = quantity.display.label
    return f"{unit.removesuffix('/m')} m/rad" if "φ" in index else unit


def _checks(checks: Sequence[Check]) -> RenderableType:
    table = engineers_table()
    for heading in ("check", "comparison"):
        table.add_column(heading, no_wrap=True)
    table.add_column("margin", justify="right", no_wrap=True)
    table.add_column("verdict", no_wrap=True)
    table.add_column("source", overflow="fold")
    for check in checks:
        word = verdicts.check_word(check)
        table.add_row(
            check.code,
            Text(check_text.comparison(check)),
            check_text.margin(check),
            Text(word.value, style=CHECK_STYLES[word]),
            Text(in_us_units(plain_text(check.source))),
        )
    return table
