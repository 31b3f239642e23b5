"""First designs: the usual rules give what is tried, limits sort out, a criterion ranks, a film confirms.

Every combination of a few widths, fits, oils and feeds is checked by a quick method at all clearances of the
tolerances. The width is then refined for each oil, and the best are solved by a method that knows more, until as
many proposals as asked for are confirmed.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from babbitt.case.case_file import CaseFile
from babbitt.case.loading import case_from_dict
from babbitt.case.parts.study import StudyBlock, Vary
from babbitt.case.with_units import case_text
from babbitt.core.kind import find_kind, kinds
from babbitt.core.notices import InputError
from babbitt.core.result import Verdict
from babbitt.study.candidates import METHOD, Candidate, candidates_of, key_of, ranked
from babbitt.study.inputs import Input
from babbitt.study.rows import Columns, RowTask, joined

if TYPE_CHECKING:
    from babbitt.study.engine import Engine
    from babbitt.study.study import Study

__all__ = [
    "Designs",
    "FirstDesign",
    "designed",
    "designs_of",
    "duty_study",
    "rule_choices",
    "rules_of",
]

TRIED, REFINED, CONFIRMED = "tried", "refined", "confirmed"
"""What rows are for."""

COARSE = 4
"""Values of a number that are tried first."""

MOST_TRIED = 200_000
"""Combinations of values."""

MOST_CONFIRMED = 3
"""Designs that are solved by the second method, for each proposal that is asked for."""

ALTERNATIVES = 2
"""Designs of one oil that are solved by the second method until one is confirmed."""

DIFFERENT = ("lubricant", "clearance")
"""Fields of which proposals differ in the first that has several values."""


class FirstDesign(Protocol):
    """What a kind says of its first designs; a module of the kind that `Kind.first_design` names."""

    OUTPUTS: tuple[str, ...]
    """Quantities that are kept, among them friction_power and total_flow, of a film short of oil its own, too."""

    REASONS: Mapping[str, str]
    """By the path of a field why its values are tried."""

    EDGES: Mapping[str, tuple[str, str, str]]
    """By the path of a field with an order the quantity that has it, and words for its smallest and largest."""

    METHODS: tuple[str, ...]
    """A quick method, and one that confirms what it finds."""

    def duty(self, **given: Any) -> dict[str, Any]:
        """A case with a duty, as a file has it, its assumptions named."""

    def choices(self, case: CaseFile, given: Mapping[str, Vary]) -> dict[str, Vary]:
        """Fields with the values that are tried, the method last; those given stay."""

    def shown(self, fields: Mapping[str, Any], values: Mapping[str, float]) -> dict[tuple[str, str], str]:
        """The cells of a design in a table, by heading and unit."""

    def fit_together(self, values: Mapping[str, Any], stated: Collection[str]) -> bool:
        """Whether values of fields, as the case has them, belong together; paths of `stated` are not by rules."""

    def departures(self, line: Mapping[str, Any]) -> Iterator[str]:
        """Usual rules that a line of a design, its columns in SI, does not keep; without numbers."""

    def reasons(self, lines: Sequence[Mapping[str, Any]], limits: Mapping[str, float]) -> Iterator[str]:
        """Why a design is as it is, by its lines of each clearance in SI and the limits by their code."""


@dataclass(frozen=True)
class Designs:
    """What a design study proposes.

    Attributes
    ----------
    proposals : tuple of (Candidate, Candidate)
        Each as it was found, and as the second method has it; the best first.
    refuted : tuple of (Candidate, Candidate)
        Designs within the limits that the second method does not confirm.
    nearest : tuple of Candidate
        Where nothing is proposed, the designs that miss their limits least.
    tried : tuple of Candidate
        All, the best first.
    """

    proposals: tuple[tuple[Candidate, Candidate], ...]
    refuted: tuple[tuple[Candidate, Candidate], ...]
    nearest: tuple[Candidate, ...]
    tried: tuple[Candidate, ...]

    @property
    def computed(self) -> int:
        """Designs that were tried."""
        return len(self.tried)

    @property
    def within(self) -> int:
        """Designs that keep all limits."""
        return sum(one.within for one in self.tried)


def rules_of(kind: str) -> FirstDesign:
    """The rules of a kind.

    Raises
    ------
    InputError
        E004 for a kind without any, with those that have some.
    """
    found = find_kind(kind)
    if found is None or not found.first_design:
        there = ", ".join(name for name, one in kinds().items() if one.first_design)
        says = f"there are no rules for a first design of kind '{kind}'; allowed: {there}"
        hint = "start from `babbitt new` and a study of kind optimise or size"
        raise InputError("E004", f"{says}; for others {hint}")
    package, _, name = found.first_design.partition(":")
    rules: Any = import_module(f"{package}.{name}")
    made: FirstDesign = rules
    return made


def rule_choices(case: CaseFile, block: StudyBlock) -> StudyBlock:
    """A design with the values that the rules of its kind try where the study names none.

    Raises
    ------
    InputError
        E004 for a kind without rules; E003 for methods other than theirs.
    """
    methods = rules_of(case.kind).METHODS
    if METHOD in block.vary:
        if block.vary[METHOD].values != methods:
            says = f"a design is found by {methods[0]} and confirmed by {methods[1]}; remove it"
            raise InputError("E003", f"study.vary.{METHOD}: {says}")
        return block
    return block.model_copy(update={"vary": rules_of(case.kind).choices(case, block.vary)})


def planned(task_inputs: Sequence[Input], block: StudyBlock, kind: str) -> int:
    """Rows that a design computes, about: the grid, and what is confirmed.

    Raises
    ------
    InputError
        E003 for more combinations than `MOST_TRIED`, and for fields without values.
    """
    combinations = math.prod(len(values) for values in _coarse(task_inputs).values())
    if combinations > MOST_TRIED:
        says = f"{combinations:.4g} designs are to be tried; allowed: {MOST_TRIED}; name fewer values"
        raise InputError("E003", f"study.vary: {says}")
    return len(_grid(task_inputs, rules_of(kind), _coarse(task_inputs))) + 2 * block.proposals


def designed(task: RowTask, block: StudyBlock, engine: Engine) -> Columns:
    """Try, refine and confirm; deterministic, so that a run that is resumed asks for the rows that are stored."""
    rules, inputs = rules_of(task.kind), task.inputs
    tried = _grid(inputs, rules, _coarse(inputs))
    parts = [engine.answers(_columns(inputs, tried, rules.METHODS[0]), TRIED)]
    if finer := _finer(inputs, rules, block, _lines(parts[0], task), tried):
        parts.append(engine.answers(_columns(inputs, finer, rules.METHODS[0]), REFINED))
    confirmed: dict[Any, int] = {}
    solved = 0
    for one in ranked(_lines(joined(parts), task), block.reserve):
        key = _distinct(one, inputs)
        enough = sum(count < 0 for count in confirmed.values()) >= block.proposals
        if enough or not one.within or solved >= MOST_CONFIRMED * block.proposals:
            break
        if not 0 <= confirmed.get(key, 0) < ALTERNATIVES:
            continue
        parts.append(engine.answers(_columns(inputs, [one.fields], rules.METHODS[1]), CONFIRMED))
        (again,) = _lines(parts[-1], task)
        confirmed[key] = -1 if again.within else confirmed.get(key, 0) + 1
        solved += 1
    return joined(parts)


def designs_of(study: Study) -> Designs:
    """The proposals of a study, best first, and what was not confirmed."""
    block, inputs = study.block, study.inputs
    paths = [one["path"] for one in inputs]
    advisories = [one["code"] for one in study.description["advisories"]]
    departures = rules_of(study.description["kind"]).departures
    found = {
        group: candidates_of(study.of(group), paths, advisories, departures)
        for group in (TRIED, REFINED, CONFIRMED)
    }
    second = {key_of(one.fields): one for one in found[CONFIRMED]}
    tried = ranked([*found[TRIED], *found[REFINED]], block.reserve)
    pairs = [(one, second[key_of(one.fields)]) for one in tried if key_of(one.fields) in second]
    proposals = sorted((pair for pair in pairs if pair[1].within), key=lambda pair: bool(pair[1].remarks))
    nearest = () if proposals else tuple(one for one in tried if math.isfinite(one.margin))[: block.proposals]
    return Designs(
        tuple(proposals),
        tuple(pair for pair in pairs if not pair[1].within),
        nearest,
        tuple(tried),
    )


def _distinct(one: Candidate, inputs: Sequence[Input]) -> Any:
    """What two proposals differ in: the oil, where one oil is tried the clearance, else any field."""
    paths = [each.path for each in inputs if each.path in DIFFERENT and each.listed.size > 1]
    return one.fields[paths[0]] if paths else key_of(one.fields)


def _coarse(inputs: Sequence[Input]) -> dict[str, list[Any]]:
    """Of each field the values that are tried first: all choices, and a few numbers."""
    made = {}
    for one in inputs:
        values = one.listed
        if not one.is_choice:
            places = np.unique(np.linspace(0, values.size - 1, min(COARSE, values.size)).round().astype(int))
            values = np.sort(values)[places]
        made[one.path] = values.tolist()
    return made


def _grid(
    inputs: Sequence[Input], rules: FirstDesign, values: Mapping[str, Sequence[Any]]
) -> list[dict[str, Any]]:
    """Every combination of values that fits together."""
    varied = [one for one in inputs if one.path != METHOD]
    stated = {one.path for one in inputs if one.reason != rules.REASONS.get(one.path)}
    made = []
    for combined in itertools.product(*(values[one.path] for one in varied)):
        given = {one.path: one.in_case(value) for one, value in zip(varied, combined, strict=True)}
        if rules.fit_together(given, stated):
            made.append(dict(zip((one.path for one in varied), combined, strict=True)))
    return made


def _finer(
    inputs: Sequence[Input],
    rules: FirstDesign,
    block: StudyBlock,
    found: Sequence[Candidate],
    tried: Sequence[Mapping[str, Any]],
) -> list[dict[str, Any]]:
    """Around the best design of each oil the numbers between those that were tried, its other choices held."""
    known = {key_of(one) for one in tried}
    coarse, made, seen = _coarse(inputs), [], set()
    for best in ranked(found, block.reserve):
        key = _distinct(best, inputs)
        if key in seen or best.verdict == Verdict.NO_SOLUTION.key:
            continue
        seen.add(key)
        values = {path: [value] for path, value in best.fields.items()}
        for one in inputs:
            if not one.is_choice:
                values[one.path] = _between(one, coarse[one.path], best.fields[one.path])
            elif one.path not in DIFFERENT:
                values[one.path] = coarse[one.path]
        finer = [row for row in _grid(inputs, rules, values) if key_of(row) not in known]
        known |= {key_of(row) for row in finer}
        made += finer
    return made


def _between(one: Input, tried: Sequence[float], best: float) -> list[float]:
    """Values from the neighbour below to that above of one that was tried."""
    place = tried.index(best)
    low, high = tried[max(0, place - 1)], tried[min(len(tried) - 1, place + 1)]
    return [value for value in sorted(one.listed.tolist()) if low <= value <= high]


def _columns(inputs: Sequence[Input], rows: Sequence[Mapping[str, Any]], method: str) -> Columns:
    made: Columns = {}
    for one in inputs:
        values = [method if one.path == METHOD else row[one.path] for row in rows]
        made[one.path] = np.array(values, object if one.is_choice else float)
    return made


def _lines(columns: Columns, task: RowTask) -> list[Candidate]:
    paths = [one.path for one in task.inputs]
    return candidates_of(columns, paths, task.advisories, rules_of(task.kind).departures)


def duty_study(
    kind: str, given: Mapping[str, Any], lubricants: Sequence[str], fits: Sequence[str], **options: Any
) -> tuple[CaseFile, StudyBlock]:
    """The case of a duty, and the study that designs it.

    Parameters
    ----------
    kind : str
        Of bearing.
    given : mapping
        What its rules take as a duty.
    lubricants, fits : sequence of str
        Those that are tried; by the rules where there are none.
    **options
        ``reserve`` and ``proposals``.

    Raises
    ------
    InputError
        With everything that the case does not take.
    """
    duty = rules_of(kind).duty(**given)
    case = case_from_dict(duty, "design").with_text(case_text(duty))
    offered = {"lubricant": lubricants, "clearance": fits}
    for name, values in offered.items():
        for value in values:
            case_from_dict({**duty, name: value}, "design")
    vary = {name: Vary(values=tuple(dict.fromkeys(values))) for name, values in offered.items() if values}
    return case, StudyBlock(kind="design", vary=vary, **options)
