"""A study from its plan to its table: computed, kept, and opened again."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.case.case_file import CaseFile
from babbitt.case.loading import case_from_dict
from babbitt.case.parts.study import StudyBlock
from babbitt.case.with_units import with_units
from babbitt.core.notices import InputError
from babbitt.study import design, grids, indices, optimum, size, spectrum
from babbitt.study.engine import Engine, NoWatch, Watch
from babbitt.study.plan import Plan, inputs_of_study, task_of
from babbitt.study.rows import Columns
from babbitt.study.store import Store
from babbitt.study.table_rows import inputs_as_told
from babbitt.study.workers import Alone, Workers

__all__ = ["Study", "case_of", "open_study", "run_study"]


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

    @property
    def lines(self) -> NDArray[np.int64]:
        """Where the row of each line stands: in the sheet of a table, else its number."""
        row: NDArray[np.int64] = self.columns["row"]
        lines = self.description.get("lines")
        return row if lines is None else np.array(lines)[row]

    def of(self, group: str) -> Columns:
        """The lines of rows that are for one thing."""
        chosen = self.columns["group"] == group
        return {name: column[chosen] for name, column in self.columns.items()}


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
    inputs = inputs_as_told(told) if study.kind == "table" else inputs_of_study(case, study.block)
    task = task_of(case, study.block, inputs)
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
