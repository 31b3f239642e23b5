"""The answers of a sweep as curves."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.files.writing import write_file
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.report.drawing import FORMATS, GREY, INK, Sheet, axis_label, in_engineers_unit, rendered, style
from babbitt.report.sweep_columns import panels_of
from babbitt.report.text import plain_text
from babbitt.study.case_sweep import CaseSweep

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Order = NDArray[np.intp]
Flags = NDArray[np.bool_]

LINES: tuple[dict[str, Any], ...] = tuple(
    {"color": colour, "linestyle": dashes}
    for dashes in ("-", (0, (6, 1.5)), (0, (2, 1.5)), (0, (6, 1.5, 1, 1.5)))
    for colour in (INK, GREY)
)
"""So many bearings can be distinguished; more share lines."""

MARKERS = ("o", "s", "^")
"""Where there are more bearings than lines."""

MOST_MARKED = 25
"""Points of a curve that are still marked one by one."""

NOT_STABLE: dict[str, Any] = {"linestyle": (0, (3.5, 1.5))}
"""Where steady states are stable or not, broken lines say just that; colours and markers tell the states."""


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
    write_file(path, image)


def sweep_figure(sweep: CaseSweep) -> Figure:
    """At most four panels over the field, a line per bearing; what the file itself has in the field is marked."""
    names, shows_stability = sweep.names, _shows_stability(sweep)
    entries = len(names) + shows_stability
    legend = 4.5 * math.ceil(entries / 3) if entries > 1 else 0.0
    height = 100.0 + legend
    figure, axes = Sheet(166.0, height, 2, 2, across=16.0, between=5.0).panels(sharex=True)
    figure.subplots_adjust(top=1.0 - (5.0 + legend) / height)
    shown = panels_of([result for _, result in sweep.rows()])
    for panel in axes.ravel()[len(shown) :]:
        panel.set_axis_off()
    for panel, choice in zip(axes.ravel(), shown, strict=False):
        _panel(panel, sweep, choice, titled=panel in axes[0])
    for panel in axes[1]:
        unit = sweep.values.unit_shown
        panel.set_xlabel(f"{sweep.path} in {unit}" if unit else sweep.path)
    if legend:
        from matplotlib.lines import Line2D

        handles = axes[0][0].get_lines()[: len(names)]
        labels = [plain_text(name).replace("$", r"\$") for name in names]
        if shows_stability:
            handles = [
                *handles,
                Line2D([], [], color=INK, marker="o", markersize=2.4, markerfacecolor="white", **NOT_STABLE),
            ]
            labels.append("not stable (broken, open)")
        figure.legend(handles, labels, loc="upper left", ncols=3, frameon=False, fontsize=7, handlelength=3.2)
    return figure


def _panel(panel: Axes, sweep: CaseSweep, choice: tuple[str, ...], *, titled: bool) -> None:
    there = {name for _, result in sweep.rows() if result.outcome.solved for name in result.values}
    name = next((one for one in choice if one in there), choice[-1])
    numbers = sweep.values.numbers
    x = np.arange(len(sweep.values.texts), dtype=float) if numbers is None else np.array(numbers)
    if numbers is None:
        panel.set_xticks(x, sweep.values.texts)
    order, shows_stability = np.argsort(x), _shows_stability(sweep)
    curves = [_curve(sweep, bearing, name, order) for bearing in sweep.names]
    for line, (y, lasts) in enumerate(curves):
        panel.plot(x[order], np.where(lasts, y, np.nan), **_look(line, x.size, shows_stability=shows_stability))
    for line, (y, lasts) in enumerate(curves):
        if lasts.all():
            continue
        beside = np.convolve(~lasts, (1, 1, 1), mode="same") > 0
        own = _look(line, x.size, shows_stability=shows_stability)
        panel.plot(x[order], np.where(beside, y, np.nan), **{**own, **NOT_STABLE, "marker": ""})
        panel.plot(x[order], np.where(lasts, np.nan, y), **{**own, "linestyle": "", "markerfacecolor": "white"})
    if sweep.present is not None and x.min() <= sweep.present <= x.max():
        panel.axvline(sweep.present, color=GREY, linewidth=0.6, linestyle=(0, (1, 2)), zorder=0)
        if titled:
            panel.annotate(
                "as in the file", (sweep.present, 1.0), xycoords=("data", "axes fraction"), xytext=(0, 2),
                textcoords="offset points", fontsize=6, color="0.4", ha="center",
            )  # fmt: skip
    panel.set_ylabel(axis_label(QUANTITIES[name]))


def _curve(sweep: CaseSweep, bearing: str, name: str, order: Order) -> tuple[Array, Flags]:
    """A result of one bearing in the order of the field, and where its state is not said to be unstable."""
    y, lasts = np.full(order.shape, np.nan), np.full(order.shape, True)
    for place, result in sweep.rows():
        if result.name == bearing and result.outcome.solved:
            y[place] = result.values.get(name, math.nan)
            lasts[place] = result.settings.get("stable") != "no"
    return in_engineers_unit(name, y[order]), lasts[order]


def _look(line: int, points: int, *, shows_stability: bool) -> dict[str, Any]:
    """Colour, dashes and markers of a bearing; of a steady state without dashes."""
    if shows_stability:
        marker = {
            "marker": MARKERS[line % len(MARKERS)],
            "markersize": 2.4,
            "markevery": max(1, points // MOST_MARKED),
        }
        return {"color": (INK, GREY)[line % 2], "linestyle": "-", **marker}
    if points > MOST_MARKED:
        return LINES[line % len(LINES)]
    return LINES[line % len(LINES)] | {"marker": MARKERS[line // len(LINES) % len(MARKERS)], "markersize": 2.4}


def _shows_stability(sweep: CaseSweep) -> bool:
    """Whether some state of the sweep is said not to be stable."""
    return any(result.settings.get("stable") == "no" for _, result in sweep.rows())
