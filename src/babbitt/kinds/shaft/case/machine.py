"""The bearings of a shaft under its loads and speed: journal bearings as a machine, and the thrust bearing."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from babbitt.case.part import is_given
from babbitt.core.solution import Calculation
from babbitt.core.units import written
from babbitt.kinds.journal.case.files import Machine
from babbitt.kinds.shaft.answer import ShaftAnswer
from babbitt.kinds.shaft.case.bearings import ShaftJournal, ShaftThrust

if TYPE_CHECKING:
    from babbitt.kinds.shaft.case.shaft import ShaftCase

__all__ = ["bearing_calculations", "machine_of"]


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
        if name != "clearance_cases" or is_given(case, name)
    }
    return Machine.model_construct(kind="machine", name=case.name, bearings=bearings, **shared)


def bearing_calculations(case: ShaftCase, answer: ShaftAnswer) -> Iterator[Calculation]:
    """One problem for each journal bearing, operating point and clearance, then that of the thrust bearing.

    Each tells where its load is from.
    """
    machine = machine_of(case, answer)
    calculations = list(machine.calculations()) if machine is not None else []
    for one in case.bearings:
        if isinstance(one, ShaftThrust):
            calculations += one.loaded(answer).calculations()
    said = ("Load and speed", f"of the shaft {case.name} at {written(case.speed, 'rpm')}")
    for each in calculations:
        problem: Any = each.problem
        yield replace(each, problem=replace(problem, given=(said, *problem.given)))
