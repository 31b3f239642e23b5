"""The answers of a sweep as curves."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from babbitt.notices import InputError
from babbitt.quantities import QUANTITIES
from babbitt.report.drawing import FORMATS, GREY, INK, Sheet, axis_label, in_engineers_unit, rendered, style
from babbitt.report.sweep_columns import panels_of
from babbitt.report.text import plain_text
from babbitt.report.writing import write_whole
from babbitt.studies.case_sweep import CaseSweep

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LINES: tuple[dict[str, Any], ...] = tuple(
    {"color": colour, "linestyle": dashes}
    for dashes in ("-", (0, (6, 1.5)), (0, (2, 1.5)), (0, (6, 1.5, 1, 1.5)))
    for colour in (INK, GREY)
)
"""So many bearings can be told apart; more share lines."""

MARKERS = ("o", "s", "^")
"""Where there are more bearings than lines."""

MOST_MARKED = 25
"""Points of a curve that are still marked one by one."""


def require_plot(path: Path) -> None:
    """Refuse a suffix that no figure has.

    Raises
    ------
    InputError
        E007.
    """
    if path.suffix.lower().removeprefix(".") not in FORMATS:
        raise InputError("E007", f"cannot write {path}: a plot is .png, .svg or .pdf")


def write_sweep_plot(sweep: CaseSweep, path: Path) -> None:
    """Draw the key results over the field and write the figure.

    Raises
    ------
    InputError
        E007 when the file cannot be written or matplotlib is not installed.
    """
    require_plot(path)
    with style():
        image = rendered(sweep_figure(sweep), path.suffix.lower().removeprefix("."))
    write_whole(path, image)


def sweep_figure(sweep: CaseSweep) -> Figure:
    """At most four panels over the field, a line per bearing; what the file itself has in the field is marked."""
    names = sweep.names
    legend = 4.5 * math.ceil(len(names) / 3) if len(names) > 1 else 0.0
    height = 100.0 + legend
    figure, axes = Sheet(166.0, height, 2, 2, across=16.0, between=5.0).panels(sharex=True)
    figure.subplots_adjust(top=1.0 - (5.0 + legend) / height)
    shown = panels_of([result for _, result in sweep.rows()])
    for panel in axes.ravel()[len(shown) :]:
        panel.set_axis_off()
    for panel, choice in zip(axes.ravel(), shown, strict=False):
        _panel(panel, sweep, choice, titled=panel in axes[0])
    for panel in axes[1]:
        panel.set_xlabel(f"{sweep.path} in {sweep.values.unit}" if sweep.values.unit else sweep.path)
    if legend:
        handles = axes[0][0].get_lines()[: len(names)]
        labels = [plain_text(name).replace("$", r"\$") for name in names]
        figure.legend(handles, labels, loc="upper left", ncols=3, frameon=False, fontsize=7, handlelength=3.2)
    return figure


def _panel(panel: Axes, sweep: CaseSweep, choice: tuple[str, ...], *, titled: bool) -> None:
    there = {name for _, result in sweep.rows() if result.outcome.solved for name in result.values}
    name = next((one for one in choice if one in there), choice[-1])
    numbers = sweep.values.numbers
    x = np.arange(len(sweep.values.texts), dtype=float) if numbers is None else np.array(numbers)
    if numbers is None:
        panel.set_xticks(x, sweep.values.texts)
    for line, bearing in enumerate(sweep.names):
        y = np.full(x.shape, np.nan)
        for place, result in sweep.rows():
            if result.name == bearing and result.outcome.solved:
                y[place] = result.values.get(name, math.nan)
        order = np.argsort(x)
        marker: dict[str, Any] = (
            {"marker": MARKERS[line // len(LINES) % len(MARKERS)], "markersize": 2.4}
            if x.size <= MOST_MARKED
            else {}
        )
        panel.plot(x[order], in_engineers_unit(name, y[order]), **LINES[line % len(LINES)], **marker)
    if sweep.present is not None and x.min() <= sweep.present <= x.max():
        panel.axvline(sweep.present, color=GREY, linewidth=0.6, linestyle=(0, (1, 2)), zorder=0)
        if titled:
            panel.annotate(
                "as in the file", (sweep.present, 1.0), xycoords=("data", "axes fraction"), xytext=(0, 2),
                textcoords="offset points", fontsize=6, color="0.4", ha="center",
            )  # fmt: skip
    panel.set_ylabel(axis_label(QUANTITIES[name]))
