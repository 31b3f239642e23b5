"""Two designs of the page side by side, as `babbitt compare a.yaml b.yaml` has them."""

from __future__ import annotations

from babbitt.app.answer import NAME, Fault, Table, faults_of, read
from babbitt.case import CaseError, located
from babbitt.core.language import translated
from babbitt.core.notices import InputError
from babbitt.report.designs_table import SAME, bearing_rows, kinds_said
from babbitt.report.names import shown_name
from babbitt.report.text import counted, plain_text
from babbitt.report.us_words import OF_RESULTS, in_us_units
from babbitt.study.designs import ComparedBearing, Designs, compare_designs

__all__ = ["LABELS", "side_by_side"]

LABELS = ("A", "B")
"""The design that was kept, and the one that is on the page."""


def side_by_side(first: str, other: str) -> tuple[tuple[Fault, ...], tuple[Table, ...]]:
    """What is wrong with two cases, or the inputs and results in which they differ, differences from the first."""
    try:
        both = [read(first), read(other)]
    except CaseError as error:
        return faults_of(error), ()
    try:
        found = compare_designs(both, LABELS)
    except InputError as error:
        return faults_of(located(error, both[1], NAME)), ()
    return (), (_inputs(found), *(_results(one) for one in found.bearings))


def _inputs(found: Designs) -> Table:
    rows = tuple((one.path, *one.shown) for one in found.changed)
    said = kinds_said(found)
    return Table(translated("Changed inputs"), (translated("field"), *found.labels), rows, (said,) if said else ())


def _results(bearing: ComparedBearing) -> Table:
    rows = list(bearing_rows(bearing))
    shown = [one for one in rows if set(one.differences) - SAME]
    left = len(rows) - len(shown)
    remarks = (
        [translated("left out: {results} that no design changes", results=counted(left, "result"))] if left else []
    )
    remarks += [
        f"{label}: {translated(one.outcome.value)}; {in_us_units(plain_text(one.message), OF_RESULTS)}"
        for label, one in zip(LABELS, bearing.results, strict=True)
        if one is not None and not one.outcome.solved
    ]
    heads = (
        translated("quantity"),
        translated("unit"),
        *LABELS,
        translated("{design} against {first}", design=LABELS[1], first=LABELS[0]),
    )
    cells = tuple((one.meaning, one.unit, *one.cells, *one.differences) for one in shown)
    return Table(shown_name(bearing.name), heads, cells, tuple(remarks), words=2)
