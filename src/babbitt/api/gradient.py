"""How results change with fields of the case: central differences, each with an estimate of its error."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from babbitt.api.given import as_given
from babbitt.case.field_types import quantity_in
from babbitt.case.part import Part
from babbitt.case.problems import CaseError, Problem
from babbitt.core.nearest_name import unknown_name
from babbitt.core.notices import InputError
from babbitt.core.units import SiField, read
from babbitt.study.fields import types_at

if TYPE_CHECKING:
    from babbitt.api.case import Case
    from babbitt.api.results import BearingResult

__all__ = ["AGREEMENT", "Gradient", "gradient_of"]

SHARE = 0.01
"""Step of a field over its value: large beside what a search leaves open, small beside what bends a curve."""

KELVIN = 1.0
"""Step of a temperature, K, of which no share means anything."""

LEAST_SHARE = 1e-8
"""Step over the value below which the digits of a number do not carry a difference."""

AGREEMENT = 0.05
"""Difference of the slopes of the step and of half of it, over the slope (of a matrix the largest entries), from
which a slope is doubtful. The grid of a film, drawn anew at every place, is worth 2 % in some stiffnesses."""

Slope = float | NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Gradient(Mapping[str, Mapping[str, Slope]]):
    """Slopes of results over fields of the case: ``gradient["stiffness"]["clearance.mean"]``.

    Attributes
    ----------
    slopes : Mapping
        By quantity and field, in SI: a number, or an array of the shape of the quantity; NaN where a neighbour has
        no operating point or lacks the quantity, for a reason in `reasons`.
    errors : Mapping
        Likewise, how far the slopes of the step and of half of it differ: an estimate of the error of the slope,
        which is better than the two where the results are smooth.
    steps : Mapping
        By field, the step to each side in SI.
    reasons : Mapping
        By quantity and field, why a slope is NaN.
    """

    slopes: Mapping[str, Mapping[str, Slope]]
    errors: Mapping[str, Mapping[str, Slope]]
    steps: Mapping[str, float]
    reasons: Mapping[tuple[str, str], str]

    def __getitem__(self, quantity: str) -> Mapping[str, Slope]:
        return self.slopes[quantity]

    def __iter__(self) -> Iterator[str]:
        return iter(self.slopes)

    def __len__(self) -> int:
        return len(self.slopes)

    @property
    def doubtful(self) -> tuple[tuple[str, str], ...]:
        """Quantities and fields whose slopes of the step and of half of it differ by more than 5 %."""
        pairs = ((quantity, field) for quantity, row in self.slopes.items() for field in row)
        return tuple(pair for pair in pairs if self._disagreement(*pair) > AGREEMENT)

    def _disagreement(self, quantity: str, field: str) -> float:
        largest = float(np.max(np.abs(self.slopes[quantity][field]), initial=0.0))
        error = float(np.max(np.abs(self.errors[quantity][field]), initial=0.0))
        return 0.0 if not error > 0.0 else error / largest if largest > 0.0 else math.inf

    def __repr__(self) -> str:
        lines = []
        for quantity, row in self.slopes.items():
            for field, slope in row.items():
                shown = np.array2string(np.asarray(slope), precision=4).replace("\n", "")
                said = self.reasons.get((quantity, field)) or f"error {self._disagreement(quantity, field):.1e}"
                lines.append(f"d {quantity} / d {field} = {shown}  ({said})")
        more = [f"and {len(lines) - 20} more"] if len(lines) > 20 else []
        return "\n".join([*lines[:20], *more])


def gradient_of(
    case: Case,
    fields: str | Iterable[str],
    of: str | Iterable[str],
    steps: Mapping[str, Any] | None = None,
    workers: int = 1,
) -> Gradient:
    """Slopes of results over fields of a case.

    Parameters
    ----------
    case : Case
        With one bearing at one point.
    fields : str or iterable of str
        Paths of fields that take a quantity, and have a value.
    of : str or iterable of str
        Quantities of the result.
    steps : Mapping, optional
        By field, the step to each side, in SI or text with a unit, in place of 1 % of the value, or of 1 K for a
        temperature. A field that is zero needs one.
    workers : int
        Processes.

    Returns
    -------
    Gradient

    Raises
    ------
    CaseError
        For a field that there is not, that has no value or takes no quantity, and for a neighbour that is refused.
    InputError
        E005 for a quantity that the result has not.

    Warns
    -----
    UserWarning
        For slopes that depend on the step (`Gradient.doubtful`).

    Notes
    -----
    The case is solved anew at two steps to each side, h and h/2. With the slopes D(h) and D(h/2) of central
    differences the slope is (4 D(h/2) - D(h))/3 (Richardson), which is exact for a quartic; their difference is
    given as its error, so that a step too small for the round-off of a search, or a film that jumps between the
    steps, shows.
    """
    from babbitt.api.sweeping import over_points

    paths, names = _listed(fields), _listed(of)
    places = {path: _present(case, path) for path in paths}
    widths = {path: _step(case, path, places[path], steps or {}) for path in paths}
    points: list[Mapping[str, Any]] = [
        {path: places[path] + share * widths[path]} for path in paths for share in (-1.0, -0.5, 0.5, 1.0)
    ]
    middle, *around = over_points(case, [{}, *points], workers)
    _refuse_unknown(middle, names)
    slopes: dict[str, dict[str, Slope]] = {name: {} for name in names}
    errors: dict[str, dict[str, Slope]] = {name: {} for name in names}
    reasons: dict[tuple[str, str], str] = {}
    for number, path in enumerate(paths):
        stencil = around[4 * number : 4 * number + 4]
        for name in names:
            reason = next((said for one in (middle, *stencil) if (said := _lack(one, name))), "")
            if reason:
                reasons[name, path] = reason
                slopes[name][path] = errors[name][path] = float("nan")
                continue
            lowest, lower, higher, highest = (np.asarray(getattr(one, name)) for one in stencil)
            far, near = (highest - lowest) / (2.0 * widths[path]), (higher - lower) / widths[path]
            slopes[name][path] = _given_back((4.0 * near - far) / 3.0)
            errors[name][path] = _given_back(np.abs(near - far))
    found = Gradient(slopes, errors, widths, reasons)
    if found.doubtful:
        listed = "; ".join(f"{quantity} over {field}" for quantity, field in found.doubtful)
        warnings.warn(
            f"slopes that change by more than {AGREEMENT:.0%} with half the step: {listed}; their errors are in "
            "`errors`, other steps can be given by steps=",
            stacklevel=3,
        )
    return found


def quantities_of(case: Part, before: tuple[str, ...] = ()) -> Iterator[str]:
    """Paths of the fields of a case that take a quantity and have a value."""
    for name, field in type(case).model_fields.items():
        value = vars(case).get(name)
        if isinstance(value, Part):
            yield from quantities_of(value, (*before, name))
        elif isinstance(value, tuple):
            for number, one in enumerate(value):
                if isinstance(one, Part):
                    yield from quantities_of(one, (*before, name, str(number)))
        elif isinstance(value, float) and isinstance(quantity_in(field.rebuild_annotation()), SiField):
            yield ".".join((*before, name))


def _listed(given: str | Iterable[str]) -> Sequence[str]:
    return [given] if isinstance(given, str) else list(dict.fromkeys(given))


def _present(case: Case, path: str) -> float:
    known = list(quantities_of(case))
    if path not in known:
        says = unknown_name(path, known, "a field with a quantity here")
        raise CaseError([Problem(type(case).__name__, 0, path, says)])
    value: Any = case
    for step in path.split("."):
        value = value[int(step)] if isinstance(value, tuple) else getattr(value, step)
    return float(value)


def _step(case: Case, path: str, value: float, given: Mapping[str, Any]) -> float:
    units = (one.unit for one in map(quantity_in, types_at(case, path)) if one is not None)
    unit = next(units)
    if path in given:
        difference = "K difference" if unit == "K" else unit
        step = abs(read(as_given(given[path], type(case).__name__, (path,)), difference))
    else:
        step = KELVIN if unit == "K" else SHARE * abs(value)
    if step <= LEAST_SHARE * abs(value):
        says = f"a step of {step:g} is lost beside {value:g}" if value else "is zero, of which no share is a step"
        allowed = f"a step of its own: steps={{'{path}': ...}}"
        raise CaseError([Problem(type(case).__name__, 0, path, says, allowed=allowed)])
    return step


def _refuse_unknown(result: BearingResult, names: Sequence[str]) -> None:
    from babbitt.core.quantities import QUANTITIES

    known = {*result.last_state, *result.result.arrays, *result.missing}
    for name in names:
        if name not in known and not (name in QUANTITIES and not result.solved):
            raise InputError("E005", unknown_name(name, sorted(known), "among the results"))


def _lack(result: BearingResult, name: str) -> str:
    """Why a result cannot give a quantity; empty where it can."""
    if not result.solved:
        return f"{result.outcome.value} at a neighbour"
    if name in result.missing:
        return result.missing[name]
    return "" if name in chain(result.values, result.arrays) else "not given at a neighbour"


def _given_back(values: NDArray[np.float64]) -> Slope:
    if values.ndim == 0:
        return float(values)
    values.setflags(write=False)
    return values
