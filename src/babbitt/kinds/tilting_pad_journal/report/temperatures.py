"""Temperatures of pads: of films and bores around the bearing, and of every pad as bars."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.units import ZERO_CELSIUS
from babbitt.kinds.tilting_pad_journal.model import PadCase
from babbitt.kinds.tilting_pad_journal.report.maps import AROUND, angle_ticks, seam, unrolled
from babbitt.report.drawing import GREY, INK, Sheet
from babbitt.report.us_words import numbers_in_us_units
from babbitt.reynolds.tilting_pads.thermal_pad_solution import ThermalTiltingPadSolution

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw_temperatures", "pad_temperatures"]

DASHED = (0, (5, 2))
BARS = (
    ("between pads", "inlet", "white"),
    ("trailing edge", "trailing", "0.85"),
    ("probe", "probe", "0.65"),
    ("highest", "maximum", "0.4"),
)
"""Bars of a pad: name, attribute, shade."""


def pad_temperatures(case: PadCase, found: ThermalTiltingPadSolution) -> Figure:
    """Bores and films over the angle, and four temperatures of every pad."""
    figure, ((left, right),) = Sheet(166.0, 62.0, 1, 2, across=15.0).panels()
    draw_temperatures(left, case, found)
    _bars(right, found)
    return figure


def draw_temperatures(panel: Axes, case: PadCase, found: ThermalTiltingPadSolution) -> None:
    """Temperatures of bores and films over the angle, numbers of the pads at their pivots."""
    start = seam(case, found)
    for number, (state, heat) in enumerate(zip(found.pads, found.temperatures, strict=True), 1):
        theta, order = unrolled(state, start)
        bore, film = ("bore", "film, mean over the gap") if number == 1 else ("", "")
        panel.plot(theta, heat.bore[order] - ZERO_CELSIUS, color=INK, linewidth=1.0, label=bore)
        mean = heat.film_mean[order] - ZERO_CELSIUS
        panel.plot(theta, mean, color=INK, linestyle=DASHED, linewidth=0.9, label=film)
        pivot = math.degrees(start + (found.bearing.pads[number - 1].pivot_angle - start) % math.tau)
        panel.annotate(f"{number}", (pivot, 0.0), xycoords=panel.get_xaxis_transform(), xytext=(0, 6),
                       textcoords="offset points", fontsize=7, ha="center", color="0.3")  # fmt: skip
    if math.isfinite(found.journal_temperature):
        panel.axhline(found.journal_temperature - ZERO_CELSIUS, color=GREY, linewidth=0.8, label="journal")
    low, high = panel.get_ylim()
    panel.set_ylim(low - 0.08 * (high - low), high + 0.3 * (high - low))
    panel.set_xlim(math.degrees(start), math.degrees(start) + 360.0)
    angle_ticks(panel)
    panel.set(xlabel=AROUND, ylabel="$T$ in °C")
    panel.legend(frameon=False, fontsize=7, ncols=2, loc="upper left", handlelength=1.8, columnspacing=1.0)


def _bars(panel: Axes, found: ThermalTiltingPadSolution) -> None:
    numbers = np.arange(1, len(found.pads) + 1)
    width = 0.8 / len(BARS)
    floor = found.heat.supply_temperature - ZERO_CELSIUS
    for place, (name, of, shade) in enumerate(BARS):
        heights = np.array([getattr(heat, of) for heat in found.temperatures]) - ZERO_CELSIUS
        at = numbers + (place - 0.5 * (len(BARS) - 1)) * width
        panel.bar(at, heights - floor, width, bottom=floor, facecolor=shade, edgecolor=INK, linewidth=0.6,
                  label=name)  # fmt: skip
        if of == "maximum":
            for x, height in zip(at, heights, strict=True):
                panel.annotate(numbers_in_us_units(f"{height:.1f}", "°C"), (x, height), xytext=(0, 1.5),
                               textcoords="offset points", fontsize=6.5, ha="center", va="bottom")  # fmt: skip
    highest = found.maximum_temperature - ZERO_CELSIUS
    panel.set_ylim(floor, floor + 1.35 * max(highest - floor, 1e-3))
    panel.set_xticks(numbers)
    panel.tick_params(axis="x", length=0.0)
    panel.set(xlabel="pad", ylabel="$T$ in °C")
    panel.legend(frameon=False, fontsize=7, ncols=4, loc="upper left", handlelength=1.2, columnspacing=0.8,
                 handletextpad=0.4)  # fmt: skip
