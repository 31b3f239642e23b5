"""What a study tells, as tables of text: for the screen, the report and the summary of a workbook alike."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from babbitt.core.check_text import distance
from babbitt.core.language import ENGLISH, decimal, language, phrases, translated
from babbitt.core.result import Verdict
from babbitt.report.columns import MARK
from babbitt.report.design_table import design_tables
from babbitt.report.sensitivity_table import sensitivity_tables
from babbitt.report.size_table import size_tables
from babbitt.report.study_lines import (
    MOST_ROWS,
    WORDS,
    bearings_in,
    has_several,
    heads,
    line_table,
    mean_heading,
    reason_at,
)
from babbitt.report.study_map import map_tables
from babbitt.report.study_values import (
    DASH,
    MARGIN_DECIMALS,
    StudyTable,
    bearing_text,
    check_title,
    input_scale,
    output_scale,
    percent,
    significant,
)
from babbitt.report.text import counted, plain_text
from babbitt.report.tolerance_table import tolerance_tables
from babbitt.study.held_film import WITH_LIMITED_FLOW, as_read
from babbitt.study.optimum import Optimum, optimum_of
from babbitt.study.rows import Columns
from babbitt.study.spectrum import spectrum_summary
from babbitt.study.study import Study

__all__ = ["StudyTable", "overview", "study_tables"]


SAMPLING = {"latin_hypercube": "Latin hypercube", "sobol": "Sobol sequence", "random": "random"}


def overview(study: Study) -> str:
    """What was computed, in a sentence, and which films are shown where the supply delivers too little."""
    read = as_read(study).columns
    rows = np.unique(read["row"][read[WITH_LIMITED_FLOW]]).size if WITH_LIMITED_FLOW in read else 0
    if not rows:
        return _computed(study)
    said = translated(
        "In {rows} the supply delivers less oil than the film wants; readings there are of the film with what it "
        "delivers ({mark}), against which the limits are held.",
        rows=counted(rows, "row"),
        mark=MARK,
    )
    return f"{_computed(study)} {said}"


def _computed(study: Study) -> str:
    block = study.block
    planned = int(study.description["rows"])
    without = _without_solution(study.columns)
    done = (
        translated("{number} of {planned} rows", number=study.rows, planned=planned)
        if not study.complete and block.kind not in ("optimise", "size", "design")
        else translated("{number} rows", number=study.rows)
    )
    drawn = ""
    if block.kind == "tolerance":
        sampling, number = translated(SAMPLING[block.sampling]), sum(study.description["batches"])
        drawn = translated(
            ", {sampling} of {number} samples, seed {seed}", sampling=sampling, number=number, seed=block.seed
        )
    if block.kind == "table":
        drawn = translated(" of {table}", table=plain_text(str(block.rows)))
    if block.kind in ("sensitivity", "optimise"):
        drawn = translated(", seed {seed}", seed=block.seed)
    refused = int(np.unique(study.columns["row"][study.columns["status"] == "refused"]).size)
    said = translated(", {number} of them refused", number=refused) if refused else ""
    return translated(
        "Study of {kind}: {done}{drawn}; {without} without a solution{refused}.",
        kind=translated(f"kind {block.kind}"),
        done=done,
        drawn=drawn,
        without=without,
        refused=said,
    )


def _without_solution(columns: Columns) -> int:
    return int(np.unique(columns["row"][columns["verdict"] == Verdict.NO_SOLUTION.key]).size)


def study_tables(study: Study) -> tuple[StudyTable, ...]:
    """The tables of a study, what matters most first, of the films that limits are held against."""
    study = as_read(study)
    made = list(_OF_KIND[study.kind](study))
    if study.kind == "table":
        return tuple(made)
    made.append(_input_table(study))
    if (lost := _reasons(study)) is not None:
        made.append(lost)
    return tuple(made)


def _input_table(study: Study) -> StudyTable:
    rows = []
    for one in study.inputs:
        scale = input_scale(one)
        ends = one["values"] if "values" in one else [scale.text(end) for end in one["support"]]
        first, last = (scale.text(str(ends[0])), scale.text(str(ends[-1]))) if ends else (DASH, DASH)
        rows.append(
            (
                plain_text(one["path"]),
                _meaning(one["meaning"]),
                translated(one["law"]),
                translated(one["reason"]),
                first,
                last,
                scale.unit,
            )
        )
    columns = heads("field", "meaning", "values or distribution", "reason", "from", "to", "unit")
    return StudyTable(translated("What varies"), columns, tuple(rows), 4)


def _meaning(meaning: str) -> str:
    """What a field is; a dash where the language has no words for it, since its path stands beside."""
    said = _first_words(meaning)
    if language() == ENGLISH:
        return said
    made_here = said.startswith("Share of ") or said.endswith(", on the diameter")
    return translated(said) if made_here else phrases(language()).get(said, DASH)


def _first_words(meaning: str) -> str:
    """What a field is, without how it is written.

    >>> _first_words("Method of calculation: the procedure of ISO 7902, or the film")
    'Method of calculation'
    """
    return re.split(r"\. |: |, or |, such as ", meaning, maxsplit=1)[0]


def _reasons(study: Study) -> StudyTable | None:
    """Why rows have no answer, the most frequent first; None where all have one."""
    lost = study.columns["verdict"] == Verdict.NO_SOLUTION.key
    counts: dict[str, int] = {}
    for place in np.flatnonzero(lost).tolist():
        if reason := reason_at(study.columns, place):
            counts[reason] = counts.get(reason, 0) + 1
    if not counts:
        return None
    most = sorted(counts.items(), key=lambda pair: -pair[1])[:5]
    rows = tuple((reason, str(count)) for reason, count in most)
    return StudyTable(
        translated("Why rows have no solution"), heads("reason, the most frequent ones", "rows"), rows
    )


def _sweep(study: Study) -> Iterator[StudyTable]:
    yield line_table(study, study.columns, translated("Results"))


def _table(study: Study) -> Iterator[StudyTable]:
    """The bearings of a table by their names, with their results; what was given stands in the table itself."""
    columns = study.columns | {"bearing": _names(study)}
    found = line_table(study, columns, translated("Bearings"), "bearing")
    left_out = len(study.inputs) + (1 if has_several(study) else 0)
    kept = [place for place in range(len(found.columns)) if not 1 <= place <= left_out]
    verdicts = [WORDS[str(one)] for one in columns["verdict"]]
    said = ", ".join(f"{verdicts.count(word)} {translated(word)}" for word in WORDS.values() if word in verdicts)
    yield StudyTable(
        found.title,
        tuple(found.columns[place] for place in kept),
        tuple(tuple(plain_text(row[place]) for place in kept) for row in found.rows),
        1,
        (*found.notes, f"{said}."),
    )
    yield from _refused(study)


def _refused(study: Study) -> Iterator[StudyTable]:
    """Rows without an answer, each with its reason."""
    columns = study.columns
    without = np.flatnonzero(columns["message"] != "")[:MOST_ROWS]
    names = _names(study)
    rows = tuple(
        (
            *(plain_text(names[place]), str(study.lines[place]), _status(str(columns["status"][place]))),
            reason_at(columns, place),
        )
        for place in without
    )
    if rows:
        headings = heads("bearing", "row", "status", "reason")
        note = translated(
            "Rows are numbered in the table that was given, from 0."
            if 0 in study.lines
            else "Rows are numbered as in the sheet, headings counted."
        )
        yield StudyTable(translated("Rows without an answer"), headings, rows, 4, (note,))


def _status(status: str) -> str:
    """How a row ended: in English by its name, as in files."""
    if language() == ENGLISH:
        return status
    return translated(status if status in ("refused", "error") else "no solution")


def _names(study: Study) -> NDArray[np.object_]:
    """The bearing of each line: that of its result, else its name in the table, else the number of its row."""
    columns = study.columns
    given = columns.get("name", np.full(columns["row"].size, "", object))
    lines = zip(columns["bearing"], given, study.lines, strict=True)
    return np.array(
        [
            bearing_text(str(one)) or str(name) or translated("row {number}", number=row)
            for one, name, row in lines
        ],
        object,
    )


def _corners(study: Study) -> Iterator[StudyTable]:
    """All corners of one bearing below each other."""
    names = bearings_in(study.columns)
    places = [names.index(str(one)) if one else len(names) for one in study.columns["bearing"]]
    order = np.argsort(places, kind="stable")
    columns = {name: column[order] for name, column in study.columns.items()}
    yield line_table(study, columns, translated("Corners"))


def _spectrum(study: Study) -> Iterator[StudyTable]:
    block = study.block
    shares = [one.share for one in block.load_cases]
    columns = dict(study.columns)
    names = [
        f"{study.columns['group'][place]} ({percent(shares[row])})" for place, row in enumerate(columns["row"])
    ]
    columns["load case"] = np.array(names, object)
    yield line_table(study, columns, translated("Load cases"), "load case")
    headings = heads("bearing", "governing load case", "check", "margin")
    scales = {name: output_scale(name) for name in study.outputs}
    headings += tuple((mean_heading(scale.name), scale.unit) for scale in scales.values())
    rows = tuple(
        (
            *(bearing_text(one.bearing), plain_text(one.governing_case), one.governing_check or DASH),
            distance(one.margin, one.worst_kelvins.get(one.governing_check, math.nan), MARGIN_DECIMALS),
            *(scale.text(one.means[name]) for name, scale in scales.items()),
            significant(one.yearly_energy / 3.6e6),
        )
        for one in spectrum_summary(study)
    )
    note = translated("Energy of friction in {hours} hours.", hours=decimal(f"{block.hours_per_year:g}"))
    energy = (translated("energy a year"), "kWh")
    yield StudyTable(translated("Over the spectrum"), (*headings, energy), rows, 3, (note,))
    margins = tuple(
        (
            bearing_text(one.bearing),
            check_title(code),
            distance(value, one.worst_kelvins.get(code, math.nan), MARGIN_DECIMALS),
        )
        for one in spectrum_summary(study)
        for code, value in sorted(one.worst_margins.items(), key=lambda pair: pair[1])
    )
    yield StudyTable(translated("Worst margins"), heads("bearing", "check", "margin"), margins, 2)


def _optimise(study: Study) -> Iterator[StudyTable]:
    found: Optimum = optimum_of(study)
    if not found.rows:
        nearest = study.columns["row"] == found.nearest
        columns = {name: column[nearest] for name, column in study.columns.items()}
        note = translated("No design that was computed keeps all limits; this one misses them least.")
        yield line_table(study, columns, translated("Nearest miss"), "row", (note,))
        return
    wanted = [np.flatnonzero(study.columns["row"] == row) for row in found.rows]
    places = np.concatenate(wanted)
    columns = {name: column[places] for name, column in study.columns.items()}
    goals = [translated("least {symbol}", symbol=output_scale(name).name) for name in study.block.minimise]
    goals += [translated("largest {symbol}", symbol=output_scale(name).name) for name in study.block.maximise]
    title = translated("Pareto set" if len(goals) > 1 else "Best design")
    note = translated(
        "{title}: {goals}; {feasible} of {rows} designs keep all limits.",
        title=title,
        goals=", ".join(goals),
        feasible=found.feasible,
        rows=study.rows,
    )
    yield line_table(study, columns, title, "row", (note,))


_OF_KIND: Mapping[str, Callable[[Study], Iterator[StudyTable]]] = {
    "sweep": _sweep,
    "corners": _corners,
    "tolerance": tolerance_tables,
    "map": map_tables,
    "size": size_tables,
    "sensitivity": sensitivity_tables,
    "spectrum": _spectrum,
    "optimise": _optimise,
    "table": _table,
    "design": design_tables,
}
