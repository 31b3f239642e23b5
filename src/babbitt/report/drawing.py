"""The style of figures: typeset, readable in grey, vector, the same on every machine."""

from __future__ import annotations

import io
import math
from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.files.marks import CREATOR
from babbitt.core.language import ENGLISH, language, translated
from babbitt.core.notices import InputError
from babbitt.core.optional_package import how_to_install
from babbitt.core.quantities import QUANTITIES, Quantity
from babbitt.core.quantities.display import is_spoken

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

MILLIMETRE = 1.0 / 25.4
"""In inches, the unit of matplotlib."""

INK, GREY, PALE = "0.0", "0.45", "0.75"
"""Lines of the bearing itself, of limits and references, of what stands beside it for comparison."""

STYLE: dict[Any, Any] = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 8.0,
    "axes.labelsize": 8.0,
    "axes.linewidth": 0.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.unicode_minus": True,
    "xtick.labelsize": 7.0,
    "ytick.labelsize": 7.0,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.major.width": 0.5,
    "ytick.major.width": 0.5,
    "xtick.minor.width": 0.3,
    "ytick.minor.width": 0.3,
    "lines.linewidth": 1.1,
    "lines.markersize": 4.5,
    "hatch.linewidth": 0.35,
    "hatch.color": "0.35",
    "savefig.facecolor": "none",
    "svg.fonttype": "path",
    "svg.hashsalt": "babbitt",
    "pdf.fonttype": 42,
}

FORMATS = ("svg", "pdf", "png")

_UNDATED: dict[str, dict[str, Any]] = {
    "svg": {"Date": None, "Creator": CREATOR},
    "pdf": {"CreationDate": None, "Producer": None, "Creator": CREATOR},
    "png": {"Software": CREATOR},
}


def require_format(image_format: str) -> None:
    """Refuse a format that no figure has, with E007."""
    if image_format not in FORMATS:
        raise InputError("E007", f"no figures as {image_format!r}; there are {', '.join(FORMATS)}")


@dataclass(frozen=True)
class Drawing:
    """A finished figure.

    Attributes
    ----------
    name : str
        Short, for a file name.
    caption : str
        What it shows, in a sentence or two.
    image : bytes
        In the format asked for.
    wide : bool
        Whether it takes the width of a page rather than half of it.
    """

    name: str
    caption: str
    image: bytes
    wide: bool = False


@contextmanager
def style() -> Iterator[None]:
    """Draw in the style of the reports, leaving matplotlib as it was.

    Raises
    ------
    InputError
        E007 when matplotlib is not installed.
    """
    try:
        import matplotlib
    except ImportError:
        raise missing_extra("matplotlib", "plots") from None
    with matplotlib.rc_context(STYLE):
        yield


def require_extra(package: str, purpose: str) -> None:
    """Refuse what needs a package that is not installed, before any work is done.

    Raises
    ------
    InputError
        E007.
    """
    if find_spec(package) is None:
        raise missing_extra(package, purpose)


def missing_extra(package: str, purpose: str) -> InputError:
    """The error for an extra that is not installed."""
    return InputError(
        "E007",
        f"{purpose} need the package {package}, which is not installed. {how_to_install(package, 'report')}",
    )


@dataclass(frozen=True)
class Sheet:
    """Size of a figure and room around and between its panels, in mm.

    Fixed margins keep panels of different figures in line on a page, and spare the search for a layout.
    """

    width: float
    height: float
    rows: int = 1
    columns: int = 1
    left: float = 13.0
    bottom: float = 9.5
    across: float = 4.0
    between: float = 4.0

    def panels(self, **settings: Any) -> tuple[Figure, Any]:
        """The empty figure and its axes, an array of shape (rows, columns)."""
        from matplotlib.figure import Figure

        figure = Figure(figsize=(self.width * MILLIMETRE, self.height * MILLIMETRE))
        panel_width = (self.width - self.left - 3.0 - (self.columns - 1) * self.across) / self.columns
        panel_height = (self.height - self.bottom - 3.0 - (self.rows - 1) * self.between) / self.rows
        axes = figure.subplots(self.rows, self.columns, squeeze=False, **settings)
        figure.subplots_adjust(
            left=self.left / self.width,
            right=1.0 - 3.0 / self.width,
            bottom=self.bottom / self.height,
            top=1.0 - 3.0 / self.height,
            wspace=self.across / panel_width,
            hspace=self.between / panel_height,
        )
        return figure, axes


def rendered(figure: Figure, image_format: str, own_words: Collection[str] = ()) -> bytes:
    """Write a figure without any date, so that equal figures are equal bytes; in the language and units
    of the report. Words of the case, such as paths of its fields, are named: they stay."""
    if is_spoken("us"):
        from babbitt.report.us_figure import turn_figure

        turn_figure(figure)
    if language() != ENGLISH:
        from babbitt.report.figure_words import translate_figure

        translate_figure(figure, own_words)
    target = io.BytesIO()
    figure.savefig(target, format=image_format, dpi=200, metadata=_UNDATED[image_format])
    return target.getvalue()


LETTER, HANDLE = 0.19, 13.0
"""Width of a letter over the size of its type, mm per point, and of what stands before a name in a legend, mm."""


def legend_columns(names: Sequence[str], width: float, size: float, most: int = 3) -> int:
    """Columns of a legend that fit into a width in mm, with a type size in points.

    >>> legend_columns(["minimum", "maximum"], 166.0, 7.0), legend_columns(["bearing " * 6] * 3, 166.0, 7.0)
    (3, 2)
    """
    longest = max(map(len, names), default=0)
    return max(1, min(most, int(width / (HANDLE + LETTER * size * longest))))


def axis_label(quantity: Quantity) -> str:
    """Symbol and unit, as mathematics: ``h_min in µm``."""
    symbol = mathematics(quantity.symbol)
    if not quantity.display.label:
        return symbol
    return translated("{quantity} in {unit}", quantity=symbol, unit=quantity.display.label)


LOW_DIGITS = {chr(0x2080 + digit): str(digit) for digit in range(10)}
"""Digits that stand low in plain text."""


def mathematics(symbol: str) -> str:
    """A symbol of the vocabulary in the mathematics of matplotlib.

    >>> mathematics("h_min"), mathematics("ε")
    ('$h_\\\\mathrm{min}$', '$ε$')
    >>> mathematics("p₁")
    '$p_\\\\mathrm{1}$'
    """
    base, _, subscript = symbol.partition("_")
    if base[-1:] in LOW_DIGITS and not subscript:
        base, subscript = base[:-1], LOW_DIGITS[base[-1]]
    base = rf"\mathrm{{{base}}}" if base in ("So", "Re") else base.replace("p\u0304", r"\bar{p}")
    return f"${base}_\\mathrm{{{subscript}}}$" if subscript else f"${base}$"


def in_engineers_unit(name: str, values: Array) -> Array:
    """SI values of a named quantity in its engineer's unit, of the same shape."""
    display = QUANTITIES[name].display
    return values * display.scale + display.offset


def mark(axes: Axes, x: float, y: float) -> None:
    """The operating point."""
    axes.plot([x], [y], "o", color=INK, zorder=5, clip_on=False)


def arrow(
    axes: Axes, tip: tuple[float, float], tail: tuple[float, float], *, size: float = 7.0, colour: str = INK
) -> None:
    """An arrow between two places of the data; `size` in points is that of its head."""
    drawn = {"arrowstyle": "-|>", "linewidth": 0.12 * size, "color": colour, "mutation_scale": size}
    axes.annotate("", tip, xytext=tail, zorder=6, arrowprops={**drawn, "shrinkA": 0, "shrinkB": 0})


def limit_line(axes: Axes, y: float, label: str, *, at: float = 0.99, beside: float = -math.inf) -> None:
    """A horizontal limit with its name on it, `at` a fraction of the width, away from a curve at ``beside``."""
    under = beside >= y
    axes.axhline(y, color=GREY, linewidth=0.7, linestyle=(0, (5, 2)), zorder=1)
    axes.annotate(
        label,
        (at, y),
        xycoords=axes.get_yaxis_transform(),
        xytext=(0, -1.5 if under else 1.5),
        textcoords="offset points",
        ha="right" if at > 0.5 else "left",
        va="top" if under else "bottom",
        fontsize=7,
        color="0.3",
    )


def spread_levels(values: Sequence[float], apart: float) -> list[float]:
    """Levels in the order of rising values, at least `apart` from each other and as near to the values as can be.

    The least sum of squared distances: values too close share their distance to both sides (pool adjacent
    violators).
    """
    pools: list[tuple[float, int]] = []  # mean of value less its place in the row, and how many
    for place, value in enumerate(values):
        mean, size = value - place * apart, 1
        while pools and pools[-1][0] > mean:
            before, count = pools.pop()
            mean, size = (mean * size + before * count) / (size + count), size + count
        pools.append((mean, size))
    means = [mean for mean, size in pools for _ in range(size)]
    return [mean + place * apart for place, mean in enumerate(means)]
