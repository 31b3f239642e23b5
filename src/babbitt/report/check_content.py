"""The checks of a report as plain data: of one result, or of several clearances side by side."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from babbitt.core import check_text
from babbitt.core.language import translated
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Bound, Check, Result
from babbitt.report import verdict as verdicts
from babbitt.report.chapters import Chapter
from babbitt.report.columns import ABSENT
from babbitt.report.labels import label
from babbitt.report.symbols import symbol_node
from babbitt.report.text import plain_text

Data = dict[str, Any]

SIGNS = {Bound.AT_MOST: "≤", Bound.AT_LEAST: "≥"}
BROKEN = {Bound.AT_MOST: ">", Bound.AT_LEAST: "<"}
"""What holds between value and limit: where the limit is kept, and where it is not."""


def sources_of(results: Iterable[Result]) -> list[str]:
    """Where the limits of some results come from, each source once."""
    said = (_source(check) for result in results for check in solved_checks(result))
    return list(dict.fromkeys(said))


def _source(check: Check) -> str:
    """Where a limit comes from; of one that the case sets also what would hold without it."""
    source = translated(plain_text(check.source))
    if check.general is None:
        return source
    value, why = check.general
    return translated(
        "{source} in place of {general} ({why})",
        source=source,
        general=check_text.written(check.quantity, value),
        why=translated(plain_text(why)),
    )


def solved_checks(result: Result) -> tuple[Check, ...]:
    """The checks of an operating point; none for an unsolved result."""
    return result.checks if result.outcome.solved else ()


def check_content(check: Check, sources: Sequence[str] = ()) -> Data:
    """One check; its source as the place in a list of `sources`, counted from 1."""
    value, limit = check_text.value_and_limit(check)
    return {
        **_what(check),
        "value": value,
        "sign": SIGNS[check.bound],
        "limit": limit,
        "margin": check_text.margin(check).replace("-", "−"),
        "verdict": verdicts.check_word(check).value,
        "source": str(1 + sources.index(_source(check))) if sources else "",
    }


def compared_checks(chapter: Chapter, sources: Sequence[str]) -> list[Data]:
    """The checks of a chapter with several clearances, one row a check and one cell a clearance."""
    by_member = [{(c.code, c.quantity): c for c in solved_checks(result)} for result in chapter.results]
    rows = []
    for key in sorted({key for checks in by_member for key in checks}):
        found = [checks.get(key) for checks in by_member]
        present = [check for check in found if check is not None]
        quantity = QUANTITIES.get(present[0].quantity)
        places = sorted({1 + sources.index(_source(check)) for check in present})
        rows.append(
            {
                **_what(present[0]),
                "unit": quantity.display.label if quantity else "",
                "compared": [
                    _compared(check) | {"governs": check is not None and check is result.governing_check}
                    for check, result in zip(found, chapter.results, strict=True)
                ],
                "source": ", ".join(map(str, places)),
            }
        )
    return rows


def _what(check: Check) -> Data:
    quantity = QUANTITIES.get(check.quantity)
    return {
        "code": check.code,
        "quantity": label(check.quantity),
        "advice": check.advisory,
        "symbol": symbol_node(quantity.symbol) if quantity else None,
    }


def _compared(check: Check | None) -> Data:
    if check is None:
        return {"said": ABSENT, "verdict": ""}
    value, limit = (check_text.number(check.quantity, number) for number in (check.value, check.limit))
    return {
        "said": f"{value} {SIGNS[check.bound] if check.ok else BROKEN[check.bound]} {limit}",
        "verdict": verdicts.check_word(check).value,
    }
