"""A case file solved again and again while one of its fields changes, by whichever method its bearings name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from babbitt.case import CaseFile
from babbitt.case.variation import CaseVariation
from babbitt.core.notices import InputError
from babbitt.core.result import Result
from babbitt.core.units import SiNumber
from babbitt.solving import MachineResult, solve
from babbitt.study.sweep_values import SweepValues

__all__ = ["CaseSweep", "SolvedPlaces", "solved_places", "sweep_case"]

Followed = Callable[[Sequence[int]], Iterable[int]]


@dataclass(frozen=True, eq=False)
class CaseSweep:
    """Answers of a case over one of its fields.

    Attributes
    ----------
    path : str
        The field.
    values : SweepValues
    present : float or None
        What the file itself has in the field, in the unit of the values.
    places : tuple of int
        Of the values that could be used.
    machines : tuple of MachineResult
        One for each of them.
    refused : mapping of int to str
        Place of every value that the case does not take, and why.
    interrupted : bool
        Whether the sweep was interrupted, so that the values after the last place were not solved.
    """

    path: str
    values: SweepValues
    present: float | None
    places: tuple[int, ...]
    machines: tuple[MachineResult, ...]
    refused: Mapping[int, str]
    interrupted: bool = False

    def rows(self) -> Iterator[tuple[int, Result]]:
        """Every answer with the place of its value."""
        for place, machine in zip(self.places, self.machines, strict=True):
            for result in machine.results:
                yield place, result

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the answers, each once."""
        return tuple(dict.fromkeys(result.name for _, result in self.rows()))

    @property
    def solved(self) -> bool:
        """Whether every value has an answer, and every answer is an operating point."""
        return not self.refused and not self.interrupted and all(machine.solved for machine in self.machines)


def sweep_case(
    variation: CaseVariation, values: SweepValues, watch: Followed = lambda places: places
) -> CaseSweep:
    """Solve a case for each value of one of its fields.

    Parameters
    ----------
    variation : CaseVariation
        The case file and the field.
    values : SweepValues
    watch : callable
        Hands on the places of the values one by one and may show how far the work is.

    Returns
    -------
    CaseSweep
        With a status for every value; one that the field does not take stops nothing. An interrupt ends it with
        the values that are finished.

    Raises
    ------
    InputError
        What the first value is refused for, if all are; nothing is solved where the case itself refuses them.
    KeyboardInterrupt
        When no value is finished.
    """
    found = solved_places(variation, values.texts, watch)
    return CaseSweep(
        variation.path,
        values,
        values.number_of(variation.present),
        tuple(found.machines),
        tuple(found.machines.values()),
        found.refused,
        found.interrupted,
    )


@dataclass(frozen=True)
class SolvedPlaces:
    """Answers by the places of their values, why other values are refused, and whether all were come to."""

    machines: Mapping[int, MachineResult]
    refused: Mapping[int, str]
    interrupted: bool


def solved_places(
    variation: CaseVariation, values: Sequence[str | SiNumber], watch: Followed = lambda places: places
) -> SolvedPlaces:
    """Solve a case for each value of one of its fields; arguments and errors are those of `sweep_case`."""
    cases: dict[int, CaseFile] = {}
    machines: dict[int, MachineResult] = {}
    refused: dict[int, InputError] = {}
    for place, value in enumerate(values):
        try:
            cases[place] = variation.case(value)
        except InputError as error:
            refused[place] = error
    interrupted = False
    try:
        for place in watch(list(cases)):
            try:
                machines[place] = solve(cases[place]).without_states()
            except InputError as error:  # of some methods only the film tells what cannot be
                refused[place] = error
    except KeyboardInterrupt:
        if not machines:
            raise
        interrupted = True
    if not machines and refused:
        raise refused[min(refused)]
    return SolvedPlaces(machines, {place: str(refused[place]) for place in sorted(refused)}, interrupted)
