"""Rows of results of which a bearing has several: supplies, recesses, frequencies."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from babbitt.core.quantities import QUANTITIES
from babbitt.report.bearing_table import matrix_unit
from babbitt.report.columns import ABSENT
from babbitt.report.symbols import symbol_node

__all__ = ["result_row"]


def result_row(name: str, said: str, values: Sequence[float], index: str) -> dict[str, Any]:
    """A row of one quantity with an index at its symbol, with one value for each result side by side."""
    quantity = QUANTITIES[name].suited(*values)
    symbol = f"{quantity.symbol.partition('_')[0]}_{index}" if index else quantity.symbol
    return {
        "label": said,
        "symbol": symbol_node(symbol),
        "values": [quantity.format(value) if math.isfinite(value) else ABSENT for value in values],
        "unit": matrix_unit(quantity, index),
    }
