"""The report on paper and on screen: one template, typeset by typst as PDF or as HTML with MathML."""

from __future__ import annotations

import datetime
import json
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from babbitt import __version__
from babbitt.core.files.marks import CREATOR
from babbitt.core.files.writing import require_writable, write_file
from babbitt.core.language import written_in
from babbitt.core.nearest_name import unknown_name
from babbitt.core.notices import InputError
from babbitt.core.quantities import SYSTEMS, displayed_in
from babbitt.core.report_level import Level
from babbitt.report.content import content
from babbitt.report.drawing import missing_extra
from babbitt.report.languages import chosen_language
from babbitt.report.text import needs_system_fonts
from babbitt.report.title_block import title_content

if TYPE_CHECKING:
    from babbitt.solving import MachineResult

GENERATOR = f"{CREATOR} {__version__}"
"""The mark of a report."""

GENERATOR_TAG = f'<meta name="generator" content="{GENERATOR}">'
"""The same in the head of a page."""

TEMPLATES = Path(__file__).parent / "templates"

Format = Literal["pdf", "html"]

STANDARDS: dict[str, Literal["ua-1"]] = {"pdf": "ua-1"}
"""A PDF is one that screen readers can read (PDF/UA-1, ISO 14289-1): tagged, with alternative texts."""

UNSHOWN = "could not be displayed with font"
"""What typst says of a letter for which it has no typeface, which PDF/UA-1 forbids."""

FORMATS: dict[str, Format] = {".pdf": "pdf", ".html": "html"}
"""Suffix of the file and format of the report."""


def write_report(
    machine: MachineResult,
    path: Path,
    level: Level | str = Level.STANDARD,
    units: str = "si",
    language: str | None = None,
) -> tuple[str, ...]:
    """Write the report of a machine.

    Parameters
    ----------
    machine : MachineResult
    path : Path
        The suffix says what is written: ``.pdf``, or ``.html`` as one file that needs nothing else.
    level : Level or {"standard", "summary", "full"}
        Inputs, results, checks and figures of every bearing; the machine alone; calculation and case file, too.
    units : {"si", "us"}
        Of texts, tables and figures; lines of the calculation stay in SI, and so does the case file.
    language : {"en", "de", "ru"}, optional
        That of the title block of the case if not given, English if that has none.

    Returns
    -------
    tuple of str
        Texts of the report that the language lacks, which stand there in English.

    Raises
    ------
    InputError
        E005 for an unknown level, system of units or language, or one without words for a kind; E007 for an
        unknown suffix, a path that cannot be written, or a package that is not installed. Nothing is left then.
    """
    path = Path(path)
    if level not in (known := [one.value for one in Level]):
        raise InputError("E005", unknown_name(level, known, "a level of reports"))
    if units not in SYSTEMS:
        raise InputError("E005", unknown_name(units, SYSTEMS, "a system of units"))
    chosen = language_of(machine, language)
    if path.suffix.lower() not in FORMATS:
        given = f"not {path.suffix}" if path.suffix else "and the name given has no suffix"
        raise InputError("E007", f"cannot write {path}: a report ends in .pdf or .html, {given}")
    require_writable(path)
    with displayed_in(units), written_in(chosen) as missing:
        made = report(machine, FORMATS[path.suffix.lower()], Level(level))
    write_file(path, made)
    return tuple(missing)


def language_of(machine: MachineResult, asked: str | None = None) -> str:
    """The language in which to write of a machine: the one asked for, else that of its title block, else English.

    Raises
    ------
    InputError
        E005 for one that is not known, or that lacks the words of a kind of the machine.
    """
    return chosen_language(machine.title_block, (result.kind for result in machine.results), asked)


def report(machine: MachineResult, report_format: Format, level: Level = Level.STANDARD) -> bytes:
    """The report of a machine, typeset.

    Parameters
    ----------
    machine : MachineResult
    report_format : {"pdf", "html"}
    level : Level

    Returns
    -------
    bytes
        Equal for equal input and date: no time, no name of the computer.
    """
    title = title_content(machine.title_block, datetime.date.today())
    return typeset(content(machine, level) | {"title": title}, "report.typ", report_format)


def typeset(data: Any, template: str, report_format: Format) -> bytes:
    """What a template makes of texts and numbers.

    A PDF follows PDF/UA-1; where the case has letters that no typeface at hand can show, it is tagged alike and
    does not claim the standard.

    Raises
    ------
    InputError
        E007 when typst is not installed.
    """
    try:
        import typst
    except ImportError:
        raise missing_extra("typst", "reports") from None
    fonts = typst.Fonts(include_system_fonts=needs_system_fonts("".join(_texts(data))))
    compiler = typst.Compiler(
        input=TEMPLATES / template,
        root=TEMPLATES,
        font_paths=fonts,
        sys_inputs={"data": json.dumps(data), "format": report_format, "generator": GENERATOR},
    )
    try:
        made = compiler.compile(format=report_format, timestamp=0, pdf_standards=STANDARDS.get(report_format))
    except typst.TypstError as error:
        if UNSHOWN not in str(error):
            raise
        made = compiler.compile(format=report_format, timestamp=0)
    assert isinstance(made, bytes), "PDF and HTML are one file each"
    return _with_style(made) if report_format == "html" else made


def _with_style(page: bytes) -> bytes:
    style = (TEMPLATES / "report.css").read_text(encoding="utf-8")
    marked = page.replace(b"<head>", f"<head>{GENERATOR_TAG}".encode(), 1)
    return marked.replace(b"</head>", f"<style>\n{style}</style></head>".encode(), 1)


def _texts(data: Any) -> Iterator[str]:
    """All texts of a report but its figures and equations."""
    if isinstance(data, str):
        yield data
    elif isinstance(data, dict):
        for key, part in data.items():
            if key not in ("svg", "bytes", "symbol", "formula", "substituted", "heading", "number"):
                yield from _texts(part)
    elif isinstance(data, list | tuple):
        for part in data:
            yield from _texts(part)
