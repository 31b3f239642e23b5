"""The page of units: what may stand behind a number in a case file or an option."""

from __future__ import annotations

from babbitt.core.units import KINDS
from babbitt_pages.markdown import code, table, text


def page() -> str:
    """Markdown table of the kinds of quantities with the units that are read without further help."""
    return table(
        ["kind", "SI unit", "without unit", "example", "everyday units"],
        (
            [
                text(kind.phrase),
                code(kind.unit),
                "in the SI unit" if kind.one_unit else "refused",
                text(kind.example) if kind.unit == "1" else code(kind.example),
                ", ".join(code(unit) for unit in kind.everyday if unit),
            ]
            for kind in KINDS.values()
        ),
    )
