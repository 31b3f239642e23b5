"""A footstep by both methods, every steady state side by side."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.result_name import ResultName
from babbitt.kinds.footstep.case.footstep import FootstepCase, heel_cases
from babbitt.kinds.footstep.methods import METHODS
from babbitt.kinds.footstep.model_case import FootstepProblem
from babbitt.kinds.footstep.states import Method
from babbitt.study.comparison import Comparison, Variant

__all__ = ["compare"]

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


COMPARED = (
    "load",
    "rim_pressure",
    "face_flow",
    "heel_leakage",
    "heel_net_flow",
    "maximum_temperature",
    "friction_power",
    "face_gap_stiffness",
    "face_gap_damping",
    "thermal_loop_gain",
)
"""What is put side by side."""


def compare(case: FootstepCase) -> tuple[Comparison, ...]:
    """Solve every heel of a case by both methods; that of the case stands first.

    Parameters
    ----------
    case : FootstepCase
        Its wall counts for narrow grooves alone.

    Returns
    -------
    tuple of Comparison
        One, of every steady state.
    """
    problems = heel_cases(case)
    first = Method(case.method)
    ordered = (first, *(method for method in Method if method is not first))
    variants = tuple(variant for method in ordered for problem in problems for variant in _by(problem, method))
    return (Comparison(case.name, variants, COMPARED),)


def _by(problem: FootstepProblem, method: Method) -> Iterator[Variant]:
    label, remark = REMARKS[method]
    for found in METHODS[method.value].solve(problem):
        name = found.result.name
        state = name.state if isinstance(name, ResultName) else ""
        yield Variant(f"{label}, {state}", remark, found)
