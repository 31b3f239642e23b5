"""The figures of a study: histograms with limits, tornado, pairs, maps with limit lines, Pareto front, curves."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.files.writing import write_files
from babbitt.core.language import decimal, translated
from babbitt.core.limited_flow import whole
from babbitt.report.design_figure import design_figures
from babbitt.report.drawing import GREY, INK, PALE, Drawing, legend_columns, mathematics, rendered, style
from babbitt.report.optimum_figures import optimum_figures
from babbitt.report.size_output import size_figure
from babbitt.report.size_table import size_scale
from babbitt.report.study_content import SAMPLING
from babbitt.report.study_map import map_figures
from babbitt.report.study_panels import (
    Drawn,
    axis_text,
    bearings_of,
    file_name,
    lines_of,
    of_bearing,
    panels_for,
    scaled,
)
from babbitt.report.study_values import bearing_text, input_scale, output_scale
from babbitt.report.text import plain_text
from babbitt.study.grids import SAMPLE
from babbitt.study.held_film import as_read
from babbitt.study.indices import Indices, indices_of
from babbitt.study.rows import Columns
from babbitt.study.size import size_of
from babbitt.study.study import Study
from babbitt.study.yields import WITHIN, tolerance_summary

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["study_drawings", "write_study_plots"]

Array = NDArray[np.float64]
MOST_PANELS = 6
MOST_CURVES = 8
CLASSES = 30

LEGEND_LINE, MM_PER_INCH = 3.5, 25.4
"""mm."""


def study_drawings(study: Study, image_format: str) -> tuple[Drawing, ...]:
    """All figures of a study, of the films that limits are held against.

    Raises
    ------
    InputError
        E007 when matplotlib is not installed.
    """
    study = as_read(study)
    own_words = {
        word for one in study.inputs for word in (one["path"], axis_text(input_scale(one)), *one.get("values", ()))
    }
    own_words |= set(study.columns["bearing"]) | set(study.columns["group"])
    with style():
        return tuple(
            Drawing(name, caption, rendered(figure, image_format, own_words), wide=True)
            for name, caption, figure in _OF_KIND[study.kind](study)
        )


def write_study_plots(study: Study, folder: Path) -> tuple[Path, ...]:
    """Write the figures into a folder, as SVG and PNG; where they are now.

    Raises
    ------
    InputError
        E007 when a file cannot be written or matplotlib is not installed.
    """
    files: dict[str, bytes] = {}
    for ending in ("svg", "png"):
        files |= {f"{one.name}.{ending}": one.image for one in study_drawings(study, ending)}
    return write_files(folder, files)


def _tolerance(study: Study) -> Iterator[Drawn]:
    bearings = bearings_of(study)
    summary = tolerance_summary(study)
    drawn = translated(SAMPLING[study.block.sampling])
    for bearing in bearings:
        own = lines_of(study.of(SAMPLE), bearing)
        of = of_bearing(bearing, bearings)
        caption = translated(
            "Scatter of the results{of} over {number} samples ({drawn}); limits broken, where one is the same in "
            "all samples that of the medians; hatched: beyond a limit of this result.",
            of=of,
            number=own["row"].size,
            drawn=drawn,
        )
        names = [name for name in study.outputs if np.isfinite(own[name]).any()] or list(study.outputs[:1])
        for page, together in enumerate(np.array_split(names, math.ceil(len(names) / MOST_PANELS)), 1):
            what = "histograms" if page == 1 else f"histograms_{page}"
            yield file_name(what, bearing, bearings), caption, _histograms(study, own, together.tolist())
        shares = {name: by for (of_bearing, name), by in summary.tornado.items() if of_bearing == bearing}
        if any(shares.values()):
            caption = translated(
                "What drives the scatter{of}: squared rank correlation of each field with each result; "
                "pale: the result falls as the field rises.",
                of=of,
            )
            yield file_name("tornado", bearing, bearings), caption, _tornado(shares)
        pairs = [one for one in study.inputs if "values" not in one][:4]
        if len(pairs) > 1:
            caption = translated(
                "Samples{of} within all limits (pale) and outside (crosses), over pairs of fields.", of=of
            )
            yield file_name("pairs", bearing, bearings), caption, _pairs(pairs, own)


def _histograms(study: Study, own: Columns, names: Sequence[str]) -> Figure:
    figure, panels = panels_for(len(names))
    for panel, name in zip(panels, names, strict=False):
        scale = output_scale(name)
        values = scale.shown(own[name][np.isfinite(own[name])])
        limits = [one for one in study.description["checks"] if whole(one["quantity"]) == name]
        counts, edges = np.histogram(values, CLASSES)
        middle = 0.5 * (edges[1:] + edges[:-1])
        beyond = np.zeros(CLASSES, bool)
        for one in limits:
            limit = scale.shown(one["limit"])
            beyond |= middle > limit if one["bound"] == "<=" else middle < limit
            span = edges[-1] - edges[0]
            if edges[0] - 0.5 * span <= limit <= edges[-1] + 0.5 * span:
                panel.axvline(limit, color=GREY, linewidth=0.8, linestyle=(0, (5, 2)))
                panel.annotate(
                    one["code"], (limit, 1.0), xycoords=("data", "axes fraction"), xytext=(0, 1.5),
                    textcoords="offset points", ha="center", fontsize=6, color="0.3",
                )  # fmt: skip
        width = edges[1] - edges[0]
        panel.bar(middle[~beyond], counts[~beyond], width, color=PALE)
        panel.bar(middle[beyond], counts[beyond], width, color="white", edgecolor=INK, linewidth=0.3, hatch="////")
        panel.set_xlabel(axis_text(scale))
        panel.set_ylabel(translated("samples"))
    return figure


def _tornado(shares: Mapping[str, Mapping[str, float]]) -> Figure:
    varying = [name for name, by in shares.items() if any(map(math.isfinite, by.values()))]
    names = sorted(varying, key=lambda name: name != "margin")[:MOST_PANELS]
    figure, panels = panels_for(max(1, len(names)), sharex=True)
    for panel, name in zip(panels, names, strict=False):
        by = {path: share for path, share in shares[name].items() if math.isfinite(share)}
        order = sorted(by, key=lambda path: abs(by[path]))
        colours = [INK if by[path] >= 0.0 else PALE for path in order]
        panel.barh(range(len(order)), [100.0 * abs(by[path]) for path in order], color=colours, height=0.35)
        _named_bars(panel, order)
        title = translated(name) if name == "margin" else mathematics(output_scale(name).name)
        panel.set_title(title, fontsize=8, pad=3)
        panel.set_xlim(0.0, 100.0)
        panel.set_xlabel("%")
    return figure


def _named_bars(panel: Axes, names: Sequence[str]) -> None:
    """Names of horizontal bars above them, where no length of a name takes room of the panel."""
    panel.set_yticks([])
    panel.set_ylim(-0.5, len(names) - 0.15)
    for place, name in enumerate(names):
        panel.annotate(
            plain_text(name), (0.01, place + 0.24), xycoords=("axes fraction", "data"), va="bottom", fontsize=6
        )


def _pairs(inputs: list[dict[str, Any]], own: Columns) -> Figure:
    couples = [(one, other) for place, one in enumerate(inputs) for other in inputs[place + 1 :]][:MOST_PANELS]
    figure, panels = panels_for(len(couples))
    within = np.isin(own["verdict"], WITHIN)
    few = slice(0, 4000)  # more points only blacken the panel
    for panel, (one, other) in zip(panels, couples, strict=True):
        x, y = (scaled(each, own)[few] for each in (one, other))
        kept = within[few]
        panel.plot(x[kept], y[kept], ".", color=PALE, markersize=2.0, rasterized=True)
        panel.plot(x[~kept], y[~kept], "x", color=INK, markersize=2.0, markeredgewidth=0.5, rasterized=True)
        panel.set_xlabel(axis_text(input_scale(one)))
        panel.set_ylabel(axis_text(input_scale(other)))
    return figure


def _size(study: Study) -> Iterator[Drawn]:
    size = size_of(study)
    if not size.choices:
        caption = translated(
            "Least margin over {field}, with the check that governs; grey: permitted",
            field=plain_text(size.path),
        )
        caption += translated("; dashed: what the case has.") if size.present is not None else ""
        yield "size", caption, size_figure(size, size_scale(study))


def _sweep(study: Study) -> Iterator[Drawn]:
    numeric = [one for one in study.inputs if "values" not in one]
    if not numeric:
        return
    along = numeric[0]
    bearings = bearings_of(study)
    for bearing in bearings:
        own = lines_of(study.columns, bearing)
        others = [one for one in study.inputs if one is not along]
        named = f" {translated('and')} ".join(plain_text(one["path"]) for one in others)
        caption = translated(
            "Results{of} over {field}{curves}. Open circles: beyond a limit.",
            of=of_bearing(bearing, bearings),
            field=plain_text(along["path"]),
            curves=translated(", a curve for each {fields}", fields=named) if others else "",
        )
        yield (
            file_name("sweep", bearing, bearings),
            caption,
            _curves(study, along, others, own, "" if len(bearings) == 1 else bearing),
        )


def _corners(study: Study) -> Iterator[Drawn]:
    numeric = [one for one in study.inputs if "values" not in one]
    names = bearings_of(study)
    if not numeric or not names:
        return
    along, others = numeric[0], [one for one in study.inputs if one is not numeric[0]]
    drawn_together = [names[first : first + 3] for first in range(0, len(names), 3)]
    said = "".join(translated(", for each {field}", field=plain_text(one["path"])) for one in others)
    caption = translated("Clearances by temperature of the oil{said}. Open circles: beyond a limit.", said=said)
    for number, together in enumerate(drawn_together, 1):
        chosen = np.isin(study.columns["bearing"], together)
        own = {name: column[chosen] for name, column in study.columns.items()}
        by_name = {"path": "bearing", "values": together, "support": []}
        yield (
            "corners" if len(drawn_together) == 1 else f"corners-{number}",
            caption,
            _curves(study, along, [by_name, *others], own),
        )


def _curves(
    study: Study, along: Mapping[str, Any], others: list[dict[str, Any]], own: Columns, title: str = ""
) -> Figure:
    """Each output over a field, a curve for each value of the others; `title` names the bearing, if of several."""
    names = [name for name in study.outputs if np.isfinite(own[name]).any()][:MOST_PANELS]
    figure, panels = panels_for(max(1, len(names)), sharex=True)
    keys = list(zip(*(own[one["path"]] for one in others), strict=True)) if others else [()] * own["row"].size
    curves = list(dict.fromkeys(keys))[:MOST_CURVES]
    for panel, name in zip(panels, names, strict=False):
        scale = output_scale(name)
        for place, key in enumerate(curves):
            chosen = np.array([one == key for one in keys])
            x, values = scaled(along, own)[chosen], scale.shown(own[name][chosen])
            order = np.argsort(x)
            colour = str(0.7 * place / max(1, len(curves) - 1))
            said = ", ".join(_named(one, part) for one, part in zip(others, key, strict=True))
            panel.plot(x[order], values[order], "-", color=colour, linewidth=0.9, label=said)
            missed = ~np.isin(own["verdict"][chosen], WITHIN)
            panel.plot(x[missed], values[missed], "o", color=colour, markerfacecolor="white", markersize=2.5)
        panel.set_xlabel(axis_text(input_scale(along)))
        panel.set_ylabel(axis_text(scale))
    if others and panels:
        handles, labels = panels[0].get_legend_handles_labels()
        high = figure.get_figheight() * MM_PER_INCH
        columns = legend_columns(labels, figure.get_figwidth() * MM_PER_INCH, 6.0)
        lines = math.ceil(len(labels) / columns) + bool(title)
        figure.subplots_adjust(top=1.0 - (6.0 + LEGEND_LINE * lines) / high)
        figure.legend(
            handles, labels, loc="upper left", ncols=columns, frameon=False, fontsize=6, handlelength=2.0,
            title=bearing_text(title) or None, title_fontsize=7, alignment="left",
        )  # fmt: skip
    elif title:
        figure.text(0.01, 0.99, bearing_text(title), fontsize=7, va="top")
    return figure


def _named(one: Mapping[str, Any], value: Any) -> str:
    """A value of a field in a legend: words alone, numbers with the field and its unit."""
    if one["path"] == "bearing":
        return bearing_text(str(value))
    scale = input_scale(one)
    text = scale.text(value)
    return text if isinstance(value, str) else f"{scale.name} {text} {scale.unit}".rstrip()


def _sensitivity(study: Study) -> Iterator[Drawn]:
    found = indices_of(study)
    bearings = bearings_of(study)
    for bearing in bearings:
        varying = [one for one in found if one.bearing == bearing and any(map(math.isfinite, one.total))]
        own = varying[:MOST_PANELS]
        if own:
            caption = translated(
                "Sobol indices{of}: first order (black), total (pale), 95 % intervals.",
                of=of_bearing(bearing, bearings),
            )
            yield file_name("indices", bearing, bearings), caption, _bars(own)


def _bars(found: list[Indices]) -> Figure:
    figure, panels = panels_for(len(found), sharex=True)
    for panel, one in zip(panels, found, strict=True):
        places = np.arange(len(one.inputs), dtype=float)
        bars: dict[str, Any] = {"height": 0.2, "error_kw": {"elinewidth": 0.5, "ecolor": GREY}}
        panel.barh(places + 0.1, one.first, xerr=one.first_conf, color=INK, **bars)
        panel.barh(places - 0.1, one.total, xerr=one.total_conf, color=PALE, **bars)
        _named_bars(panel, one.inputs)
        panel.set_title(mathematics(output_scale(one.output).name), fontsize=8, pad=3)
        panel.set_xlim(0.0, 1.15)
        panel.set_xlabel(translated("share of the variance"))
    return figure


def _spectrum(study: Study) -> Iterator[Drawn]:
    shares = np.array([one.share for one in study.block.load_cases])
    names = [str(one) for one in dict.fromkeys(study.columns["group"])]
    bearings = bearings_of(study)
    figure, panels = panels_for(1, 60.0)
    for place, bearing in enumerate(bearings):
        own = lines_of(study.columns, bearing)
        look: dict[str, Any] = {
            "color": str(0.7 * place / max(1, len(bearings) - 1)),
            "marker": "o",
            "markersize": 3.0,
        }
        panels[0].plot(own["row"], 100.0 * own["margin"], label=bearing_text(bearing), **look)
    panels[0].axhline(0.0, color=GREY, linewidth=0.7, linestyle=(0, (5, 2)))
    labels = [
        f"{plain_text(name)}\n{decimal(f'{100.0 * share:.3g}')} %"
        for name, share in zip(names, shares, strict=True)
    ]
    panels[0].set_xticks(range(len(names)), labels)
    panels[0].set_ylabel(translated("governing margin in %"))
    if len(bearings) > 1:
        panels[0].legend(frameon=False, fontsize=6)
    caption = translated("Margin of the governing check in each load case, with its share of time.")
    yield "spectrum", caption, figure


_OF_KIND: Mapping[str, Callable[[Study], Iterator[Drawn]]] = {
    "tolerance": _tolerance,
    "map": map_figures,
    "sweep": _sweep,
    "size": _size,
    "corners": _corners,
    "sensitivity": _sensitivity,
    "spectrum": _spectrum,
    "optimise": optimum_figures,
    "table": lambda _: iter(()),
    "design": design_figures,
}
