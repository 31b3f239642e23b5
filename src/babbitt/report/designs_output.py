"""Designs side by side as JSON, CSV, workbook and page: checked before all work, written after it."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from pathlib import Path
from typing import Any

from babbitt import __version__
from babbitt.core.check_text import comparison
from babbitt.core.files.spreadsheet import Cell, rows_text, workbook
from babbitt.core.files.writing import require_distinct, require_writable, write_file
from babbitt.core.language import keeping, language, translated, written_in
from babbitt.core.quantities import QUANTITIES
from babbitt.report.comparison_page import require_page
from babbitt.report.designs_table import bearing_rows, kinds_said
from babbitt.report.document import GENERATOR_TAG, TEMPLATES
from babbitt.report.languages import chosen_language
from babbitt.report.names import shown_name
from babbitt.report.sweep_output import require_ending
from babbitt.report.text import plain_text
from babbitt.report.us_words import in_us_units
from babbitt.study.designs import ComparedBearing, Designs

__all__ = ["designs_page", "designs_record", "designs_rows", "require_designs_outputs", "write_designs_outputs"]


def require_designs_outputs(
    inputs: Mapping[Path, str], record: Path | None, table: Path | None, page: Path | None
) -> None:
    """Find out before any work is done whether a comparison can be written.

    Raises
    ------
    InputError
        E007 for a path that cannot be written, another ending, one path for two outputs, and an output that would
        replace an input.
    """
    outputs = [output for output in (record, table, page) if output is not None]
    require_distinct(outputs, inputs)
    if table is not None:
        require_ending(table)
    if page is not None:
        require_page(page)
    for output in outputs:
        require_writable(output)


def write_designs_outputs(
    designs: Designs, record: Path | None, table: Path | None, page: Path | None, language_code: str | None = None
) -> tuple[str, ...]:
    """Write a comparison as JSON, as table and as HTML page, as far as asked for.

    Parameters
    ----------
    designs : Designs
    record, table, page : Path or None
    language_code : {"en", "de", "ru"}, optional
        Language of the page; that of the title block of the first case if not given, English if that has none.

    Returns
    -------
    tuple of str
        Texts of the page that the language lacks, which stand there in English.

    Raises
    ------
    InputError
        E005 for a language that is not known, or that lacks the words of a kind; E007 for a file that cannot be
        written.
    """
    if record is not None:
        text = json.dumps(designs_record(designs), indent=2, ensure_ascii=False, allow_nan=False) + "\n"
        write_file(record, text.encode())
    if table is not None:
        rows = designs_rows(designs)
        if table.suffix.lower() == ".xlsx":
            changed: list[Sequence[Cell]] = [("field", *designs.labels)]
            changed += [(one.path, *one.shown) for one in designs.changed]
            write_file(table, workbook({"Results": rows, "Changed inputs": changed}, str(table)))
        else:
            write_file(table, rows_text(rows).encode())
    if page is not None:
        kinds = (one.kind for machine in designs.machines for one in machine.results)
        chosen = chosen_language(designs.machines[0].title_block, kinds, language_code)
        with written_in(chosen) as missing:
            made = designs_page(designs)
        write_file(page, made.encode())
        return tuple(missing)
    return ()


def designs_record(designs: Designs) -> dict[str, Any]:
    """The comparison as plain data, values in SI."""
    return {
        "babbitt": __version__,
        "designs": [
            {"label": label, "name": machine.name, "kind": kind, "case_hash": machine.case_hash}
            for label, machine, kind in zip(designs.labels, designs.machines, designs.kinds, strict=True)
        ],
        "changed_inputs": [
            {"path": one.path, "values": dict(zip(designs.labels, one.values, strict=True))}
            for one in designs.changed
        ],
        "bearings": [_bearing_record(designs, one) for one in designs.bearings],
    }


def _bearing_record(designs: Designs, bearing: ComparedBearing) -> dict[str, Any]:
    present = [(label, one) for label, one in zip(designs.labels, bearing.results, strict=True) if one is not None]
    solved = [(label, one) for label, one in present if one.outcome.solved]
    return {
        "name": str(bearing.name),
        "designs": {
            label: {
                "outcome": one.outcome.name.lower(),
                "verdict": one.verdict.key,
                "governing_check": None if one.governing_check is None else comparison(one.governing_check),
                "warnings": [warning.code for warning in one.warnings],
            }
            for label, one in present
        },
        "values": {
            name: {
                "unit": QUANTITIES[name].unit,
                **{label: one.values[name] for label, one in solved if name in one.values},
            }
            for name in bearing.quantities
        },
    }


def designs_rows(designs: Designs) -> list[Sequence[Cell]]:
    """A row for each bearing and quantity in SI: its value in each design, differences in % of the first."""
    head: Sequence[Cell] = (
        "bearing", "quantity", "unit", *designs.labels,
        *(f"{label} against {designs.labels[0]} [%]" for label in designs.labels[1:]),
    )  # fmt: skip
    return [head, *(row for bearing in designs.bearings for row in _rows(bearing))]


def _rows(bearing: ComparedBearing) -> Iterator[Sequence[Cell]]:
    for name in bearing.quantities:
        values = [
            one.values.get(name) if one is not None and one.outcome.solved else None for one in bearing.results
        ]
        first = values[0]
        shares = [
            100.0 * (other - first) / abs(first) if first and other is not None else "" for other in values[1:]
        ]
        cells = ["" if value is None else value for value in values]
        yield (str(bearing.name), name, QUANTITIES[name].unit, *cells, *shares)
    verdicts = ["" if one is None else one.verdict.value for one in bearing.results]
    checks = [
        "" if one is None or one.governing_check is None else comparison(one.governing_check)
        for one in bearing.results
    ]
    nothing = [""] * (len(verdicts) - 1)
    yield (str(bearing.name), "verdict", "", *verdicts, *nothing)
    yield (str(bearing.name), "governing_check", "", *checks, *nothing)


def designs_page(designs: Designs) -> str:
    """The comparison as one HTML page; equal for equal input."""
    css = (TEMPLATES / "report.css").read_text(encoding="utf-8")
    title = _text(translated("{designs}: designs compared", designs=_joined(designs.labels)))
    with keeping(word for machine in designs.machines for word in machine.own_words):
        body = "\n".join(_body(designs))
    return (
        f'<!DOCTYPE html>\n<html lang="{language()}"><head>{GENERATOR_TAG}<meta charset="utf-8">'
        f"<title>{title}</title>"
        f"<style>\n{css}</style></head>\n<body>\n" + body + "\n</body></html>\n"
    )


def _body(designs: Designs) -> Iterator[str]:
    yield f"<h1>{_text(_joined(designs.labels))}</h1>"
    names = ", ".join(
        f"{label}: {machine.name} ({kind})"
        for label, machine, kind in zip(designs.labels, designs.machines, designs.kinds, strict=True)
    )
    against = translated("Differences count against {design}.", design=designs.labels[0])
    yield f'<p class="method">{_text(names)}. {_text(against)}</p>'
    if said := kinds_said(designs):
        yield f'<p class="finding"><b>{_text(said)}</b></p>'
    yield f"<h3>{translated('Changed inputs')}</h3>"
    if designs.changed:
        yield from _table(
            (translated("field"),), designs.labels, ((one.path, *one.shown) for one in designs.changed)
        )
    else:
        yield f"<p>{translated('No input differs.')}</p>"
    differences = tuple(
        translated("{design} against {first}", design=label, first=designs.labels[0])
        for label in designs.labels[1:]
    )
    for bearing in designs.bearings:
        yield f"<h3>{_text(shown_name(bearing.name))}</h3>"
        rows = ((one.meaning, one.unit, *one.cells, *one.differences) for one in bearing_rows(bearing))
        yield from _table((translated("quantity"), translated("unit")), (*designs.labels, *differences), rows)
        for label, result in zip(designs.labels, bearing.results, strict=True):
            if result is None:
                lacks = translated("has no such bearing.")
                yield f'<p class="finding"><b>{_text(label)}</b> {lacks}</p>'
                continue
            if not result.outcome.solved:
                yield f'<p class="finding"><b>{_text(label)}</b>: {_text(in_us_units(result.message))}</p>'
            for warning in result.warnings:
                said = f"{warning.code} {in_us_units(warning.message)}"
                yield f'<p class="finding"><b>{_text(label)}</b>: {_text(said)}</p>'


def _joined(labels: Sequence[str]) -> str:
    return f" {translated('and')} ".join(labels)


def _table(words: Sequence[str], numbers: Sequence[str], rows: Iterator[tuple[str, ...]]) -> Iterator[str]:
    heads = "".join(f"<th>{_text(one)}</th>" for one in words)
    heads += "".join(f'<th class="number">{_text(one)}</th>' for one in numbers)
    yield f'<div class="wide"><table class="sheet"><tr>{heads}</tr>'
    for row in rows:
        cells = "".join(f"<td>{_text(cell)}</td>" for cell in row[: len(words)])
        cells += "".join(f'<td class="number">{_text(cell)}</td>' for cell in row[len(words) :])
        yield f"<tr>{cells}</tr>"
    yield "</table></div>"


def _text(said: str) -> str:
    return escape(plain_text(said))
