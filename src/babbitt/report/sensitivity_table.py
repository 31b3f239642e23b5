"""Tables of a sensitivity study: indices of Sobol, slopes at the medians."""

from __future__ import annotations

import math
from collections.abc import Iterator

from babbitt.core.language import decimal, translated
from babbitt.report.study_lines import bearing_head, has_several, heads
from babbitt.report.study_values import DASH, StudyTable, bearing_text, output_scale, significant
from babbitt.study.indices import indices_of, slopes_of
from babbitt.study.study import Study

__all__ = ["sensitivity_tables"]


def sensitivity_tables(study: Study) -> Iterator[StudyTable]:
    """Indices with their confidence, then slopes; one line a bearing and result."""
    several = has_several(study)
    paths = [one["path"] for one in study.inputs]
    lead = bearing_head(several)
    found = indices_of(study)
    rows = []
    for one in found:
        name = ((bearing_text(one.bearing),) if several else ()) + (output_scale(one.output).name,)
        for what, values, conf in (("first", one.first, one.first_conf), ("total", one.total, one.total_conf)):
            cells = tuple(
                decimal(f"{value:.3f} ± {half:.3f}") if math.isfinite(value) else DASH
                for value, half in zip(values, conf, strict=True)
            )
            rows.append((*name, translated(what), *cells))
    notes = [
        translated("Share of the variance: of the field alone (first), with all its interactions (total); ± 95 %.")
    ]
    least = min((one.used for one in found), default=0)
    if found and least < found[0].base:
        notes.append(
            translated(
                "{number} of {base} base samples have a row without solution, left out.",
                number=found[0].base - least,
                base=found[0].base,
            )
        )
    headings = (*lead, *heads("result", "index"), *((path, "") for path in paths))
    yield StudyTable(translated("Sobol indices"), headings, tuple(rows), 3 if several else 2, tuple(notes))
    slopes = slopes_of(study)
    rows = [
        ((bearing_text(bearing),) if several else ())
        + (output_scale(output).name, *(significant(own[path][1], 3) for path in paths))
        for (bearing, output), own in slopes.items()
    ]
    note = translated(
        "Elasticity: percent of change of the result for one percent of the field (temperatures in K), by central "
        "differences at the medians."
    )
    headings = (*lead, *heads("result"), *((path, "") for path in paths))
    yield StudyTable(translated("Slopes at the medians"), headings, tuple(rows), 2 if several else 1, (note,))
