"""What a study tells, as tables of text: for the screen, the report and the summary of a workbook alike."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.check_text import distance
from babbitt.core.language import ENGLISH, decimal, language, phrases, translated
from babbitt.core.limited_flow import limited
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Verdict
from babbitt.report.columns import MARK
from babbitt.report.design_table import design_tables
from babbitt.report.size_table import size_tables
from babbitt.report.study_map import map_tables
from babbitt.report.study_values import (
    DASH,
    MARGIN_DECIMALS,
    Scale,
    StudyTable,
    bearing_text,
    check_title,
    input_scale,
    margin_text,
    output_scale,
    percent,
    reason_text,
    significant,
)
from babbitt.report.text import counted, plain_text
from babbitt.study.held_film import WITH_LIMITED_FLOW, as_read
from babbitt.study.indices import indices_of, slopes_of
from babbitt.study.optimum import Optimum, optimum_of
from babbitt.study.rows import Columns
from babbitt.study.spectrum import spectrum_summary
from babbitt.study.study import Study
from babbitt.study.yields import ALL, Capability, tolerance_summary

__all__ = ["StudyTable", "overview", "study_tables"]

MOST_ROWS = 200
"""Rows of a sweep that a table shows."""

LARGEST_CPK = 100.0
"""Beyond which its size tells nothing more: the margin scatters by less than a third of a hundredth of itself."""

SAMPLING = {"latin_hypercube": "Latin hypercube", "sobol": "Sobol sequence", "random": "random"}

WORDS = {verdict.key: verdict.value for verdict in Verdict}


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
    columns = _heads("field", "meaning", "values or distribution", "reason", "from", "to", "unit")
    return StudyTable(translated("What varies"), columns, tuple(rows), 4)


def _heads(*names: str) -> tuple[tuple[str, str], ...]:
    """Headings without units."""
    return tuple((translated(name), "") for name in names)


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
        if reason := _reason(study.columns, place):
            counts[reason] = counts.get(reason, 0) + 1
    if not counts:
        return None
    most = sorted(counts.items(), key=lambda pair: -pair[1])[:5]
    rows = tuple((reason, str(count)) for reason, count in most)
    return StudyTable(
        translated("Why rows have no solution"), _heads("reason, the most frequent ones", "rows"), rows
    )


def _reason(columns: Columns, place: int) -> str:
    """Why a row has no answer."""
    message, codes, status = (str(columns[name][place]) for name in ("message", "codes", "status"))
    return plain_text(reason_text(message, codes.partition(" ")[0], status))


def _scales(study: Study) -> tuple[dict[str, Scale], dict[str, Scale]]:
    inputs = {one["path"]: input_scale(one, _numbers(study, one)) for one in study.inputs}
    return inputs, {name: output_scale(name) for name in study.outputs}


def _numbers(study: Study, one: Mapping[str, Any]) -> Any:
    return None if "values" in one else study.columns[one["path"]]


def _bearings(columns: Columns) -> list[str]:
    return [str(one) for one in dict.fromkeys(columns["bearing"]) if one]


def _several(study: Study) -> bool:
    return len(_bearings(study.columns)) > 1


def line_table(
    study: Study, columns: Columns, title: str, first: str = "", notes: Sequence[str] = ()
) -> StudyTable:
    """Lines of a study as they stand, in engineers' units; `first` names a column that stands at their head."""
    inputs, outputs = _scales(study)
    several = _several(study)
    heads = [*_heads(first)] if first else []
    heads += [(scale.name, scale.unit) for scale in inputs.values()]
    heads += _bearing_head(several)
    heads += [(scale.name, scale.unit) for scale in outputs.values()]
    heads += _heads("margin", "governed by", "verdict", "codes")
    rows = []
    for place in range(min(columns["row"].size, MOST_ROWS)):
        cells = [str(columns[first][place])] if first else []
        cells += [scale.text(columns[path][place]) for path, scale in inputs.items()]
        cells += [bearing_text(str(columns["bearing"][place]))] if several else []
        cells += [
            scale.text(columns[name][place]) + _mark(columns, name, place) for name, scale in outputs.items()
        ]
        cells += [margin_text(columns, place)]
        status = str(columns["status"][place])
        verdict = translated(WORDS.get(str(columns["verdict"][place]), ""))
        cells += [str(columns["governing_check"][place]) or DASH]
        cells += [translated(status) if status == "refused" else verdict]
        rows.append((*cells, str(columns["codes"][place])))
    more = columns["row"].size - len(rows)
    said = [translated("{number} more rows are not shown; --xlsx or --out has all.", number=more)] * (more > 0)
    return StudyTable(title, tuple(heads), tuple(rows), 1 if first else 0, (*notes, *said))


def _mark(columns: Columns, name: str, place: int) -> str:
    """What marks the reading of a film with limited flow."""
    less = WITH_LIMITED_FLOW in columns and columns[WITH_LIMITED_FLOW][place]
    return MARK if less and limited(name) in QUANTITIES else ""


def _bearing_head(several: bool) -> tuple[tuple[str, str], ...]:
    """The heading of the bearings; none where there is one."""
    return _heads("bearing") if several else ()


def _sweep(study: Study) -> Iterator[StudyTable]:
    yield line_table(study, study.columns, translated("Results"))


def _table(study: Study) -> Iterator[StudyTable]:
    """The bearings of a table by their names, with their results; what was given stands in the table itself."""
    columns = study.columns | {"bearing": _names(study)}
    found = line_table(study, columns, translated("Bearings"), "bearing")
    left_out = len(study.inputs) + (1 if _several(study) else 0)
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
            _reason(columns, place),
        )
        for place in without
    )
    if rows:
        heads = _heads("bearing", "row", "status", "reason")
        note = translated(
            "Rows are numbered in the table that was given, from 0."
            if 0 in study.lines
            else "Rows are numbered as in the sheet, headings counted."
        )
        yield StudyTable(translated("Rows without an answer"), heads, rows, 4, (note,))


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
    names = _bearings(study.columns)
    places = [names.index(str(one)) if one else len(names) for one in study.columns["bearing"]]
    order = np.argsort(places, kind="stable")
    columns = {name: column[order] for name, column in study.columns.items()}
    yield line_table(study, columns, translated("Corners"))


def _tolerance(study: Study) -> Iterator[StudyTable]:
    found = tolerance_summary(study)
    yield StudyTable(
        translated("Yield"),
        _heads("", "samples", "within limits", "yield", "95 % from", "to", "unsolved", "interval by"),
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
    several = _several(study)
    yield StudyTable(
        translated("Checks"),
        _bearing_head(several) + _heads("check", "failed", "share") + (("Cpk", ""),) + _heads("Cpk holds"),
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


def _mean(symbol: str) -> str:
    return translated("mean {symbol}", symbol=symbol)


def _spread_table(study: Study, spreads: Sequence[Any], several: bool) -> StudyTable:
    ranks = sorted(next((one.percentiles for one in spreads), {}))
    heads = _bearing_head(several) + _heads("quantity") + ((_mean("").strip(), ""), ("σ", ""))
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
    columns = (*heads, *_heads("least"), *percentiles, *_heads("largest"))
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
    heads = _bearing_head(several) + _heads("result")
    rows = tuple(
        ((bearing_text(bearing),) if several else ())
        + (_result_name(output), *(_signed(shares.get(path, math.nan)) for path in paths))
        for (bearing, output), shares in tornado.items()
    )
    note = translated(
        "Squared rank correlation (Spearman), in percent; a minus: the result falls as the field rises."
    )
    columns = (*heads, *((path, "%") for path in paths))
    return StudyTable(translated("What drives the scatter"), columns, rows, 2 if several else 1, (note,))


def _result_name(output: str) -> str:
    """What a result is called: its symbol, or the margin."""
    return translated(output) if output == "margin" else output_scale(output).name


def _signed(share: float) -> str:
    return decimal(f"{100.0 * share:.1f}") if math.isfinite(share) else DASH


def _sensitivity(study: Study) -> Iterator[StudyTable]:
    several = _several(study)
    paths = [one["path"] for one in study.inputs]
    lead = _bearing_head(several)
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
    heads = (*lead, *_heads("result", "index"), *((path, "") for path in paths))
    yield StudyTable(translated("Sobol indices"), heads, tuple(rows), 3 if several else 2, tuple(notes))
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
    heads = (*lead, *_heads("result"), *((path, "") for path in paths))
    yield StudyTable(translated("Slopes at the medians"), heads, tuple(rows), 2 if several else 1, (note,))


def _spectrum(study: Study) -> Iterator[StudyTable]:
    block = study.block
    shares = [one.share for one in block.load_cases]
    columns = dict(study.columns)
    names = [
        f"{study.columns['group'][place]} ({percent(shares[row])})" for place, row in enumerate(columns["row"])
    ]
    columns["load case"] = np.array(names, object)
    yield line_table(study, columns, translated("Load cases"), "load case")
    heads = _heads("bearing", "governing load case", "check", "margin")
    scales = {name: output_scale(name) for name in study.outputs}
    heads += tuple((_mean(scale.name), scale.unit) for scale in scales.values())
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
    yield StudyTable(translated("Over the spectrum"), (*heads, energy), rows, 3, (note,))
    margins = tuple(
        (
            bearing_text(one.bearing),
            check_title(code),
            distance(value, one.worst_kelvins.get(code, math.nan), MARGIN_DECIMALS),
        )
        for one in spectrum_summary(study)
        for code, value in sorted(one.worst_margins.items(), key=lambda pair: pair[1])
    )
    yield StudyTable(translated("Worst margins"), _heads("bearing", "check", "margin"), margins, 2)


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
    "tolerance": _tolerance,
    "map": map_tables,
    "size": size_tables,
    "sensitivity": _sensitivity,
    "spectrum": _spectrum,
    "optimise": _optimise,
    "table": _table,
    "design": design_tables,
}
