"""The answer of `babbitt size` as JSON and as a figure: checked before all work, written after it."""

from __future__ import annotations

import json
import math
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

from babbitt import __version__
from babbitt.case.variation import CaseVariation
from babbitt.core.files.writing import require_distinct, require_writable, write_file
from babbitt.report.drawing import GREY, INK, Sheet, rendered, require_extra, style
from babbitt.report.outputs import inputs_of
from babbitt.report.sweep_plot import require_plot
from babbitt.report.verdict import comparison
from babbitt.study.permitted import Appraisal
from babbitt.study.size import LOGARITHMIC_FROM, Size
from babbitt.study.sweep_values import SHOWN

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEAST_MARGIN = -1.0
"""Margins below are drawn here: how far a limit is missed says little then."""

PAPER = {"facecolor": "white", "linewidth": 0.0, "pad": 0.5}
"""Behind words on a line."""


def require_size_outputs(variation: CaseVariation, record: Path | None, plot: Path | None) -> None:
    """Find out before any work is done whether an answer can be written.

    Raises
    ------
    InputError
        E007 for a path that cannot be written, one path for two outputs, an output that would replace an input,
        and for a package that is not installed.
    """
    outputs = [output for output in (record, plot) if output is not None]
    require_distinct(outputs, inputs_of([variation.file], variation.inputs))
    for output in outputs:
        require_writable(output)
    if plot is not None:
        require_extra("matplotlib", "plots")
        require_plot(plot)


def write_size(size: Size, record: Path | None, plot: Path | None) -> None:
    """Write an answer as JSON and as a figure, as far as asked for.

    Raises
    ------
    InputError
        E007 when a file cannot be written.
    """
    if record is not None:
        write_file(record, size_json(size).encode())
    if plot is not None:
        with style():
            image = rendered(size_figure(size), plot.suffix.lower().removeprefix("."))
        write_file(plot, image)


def size_json(size: Size) -> str:
    """The answer as JSON: intervals and scan in the unit named."""
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
    }
    return json.dumps(record, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _record(one: Appraisal | None) -> dict[str, Any] | None:
    if one is None:
        return None
    return {
        "value": one.value,
        "permitted": one.permitted,
        "margin": one.margin if math.isfinite(one.margin) else None,
        "code": one.code,
        "bearing": one.bearing,
        "reason": comparison(one.check) if one.check is not None else one.reason,
        "remarks": list(one.remarks),
    }


def size_figure(size: Size) -> Figure:
    """The least margin over the field, a line for the governing check each, permitted intervals shaded."""
    figure, axes = Sheet(166.0, 70.0, 1, 1, across=16.0, between=5.0).panels()
    panel = axes.ravel()[0] if hasattr(axes, "ravel") else axes
    shown = sorted(
        {one.value: one for one in (*size.scan, *_ends(size)) if math.isfinite(one.margin)}.values(),
        key=lambda one: one.value,
    )
    for one in size.intervals:
        panel.axvspan(one.lower.value, one.upper.value, color="0.9", linewidth=0.0, zorder=0)
    panel.axhline(0.0, color=GREY, linewidth=0.7)
    panel.plot([one.value for one in shown], [max(one.margin, LEAST_MARGIN) for one in shown], color=INK, zorder=3)
    first, last = size.scan[0].value, size.scan[-1].value
    if first > 0.0 and last >= LOGARITHMIC_FROM * first:
        panel.set_xscale("log")
    for codes, place in _governing(shown):
        panel.annotate(
            codes, (place.value, max(place.margin, LEAST_MARGIN)), xytext=(0, 4), textcoords="offset points",
            ha="center", fontsize=7, color="0.3", zorder=4, bbox=PAPER,
        )  # fmt: skip
    if size.present is not None and first <= size.present <= last:
        panel.axvline(size.present, color=GREY, linewidth=0.7, linestyle=(0, (2, 2)))
    unit = SHOWN.get(size.unit, size.unit)
    panel.set_xlabel(f"{size.path} in {unit}" if unit else size.path)
    panel.set_ylabel("Least margin")
    return figure


def _ends(size: Size) -> list[Appraisal]:
    found = [end for one in size.intervals for end in (one.lower, one.upper, one.below, one.above)]
    return [one for one in found if one is not None]


def _governing(shown: list[Appraisal]) -> list[tuple[str, Appraisal]]:
    """Code and middle of every stretch that one check governs."""
    stretches = [(code, list(stretch)) for code, stretch in groupby(shown, lambda one: one.code)]
    return [(code, stretch[len(stretch) // 2]) for code, stretch in stretches]
