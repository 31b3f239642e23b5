"""The figure of `babbitt compare`: film, power, flow and temperatures by every method for one bearing."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.quantities import QUANTITIES
from babbitt.core.units import ZERO_CELSIUS
from babbitt.report.comparison_table import spoken
from babbitt.report.drawing import INK, Sheet, axis_label, mathematics
from babbitt.study.comparison import Comparison, Variant

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["drawn_names", "draw_methods", "is_shown", "methods_figure"]

SHOWN = ("minimum_film_thickness", "friction_power", "total_flow")
TEMPERATURES = ("effective_temperature", "outlet_temperature", "maximum_bush_temperature", "maximum_temperature")
MARKS = {"effective_temperature": "|", "outlet_temperature": ">", "maximum_bush_temperature": "s",
         "maximum_temperature": "o"}  # fmt: skip
LEFT, ACROSS, ABOVE = 29.0, 5.0, 7.0
"""Room for the names of methods, between panels, and above them for the legend, mm."""


def methods_figure(comparison: Comparison) -> Figure | None:
    """One row of panels; None where no method has found a film with a temperature."""
    solved = [one for one in comparison.methods if is_shown(one)]
    if not solved:
        return None
    height = 60.0
    figure, axes = Sheet(166.0, height, 1, len(drawn_names(solved)) + 1, left=LEFT, across=ACROSS).panels()
    figure.subplots_adjust(top=1.0 - ABOVE / height)
    draw_methods(axes[0], solved)
    return figure


def drawn_names(variants: Sequence[Variant]) -> list[str]:
    """What has a panel of bars."""
    return [name for name in SHOWN if any(name in one.result.values for one in variants)]


def draw_methods(panels: Sequence[Axes], variants: Sequence[Variant]) -> None:
    """Bars of each of `drawn_names`, then temperatures; one panel more than names."""
    for panel, name in zip(panels, drawn_names(variants), strict=False):
        _bars(panel, variants, name)
    _temperatures(panels[-1], variants)
    for panel in panels[1:]:
        panel.set_yticklabels([])


def is_shown(variant: Variant) -> bool:
    """Whether a variant is a method of its own that has found a film with a temperature; hydrostatic bearings and
    footsteps are compared in the table alone."""
    result = variant.result
    solved = variant.is_method and result.outcome.solved
    return solved and "effective_temperature" in result.values


def _bars(panel: Axes, variants: Sequence[Variant], name: str) -> None:
    quantity = QUANTITIES[name]
    places = np.arange(len(variants))[::-1]
    values = [one.result.values.get(name, math.nan) for one in variants]
    shown = [quantity.shown(value) for value in values]
    panel.barh(places, shown, color="0.75", edgecolor=INK, linewidth=0.5, height=0.6)
    for place, value, length in zip(places, values, shown, strict=True):
        if not math.isnan(value):
            panel.annotate(quantity.format(value), (length, place), xytext=(2, 0), textcoords="offset points",
                           fontsize=7, va="center", annotation_clip=False)  # fmt: skip
    panel.set_yticks(places, [spoken(one.label) for one in variants])
    panel.set_ylim(places[-1] - 0.5, places[0] + 0.5)  # a method without the quantity keeps its row
    panel.set_xlim(0.0, 1.28 * np.nanmax(shown))
    panel.set_xlabel(axis_label(quantity))


def _temperatures(panel: Axes, variants: Sequence[Variant]) -> None:
    places = np.arange(len(variants))[::-1]
    for name in TEMPERATURES:
        if not any(name in one.result.values for one in variants):
            continue
        at = [
            one.result.values[name] - ZERO_CELSIUS if name in one.result.values else math.nan for one in variants
        ]
        panel.plot(at, places, MARKS[name], color=INK, markersize=4.5, fillstyle="none", markeredgewidth=0.9,
                   label=mathematics(QUANTITIES[name].symbol))  # fmt: skip
    panel.set_yticks(places, [])
    panel.set_ylim(places[-1] - 0.5, places[0] + 0.5)
    panel.grid(axis="y", linewidth=0.3, color="0.85")
    panel.set_xlabel("temperatures in °C")
    panel.legend(frameon=False, fontsize=7, ncols=4, loc="lower right", bbox_to_anchor=(1.05, 0.98), borderpad=0.0,
                 handletextpad=0.0, columnspacing=0.4)  # fmt: skip
