"""The same bearing by every method and option that applies, side by side."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from inspect import getdoc
from typing import Any

from babbitt.case.case_file import CaseFile
from babbitt.core.kind import Kind, find_kind
from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.core.result import Result
from babbitt.core.solution import Method, Solution
from babbitt.solving import own_words

__all__ = ["Comparison", "Variant", "compare_methods"]

ONE_METHOD = "a case of kind {kind!r} has one method; there is nothing to compare"


@dataclass(frozen=True)
class Variant:
    """One way to compute a bearing, and what it assumes or neglects.

    Attributes
    ----------
    label, remark : str
    solution : Solution
    is_method : bool
        False: differs from a method in one choice only, and is shown apart.
    detail : int
        Methods are shown in this order, from those that see least to those that see most.
    """

    label: str
    remark: str
    solution: Solution
    is_method: bool = True
    detail: int = 0

    @property
    def result(self) -> Result:
        """What an engineer reads of the solution."""
        return self.solution.result


@dataclass(frozen=True)
class Comparison:
    """All ways to compute one bearing; the first is the one the case asks for.

    Attributes
    ----------
    name : str
    variants : tuple of Variant
    compared : tuple of str
        Quantities that are put side by side.
    left_out : str
        Which methods do not apply and why, a line for each.
    sentences : tuple of str
        What the differences come to, under `heading`.
    heading, note : str
        Of the sentences; what one must know of the numbers.
    draw : callable, optional
        Draws the figure of the comparison; None where a table tells all.
    caption : str
        Of the figure, beside what every such figure shows.
    own_words : tuple of str
        Names in the case and what it assumes itself, which no page translates.
    """

    name: str
    variants: tuple[Variant, ...]
    compared: tuple[str, ...]
    left_out: str = ""
    sentences: tuple[str, ...] = ()
    heading: str = ""
    note: str = ""
    draw: Callable[[Comparison], Any] | None = None
    caption: str = ""
    own_words: tuple[str, ...] = ()

    @property
    def asked(self) -> Variant:
        """The method that the case asks for."""
        return self.variants[0]

    @property
    def methods(self) -> list[Variant]:
        """Methods of their own, from that which sees least to that which sees most."""
        return sorted((one for one in self.variants if one.is_method), key=lambda one: one.detail)

    @property
    def choices(self) -> list[Variant]:
        """What differs from a method in one choice only."""
        return [one for one in self.variants if not one.is_method]


def compare_methods(case: CaseFile) -> tuple[Comparison, ...]:
    """Solve every bearing of a case by every method and variant that applies to it.

    Parameters
    ----------
    case : CaseFile

    Returns
    -------
    tuple of Comparison
        The method that the case names stands first in each; a method is left out where it does not know the
        bearing.

    Raises
    ------
    InputError
        E004 when the kind of the case has one method.
    """
    kind = find_kind(case.kind)
    if kind is not None and kind.comparison:
        found: Iterable[Comparison] = kind.load(kind.comparison)(case)
        return _with_own_words(found, case)
    if kind is None or kind.one_method or len(kind.views) < 2:
        said = kind.one_method if kind is not None and kind.one_method else ONE_METHOD.format(kind=case.kind)
        raise InputError("E004", f"{case.name}: {said}")
    by_method = (_by_each_method(case, place, kind) for place in range(len(case.calculations())))
    return _with_own_words(by_method, case)


def _with_own_words(comparisons: Iterable[Comparison], case: CaseFile) -> tuple[Comparison, ...]:
    words = own_words(case)
    return tuple(replace(one, own_words=words) for one in comparisons)


def _by_each_method(case: CaseFile, place: int, kind: Kind) -> Comparison:
    """One bearing of a case, by each method that the field `method` may name and that does not refuse it."""
    asked, variants, left_out = case.calculations()[place], [], []
    for name in (asked.method.name, *(one for one in kind.views if one != asked.method.name)):
        try:
            one = case.model_copy(update={"method": name}).calculations()[place]
            variants.append(Variant(name, _about(one.method), one.method.solve_one(one.problem)))
        except InputError as error:
            if name == asked.method.name:
                raise
            left_out.append(f"{name} is left out: {error.message}")
    compared = dict.fromkeys(name for one in variants for name in one.result.values if name in QUANTITIES)
    return Comparison(asked.problem.name, tuple(variants), tuple(compared), "\n".join(left_out))


def _about(method: Method) -> str:
    """What a method is: the first line of its docstring."""
    return (getdoc(method) or "").partition("\n")[0]
