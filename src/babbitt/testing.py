"""For tests of a kind of bearing in another package: every mistake of it, by its template."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any, get_args

from babbitt.case import KINDS, parse_case, template
from babbitt.case.case_file import CaseFile
from babbitt.core.kind import Kind, register
from babbitt.core.nearest_name import unknown_name
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.report.view import find_view
from babbitt.solving import MachineResult, solve

__all__ = ["check_kind", "mistakes_of"]

ASSUMED = "What babbitt.testing assumes."
GROUPED = "12.000 N"
"""A number whose digits may be grouped, of which W181 warns."""


def check_kind(kind: Kind) -> None:
    """Refuse a kind that has a mistake; it stays registered.

    Parameters
    ----------
    kind : Kind

    Raises
    ------
    AssertionError
        With all of `mistakes_of`, a line each.
    """
    if found := mistakes_of(kind):
        raise AssertionError("\n".join((f"the kind {kind.name!r} has mistakes:", *found)))


def mistakes_of(kind: Kind) -> tuple[str, ...]:
    """Every mistake of a kind that shows when its template is read, solved, reported and compared.

    Names that case, results, views and comparison give to each other are compared; a name that a table does not
    know is left out of it elsewhere, without a word.

    Parameters
    ----------
    kind : Kind

    Returns
    -------
    tuple of str
        A sentence for each; empty for a sound kind.
    """
    return tuple(dict.fromkeys(_mistakes(kind)))


def _mistakes(kind: Kind) -> Iterator[str]:
    try:
        register(kind)
        model = KINDS[kind.name]
    except Exception as error:  # as everywhere here: whatever the kind does wrong
        yield _said("registration", error)
        return
    yield from _tried("schema", lambda: _of_model(kind, model))
    for method in kind.views:
        yield from _tried(f"view of {method}", partial(_of_view, kind, method))
    yield from _tried("meanings", lambda: _unknown(kind.load_meanings(), "a quantity"))
    try:
        case = parse_case(template(kind.name), kind.template)
        yield from _of_problems(kind, case)
        machine = solve(case)
    except Exception as error:
        yield _said("template", error)
        return
    for result in machine.results:
        yield from _of_result(kind, result)
    yield from _tried("report", lambda: _reported(machine))
    yield from _tried("warnings", lambda: _of_warnings(case))
    if kind.comparison or (len(kind.views) > 1 and not kind.one_method):
        yield from _tried("comparison", lambda: _of_comparison(case))


def _tried(what: str, step: Callable[[], Iterable[str]]) -> Iterator[str]:
    """What a step finds, and the error that ends it."""
    try:
        yield from step()
    except Exception as error:
        yield _said(what, error)


def _said(what: str, error: Exception) -> str:
    return f"{what}: {type(error).__name__}: {error}"


def _unknown(names: Iterable[str], what: str) -> Iterator[str]:
    for name in names:
        if name not in QUANTITIES:
            yield unknown_name(name, QUANTITIES, what)


def _of_model(kind: Kind, model: type[CaseFile]) -> Iterator[str]:
    model.model_json_schema()
    if "name" not in model.model_fields:
        yield f"{kind.model} has no field name"
    if "method" in model.model_fields:
        offered = [one for one in get_args(model.model_fields["method"].annotation) if isinstance(one, str)]
        for name in offered:
            if name not in kind.views:
                yield f"the method {unknown_name(name, kind.views, 'among the views')}"


def _of_view(kind: Kind, method: str) -> Iterator[str]:
    view = find_view(kind.name, method)
    yield from _unknown((*view.key_results, *view.fed_results), "a quantity, though a key result")
    yield from _unknown(view.sweep, "a quantity, though of the sweep of a view")
    shown = (column.quantity for column in (*view.columns, *view.overview) if column.quantity)
    yield from _unknown(shown, "a quantity, though it has a column")


def _of_problems(kind: Kind, case: CaseFile) -> Iterator[str]:
    for one in case.calculations():
        if one.problem.kind != kind.name:
            yield f"the kind of {type(one.problem).__name__} is {one.problem.kind!r}, not {kind.name!r}"
        if one.method.name not in kind.views:
            yield f"the method {unknown_name(one.method.name, kind.views, 'among the views')}"


def _of_result(kind: Kind, result: Result) -> Iterator[str]:
    if result.kind != kind.name:
        yield f"the kind of a result is {result.kind!r}, not {kind.name!r}"
    if result.method not in kind.views:
        yield f"the method of a result {unknown_name(result.method, kind.views, 'among the views')}"
    yield from _unknown((*result.values, *result.arrays, *result.missing), "a quantity, though a result")


def _reported(machine: MachineResult) -> tuple[()]:
    from babbitt.report.content import content
    from babbitt.report.export import write_json
    from babbitt.report.table import PIPED_WIDTH, render

    content(machine)
    write_json(machine)
    render(machine.name, machine.results, PIPED_WIDTH)
    return ()


def _of_warnings(case: CaseFile) -> Iterator[str]:
    """What of a case does not come through to its results: its assumptions, and the warning of grouped digits."""
    update: dict[str, Any] = {"assumptions": (ASSUMED,)} if "assumptions" in type(case).model_fields else {}
    changed = case.model_copy(update=update)
    changed._grouped = (("name", GROUPED),)
    for result in solve(changed).results:
        if update and ASSUMED not in result.assumptions:
            yield "the assumptions of a case do not reach its results: give them to the problem"
        if not any(notice.code == "W181" for notice in result.warnings):
            yield "W181 does not reach the results: give about_grouped_digits(case) to the problem as warnings"


def _of_comparison(case: CaseFile) -> Iterator[str]:
    from babbitt.study.comparison import compare_methods

    for comparison in compare_methods(case):
        yield from _unknown(comparison.compared, "a quantity, though compared")
        labels = [variant.label for variant in comparison.variants]
        twice = [label for label in dict.fromkeys(labels) if labels.count(label) > 1]
        yield from (f"the label {label!r} stands twice in a comparison" for label in twice)
