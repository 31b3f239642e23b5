"""A study from its block to its table: planned, computed, kept, and opened again."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt import __version__
from babbitt.case.case_file import CaseFile
from babbitt.case.case_hash import case_hash
from babbitt.case.kinds import KINDS
from babbitt.case.loading import case_from_dict
from babbitt.case.named_files import NamedFiles
from babbitt.case.parts.study import StudyBlock
from babbitt.case.with_units import with_units
from babbitt.core.nearest_name import unknown_name
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Check, Result
from babbitt.study import corners, design, grids, indices, optimum, size, spectrum
from babbitt.study.appraisal import ALL_LIMITS, counted, require_known
from babbitt.study.engine import Engine, NoWatch, Watch, chunk_size, timed
from babbitt.study.examples import Example, first_solved, nominal_example
from babbitt.study.inputs import Input, inputs_of
from babbitt.study.laws import Choices, Listed
from babbitt.study.maps import FROM, TO, default_axes
from babbitt.study.rows import Columns, RowTask
from babbitt.study.sampling import batch_sizes
from babbitt.study.store import FORMAT, Store
from babbitt.study.table_cells import BearingTable
from babbitt.study.table_rows import inputs_as_told, inputs_of_table, table_in
from babbitt.study.workers import Alone, Processes, Workers

__all__ = ["Study", "case_of", "open_study", "plan", "plan_table", "require_possible", "run_study"]

KEY_RESULTS = (
    "minimum_film_thickness",
    "friction_power",
    "outlet_temperature",
    "effective_temperature",
    "maximum_temperature",
    "total_flow",
    "maximum_pressure",
    "eccentricity_ratio",
)
"""Kept where the study names no outputs, as far as the method gives them."""

FEWEST_KEY_RESULTS, MOST_OUTPUTS = 3, 12
"""Of a method that gives fewer of them its first results are kept, at most so many."""

ASSUMED = {
    "map": f"{FROM:g} to {TO:g} times what the case has (assumption)",
    "corners": f"{corners.COLDER:g} K below and {corners.HOTTER:g} K above what the case has (assumption)",
}
"""Reasons of what varies where nothing is named."""

SHORT = 3.0
"""Seconds of work for which no process is started: starting takes as long."""


@dataclass(frozen=True, eq=False)
class Plan:
    """What a study will compute.

    Attributes
    ----------
    case : CaseFile
    block : StudyBlock
    task : RowTask
    rows : int
    seconds_a_row : float
        Measured on the nominal case.
    checks, advisories : tuple of dict
        Code, quantity, limit and bound of the limits of the nominal case, and of what is recommended or screened.
    not_checked : tuple of dict
        Code and message of the checks for which the nominal case lacks data.
    given : mapping
        By the path of each input of a table its values; of other studies nothing.
    """

    case: CaseFile
    block: StudyBlock
    task: RowTask
    rows: int
    seconds_a_row: float
    checks: tuple[dict[str, Any], ...]
    advisories: tuple[dict[str, Any], ...]
    not_checked: tuple[dict[str, str], ...]
    given: Mapping[str, NDArray[Any]] = field(default_factory=dict)

    @property
    def work(self) -> float:
        """Seconds that one process would take, about."""
        return self.rows * self.seconds_a_row

    def hands(self, count: int) -> Workers:
        """So many processes, or this one where starting them takes as long as the work."""
        return Alone() if self.work < SHORT else Processes(min(count, self.rows))

    @property
    def description(self) -> dict[str, Any]:
        """What ``study.json`` says."""
        return {
            "format": FORMAT,
            "babbitt": __version__,
            "name": self.case.name,
            "case_hash": case_hash(self.case),
            "study": self.block.model_dump(exclude_defaults=True, mode="json"),
            "inputs": [_told(one, self.block.kind) for one in self.task.inputs],
            "outputs": list(self.task.outputs),
            "checks": list(self.checks),
            "advisories": list(self.advisories),
            "not_checked": list(self.not_checked),
            "rows": self.rows,
            "rows_in_chunk": chunk_size(self.seconds_a_row),
            "batches": batch_sizes(grids.samples_of(self.block), self.block.sampling),
            "kind": self.case.kind,
            "case": json.loads(json.dumps(_given(self.case), default=str)),
            "text": self.case.text,
        }


def _described(one: Check) -> dict[str, Any]:
    return {"code": one.code, "quantity": one.quantity, "limit": one.limit, "bound": one.bound.value}


def _told(one: Input, kind: str) -> dict[str, Any]:
    """An input in words and numbers."""
    drawn = kind in ("tolerance", "sensitivity") and isinstance(one.law, Listed | Choices)
    told: dict[str, Any] = {"path": one.path, "field": one.field, "unit": one.unit, "meaning": one.meaning}
    told |= {"law": f"{one.law.words}{', equally likely' * drawn}", "reason": one.reason, "form": one.form}
    if one.is_choice:
        return told | {"values": list(one.law.values)}  # type: ignore[union-attr]
    return told | {"support": [float(end) for end in one.law.support]}  # type: ignore[union-attr]


@dataclass(frozen=True, eq=False)
class Study:
    """A study that was computed, or as much of it as is.

    Attributes
    ----------
    description : mapping
        Case, plan and versions, as ``study.json`` has them.
    columns : dict of str to ndarray
        A line for each row and bearing: ``row``, ``group``, ``bearing``, inputs and outputs in SI, margins,
        ``status``, ``verdict``, ``governing_check``, ``failed_checks``, ``message``.
    folder : Path or None
        Where it is stored.
    """

    description: Mapping[str, Any]
    columns: Columns
    folder: Path | None = None

    @property
    def block(self) -> StudyBlock:
        """What was asked."""
        return StudyBlock.model_validate(self.description["study"])

    @property
    def kind(self) -> str:
        """Which question."""
        return str(self.description["study"]["kind"])

    @property
    def inputs(self) -> tuple[dict[str, Any], ...]:
        """The fields that vary: path, unit, meaning, law, reason, and support or values."""
        return tuple(self.description["inputs"])

    @property
    def outputs(self) -> tuple[str, ...]:
        """Quantities that were kept."""
        return tuple(self.description["outputs"])

    @property
    def rows(self) -> int:
        """Rows that are finished."""
        return int(np.unique(self.columns["row"]).size)

    @property
    def complete(self) -> bool:
        """Whether all rows are finished."""
        return self.rows >= int(self.description["rows"])

    def of(self, group: str) -> Columns:
        """The lines of rows that are for one thing."""
        chosen = self.columns["group"] == group
        return {name: column[chosen] for name, column in self.columns.items()}


def plan(case: CaseFile, block: StudyBlock) -> Plan:
    """Plan a study; nothing is written, and one case is solved.

    Raises
    ------
    InputError
        For all that makes the study impossible.
    """
    if block.kind == "table":
        return _plan_of_table(case, block, table_in(case, str(block.rows)))
    stated, block = block.vary, _completed(case, block)
    inputs, rows = require_possible(case, block)
    inputs = tuple(_with_reason(case, block, one) if one.path not in stated else one for one in inputs)
    task = _task(case, block, inputs)
    return _planned(case, block, task, rows, nominal_example(case, task))


def _with_reason(case: CaseFile, block: StudyBlock, one: Input) -> Input:
    """A field that the study does not name, with why it varies as it does."""
    if one.path not in block.vary:
        return one
    if block.kind == "design":
        return replace(one, reason=str(design.rules_of(case.kind).REASONS[one.path]))
    return replace(one, reason=ASSUMED.get(block.kind, one.reason))


def plan_table(case: CaseFile, table: BearingTable, outputs: Sequence[str] = ()) -> Plan:
    """Plan the bearings in the rows of a table as `plan` does, `outputs` those of `StudyBlock`."""
    block = StudyBlock(kind="table", rows=table.name, outputs=tuple(outputs))
    return _plan_of_table(case, block, table)


def _plan_of_table(case: CaseFile, block: StudyBlock, table: BearingTable) -> Plan:
    inputs, values = inputs_of_table(case, table)
    grids.require_bearable(table.count, 12 + len(inputs) + len(block.outputs))
    task = _task(case, block, inputs)
    return replace(_planned(case, block, task, table.count, first_solved(case, task, values)), given=values)


def _planned(case: CaseFile, block: StudyBlock, task: RowTask, rows: int, example: Example) -> Plan:
    """The plan of rows of which an example was solved."""
    results = example.results
    require_known(task.limits, results)
    outputs = design.rules_of(case.kind).OUTPUTS if block.kind == "design" else _outputs(block, results)
    checks = {one.code: one for result in results for one in counted(result, task.limits or (ALL_LIMITS,))}
    advisories = {
        check.code: check
        for result in results
        for check in result.checks
        if check.advisory and check.code not in checks
    }
    lacks = {notice.code: notice.message for result in results for notice in result.not_checked}
    task = replace(task, outputs=outputs, codes=tuple(checks), advisories=tuple(advisories))
    seconds = timed(task, {"row": np.array([0]), "group": np.array([grids.NOMINAL], object), **example.values})
    not_checked = tuple({"code": code, "message": said} for code, said in lacks.items() if code not in checks)
    limits, advised = (tuple(map(_described, each.values())) for each in (checks, advisories))
    return Plan(case, block, task, rows, seconds, limits, advised, not_checked)


def require_possible(case: CaseFile, block: StudyBlock) -> tuple[tuple[Input, ...], int]:
    """Find out without solving whether a study can be computed: its fields, and its rows.

    Raises
    ------
    InputError
        For all that makes the study impossible, but for outputs that the results lack.
    """
    if block.kind == "table":
        table = table_in(case, str(block.rows))
        return inputs_of_table(case, table)[0], table.count
    block = _completed(case, block)
    inputs = _inputs(case, block)
    indices.require_numeric(block, inputs)
    optimum.require_pymoo(block, inputs)
    designing = block.kind == "design"
    rows = design.planned(inputs, block, case.kind) if designing else grids.planned(block, inputs)
    grids.require_bearable(rows, 12 + len(inputs) + len(block.outputs))
    return inputs, rows


def _completed(case: CaseFile, block: StudyBlock) -> StudyBlock:
    """The study with what follows from its case where it says nothing."""
    return _COMPLETED[block.kind](case, block) if block.kind in _COMPLETED else block


_COMPLETED: Mapping[str, Callable[[CaseFile, StudyBlock], StudyBlock]] = {
    "map": default_axes,
    "corners": corners.default_oil,
    "size": size.default_scan,
    "design": design.rule_choices,
}


def _inputs(case: CaseFile, block: StudyBlock) -> tuple[Input, ...]:
    if block.kind == "spectrum":
        return spectrum.inputs_of_spectrum(case, block)
    clearance = corners.clearance_input(case) if block.kind == "corners" else None
    return (*(() if clearance is None else (clearance,)), *inputs_of(case, block))


def _task(case: CaseFile, block: StudyBlock, inputs: tuple[Input, ...]) -> RowTask:
    """The case as workers get it."""
    given, fields = _given(case), KINDS[case.kind].model_fields
    if block.over_tolerance and corners.CASES not in fields:
        raise InputError("E004", f"a clearance of kind {case.kind!r} has no tolerances")
    if block.over_tolerance or block.kind in ("corners", "design"):
        given = corners.at_all_clearances(given, fields)
    assert case.origin is not None, "what stands in it was just read"
    limits = block.limits if block.kind == "size" else ()
    return RowTask(case.kind, given, case.origin.file, case.origin.reach, inputs, limits=limits)


def _given(case: CaseFile) -> dict[str, Any]:
    """What stands in a case, with the files that it names in their place."""
    origin = case.origin
    if origin is None:
        raise InputError("E005", f"{case.name}: only a case from a file, a text or a dictionary can be varied")
    return KINDS[case.kind].with_named_files(dict(origin.given), NamedFiles(origin.file.parent, origin.reach))


def _outputs(block: StudyBlock, results: Sequence[Result]) -> tuple[str, ...]:
    """The quantities that are kept: those asked for, else the key results."""
    there = list(dict.fromkeys(name for result in results for name in result.values if name in QUANTITIES))
    asked = tuple(dict.fromkeys((*block.outputs, *block.minimise, *block.maximise)))
    for name in asked:
        if name not in there:
            where = "minimise" if name in block.minimise else "maximise" if name in block.maximise else "outputs"
            raise InputError("E005", f"study.{where}: {unknown_name(name, there, 'a quantity of these results')}")
    if block.outputs:
        return asked
    wanted = corners.CORNER_RESULTS if block.kind == "corners" else KEY_RESULTS
    key = [name for name in wanted if name in there]
    if len(key) < FEWEST_KEY_RESULTS:
        key = [name for name in there if name not in ("wall_time", "iterations")][:MOST_OUTPUTS]
    return tuple(dict.fromkeys((*key, *asked)))


def run_study(
    made: Plan,
    *,
    workers: int | Workers = 1,
    folder: Path | None = None,
    watch: Watch | None = None,
) -> Study:
    """Compute a study.

    Parameters
    ----------
    made : Plan
    workers : int or Workers
        Processes of this machine, or where chunks go instead.
    folder : Path, optional
        Where finished chunks are kept; what stands there of the same study is not computed again.
    watch : Watch, optional
        Follows the progress.

    Raises
    ------
    InterruptedStudyError
        After an interrupt.
    InputError
        E007 for a folder that cannot be used.
    """
    store = Store(folder) if folder is not None else None
    description = made.description
    if store is not None:
        description = store.begin(description)
    hands = _workers(workers, made)
    engine = Engine(made.task, hands, int(description["rows_in_chunk"]), store, watch or NoWatch())
    try:
        columns = _ASKED[made.block.kind](made, engine)
    finally:
        hands.stop()
        if store is not None:
            store.close()
    return Study(description, columns, folder)


def open_study(path: str | Path) -> Study:
    """Read a study that was stored, finished or not.

    Raises
    ------
    InputError
        E007 for a folder that holds no study, or none that is readable.
    """
    store = Store(Path(path))
    return Study(store.description, store.table(), Path(path))


def case_of(study: Study, row: int) -> CaseFile:
    """The case of one row, as it can be solved or written.

    Raises
    ------
    InputError
        E005 for a row that there is not.
    """
    places = np.flatnonzero(study.columns["row"] == row)
    if not places.size:
        raise InputError("E005", f"the study has no row {row}; there are 0 to {study.rows - 1}")
    given = dict(study.description["case"])
    case = case_from_dict(given, study.description["name"])
    told = study.description["inputs"]
    inputs = inputs_as_told(told) if study.kind == "table" else _inputs(case, study.block)
    task = _task(case, study.block, inputs)
    made = task.case({one.path: study.columns[one.path][places[0]] for one in inputs})
    assert made.origin is not None, "it was read just now"
    return made.with_origin(replace(made.origin, given=with_units(made.origin.given, made)))


def _workers(workers: int | Workers, made: Plan) -> Workers:
    if not isinstance(workers, int):
        return workers
    if workers < 1:
        raise InputError("E005", f"workers is {workers}; give 1 or more")
    return Alone() if workers == 1 else made.hands(workers)


def _grid(made: Plan, engine: Engine) -> Columns:
    return engine.answers(*grids.product(made.task.inputs))


def _table(made: Plan, engine: Engine) -> Columns:
    return engine.answers(made.given, GIVEN)


def _tolerance(made: Plan, engine: Engine) -> Columns:
    inputs = made.task.inputs
    blocks = [grids.nominal(inputs), grids.joint_sample(inputs, made.block), grids.corners(inputs)]
    return engine.answers(*grids.stacked(blocks))


def _sensitivity(made: Plan, engine: Engine) -> Columns:
    inputs = made.task.inputs
    base = indices.saltelli(inputs, grids.samples_of(made.block), made.block.seed)
    return engine.answers(*grids.stacked([grids.nominal(inputs), grids.differences(inputs), base]))


def _spectrum(made: Plan, engine: Engine) -> Columns:
    return engine.answers(*spectrum.rows_of_spectrum(made.task.inputs, made.block))


def _size(made: Plan, engine: Engine) -> Columns:
    return size.searched(made.task, made.block, engine)


def _design(made: Plan, engine: Engine) -> Columns:
    return design.designed(made.task, made.block, engine)


def _optimise(made: Plan, engine: Engine) -> Columns:
    return optimum.optimised(made.task, made.block, engine)


GIVEN = "given"
"""What rows of a table are for."""

_ASKED: Mapping[str, Callable[[Plan, Engine], Columns]] = {
    "sweep": _grid,
    "map": _grid,
    "corners": _grid,
    "size": _size,
    "tolerance": _tolerance,
    "sensitivity": _sensitivity,
    "spectrum": _spectrum,
    "optimise": _optimise,
    "table": _table,
    "design": _design,
}
