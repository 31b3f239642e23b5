"""Studies of a bearing in Python: many variants of it, one question."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from babbitt.api.given import as_given
from babbitt.api.tables import attributes_of
from babbitt.case.case_file import CaseFile
from babbitt.case.field_types import quantity_in
from babbitt.case.loading import problems_of
from babbitt.case.parts.study import StudyBlock
from babbitt.case.problems import CaseError, Problem
from babbitt.case.with_units import quantity_text
from babbitt.core.optional_package import how_to_install, optional_package
from babbitt.core.result import Verdict
from babbitt.core.units import AS_WRITTEN, KINDS, SiField
from babbitt.study import study as engine
from babbitt.study.best_designs import require_stored_designs, write_designs
from babbitt.study.design import Designs, designs_of
from babbitt.study.engine import InterruptedStudyError
from babbitt.study.fields import types_at
from babbitt.study.held_film import as_read
from babbitt.study.indices import Indices, indices_of
from babbitt.study.optimum import Optimum, optimum_of
from babbitt.study.plan import Plan, plan, plan_table
from babbitt.study.size import Size, size_of
from babbitt.study.spectrum import SpectrumSummary, spectrum_summary
from babbitt.study.table_cells import read_table, table_of_columns
from babbitt.study.workers import Cluster, Given, Workers
from babbitt.study.yields import ToleranceSummary, tolerance_summary

if TYPE_CHECKING:
    import pandas
    import xarray

    from babbitt.api.case import Case

__all__ = ["Study", "run", "scalar", "solved_table", "studied"]

EXECUTOR_CHUNKS = 8
"""Chunks that an executor, which does not tell how many workers it has, gets at once."""

PLAIN = ("range", "log_range", "uniform", "triangular", "values")
"""Ways to say values in which every number is one of the field."""


class Study:
    """A study that was computed, or read back from its folder.

    Parameters
    ----------
    study : babbitt.study.study.Study
    public : callable
        Makes a bearing of the Python front door of a case.
    """

    def __init__(self, study: engine.Study, public: Callable[[CaseFile], Any]) -> None:
        self._study, self._public = study, public

    @property
    def kind(self) -> str:
        """What was asked: ``sweep``, ``size``, ``tolerance``, ``map``, ``sensitivity``, ``spectrum``, ..."""
        return self._study.kind

    @property
    def complete(self) -> bool:
        """Whether all rows are finished."""
        return self._study.complete

    @property
    def table(self) -> pandas.DataFrame:
        """A line for each row and bearing; ``frame.attrs["units"]`` has the units of the columns, SI.

        ``row``, ``group``, ``bearing``, inputs, outputs, ``margin`` and those of all limits and (``advisory_``)
        recommendations, ``status``, ``verdict``, ``governing_check``, ``failed_checks``, ``message``.

        Raises
        ------
        InputError
            E007 where pandas is not installed.
        """
        package = optional_package("pandas", "tables of studies", how_to_install("pandas", "studies"))
        frame: pandas.DataFrame = package.DataFrame(self._study.columns)
        frame.attrs["units"] = self._units()
        return frame

    @property
    def answer(
        self,
    ) -> ToleranceSummary | tuple[Indices, ...] | tuple[SpectrumSummary, ...] | Optimum | Designs | Size | None:
        """What the study comes to, in SI, of the films that limits are held against.

        None for a sweep, map and corners, whose answer is the table.
        """
        study = as_read(self._study)
        match self.kind:
            case "tolerance":
                return tolerance_summary(study)
            case "sensitivity":
                return indices_of(study)
            case "spectrum":
                return spectrum_summary(study)
            case "optimise":
                return optimum_of(study)
            case "design":
                return designs_of(study)
            case "size":
                return size_of(study)
        return None

    def summary(self) -> str:
        """The tables that ``babbitt study`` prints, as text."""
        from rich.console import Console

        from babbitt.report.study_table import print_study

        console = Console(width=200, color_system=None, force_terminal=False)
        with console.capture() as captured:
            print_study(self._study, console)
        return captured.get()

    def case(self, row: int) -> Any:
        """The bearing of one row, which can be solved, changed and written.

        Raises
        ------
        InputError
            E005 for a row that there is not.
        """
        return self._public(engine.case_of(self._study, row))

    def to_xarray(self) -> xarray.Dataset:
        """A sweep, map or corners over its fields; several bearings are along a dimension of their own.

        Raises
        ------
        InputError
            E004 for another kind; E007 where xarray is not installed.
        """
        from babbitt.core.notices import InputError
        from babbitt.report.fields import require_package

        if self.kind not in ("sweep", "map", "corners"):
            raise InputError("E004", f"a study of kind {self.kind} is no grid; .table has its rows")
        package = require_package("xarray")
        paths = [one["path"] for one in self._study.inputs]
        frame = self.table
        frame = frame[frame["bearing"] != ""]
        several = frame["bearing"].nunique() > 1
        axes = (["bearing"] if several else []) + paths
        kept = [*self._study.outputs, *(name for name in frame if name.startswith(("margin", "advisory")))]
        kept += ["status", "verdict", "governing_check", "failed_checks"]
        made: xarray.Dataset = package.Dataset.from_dataframe(frame.set_index(axes)[kept])
        units = self._units()
        for name in (*paths, *kept):
            about = attributes_of(name)
            made[name].attrs.update(about or ({"units": units[name]} if name in units else {}))
        return made

    def _units(self) -> dict[str, str]:
        told = {one["path"]: one["unit"] for one in self._study.inputs if one["unit"]}
        return told | {
            name: about["units"] for name in self._study.outputs if (about := attributes_of(name)).get("units")
        }

    def __repr__(self) -> str:
        counts = {one: int((self._study.columns["verdict"] == one.key).sum()) for one in Verdict}
        told = ", ".join(f"{count} {verdict.value}" for verdict, count in counts.items() if count)
        over = ", ".join(one["path"] for one in self._study.inputs)
        name, rows = self._study.description["name"], self._study.rows
        return f"{name}: study of kind {self.kind} over {over}, {rows} rows\n  {told}\n  .summary(), .table"


def studied(
    case: Case,
    kind: str | None,
    vary: Mapping[str, Any] | None,
    outputs: Sequence[str],
    samples: int | None,
    out: str | Path | None,
    workers: int | Executor | str,
    options: Mapping[str, Any],
) -> Study:
    """Study a case; arguments are those of `babbitt.api.case.Case.study`."""
    complete = case.complete()
    block = _block(complete, kind, vary, outputs, samples, options)
    return run(complete, plan(complete, block), out, workers, type(case).of)


def solved_table(
    case: Case,
    table: str | Path | Mapping[str, Any],
    outputs: Sequence[str],
    out: str | Path | None,
    workers: int | Executor | str,
) -> Study:
    """Solve the rows of a table; arguments are those of `babbitt.api.case.Case.solve_table`."""
    rows = read_table(Path(table)) if isinstance(table, str | Path) else table_of_columns(table)
    return run(case, plan_table(case.complete(), rows, outputs), out, workers, type(case).of)


def run(
    case: CaseFile,
    made: Plan,
    out: str | Path | None,
    workers: int | Executor | str,
    public: Callable[[CaseFile], Any],
) -> Study:
    """Compute a study that is planned, keep it if asked to, and write its designs."""
    folder = None if out is None else Path(out)
    require_stored_designs(folder)
    try:
        found = engine.run_study(made, workers=_workers(workers), folder=folder)
    except InterruptedStudyError as error:
        raise KeyboardInterrupt(str(error)) from None
    write_designs(found)
    return Study(found, public)


def _workers(workers: int | Executor | str) -> int | Workers:
    if isinstance(workers, str):
        return Cluster(workers)
    return Given(workers, EXECUTOR_CHUNKS) if isinstance(workers, Executor) else workers


def _block(
    case: Case,
    kind: str | None,
    vary: Mapping[str, Any] | None,
    outputs: Sequence[str],
    samples: int | None,
    options: Mapping[str, Any],
) -> StudyBlock:
    """The study that was asked for; that of the file where nothing was."""
    where = f"{type(case).__name__}.study"
    if kind is None:
        if case.study_block is None or vary or outputs or samples or options:
            says = "is missing" if case.study_block is not None else "is missing, and its file has no study"
            raise CaseError([Problem(where, 0, "kind", says, allowed="such as 'tolerance'")])
        return case.study_block
    given: dict[str, Any] = {"kind": kind, "outputs": list(outputs), **options}
    given |= {} if samples is None else {"samples": samples}
    given = as_given(given, where)
    varied = {path: as_given(one, where, (path,)) for path, one in (vary or {}).items()}
    given["vary"] = {path: _with_units(case, path, one) for path, one in varied.items()}
    for one in given.get("load_cases", ()):
        if isinstance(one, dict) and isinstance(one.get("set"), dict):
            one["set"] = {path: scalar(case, path, value) for path, value in one["set"].items()}
    try:
        return StudyBlock.model_validate(given, context=AS_WRITTEN)
    except ValidationError as error:
        raise CaseError(problems_of(error.errors(include_url=False), given, where)) from None


def _with_units(case: Case, path: str, given: Any) -> Any:
    """Numbers of the program, which are in SI, written with the unit of their field."""
    if isinstance(given, list):
        return [scalar(case, path, one) for one in given]
    if not isinstance(given, dict):
        return given
    made = dict(given)
    for name in PLAIN:
        if isinstance(made.get(name), list):
            last = 1 if name in ("range", "log_range") else 0  # the number of values has no unit
            numbers, count = made[name][: len(made[name]) - last], made[name][len(made[name]) - last :]
            made[name] = [*(scalar(case, path, one) for one in numbers), *count]
    if isinstance(made.get("normal"), list):
        mean, *deviation = made["normal"]
        made["normal"] = [scalar(case, path, mean), *(scalar(case, path, one, True) for one in deviation)]
    if "half_normal" in made:
        made["half_normal"] = scalar(case, path, made["half_normal"], True)
    return made


def scalar(case: Case, path: str, value: Any, deviation: bool = False) -> Any:
    """A number of a program, which is in SI, with the unit of its field; anything else as it is."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return value
    found = map(quantity_in, types_at(case, path))
    quantity = next((one for one in found if isinstance(one, SiField)), None)
    if quantity is None:
        return value
    kind = KINDS["K difference"] if deviation and quantity.unit == "K" else quantity.kind
    return quantity_text(float(value), kind)
