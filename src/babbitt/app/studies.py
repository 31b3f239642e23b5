"""Studies of the case on the page: the block of a case file that asks, and its answer as plain data."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from babbitt.app.answer import NAME, Fault, Figure, Table, faults_of, read
from babbitt.app.document import CaseDocument, path_in, with_changed
from babbitt.app.form import Item, as_text, quantities
from babbitt.app.progress import FileWatch
from babbitt.app.units import SYSTEMS, from_si, shown_in, split
from babbitt.app.words import told
from babbitt.case import CaseError, located
from babbitt.case.with_units import case_text
from babbitt.core.kind import find_kind
from babbitt.core.notices import InputError
from babbitt.report.size_table import rounded
from babbitt.report.text import plain_text
from babbitt.study.permitted import Interval, Trial
from babbitt.study.size import Size, size_of
from babbitt.study.size_choices import standard_choices
from babbitt.study.study import Study

__all__ = [
    "Axis",
    "Studied",
    "asked_text",
    "axes_of",
    "block_of",
    "first_axis",
    "kinds_of",
    "replaces_fit",
    "sizes_of",
    "studied",
    "study_file",
    "with_value",
]

NEEDS = {"sweep": (1, 3), "size": (1, 1), "tolerance": (1, 8), "map": (0, 2), "corners": (0, 0), "design": (0, 0)}
"""Kinds of study on the page, each with the fewest and most fields that it varies."""

WIDE, NARROW = 2.0, 1.05
"""First ends of an axis: what the case has over this, and times this; the narrow one for tolerances."""

MEAN = "clearance.mean"
"""The clearance as a number."""

RELATIVE_CLEARANCES = ("0.5 permille", "3 permille")
"""First ends of a clearance that the case gives by a fit (assumption: the usual range)."""


@dataclass(frozen=True)
class Axis:
    """A field that a study varies.

    Attributes
    ----------
    path : str
    first, last : str
        Ends, as a case file has them; empty for choices.
    points : int
        Values from end to end.
    choices : tuple of str
        Words that stand for the field, in place of numbers.
    law : str
        Of a tolerance: ``uniform``, ``triangular`` (the middle most likely), ``fit`` or ``scatter``.
    law_of : str
        What the law needs to know: the fit.
    """

    path: str
    first: str = ""
    last: str = ""
    points: int = 11
    choices: tuple[str, ...] = ()
    law: str = "uniform"
    law_of: str = ""


@dataclass(frozen=True)
class Studied:
    """What became of a study: what is wrong with it, or its tables and figures."""

    faults: tuple[Fault, ...] = ()
    overview: str = ""
    tables: tuple[Table, ...] = ()
    figures: tuple[Figure, ...] = ()
    study: Study | None = None


def kinds_of(given: Mapping[str, Any]) -> tuple[str, ...]:
    """The kinds of study that a case can be asked for; a case with a study of its own is asked for that first."""
    kind = find_kind(str(given.get("kind")))
    without = ("design",) if kind is None or not kind.first_design else ()
    own = ("own",) if isinstance(given.get("study"), Mapping) else ()
    return (*own, *(name for name in NEEDS if name not in without))


def axes_of(document: CaseDocument, kind: str, system: str = SYSTEMS[0]) -> dict[str, Axis]:
    """The fields that a study of a case may vary, by their paths, each with the values to begin with."""
    if kind not in NEEDS or NEEDS[kind][1] == 0:
        return {}
    given, tolerance = document.given, kind == "tolerance"
    found = {axis.path: axis for axis in _numbers(document.items, NARROW if tolerance else WIDE, system)}
    clearance = given.get("clearance")
    if isinstance(clearance, Mapping) and {"bore", "journal"} <= clearance.keys():
        fit = f"{clearance['bore']}/{clearance['journal']}"
        if tolerance:
            found["clearance"] = Axis("clearance", law="fit", law_of=fit)
        else:
            found[MEAN] = Axis(MEAN, *RELATIVE_CLEARANCES)
            found |= {
                path: Axis(path, choices=standard_choices(path))
                for path in ("clearance.bore", "clearance.journal")
            }
    if kind == "map":  # two axes of numbers
        return {path: axis for path, axis in found.items() if not axis.choices}
    if "lubricant" in given and tolerance:
        found["lubricant"] = Axis("lubricant", law="scatter")
    elif "lubricant" in given:
        found["lubricant"] = Axis("lubricant", choices=standard_choices("lubricant"))
    return found


def first_axis(given: Mapping[str, Any], known: Iterable[str]) -> str:
    """The field to begin with: that over which a map of the kind goes up, such as the load, else the first."""
    paths = list(known)
    kind = find_kind(str(given.get("kind")))
    usual = kind.envelope[1] if kind is not None else ()
    return next((path for path in paths if path.rpartition(".")[2] in usual), paths[0])


def _numbers(items: tuple[Item, ...], factor: float, system: str) -> Iterator[Axis]:
    for entry in quantities(items):
        number, unit = split(as_text(entry.value), entry.units)
        number, unit = shown_in(system, number, unit, entry.units)
        if entry.options or not (value := float(number)):
            continue
        first, last = sorted((value / factor, value * factor))
        yield Axis(".".join(map(str, entry.path)), f"{first:.6g} {unit}".strip(), f"{last:.6g} {unit}".strip())


def block_of(kind: str, axes: Sequence[Axis], samples: int = 1000) -> dict[str, Any]:
    """The block ``study`` of a case file that asks for a study.

    >>> block_of("sweep", [Axis("load", "10 kN", "20 kN", 3)])
    {'kind': 'sweep', 'vary': {'load': {'range': ['10 kN', '20 kN', 3]}}}
    """
    block: dict[str, Any] = {"kind": kind}
    if axes:
        block["vary"] = {axis.path: _values(axis, kind) for axis in axes}
    if kind == "tolerance":
        block["samples"] = samples
    return block


def asked_text(given: Mapping[str, Any], block: Mapping[str, Any]) -> str:
    """The text of a case with a study; a clearance that varies as a number takes the place of a fit."""
    asked = with_changed(given, ("study",), dict(block))
    if any(replaces_fit(given, path) for path in block.get("vary", {})):
        asked = with_value(asked, MEAN, _mean_of(given) or block["vary"][MEAN]["range"][0])
    return case_text(asked)


def with_value(given: Mapping[str, Any], path: str, value: str) -> dict[str, Any]:
    """What a case gives with a value that a study found; a mean clearance takes the place of a fit."""
    steps = path_in(path)
    if replaces_fit(given, path):
        return with_changed(given, steps[:1], {"kind": "relative", steps[1]: value})
    return with_changed(given, steps, value)


def replaces_fit(given: Mapping[str, Any], path: str) -> bool:
    """Whether a value takes the place of a fit, or of sizes, and of their tolerances."""
    return path == MEAN and "mean" not in given.get("clearance", {})


def _mean_of(given: Mapping[str, Any]) -> str:
    """The mean clearance of a case with a fit; empty where the case cannot be read."""
    try:
        bearing = read(case_text(dict(given))).problems()[0].bearing
    except (CaseError, InputError, AttributeError, IndexError):
        return ""
    return f"{1e3 * bearing.mean_relative_clearance:.6g} permille"


def sizes_of(study: Study) -> dict[str, str] | None:
    """Values that keep all limits, as a case file has them: ends and best of each interval, or choices.

    Each with what it is, in words; empty for a choice. None where the study does not say in which unit a case file
    has them.
    """
    size = size_of(study)
    if size.choices:
        return {str(choice): "" for choice, one in size.choices.items() if one.permitted}
    asked = study.block.vary.get(size.path)
    if asked is None or asked.range is None:
        return None
    unit = str(asked.range[0]).partition(" ")[2]
    found: dict[str, list[str]] = {}
    questioned: set[str] = set()
    for one in size.intervals:
        offered = (
            (one.lower, True, "from"),
            (one.upper, False, "to"),
            (one.best, one.best is one.lower, "largest margin"),
            *_without_remarks(size, one),
        )
        for trial, upward, role in offered:
            text = f"{rounded(from_si(trial.value, unit), upward=upward)} {unit}".strip()
            found.setdefault(text, []).append(told(role))
            if trial.remarks:
                questioned.add(text)
    remarks = told("with remarks")
    return {text: ", ".join([*roles, remarks] if text in questioned else roles) for text, roles in found.items()}


def _without_remarks(size: Size, interval: Interval) -> Iterator[tuple[Trial, bool, str]]:
    """The value of the scan with the largest margin among those without remarks, where the largest has some."""
    if not interval.best.remarks:
        return
    clean = [
        one for one in size.scan
        if one.permitted and not one.remarks and interval.lower.value <= one.value <= interval.upper.value
    ]  # fmt: skip
    if clean:
        best = max(clean, key=lambda one: one.margin)
        yield best, best.value == interval.lower.value, "largest margin without remarks"


def _values(axis: Axis, kind: str) -> Any:
    if kind == "tolerance":
        if axis.law in ("fit", "scatter"):
            return {axis.law: axis.law_of or "vg"}
        if axis.law == "triangular":
            return {"triangular": [axis.first, _between(axis), axis.last]}
        return {"uniform": [axis.first, axis.last]}
    return list(axis.choices) if axis.choices else {"range": [axis.first, axis.last, axis.points]}


def _between(axis: Axis) -> str:
    """The middle of two ends of one unit; the first end where they are of two, which the study then refuses."""
    (low, unit), (high, other) = (one.strip().partition(" ")[::2] for one in (axis.first, axis.last))
    try:
        return f"{0.5 * (float(low) + float(high)):.9g} {unit}".strip() if unit == other else axis.first
    except ValueError:
        return axis.first


def studied(text: str, progress: str) -> Studied:
    """Compute the study of a case, never raising for what stands in it.

    Parameters
    ----------
    text : str
        The case with its block ``study``.
    progress : str
        File for `babbitt.app.progress`.
    """
    from babbitt.report.study_content import overview, study_tables
    from babbitt.report.study_figures import study_drawings
    from babbitt.study.plan import plan
    from babbitt.study.study import run_study

    try:
        case = read(text)
    except CaseError as error:
        return Studied(faults_of(error))
    try:
        if (asked := case.study_block) is None:
            raise InputError("E003", "study: is missing")
        study = run_study(plan(case, asked), watch=FileWatch(progress))
        tables = tuple(_table(one) for one in study_tables(study))
        drawn = study_drawings(study, "svg")
    except InputError as error:
        return Studied(faults_of(located(error, case, NAME)))
    figures = tuple(Figure(plain_text(one.name), one.caption, one.image.decode()) for one in drawn)
    return Studied((), overview(study), tables, figures, study)


def _table(table: Any) -> Table:
    heads = tuple(f"{name} {unit}".strip() for name, unit in table.columns)
    return Table(plain_text(table.title), heads, tuple(map(tuple, table.rows)), tuple(table.notes), table.words)


def study_file(study: Study, ending: str) -> bytes:
    """A study as a file: ``.csv``, ``.xlsx``, ``.pdf`` or ``.html``, as `babbitt study` writes them.

    Raises
    ------
    InputError
        E007 when a package for it is not installed.
    """
    if ending == ".csv":
        from babbitt.core.files.spreadsheet import rows_text
        from babbitt.report.study_workbook import study_rows

        return rows_text(study_rows(study)).encode()
    if ending == ".xlsx":
        from babbitt.report.study_workbook import study_workbook

        return study_workbook(study, f"study{ending}")
    from babbitt.core.language import written_in
    from babbitt.report.study_document import study_report
    from babbitt.report.study_output import language_of_study

    with written_in(language_of_study(study)):
        return study_report(study, ending)
