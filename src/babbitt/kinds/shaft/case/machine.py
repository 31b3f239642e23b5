"""The journal bearings of a shaft as a machine, whose loads and speeds are those of the shaft."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from babbitt.core.solution import Calculation
from babbitt.core.units import written
from babbitt.kinds.journal.case.files import Machine
from babbitt.kinds.shaft.answer import ShaftAnswer
from babbitt.kinds.shaft.case.bearings import ShaftJournal

if TYPE_CHECKING:
    from babbitt.kinds.shaft.case.shaft import ShaftCase

__all__ = ["journal_calculations", "machine_of"]


def machine_of(case: ShaftCase, answer: ShaftAnswer) -> Machine | None:
    """The journal bearings under the loads of the shaft; None where there are none.

    Parameters
    ----------
    case : ShaftCase
    answer : ShaftAnswer
        Of its shaft.
    """
    bearings = tuple(
        one.loaded(answer, place, case.speed)
        for place, one in enumerate(case.bearings)
        if isinstance(one, ShaftJournal)
    )
    if not bearings:
        return None
    shared: dict[str, Any] = {
        name: getattr(case, name)
        for name in ("lubricant", "supply", "cooling", "materials", "clearance_cases", "assumptions")
    }
    return Machine.model_construct(kind="machine", name=case.name, bearings=bearings, **shared)


def journal_calculations(case: ShaftCase, answer: ShaftAnswer) -> Iterator[Calculation]:
    """One problem for each journal bearing, operating point and clearance, which tells where its load is from."""
    machine = machine_of(case, answer)
    for one in machine.calculations() if machine is not None else ():
        said = ("Load and speed", f"of the shaft {case.name} at {written(case.speed, 'rpm')}")
        problem: Any = one.problem
        yield replace(one, problem=replace(problem, given=(said, *problem.given)))
