"""The page of `babbitt compare`: results of every method for one bearing, as one HTML file."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator, Sequence
from html import escape
from pathlib import Path

from babbitt.core.files.writing import require_writable, write_file
from babbitt.core.notices import InputError
from babbitt.report.comparison_table import AS_ASKED, compared_rows, contradiction, head, objected, spoken
from babbitt.report.document import GENERATOR_TAG, TEMPLATES
from babbitt.report.drawing import rendered, style
from babbitt.report.text import plain_text
from babbitt.study.comparison import Comparison, Variant

__all__ = ["comparison_page", "require_page", "write_comparison_page"]

CAPTION = "Least film thickness, friction power, oil flow and temperatures, as far as the methods tell them."


def write_comparison_page(comparisons: Sequence[Comparison], path: Path) -> None:
    """Write the page of all bearings compared.

    Parameters
    ----------
    comparisons : sequence of Comparison
    path : Path
        Ends in ``.html``.

    Raises
    ------
    InputError
        E007 for another suffix, a path that cannot be written, or matplotlib that is not installed.
    """
    require_page(path)
    write_file(path, comparison_page(comparisons).encode())


def require_page(path: Path) -> None:
    """Find out before any work is done whether a page can be written; raises as `write_comparison_page`."""
    if path.suffix.lower() != ".html":
        raise InputError("E007", f"cannot write {path}: the page of a comparison ends in .html")
    require_writable(path)


def comparison_page(comparisons: Sequence[Comparison]) -> str:
    """The page as HTML; equal for equal input."""
    css = (TEMPLATES / "report.css").read_text(encoding="utf-8")
    bodies = "\n".join(part for comparison in comparisons for part in _bearing(comparison))
    title = escape(", ".join(plain_text(one.name) for one in comparisons))
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head>{GENERATOR_TAG}<meta charset="utf-8">'
        f"<title>{title}: methods compared</title>"
        f"<style>\n{css}</style></head>\n<body>\n{bodies}\n</body></html>\n"
    )


def _bearing(comparison: Comparison) -> Iterator[str]:
    methods, others, asked = comparison.methods, comparison.choices, comparison.asked
    figure = list(_figure(comparison))
    yield f"<h1>{escape(plain_text(comparison.name))}</h1>"
    yield (
        f'<p class="method">The same bearing by {len(methods)} methods; the case asks for '
        f"{_text(asked.label)} (marked{AS_ASKED}). The methods differ in what they neglect: see the notes on each "
        f"below{' the figure' if figure else ''}.</p>"
    )
    if comparison.sentences:
        yield f"<h3>{_text(comparison.heading)}</h3>"
        yield from (f"<p>{_text(said)}</p>" for said in comparison.sentences)
    yield from figure
    yield "<h3>What each method sees and neglects</h3>"
    yield from _remarks(methods)
    for line in comparison.left_out.splitlines():
        yield f'<p class="note">{_text(line)}</p>'
    yield "<h3>Results side by side</h3>"
    yield from _table(comparison.compared, methods, asked)
    if comparison.note:
        yield f'<p class="note">{_text(comparison.note)}</p>'
    if others:
        yield "<h3>Other choices within a method</h3>"
        yield from _remarks(others)
        yield from _table(comparison.compared, others, asked)
    raised = [one for variant in comparison.variants for one in variant.result.warnings]
    warned = {one.code: one.message for one in reversed(raised)}  # by the first that raises it
    if warned:
        yield "<h3>Warnings</h3>"
        yield from (f'<p class="finding"><b>{code}</b>: {_text(warned[code])}</p>' for code in sorted(warned))
    assumed = list(dict.fromkeys(asked.result.assumptions))
    if assumed:
        yield f"<h3>What {_text(asked.label)} takes for granted</h3>"
        yield from (f'<p class="finding">{_text(said)}</p>' for said in assumed)


def _figure(comparison: Comparison) -> Iterator[str]:
    with style():
        figure = comparison.draw(comparison) if comparison.draw is not None else None
        drawn = b64encode(rendered(figure, "svg")).decode() if figure is not None else ""
    if not drawn:
        return
    caption = _text(f"{CAPTION} {comparison.caption}".strip())
    yield (
        f'<figure><img alt="{caption}" src="data:image/svg+xml;base64,{drawn}">'
        f"<figcaption>{caption}</figcaption></figure>"
    )


def _remarks(variants: Sequence[Variant]) -> Iterator[str]:
    if disagree := contradiction(variants):
        yield f'<p class="finding"><b>{_text(disagree)}</b></p>'
    for one in variants:
        said = f"<b>{_text(one.label)}</b>: {_text(one.remark)}."
        if not one.result.outcome.solved:
            said += f" No solution: {_text(one.result.outcome.value)}; {_text(one.result.message)}"
        if objections := objected(one.result):
            said += f" This result {_text(objections)}."
        yield f'<p class="finding">{said}</p>'


def _table(compared: Sequence[str], variants: Sequence[Variant], asked: Variant) -> Iterator[str]:
    heads = "".join(f'<th class="number">{_text(head(one, asked))}</th>' for one in variants)
    yield f'<div class="wide"><table class="sheet compared"><tr><th>quantity</th><th>unit</th>{heads}</tr>'
    for row in compared_rows(compared, variants):
        cells = "".join(f'<td class="number">{escape(cell)}</td>' for cell in row.cells)
        yield f"<tr><td>{escape(row.meaning)}</td><td>{escape(row.unit)}</td>{cells}</tr>"
    yield "</table></div>"


def _text(said: str) -> str:
    return escape(spoken(plain_text(said)))
