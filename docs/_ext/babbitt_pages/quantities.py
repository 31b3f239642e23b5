"""The page of quantities: every name that results, JSON and checks use."""

from __future__ import annotations

from babbitt.core.quantities import QUANTITIES
from babbitt_pages.markdown import code, table, text


def page() -> str:
    """Markdown table in the order of the vocabulary."""
    return table(
        ["name", "symbol", "SI unit", "shown in", "meaning"],
        (
            [
                code(quantity.name),
                text(quantity.symbol),
                text(quantity.unit),
                text(quantity.display.label or "1"),
                text(quantity.meaning),
            ]
            for quantity in QUANTITIES.values()
        ),
    )
