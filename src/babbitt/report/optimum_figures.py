"""The figures of an optimisation: front, designs in parallel coordinates, or the objective over a single field."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.language import listed, translated
from babbitt.report.drawing import GREY, INK, PALE, Sheet, mathematics
from babbitt.report.study_panels import WIDTH, Drawn, axis_text, scaled
from babbitt.report.study_values import Scale, input_scale, output_scale
from babbitt.report.text import plain_text
from babbitt.study.optimum import KEPT, Optimum, designs, optimum_of
from babbitt.study.rows import Columns
from babbitt.study.study import Study

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["optimum_figures"]

Array = NDArray[np.float64]

MOST_LINES = 400
"""Designs that parallel coordinates show, the last ones."""


def optimum_figures(study: Study) -> Iterator[Drawn]:
    """The front of two objectives and the designs; of one field and one objective the one over the other."""
    found = optimum_of(study)
    if not found.rows:
        return
    varying = [one for one in study.inputs if len(set(study.columns[one["path"]].tolist())) > 1]
    if len(varying) == len(found.objectives) == 1:
        path, goal = plain_text(varying[0]["path"]), plain_text(output_scale(found.objectives[0]).name)
        said = translated(
            "{goal} over {field}: designs within all limits (filled), beyond one (crosses), the best (ringed).",
            goal=goal,
            field=path,
        )
        yield "designs", said, _over_field(designs(study), varying[0], found)
        return
    if len(found.objectives) > 1:
        said = translated(
            "Pareto front: of {number} designs within all limits (pale) no other is better in both.",
            number=found.feasible,
        )
        yield "pareto", said, _front(study, found)
    axes, alike = _axes_of(study, designs(study))
    if len(axes) > 1:
        caption = translated(
            "Designs within all limits in parallel coordinates, each axis from its least to its largest value; "
            "black: the best ones."
        )
        if alike:
            caption += translated(
                " All these designs have the same: {values}.", values=listed(map(plain_text, alike))
            )
        yield "designs", caption, _parallel(study, found.rows, axes)


def _front(study: Study, found: Optimum) -> Figure:
    goals = [output_scale(name) for name in found.objectives]
    figure, axes = Sheet(110.0, 76.0, left=16.0, bottom=11.0).panels()
    panel = axes[0][0]
    every = designs(study)
    x, y = (
        scale.shown(every[name][every[KEPT]]) for scale, name in zip(goals[:2], found.objectives, strict=False)
    )
    panel.plot(x, y, ".", color=PALE, markersize=3.0)
    front = [scale.shown(found.values[:, place]) for place, scale in enumerate(goals[:2])]
    order = np.argsort(front[0])
    panel.plot(front[0][order], front[1][order], "o-", color=INK, markersize=3.5, linewidth=0.8)
    _name_choices(panel, study, found, front)
    panel.set_xlabel(axis_text(goals[0]))
    panel.set_ylabel(axis_text(goals[1]))
    return figure


def _name_choices(panel: Axes, study: Study, found: Optimum, front: Sequence[Array]) -> None:
    """Write beside each point of a front which choice it is, where a single field of words varies."""
    if len(study.inputs) > 1 or "values" not in study.inputs[0]:
        return
    for place, row in enumerate(found.rows):
        line = int(np.flatnonzero(study.columns["row"] == row)[0])
        word = plain_text(str(study.columns[study.inputs[0]["path"]][line]))
        panel.annotate(
            word, (front[0][place], front[1][place]), xytext=(4, 3), textcoords="offset points", fontsize=6
        )
    panel.margins(x=0.15)


def _over_field(own: Columns, about: Mapping[str, Any], found: Optimum) -> Figure:
    """The objective over the one field that varies."""
    (name,) = found.objectives
    scale, goal = input_scale(about), output_scale(name)
    figure, axes = Sheet(110.0, 70.0, left=16.0, bottom=11.0).panels()
    panel = axes[0][0]
    if "values" in about:
        words = [str(one) for one in about["values"]]
        x = np.array([words.index(str(one)) for one in own[about["path"]]], float)
        panel.set_xticks(range(len(words)), [plain_text(word) for word in words])
        panel.set_xlim(-0.5, len(words) - 0.5)
    else:
        x = scaled(about, own)
    y = goal.shown(own[name])
    kept, best = own[KEPT], np.isin(own["row"], found.rows)
    panel.plot(x[kept], y[kept], "o", color=INK, markersize=3.0)
    panel.plot(x[~kept], y[~kept], "x", color=GREY, markersize=4.0, markeredgewidth=0.8)
    panel.plot(x[best], y[best], "o", color=INK, markersize=8.0, markerfacecolor="none", markeredgewidth=0.9)
    panel.margins(y=0.12)
    panel.set_xlabel(axis_text(scale))
    panel.set_ylabel(axis_text(goal))
    return figure


def _axes_of(study: Study, own: Columns) -> tuple[dict[str, tuple[Scale, Array, tuple[str, ...]]], list[str]]:
    """Axes of fields and objectives with the height of every line and their labels, and names that do not vary."""
    kept = own[KEPT]
    scales = {one["path"]: input_scale(one) for one in study.inputs}
    scales |= {name: output_scale(name) for name in (*study.block.minimise, *study.block.maximise)}
    words = {one["path"]: one.get("values", ()) for one in study.inputs}
    axes: dict[str, tuple[Scale, Array, tuple[str, ...]]] = {}
    alike = []
    for name, scale in scales.items():
        values, labels = _column(own[name], scale, kept, words.get(name, ()))
        low, high = np.nanmin(values[kept]), np.nanmax(values[kept])
        if high > low:
            axes[name] = scale, (values - low) / (high - low), labels
        else:
            alike.append(f"{scale.name} {scale.text(own[name][kept][0])} {scale.unit}".strip())
    return axes, alike


def _column(
    column: NDArray[Any], scale: Scale, kept: NDArray[np.bool_], words: Sequence[str]
) -> tuple[Array, tuple[str, ...]]:
    """Numbers of a column, and what stands along its axis: the words that are left, or least and largest value."""
    if column.dtype == object:
        there = [word for word in words if word in set(column[kept])]
        places = {word: place for place, word in enumerate(there)}
        return np.array([places.get(one, np.nan) for one in column], float), tuple(there)
    values = column.astype(float)
    return values, (scale.text(np.nanmin(values[kept])), scale.text(np.nanmax(values[kept])))


def _parallel(
    study: Study, best: tuple[int, ...], axes_of: Mapping[str, tuple[Scale, Array, tuple[str, ...]]]
) -> Figure:
    """Parallel coordinates of fields and objectives."""
    own = designs(study)
    kept = np.flatnonzero(own[KEPT])[-MOST_LINES:]
    figure, axes = Sheet(WIDTH, 70.0, left=10.0, bottom=16.0).panels()
    panel = axes[0][0]
    lines = np.array([heights for _, heights, _ in axes_of.values()])
    for place in kept:
        panel.plot(lines[:, place], color=PALE, linewidth=0.4, zorder=1)
    for place in np.flatnonzero(np.isin(own["row"], best)):
        panel.plot(lines[:, place], color=INK, linewidth=1.0, zorder=2)
    for place, (_, _, labels) in enumerate(axes_of.values()):
        panel.axvline(place, color=GREY, linewidth=0.5, zorder=0)
        for at, end in ((-0.06, labels[0]), (1.03, labels[-1])):
            panel.annotate(plain_text(end), (place, at), ha="center", fontsize=6, annotation_clip=False)
        for number, word in enumerate(labels[1:-1], 1):
            at = number / (len(labels) - 1)
            panel.annotate(
                plain_text(word), (place, at), xytext=(2, 0), textcoords="offset points", va="center", fontsize=6
            )
    labels_below = [
        f"{mathematics(scale.name) if scale.quantity else scale.name}\n{scale.unit}".strip()
        for scale, _, _ in axes_of.values()
    ]
    panel.set_xticks(range(len(axes_of)), labels_below)
    panel.tick_params(axis="x", pad=9, length=0)
    panel.set_yticks([])
    panel.set_ylim(0.0, 1.08)
    return figure
