"""Cases of a program, solved one by one by the engine of studies, in this process or several."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.api.answers import solutions_of
from babbitt.core.files.reading import Reach
from babbitt.report.verdict import worst_verdict
from babbitt.solving import MachineResult
from babbitt.study.engine import Engine, InterruptedStudyError, NoWatch
from babbitt.study.rows import Columns, RowTask
from babbitt.study.workers import Alone, Processes

if TYPE_CHECKING:
    from babbitt.api.case import Case

__all__ = ["solved_cases"]


def solved_cases(cases: Sequence[Case], workers: int, keep: str) -> list[MachineResult]:
    """Solve cases, each for the first of its steady states; what they are, whoever solves them, in their order.

    Parameters
    ----------
    cases : sequence of Case
        Complete ones, at least one.
    workers : int
        Processes of this machine.
    keep : str
        ``results``, or ``solutions`` with the state of every film.
    """
    hands = Alone() if workers == 1 else Processes(min(workers, len(cases)))
    task = _CaseTask(cases[0].kind, {}, Path(), Reach.FOLDER, (), keep=keep)
    try:
        found = Engine(task, hands, 1, None, NoWatch()).answers({"case": _objects(cases)}, "given")
    except InterruptedStudyError as error:
        raise KeyboardInterrupt(str(error)) from None
    finally:
        hands.stop()
    results: list[MachineResult] = found["result"].tolist()
    return results


@dataclass(frozen=True, eq=False)
class _CaseTask(RowTask):
    """Rows that are cases of their own, whose answers are whole results."""

    keep: str = "results"

    def answers(self, rows: Columns) -> Columns:
        """Solve the case of each row."""
        found = [_first_state(case, self.keep) for case in rows["case"]]
        verdicts = [worst_verdict(one.results).key for one in found]
        return {"row": rows["row"], "verdict": _objects(verdicts), "result": _objects(found)}


def _first_state(case: Case, keep: str) -> MachineResult:
    """Solve one case: the first of its steady states."""
    found = solutions_of(case)
    first = replace(found, solutions=found.solutions[:1])
    return first if keep == "solutions" else first.without_states()


def _objects(values: Sequence[Any]) -> NDArray[np.object_]:
    made = np.empty(len(values), object)
    made[:] = values
    return made
