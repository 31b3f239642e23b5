"""The Stribeck curve of a film with its mixed branch."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.kinds.journal.report.plots import plain_ticks
from babbitt.report.drawing import GREY, INK, PALE, Array, Sheet, axis_label, mark, mathematics

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["CAPTION", "stribeck"]

CAPTION = (
    "Friction coefficient over speed at the load of the operating point: film and asperities together (line), the "
    "film alone (pale). Below: share of the load on asperities, and least gap over the composite roughness. "
    "Dotted: asperities carry 1 % of the load; broken: transition by the film thickness of ISO 7902. Filled: the "
    "operating point."
)

SHOWN_FROM = 0.3
"""Share of the least friction at which its axis begins; the film alone falls without end."""


def stribeck(result: Result) -> Figure:
    """Friction, share of the asperities and least gap over the speed."""
    speed, friction, by_film, share, gap = np.array(result.arrays["stribeck"]).T
    rpm = QUANTITIES["angular_speed"].display.scale * speed
    figure, axes = Sheet(81.0, 118.0, 3, 1, left=14.0, between=5.0).panels(sharex=True)
    top, middle, bottom = axes[:, 0]
    top.plot(rpm, by_film, color=PALE)
    top.plot(rpm, friction, color=INK)
    top.set(xscale="log", yscale="log", ylim=(SHOWN_FROM * friction.min(), None))
    top.set_ylabel(axis_label(QUANTITIES["friction_coefficient"]))
    here = QUANTITIES["angular_speed"].shown(abs(result.angular_speed))
    mark(top, here, result.mixed_friction_coefficient)
    middle.plot(rpm, 100.0 * share, color=INK)
    middle.set(ylabel=axis_label(QUANTITIES["asperity_load_share"]), ylim=(0.0, None))
    mark(middle, here, 100.0 * result.asperity_load_share)
    ratio: Array = gap / result.composite_roughness
    bottom.plot(rpm, ratio, color=INK)
    bottom.set(yscale="log", ylabel=axis_label(QUANTITIES["film_parameter"]))
    mark(bottom, here, result.film_parameter)
    bottom.set_xlabel(f"{mathematics('N')} in rpm")
    for panel in (top, bottom):
        plain_ticks(panel.yaxis)
    plain_ticks(bottom.xaxis)
    _transition(top, axes[:, 0], result, "asperity_transition_speed", ":")
    _transition(top, axes[:, 0], result, "transition_speed", "--")
    return figure


def _transition(named: Axes, panels: Array, result: Result, name: str, dashes: str) -> None:
    """A line at a speed of transition, where it is known and within the curve."""
    if name not in result.values:
        return
    quantity = QUANTITIES[name]
    rpm = quantity.shown(result.values[name])
    low, high = named.get_xlim()
    if not low < rpm < high:
        return
    for panel in panels:
        panel.axvline(rpm, color=GREY, linewidth=0.8, linestyle=dashes)
    named.annotate(
        f"{mathematics(quantity.symbol)} = {quantity.with_unit(result.values[name])}",
        (rpm, 0.99 if dashes == ":" else 0.89),
        xycoords=named.get_xaxis_transform(),
        xytext=(3, 0),
        textcoords="offset points",
        va="top",
        fontsize=7,
        color="0.3",
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.3},
    )
