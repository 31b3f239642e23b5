"""Several designs side by side, as results of the front door."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from babbitt.case.case_file import CaseFile
from babbitt.core.optional_package import optional_package

if TYPE_CHECKING:
    import pandas

    from babbitt.study import designs as study

__all__ = ["DesignComparison", "compare"]


@dataclass(frozen=True, repr=False)
class DesignComparison:
    """Designs side by side; differences count against the first.

    Parameters
    ----------
    engine : babbitt.study.designs.Designs
    """

    engine: study.Designs

    @property
    def labels(self) -> tuple[str, ...]:
        """By what the designs are called."""
        return self.engine.labels

    @property
    def changed(self) -> dict[str, tuple[str, ...]]:
        """By its path every input in which the designs differ, its text in each."""
        return {one.path: one.values for one in self.engine.changed}

    def to_dict(self) -> dict[str, Any]:
        """What `babbitt compare --json` writes."""
        from babbitt.report.designs_output import designs_record

        return designs_record(self.engine)

    def to_dataframe(self) -> pandas.DataFrame:
        """A row for each bearing and quantity, in SI, with differences in per cent.

        Raises
        ------
        InputError
            E007 where pandas is not installed.
        """
        from babbitt.report.designs_output import designs_rows

        package = optional_package("pandas", "tables", "Install it with: pip install pandas")
        head, *rows = designs_rows(self.engine)
        frame: pandas.DataFrame = package.DataFrame(rows, columns=list(head))
        return frame

    def report(self, path: str | Path, language: str | None = None) -> None:
        """Write the page; ``.html``.

        `language` is "en", "de" or "ru", that of the title block of the first case if not given.

        Raises
        ------
        InputError
            E005 for a language without the words of a kind; E007 for another ending or a path that cannot be
            written.
        """
        from babbitt.report.designs_output import require_designs_outputs, write_designs_outputs

        require_designs_outputs({}, None, None, Path(path))
        write_designs_outputs(self.engine, None, None, Path(path), language)

    def __repr__(self) -> str:
        from babbitt.report.designs_table import short_designs

        return short_designs(self.engine)

    def _repr_html_(self) -> str:
        return f"<pre>{escape(repr(self))}</pre>"


def compare(first: CaseFile, *others: CaseFile) -> DesignComparison:
    """Solve several designs and put them side by side: changed inputs, results, verdicts, governing checks.

    Bearings are matched by name, operating point and clearance; cases of one bearing each whatever they are
    called.
    The methods for one bearing are compared by its own `compare`.

    Parameters
    ----------
    first, *others : CaseFile
        Such as a `babbitt.JournalBearing`, or what `babbitt.load_case` reads; at least two.

    Raises
    ------
    CaseError
        With what is missing in a case.
    InputError
        E004 for one case, and for cases without a bearing in common.
    TypeError
        If something is not a case.
    """
    from babbitt.study.designs import compare_designs

    cases = [_in_language(one) for one in (first, *others)]
    return DesignComparison(compare_designs(cases, [one.name for one in cases]))


def _in_language(one: Any) -> CaseFile:
    from babbitt.api.case import Case

    if not isinstance(one, CaseFile):
        raise TypeError(f"compare takes cases, not {type(one).__name__}; read them with babbitt.load_case(path)")
    return one.complete().in_language() if isinstance(one, Case) else one
