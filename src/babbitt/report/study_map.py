"""Maps: region within limits, contours of the governing margin, lines of single checks, temperature."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.check_text import distance
from babbitt.core.language import ENGLISH, language, translated, translated_if_known
from babbitt.core.result import ROUND_OFF, Verdict
from babbitt.report.drawing import GREY, INK, Sheet
from babbitt.report.study_panels import (
    WIDTH,
    Drawn,
    axis_text,
    bearings_of,
    file_name,
    lines_of,
    of_bearing,
    scaled,
)
from babbitt.report.study_values import (
    DASH,
    MARGIN_DECIMALS,
    StudyTable,
    bearing_text,
    check_title,
    input_scale,
    output_scale,
)
from babbitt.report.text import plain_text
from babbitt.study.rows import Columns, advisory_name, kelvin_name, margin_name
from babbitt.study.study import Study
from babbitt.study.yields import WITHIN

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["map_figures", "map_tables"]

Array = NDArray[np.float64]

MARGINS = (-0.5, -0.2, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8)
"""Contours of the governing margin; zero has its own."""

SECOND = (
    "maximum_temperature",
    "outlet_temperature",
    "trailing_temperature",
    "effective_temperature",
    "temperature_rise",
    "minimum_film_thickness",
)
"""Of the second panel: the first that is kept."""

CONTOURS = 7

LOST = -1.0
"""Margin of points without a solution where the region ends between them and others."""


def map_tables(study: Study) -> Iterator[StudyTable]:
    """The verdict at each point, and where each check is missed."""
    bearings = bearings_of(study)
    if not bearings:
        return
    for bearing in bearings:
        own = lines_of(study.columns, bearing)
        yield _verdicts(study, own, bearing)
        yield _checks(study, own, bearing_text(bearing))


def _verdicts(study: Study, own: Columns, bearing: str) -> StudyTable:
    across, up = study.inputs
    scales = [input_scale(one, None if "values" in one else study.columns[one["path"]]) for one in (across, up)]
    axes = [list(dict.fromkeys(study.columns[one["path"]].tolist())) for one in (across, up)]
    letters = {
        (own[across["path"]][place], own[up["path"]][place]): _letter(own, place)
        for place in range(own["row"].size)
    }
    rows = tuple((scales[1].text(y), *(letters.get((x, y), DASH) for x in axes[0])) for y in reversed(axes[1]))
    heads = ((scales[1].heading, ""), *((scales[0].text(x), "") for x in axes[0]))
    title = translated(
        "Map of {bearing}: {up} up, {across} across",
        bearing=bearing_text(bearing),
        up=scales[1].name,
        across=scales[0].heading,
    )
    note = translated(
        "○ within all limits; a code: the check that governs where one is missed; ? no verdict; – no solution."
    )
    shares = [f"{one['path']}: {_begun(one['meaning'])}." for one in (across, up) if one["form"] == "share"]
    return StudyTable(title, heads, rows, 1, (note, *shares))


def _begun(meaning: str) -> str:
    """What a field is, as it stands behind a colon."""
    return meaning[0].lower() + meaning[1:] if language() == ENGLISH else translated_if_known(meaning)


def _letter(columns: Columns, place: int) -> str:
    match str(columns["verdict"][place]):
        case "pass" | "remarks":
            return "○"
        case "fail":
            return str(columns["governing_check"][place])
        case "no_verdict":
            return "?"
    return DASH


def _checks(study: Study, own: Columns, bearing: str) -> StudyTable:
    """Every check of a map: at how many points it is missed, and between which margins it lies."""
    solved = own["verdict"] != Verdict.NO_SOLUTION.key
    rows = []
    for (code, what), margin in _lines(study, own).items():
        known = np.isfinite(margin)
        kelvin = own.get(kelvin_name(code)) if what == "limit" else None
        warm = np.full(margin.size, np.nan) if kelvin is None else kelvin
        order = np.argsort(np.where(known, margin, np.inf))
        ends = (distance(margin[at], warm[at], MARGIN_DECIMALS) for at in (order[0], order[known.sum() - 1]))
        rows.append((check_title(code), translated(what), str(int((margin[known] < -ROUND_OFF).sum())), *ends))
    within = int(np.isin(own["verdict"], WITHIN).sum())
    notes = [
        translated(
            "{within} of {points} points within all limits, {without} without a solution.",
            within=within,
            points=solved.size,
            without=int((~solved).sum()),
        )
    ]
    if not within:
        notes.append(_why_empty(own, solved))
    notes += [
        translated("No line of {check}", check=check_title(one["code"]))
        + (f": {one['message']}." if language() == ENGLISH else ".")
        for one in study.description["not_checked"]
    ]
    check, kind, missed, least, largest = map(
        translated, ("check", "kind", "missed at", "least margin", "largest margin")
    )
    heads = ((check, ""), (kind, ""), (missed, translated("points")), (least, ""), (largest, ""))
    title = translated("Checks over the map of {bearing}", bearing=bearing)
    return StudyTable(title, heads, tuple(rows), 2, tuple(notes))


def _why_empty(own: Columns, solved: NDArray[np.bool_]) -> str:
    """Why no point is within the limits."""
    if not solved.any():
        return translated("No point has a solution.")
    if not (own["verdict"] == Verdict.FAIL.key).any():
        return translated(
            "No point has a verdict: no limit was held against the results, or what was held does not suffice."
        )
    codes = [set(str(one).split()) for one in own["failed_checks"][solved]]
    everywhere = sorted(set.intersection(*codes))
    if everywhere:
        return translated("At every point that has a solution {codes} is missed.", codes=", ".join(everywhere))
    return translated("Every point that has a solution misses some limit.")


def _lines(study: Study, own: Columns) -> dict[tuple[str, str], Array]:
    """Margins of all checks that some point has, by code and kind."""
    named = {(one["code"], "limit"): margin_name(one["code"]) for one in study.description["checks"]}
    named |= {
        (one["code"], "recommendation"): advisory_name(one["code"]) for one in study.description["advisories"]
    }
    return {key: own[name] for key, name in named.items() if np.isfinite(own[name]).any()}


def map_figures(study: Study) -> Iterator[Drawn]:
    """A figure for each bearing: the margin, and beside it the temperature or the film."""
    across, up = study.inputs
    if "values" in across or "values" in up:
        return
    bearings = bearings_of(study)
    for bearing in bearings:
        own = lines_of(study.columns, bearing)
        second = next((name for name in SECOND if name in study.outputs and _varies(own[name])), "")
        lines = _lines(study, own)
        yield (
            file_name("map", bearing, bearings),
            _caption(study, own, of_bearing(bearing, bearings), second),
            _figure(across, up, own, lines, second),
        )


def _caption(study: Study, own: Columns, of: str, second: str) -> str:
    across, up = (plain_text(one["path"]) for one in study.inputs)
    said = [
        translated(
            "Region{of} within all limits (blank) over {across} and {up}, with contours of the governing margin "
            "in percent. Bold: margin zero; broken: of a single limit, by its code",
            of=of,
            across=across,
            up=up,
        )
    ]
    crossed = [code for (code, what), line in _lines(study, own).items() if what != "limit" and _crosses(line)]
    if crossed:
        titles = ", ".join(map(check_title, crossed))
        said.append(translated("; dotted: of a recommendation or screening, {checks}", checks=titles))
    said.append(translated(". Grey: beyond a limit, or (crosses) no solution; dots: no verdict."))
    if second:
        scale = output_scale(second)
        name = translated("{quantity} in {unit}", quantity=plain_text(scale.name), unit=scale.unit)
        said.append(translated(" Right: {quantity}, and the line of margin zero.", quantity=name))
    return "".join(said)


def _varies(values: Array) -> bool:
    known = values[np.isfinite(values)]
    return bool(known.size and np.ptp(known) > 1e-6 * np.abs(known).max())


def _crosses(margin: Array) -> bool:
    return bool(np.isfinite(margin).any() and np.nanmin(margin) < 0.0 < np.nanmax(margin))


def _figure(
    across: Mapping[str, Any],
    up: Mapping[str, Any],
    own: Columns,
    lines: Mapping[tuple[str, str], Array],
    second: str,
) -> Figure:
    x, y = (np.unique(scaled(one, own)) for one in (across, up))
    at_x = np.searchsorted(x, scaled(across, own))
    at_y = np.searchsorted(y, scaled(up, own))

    def field(values: Array) -> Array:
        made = np.full((y.size, x.size), np.nan)
        made[at_y, at_x] = values
        return made

    wide = 2 if second else 1
    sheet = Sheet(WIDTH if second else 110.0, 78.0, 1, wide, left=15.0, bottom=11.0, across=13.0)
    figure, axes = sheet.panels(sharey=True)
    panels = list(axes.ravel())
    figure.subplots_adjust(top=0.93)
    lost = own["verdict"] == Verdict.NO_SOLUTION.key
    unjudged = own["verdict"] == Verdict.NO_VERDICT.key
    margin = field(own["margin"])
    region = field(np.where(lost, LOST, own["margin"]))
    if min(margin.shape) > 1:
        _margins(panels[0], x, y, margin, region)
        for (code, what), values in lines.items():
            _zero(panels[0], x, y, field(values), code, "dashed" if what == "limit" else "dotted")
        if second:
            _contours(panels[1], x, y, field(output_scale(second).shown(own[second])), region)
    panels[0].plot(x[at_x[lost]], y[at_y[lost]], "x", color=INK, markersize=3.0, markeredgewidth=0.6)
    panels[0].plot(x[at_x[unjudged]], y[at_y[unjudged]], ".", color=INK, markersize=1.5)
    panels[0].set_title(translated("governing margin in %"), fontsize=8, pad=3)
    panels[0].set_ylabel(axis_text(input_scale(up)))
    if second:
        panels[1].set_title(axis_text(output_scale(second)), fontsize=8, pad=3)
    for panel in panels:
        panel.set_xlabel(axis_text(input_scale(across)))
        panel.set_xlim(x[0], x[-1])
        panel.set_ylim(y[0], y[-1])
    return figure


def _margins(panel: Axes, x: Array, y: Array, margin: Array, region: Array) -> None:
    if not np.isfinite(margin).any():
        return
    if np.nanmin(region) < 0.0:
        panel.contourf(x, y, region, levels=[np.nanmin(region), 0.0], colors=["0.85"])
    least, most = np.nanmin(margin), np.nanmax(margin)
    levels = [level for level in MARGINS if least < level < most]
    if levels:
        drawn = panel.contour(x, y, margin, levels=levels, colors=GREY, linewidths=0.6, linestyles="solid")
        panel.clabel(drawn, fmt=lambda value: f"{100.0 * value:.0f}", fontsize=6)
    _bold(panel, x, y, region)


def _bold(panel: Axes, x: Array, y: Array, region: Array) -> None:
    if _crosses(region):
        panel.contour(x, y, region, levels=[0.0], colors=INK, linewidths=1.4, linestyles="solid")


def _zero(panel: Axes, x: Array, y: Array, margin: Array, code: str, style: str) -> None:
    """The line where a single check is just kept."""
    if _crosses(margin):
        drawn = panel.contour(x, y, margin, levels=[0.0], colors=INK, linewidths=0.7, linestyles=style)
        for label in panel.clabel(drawn, fmt=lambda _: code, fontsize=6, inline=False):
            label.set_bbox({"facecolor": "white", "linewidth": 0.0, "pad": 0.8})
            label.set_zorder(5)


def _contours(panel: Axes, x: Array, y: Array, values: Array, region: Array) -> None:
    drawn = panel.contour(x, y, values, levels=CONTOURS, colors=GREY, linewidths=0.6, linestyles="solid")
    panel.clabel(drawn, fontsize=6)
    _bold(panel, x, y, region)
