"""The answer of a size as JSON and as a figure."""

from __future__ import annotations

import json
import math
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

from babbitt import __version__
from babbitt.core.files.writing import write_file
from babbitt.core.language import translated
from babbitt.report.drawing import GREY, INK, Sheet
from babbitt.report.study_values import Scale
from babbitt.study.permitted import Trial
from babbitt.study.size import Size, size_of
from babbitt.study.study import Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEAST_MARGIN = -1.0
"""Margins below are drawn here: how far a limit is missed says little then."""

PAPER = {"facecolor": "white", "linewidth": 0.0, "pad": 0.5}
"""Behind words on a line."""


def write_size(study: Study, record: Path | None) -> None:
    """Write an answer as JSON, if asked for.

    Raises
    ------
    InputError
        E007 when the file cannot be written.
    """
    if record is not None:
        write_file(record, size_json(size_of(study)).encode())


def size_json(size: Size) -> str:
    """The answer as JSON: intervals and scan in SI."""
    record = {
        "babbitt": __version__,
        "case": size.name,
        "field": size.path,
        "unit": size.unit,
        "limits": list(size.limits),
        "over_tolerance": size.over_tolerance,
        "intervals": [
            {
                "from": one.lower.value,
                "to": one.upper.value,
                "below": _record(one.below),
                "above": _record(one.above),
                "best": _record(one.best),
            }
            for one in size.intervals
        ],
        "scan": [_record(one) for one in size.scan],
        "preferred": [_record(one) for one in size.preferred],
        "choices": {choice: _record(one) for choice, one in size.choices.items()},
    }
    return json.dumps(record, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _record(one: Trial | None) -> dict[str, Any] | None:
    if one is None:
        return None
    return {
        "value": one.value,
        "permitted": one.permitted,
        "margin": one.margin if math.isfinite(one.margin) else None,
        "code": one.code,
        "bearing": one.bearing,
        "reason": one.reason,
        "remarks": list(one.remarks),
    }


def size_figure(size: Size, scale: Scale) -> Figure:
    """The least margin over the field, a line for the governing check each, permitted intervals shaded."""
    figure, axes = Sheet(166.0, 70.0, 1, 1, across=16.0, between=5.0).panels()
    panel = axes.ravel()[0] if hasattr(axes, "ravel") else axes
    shown = sorted(
        {one.value: one for one in (*size.scan, *_ends(size)) if math.isfinite(one.margin)}.values(),
        key=lambda one: one.value,
    )
    for one in size.intervals:
        panel.axvspan(
            scale.shown(one.lower.value), scale.shown(one.upper.value), color="0.9", linewidth=0.0, zorder=0
        )
    panel.axhline(0.0, color=GREY, linewidth=0.7)
    margins = [100.0 * max(one.margin, LEAST_MARGIN) for one in shown]
    panel.plot([scale.shown(one.value) for one in shown], margins, color=INK, zorder=3)
    first, last = size.scan[0].value, size.scan[-1].value
    if size.steps == "ratios":
        panel.set_xscale("log")
        panel.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    for codes, place in _governing(shown):
        panel.annotate(
            codes, (scale.shown(place.value), 100.0 * max(place.margin, LEAST_MARGIN)), xytext=(0, 4),
            textcoords="offset points", ha="center", fontsize=7, color="0.3", zorder=4, bbox=PAPER,
        )  # fmt: skip
    if size.present is not None and first <= size.present <= last:
        panel.axvline(scale.shown(size.present), color=GREY, linewidth=0.7, linestyle=(0, (2, 2)))
    panel.set_xlabel(scale.heading)
    panel.set_ylabel(translated("least margin in %"))
    return figure


def _ends(size: Size) -> list[Trial]:
    found = [end for one in size.intervals for end in (one.lower, one.upper, one.below, one.above)]
    return [one for one in found if one is not None]


def _governing(shown: list[Trial]) -> list[tuple[str, Trial]]:
    """Code and middle of every stretch that one check governs."""
    stretches = [(code, list(stretch)) for code, stretch in groupby(shown, lambda one: one.code)]
    return [(code, stretch[len(stretch) // 2]) for code, stretch in stretches]
