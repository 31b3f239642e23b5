"""Misses, warnings and checks that could not be made: those of many bearings gathered by code."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain

from babbitt.core.check_text import comparison
from babbitt.core.language import translated
from babbitt.core.notices import Effect, Notice, Subject, explanations
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Check, Result
from babbitt.report.meanings import remark_on_zero
from babbitt.report.names import listed, shortened, shown_name
from babbitt.report.text import plain_text
from babbitt.report.us_words import OF_RESULTS, in_us_units

ASSUMED_METAL = "the bearing metal is assumed, and its limits decide nothing (materials: bearing_metal)"
"""Why a check that was made leaves its subject without a verdict."""

MOST_MESSAGES = 3
"""Different messages of one code that are listed where it touches verdicts; of more the first is an example."""


@dataclass(frozen=True)
class Group:
    """What one code, or several with the same cause, says about one or more bearings.

    Attributes
    ----------
    code, title : str
        The code and what it means in general.
    names : tuple of str
        Which results, the worst first where one can be worse than another.
    of : tuple of str
        All results of the machine.
    message : str
        The numbers of the case.
    remedy : str
        What to do; empty when the register knows none.
    """

    code: str
    title: str
    names: tuple[str, ...]
    of: tuple[str, ...]
    message: str
    remedy: str = ""

    @property
    def bearings(self) -> str:
        """Every bearing concerned."""
        return listed(self.names, self.of)

    @property
    def some_bearings(self) -> str:
        """The first bearings concerned, the others counted."""
        return shortened(self.names, self.of)


def missed_limits(results: Sequence[Result]) -> tuple[Group, ...]:
    """Violated limits of solved bearings, gathered by code, the worst margin first in each group."""
    return _missed(results, lambda check: not check.advisory)


def missed_advice(results: Sequence[Result]) -> tuple[Group, ...]:
    """Missed recommendations of solved bearings, gathered by code."""
    return _missed(results, lambda check: check.advisory)


def _missed(results: Sequence[Result], concerned: Callable[[Check], bool]) -> tuple[Group, ...]:
    found: dict[tuple[str, str], list[tuple[Result, Check]]] = {}
    for result in results:
        if result.outcome.solved:
            for check in result.checks:
                if not check.ok and concerned(check):
                    found.setdefault((check.code, check.quantity), []).append((result, check))
    groups = []
    for (code, quantity), misses in sorted(found.items()):
        misses.sort(key=lambda miss: miss[1].margin)
        check = misses[0][1]
        known = QUANTITIES.get(quantity)
        groups.append(
            Group(
                code,
                (translated(known.meaning) if known else quantity) + remark_on_zero(quantity, check.value),
                tuple(result.name for result, _ in misses),
                _names(results),
                comparison(check)
                if len(misses) == 1
                else translated("worst {comparison}", comparison=comparison(check)),
                explanations()[code].remedy if code in explanations() else "",
            )
        )
    return tuple(groups)


def no_verdict(results: Sequence[Result]) -> tuple[Group, ...]:
    """Why solved bearings are without a verdict: outside the validity of a model, or a subject without a check."""
    return (*_warned(results, Effect.NO_VERDICT), *lacking(results))


def remarks(results: Sequence[Result]) -> tuple[Group, ...]:
    """Warnings that question a result."""
    return _warned(results, Effect.QUESTIONS_RESULT)


def information(results: Sequence[Result]) -> tuple[Group, ...]:
    """Warnings that change no verdict."""
    return _warned(results, Effect.INFORMATION)


def _warned(results: Sequence[Result], effect: Effect) -> tuple[Group, ...]:
    most = 1 if effect is Effect.INFORMATION else MOST_MESSAGES
    return _gathered(results, lambda result: [one for one in result.warnings if one.effect is effect], most)


def lacking(results: Sequence[Result]) -> Iterator[Group]:
    """One group for each subject of which no check could be made, with what the first bearing concerned lacks."""
    for subject in Subject:
        found = [result for result in results if result.outcome.solved and subject in result.lacking]
        if found:
            missing = [one for one in found[0].not_checked if explanations()[one.code].subject is subject]
            reasons = dict.fromkeys(plain_text(one.message) for one in missing)
            advice = [
                one for one in found[0].checks if one.advisory and explanations()[one.code].subject is subject
            ]
            title = f"No check of the {subject.value} could be made"
            if advice:
                title = f"Only a recommendation for the {subject.value}"
                reasons[translated(ASSUMED_METAL)] = None
            yield Group(
                ", ".join(dict.fromkeys([one.code for one in missing] + [one.code for one in advice])),
                translated(title),
                tuple(result.name for result in found),
                _names(results),
                "; ".join(reasons),
            )


def missing_values(results: Sequence[Result]) -> tuple[Group, ...]:
    """Quantities of solved bearings that could not be found, gathered by their reason."""
    found: dict[str, tuple[list[str], list[str]]] = {}
    for result in (one for one in results if one.outcome.solved):
        for name, reason in result.missing.items():
            symbols, names = found.setdefault(reason, ([], []))
            symbols.append(QUANTITIES[name].symbol)
            names.append(result.name)
    return tuple(
        Group(
            "",
            ", ".join(dict.fromkeys(symbols)),
            tuple(dict.fromkeys(names)),
            _names(results),
            in_us_units(translated(reason), OF_RESULTS),
        )
        for reason, (symbols, names) in found.items()
    )


def not_checked(results: Sequence[Result]) -> tuple[Group, ...]:
    """Checks that could not be made, one group for all that lack the same data."""
    together: dict[tuple[str, tuple[str, ...]], list[Group]] = {}
    for group in _gathered(results, lambda result: result.not_checked):
        together.setdefault((group.message, group.names), []).append(group)
    return tuple(
        Group(
            ", ".join(group.code for group in groups),
            ", ".join(group.title for group in groups),
            names,
            _names(results),
            message,
        )
        for (message, names), groups in together.items()
    )


def _gathered(
    results: Sequence[Result], notices_of: Callable[[Result], Iterable[Notice]], most: int = 1
) -> tuple[Group, ...]:
    """One group a code, or a message where a code has at most so many; of more the first is an example."""
    found: dict[str, dict[str, list[Result]]] = {}
    for result in results:
        for notice in notices_of(result):
            message = in_us_units(plain_text(notice.message), OF_RESULTS)
            found.setdefault(notice.code, {}).setdefault(message, []).append(result)
    groups = []
    for code, by_message in sorted(found.items()):
        if len(by_message) > most:
            message, (first, *_) = next(iter(by_message.items()))
            example = translated("{name}, for example: {message}", name=shown_name(first.name), message=message)
            by_message = {example: list(chain.from_iterable(by_message.values()))}
        explanation = explanations()[code]
        for message, concerned in by_message.items():
            places = set(map(id, concerned))
            names = tuple(result.name for result in results if id(result) in places)
            groups.append(Group(code, explanation.title, names, _names(results), message, explanation.remedy))
    return tuple(groups)


def unsolved(results: Sequence[Result]) -> tuple[Group, ...]:
    """Bearings without an operating point, and why."""
    return tuple(
        Group(
            result.outcome.code,
            translated(result.outcome.value),
            (result.name,),
            _names(results),
            plain_text(result.message),
            explanations()[result.outcome.code].remedy if result.outcome.code in explanations() else "",
        )
        for result in results
        if not result.outcome.solved
    )


def _names(results: Sequence[Result]) -> tuple[str, ...]:
    return tuple(result.name for result in results)
