"""Sweeps: the design check repeated while one number of the case changes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from babbitt.cases.build import DesignT
from babbitt.cases.designs import AnyDesign
from babbitt.results import Outcome
from babbitt.solving import solve_design

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Sweep:
    """Answers over one varied number.

    Attributes
    ----------
    path : str
        Which number of the case was varied, such as ``"bearing.relative_clearance"``.
    points : ndarray, shape (n,)
        The values it took, in SI.
    outcomes : tuple of Outcome, length n
        How each calculation ended.
    values : Mapping[str, ndarray]
        Each named result in SI, shape (n,); NaN where there is no operating point, so that a curve has a gap.
    """

    path: str
    points: Array
    outcomes: tuple[Outcome, ...]
    values: Mapping[str, Array]

    @property
    def solved(self) -> NDArray[np.bool_]:
        """Which points have an operating point, shape (n,)."""
        return np.array([outcome.solved for outcome in self.outcomes], dtype=np.bool_)

    def __getitem__(self, name: str) -> Array:
        """Named result over the sweep, shape (n,); all NaN if no point has it."""
        return self.values.get(name, np.full(self.points.shape, np.nan))


def sweep(case: AnyDesign, path: str, points: Iterable[float]) -> Sweep:
    """Run the design check for each value of one number of a case.

    Parameters
    ----------
    case : DesignCase or FilmCase
    path : str
        Dotted name of a scalar of the case: ``"journal_speed"``, ``"duty.load"``, ``"bearing.span"``,
        ``"oil_supply.temperature"``.
    points : iterable of float
        Values in SI; the span in degrees, as in the case.

    Returns
    -------
    Sweep
        Every point has an outcome; one that is not solved leaves a gap and stops nothing.

    Raises
    ------
    ValueError
        If the case has no such number.
    """
    taken = [float(point) for point in points]
    results = [solve_design(varied(case, path, point)) for point in taken]
    names = dict.fromkeys(name for result in results for name in result.values)
    values = {
        name: np.array(
            [result.values.get(name, np.nan) if result.outcome.solved else np.nan for result in results]
        )
        for name in names
    }
    return Sweep(path, np.array(taken), tuple(result.outcome for result in results), values)


def varied(case: DesignT, path: str, value: float) -> DesignT:
    """The same case with another value of one number.

    A number that is a whole one in the case, such as the span in degrees, stays whole.
    """
    changed: DesignT = _replaced(case, path.split("."), value, path)
    return changed


def _replaced(part: Any, names: list[str], value: float, path: str) -> Any:
    name, *rest = names
    if name not in _field_names(part):
        raise ValueError(f"the case has no {path!r}: {type(part).__name__} has no field {name!r}")
    present = getattr(part, name)
    if rest:
        return replace(part, **{name: _replaced(present, rest, value, path)})
    if isinstance(present, bool) or not isinstance(present, int | float):
        raise ValueError(f"{path!r} of the case is no number: {present!r}")
    return replace(part, **{name: round(value) if isinstance(present, int) else value})


def _field_names(part: object) -> set[str]:
    return {field.name for field in fields(part)} if is_dataclass(part) else set()
