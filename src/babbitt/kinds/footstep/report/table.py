"""The steady states of a footstep side by side, for the terminal."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rich.console import Group, RenderableType
from rich.text import Text

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.bearing_table import STYLES, engineers_table
from babbitt.report.columns import ABSENT
from babbitt.report.meanings import meaning
from babbitt.report.names import split_clearance
from babbitt.report.text import plain_text

LEFT_OUT = ("wall_time",)


def heel_table(results: Sequence[Result]) -> RenderableType:
    """All quantities of the states of one footstep, one column a state.

    Parameters
    ----------
    results : sequence of Result
        Of one footstep; a heel without a steady state has an empty column that says so.
    """
    heading = Text(plain_text(split_clearance(results[0].name)[0]), style="bold")
    heading.append(f"   {results[0].method}", style="dim")
    table = engineers_table()
    for title in ("quantity", "symbol", "unit"):
        table.add_column(title, overflow="fold" if title == "quantity" else "ellipsis")
    for result in results:
        table.add_column(Text(split_clearance(result.name)[1].replace(" ", "\n")), justify="right", no_wrap=True)
    solved = [result.values if result.outcome.solved else {} for result in results]
    for name in dict.fromkeys(name for values in solved for name in values):
        quantity = QUANTITIES.get(name)
        if quantity is None or name in LEFT_OUT:
            continue
        cells = [values.get(name, math.nan) for values in solved]
        written = [quantity.format(value) if math.isfinite(value) else ABSENT for value in cells]
        table.add_row(meaning(name, results[0].kind), quantity.symbol, quantity.display.label, *written)
    words = [result.verdict for result in results]
    stable = [
        {"yes": "stable", "no": "not stable"}.get(result.settings.get("stable", ""), "") for result in results
    ]
    table.add_row(Text("verdict"), "", "", *(Text(word.value, style=STYLES[word]) for word in words))
    table.add_row(Text("steady state"), "", "", *stable)
    return Group(heading, table)
