"""The journal bearings of a shaft by every method, under the loads and slopes of the shaft."""

from __future__ import annotations

from babbitt.core.notices import InputError
from babbitt.kinds.journal.compare.comparison import compare as compare_journals
from babbitt.kinds.shaft.case.machine import machine_of
from babbitt.kinds.shaft.case.shaft import ShaftCase
from babbitt.study.comparison import Comparison

__all__ = ["compare"]


def compare(case: ShaftCase) -> tuple[Comparison, ...]:
    """Solve every journal bearing of a shaft by every method that applies to it.

    Raises
    ------
    InputError
        E004 when the shaft has no journal bearing that is computed.
    """
    machine = machine_of(case, case.answer)
    if machine is None:
        raise InputError(
            "E004", f"{case.name}: the shaft has no bearing of kind journal, which several methods know"
        )
    return compare_journals(machine)
