"""The report of a study: its tables, its figures, and the case with the study as it was given."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from babbitt.case.loading import STUDY, read_tree
from babbitt.case.parts.study import StudyBlock
from babbitt.case.with_units import case_text
from babbitt.core.files.writing import require_writable, write_file
from babbitt.core.language import language, phrases, translated, translated_if_known
from babbitt.core.units import AS_WRITTEN
from babbitt.report.document import FORMATS, typeset
from babbitt.report.study_content import StudyTable, overview, study_tables
from babbitt.report.study_figures import study_drawings
from babbitt.report.text import plain_lines, plain_text
from babbitt.study.study import Study

__all__ = ["report_content", "study_report", "write_study_report"]

LONG = 40
"""Letters of a cell beyond which words share the width of a page."""


def write_study_report(study: Study, path: Path) -> None:
    """Write the report of a study; the suffix says what: ``.pdf`` or ``.html``.

    Raises
    ------
    InputError
        E007 for a path that cannot be written, or a package that is not installed.
    """
    require_writable(path)
    write_file(path, study_report(study, path.suffix.lower()))


def study_report(study: Study, suffix: str) -> bytes:
    """The report of a study, typeset; equal for equal input."""
    return typeset(report_content(study), "study.typ", FORMATS[suffix])


def report_content(study: Study) -> dict[str, Any]:
    """Everything that the report of a study says, in the language that is written now."""
    told = study.description
    return {
        "language": language(),
        "words": dict(phrases(language())),
        "name": _name(study) or translated("Unnamed case"),
        "version": str(told["babbitt"]),
        "hash": str(told["case_hash"]),
        "overview": overview(study),
        "source": plain_text(str(told["case"].get("source", ""))),
        "notes": plain_text(str(told["case"].get("notes", ""))),
        "tables": [_table(one) for one in study_tables(study)],
        "figures": [{"caption": one.caption, "svg": one.image.decode()} for one in study_drawings(study, "svg")],
        "text": plain_lines(_text(told)).strip("\n"),
    }


def _name(study: Study) -> str:
    """The name of the case; that of a duty says what it is in the language of the report."""
    name = str(study.description["name"])
    return plain_text(translated_if_known(name) if study.kind == "design" else name)


def _text(told: Mapping[str, Any]) -> str:
    """The case as it was read, and below it the study where that stands elsewhere or was completed."""
    text = str(told["text"])
    stated = (read_tree(text, "").plain() if text else {}).get(STUDY)
    if stated is not None:
        block = StudyBlock.model_validate(stated, context=AS_WRITTEN)
        if block.model_dump(exclude_defaults=True, mode="json") == told["study"]:
            return text
    return f"{text.rstrip()}\n\n# {translated('The study that was computed')}\n{case_text({STUDY: told['study']})}"


def _table(table: StudyTable) -> dict[str, Any]:
    return {
        "title": table.title,
        "columns": [list(column) for column in table.columns],
        "rows": [list(row) for row in table.rows],
        "words": table.words,
        "long": [any(len(cell) > LONG for cell in column) for column in zip(*table.rows, strict=True)],
        "notes": list(table.notes),
    }
