"""What a page shows of a case: solved in a worker process, sent as plain data."""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from babbitt.app.document import CaseDocument
from babbitt.case import CaseError, located, parse_case
from babbitt.case.case_file import CaseFile
from babbitt.case.method_mapping import METHOD, choices_of
from babbitt.core.check_text import margin, value_and_limit
from babbitt.core.files.reading import Reach
from babbitt.core.language import keeping, translated, written_in
from babbitt.core.limited_flow import is_short_of_oil, quantity_held
from babbitt.core.notices import Effect, InputError, explanations
from babbitt.core.quantities import QUANTITIES
from babbitt.core.quantities.display import displayed_in
from babbitt.core.result import Bound, Check, Result, Verdict
from babbitt.core.solution import Solution
from babbitt.report import findings
from babbitt.report import verdict as verdicts
from babbitt.report.coefficient_temperatures import temperature_remark
from babbitt.report.drawing import Drawing
from babbitt.report.labels import label, told_meaning
from babbitt.report.meanings import remark_on_zero
from babbitt.report.names import shown_name
from babbitt.report.study_values import refusal
from babbitt.report.text import plain_text
from babbitt.report.units_of_matrices import suited_among
from babbitt.report.us_words import OF_RESULTS, in_us_units
from babbitt.report.view import view_of
from babbitt.solving import MachineResult, solve

if TYPE_CHECKING:
    from babbitt.study.comparison import Comparison, Variant

__all__ = [
    "Answer",
    "Card",
    "Fault",
    "Figure",
    "Finding",
    "Shown",
    "Table",
    "answer",
    "compared",
    "faults_of",
    "figure_of",
    "figures",
    "json_of",
    "read",
    "report_of",
    "solved",
]

NAME = "case"
"""What messages call the text on the page."""

QUICK: Mapping[str, Any] = {
    "accuracy": "draft", "equilibria": "first", "error_estimate": False, "limiting_speeds": False,
}  # fmt: skip
"""Choices of a method for an answer while a value is still moving."""

NOT_READ = "W183"
"""Of fields that a method does not read."""

MOST_CHECKED, MOST_CARDS = 7, 10
"""Cards with a limit, and in all: more are a table."""


@dataclass(frozen=True)
class Fault:
    """What is wrong with a field of the case."""

    field: str
    line: int
    message: str
    code: str


@dataclass(frozen=True)
class Card:
    """One number with its limit.

    Attributes
    ----------
    label, symbol, value, limit, margin : str
        In the engineer's units; without a limit the last two are empty.
    share : float
        Of the limit that is used up, 1 where it is reached; NaN without a limit.
    word : str
        pass, missed or fail; empty without a limit.
    is_advice : bool
        Whether the limit is a recommendation or a screening indicator.
    """

    label: str
    symbol: str
    value: str
    limit: str = ""
    margin: str = ""
    share: float = math.nan
    word: str = ""
    is_advice: bool = False


@dataclass(frozen=True)
class Finding:
    """A warning, a check that was not made, or why there is no solution."""

    code: str
    title: str
    message: str
    remedy: str
    grave: bool


@dataclass(frozen=True)
class Shown:
    """One bearing at one operating point and clearance.

    Attributes
    ----------
    name, method : str
    key : str
        The name by which questions call it, whatever the language.
    verdict, verdict_key : str
        In words, and for the style of the page.
    governing : str
        The governing check with its margin; empty where there is none.
    cards : tuple of Card
    findings : tuple of Finding
    picture : str
        SVG; empty where there is none.
    rows : tuple of tuple of str
        Meaning, symbol, value and unit of every result.
    moves : bool
        Whether something in the picture moves.
    unread : tuple of str
        Fields of the case that its method does not read, as messages write them.
    """

    name: str
    method: str
    key: str
    verdict: str
    verdict_key: str
    governing: str
    cards: tuple[Card, ...]
    findings: tuple[Finding, ...]
    picture: str
    rows: tuple[tuple[str, str, str, str], ...]
    moves: bool = False
    unread: tuple[str, ...] = ()


@dataclass(frozen=True)
class Answer:
    """What became of a case: what is wrong with it, or its bearings, one of which is the worst."""

    faults: tuple[Fault, ...] = ()
    bearings: tuple[Shown, ...] = ()
    worst: int = 0
    case_hash: str = ""
    quick: bool = False
    seconds: float = 0.0


@dataclass(frozen=True)
class Figure:
    """A figure of the report."""

    name: str
    caption: str
    svg: str


@dataclass(frozen=True)
class Table:
    """Rows of text under heads.

    Attributes
    ----------
    title : str
    heads : tuple of str
    rows : tuple of tuple of str
        As many cells as heads.
    remarks : tuple of str
        What to know of them.
    words : int
        Columns of words; those after them are numbers.
    """

    title: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    remarks: tuple[str, ...] = ()
    words: int = 1


def read(text: str) -> CaseFile:
    """The case of a text that names no files.

    Raises
    ------
    CaseError
        With all that is wrong.
    """
    return parse_case(text, NAME, Reach.NOWHERE)


def answer(text: str, quick: bool = False) -> Answer:
    """Solve a case for the page, never raising for what stands in it.

    Parameters
    ----------
    text : str
    quick : bool
        On a draft grid, with one equilibrium and no estimate of errors.
    """
    begun = time.perf_counter()
    try:
        machine = solved(text, quick)
    except CaseError as error:
        return Answer(faults_of(error), quick=quick, seconds=time.perf_counter() - begun)
    document = CaseDocument(text)
    with keeping(machine.own_words):
        bearings = tuple(shown(one, document) for one in machine.solutions)
    worst = worst_of([one.result for one in machine.solutions])
    return Answer((), bearings, worst, machine.case_hash, quick, time.perf_counter() - begun)


def worst_of(results: Sequence[Result]) -> int:
    """Place of the result with the gravest verdict, of several the one nearest its limit or farthest beyond."""
    order = list(Verdict)

    def gravity(place: int) -> tuple[int, float]:
        result = results[place]
        return -order.index(result.verdict), result.margin if math.isfinite(result.margin) else math.inf

    return min(range(len(results)), key=gravity, default=0)


def faults_of(error: CaseError) -> tuple[Fault, ...]:
    """All that is wrong, as the page shows it."""
    return tuple(Fault(one.field, one.line, refusal(one.message), one.code) for one in error.problems)


def solved(text: str, quick: bool = False) -> MachineResult:
    """The answers of a case.

    Raises
    ------
    CaseError
        With all that is wrong.
    """
    case = read(text)
    try:
        return solve(as_quick(case), only=()) if quick else solve(case)
    except InputError as error:
        raise located(error, case, NAME) from None


def as_quick(case: CaseFile) -> CaseFile:
    """The case with the quick choices of its method, where the method has them."""
    method = getattr(case, METHOD, None)
    if not isinstance(method, str):
        return case
    known = choices_of(type(case), method)
    changes = {name: value for name, value in QUICK.items() if known.get(name) == (name,)}
    return case.model_copy(update=changes) if changes else case


def shown(solution: Solution, document: CaseDocument) -> Shown:
    """One bearing of a document as the page shows it."""
    result = solution.result
    governing = result.governing_check
    picture = view_of(result).picture(solution)
    return Shown(
        shown_name(result.name),
        translated(view_of(result).title or result.method),
        plain_text(result.name),
        translated(result.verdict.value),
        result.verdict.key,
        "" if governing is None else f"{label(governing.quantity, result.kind)}: {margin(governing)}",
        cards_of(result),
        tuple(findings_of(result)),
        "" if picture is None else picture.svg(document.may_turn),
        tuple(rows_of(result)),
        picture is not None and picture.moves,
        tuple(field for notice in result.warnings if notice.code == NOT_READ for field in notice.values["fields"]),
    )


def cards_of(result: Result) -> tuple[Card, ...]:
    """The strictest check of each quantity, then the results that matter most, of the film that limits are held
    against."""
    if not result.outcome.solved:
        return ()
    view = view_of(result)
    found: dict[str, Card] = {}
    for check in sorted(result.checks, key=lambda one: (one.advisory, one.margin)):
        if check.quantity not in found and len(found) < MOST_CHECKED:
            found[check.quantity] = _checked(check, result)
    for wanted in (*view.sweep, *(column.quantity for column in view.columns), *view.key_results):
        name = quantity_held(result, wanted)
        value = result.values.get(name, math.nan)
        if name not in found and name in QUANTITIES and math.isfinite(value):
            quantity = suited_among(name, result.values)
            found[name] = Card(in_us_units(label(name, result.kind)), quantity.symbol, quantity.with_unit(value))
    return tuple(found.values())[:MOST_CARDS]


def _checked(check: Check, result: Result) -> Card:
    value, limit = value_and_limit(check)
    sign = "≤" if check.bound is Bound.AT_MOST else "≥"
    return Card(
        in_us_units(label(check.quantity, result.kind)),
        QUANTITIES[check.quantity].symbol,
        value,
        f"{sign} {limit}",
        margin(check),
        used_share(check),
        verdicts.check_word(check).value,
        check.advisory,
    )


def used_share(check: Check) -> float:
    """Share of a limit that is used up: value over limit, of a lower limit the inverse, as margins count them."""
    if check.limit == 0.0 or not math.isfinite(check.margin):
        return 0.0 if check.ok else math.inf
    if check.bound is Bound.AT_MOST:
        return max(1.0 - check.margin, 0.0)
    return 1.0 / (1.0 + check.margin) if check.margin > -1.0 else math.inf


def findings_of(result: Result) -> Iterable[Finding]:
    """Why there is no solution, limits that are missed, why there is no verdict, warnings from the gravest on.

    Then recommendations that are missed, and checks that were not made.
    """
    if result.failure is not None:
        yield _finding(result.failure.code, result.failure.message, grave=True)
    for group in (*findings.missed_limits([result]), *findings.lacking([result])):
        yield _gathered(group, group.message, grave=True)
    if result.outcome.solved and not (result.limits or result.lacking):
        said = translated(
            "Nothing is held against a limit (recommendations change no verdict), so that there is no verdict."
        )
        yield Finding("", said, "", "", grave=True)
    for effect in (Effect.NO_VERDICT, Effect.QUESTIONS_RESULT, Effect.INFORMATION):
        for notice in result.warnings:
            if notice.effect is effect:
                yield _finding(notice.code, notice.message, grave=effect is not Effect.INFORMATION)
    for group in findings.missed_advice([result]):
        said = f"{group.message}. {translated('A missed recommendation changes no verdict.')}"
        missed = replace(group, title=f"{group.title}: {translated('missed')}")
        yield _gathered(missed, said, grave=False)
    for notice in result.not_checked:
        yield replace(_finding(notice.code, notice.message, grave=False), remedy="")


def _finding(code: str, message: str, grave: bool) -> Finding:
    known = explanations().get(code)
    title, remedy = (known.title, known.remedy) if known is not None else ("", "")
    return Finding(code, title, in_us_units(plain_text(message), OF_RESULTS), remedy, grave)


def _gathered(group: findings.Group, message: str, grave: bool) -> Finding:
    return Finding(group.code, in_us_units(group.title), in_us_units(message, OF_RESULTS), group.remedy, grave)


def rows_of(result: Result) -> Iterable[tuple[str, str, str, str]]:
    """Every result, as the table of the terminal has it."""
    if not result.outcome.solved:
        return
    for name, value in result.values.items():
        if name in QUANTITIES and math.isfinite(value) and name != "wall_time":
            said = told_meaning(name, result.kind) + remark_on_zero(name, value) + temperature_remark(name, result)
            quantity = suited_among(name, result.values)
            yield in_us_units(said), quantity.symbol, quantity.format(value), quantity.display.label


def figures(text: str) -> tuple[Figure, ...]:
    """The figures that a report would have, of every bearing."""
    machine = solved(text)
    with keeping(machine.own_words):
        return tuple(
            figure_of(one.result, drawn)
            for one in machine.solutions
            for drawn in view_of(one.result).report_figures(one)
        )


def figure_of(result: Result, drawn: Drawing) -> Figure:
    """A figure of a bearing; its caption says which film it is of where limits are held against another."""
    caption = translated(drawn.caption)
    if is_short_of_oil(result):
        caption = f"{caption} {translated('The figures are of the film with the full flow.')}"
    return Figure(plain_text(f"{result.name}: {drawn.name}"), caption, drawn.image.decode())


def compared(text: str) -> tuple[Table, ...]:
    """Every method that knows the bearing, side by side, then other choices within a method."""
    from babbitt.report.comparison_table import asked_for, notes_on, spoken, told_left_out, warnings_of
    from babbitt.study.comparison import compare_methods

    tables: list[Table] = []
    for one in compare_methods(read(text)):
        left_out = map(told_left_out, filter(None, one.left_out.splitlines()))
        said = (*map(spoken, (*one.sentences, one.note)), *left_out)
        remarks = (asked_for(one), *notes_on(one.methods), *filter(None, said))
        parts = [_side_by_side(one, one.methods, shown_name(one.name), remarks)]
        if one.choices:
            title = translated("Other choices within a method")
            parts.append(_side_by_side(one, one.choices, title, tuple(notes_on(one.choices))))
        warned = (
            f"{code}: {in_us_units(plain_text(said), OF_RESULTS)}" for code, said in warnings_of(one).items()
        )
        tables += [*parts[:-1], replace(parts[-1], remarks=(*parts[-1].remarks, *warned))]
    return tuple(tables)


def _side_by_side(
    comparison: Comparison, variants: Sequence[Variant], title: str, remarks: tuple[str, ...]
) -> Table:
    from babbitt.report.comparison_table import compared_rows, head

    rows = tuple(
        (f"{row.meaning} {row.unit}".strip(), *row.cells) for row in compared_rows(comparison.compared, variants)
    )
    return Table(title, ("", *(head(variant, comparison.asked) for variant in variants)), rows, remarks)


def report_of(text: str, report_format: Any) -> bytes:
    """The report, as `babbitt solve --report` writes it."""
    from babbitt.report.document import language_of, report

    machine = solved(text)
    with written_in(language_of(machine)):
        return report(machine, report_format)


def json_of(text: str) -> str:
    """The results, as `babbitt solve --json` writes them: in SI, its messages, too."""
    from babbitt.report.export import write_json

    with displayed_in("si"):
        return write_json(solved(text))
