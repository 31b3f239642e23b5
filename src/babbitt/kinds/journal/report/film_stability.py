"""Where a rotor whirls: over load and speed, and without dimension over the load number."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.quantities import QUANTITIES
from babbitt.kinds.journal.film.isothermal import FilmState
from babbitt.kinds.journal.film.model import FilmCase
from babbitt.kinds.journal.film.whirl import mass_of_rotor
from babbitt.kinds.journal.report.plots import plain_ticks
from babbitt.kinds.journal.study.film_points import FilmPoints
from babbitt.kinds.journal.study.stability_map import StabilityMap, mass_number
from babbitt.report.drawing import GREY, INK, Array, Sheet, axis_label, mark
from babbitt.reynolds.stability.rotor import RIGID

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WHIRLS, RESERVES = "0.88", (2.0, 5.0, 10.0)
"""Grey of the unstable region; multiples of the mass of the rotor that are drawn."""

EDGE_OF_WHIRL = 0.5
"""Mass of the rotor over its sum with the critical one where both are equal."""

WORD, ROOM = 2.5, 0.05
"""Width of a word over its height; room around its middle that it takes, as a share of the height of the panel."""

EDGE, NAMED_AT = 0.055, 0.75
"""Shares of the panel: what a name keeps from the edges, and where across it a curve is named if it can be."""

DECADES = 1.5
"""The mass is shown over so many decades to either side of that of the rotor, or as far as the curve goes."""


def stability(case: FilmCase, state: FilmState, found: StabilityMap, by_load: FilmPoints) -> Figure:
    """The map of the rotor of the case, and the chart for rotors of any mass; operating point in both."""
    figure, ((left, right),) = Sheet(166.0, 62.0, 1, 2, across=15.0).panels()
    _map(left, state, found)
    _chart(right, case, state, by_load)
    return figure


def _map(panel: Axes, state: FilmState, found: StabilityMap) -> None:
    rpm, kilo = QUANTITIES["threshold_speed"].display.scale, QUANTITIES["load"].display.scale
    x, y = kilo * found.loads, rpm * found.speeds
    panel.set(xscale="log", yscale="log", xlim=(x[0], x[-1]), ylim=(y[0], y[-1]))
    share = whirl_share(found).T
    if np.ma.count(share):
        panel.contourf(x, y, share, levels=[EDGE_OF_WHIRL, 1.1], colors=[WHIRLS])
    if not found.points.solved.all():
        missing = np.where(found.points.solved.reshape(found.growth.shape), 0.0, 1.0).T
        panel.contourf(x, y, missing, levels=[0.5, 1.5], colors=["none"], hatches=["////"])
    if share.min() < EDGE_OF_WHIRL < share.max():
        panel.contour(x, y, share, levels=[EDGE_OF_WHIRL], colors=[INK], linewidths=[1.1])
    levels = [level for times in reversed(RESERVES) if share.min() < (level := 1.0 / (1.0 + times)) < share.max()]
    if levels:
        lines = panel.contour(x, y, share, levels=levels, colors=["0.6"], linewidths=[0.5])
        places = [place for path in lines.get_paths() if (place := _inside(path.vertices, x, y)) is not None]
        places = [one for n, one in enumerate(places) if all(_apart(one, other, x, y) for other in places[:n])]
        if places:
            panel.clabel(
                lines, fmt=lambda level: f"{1.0 / level - 1.0:.0f} m", fontsize=6, inline_spacing=2, manual=places
            )
    here = kilo * state.load, rpm * abs(state.solution.film.angular_speed)
    _words(panel, x, y, found, here)
    mark(panel, *here)
    panel.set(xlabel=axis_label(QUANTITIES["load"]), ylabel="$N$ in rpm")
    plain_ticks(panel.xaxis)
    plain_ticks(panel.yaxis)


def whirl_share(found: StabilityMap) -> np.ma.MaskedArray[Any, Any]:
    """Mass of the rotor over the sum of it and the critical mass, shape (n, m), masked where there is no film.

    It rises from 0, where no rotor whirls, over 1/2 at the edge of whirl to 1, where every one does: as curves of
    one level each of one finite field, the edge and the multiples of the mass cannot cross.
    """
    share = 1.0 / (1.0 + np.maximum(found.reserve, 0.0))
    sided = np.where(found.stable, np.minimum(share, EDGE_OF_WHIRL - 1e-6), np.maximum(share, EDGE_OF_WHIRL))
    return np.ma.masked_array(sided, ~np.isfinite(found.growth + share))


def _apart(one: tuple[float, float], other: tuple[float, float], x: Array, y: Array) -> bool:
    """Whether two places leave room for a name at each."""
    across = math.log(one[0] / other[0]) / math.log(x[-1] / x[0])
    up = math.log(one[1] / other[1]) / math.log(y[-1] / y[0])
    return math.hypot(across, up) > ROOM


def _inside(curve: Any, x: Array, y: Array) -> tuple[float, float] | None:
    """The place on a curve for its name, right of the middle and off the edges; none where it grazes them only."""
    vertices = np.asarray(curve, dtype=np.float64)
    across = np.log(vertices[:, 0] / x[0]) / math.log(x[-1] / x[0])
    up = np.log(vertices[:, 1] / y[0]) / math.log(y[-1] / y[0])
    free = (np.abs(across - 0.5) < 0.5 - EDGE) & (np.abs(up - 0.5) < 0.5 - EDGE)
    if not free.any():
        return None
    place = int(np.where(free, np.abs(across - NAMED_AT), math.inf).argmin())
    return float(vertices[place, 0]), float(vertices[place, 1])


def _words(panel: Axes, x: Array, y: Array, found: StabilityMap, here: tuple[float, float]) -> None:
    """Name the regions in their middle beside the operating point, as far as they have room for a word."""
    column, row = np.abs(np.log(x / here[0])).argmin(), np.abs(np.log(y / here[1])).argmin()
    film = found.points.solved.reshape(found.growth.shape)
    for text, region in (("stable", found.stable), ("whirls", film & ~found.stable), ("no film", ~film)):
        open_region = region.copy()
        open_region[column, row] = False
        place = _middle(open_region)
        if place is not None:
            panel.annotate(
                text, (x[place[0]], y[place[1]]), fontsize=7, ha="center", va="center", color="0.2",
                bbox={"facecolor": WHIRLS if text == "whirls" else "white", "edgecolor": "none", "pad": 0.8},
            )  # fmt: skip


def _middle(region: NDArray[np.bool_]) -> tuple[int, int] | None:
    """The place of a region that is farthest from its edges; none where the region has no room for a word."""
    from scipy.ndimage import distance_transform_edt

    columns, rows = region.shape  # of a panel about as wide as high
    depth = distance_transform_edt(np.pad(region, 1), sampling=(1.0 / (WORD * columns), 1.0 / rows))[1:-1, 1:-1]
    column, row = np.unravel_index(int(depth.argmax()), depth.shape)
    return (int(column), int(row)) if depth[column, row] > ROOM else None


def _label_next_to(panel: Axes, place: tuple[float, float], text: str) -> None:
    settings: dict[str, Any] = {"textcoords": "offset points", "fontsize": 7, "color": "0.3", "ha": "right"}
    panel.annotate(text, place, xytext=(-3, 3), annotation_clip=True, **settings)


def _chart(panel: Axes, case: FilmCase, state: FilmState, by_load: FilmPoints) -> None:
    film, mass = state.solution.film, mass_of_rotor(case, state.load)
    speed = abs(film.angular_speed)
    here = mass * film.clearance * speed**2 / state.load
    shaft = case.shaft_stiffness if case.shaft_stiffness is not None else RIGID
    order = np.argsort(by_load.sommerfeld_number)
    numbers = by_load.sommerfeld_number[order]
    least, critical = (mass_number(bound, by_load)[order] for bound in by_load.stable_masses(shaft))
    known = np.isfinite(critical) & (critical > 0.0)
    low, high = here / 10.0**DECADES, here * 10.0**DECADES
    if known.any():
        low, high = min(low, 0.5 * critical[known].min()), max(high, 3.0 * float(np.median(critical[known])))
    panel.set(xscale="log", yscale="log", xlim=(numbers[0], numbers[-1]), ylim=(low, high))
    edge = np.clip(critical, low, high)
    panel.fill_between(numbers, edge, high, where=(critical < math.inf).tolist(), color=WHIRLS, linewidth=0.0)
    panel.plot(numbers[known], critical[known], color=INK)
    if (reversed_there := (least > 0.0) & (least < math.inf)).any():  # light rotors whirl there
        below = np.clip(least, low, high)
        panel.fill_between(numbers, low, below, where=reversed_there.tolist(), color=WHIRLS, linewidth=0.0)
        panel.plot(numbers[reversed_there], least[reversed_there], color=INK)
    if shaft != RIGID:
        rigid = mass_number(by_load.critical_mass(), by_load)[order]
        seen = np.isfinite(rigid) & (rigid > 0.0)
        panel.plot(numbers[seen], rigid[seen], color=GREY, linestyle=(0, (5, 2)), linewidth=0.8)
        if seen.any():
            end = numbers[seen][-1], rigid[seen][-1]
            _label_next_to(panel, end, "rigid")
    at = numbers[0] * (numbers[-1] / numbers[0]) ** 0.15
    border = float(np.exp(np.interp(math.log(at), np.log(numbers), np.log(edge))))
    for text, level in (("whirls", math.sqrt(border * high)), ("stable", math.sqrt(border * low))):
        if low * 1.3 < level < high / 1.3:
            panel.annotate(text, (at, level), fontsize=7, ha="center", va="center", color="0.2")
    mark(panel, state.solution.sommerfeld_number, here)
    panel.set(xlabel=axis_label(QUANTITIES["sommerfeld_number"]), ylabel="$m\\,c\\,ω^2/F$")
    plain_ticks(panel.xaxis)
    plain_ticks(panel.yaxis)
