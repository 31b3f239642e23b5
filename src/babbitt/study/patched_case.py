"""A case that was read once, with other numbers in some of its fields: as if it had been read with them.

Reading a case takes as long as many a film. Its numbers are held against the ranges of their fields, and the parts
above them are asked for their rules; what refuses a number is left to those who read the case anew.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, TypeAlias

from babbitt.case.case_file import CaseFile
from babbitt.case.error_messages import metadata_of
from babbitt.case.part import Part, broken_rules
from babbitt.core.units import SiField

if TYPE_CHECKING:
    from babbitt.study.inputs import Input
    from babbitt.study.rows import RowTask

__all__ = ["ENDS", "PatchedCases", "Steps", "is_empty", "patched", "way_to"]

Steps: TypeAlias = "tuple[str, ...]"
"""Names of fields, and numbers of members, from a case to one of its numbers."""

ENDS: Mapping[str, Steps] = {"quantity": (), "clearance": ("mean",), "viscosity": ("nu40",)}
"""By the form of an input, where below its field its number stands in a case that was read."""


def is_empty(value: Any) -> bool:
    """Whether a cell of a table holds nothing.

    >>> import math
    >>> is_empty(math.nan), is_empty(""), is_empty(0.0)
    (True, True, False)
    """
    return bool(value == "" or value != value)


def is_number_in_case(one: Input) -> bool:
    """Whether the values of an input are numbers that stand in the case as they are."""
    return not one.is_choice and one.form in ENDS


def way_to(case: CaseFile, one: Input, value: Any) -> Steps | None:
    """Way to the number of an input in a case that was read with its value; None where it does not stand there."""
    steps = (*one.field.split("."), *ENDS[one.form])
    return steps if _at(case, steps) == value else None


def patched(case: CaseFile, numbers: Mapping[Steps, Any]) -> CaseFile | None:
    """A case with other numbers (or `babbitt.numerics.lanes.Lanes`); None where it does not take them."""
    for steps, value in numbers.items():
        if not _in_range(type(_at(case, steps[:-1])), steps[-1], value):
            return None
        case = _with(case, steps, value)
    above = dict.fromkeys(steps[:depth] for steps in numbers for depth in range(len(steps)))
    parts = [part for steps in above if isinstance(part := _at(case, steps), Part)]
    return None if any(True for part in parts for _ in broken_rules(part)) else case


def _at(case: Any, steps: Steps) -> Any:
    for step in steps:
        case = case[int(step)] if isinstance(case, tuple) else getattr(case, step, None)
    return case


def _in_range(part: type[Part], name: str, values: Any) -> bool:
    """Whether values lie in the range of their field."""
    fields = list(metadata_of(part, name, SiField))
    return all(
        bool((one.ranged(values) >= one.bounds[0]) & (one.ranged(values) <= one.bounds[1]))
        for one in fields
        if one.bounds is not None
    )


def _with(case: Any, steps: Steps, value: Any) -> Any:
    """A case with a value in one place."""
    if not steps:
        return value
    first, rest = steps[0], steps[1:]
    if isinstance(case, tuple):
        place = int(first)
        return (*case[:place], _with(case[place], rest, value), *case[place + 1 :])
    return case.model_copy(update={first: _with(getattr(case, first), rest, value)})


@dataclass(eq=False)
class _Read:
    """A case that was read for one row, ways to its numbers, and whether another row was the same when read."""

    case: CaseFile
    ways: Mapping[str, Steps]
    confirmed: bool = False


@dataclass(eq=False)
class PatchedCases:
    """Cases of the rows of a study, one by one; those that differ in numbers alone share one that was read.

    Attributes
    ----------
    task : RowTask
    """

    task: RowTask
    _known: dict[tuple[str, ...], _Read | None] = field(default_factory=dict)

    def case(self, row: Mapping[str, Any]) -> CaseFile:
        """The case of a row, as `RowTask.case` gives it; raises as it does.

        Rows are read until two of them show that numbers stand nowhere but where they are put.
        """
        words = tuple(
            str(is_empty(row[one.path]) if is_number_in_case(one) else row[one.path]) for one in self.task.inputs
        )
        if words not in self._known:
            case = self.task.case(row)
            self._known[words] = self._read(case, row)
            return case
        known = self._known[words]
        found = (
            None
            if known is None
            else patched(known.case, {way: float(row[path]) for path, way in known.ways.items()})
        )
        if known is None or found is None:
            return self.task.case(row)
        if not known.confirmed:
            read = self.task.case(row)
            known.confirmed = read == found
            if not known.confirmed:
                self._known[words] = None
            return read
        return found

    def _read(self, case: CaseFile, row: Mapping[str, Any]) -> _Read | None:
        ways: dict[str, Steps] = {}
        for one in self.task.inputs:
            if not is_number_in_case(one) or is_empty(row[one.path]):
                continue
            way = way_to(case, one, row[one.path])
            if way is None:
                return None
            ways[one.path] = way
        return _Read(case, ways)
