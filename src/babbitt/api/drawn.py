"""Axes to draw on: those of the user, or of a new figure, in the style of the reports."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from babbitt.report.drawing import MILLIMETRE, style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["MAP", "SQUARE", "drawn"]

MAP, SQUARE = (166.0, 56.0), (95.0, 90.0)
"""Sizes of new figures, mm."""


def drawn(draw: Callable[[Any], None], ax: Axes | None, size: tuple[float, float]) -> Axes:
    """Draw in the style of the reports, on axes that are given or in a figure that a notebook shows."""
    with style():
        if ax is None:
            from matplotlib import pyplot

            inches = (size[0] * MILLIMETRE, size[1] * MILLIMETRE)
            _, ax = pyplot.subplots(figsize=inches, layout="constrained")
        draw(ax)
    return ax
