"""The page of `babbitt compare`: results of every method for one bearing, as one HTML file."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator, Sequence
from html import escape
from pathlib import Path

from babbitt.core.files.writing import require_writable, write_file
from babbitt.core.language import ENGLISH, keeping, language, translated, translated_if_known, written_in
from babbitt.core.notices import InputError
from babbitt.report.comparison_table import (
    AS_ASKED,
    compared_rows,
    contradiction,
    head,
    objected,
    spoken,
    told_left_out,
    warnings_of,
)
from babbitt.report.document import GENERATOR_TAG, TEMPLATES
from babbitt.report.drawing import rendered, style
from babbitt.report.names import shown_name
from babbitt.report.text import plain_text
from babbitt.report.us_words import OF_RESULTS, in_us_units
from babbitt.study.comparison import Comparison, Variant

__all__ = ["comparison_page", "require_page", "write_comparison_page"]

CAPTION = "Least film thickness, friction power, oil flow and temperatures, as far as the methods tell them."


def write_comparison_page(
    comparisons: Sequence[Comparison], path: Path, language_code: str = ENGLISH
) -> tuple[str, ...]:
    """Write the page of all bearings compared.

    Parameters
    ----------
    comparisons : sequence of Comparison
    path : Path
        Ends in ``.html``.
    language_code : {"en", "de", "ru"}

    Returns
    -------
    tuple of str
        Texts of the page that the language lacks, which stand there in English.

    Raises
    ------
    InputError
        E007 for another suffix, a path that cannot be written, or matplotlib that is not installed.
    """
    require_page(path)
    with written_in(language_code) as missing:
        made = comparison_page(comparisons)
    write_file(path, made.encode())
    return tuple(missing)


def require_page(path: Path) -> None:
    """Find out before any work is done whether a page can be written; raises as `write_comparison_page`."""
    if path.suffix.lower() != ".html":
        raise InputError("E007", f"cannot write {path}: the page of a comparison ends in .html")
    require_writable(path)


def comparison_page(comparisons: Sequence[Comparison]) -> str:
    """The page as HTML; equal for equal input."""
    css = (TEMPLATES / "report.css").read_text(encoding="utf-8")
    bodies = "\n".join(map(_kept, comparisons))
    names = ", ".join(shown_name(one.name) for one in comparisons)
    title = escape(translated("{names}: methods compared", names=names))
    return (
        f'<!DOCTYPE html>\n<html lang="{language()}"><head>{GENERATOR_TAG}<meta charset="utf-8">'
        f"<title>{title}</title>"
        f"<style>\n{css}</style></head>\n<body>\n{bodies}\n</body></html>\n"
    )


def _kept(comparison: Comparison) -> str:
    """The part of a bearing, with the words of its case as they are."""
    with keeping(comparison.own_words):
        return "\n".join(_bearing(comparison))


def _bearing(comparison: Comparison) -> Iterator[str]:
    methods, others, asked = comparison.methods, comparison.choices, comparison.asked
    figure = list(_figure(comparison))
    yield f"<h1>{escape(shown_name(comparison.name))}</h1>"
    about = translated(
        "The same bearing by {number} methods; the case asks for {label} (marked{mark}). The methods differ in "
        "what they neglect: see the notes on each {where}.",
        number=len(methods),
        label=spoken(asked.label),
        mark=AS_ASKED,
        where=translated("below the figure" if figure else "below"),
    )
    yield f'<p class="method">{_told(about)}</p>'
    if comparison.sentences:
        yield _heading(comparison.heading)
        yield from (f"<p>{_text(said)}</p>" for said in comparison.sentences)
    yield from figure
    yield _heading("What each method sees and neglects")
    yield from _remarks(methods)
    for line in comparison.left_out.splitlines():
        yield f'<p class="note">{escape(plain_text(told_left_out(line)))}</p>'
    yield _heading("Results side by side")
    yield from _table(comparison.compared, methods, asked)
    if comparison.note:
        yield f'<p class="note">{_text(comparison.note)}</p>'
    if others:
        yield _heading("Other choices within a method")
        yield from _remarks(others)
        yield from _table(comparison.compared, others, asked)
    if warned := warnings_of(comparison):
        yield _heading("Warnings")
        yield from (f'<p class="finding"><b>{code}</b>: {_told(said)}</p>' for code, said in warned.items())
    assumed = list(dict.fromkeys(asked.result.assumptions))
    if assumed:
        label = spoken(asked.label)
        yield f"<h3>{_told(translated('What {label} takes for granted', label=label))}</h3>"
        for said in assumed:
            yield f'<p class="finding">{_told(translated_if_known(said))}</p>'


def _heading(words: str) -> str:
    return f"<h3>{escape(translated(words))}</h3>"


def _figure(comparison: Comparison) -> Iterator[str]:
    with style():
        figure = comparison.draw(comparison) if comparison.draw is not None else None
        drawn = b64encode(rendered(figure, "svg")).decode() if figure is not None else ""
    if not drawn:
        return
    captions = (CAPTION, comparison.caption)
    caption = _told(" ".join(translated(one) for one in captions if one))
    yield (
        f'<figure><img alt="{caption}" src="data:image/svg+xml;base64,{drawn}">'
        f"<figcaption>{caption}</figcaption></figure>"
    )


def _remarks(variants: Sequence[Variant]) -> Iterator[str]:
    if disagree := contradiction(variants):
        yield f'<p class="finding"><b>{_told(disagree)}</b></p>'
    for one in variants:
        said = f"<b>{_text(one.label)}</b>: {_text(one.remark)}."
        if not one.result.outcome.solved:
            why = f"{translated(one.result.outcome.value)}; {one.result.message}"
            said += f" {_told(translated('No solution'))}: {_told(why)}"
        if objections := objected(one.result):
            said += f" {_told(translated('This result {objections}.', objections=objections))}"
        yield f'<p class="finding">{said}</p>'


def _table(compared: Sequence[str], variants: Sequence[Variant], asked: Variant) -> Iterator[str]:
    words = "".join(f"<th>{escape(translated(word))}</th>" for word in ("quantity", "unit"))
    heads = "".join(f'<th class="number">{_told(head(one, asked))}</th>' for one in variants)
    yield f'<div class="wide"><table class="sheet compared"><tr>{words}{heads}</tr>'
    for row in compared_rows(compared, variants):
        cells = "".join(f'<td class="number">{escape(cell)}</td>' for cell in row.cells)
        yield f"<tr><td>{escape(row.meaning)}</td><td>{escape(row.unit)}</td>{cells}</tr>"
    yield "</table></div>"


def _text(said: str) -> str:
    return escape(spoken(plain_text(said)))


def _told(said: str) -> str:
    """What is in the language already, in the units that are spoken."""
    return escape(str(in_us_units(plain_text(said), OF_RESULTS)))
