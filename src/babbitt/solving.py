"""Solve a case: every bearing at every operating point and clearance, by the method that it names."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from babbitt import __version__
from babbitt.case.case_file import CaseFile
from babbitt.case.case_hash import case_hash
from babbitt.case.part import Part, given_paths
from babbitt.case.parts.title_block import TitleBlock
from babbitt.core.notices import InputError
from babbitt.core.progress import ProgressCallback, no_progress
from babbitt.core.result import Result
from babbitt.core.solution import Solution

__all__ = ["MachineResult", "given_fields", "own_words", "refusal_of", "solve"]

OWN_WORDS = (
    "assumptions",
    "name",
    "source",
    "lubricant",
    "oil",
    "bearing_metal",
    "bearing",
    "journal",
    "material",
)
"""Fields whose texts are words of the case."""


@dataclass(frozen=True)
class MachineResult:
    """The answers for all bearings of one case file.

    Attributes
    ----------
    name : str
    solutions : tuple of Solution
        One per bearing, operating point and clearance, or steady state.
    case_hash : str
        SHA-256 of the validated case.
    version : str
        Of Babbitt.
    case_text : str
        The case file as it was read; empty where there was none.
    source, notes : str
        What the case says of itself.
    own_words : tuple of str
        Names in the case, and what it and its bearings themselves assume.
    title_block : TitleBlock or None
        Of the report.
    given : Mapping
        By the name of a problem: paths of the fields that its case has written. Problems made by hand have none.
    """

    name: str
    solutions: tuple[Solution, ...]
    case_hash: str
    version: str = __version__
    case_text: str = ""
    source: str = ""
    notes: str = ""
    own_words: tuple[str, ...] = ()
    title_block: TitleBlock | None = None
    given: Mapping[str, frozenset[str]] = field(default_factory=dict)

    @property
    def results(self) -> tuple[Result, ...]:
        """The result of each solution."""
        return tuple(one.result for one in self.solutions)

    @property
    def problems(self) -> tuple[Any, ...]:
        """What each result was computed from, in the same order."""
        return tuple(one.problem for one in self.solutions)

    @property
    def solved(self) -> bool:
        """Whether every bearing has an operating point."""
        return all(result.outcome.solved for result in self.results)

    @property
    def within_limits(self) -> bool:
        """Whether every bearing passes, with or without remarks."""
        return all(result.within_limits for result in self.results)

    def __getitem__(self, name: str) -> Result:
        """The result of a bearing by its name."""
        for result in self.results:
            if result.name == name:
                return result
        raise KeyError(f"no bearing {name!r}; there are: {', '.join(result.name for result in self.results)}")

    def without_states(self) -> MachineResult:
        """The same without the fields of its films, which take memory where many machines are kept."""
        return replace(self, solutions=tuple(one.without_state() for one in self.solutions))


def solve(
    case: CaseFile, progress: ProgressCallback = no_progress, only: Collection[str] | None = None
) -> MachineResult:
    """Solve every bearing of a case.

    Parameters
    ----------
    case : CaseFile
        From `babbitt.load_case` or `babbitt.parse_case`.
    progress : callable
        Hands on the numbers of the cycles of an orbit, which takes long, and may show how far it is.
    only : collection of str, optional
        Quantities that are wanted, limits and what questions them besides (`Calculation.only`); None: all.

    Returns
    -------
    MachineResult
    """
    calculations = case.calculations()
    if only is not None:
        calculations = tuple(one.only(only) for one in calculations)
    solutions: Sequence[Solution] = [found for one in calculations for found in one.solve(progress)]
    return MachineResult(
        case.name,
        tuple(solutions),
        case_hash(case),
        case_text=case.text,
        source=getattr(case, "source", ""),
        notes=getattr(case, "notes", ""),
        own_words=own_words(case),
        title_block=case.title_block,
        given=given_fields(case, (one.problem for one in solutions)),
    )


def own_words(case: CaseFile) -> tuple[str, ...]:
    """Words of a case: what it assumes, names of oils, metals, bearings. No report translates or converts them."""
    return tuple(dict.fromkeys(_words_in(case)))


def _words_in(given: Any, field: str = "") -> Iterator[str]:
    if isinstance(given, str):
        if field in OWN_WORDS:
            yield given
    elif isinstance(given, Part):
        for name, one in given:
            yield from _words_in(one, name)
    elif isinstance(given, list | tuple):
        for one in given:
            yield from _words_in(one, field)


def given_fields(case: CaseFile, problems: Iterable[Any]) -> Mapping[str, frozenset[str]]:
    """Paths of the fields that a case has written, by the name of each problem."""
    return {one.name: frozenset(given_paths(case, one.name)) for one in problems}


def refusal_of(case: CaseFile) -> InputError | None:
    """What `solve` would refuse of a case that was read; None where it would solve or say why it cannot.

    The rules of the case have been asked; what is left shows when its problems are made, or when a first film is
    found: pads that do not balance, a motion without bound.

    Parameters
    ----------
    case : CaseFile

    Returns
    -------
    InputError or None
    """
    try:
        for one in case.calculations():
            one.method.refuse(one.problem)
    except InputError as error:
        return error
    return None
