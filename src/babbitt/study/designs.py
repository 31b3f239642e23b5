"""Several designs side by side: the inputs in which they differ, and the results of each bearing of theirs."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

from babbitt.case.case_file import CaseFile
from babbitt.case.field_types import quantity_in
from babbitt.case.part import Part
from babbitt.case.with_units import FEW_DIGITS, short_quantity
from babbitt.core.notices import InputError
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.quantities import QUANTITIES
from babbitt.core.quantities.display import written_in_system
from babbitt.core.result import Result
from babbitt.core.result_name import ResultName
from babbitt.core.units import Kind
from babbitt.solving import MachineResult, solve

__all__ = ["ABSENT", "ChangedInput", "ComparedBearing", "Designs", "changed_inputs", "compare_designs"]

ABSENT = "–"
"""In place of what a design does not have."""

ALL_DIGITS = 12
"""Significant digits of a quantity at most."""

OF_THE_FILE = ("babbitt", "name", "notes", "source")
"""Fields of a whole file that describe nothing."""

NOT_COMPARED = ("wall_time", "iterations")
"""Results that say how it was computed."""


@dataclass(frozen=True)
class ChangedInput:
    """A field in which designs differ.

    Attributes
    ----------
    path : str
    values : tuple of str
        Its text in each design, in units of the SI.
    numbers : tuple of float or None
        In SI, None where a design does not have it; of a field that takes no quantity nothing.
    kind : Kind or None
        Of the quantity.
    """

    path: str
    values: tuple[str, ...]
    numbers: tuple[float | None, ...] = ()
    kind: Kind | None = None

    @property
    def shown(self) -> tuple[str, ...]:
        """The texts in the units that are spoken, short as long as they tell what differs."""
        texts, kind = self.values, self.kind
        if kind is None:
            return texts
        for digits in (FEW_DIGITS, ALL_DIGITS):
            texts = tuple(
                ABSENT if one is None else short_quantity(one, kind, digits, written_in_system)
                for one in self.numbers
            )
            if len(set(texts)) == len(set(self.values)):
                break
        return texts


@dataclass(frozen=True)
class ComparedBearing:
    """A bearing, operating point and clearance that designs have in common.

    Attributes
    ----------
    name : str
    results : tuple of Result or None
        One for each design, None where it has no such bearing.
    quantities : tuple of str
        Names of the results put side by side.
    """

    name: str
    results: tuple[Result | None, ...]
    quantities: tuple[str, ...]


@dataclass(frozen=True)
class Designs:
    """Designs side by side; differences count against the first.

    Attributes
    ----------
    labels : tuple of str
        By what the designs are called, each once.
    kinds : tuple of str
    machines : tuple of MachineResult
    changed : tuple of ChangedInput
        Every input in which they differ, defaults included.
    bearings : tuple of ComparedBearing
    """

    labels: tuple[str, ...]
    kinds: tuple[str, ...]
    machines: tuple[MachineResult, ...]
    changed: tuple[ChangedInput, ...]
    bearings: tuple[ComparedBearing, ...]

    @property
    def one_kind(self) -> bool:
        """Whether all designs are of one kind; else only results that all have are compared."""
        return len(set(self.kinds)) == 1

    @property
    def solved(self) -> bool:
        """Whether every bearing of every design has an operating point."""
        return all(one.solved for one in self.machines)


def compare_designs(
    cases: Sequence[CaseFile], labels: Sequence[str], progress: ProgressCallback = no_progress
) -> Designs:
    """Solve several cases and put them side by side.

    Parameters
    ----------
    cases : sequence of CaseFile
    labels : sequence of str
        What to call them; equal ones are numbered.
    progress : callable
        As of `babbitt.solving.solve`.

    Raises
    ------
    InputError
        E004 for fewer than two cases, or cases of different kinds without a bearing in common.
    """
    if len(cases) < 2:
        raise InputError("E004", "designs are compared from two cases on")
    machines = tuple(solve(case, progress) for case in cases)
    kinds = tuple(case.kind for case in cases)
    bearings = tuple(_matched(machines))
    if not any(sum(one is not None for one in bearing.results) > 1 for bearing in bearings):
        names = "; ".join(", ".join(one.name for one in machine.results) for machine in machines)
        says = f"the designs have no bearing, operating point and clearance in common: {names}"
        raise InputError("E004", f"{says}. {_remedy(machines)}")
    return Designs(_each_once(labels), kinds, machines, changed_inputs(cases), bearings)


def changed_inputs(cases: Sequence[CaseFile]) -> tuple[ChangedInput, ...]:
    """Every field in which cases differ, with the values that count, whether given or by default."""
    inputs = [
        {path: leaf for path, leaf in _inputs(case, ()) if path.partition(".")[0] not in OF_THE_FILE}
        for case in cases
    ]
    rows = (
        _row(path, [one.get(path) for one in inputs]) for path in dict.fromkeys(p for one in inputs for p in one)
    )
    return tuple(row for row in rows if len(set(row.values)) > 1)


_Leaf = tuple[str | float, Kind | None]
"""A text, or a number in SI with the kind of its quantity."""


def _row(path: str, leaves: Sequence[_Leaf | None]) -> ChangedInput:
    """A field with what each design has in it."""
    texts = tuple(ABSENT if one is None else _said_of(one) for one in leaves)
    kind, *others = dict.fromkeys(one[1] for one in leaves if one is not None)
    if kind is None or others:
        return ChangedInput(path, texts)
    return ChangedInput(path, texts, tuple(None if one is None else float(one[0]) for one in leaves), kind)


def _said_of(leaf: _Leaf) -> str:
    """A leaf in units of the SI."""
    value, kind = leaf
    if isinstance(value, str):
        return value
    assert kind is not None, "a number is one of a quantity"
    return short_quantity(value, kind, ALL_DIGITS)


def _inputs(part: Part, path: tuple[str, ...]) -> Iterator[tuple[str, _Leaf]]:
    for name, field in type(part).model_fields.items():
        quantity = quantity_in(field.rebuild_annotation())
        yield from _leaves(getattr(part, name), (*path, name), None if quantity is None else quantity.kind)


def _leaves(value: Any, path: tuple[str, ...], kind: Kind | None) -> Iterator[tuple[str, _Leaf]]:
    match value:
        case None:
            return
        case Part():
            yield from _inputs(value, path)
        case tuple():
            for index, one in enumerate(value):
                own = getattr(one, "name", None) if isinstance(one, Part) else None
                yield from _leaves(one, (*path, own if isinstance(own, str) else str(index)), kind)
        case float() if kind is not None:
            yield ".".join(path), (value, kind)
        case bool():
            yield ".".join(path), ("yes" if value else "no", None)
        case _:
            yield ".".join(path), (f"{value:.12g}" if isinstance(value, float) else str(value), None)


def _matched(machines: Sequence[MachineResult]) -> Iterator[ComparedBearing]:
    """Bearings of equal name, point and clearance; in designs of one bearing each, whatever they are called.

    Beside a bearing of which all clearances are solved, one that is solved at one stands for its mean.
    """
    single = _single(machines)
    several = {_known_as(one, single) for machine in machines for one in machine.results if _clearance(one)}
    tables = [{_key(one, single, several): one for one in machine.results} for machine in machines]
    for key in dict.fromkeys(key for table in tables for key in table):
        results = tuple(table.get(key) for table in tables)
        first = next(one for one in results if one is not None)
        name: str = first.name
        if isinstance(name, ResultName) and not name.member and key[2]:
            name = ResultName(name.bearing, name.point, "mean")
        yield ComparedBearing(name, results, _quantities([one for one in results if one is not None]))


def _single(machines: Sequence[MachineResult]) -> bool:
    """Whether each design is of one bearing."""
    return all(len({_bearing(one) for one in machine.results}) == 1 for machine in machines)


def _remedy(machines: Sequence[MachineResult]) -> str:
    """What to do about designs with nothing in common, by what of their names is not the same."""
    shared = set.intersection(*({_bearing(one) for one in machine.results} for machine in machines))
    if shared or _single(machines):
        return "Their bearings match: give their operating points the same names, or none."
    return "Give bearings and operating points the same names."


def _bearing(result: Result) -> str:
    return result.name.bearing if isinstance(result.name, ResultName) else result.name


def _clearance(result: Result) -> str:
    """At which clearance a bearing is solved of which several are; empty where one alone is."""
    return result.name.clearance if isinstance(result.name, ResultName) else ""


def _known_as(result: Result, single: bool) -> str:
    return "" if single else _bearing(result)


def _key(result: Result, single: bool, several: Collection[str]) -> tuple[str, str, str]:
    """Bearing, point and member; bearings in `several` are solved at several clearances in some design."""
    name, bearing = result.name, _known_as(result, single)
    if not isinstance(name, ResultName):
        return (bearing, "", "")
    return (bearing, name.point, name.member or ("mean" if bearing in several else ""))


def _quantities(results: Sequence[Result]) -> tuple[str, ...]:
    """Results of all designs; of different kinds those that all have, of one kind those that any has."""
    solved = [one for one in results if one.outcome.solved]
    names = dict.fromkeys(
        name for one in solved for name in one.values if name in QUANTITIES and name not in NOT_COMPARED
    )
    if len({one.kind for one in solved}) > 1:
        return tuple(name for name in names if all(name in one.values for one in solved))
    return tuple(names)


def _each_once(labels: Sequence[str]) -> tuple[str, ...]:
    """Labels of which equal ones are numbered."""
    found: list[str] = []
    for label in labels:
        names = (label if number == 1 else f"{label} ({number})" for number in count(1))
        found.append(next(name for name in names if name not in found))
    return tuple(found)
