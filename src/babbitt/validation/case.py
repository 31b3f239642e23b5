"""A published case: what a source says, what Babbitt says, and how far they may differ.

One description serves three readers: the test that fails when a value leaves its tolerance, the page of the
documentation, and the command ``babbitt validate``.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import TYPE_CHECKING

from babbitt.validation.tolerance import Tolerance

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Verdict(Enum):
    """What a comparison says."""

    AGREES = "agrees"
    DIFFERS = "DIFFERS"
    SUSPECT = "set aside"
    SHOWN = "not judged"


class Evidence(Enum):
    """What agreement with a case shows.

    VALIDATION: inputs are those of the source, so that agreement speaks for the method. REPRODUCTION: the source
    leaves inputs open, which were fitted to the very values compared; agreement shows that one set of inputs gives
    them all, no more. REGRESSION: the reference is ours, another solver or program or a relation between our own
    values; agreement shows that nothing changed and that both say the same, not that they are right.
    """

    VALIDATION = "validation"
    REPRODUCTION = "reproduction"
    REGRESSION = "regression"


@dataclass(frozen=True)
class Comparison:
    """One published value beside ours.

    Attributes
    ----------
    quantity : str
        What is compared, by its symbol.
    place : str
        For which bearing, row or operating point.
    published, computed : float
        In the unit of the source.
    tolerance : Tolerance or None
        None only where nothing is judged.
    unit : str
    source : str
        Table, row, equation or page of the source.
    decimals : int or None
        Decimals of the print; ours is shown with one more. None shows six significant digits.
    suspect : str
        Why the print is held to be wrong; the row is shown and not judged.
    information : str
        Why the row is shown without a judgement although the print is not held to be wrong.
    remark : str
        Something odd about a row that is judged all the same.
    """

    quantity: str
    place: str
    published: float
    computed: float
    tolerance: Tolerance | None
    unit: str = ""
    source: str = ""
    decimals: int | None = None
    suspect: str = ""
    information: str = ""
    remark: str = ""

    def __post_init__(self) -> None:
        if self.tolerance is None and not self.note:
            raise ValueError(f"{self.label}: a row without tolerance must say why it is not judged")

    @property
    def label(self) -> str:
        """Quantity and place."""
        return f"{self.quantity}, {self.place}" if self.place else self.quantity

    @property
    def note(self) -> str:
        """What the reader should know about this row."""
        return self.suspect or self.information or self.remark

    @property
    def judged(self) -> bool:
        """Whether the row counts."""
        return not (self.suspect or self.information)

    @property
    def deviation(self) -> float:
        """Computed less published value."""
        return self.computed - self.published

    @property
    def relative_deviation(self) -> float:
        """Deviation over the published value."""
        return self.deviation / self.published

    @property
    def share(self) -> float:
        """How much of the tolerance is used, 1 at its edge; not a number without a tolerance."""
        return self.tolerance.share(self.published, self.computed) if self.tolerance else float("nan")

    @property
    def ok(self) -> bool:
        """Whether the row agrees or is not judged; false for a computed value that is not a number."""
        return not self.judged or self.share <= 1.0

    @property
    def verdict(self) -> Verdict:
        """The judgement in one word."""
        if self.suspect:
            return Verdict.SUSPECT
        if self.information:
            return Verdict.SHOWN
        return Verdict.AGREES if self.ok else Verdict.DIFFERS

    def cells(self) -> tuple[str, str, str, str, str, str, str]:
        """Quantity, unit, published, computed, difference, tolerance and verdict as text."""
        return (
            self.label,
            self.unit,
            _text(self.published, self.decimals),
            _text(self.computed, None if self.decimals is None else self.decimals + 1),
            self._difference(),
            self.tolerance.describe() if self.tolerance else "–",
            self.verdict.value,
        )

    def _difference(self) -> str:
        if getattr(self.tolerance, "relative", 0.0) and self.published:
            percent = 100.0 * getattr(self.tolerance, "relative", 0.0)
            digits = max(2, 1 - math.floor(math.log10(percent)))
            return f"{100.0 * self.relative_deviation:+.{digits}f} %"
        return f"{self.deviation:+.3g}" if self.decimals is None else f"{self.deviation:+.{self.decimals + 1}f}"


def _text(value: float, decimals: int | None) -> str:
    return f"{value:.6g}" if decimals is None else f"{value:.{decimals}f}"


@dataclass(frozen=True)
class Story:
    """What a reader must know to judge the comparison, in Markdown.

    Attributes
    ----------
    what : str
        What is compared and why it matters.
    source : str
        Where the published numbers come from.
    assumptions : str
        What the source leaves open and what was assumed.
    tolerances : str
        How far values may differ, and why that far.
    differences : str
        What differs, and why.
    """

    what: str
    source: str
    assumptions: str
    tolerances: str
    differences: str


@dataclass(frozen=True)
class ValidationCase:
    """A published case.

    Attributes
    ----------
    name : str
        As in ``babbitt validate NAME``; also the name of its page and figure.
    title : str
        One line.
    story : Story
    run : callable
        Computes every comparison.
    draw : callable
        Draws into an empty matplotlib figure.
    caption : str
        What the figure shows.
    evidence : Evidence
        Whether it counts as validation.
    """

    name: str
    title: str
    story: Story
    run: Callable[[], tuple[Comparison, ...]]
    draw: Callable[[Figure], None]
    caption: str
    evidence: Evidence = Evidence.VALIDATION

    @cached_property
    def rows(self) -> tuple[Comparison, ...]:
        """What `run` computes, once: page, figure and scoreboard tell the same."""
        return self.run()
