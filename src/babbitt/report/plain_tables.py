"""Tables of a report as plain data: title, columns of (symbol, unit), rows of texts, a note."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.columns import ABSENT
from babbitt.report.symbols import symbol_node

__all__ = ["plain_table", "table_by_pad"]

Data = dict[str, Any]


def table_by_pad(result: Result, title: str, names: Sequence[str], note: str) -> Data:
    """A row for each pad, a column for each quantity of which the result has a number per pad."""
    quantities = [QUANTITIES[name] for name in names]
    columns = [result.arrays[name][0] for name in names]
    rows = [
        [
            str(pad),
            *(
                quantity.format(value) if math.isfinite(value) else ABSENT
                for quantity, value in zip(quantities, values, strict=True)
            ),
        ]
        for pad, values in enumerate(zip(*columns, strict=True), start=1)
    ]
    heads: list[Data] = [{"text": "Pad", "symbol": None, "unit": ""}]
    heads += [{"text": "", "symbol": symbol_node(q.symbol), "unit": q.display.label} for q in quantities]
    return {"title": title, "columns": heads, "rows": rows, "note": note}


def plain_table(
    title: str, names: Sequence[str], units: Sequence[str], rows: Iterable[Sequence[str]], note: str
) -> Data:
    """A table with headings in words."""
    heads = [{"text": name, "symbol": None, "unit": unit} for name, unit in zip(names, units, strict=True)]
    return {"title": title, "columns": heads, "rows": [list(row) for row in rows], "note": note}
