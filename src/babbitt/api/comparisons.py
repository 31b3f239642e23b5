"""One bearing by every method that knows it, as results of the front door."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any

from babbitt.api.results import BearingResult
from babbitt.core.nearest_name import unknown_name

if TYPE_CHECKING:
    import pandas

    from babbitt.api.case import Case
    from babbitt.study import comparison as study

__all__ = ["Comparison", "Comparisons", "Variant", "compared"]

SHOWN = 20
"""Bearings that are listed."""


@dataclass(frozen=True)
class Variant:
    """One way to compute a bearing, what it assumes or neglects, and what it gives.

    Parameters
    ----------
    label, remark : str
    result : BearingResult
    is_method : bool
        False: differs from a method in one choice only.
    """

    label: str
    remark: str
    result: BearingResult
    is_method: bool = True


@dataclass(frozen=True, repr=False)
class Comparison:
    """One bearing, at one operating point and clearance, by every method that knows it.

    ``comparison["ISO 7902"]`` is the result of a method by its label, as `solve` gives it. Iteration goes over all
    variants, that which the case asks for first.

    Parameters
    ----------
    engine : babbitt.study.comparison.Comparison
    case_hash, case_text : str
        Of the case, for reports.
    """

    engine: study.Comparison
    case_hash: str = ""
    case_text: str = ""

    @property
    def name(self) -> str:
        """Of the bearing, operating point and clearance."""
        return self.engine.name

    @cached_property
    def variants(self) -> tuple[Variant, ...]:
        """All that were solved, that which the case asks for first."""
        return tuple(
            Variant(
                one.label, one.remark, BearingResult(one.solution, self.case_hash, self.case_text), one.is_method
            )
            for one in self.engine.variants
        )

    @property
    def asked(self) -> Variant:
        """The method that the case asks for."""
        return self.variants[0]

    @property
    def labels(self) -> tuple[str, ...]:
        """By what the variants are called."""
        return tuple(one.label for one in self.variants)

    @property
    def left_out(self) -> str:
        """Which methods do not apply and why, a line for each."""
        return self.engine.left_out

    @property
    def sentences(self) -> tuple[str, ...]:
        """What the differences come to."""
        return self.engine.sentences

    @property
    def note(self) -> str:
        """What one must know of the numbers; empty where there is nothing."""
        return self.engine.note

    def __getitem__(self, label: str) -> BearingResult:
        """The result of a variant by its label.

        Raises
        ------
        KeyError
            For an unknown label, with the nearest.
        """
        for one in self.variants:
            if one.label == label:
                return one.result
        raise KeyError(unknown_name(label, self.labels, "a method of this comparison"))

    def __iter__(self) -> Iterator[Variant]:
        return iter(self.variants)

    def __len__(self) -> int:
        return len(self.engine.variants)

    def to_dataframe(self) -> pandas.DataFrame:
        """A row for each variant: bearing, label, verdict, values, entries of matrices.

        Raises
        ------
        InputError
            E007 where pandas is not installed.
        """
        return Comparisons([self]).to_dataframe()

    def __getstate__(self) -> dict[str, Any]:
        return {"engine": self.engine, "case_hash": self.case_hash, "case_text": self.case_text}

    def __repr__(self) -> str:
        from babbitt.report.comparison_table import short_comparison

        return short_comparison(self.engine)

    def _repr_html_(self) -> str:
        return f"<pre>{escape(repr(self))}</pre>"


class Comparisons(tuple[Comparison, ...]):
    """The comparisons of a case: one for each bearing, operating point and clearance, in a tuple."""

    __slots__ = ()

    def to_dataframe(self) -> pandas.DataFrame:
        """A row for each variant of each bearing: bearing, label, verdict, values, entries of matrices.

        Raises
        ------
        InputError
            E007 where pandas is not installed.
        """
        from babbitt.api.tables import frame_of

        pairs = [(comparison, one) for comparison in self for one in comparison]
        leading = [{"bearing": str(comparison.name), "variant": one.label} for comparison, one in pairs]
        return frame_of(leading, [one.result for _, one in pairs])

    def __repr__(self) -> str:
        if len(self) == 1:
            return repr(self[0])
        lines = [_line(one) for one in self[:SHOWN]]
        left = len(self) - SHOWN
        return "\n".join([f"{len(self)} comparisons", *lines, *([f"  and {left} more"] if left > 0 else [])])

    def _repr_html_(self) -> str:
        return f"<pre>{escape(repr(self))}</pre>"


def compared(case: Case) -> Comparisons:
    """Solve every bearing of a complete case by every method that knows it.

    Raises
    ------
    InputError
        E004 where its kind has one method.
    """
    from babbitt.case.case_hash import case_hash
    from babbitt.study.comparison import compare_methods

    return Comparisons(Comparison(one, case_hash(case), case.text) for one in compare_methods(case.in_language()))


def _line(comparison: Comparison) -> str:
    """Name of a bearing, and the verdict of each method."""
    verdicts = ", ".join(f"{one.label} {one.result.verdict.value}" for one in comparison if one.is_method)
    return f"  {comparison.name}: {verdicts}"
