"""A case file solved again and again while one of its fields changes, by whichever method its bearings name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from babbitt.cases.variation import CaseVariation
from babbitt.results import Result
from babbitt.solving import MachineResult, solve
from babbitt.studies.sweep_values import SweepValues

__all__ = ["CaseSweep", "sweep_case"]

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
    machines : tuple of MachineResult
        One per value.
    """

    path: str
    values: SweepValues
    present: float | None
    machines: tuple[MachineResult, ...]

    def rows(self) -> Iterator[tuple[int, Result]]:
        """Every answer with the place of its value."""
        for place, machine in enumerate(self.machines):
            for result in machine.results:
                yield place, result

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the answers, each once."""
        return tuple(dict.fromkeys(result.name for _, result in self.rows()))

    @property
    def solved(self) -> bool:
        """Whether every answer is an operating point."""
        return all(machine.solved for machine in self.machines)


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
        With a status for every value.

    Raises
    ------
    CaseError
        For a value that the field does not take; nothing is solved then.
    """
    cases = [variation.case(text) for text in values.texts]
    machines = tuple(solve(cases[place]) for place in watch(range(len(cases))))
    return CaseSweep(variation.path, values, values.number_of(variation.present), machines)
