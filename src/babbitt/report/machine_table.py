"""Which results stand in the table of a machine, and in which columns."""

from __future__ import annotations

from collections.abc import Sequence

from babbitt.core.language import translated
from babbitt.core.result import Result
from babbitt.report.columns import Column, filled
from babbitt.report.names import counted_results, shown_name
from babbitt.report.view import view_of

__all__ = ["columns_of", "counted_parts", "in_machine_table", "overview_columns", "overview_results"]


def columns_of(results: Sequence[Result]) -> tuple[Column, ...]:
    """The columns, by the view of the first result that belongs there, in which some bearing has a number."""
    if not results:
        return ()
    first = next((one for one in results if view_of(one).in_machine_table), results[0])
    return filled(view_of(first).columns, results)


def overview_results(results: Sequence[Result]) -> list[Result]:
    """Solved results whose view puts some of them side by side a second time."""
    return [one for one in results if one.outcome.solved and view_of(one).overview]


def overview_columns(results: Sequence[Result]) -> tuple[Column, ...]:
    """The columns of the overview; none for fewer than two bearings."""
    return filled(view_of(results[0]).overview, results) if len(results) > 1 else ()


def in_machine_table(result: Result) -> bool:
    """Whether a result belongs in the table, as its view says."""
    view = view_of(result)
    return view.in_machine_table and bool(view.columns)


def counted_parts(results: Sequence[Result]) -> str:
    """How many bearings results are, and the names of what stands beside them: their shaft, or their oil system.

    Parameters
    ----------
    results : sequence of Result
    """
    bearings = [one.name for one in results if in_machine_table(one)]
    beside = [one.name for one in results if not in_machine_table(one)]
    if not bearings or not beside:
        return counted_results([one.name for one in results])
    return translated(
        "{bearings} and {others}", bearings=counted_results(bearings), others="; ".join(map(shown_name, beside))
    )
