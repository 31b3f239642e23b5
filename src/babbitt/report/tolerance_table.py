"""Tables of a tolerance study: yield, checks, scatter, worst cases, and what drives them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from babbitt.core.language import decimal, translated
from babbitt.report.study_lines import bearing_head, has_several, heads, line_table, mean_heading
from babbitt.report.study_values import (
    DASH,
    StudyTable,
    bearing_text,
    check_title,
    output_scale,
    percent,
    significant,
)
from babbitt.study.study import Study
from babbitt.study.yields import ALL, Capability, tolerance_summary

__all__ = ["tolerance_tables"]
LARGEST_CPK = 100.0
"""Beyond which its size tells nothing more: the margin scatters by less than a third of a hundredth of itself."""


def tolerance_tables(study: Study) -> Iterator[StudyTable]:
    """Yield and checks first, then the scatter of the results."""
    found = tolerance_summary(study)
    yield StudyTable(
        translated("Yield"),
        heads("", "samples", "within limits", "yield", "95 % from", "to", "unsolved", "interval by"),
        tuple(
            (
                *(translated(ALL) if one.bearing == ALL else bearing_text(one.bearing),),
                *(str(one.samples), str(one.within)),
                *(percent(share, 2) for share in (one.share, one.low, one.high)),
                *(str(one.unsolved), translated(one.method)),
            )
            for one in found.yields
        ),
        notes=(
            translated(
                "Within limits: verdict pass or pass with remarks; a row without a solution or verdict is outside."
            ),
        ),
    )
    several = has_several(study)
    yield StudyTable(
        translated("Checks"),
        bearing_head(several) + heads("check", "failed", "share") + (("Cpk", ""),) + heads("Cpk holds"),
        tuple(
            ((bearing_text(one.bearing),) if several else ())
            + (check_title(one.code), str(one.failures), percent(one.failures / max(1, one.samples), 2))
            + (_cpk(one), _cpk_holds(one))
            for one in found.capabilities
        ),
        2 if several else 1,
        (
            translated(
                "Cpk of a one-sided limit: mean margin over three standard deviations; holds for near-normal "
                "margins."
            ),
        ),
    )
    yield _spread_table(study, found.spreads, several)
    yield from _worst_cases(study, found.worst_corner, found.worst_sample)
    yield _tornado_table(study, found.tornado, several)


def _cpk(one: Capability) -> str:
    """No more than its sign of one whose size tells nothing."""
    if not one.varies:
        return translated("does not vary")
    if abs(one.cpk) > LARGEST_CPK:
        return f"> {LARGEST_CPK:g}" if one.cpk > 0.0 else f"< -{LARGEST_CPK:g}"
    return significant(one.cpk, 3)


def _cpk_holds(one: Capability) -> str:
    if not one.varies:
        return DASH
    return translated("about" if one.near_normal else "not: margins far from a normal law")


def _spread_table(study: Study, spreads: Sequence[Any], several: bool) -> StudyTable:
    ranks = sorted(next((one.percentiles for one in spreads), {}))
    headings = bearing_head(several) + heads("quantity") + ((mean_heading("").strip(), ""), ("σ", ""))
    rows = []
    for one in spreads:
        scale = output_scale(one.output)
        cells = ((bearing_text(one.bearing),) if several else ()) + (f"{scale.name} {scale.unit}".strip(),)
        deviation = significant(one.deviation * scale.factor, 3)
        numbers = [scale.text(one.percentiles[rank]) for rank in ranks]
        rows.append(
            (*cells, scale.text(one.mean), deviation, scale.text(one.least), *numbers, scale.text(one.most))
        )
    percentiles = tuple((decimal(f"{rank:g} %"), "") for rank in ranks)
    columns = (*headings, *heads("least"), *percentiles, *heads("largest"))
    return StudyTable(translated("Scatter of the results"), columns, tuple(rows), 2 if several else 1)


def _worst_cases(
    study: Study, corner: Mapping[str, Any] | None, sample: Mapping[str, Any] | None
) -> Iterator[StudyTable]:
    found = [(name, one) for name, one in (("worst corner", corner), ("worst sample", sample)) if one is not None]
    if not found:
        return
    columns = {name: np.array([one[name] for _, one in found]) for name in found[0][1]}
    columns["case"] = np.array([translated(name) for name, _ in found], object)
    note = (
        "Corners: every combination of smallest and largest values."
        if corner is not None
        else "No corners are computed: there are more than 8 numeric fields, none, or fields of a table."
    )
    yield line_table(study, columns, translated("Worst cases"), "case", (translated(note),))


def _tornado_table(
    study: Study, tornado: Mapping[tuple[str, str], Mapping[str, float]], several: bool
) -> StudyTable:
    paths = [one["path"] for one in study.inputs if "values" not in one]
    headings = bearing_head(several) + heads("result")
    rows = tuple(
        ((bearing_text(bearing),) if several else ())
        + (_result_name(output), *(_signed(shares.get(path, math.nan)) for path in paths))
        for (bearing, output), shares in tornado.items()
    )
    note = translated(
        "Squared rank correlation (Spearman), in percent; a minus: the result falls as the field rises."
    )
    columns = (*headings, *((path, "%") for path in paths))
    return StudyTable(translated("What drives the scatter"), columns, rows, 2 if several else 1, (note,))


def _result_name(output: str) -> str:
    """What a result is called: its symbol, or the margin."""
    return translated(output) if output == "margin" else output_scale(output).name


def _signed(share: float) -> str:
    return decimal(f"{100.0 * share:.1f}") if math.isfinite(share) else DASH
