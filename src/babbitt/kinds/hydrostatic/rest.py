"""Whether a hydrostatic journal floats before it turns."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from babbitt.core.notices import Notice
from babbitt.kinds.hydrostatic.answer import answer
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.hydrostatic.state import SearchOutcome

__all__ = ["warnings_about_rest"]

CANNOT_FLOAT = (SearchOutcome.OVERLOADED,)
"""Ends of a search that found no gap under the load."""


def warnings_about_rest(case: HydrostaticCase) -> Iterator[Notice]:
    """Tell where rotation alone carries the load of a journal: at rest its recesses do not.

    Parameters
    ----------
    case : HydrostaticCase
        At its temperature; that of the oil at rest changes the share of orifices alone.
    """
    if not case.is_journal or case.duty.load is None or case.duty.angular_speed == 0.0:
        return
    resting = answer(replace(case, duty=replace(case.duty, angular_speed=0.0), accuracy="draft"))
    if resting.ending in CANNOT_FLOAT:
        yield Notice("W330", values={"load": case.duty.load, "share": resting.carried})
