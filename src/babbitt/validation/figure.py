"""Figures of the published cases: one style, readable in grey, and the strip of deviations they share."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from babbitt.validation.case import Comparison, ValidationCase, Verdict
from babbitt.validation.summary import by_quantity

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

INK, GREY, BAND = "#111111", "#707070", "#e4e4e4"
"""Black and grey for lines and points, and the light grey of a tolerance band."""

MARKERS = ("o", "s", "^", "D", "v", "P", "X")
LINES = ("-", "--", "-.", ":", (0, (6, 1, 1, 1, 1, 1)))
"""What tells the members of a family apart without colour."""

_STYLE: dict[Any, Any] = {
    "font.size": 9.0,
    "axes.titlesize": 9.0,
    "axes.labelsize": 9.0,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#ececec",
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "lines.linewidth": 1.1,
    "lines.markersize": 4.0,
    "legend.frameon": False,
    "legend.fontsize": 8.0,
    "legend.handlelength": 2.6,
    "svg.hashsalt": "babbitt",
}


def figure_file(case: ValidationCase) -> str:
    """Name of the file that a case's page refers to."""
    return f"{case.name}.svg"


def figure_of(case: ValidationCase) -> Figure:
    """Draw the figure of a case.

    Needs matplotlib (``pip install '.[report]'`` in a clone).

    Parameters
    ----------
    case : ValidationCase

    Returns
    -------
    matplotlib.figure.Figure
    """
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    with rc_context(_STYLE):
        figure = Figure(figsize=(7.2, 4.4), layout="constrained")
        case.draw(figure)
    return figure


def save_figure(case: ValidationCase, folder: Path) -> Path:
    """Draw the figure of a case and write it into a folder, under the name its page refers to.

    Parameters
    ----------
    case : ValidationCase
    folder : Path
        Must exist.

    Returns
    -------
    Path
        Of the file.
    """
    from matplotlib import rc_context

    target = folder / figure_file(case)
    with rc_context(_STYLE):
        figure_of(case).savefig(target, metadata={"Date": None})
    return target


def eccentricity_axis(axes: Axes) -> None:
    """Stretch both ends of eccentricity, over which films change most: ln(ε/(1 - ε)) is the axis."""
    axes.set_xscale("logit")
    places = (0.1, 0.3, 0.5, 0.7, 0.9, 0.97, 0.99)
    axes.set_xticks(places, [f"{place:g}" for place in places])
    axes.set_xticks([], minor=True)
    axes.tick_params(axis="x", labelsize=8.0)
    axes.set_xlabel("eccentricity ratio ε")


def logarithmic_axis(axes: Axes, places: Sequence[float]) -> None:
    """Logarithmic abscissa with the given numbers written out."""
    axes.set_xscale("log")
    axes.set_xticks(places, [f"{place:g}" for place in places])
    axes.set_xticks([], minor=True)


def draw_deviations(axes: Axes, rows: Sequence[Comparison]) -> None:
    """Draw every deviation in units of its tolerance, a line for each quantity; the band is what is allowed.

    Rows without a tolerance, and one-sided bounds, have no place here.
    """
    two_sided = [row for row in rows if hasattr(row.tolerance, "relative")]
    quantities = list(by_quantity(two_sided))
    axes.axvspan(-1.0, 1.0, color=BAND, zorder=0)
    axes.axvline(0.0, color=GREY, linewidth=0.8)
    for row in two_sided:
        signed = row.share if row.deviation >= 0.0 else -row.share
        judged = row.verdict in (Verdict.AGREES, Verdict.DIFFERS)
        axes.plot(
            signed,
            quantities.index(row.quantity),
            marker="|" if judged else "x",
            markersize=9.0 if judged else 6.0,
            color=INK if judged else GREY,
            linestyle="none",
        )
    axes.set_yticks(range(len(quantities)), quantities)
    axes.set_ylim(len(quantities) - 0.5, -0.5)
    axes.set_xlabel("deviation in units of the tolerance")
    axes.grid(visible=False, axis="y")
