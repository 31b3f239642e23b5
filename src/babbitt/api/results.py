"""The answer for one bearing as an object: named quantities as attributes, arrays, film, fields, plots."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.core.limited_flow import quantity_held
from babbitt.core.nearest_name import unknown_name
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.solution import Solution

if TYPE_CHECKING:
    import pandas
    import xarray

    from babbitt.api.case import Case
    from babbitt.api.film import SolvedFilm
    from babbitt.api.gradient import Gradient
    from babbitt.api.pad_film import SolvedPadFilms
    from babbitt.api.pad_plot import PadPlots
    from babbitt.api.plot import ResultPlots
    from babbitt.core.notices import Notice
    from babbitt.core.result import Check, Matrix, Outcome, Result, Verdict

__all__ = ["BearingResult"]

Array = NDArray[np.float64]

NOT_CONTENT = ("wall_time",)
"""What two runs of the same calculation differ in."""


OF_ONE_ROW = ("pad_", "pivot_", "whirl_ratio", "dynamic_frequency", "assumed_")
"""How names of quantities begin that have a number for each pad, frequency or assumption."""

SEVERAL_UNITS = "SI"
"""Unit of arrays whose columns have units of their own."""


@dataclass(frozen=True, eq=False, repr=False)
class BearingResult:
    """The answer for one bearing at one operating point and clearance.

    Named quantities are attributes in SI: ``result.minimum_film_thickness`` is a float, ``result.stiffness`` a
    read-only array. Those of a result without an operating point raise; the last state of its search stands under
    `last_state`.

    Parameters
    ----------
    solution : Solution
        From a method; without its state the result has no film, fields and plots.
    case_hash, case_text : str
        Of the case, for reports; empty where there is none.
    case : Case, optional
        What was solved, where it was one bearing at one point.

    Notes
    -----
    Results are immutable, pickle, and are equal where their content is, whatever time they took.
    """

    solution: Solution
    case_hash: str = ""
    case_text: str = ""
    case: Case | None = None

    @property
    def result(self) -> Result:
        """The result as the methods make it."""
        return self.solution.result

    @property
    def name(self) -> str:
        """Which bearing, operating point and clearance."""
        return self.result.name

    @property
    def kind(self) -> str:
        """Kind of bearing."""
        return self.result.kind

    @property
    def method(self) -> str:
        """Method by which it was solved."""
        return self.result.method

    @property
    def outcome(self) -> Outcome:
        """How the calculation ended."""
        return self.result.outcome

    @property
    def message(self) -> str:
        """For an unsolved result: how far it came and what to try."""
        return self.result.message

    @property
    def solved(self) -> bool:
        """Whether there is an operating point."""
        return self.result.outcome.solved

    @property
    def verdict(self) -> Verdict:
        """The judgement in one word."""
        return self.result.verdict

    @property
    def governing_check(self) -> Check | None:
        """The limit with the least margin."""
        return self.result.governing_check

    @property
    def within_limits(self) -> bool:
        """Whether the bearing passes; False where it is not solved."""
        return self.result.within_limits

    @property
    def values(self) -> Mapping[str, float]:
        """Named quantities in SI; none without an operating point."""
        return self.last_state if self.solved else MappingProxyType({})

    @property
    def last_state(self) -> Mapping[str, float]:
        """What the search reached last, in SI: the operating point where there is one."""
        return MappingProxyType(dict(self.result.values))

    @property
    def arrays(self) -> Mapping[str, Array]:
        """Named quantities of several numbers in SI, read-only; none without an operating point.

        Numbers of pads and pivots, and of frequencies, have one axis, matrices and tables two.
        """
        return MappingProxyType(
            {name: _read_only(_in_one_row(name, rows)) for name, rows in self.result.arrays.items()}
            if self.solved
            else {}
        )

    @property
    def checks(self) -> tuple[Check, ...]:
        """Comparisons with what is permissible; none without an operating point."""
        return self.result.checks if self.solved else ()

    @property
    def warnings(self) -> tuple[Notice, ...]:
        """Warnings about the result."""
        return self.result.warnings

    @property
    def not_checked(self) -> tuple[Notice, ...]:
        """Checks that could not be made, each with what is missing."""
        return self.result.not_checked

    @property
    def assumptions(self) -> tuple[str, ...]:
        """What was assumed because neither the case nor a published source says it."""
        return self.result.assumptions

    @property
    def settings(self) -> Mapping[str, str]:
        """Choices that the numbers depend on."""
        return MappingProxyType(dict(self.result.settings))

    @property
    def missing(self) -> Mapping[str, str]:
        """Quantities that belong among the values and could not be found, each with the reason."""
        return MappingProxyType(dict(self.result.missing))

    @cached_property
    def film(self) -> SolvedFilm | SolvedPadFilms:
        """The film of the kept solution: fields over the bore, forces elsewhere; of tilting pads fields of each.

        Raises
        ------
        AttributeError
            Where the method has no film, there is no operating point, or the film was not kept.
        """
        from babbitt.api.film import film_of_solution

        return film_of_solution(self.solution)

    @property
    def fields(self) -> xarray.Dataset:
        """Fields of the film with units (`babbitt.report.fields.fields`).

        Raises
        ------
        InputError
            E003 without an operating point, E004 for a method without fields, E007 where xarray is not installed.
        AttributeError
            Where the film was not kept.
        """
        from babbitt.api.film import require_state
        from babbitt.report.fields import fields
        from babbitt.report.view import view_of

        if view_of(self.result).fields is not None and self.solved:
            require_state(self.solution)
        return fields(self.solution)

    @property
    def plot(self) -> ResultPlots | PadPlots:
        """Pictures of the film: ``result.plot.pressure()``; ``result.plot()`` is that which tells most."""
        from babbitt.api.plot import plots_of_solution

        return plots_of_solution(self.solution)

    def checked_value(self, name: str) -> float:
        """A value in SI of the film against which limits are held, as tables of the command line show it.

        A bearing whose supply delivers less oil than its film wants is solved with either flow;
        ``result.outlet_temperature`` is that with all the oil, ``result.starved_outlet_temperature`` the other.

        Parameters
        ----------
        name : str
            Of a value of this result, such as ``minimum_film_thickness``.

        Raises
        ------
        AttributeError
            As the attribute of the name.
        """
        return float(self._named(quantity_held(self.result, name)))

    def quantity(self, name: str) -> Any:
        """A named quantity with its unit, in the application registry of pint.

        Parameters
        ----------
        name : str
            Of a value or an array of this result.

        Raises
        ------
        AttributeError
            As the attribute of the name.
        ValueError
            For an array whose columns have different units.
        """
        from babbitt.core.units.pint_quantity import pint_quantity

        if name in QUANTITIES and QUANTITIES[name].unit == SEVERAL_UNITS:
            raise ValueError(f"{name} holds numbers of several units; take its columns by result.{name}")
        return pint_quantity(self._named(name), QUANTITIES[name].unit if name in QUANTITIES else "1")

    def gradient(
        self,
        over: str | Iterable[str],
        *,
        of: str | Iterable[str],
        steps: Mapping[str, Any] | None = None,
        workers: int = 1,
    ) -> Gradient:
        """Slopes of results over fields of the case, which is solved anew around its point.

        Parameters
        ----------
        over : str or iterable of str
            Paths of fields, such as ``["clearance.mean", "supply.temperature"]``.
        of, steps, workers
            As of `babbitt.api.case.Case.gradient`.

        Raises
        ------
        InputError
            E005 for one of several results of a case.
        CaseError
            For what is no field with a quantity.
        """
        if self.case is None:
            says = "does not know its case; take the gradient of a case with one bearing at one point"
            raise InputError("E005", f"{self.name} {says}")
        return self.case.gradient(over, of=of, steps=steps, workers=workers)

    def without_state(self) -> BearingResult:
        """The same without its film, which takes memory where many results are kept."""
        return replace(self, solution=self.solution.without_state())

    def to_dict(self) -> dict[str, Any]:
        """Plain dictionaries, lists, strings and finite numbers in SI: a bearing of the JSON output."""
        from babbitt.report.export import bearing_record

        return bearing_record(self.result)

    def to_json(self) -> str:
        """The JSON text of `to_dict`, indented."""
        return json.dumps(self.to_dict(), indent=2, ensure_ascii=False, allow_nan=False) + "\n"

    def to_xarray(self) -> xarray.Dataset:
        """Values and arrays as a dataset, each with ``units`` and ``long_name``.

        Raises
        ------
        InputError
            E007 where xarray is not installed.
        """
        from babbitt.api.tables import dataset_of

        return dataset_of(self)

    def to_dataframe(self) -> pandas.DataFrame:
        """One row: verdict, and every value and entry of a matrix in a column.

        Raises
        ------
        InputError
            E007 where pandas is not installed.
        """
        from babbitt.api.tables import frame_of

        return frame_of([{}], [self])

    def write_report(
        self, path: str | Path, level: str = "standard", units: str = "si", language: str | None = None
    ) -> None:
        """Write the report, as PDF or HTML by the suffix (`babbitt.report.document.write_report`).

        `units` are those of tables and figures, "si" or "us"; `language` is "en", "de" or "ru", that of the title
        block of the case if not given.

        Raises
        ------
        InputError
            E007 for another suffix, a path that cannot be written, or a package that is not installed.
        """
        from babbitt.report.document import write_report
        from babbitt.solving import MachineResult, given_fields, own_words

        case, solved = self.case, self.solution
        machine = MachineResult(
            self.name,
            (solved,),
            self.case_hash,
            case_text=self.case_text,
            own_words=() if case is None else own_words(case),
            title_block=None if case is None else case.title_block,
            given={} if case is None else given_fields(case, [solved.problem]),
        )
        write_report(machine, Path(path), level, units, language)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or "solution" not in self.__dict__:  # copying and pickling ask before all is there
            raise AttributeError(name)
        own = type(self).__dict__.get(name)
        if isinstance(own, property | cached_property):  # it raised this error itself; let it say why again
            return own.__get__(self, type(self))
        return self._named(name)

    def __getstate__(self) -> dict[str, Any]:
        return {one.name: getattr(self, one.name) for one in fields(self)}

    def _named(self, name: str) -> Any:
        result = self.result
        if name in self.values:
            return float(result.values[name])
        if name in self.arrays:
            return self.arrays[name]
        if name in result.missing:
            raise AttributeError(f"{result.name}: {name} could not be found: {result.missing[name]}")
        if not self.solved and (name in result.values or name in result.arrays or name in QUANTITIES):
            raise AttributeError(
                f"{result.name}: no {name}, for there is no operating point ({result.outcome.value}); what the "
                "search reached last is in .last_state"
            )
        if name in QUANTITIES:
            raise AttributeError(f"{result.name}: the method {result.method} does not give {name} here")
        raise AttributeError(f"{result.name}: {unknown_name(name, dir(self), 'among the results')}")

    def __dir__(self) -> list[str]:
        return sorted({one for one in super().__dir__() if not one.startswith("_")} | {*self.values, *self.arrays})

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, BearingResult):
            return NotImplemented
        return _content(self.result) == _content(other.result)

    def __hash__(self) -> int:
        return hash((self.name, self.kind, self.method, self.outcome))

    def __repr__(self) -> str:
        from babbitt.api.result_text import text_of

        return text_of(self.result)

    def _repr_html_(self) -> str:
        from babbitt.api.result_text import html_of

        return html_of(self.result)


def _in_one_row(name: str, rows: Matrix) -> Any:
    """Numbers of pads or frequencies, the only row of their matrix, as a row; other matrices as they are."""
    return rows[0] if len(rows) == 1 and name.startswith(OF_ONE_ROW) else rows


def _read_only(rows: Any) -> Array:
    array = np.array(rows, dtype=np.float64)
    array.setflags(write=False)
    return array


def _content(result: Result) -> tuple[Any, ...]:
    """What makes two results equal; numbers as text, for NaN is not equal to itself."""
    values = sorted((name, repr(float(value))) for name, value in result.values.items() if name not in NOT_CONTENT)
    arrays = sorted(
        (name, repr(np.asarray(rows, dtype=np.float64).tolist())) for name, rows in result.arrays.items()
    )
    return (
        result.name, result.kind, result.method, result.outcome, tuple(values), repr(result.checks),
        result.warnings, result.not_checked, result.assumptions, result.message, sorted(result.settings.items()),
        tuple(arrays), sorted(result.missing.items()),
    )  # fmt: skip
