"""What a study will compute: its block completed, its fields, its rows, and a nominal case solved."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt import __version__
from babbitt.case.case_file import CaseFile
from babbitt.case.case_hash import case_hash
from babbitt.case.kinds import KINDS
from babbitt.case.named_files import NamedFiles
from babbitt.case.parts.study import StudyBlock
from babbitt.core.kind import find_kind
from babbitt.core.limited_flow import limited, may_be_short
from babbitt.core.nearest_name import unknown_name
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Check, Result
from babbitt.study import corners, design, grids, indices, optimum, size, spectrum
from babbitt.study.appraisal import ALL_LIMITS, counted, require_known
from babbitt.study.engine import chunk_size, timed
from babbitt.study.examples import Example, first_solved, nominal_example
from babbitt.study.inputs import Input, inputs_of
from babbitt.study.laws import Choices, Listed
from babbitt.study.maps import FROM, TO, default_axes
from babbitt.study.rows import RowTask
from babbitt.study.sampling import batch_sizes
from babbitt.study.store import FORMAT
from babbitt.study.table_cells import BearingTable
from babbitt.study.table_rows import rows_of_table, table_in
from babbitt.study.workers import Alone, Processes, Workers

__all__ = ["Plan", "inputs_of_study", "plan", "plan_table", "require_possible", "task_of"]

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

_KEPT = {
    "corners": corners.CORNER_RESULTS,
    "tolerance": (*KEY_RESULTS, *(one for one in corners.CORNER_RESULTS if one not in KEY_RESULTS)),
}
"""Of kinds that keep others: what scatters of a rotor's bearing are its stiffness, damping and thresholds, too."""

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
    lines : tuple of int
        Where the rows of a table stand in it.
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
    lines: tuple[int, ...] = ()

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
            **({"lines": list(self.lines)} if self.lines else {}),
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
    task = task_of(case, block, inputs)
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
    found = rows_of_table(case, table)
    grids.require_bearable(table.count, 12 + len(found.inputs) + len(block.outputs))
    task = replace(task_of(case, block, found.inputs), refused=found.refused, table=table.short_name)
    made = _planned(case, block, task, table.count, first_solved(case, task, found.values))
    return replace(made, given=found.values, lines=table.lines)


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
    warm = tuple(code for code, check in checks.items() if check.is_in_kelvin)
    task = replace(task, outputs=outputs, codes=tuple(checks), advisories=tuple(advisories), temperatures=warm)
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
        return rows_of_table(case, table).inputs, table.count
    block = _completed(case, block)
    inputs = inputs_of_study(case, block)
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


def inputs_of_study(case: CaseFile, block: StudyBlock) -> tuple[Input, ...]:
    """The fields that vary, of a completed study."""
    if block.kind == "spectrum":
        return spectrum.inputs_of_spectrum(case, block)
    clearance = corners.clearance_input(case) if block.kind == "corners" else None
    return (*(() if clearance is None else (clearance,)), *inputs_of(case, block))


def task_of(case: CaseFile, block: StudyBlock, inputs: tuple[Input, ...]) -> RowTask:
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
        return _with_held(asked, results)
    wanted = _KEPT.get(block.kind, KEY_RESULTS)
    own = (name for result in results if (kind := find_kind(result.kind)) for name in kind.study_results)
    key = [name for name in dict.fromkeys((*wanted, *own)) if name in there]
    if len(key) < FEWEST_KEY_RESULTS:
        key = [name for name in there if name not in ("wall_time", "iterations")][:MOST_OUTPUTS]
    return _with_held((*key, *asked), results)


def _with_held(names: Sequence[str], results: Sequence[Result]) -> tuple[str, ...]:
    """Quantities, each with the reading that limits are held against where a row may be short of oil."""
    both = ((name, limited(name)) if may_be_short(results, name) else (name,) for name in names)
    return tuple(dict.fromkeys(one for pair in both for one in pair))
