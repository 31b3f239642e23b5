"""The log decrement over the cross-coupling of a rotor and over its speed: figure and table."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.kinds.tilting_pad_journal.cross_coupling import CrossCoupling
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.report.drawing import GREY, INK, Sheet, mark
from babbitt.report.symbols import symbol_node

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["log_decrements", "stability_table"]

DASHED = (0, (5, 2))
DECREMENTS = ("log_decrement", "log_decrement_anticipated")
CRITICAL, RATIO = "critical_cross_coupling", "cross_coupling_ratio"
"""What the table tells, by either kind of coefficients."""


def log_decrements(case: PadCase, found: CrossCoupling, least: float) -> Figure:
    """Log decrement over the cross-coupling of the rotor, and over its speed, by both kinds of coefficients.

    Parameters
    ----------
    case : PadCase
    found : CrossCoupling
    least : float
        Log decrement that is asked with the anticipated cross-coupling.
    """
    figure, ((left, right),) = Sheet(166.0, 60.0, 1, 2, across=17.0).panels()
    _over_cross_coupling(left, found, least)
    speeds, full, driven, synchronous, reduced = np.array(found.over_speed).T
    turns = speeds * 30.0 / math.pi
    for values, colour, stroke in (
        (full, GREY, "-"), (synchronous, GREY, DASHED), (driven, INK, "-"), (reduced, INK, DASHED),
    ):  # fmt: skip
        right.plot(turns, values, color=colour, linestyle=stroke)
    right.axhline(least, color=GREY, linewidth=0.7, linestyle=":")
    mark(right, abs(case.journal_speed) * 30.0 / math.pi, found.full.anticipated_decrement)
    right.set(xlabel="$n$ in 1/min", ylabel="log decrement $δ$")
    right.set_ylim(bottom=min(0.0, right.get_ylim()[0]))
    return figure


def _over_cross_coupling(panel: Axes, found: CrossCoupling, least: float) -> None:
    crosses, full, synchronous = np.array(found.curve).T
    panel.plot(1e-6 * crosses, full, color=INK, label="full coefficients")
    panel.plot(1e-6 * crosses, synchronous, color=INK, linestyle=DASHED, label="synchronous")
    panel.axhline(0.0, color=GREY, linewidth=0.7)
    anticipated = 1e-6 * found.anticipated
    low, high = panel.get_ylim()
    panel.set_ylim(low, high + 0.16 * (high - low))
    for share, name in ((1.0, "$Q_\\mathrm{A}$"), (2.0, "$2Q_\\mathrm{A}$")):
        panel.axvline(share * anticipated, color=GREY, linewidth=0.7, linestyle=":")
        panel.annotate(name, (share * anticipated, 1.0), xycoords=("data", "axes fraction"), xytext=(2, -8),
                       textcoords="offset points", fontsize=7)  # fmt: skip
    panel.plot([0.0, anticipated], [least, least], color=GREY, linewidth=0.9)
    mark(panel, anticipated, found.full.anticipated_decrement)
    panel.set_xlim(0.0, 1e-6 * float(crosses[-1]))
    panel.set(xlabel="$Q$ in MN/m", ylabel="log decrement $δ$")
    panel.legend(
        facecolor="white", edgecolor="none", framealpha=1.0, fontsize=7, loc="lower left", handlelength=1.8
    )


def stability_table(result: Result) -> dict[str, Any]:
    """Margins by both kinds of coefficients."""
    values, prefixes = result.values, ("", "synchronous_")
    anticipated = values["anticipated_cross_coupling"]
    critical = [values.get(f"{prefix}critical_cross_coupling", math.nan) for prefix in prefixes]
    coupling = QUANTITIES["anticipated_cross_coupling"].suited(anticipated, *critical)
    rows = [
        (
            name,
            *(QUANTITIES[one].format(values[f"{prefix}{one}"]) for one in DECREMENTS),
            coupling.format(threshold) if math.isfinite(threshold) else "none",
            QUANTITIES[RATIO].format(values[f"{prefix}{RATIO}"]) if math.isfinite(threshold) else "none",
        )
        for name, prefix, threshold in zip(
            ("rotor and pads together", "synchronously reduced"), prefixes, critical, strict=True
        )
    ]
    heads: list[dict[str, Any]] = [{"text": "Coefficients", "symbol": None, "unit": ""}]
    heads += [
        {"text": "", "symbol": symbol_node(one.symbol), "unit": one.display.label}
        for one in (*(QUANTITIES[name] for name in DECREMENTS), QUANTITIES[CRITICAL], QUANTITIES[RATIO])
    ]
    heads[3]["unit"] = coupling.display.label
    note = (
        f"Log decrement without cross-coupling and with that anticipated, {coupling.with_unit(anticipated)} of "
        "the whole rotor on two such bearings; threshold, and threshold over anticipated. Judged by the motions "
        "of rotor and pads together."
    )
    return {"title": "Cross-coupling of the rotor", "columns": heads, "rows": rows, "note": note}
