"""What the figures of studies have in common: bearings, panels, labels of axes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.language import translated
from babbitt.report.drawing import Sheet, mathematics
from babbitt.report.study_values import Scale, bearing_text, input_scale
from babbitt.study.rows import Columns
from babbitt.study.study import Study

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = [
    "WIDTH",
    "Drawn",
    "axis_text",
    "bearings_of",
    "file_name",
    "lines_of",
    "of_bearing",
    "panels_for",
    "scaled",
]

Array = NDArray[np.float64]
Drawn = tuple[str, str, "Figure"]
"""Name, caption and figure."""

MOST_BEARINGS = 12

WIDTH = 166.0
"""mm."""


def bearings_of(study: Study) -> list[str]:
    """Bearings of which there are answers, the first ones."""
    return [str(one) for one in dict.fromkeys(study.columns["bearing"]) if one][:MOST_BEARINGS]


def lines_of(columns: Columns, bearing: str) -> Columns:
    """The lines of one bearing."""
    chosen = columns["bearing"] == bearing
    return {name: column[chosen] for name, column in columns.items()}


def file_name(what: str, bearing: str, bearings: list[str]) -> str:
    """Name of the figure of a bearing."""
    return what if len(bearings) == 1 else f"{what}-{bearings.index(bearing) + 1}"


def of_bearing(bearing: str, bearings: list[str]) -> str:
    """Which bearing a caption speaks of; nothing for the only one."""
    return "" if len(bearings) == 1 else translated(" of {bearing}", bearing=bearing_text(bearing))


def axis_text(scale: Scale) -> str:
    """Name and unit at an axis."""
    name = mathematics(scale.name) if scale.quantity else scale.name.replace("$", r"\$")
    return translated("{quantity} in {unit}", quantity=name, unit=scale.unit) if scale.unit else name


def panels_for(count: int, height: float = 46.0, **settings: Any) -> tuple[Figure, list[Axes]]:
    """A figure of so many panels, three in a row."""
    across = min(3, count)
    rows = math.ceil(count / across)
    sheet = Sheet(WIDTH, rows * height, rows, across, left=13.0, bottom=10.0, across=12.0, between=13.0)
    figure, axes = sheet.panels(**settings)
    figure.subplots_adjust(top=1.0 - 6.0 / (rows * height))
    panels = list(axes.ravel())
    for panel in panels[count:]:
        panel.set_axis_off()
    for panel in panels[max(0, count - across) : count]:
        panel.tick_params(labelbottom=True)  # which panels that share an axis have in the last row alone
    return figure, panels[:count]


def scaled(one: Mapping[str, Any], own: Columns) -> Array:
    """The column of an input in the unit in which it is shown."""
    return np.asarray(input_scale(one).shown(own[one["path"]].astype(float)))
