"""Fields in shades of grey with lines at round levels, and points marked on them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from babbitt.report.drawing import INK, Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.contour import QuadContourSet
    from matplotlib.figure import Figure

Scale = tuple[list[str], Array]
"""Shades, and the levels between them."""


def levels_of(shown: Array) -> Scale:
    """Shades from pale to dark and the round levels between them."""
    lowest, highest = float(np.nanmin(shown)), float(np.nanmax(shown))
    levels = np.array(round_steps(lowest, highest, 14))
    if levels.size < 2:
        levels = np.array([lowest - 0.5, highest + 0.5])
    return [str(round(1.0 - 0.55 * place / levels.size, 3)) for place in range(levels.size + 1)], levels


def shaded(panel: Axes, x: Array, y: Array, shown: Array, scale: Scale | None = None) -> QuadContourSet:
    """A quantity over two coordinates in shades of grey, with lines at round levels; on its own scale if none is
    given."""
    shades, levels = scale or levels_of(shown)
    panel.contourf(x, y, shown.T, levels=levels, colors=shades, extend="both")
    return panel.contour(x, y, shown.T, levels=levels, colors="0.25", linewidths=0.45)


def bar(figure: Figure, panels: Sequence[Axes], scale: Scale, said: str) -> None:
    """What the shades mean, at the right of panels that stand one above the other."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import BoundaryNorm, ListedColormap

    shades, levels = scale
    map_of_shades = ListedColormap(shades[1:-1]).with_extremes(under=shades[0], over=shades[-1])
    highest, lowest = panels[0].get_position(), panels[-1].get_position()
    room = figure.add_axes((highest.x1 + 0.012, lowest.y0, 0.014, highest.y1 - lowest.y0))
    norm = BoundaryNorm(levels, len(shades) - 2)
    drawn = figure.colorbar(ScalarMappable(norm, map_of_shades), cax=room, extend="both", ticks=levels[::2])
    drawn.outline.set_linewidth(0.4)
    drawn.set_label(said)


def point(panel: Axes, x: float, y: float, text: str) -> None:
    """A cross with a number beside it."""
    panel.plot([x], [y], "+", color=INK, markersize=6, markeredgewidth=0.9, zorder=6, clip_on=False)
    low, high = panel.get_xlim()
    aside = -4 if x > low + 0.9 * (high - low) else 4
    panel.annotate(
        text, (x, y), xytext=(aside, 4), textcoords="offset points", fontsize=7, zorder=6,
        ha="left" if aside > 0 else "right", bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.6},
    )  # fmt: skip


def round_steps(lowest: float, highest: float, about: int) -> list[float]:
    """Round levels between two values.

    >>> round_steps(0.0, 3.2, 6)
    [1.0, 2.0, 3.0]
    >>> round_steps(0.7, 3.2, 5)
    [1.0, 1.5, 2.0, 2.5, 3.0]
    """
    raw = (highest - lowest) / about
    if not raw > 0.0:
        return []
    decade = 10.0 ** math.floor(math.log10(raw))
    step = next(factor * decade for factor in (1.0, 2.0, 2.5, 5.0, 10.0) if factor * decade >= 0.999 * raw)
    first = math.floor(lowest / step * (1.0 + 1e-9)) + 1
    return [round(step * place, 12) for place in range(first, int(highest / step * (1.0 - 1e-9)) + 1)]
