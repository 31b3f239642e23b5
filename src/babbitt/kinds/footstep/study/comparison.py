"""A footstep by both methods, every steady state side by side."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from babbitt.core.result import Result
from babbitt.core.result_name import ResultName
from babbitt.kinds.footstep.case.footstep import ScrewHeelCase, heel_cases
from babbitt.kinds.footstep.check import heel_results
from babbitt.kinds.footstep.model_case import HeelCase
from babbitt.kinds.footstep.states import Method

__all__ = ["HeelVariant", "compare_heels"]

REMARKS = {
    Method.SUPERPOSITION: (
        "study",
        "takes groove and clearance as two flows, gives no heat to the metal, and leaves the shear of the lands "
        "out of the heat",
    ),
    Method.NARROW_GROOVE: (
        "narrow grooves",
        "takes the clearance as one film with one temperature; counts on many grooves",
    ),
}


@dataclass(frozen=True)
class HeelVariant:
    """One steady state by one method, and what the method neglects."""

    label: str
    remark: str
    result: Result


def compare_heels(case: ScrewHeelCase) -> tuple[HeelVariant, ...]:
    """Solve every heel of a case by both methods; that of the case stands first.

    Parameters
    ----------
    case : ScrewHeelCase
        Its wall counts for narrow grooves alone.

    Returns
    -------
    tuple of HeelVariant
    """
    designs = heel_cases(case)
    first = Method(case.method)
    ordered = (first, *(method for method in Method if method is not first))
    return tuple(variant for method in ordered for design in designs for variant in _by(design, method))


def _by(design: HeelCase, method: Method) -> Iterator[HeelVariant]:
    label, remark = REMARKS[method]
    for result in heel_results(replace(design, method=method)):
        state = result.name.state if isinstance(result.name, ResultName) else ""
        yield HeelVariant(f"{label}, {state}", remark, result)
