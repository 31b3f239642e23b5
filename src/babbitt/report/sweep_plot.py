"""The answers of a sweep as curves."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.files.writing import write_file
from babbitt.core.limited_flow import quantity_held, whole
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.drawing import (
    FORMATS,
    GREY,
    INK,
    Sheet,
    axis_label,
    in_engineers_unit,
    legend_columns,
    rendered,
    style,
)
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

LIMIT: dict[str, Any] = {"color": GREY, "linewidth": 0.7, "linestyle": (0, (1, 1.2)), "zorder": 1}
MOST_LIMITS = 6
"""Lines of limits in a panel."""

NOTE_LINE = 3.5
"""mm."""

LESS_OIL = "Where the supply delivers less oil than the film wants: the film with what it delivers, as judged."

NOT_VALID: dict[str, Any] = {"color": INK, "linestyle": "", "marker": "x", "markersize": 4.0, "zorder": 3}
"""Where a model does not hold, though its curve goes on."""

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


def write_sweep_plot(sweep: CaseSweep, path: Path, chosen: Sequence[str] = ()) -> None:
    """Draw results over the first field and write the figure; the key results, or those that are chosen.

    Raises
    ------
    InputError
        E007 when the file cannot be written or matplotlib is not installed.
    """
    require_plot(path)
    with style():
        image = rendered(sweep_figure(sweep, chosen), path.suffix.lower().removeprefix("."))
    write_file(path, image)


WIDTH, ROW, LEGEND_SIZE = 166.0, 50.0, 7.0
"""Of the figure and of a row of its panels, mm, and of the type of its legend, points."""


@dataclass(frozen=True)
class Curve:
    """Results of one bearing over the first field, all other fields at one value.

    Attributes
    ----------
    label : str
    results : mapping of int to Result
        By the place of the value of the first field; solved ones alone.
    """

    label: str
    results: Mapping[int, Result]


def sweep_figure(sweep: CaseSweep, chosen: Sequence[str] = ()) -> Figure:
    """Panels over the first field, two in a row, a line per bearing and value of the others, and limits.

    What the file itself has in the field is marked.
    """
    curves, shows_stability = _curves(sweep), _shows_stability(sweep)
    labels = [plain_text(curve.label).replace("$", r"\$") for curve in curves]
    labels += ["not stable (broken, open)"] if shows_stability else []
    columns = legend_columns(labels, WIDTH, LEGEND_SIZE)
    legend = 4.5 * math.ceil(len(labels) / columns) if len(labels) > 1 else 0.0
    shown = tuple((name,) for name in chosen) or panels_of([result for _, result in sweep.rows()])
    lacks_oil = any(_of_less_oil(result, choice) for _, result in sweep.rows() for choice in shown)
    notes = [LESS_OIL] * lacks_oil
    if codes := sorted(
        {code for curve in curves for one in curve.results.values() for code in one.invalidating_codes}
    ):
        notes.append(f"×: the model does not hold there ({', '.join(codes)}).")
    below = NOTE_LINE * len(notes)
    rows = math.ceil(len(shown) / 2)
    height = ROW * rows + legend + below
    sheet = Sheet(WIDTH, height, rows, 2, bottom=Sheet.bottom + below, across=16.0, between=5.0)
    figure, axes = sheet.panels(sharex=True)
    figure.subplots_adjust(top=1.0 - (5.0 + legend) / height)
    for panel in axes.ravel()[len(shown) :]:
        panel.set_axis_off()
    for panel, choice in zip(axes.ravel(), shown, strict=False):
        _panel(panel, sweep, curves, choice, titled=panel in axes[0])
    field = sweep.fields[0]
    unit = field.values.unit_shown
    for panel in axes.ravel()[: len(shown)][-2:]:  # the last of each column
        panel.tick_params(labelbottom=True)
        panel.set_xlabel(f"{field.path} in {unit}" if unit else field.path)
    for line, note in enumerate(notes):
        figure.text(
            0.008, 0.006 + line * NOTE_LINE / height, note, ha="left", va="bottom", fontsize=6, color="0.4"
        )
    if legend:
        from matplotlib.lines import Line2D

        handles = axes[0][0].get_lines()[: len(curves)]
        if shows_stability:
            handles = [
                *handles,
                Line2D([], [], color=INK, marker="o", markersize=2.4, markerfacecolor="white", **NOT_STABLE),
            ]
        figure.legend(handles, labels, loc="upper left", ncols=columns, frameon=False, fontsize=LEGEND_SIZE,
                      handlelength=3.2)  # fmt: skip
    return figure


def _of_less_oil(result: Result, choice: Sequence[str]) -> bool:
    """Whether a panel shows the film of a result with the flow that its supply delivers."""
    name = next((one for one in choice if one in result.values), choice[-1])
    return result.outcome.solved and quantity_held(result, name) != name


def _curves(sweep: CaseSweep) -> list[Curve]:
    found: dict[tuple[str, tuple[str, ...]], dict[int, Result]] = {}
    for row, result in sweep.rows():
        texts = sweep.texts(row)[1:]
        points = found.setdefault((result.name, texts), {})
        if result.outcome.solved:
            points[sweep.places(row)[0]] = result
    alone = len(sweep.names) == 1
    return [
        Curve(", ".join(texts if alone and texts else (name, *texts)), points)
        for (name, texts), points in found.items()
    ]


def _panel(
    panel: Axes, sweep: CaseSweep, curves: Sequence[Curve], choice: tuple[str, ...], *, titled: bool
) -> None:
    there = {name for curve in curves for result in curve.results.values() for name in result.values}
    name = next((one for one in choice if one in there), choice[-1])
    values, present = sweep.fields[0].values, sweep.fields[0].present
    numbers = values.numbers
    x = np.arange(len(values.texts), dtype=float) if numbers is None else np.array(numbers)
    if numbers is None:
        panel.set_xticks(x, values.texts)
    if values.logarithmic:
        panel.set_xscale("log")
        _label_plainly(panel)
    order, shows_stability = np.argsort(x), _shows_stability(sweep)
    drawn = [_curve(curve, name, order) for curve in curves]
    for line, (y, lasts) in enumerate(drawn):
        panel.plot(x[order], np.where(lasts, y, np.nan), **_look(line, x.size, shows_stability=shows_stability))
    for line, (y, lasts) in enumerate(drawn):
        if lasts.all():
            continue
        beside = np.convolve(~lasts, (1, 1, 1), mode="same") > 0
        own = _look(line, x.size, shows_stability=shows_stability)
        panel.plot(x[order], np.where(beside, y, np.nan), **{**own, **NOT_STABLE, "marker": ""})
        panel.plot(x[order], np.where(lasts, np.nan, y), **{**own, "linestyle": "", "markerfacecolor": "white"})
    for curve, (y, _) in zip(curves, drawn, strict=True):
        holds = [place not in curve.results or not curve.results[place].invalidating_codes for place in order]
        if not all(holds):
            panel.plot(x[order], np.where(holds, np.nan, y), **NOT_VALID)
    if present is not None and x.min() <= present <= x.max():
        panel.axvline(present, color=GREY, linewidth=0.6, linestyle=(0, (1, 2)), zorder=0)
        if titled:
            panel.annotate(
                "as in the file", (present, 1.0), xycoords=("data", "axes fraction"), xytext=(0, 2),
                textcoords="offset points", fontsize=6, color="0.4", ha="center",
            )  # fmt: skip
    _draw_limits(panel, curves, name, x[order], order)
    panel.set_ylabel(axis_label(QUANTITIES[name]))


def _label_plainly(panel: Axes) -> None:
    """Ticks of a logarithmic axis at 1, 2 and 5 of each decade, as plain numbers."""
    from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

    panel.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    panel.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    panel.xaxis.set_minor_formatter(NullFormatter())


def _draw_limits(panel: Axes, curves: Sequence[Curve], name: str, x: Array, order: Order) -> None:
    """The limits of a quantity that lie near its curves, by their codes.

    Of the flow also what is supplied and needed, where there is one curve: of several, such lines would hide them.
    """
    heights = np.concatenate([_curve(curve, name, order)[0] for curve in curves] or [np.empty(0)])
    if not np.isfinite(heights).any():
        return
    low, high = float(np.nanmin(heights)), float(np.nanmax(heights))
    room = max(high - low, 0.5 * abs(high))
    found: dict[tuple[str, bytes], Array] = {}
    for curve in curves:
        flows = _flows(curve) if name == "total_flow" and len(curves) == 1 else {}
        for label, by_place in (_limits(curve, name) | flows).items():
            y = np.full(order.shape, np.nan)
            for place, limit in by_place.items():
                y[place] = limit
            y = in_engineers_unit(name, y[order])
            near = np.isfinite(y) & (y >= low - room) & (y <= high + room)
            if near.any():
                found[label, np.round(y, 9).tobytes()] = np.where(near, y, np.nan)
    for number, ((label, _), y) in enumerate(list(found.items())[:MOST_LIMITS]):
        panel.plot(x, y, **LIMIT)
        side = -1 if number % 2 == 0 else 0
        end = int(np.flatnonzero(np.isfinite(y))[side])
        panel.annotate(
            label, (x[end], y[end]), xytext=(-1, 1.5), textcoords="offset points", fontsize=6, color="0.3",
            ha="left" if side == 0 else "right",
        )  # fmt: skip


def _limits(curve: Curve, name: str) -> dict[str, dict[int, float]]:
    """Limits of a quantity by the code of their check and the place along the curve."""
    found: dict[str, dict[int, float]] = {}
    for place, result in curve.results.items():
        for check in result.limits:
            if whole(check.quantity) == name:
                found.setdefault(check.code, {})[place] = check.limit
    return found


def _flows(curve: Curve) -> dict[str, dict[int, float]]:
    """Flow that the supply delivers, and that the film needs of it, by the place along the curve."""
    found: dict[str, dict[int, float]] = {}
    for place, result in curve.results.items():
        for check in result.checks:
            if check.quantity == "supply_capacity":
                found.setdefault("supplied", {})[place] = check.value
                found.setdefault("needed", {})[place] = check.limit
    return found


def _curve(curve: Curve, name: str, order: Order) -> tuple[Array, Flags]:
    """A result of one curve in the order of the field, and where its state is not said to be unstable."""
    y, lasts = np.full(order.shape, np.nan), np.full(order.shape, True)
    for place, result in curve.results.items():
        y[place] = result.values.get(quantity_held(result, name), math.nan)
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
