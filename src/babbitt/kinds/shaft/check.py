"""A shaft held against its limits."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from babbitt.core.notices import Notice
from babbitt.core.result import Bound, Check, Matrix, Outcome, Result
from babbitt.core.solution import Solution
from babbitt.kinds.shaft.answer import ShaftAnswer, answered
from babbitt.kinds.shaft.problem import ShaftProblem
from babbitt.kinds.shaft.statics import thrust

__all__ = ["shaft_solution"]

GIVEN = "given in the case"


def shaft_solution(problem: ShaftProblem, method: str) -> Solution:
    """Solve a shaft and hold it against its limits.

    Parameters
    ----------
    problem : ShaftProblem
    method : str
        ``statics`` or ``beam``.
    """
    answer = answered(problem.shaft)
    values = _values(answer)
    result = Result(
        problem.name,
        problem.kind,
        method,
        Outcome.CONVERGED,
        values,
        tuple(_checks(problem, values)),
        warnings=problem.warnings,
        not_checked=tuple(_not_checked(problem, values)),
        assumptions=(*problem.assumptions, *([RESTS_ON_STIFFNESS] if answer.slopes is not None else [])),
        settings={f"bearing_{place}": one.name for place, one in enumerate(problem.shaft.supports, start=1)},
        arrays=_arrays(answer),
    )
    return Solution(problem, result, answer)


def _values(answer: ShaftAnswer) -> dict[str, float]:
    curves, radial = answer.curves, answer.bearing_forces[:, :2]
    values = {
        "largest_support_load": _largest(radial),
        "axial_load": thrust(answer.shaft),
        "largest_torque": float(np.abs(answer.torque()).max()),
        "bending_moment": _largest(curves.moment),
    }
    if answer.slopes is not None:
        carrying = [place for place, one in enumerate(answer.shaft.supports) if one.radial]
        values |= {
            "support_slope": _largest(answer.slopes[carrying]),
            "shaft_deflection": _largest(curves.deflection),
        }
    return values | {"equilibrium_error": answer.equilibrium_error()}


def _largest(vectors: np.ndarray) -> float:
    return float(np.hypot(vectors[:, 0], vectors[:, 1]).max())


def _arrays(answer: ShaftAnswer) -> dict[str, Matrix]:
    x, y, z = answer.bearing_forces.T
    arrays = {
        "support_station": [one.station for one in answer.shaft.supports],
        "support_load_x": x,
        "support_load_y": y,
        "support_load": np.hypot(x, y),
        "support_load_angle": np.arctan2(y, x),
        "support_axial_load": z,
    }
    if answer.slopes is not None:
        arrays |= {"support_slope_x": answer.slopes[:, 0], "support_slope_y": answer.slopes[:, 1]}
    return {name: (tuple(map(float, row)),) for name, row in arrays.items()}


RESTS_ON_STIFFNESS = (
    "Slope and deflection (C501, C502) rest on the stiffness of the bearings in the case, rigid where none is "
    "given, not on that of their films."
)

LIMITS = (("C501", "slope", "support_slope"), ("C502", "deflection", "shaft_deflection"))
"""Code, limit of the case, and the value that is held against it."""


def _checks(problem: ShaftProblem, values: dict[str, float]) -> Iterator[Check]:
    for code, limit, name in LIMITS:
        most = getattr(problem.limits, limit)
        if most is not None and name in values:
            yield Check(code, name, values[name], most, Bound.AT_MOST, GIVEN)


def _not_checked(problem: ShaftProblem, values: dict[str, float]) -> Iterator[Notice]:
    if problem.loads_alone:
        yield Notice("C503", values={"bearings": problem.loads_alone})
    for code, limit, name in LIMITS:
        if name not in values:
            yield Notice(code, "no_pieces")
        elif getattr(problem.limits, limit) is None:
            yield Notice(code, "no_limit")
