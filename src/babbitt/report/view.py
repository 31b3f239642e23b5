"""How the solutions of one method are shown: what a kind gives to tables, reports, plots and fields."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from babbitt.core.kind import find_kind
from babbitt.core.result import Result
from babbitt.core.solution import Solution
from babbitt.report.columns import Column

if TYPE_CHECKING:
    import xarray
    from rich.console import RenderableType

    from babbitt.properties.lubricants import Lubricant
    from babbitt.report.drawing import Drawing
    from babbitt.report.inputs import InputGroup
    from babbitt.report.line import Section
    from babbitt.report.picture import Picture

__all__ = ["NO_VIEW", "View", "find_view", "lubricant_of", "view_of"]

Data = dict[str, Any]


def _none(*_: Any) -> tuple[()]:
    """Nothing to show."""
    return ()


def _itself(problem: Any) -> Any:
    return problem


def _nothing(_: Any) -> None:
    return None


def lubricant_of(problem: Any) -> Lubricant:
    """The lubricant of a problem that has one, for `View.oil`."""
    found: Lubricant = problem.lubricant
    return found


@dataclass(frozen=True)
class View:
    """What is shown of the solutions of one method; each part may be a `LazyFunction`.

    Attributes
    ----------
    title : str
        Name of the method on paper.
    key_results : tuple of str
        Results at the head of a report, those of them that there are; empty: all.
    fed_results : tuple of str
        Those that stand there only where oil is fed, and a supply temperature is among the results.
    rows : callable
        Results -> further rows of results, of supplies or recesses.
    inputs : callable
        Problem -> groups of inputs.
    left_out : Mapping of str to tuple of str
        Inputs that a case may leave out, by the quantity of their row or its label: the fields that give them.
    sections : callable
        Solution -> sections of the calculation, line by line.
    figures : callable
        Solution and image format -> every figure.
    report_figures : callable
        Solution -> figures of the report; those that take long may be left out.
    of_every_state : bool
        Solutions of one problem are steady states: sections and figures are those of each of them.
    tables : callable
        Result -> tables of the report.
    terminal_tables : callable
        Result -> those of them that the terminal shows, too.
    sentences : callable
        Result -> answers in words.
    columns : tuple of Column
        Of the table of a machine.
    in_machine_table : bool
        Whether several bearings stand in one table, which takes columns; else each has a table of its own.
    overview : tuple of Column
        Of a second table in reports, of the solved bearings side by side.
    sweep : tuple of str
        Results of a sweep, what matters most first; empty: the columns.
    state_table : callable, optional
        Results -> the table of the terminal in place of all others.
    alike : callable
        Problem -> what is equal for problems that differ in the clearance only.
    citations : callable
        Problem -> references of the method.
    oil : callable
        Problem -> its lubricant, None where a viscosity is given.
    fields : callable, optional
        Solution -> fields of the film as a dataset.
    picture : callable
        Solution -> the bearing as a drawing for the screen (`babbitt.report.picture.Picture`), or None.
    """

    title: str
    key_results: tuple[str, ...] = ()
    fed_results: tuple[str, ...] = ()
    rows: Callable[[Sequence[Result]], Iterable[Data]] = _none
    inputs: Callable[[Any], Iterable[InputGroup]] = _none
    left_out: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    sections: Callable[[Solution], Iterable[Section]] = _none
    figures: Callable[[Solution, str], Iterable[Drawing]] = _none
    report_figures: Callable[[Solution], Iterable[Drawing]] = _none
    of_every_state: bool = False
    tables: Callable[[Result], Iterable[Data]] = _none
    terminal_tables: Callable[[Result], Iterable[Data]] = _none
    sentences: Callable[[Result], Iterable[str]] = _none
    columns: tuple[Column, ...] = ()
    in_machine_table: bool = True
    overview: tuple[Column, ...] = ()
    sweep: tuple[str, ...] = ()
    state_table: Callable[[Sequence[Result]], RenderableType] | None = None
    alike: Callable[[Any], Any] = _itself
    citations: Callable[[Any], Iterable[str]] = _none
    oil: Callable[[Any], Lubricant | None] = _nothing
    fields: Callable[[Solution], xarray.Dataset] | None = None
    picture: Callable[[Solution], Picture | None] = _nothing


NO_VIEW = View("")
"""Of a result whose kind or method is not known: its values, checks and warnings."""


def find_view(kind: str, method: str) -> View:
    """The view of a method of a kind; one that shows the bare values where there is none."""
    known = find_kind(kind)
    if known is None or method not in known.views:
        return NO_VIEW
    view: View = known.load(known.views[method])
    return view


def view_of(result: Result) -> View:
    """The view of a result, by its kind and method."""
    return find_view(result.kind, result.method)
